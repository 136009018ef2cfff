"""Where a scene rests: as drawn, in letters, or where a search found it, told with letters of its own."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.mechanics.linearisation import residual_terms
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import is_zero
from vibcli.symbolic.parser import VALUE
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

UNMOVED = 1e-12         # relative: how far from the drawn place rounding alone brings a coordinate at rest
OF_PLACES = VALUE, "max", "min", "mean"         # what one asks of a place, which has its unit and zero
RECKONED = ("from now on ", " is counted from there")


def about_rest(problem: "Problem", sheet: WorkedSolution) -> AboutRest:
    """The problem about its rest. Where that is known in numbers alone, coordinates that rest elsewhere than drawn have
    letters there, which are told with what a search found."""
    scene, symbolic = problem.scene, problem.symbolic
    if symbolic.balanced_as_drawn:
        return AboutRest(problem, scene.drawn_position, {}, sheet)
    try:
        named = symbolic.equilibrium_position
    except NotInLetters:
        if problem.numeric.has_free_symbols:
            raise
        return _about_numbers(problem, sheet)
    about = AboutRest(problem, {**scene.drawn_position, **{q: named[q.name] for q in scene.q}}, {}, sheet)
    for q in scene.q:
        if not about.same(named[q.name], scene.drawn[q]):
            value, unit = about.value(named[q.name]), "m" if problem.system.dimension(q.name) else "rad"
            sheet.write(Words("the forces balance at  "), Name(q.name), " = ", named[q.name],
                        *(() if value is None else number(value, unit)), Words(f";  {RECKONED[0]}"), Name(q.name),
                        Words(RECKONED[1]), settles=f"equilibrium[{q.name}]", node=named[q.name],
                        value=value, unit=unit)
    return about


def as_counted(problem: "Problem", tree: Any) -> list[Words]:
    """Words where a place in time is asked of a coordinate that lines count from rest, and the file as drawn."""
    place = tree.args[0] if getattr(tree, "head", "") in OF_PLACES and tree.args else None
    if not isinstance(place, NameRef) or place.primes or problem.spec.in_full:
        return []
    try:
        moved = not problem.symbolic.balanced_as_drawn and _is_moved(problem, place.name)
    except PhysicsError:        # nothing is counted from rest
        return []
    return [Words(" (counted as drawn)")] * moved


def _is_moved(problem: "Problem", name: str) -> bool:
    """Does a coordinate rest elsewhere than drawn?"""
    if problem.numeric.has_free_symbols:
        rest = problem.symbolic.equilibrium_position.get(name)
        return rest is not None and not is_zero(rest - problem.scene.drawn[problem.scene.symbol(name)])
    rest, drawn = problem.configuration.equilibrium.values, problem.scene.drawn_values
    if name in problem.scene.coordinates:
        return abs(rest[name] - drawn[name]) > UNMOVED * (1 + abs(drawn[name]))
    return name in problem.scene.dependent


def _about_numbers(problem: "Problem", sheet: WorkedSolution) -> AboutRest:
    """The problem about a place of rest that a search found."""
    scene, values = problem.scene, problem.configuration.equilibrium.values
    looped = scene.loops.names if scene.loops is not None else ()
    moving = {q.name: q for q in scene.q} | {name: node for name, node in scene.dependent.items() if name in looped}
    drawn = dict(zip(moving, evaluate([scene.drawn[scene.symbol(name)] for name in moving], Floats,
                                      problem.numeric.floats), strict=True))
    moved = [name for name in moving if abs(values[name] - drawn[name]) > UNMOVED * (1 + abs(drawn[name]))]
    letter = {name: sheet.letter(f"{name}0") for name in moved}
    symbols = {moving[name]: scene.table.parameter(letter[name], positive=False) for name in moved}
    vanishes = _conditions(problem, {**scene.drawn_position, **symbols})
    left = problem.configuration.equilibrium.residual
    how = "the forces balance exactly"
    if left:
        how = f"what is left of the forces is {figure(left, digits=2)} of their terms"
    for name in moved:
        unit = "m" if problem.system.dimension(name) else "rad"
        first, last = name == moved[0], name == moved[-1]
        it = (Name(name), Words(RECKONED[1])) if first else (Words("all are counted from there"),)
        sheet.write(*([Words("at rest  ")] if first else []), Name(name), " = ", Name(letter[name]), *number(
            values[name], unit), *((Words(f"  by a search ({how}); {RECKONED[0]}"), *it) if last else ()),
            settles=f"equilibrium[{name}]", value=values[name], unit=unit, joined=not first, letter=letter[name],
            vanishes=vanishes.get(name))
    return AboutRest(problem, {**scene.drawn_position, **symbols}, {letter[name]: values[name] for name in moved},
                     sheet)


def _conditions(problem: "Problem", place: "Mapping[Node, Node]") -> "dict[str, Node]":
    """{coordinate: an expression that vanishes where it rests}: the force along it, or of loops a condition."""
    scene = problem.scene
    still = {**place, **dict.fromkeys((*scene.v, *scene.a), scene.table.zero)}
    forces = [scene.table.total(terms) for terms in residual_terms(problem.system.linearisation)]
    of = dict(zip([q.name for q in scene.q], forces, strict=True))
    if scene.loops is not None:
        of |= zip(scene.loops.names, scene.loops.conditions, strict=True)
    return dict(zip(of, substitute(list(of.values()), still), strict=True))
