"""Quantities of equilibria: where they are, how many there are, whether they are stable."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.units import LENGTH
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import CONTACT, is_reaction, signal_dimension
from vibcli.quantities.matrices import coordinate_number
from vibcli.quantities.quantity import COUNT, FUNCTION, ROUNDING, TRUTH, Declaration, measured, unit
from vibcli.quantities.signal_dimensions import generalised_dimension, name_dimension

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.rest_at_jumps import JumpsAtRest
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


def about(problem: "Problem", number: int) -> "Problem":
    """The problem about one of all its equilibria."""
    if number > count(problem):
        raise PhysicsError(f"there is no equilibrium {number}: {count(problem) or 'none'} "
                           f"{'is' if count(problem) < 2 else 'are'} found within the bounds",
                           "ask for one of these, or give bounds as in find: {equilibria: all, within: …}")
    return problem.about_each[number - 1]


def count(problem: "Problem") -> int:
    """How many equilibria are found; refused where the search could not be finished."""
    found = problem.equilibria
    if found.cut:
        raise PhysicsError("the search for all equilibria was cut short: their number is not known",
                           "give narrower bounds, as in find: {equilibria: all, within: …}")
    if found.missed:
        raise PhysicsError(f"more equilibria exist than the {len(found.items)} that were found: by the forces on the "
                           f"bounds their indices sum to {found.indices.degree}, not {found.indices.sum}",
                           "give narrower bounds, as in find: {equilibria: all, within: …}")
    return len(found.items)


def at_rest(problem: "Problem", scene: "Scene", signal: str) -> "Node | None":
    """The expression of a coordinate, place, turn, stretch or force of a spring at rest; None of another signal."""
    from vibcli.mechanics.inputs_outputs.displacements import resting

    node, (name, part, *_) = resting(scene, signal), signal_name(signal)
    if node is None and part == "force" and name in (problem.spec.get("springs") or {}):
        return scene.force_of(name)
    return node


def _equilibrium(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    from vibcli.symbolic.evaluation import evaluate
    from vibcli.symbolic.running_errors import RunningErrors

    signal = problem.spec.coordinate_name(tree.indices[0]) or tree.indices[0]
    scene, (name, part, *_) = problem.scene.resting, signal_name(signal)
    node = at_rest(problem, scene, signal)
    if node is None and part == "energy" and (laws := scene.terms_of(name, "laws")):
        node = scene.table.total([law.energy(scene) for law in laws])
    if node is None:
        return _force(problem, signal)
    jumps = problem.configuration.equilibrium.jumps
    if jumps is not None:
        node = _opened(problem, jumps, node, signal)
    if problem.digits is None:
        return measured(evaluate([node], *problem.configuration.bounded_rest)[0])
    inner, values = problem.configuration.precise_rest(problem.digits)
    return measured(evaluate([node], RunningErrors(inner, unit(problem)), values)[0], 10.0**-problem.digits)


def _force(problem: "Problem", signal: str) -> tuple[float, float]:
    from vibcli.mechanics.signals import force, reaction_error

    found = force(problem.configuration, signal)
    if not found or not is_reaction(problem.spec, signal):
        return found, ROUNDING
    return found, min(1.0, max(ROUNDING, reaction_error(problem.configuration, signal) / abs(found)))


def _opened(problem: "Problem", jumps: "JumpsAtRest", node: "Node", signal: str) -> "Node":
    """An expression with what stands for the jumps at rest; refused where several laws jump there at once."""
    from vibcli.symbolic.expression_graph import reachable

    scene = problem.scene.resting
    for part in jumps.nodes.keys() & set(reachable([node])):
        owners = {law.owner for law in scene.laws if part in reachable([law.force(scene)])}
        if len(owners) > 1:
            raise PhysicsError(f"balance alone does not tell '{signal}': {' and '.join(sorted(owners))} jump at one "
                               "place, and bear there only together what it asks for", "give one law in their stead")
    return jumps.opened(node)


def _in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    """A coordinate, place, turn, stretch or tension in equilibrium."""
    from vibcli.symbolic.derivatives import substitute
    from vibcli.symbolic.normal_form import textbook

    text = problem.spec.coordinate_name(tree.indices[0]) or tree.indices[0]
    scene, name = problem.scene, signal_name(text)
    node = at_rest(problem, scene, text)
    if node is None and is_reaction(problem.spec, text) and name.kind not in CONTACT:
        return _force_in_letters(problem, text)
    if node is None:
        raise NotInLetters(f"'{text}' in equilibrium is found in numbers")
    values, zero = problem.symbolic.equilibrium_position, scene.table.zero
    rest = dict.fromkeys((*scene.v, scene.time), zero) | {q: values[q.name] for q in scene.q}
    found, = substitute([node], rest)
    if found.mask:
        raise NotInLetters(f"'{text}' in equilibrium is found in numbers")
    return textbook(found)


def _force_in_letters(problem: "Problem", text: str) -> "Node":
    """The force of a constraint or support."""
    from vibcli.mechanics.signals import not_fixed, reaction_of

    known = problem.symbolic.reactions.values
    text = reaction_of(problem.system, text, known)
    if known[text] is None:
        raise not_fixed(text, known)
    found: Node = known[text]
    return found


def _size(problem: "Problem", tree: "QuantityRef") -> float:
    """Of a coordinate, place, turn or force in equilibrium; forces lose a digit more."""
    from vibcli.results.random_states import reach

    text = tree.indices[0]
    name = problem.spec.coordinate_name(text)
    if name is not None:
        return reach(problem, name)
    dimension = signal_dimension(problem.spec, text)
    if dimension in ({}, LENGTH):
        return problem.numeric.figure_size or 1.0 if dimension else 1.0
    reactions = problem.configuration.reactions
    return 10.0 * max((abs(reaction.value) for reaction in reactions if reaction.value), default=0.0)


def _generalised_force(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.mechanics.virtual_work import generalised_force_at_rest

    return generalised_force_at_rest(problem.system, coordinate_number(problem, tree.indices[0]))


def _stable(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[bool, float]:
    found = problem.modal.stability.stable
    if found is None:
        raise PhysicsError("loads without a potential act on what has no inertia: masses or dampers would decide "
                           "whether it is stable", "give it a mass or a damper")
    return found, 0.0


QUANTITIES = {
    "equilibrium": Declaration(
        "a coordinate or signal in equilibrium", None, _equilibrium, ("signal",), several=True, size=_size,
        symbolic=_in_letters, dimension=lambda spec, tree: name_dimension(
            spec, spec.coordinate_name(tree.indices[0]) or tree.indices[0])),
    "Q": Declaration(
        "generalised force of weights, springs and steady loads at rest, δA = Σ Q δq", indices=("coordinate",),
        kind=FUNCTION, symbolic=_generalised_force, dimension=lambda spec, tree: generalised_dimension(
            spec, spec.coordinate_name(tree.indices[0]))),
    "stable": Declaration(
        "`true` where the equilibrium is stable: by the eigenvalues of small motions, by the signs of K where not "
        "everything has inertia, and by terms beyond the linear ones where these vanish", "1",
        _stable, several=True, kind=TRUTH),
    "equilibria": Declaration(
        "number of equilibria found within the bounds that `find` gives, or default ones; a line of neutral ones "
        "counts once", "1", lambda problem, tree, args: (count(problem), 0.0), kind=COUNT),
}
