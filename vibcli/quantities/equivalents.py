"""What springs and dampers resist with where they end together: `stiffness[P].max`, `damping[P].angle`."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.units import parse_unit
from vibcli.quantities.quantity import Declaration, measured, unit

if TYPE_CHECKING:
    import mpmath

    from vibcli.language.spec import Spec
    from vibcli.mechanics.concurrent import Concurrent
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

SECTIONS = {"stiffness": "springs", "damping": "dampers"}
UNITS = {"stiffness": "N/m", "damping": "N*s/m"}
PARTS = ("max", "min", "angle", "xx", "xy", "yy")


def asked_places(spec: "Spec") -> list[str]:
    """The places whose equivalents answers ask for."""
    trees = [tree for answer in spec.answers for tree in answer.asked.parts.quantities]
    return list(dict.fromkeys(tree.indices[0] for tree in trees if tree.head in SECTIONS and tree.component))


def elements_at(problem: "Problem", place: str, section: str) -> "list[Concurrent]":
    """The springs or dampers that end at a place."""
    from vibcli.mechanics.concurrent import concurrent

    return concurrent(problem.spec, problem.scene.resting, place, section)


def _elements(problem: "Problem", tree: "QuantityRef") -> "list[Concurrent]":
    return elements_at(problem, tree.indices[0], SECTIONS[tree.head])


def _value(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> "tuple[float | mpmath.mpf, float]":
    from vibcli.mechanics.equivalents import equivalent

    found = equivalent(problem.configuration, _elements(problem, tree), problem.digits, unit(problem))
    return measured(getattr(found, tree.component), 10.0**-problem.digits if problem.digits else 0.0)


def elements_in_letters(problem: "Problem", place: str, section: str) -> "list[Concurrent]":
    """The same in equilibrium, in letters: where they stand as drawn, or the equilibrium is known in letters."""
    from vibcli.mechanics.concurrent import at_rest, kinked

    elements, scene = elements_at(problem, place, section), problem.scene.resting
    if kinked(elements):
        raise NotInLetters("the equivalent of what has a kink is found in numbers",
                           "give the parameters values with --set")
    rest = {}
    if any(node.mask for one in elements for node in one.nodes):
        values, zero = problem.symbolic.equilibrium_position, scene.table.zero
        rest = dict.fromkeys((*scene.v, scene.time), zero) | {q: values[q.name] for q in scene.q}
    try:
        elements = at_rest(elements, rest)
    except ZeroDivisionError:
        raise PhysicsError(f"the ends of an element at '{place}' meet in equilibrium: it has no direction there",
                           "let it end elsewhere") from None
    if any(node.mask for one in elements for node in one.nodes):
        raise NotInLetters("the equivalent is found in numbers", "give the parameters values with --set")
    return elements


def _in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.mechanics.concurrent import in_letters

    return in_letters(elements_in_letters(problem, tree.indices[0], SECTIONS[tree.head]), tree.component)


def _dimension(spec: "Spec", tree: "QuantityRef") -> Any:
    return parse_unit("rad" if tree.component == "angle" else UNITS[tree.head]).dimension


def _size(problem: "Problem", tree: "QuantityRef") -> float:
    """The sum of what the elements resist with."""
    if tree.component == "angle":
        return 1.0
    from vibcli.mechanics.equivalents import size

    return size(problem.configuration, _elements(problem, tree))


def _of(what: str, word: str) -> Declaration:
    about = (f"{word} of the {what} that end at a place, without torsion, there in equilibrium, other ends held"
             + (", tensions included" if word == "stiffness" else "")
             + ": .max and .min of all directions, .angle of the largest in (−π/2, π/2] from +x, entries .xx, .xy, .yy")
    return Declaration(about, None, _value, ("place",), components=PARTS, dimension=_dimension, size=_size,
                       symbolic=_in_letters, several=True)


QUANTITIES = {word: _of(section, word) for word, section in SECTIONS.items()}
