"""Inputs of the small oscillations: what a load, a driven displacement or a coordinate of this name does to them.

A unit of an input e^{st} drives M q̈ + C q̇ + K q by b(s) e^{st}, b(s) = b₀ + b₁ s + b₂ s²: a force of 1 N along the line
in which it is written, a load along a member in its form whose largest value is 1 N/m, a moment of 1 N·m, an unbalance
of 1 kg·m turning at s = iΩ (in the plane from the direction +x, its reference is cos Ωt), a driven displacement of 1 m
or 1 rad, a generalised force 1 along a coordinate.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.signal_names import signal_name
from vibcli.mechanics.inputs_outputs.amplitudes import amplitudes
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    import mpmath

    from vibcli.language.reader import Record
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction
    from vibcli.scene.displacements import Opening
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

INSTANTS, SAME = (0.0, 0.173, 0.891, 2.317), 1e-12


class Input(NamedTuple):
    """weights {number of an input coordinate: its share}, times (−s²)^turns: an unbalance acts with m₀ e Ω². carried:
    the shares as nodes of the time where a load turns with a body that is driven; then weights are those at t = 0."""

    weights: dict[int, Any]
    turns: int = 0
    carried: "dict[int, Node] | None" = None


def named_input(configuration: "Configuration", text: str) -> Input:
    """The Input of this name: a load, a driven point or body (a component of it: drive.x), a coordinate."""
    opened = configuration.with_inputs
    found = dict(enumerate(opened.scene.inputs.values(), opened.n))
    for kind in (_loads, _driven, _along_coordinate):
        chosen = kind(configuration, text, found)
        if chosen is not None:
            return chosen
    names = list(dict.fromkeys(opening.name for opening in found.values()))
    raise PhysicsError(f"nothing named '{text}' drives this scene", "name one of " + ", ".join(names) if names else
                       "let a load act that is not zero, as in `force: 1 N`")


def drives_supports(configuration: "Configuration", given: Any) -> bool:
    """Is an input, by its weights, the displacement of supports? Or a load."""
    opened = configuration.with_inputs
    driven = [j for j, opening in enumerate(opened.scene.inputs.values(), opened.n) if opening.node is not None]
    return any(share and j in driven for j, share in given.weights.items())


def input_columns(configuration: "Configuration", chosen: Input) -> list[dict[int, Any]]:
    """b as [{i: number}] of the powers s⁰, s¹, s² of an Input; PhysicsError where it depends on the time."""
    if chosen.carried:
        return [configuration.with_inputs.carried(chosen.carried), {}, {}]
    configuration.with_inputs.require_steady(chosen.weights)
    return in_powers(configuration.with_inputs.columns, chosen.weights, chosen.turns)


def in_powers(columns: Mapping[int, list[dict[int, Any]]], weights: Mapping[int, Any],
              turns: int) -> list[dict[int, Any]]:
    """Σ weight·column of the columns [{i: number or node}] of input coordinates, times (−s²)^turns; what a load does
    that turns has no s."""
    parts: list[dict[int, Any]] = [{} for _ in range(3)]
    for j, weight in weights.items():
        for power, column in enumerate(columns[j]):
            for i, x in column.items():
                parts[power][i] = parts[power][i] + weight * x if i in parts[power] else weight * x
    return [{}, {}, {i: -x for i, x in parts[0].items()}] if turns else parts


def direct_part(row: "LinearFunction", chosen: Input) -> list[float]:
    """d as [number] of the powers s⁰, s¹, s²: what an Input does to a LinearFunction at once."""
    if chosen.carried and any(part.get(j) for part in (row.q, row.v, row.a) for j in chosen.carried):
        raise PhysicsError("what this load does to the signal at once turns with what is driven",
                           "ask for a coordinate")
    parts = [sum(weight * part.get(j, 0.0) for j, weight in chosen.weights.items()) for part in (row.q, row.v, row.a)]
    return [0.0, 0.0, -parts[0]] if chosen.turns else parts


def _loads(configuration: "Configuration", text: str, found: "dict[int, Opening]") -> Input | None:
    name, axis, *_ = signal_name(text)
    record = (configuration.spec.get("forces") or {}).get(name)
    terms = {i: opening.load for i, opening in found.items() if opening.load is not None and opening.name == name}
    if record is not None and "per_length" in record:
        from vibcli.mechanics.inputs_outputs.spread_inputs import spread_input

        return None if axis else Input(spread_input(configuration, name, found))
    if record is None or axis not in ("", "x", "y") or not terms:
        return None
    if axis:
        return Input({list(terms)["xy".index(axis)]: 1.0}) if len(terms) == 2 else None
    if "unbalance" in record:
        return Input(dict(zip(terms, (1.0, -1j), strict=False)), turns=1)
    scene, sample = configuration.with_inputs.scene, configuration.with_inputs.sample
    nodes = [scene.forces[k].weight for k in terms.values()]
    if not _keeps_line(nodes, scene, sample):
        if "carrier" in record:
            return _carried(configuration, record, name, terms)
        raise PhysicsError(f"'{name}' changes its direction: it has no line", f"name {name}.x or {name}.y")
    return Input(dict(zip(terms, _unit(amplitudes(configuration.with_inputs, nodes), name), strict=True)))


def _carried(configuration: "Configuration", record: "Record", name: str, terms: Iterable[int]) -> Input:
    """The direction of a load, as it is written in the axes of the body that carries it."""
    scene, sample = configuration.with_inputs.scene, configuration.with_inputs.sample
    written = amplitudes(configuration.with_inputs, [scene.lower(part) for part in record["force"]])
    line = [scene.table.number(fraction_of(x)) for x in _unit(written, name)]
    nodes = dict(zip(terms, scene.frame(record["carrier"]).turned(*line), strict=True))
    start = evaluate(list(nodes.values()), Floats, {**sample, scene.time.name: 0.0})
    return Input(dict(zip(nodes, start, strict=True)), carried=nodes)


def _keeps_line(nodes: "list[Node]", scene: "Scene", sample: "Mapping[str, float | mpmath.mpf]") -> bool:
    """Does what has these components, one or two, keep its line in time?"""
    if len(nodes) == 1:
        return True
    moving = [evaluate(nodes, Floats, {**sample, scene.time.name: t}) for t in INSTANTS]
    return not any(abs(x * v - y * u) > SAME * (abs(x * v) + abs(y * u)) for x, y in moving for u, v in moving)


def _unit(vector: "Sequence[float | mpmath.mpf]", name: str) -> list[float]:
    if len(vector) == 1:
        return [-1.0 if vector[0] < 0 else 1.0]
    length = sum(x * x for x in vector) ** 0.5
    if not length:
        raise PhysicsError(f"'{name}' has no direction in equilibrium", f"name {name}.x or {name}.y")
    return [x / length for x in vector]


def _driven(configuration: "Configuration", text: str, found: "Mapping[int, Opening]") -> Input | None:
    """A point or body that is driven: its one displacement, or the line along which it moves."""
    scene = configuration.with_inputs.scene
    moved = {i: opening for i, opening in found.items() if opening.node is not None}
    exact = [i for i, opening in moved.items() if opening.name == text]
    parts = exact or [i for i, opening in moved.items() if signal_name(opening.name).name == text]
    if not parts:
        return None
    if len(parts) == 1:
        return Input({parts[0]: 1.0})
    nodes = [moved[i].node for i in parts]
    values = configuration.with_inputs.sample
    if exact or not _keeps_line(nodes, scene, values):
        raise PhysicsError(f"'{text}' is driven in several ways", f"name {text}.x or {text}.y of a point")
    return Input(dict(zip(parts, _unit(amplitudes(configuration.with_inputs, nodes), text), strict=True)))


def _along_coordinate(configuration: "Configuration", text: str, found: "Mapping[int, Opening]") -> Input | None:
    if text not in configuration.spec.coordinates:
        return None
    return Input({i: 1.0 for i, opening in found.items()
                  if opening.name == text and opening.load is None and opening.node is None})
