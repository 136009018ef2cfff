"""Where dry friction holds a scene at rest: at bᵢ(q) + Σ σₖ aᵢₖ(q) = 0 with |σₖ| ≤ σ₀ₖ.

These are the equations of motion at rest, the sign σₖ of each velocity that vanishes being whatever keeps it at zero.
"""

from collections.abc import Callable, Mapping, Sequence
from math import inf, isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.lagrange import equation_of
from vibcli.mechanics.linearisation import residual_terms
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

STEPS, ROUNDS, REACH = 400, 60, 4.0     # REACH: sizes of the figure, radians
SWEEPS, BALANCED = 500, 1e-12           # of the descent; of the forces


class Span(NamedTuple):
    """Places of rest of one coordinate from `low` to `high`, infinite where no end is met; whole: are they all? Empty
    where low > high."""

    low: float
    high: float
    whole: bool


class HeldCondition(NamedTuple):
    """One condition: b + Σ a σ = 0; `held` {σ: a}. `within`: the bound of |b| where its one σ stands in no other
    condition, else None."""

    name: str
    b: Any
    held: "dict[Node, Node]"
    within: Any


class Sticking(NamedTuple):
    """The conditions, a HeldCondition for each coordinate, and {σ: σ₀}."""

    rows: tuple[HeldCondition, ...]
    bounds: "dict[Node, Node]"


def sticking(system: "MechanicalSystem") -> Sticking | None:
    """The Sticking of a scene without loops that are closed numerically; None where no friction holds it."""
    scene = system.scene
    equations = [equation_of(scene, i) for i in range(len(scene.q))]
    symbols, bounds = _senses(scene, equations)
    if not symbols:
        return None
    rest = dict.fromkeys((*scene.v, *scene.a), scene.table.zero)
    opened, terms, parts = substitute(equations, symbols), residual_terms(system.linearisation), []
    for node, row in zip(opened, terms, strict=True):
        slopes = gradient(node)
        held = {sigma: textbook(substitute([slopes[sigma]], rest)[0]) for sigma in bounds if sigma in slopes}
        held = {sigma: a for sigma, a in held.items() if not a.is_zero}
        if any(a.mask & unknown.mask for a in held.values() for unknown in (scene.time, *bounds)):
            return None
        parts.append((textbook(scene.table.total(row)), held))
    if not any(held for _, held in parts):
        return None
    return Sticking(tuple(_row(scene, name, b, held, parts, bounds)
                         for name, (b, held) in zip(scene.coordinates, parts, strict=True)), bounds)


def signs_of_speeds(scene: "Scene", nodes: "Sequence[Node]") -> "list[Node]":
    """The signs in some nodes that a velocity changes, in order."""
    return [part for part in reachable(nodes) if part.name == "sign" and any(part.mask & v.mask for v in scene.v)]


def _senses(scene: "Scene", equations: "list[Node]") -> "tuple[dict[Node, Node], dict[Node, Node]]":
    """({sign of a velocity that vanishes at rest: σ}, {σ: σ₀})."""
    limits = scene.law_switches()[1]
    rest = scene.rates_at_rest
    symbols, bounds = {}, {}
    for part in signs_of_speeds(scene, equations):
        if is_zero(substitute([part.args[0]], rest)[0]):
            sigma = scene.table.variable(f"sigma_{len(symbols) + 1}")
            symbols[part], bounds[sigma] = sigma, limits.get(part.args[0], scene.table.one)
    return symbols, bounds


def _row(scene: "Scene", name: str, b: "Node", held: "dict[Node, Node]",
         parts: "Sequence[tuple[Node, dict[Node, Node]]]", bounds: "Mapping[Node, Node]") -> HeldCondition:
    alone = len(held) == 1 and sum(sigma in other for sigma in held for _, other in parts) == 1
    within = None
    if alone:
        (sigma, a), = held.items()
        within = textbook(bounds[sigma] * scene.table.call("abs", a))
    return HeldCondition(name, b, held, within)


def holds(numeric: Any, found: Any, place: Any) -> bool:
    """Does friction hold the scene at rest at a place {coordinate: value}: is b + A σ = 0 with |σ| ≤ σ₀? The sum of
    squares is descended along one σ after the other."""
    import numpy as np

    names, bounds = list(found.bounds), list(found.bounds.values())
    zero = numeric.scene.table.zero
    nodes = [*bounds, *(row.b for row in found.rows),
             *(row.held.get(sigma, zero) for row in found.rows for sigma in names)]
    values = np.array(evaluate(nodes, Floats, {**numeric.floats, numeric.scene.time.name: 0.0, **place}), dtype=float)
    count = len(names)
    b = values[count:count + len(found.rows)]
    A = values[count + len(found.rows):].reshape(len(b), count) * values[:count]
    if not np.isfinite(values).all():
        return False
    size = np.abs(b) + np.abs(A).sum(axis=1)
    b, A = b / np.where(size > 0, size, 1.0), A / np.where(size > 0, size, 1.0)[:, None]
    sigma = np.clip(np.linalg.lstsq(A, -b, rcond=None)[0], -1.0, 1.0)
    for _ in range(SWEEPS):
        for k in range(count):
            if A[:, k].any():
                sigma[k] = np.clip(sigma[k] - A[:, k] @ (b + A @ sigma) / (A[:, k] @ A[:, k]), -1.0, 1.0)
        if np.abs(b + A @ sigma).max(initial=0.0) <= BALANCED:
            return True
    return False


def span(configuration: "Configuration", found: Sticking) -> Span | None:
    """The Span of a scene of one coordinate in numbers: all places of rest of a linear condition, of others those about
    the drawn position or the equilibrium without friction; None where that is none, and of several coordinates."""
    row, *others = found.rows
    if others or row.within is None:
        return None
    scene = configuration.scene
    (q,), slope = scene.q, gradient(row.b).get(scene.q[0], scene.table.zero)
    if not slope.mask and not row.within.mask:
        b, k, most = evaluate([substitute([row.b], {q: scene.table.zero})[0], slope, row.within], Floats,
                              configuration.numeric.floats)
        if not k:
            return Span(-inf, inf, True) if abs(b) <= most else Span(inf, -inf, True)
        low, high = sorted((-b - sign * most) / k for sign in (1, -1))
        return Span(low, high, True)
    return _about(configuration, row, q)


def _about(configuration: "Configuration", row: HeldCondition, q: "Node") -> Span | None:
    """The same of a nonlinear condition, followed from a place of rest to both sides."""
    from vibcli.base.errors import PhysicsError

    numeric = configuration.numeric

    def room(x: float) -> float:
        b, most = evaluate([row.b, row.within], Floats, {**numeric.floats, q.name: x})
        found: float = most - abs(b)
        return found

    start = numeric.drawn_floats[q.name]
    if not room(start) >= 0:
        try:
            start = configuration.equilibrium.values[q.name]
        except PhysicsError:
            return None
    reach = REACH * numeric.size_along(q.name)
    low, high = (_end(room, start, sign * reach / STEPS) for sign in (-1, 1))
    return Span(low, high, False)


def _end(room: Callable[[float], float], start: float, step: float) -> float:
    """Where room(x) first vanishes from the start on; infinite where it does not."""
    from vibcli.numerics.root_finding import last_place

    low, high = start, start + step
    for _ in range(STEPS):
        value = room(high)
        if not isfinite(value) or value < 0:
            break
        low, high = high, high + step
    else:
        return inf if step > 0 else -inf
    return last_place(lambda x: room(x) >= 0, low, high, ROUNDS)[0]
