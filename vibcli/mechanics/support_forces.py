"""What springs and dampers exert on the ground, Σ F: on whatever is fixed or driven, in the fixed axes.

An element with tension F pulls each of its ends towards the other.
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction, combined, product, rate
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.language.reader import Expression, Record, Reference
    from vibcli.language.signal_names import SignalName
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

PARTS = {"force": "slide", "moment": "turn"}


def on_the_ground(opened: Any, signal: "SignalName") -> LinearFunction:
    """The LinearFunction of ground.force, ground.moment (one-axis scenes), ground.force.x or ground.force.y."""
    terms, axis = [], signal.axis
    if opened.scene.members:
        raise PhysicsError(f"ground.{signal.part} is not told where members stand on the ground",
                           "ask for what they bear there: rod.force(0 m), wing.shear(0 m), line.moment(0 m)")
    for record in opened.configuration.spec.connections:
        terms += _of_element(opened, record, signal.kind, axis)
    if not terms:
        which, along = ("", f" along {axis}") if axis else (" of one axis", "")
        raise PhysicsError(f"no spring or damper{which} exerts a {signal.kind} on the ground{along}",
                           "ask for ground.force in one-axis scenes, else for ground.force.x or .y")
    return combined(terms)


def _of_element(opened: "SystemWithInputs", record: "Record", kind: str,
                axis: str) -> list[tuple[float, LinearFunction]]:
    """[(factor, LinearFunction)] of one element; none where it does not end at the ground."""
    scene = opened.scene
    if "between" not in record:
        raise PhysicsError(f"'{record.name}' gives its stretch outright: what it exerts on the ground is not known",
                           "give its two ends with `between`")
    ends = record["between"]
    sign = along_the_axis(opened, record, kind)
    if sign is not None:
        return [] if axis or not sign else [(float(sign), force) for force in forces(opened, record.name)]
    if "torsion" in record or not axis:
        return []
    places = [scene.place_of(end) for end in ends]
    held = [not any(_moves(opened, node) for node in place) for place in places]
    if held[0] == held[1]:
        return []
    span = [b - a for a, b in zip(*places, strict=True)]
    sign, found = 1.0 if held[0] else -1.0, forces(opened, record.name)
    if len(found) > 1:
        return [(sign, found["xy".index(axis)])]
    along, = opened.rows([span["xy".index(axis)] / scene.distance(*span)])
    return [(sign, product(found[0], along))]


def along_the_axis(opened: Any, record: "Record", kind: str) -> int:
    """±1: the sign with which the tension of an element between lumped ends acts on the ground; 0 where it does not,
    None of an element between places."""
    lumped = [_axis_of(opened.scene, end) for end in record["between"]]
    if None in lumped:
        return None
    held = [not _moves(opened, node) for _, node in lumped]
    if held[0] == held[1] or ("torsion" in record) != (kind == "moment"):
        return 0
    return 1 if held[0] else -1


def _axis_of(scene: "Scene", end: "list[Expression] | Reference") -> "tuple[str, Node] | None":
    """(slide or turn, displacement) of the ground or a lumped body; None of what has a place."""
    if isinstance(end, list):
        return None
    if end.text == "ground":
        return "ground", scene.table.zero
    body = scene.bodies.get(end.text)
    return None if body is None else body.lumped


def _moves(opened: "SystemWithInputs", node: "Node") -> bool:
    return any(node.mask & q.mask for q in opened.scene.q[:opened.n])


def forces(opened: Any, name: str) -> list[LinearFunction]:
    """The LinearFunctions of the force of an element; those of its components where it has no free length."""
    scene = opened.scene
    return [combined([pair]) for pair in weighted_rates(opened, name)] or opened.rows(
        [term.force(scene) for term in scene.terms_of(name)])


def weighted_rates(opened: Any, name: str) -> list[tuple[float, LinearFunction]]:
    """[(weight, LinearFunction)] of ṡ of a linear damper, of s̈ of an inerter; none of another element."""
    scene = opened.scene
    terms = scene.terms_of(name, "dampers", "inertias")
    weights = evaluate([term.weight for term in terms], opened.arithmetic, opened.values)
    rates = [rate(row, scene) for row in opened.rows([term.s for term in terms])]
    if scene.terms_of(name, "inertias"):
        rates = [rate(row, scene) for row in rates]
    return list(zip(weights, rates, strict=True))
