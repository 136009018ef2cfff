"""Forces in constraints and supports in letters, at rest as drawn or at a given place, at given accelerations.

As in numbers (mechanics/reactions.py) the scene is released, and with the position put in, all is linear in λ:

    E_q + Σ λ_k ∂G_k/∂q = 0        R_ρ = E_ρ + Σ λ_k ∂G_k/∂ρ,        E = d/dt ∂T/∂q̇ − ∂T/∂q + ∂Φ/∂q̇ + ∂V/∂q − Q.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.parameter_samples import given_values
from vibcli.mechanics.energies import dissipation, kinetic, potential
from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING, OPEN, constraint_slopes, left_inverse
from vibcli.mechanics.lagrange import equation_of
from vibcli.mechanics.static_preload import pivots, solve_linear, take_over
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.radicals import without_bars
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAMPLES = range(16)     # sets of values of letters at which signs are looked at, some of letters far apart


class SymbolicForces(NamedTuple):
    """conditions: {coordinate: left side of its equation, the forces of constraints in it as symbols}; supports:
    {signal: R of a support with these symbols}; forces: {symbol: signal of the constraint}; values: {signal:
    expression, None where rigid bodies alone leave it open} of constraints and supports; degree: how many forces are
    more than rigid bodies fix."""

    conditions: "dict[str, Node]"
    supports: "dict[str, Node]"
    forces: "dict[Node, str]"
    values: "dict[str, Node | None]"
    degree: int


class _Open(NamedTuple):
    """Numbers of the constraints, and of the supports among the coordinates, whose forces statics leaves open; how many
    forces are too many."""

    ties: tuple[int, ...]
    supports: tuple[int, ...]
    degree: int


def symbolic_forces(numeric: "NumericSystem", accelerations: "Mapping[str, Node] | None" = None,
                    place: "Mapping[str, Node] | None" = None) -> SymbolicForces:
    """The SymbolicForces of a system at rest as drawn, or at a `place` {coordinate: node} of those that are elsewhere,
    with the `accelerations` {coordinate: node}, else without."""
    scene = take_over(numeric.scene.with_released_supports(), numeric.system.preloads)
    n, total = len(numeric.spec.coordinates), scene.table.total
    E, G = _at_rest(scene, accelerations or {}, place or {}, n)
    multipliers, left_open = _multipliers(scene, E[:n], G)
    signs = [1 if tie.form in LENGTHENING else -1 for tie in scene.constraints]
    symbols = [scene.table.variable("S_" + tie.name.replace(".", "_")) for tie in scene.constraints]
    values = {tie.signal: None if k in left_open.ties else _simplest(signs[k] * multipliers[k])
              for k, tie in enumerate(scene.constraints)}
    equations = []
    for i, q in enumerate(scene.q):
        ties = [signs[k] * row[i] * symbols[k] for k, row in enumerate(G)]
        equations.append(textbook(total([E[i], *ties])))
        if i >= n:
            force = total([E[i], *(row[i] * size for row, size in zip(G, multipliers, strict=True))])
            values[q.name] = None if i in left_open.supports else _simplest(force)
    free = [scene.table.zero, *equations[:n]]       # what a coordinate does costs no reaction
    supports = {q.name: node for q, node in zip(scene.q[n:], equations[n:], strict=True)
                if not any(is_zero(node - sign * other) for other in free for sign in (1, -1))}
    return SymbolicForces(dict(zip((q.name for q in scene.q[:n]), equations, strict=False)), supports,
                          dict(zip(symbols, (tie.signal for tie in scene.constraints), strict=True)), values,
                          left_open.degree)


def _simplest(node: "Node") -> "Node":
    """A fraction without common factors, where that is shorter."""
    found = single(node)
    return min((found, single(textbook(found))), key=letters)


def _without_bars(node: "Node", samples: list[dict[str, float]]) -> "Node":
    """An expression with lengths as drawn for the roots of their squares."""
    found = without_bars(node, samples)
    return node if found is node else single(found)


def _samples(scene: "Scene") -> list[dict[str, float]]:
    """Values of the parameters, at those that the file has."""
    parameters = scene.parameters
    values = (given_values(parameters, scene.sample, parameters.free, attempt) for attempt in SAMPLES)
    return [parameters.values(Floats, {name: float(value) for name, value in known.items()})
            for known, _ in zip(values, SAMPLES if parameters.free else "1", strict=False)]


def _at_rest(scene: "Scene", accelerations: "Mapping[str, Node]", place: "Mapping[str, Node]",
             n: int) -> "tuple[list[Node], list[list[Node]]]":
    """E of every coordinate, and [∂G_k/∂q] of each constraint, at rest as drawn but for what is at a place; n: how many
    coordinates are no supports that give way."""
    T, V, Phi = kinetic(scene), potential(scene), dissipation(scene)
    nodes = [*(equation_of(scene, i, T, V, Phi) for i in range(len(scene.q))), *constraint_slopes(scene)]
    nodes = _with_lengths_as_drawn(scene, nodes, n) if place else nodes
    zero = scene.table.zero
    given, elsewhere = ({name: copied([node], scene.table)[0] for name, node in of.items()}
                        for of in (accelerations, place))
    at = {**scene.drawn_position, **{q: elsewhere[q.name] for q in scene.q if q.name in elsewhere}}
    at |= dict.fromkeys(scene.v, zero)
    at |= {a: given.get(q.name, zero) for q, a in zip(scene.q, scene.a, strict=True)}
    samples = _samples(scene)
    found = [_without_bars(textbook(node), samples) for node in substitute(nodes, at)]
    size = len(scene.q)
    return found[:size], [found[start:start + size] for start in range(size, len(found), size)]


def _with_lengths_as_drawn(scene: "Scene", nodes: "Sequence[Node]", n: int) -> "list[Node]":
    """Expressions of supports that hold with lengths as drawn for the roots of their squares."""
    still = {q: scene.drawn_position[q] for q in scene.q[n:]}
    return scene.unrooted(substitute(nodes, still))


def _multipliers(scene: "Scene", E: "Sequence[Node]", G: "Sequence[list[Node]]") -> "tuple[list[Node], _Open]":
    """([λ_k], which of them and of the supports' reactions rigid bodies leave open): one solution of Gᵀλ = −E."""
    import numpy as np

    zero, count, n = scene.table.zero, len(G), len(E)
    if not count:
        return [], _Open((), (), 0)
    values = {**scene.sample, scene.time.name: 0.0}
    slopes = np.array(evaluate([node for row in G for node in row], Floats, values)).reshape(count, -1)
    rows, picked = pivots(slopes[:, :n].T.tolist())
    found = solve_linear([[G[k][i] for k in picked] + [-E[i]] for i in rows], zero)
    solution = dict(zip(picked, found, strict=True))
    _, loose = left_inverse(slopes[:, :n], scene.units_of([q.name for q in scene.q[:n]]))
    shared = np.abs(loose).max(axis=0, initial=0.0) > OPEN
    carried = np.abs(loose @ slopes).max(axis=0, initial=0.0) > OPEN
    return [solution.get(k, zero) for k in range(count)], _Open(
        tuple(np.flatnonzero(shared)), tuple(np.flatnonzero(carried)), len(loose))
