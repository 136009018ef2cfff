"""The equations of a motion as one would hand them to an integrator: a function of floats, compiled from the scene's
expressions; and what is read off its solution."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.records import driving_records
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.evaluation_code import in_floats
from vibcli.symbolic.expression_graph import evaluable

if TYPE_CHECKING:
    from vibcli.evidence.reference.motion import Motion
    from vibcli.symbolic.node import Node

STENCIL = 12            # samples about an instant
SAMPLES = 4001          # of a motion whose extreme is looked for


class LinearEquations(NamedTuple):
    """ẏ = A y + B u(t); inputs(times): u there, an instant a row; instants: at which records have their samples."""

    A: np.ndarray
    B: np.ndarray
    inputs: Callable[[np.ndarray], np.ndarray]
    instants: Sequence[float]


class PlainEquations(NamedTuple):
    """ẏ = rates(t, y) of y = (q, q̇) from `start` on until an instant; times: at which the solution is asked for;
    read(Y, times): the number from the states there, one a row; linear: the same of linear motions, else None;
    sizes: of the states, where they are known."""

    rates: Callable[[float, Any], Any]
    start: np.ndarray
    times: np.ndarray
    read: Callable[[np.ndarray, np.ndarray], float]
    linear: LinearEquations | None
    sizes: "np.ndarray | None" = None


def plain_equations(motion: "Motion", node: "Node", until: float, feature: str) -> PlainEquations:
    """Of a signal: `value` at the end, `max`, `min`, `argmax` or `argmin` until then, `zero 2`: its second zero;
    of a whole period its `mean` or `rms`; of a rate the `period`, from a zero to the next but one."""
    start = np.array([float(x) / 2.0**200 for x in motion.start(200)])
    times = np.array([0.0, until]) if feature == "value" else np.linspace(0.0, until, SAMPLES)
    linear = _linear(motion) if motion.rested else None
    rates = _rates(motion) if linear is None else _linear_rates(motion, linear)

    def read(states: np.ndarray, times: np.ndarray) -> float:
        known = _known(motion, times, states, rates if any(node.mask & a.mask for a in motion.scene.a) else None)
        values = np.broadcast_to(evaluate([node], Arrays, known)[0], times.shape)
        if feature.startswith("zero"):
            return _zero(times, values, int(feature[len("zero"):]))
        if feature == "period":
            return _zero(times, values, 3) - _zero(times, values, 1)
        if feature in ("mean", "rms"):
            return float(np.mean(values[:-1]) if feature == "mean" else np.sqrt(np.mean(values[:-1] ** 2)))
        return float(values[-1]) if feature == "value" else extreme(times, values, feature)

    return PlainEquations(rates, start, times, read, linear)


def _known(motion: "Motion", times: np.ndarray, states: np.ndarray,
           rates: Callable[..., np.ndarray] | None) -> dict[str, float | np.ndarray]:
    """{name: array} of all that a signal is made of; q̈ where `rates` gives it."""
    n = len(motion.scene.q)
    known: dict[str, Any] = {**motion.floats, motion.scene.time.name: times}
    rows = [states[:, :n], states[:, n:]]
    if rates is not None:
        rows.append(np.array([rates(t, y)[n:] for t, y in zip(times, states, strict=True)]))
    for primes, row in zip(("", "'", "''"), rows, strict=False):
        known |= {name + primes: column for name, column in zip(motion.scene.coordinates, row.T, strict=True)}
    return known


def extreme(times: np.ndarray, values: np.ndarray, feature: str) -> float:
    """The top of what passes through the largest of the samples and those about it."""
    sense = -1.0 if feature.endswith("min") else 1.0
    i = int(np.argmax(sense * values))
    place, top = float(times[i]), float(values[i])
    if 0 < i < len(values) - 1:
        for left in (i - 1, i):
            curve = _between(times, values, left)
            for turn in _real_roots(curve.deriv(), times[left:left + 2]):
                if sense * curve(turn) > sense * top:
                    place, top = turn, float(curve(turn))
    return place if feature.startswith("arg") else top


def _zero(times: np.ndarray, values: np.ndarray, number: int) -> float:
    """The instant of a zero of what passes through the samples about it."""
    at = [] if values[0] else [0]
    at += (np.flatnonzero(values[1:-1] * values[2:] <= 0) + 1).tolist() if values[0] == 0 else np.flatnonzero(
        values[:-1] * values[1:] <= 0).tolist()
    if len(at) < number:
        raise RuntimeError(f"{len(at)} zeros of this solution")
    i = at[number - 1]
    if not values[i]:
        return float(times[i])
    return next(iter(_real_roots(_between(times, values, i), times[i:i + 2])), float(times[i]))


def _between(times: np.ndarray, values: np.ndarray, i: int) -> Any:
    """The polynomial between a sample and the next one: of the STENCILs of samples that hold both the smoothest, as
    no load may jump within it."""
    firsts = range(max(i + 2 - STENCIL, 0), max(min(i, len(times) - STENCIL), 0) + 1)
    first = min(firsts, key=lambda k: (abs(np.diff(values[k:k + STENCIL], STENCIL - 1)).sum(),
                                       abs(2 * k + STENCIL - 2 * i - 2)))
    which = slice(first, first + STENCIL)
    return np.polynomial.Polynomial.fit(times[which], values[which], min(STENCIL, len(times)) - 1)


def _real_roots(curve: Any, ends: np.ndarray) -> list[float]:
    """Those between two instants, ascending."""
    roots = curve.roots()
    return sorted(float(x.real) for x in roots if abs(x.imag) <= 1e-9 * abs(ends[1] - ends[0])
                  and ends[0] <= x.real <= ends[1])


def _rates(motion: "Motion") -> Callable[[float, Sequence[float]], np.ndarray]:
    """ẏ of y."""
    scene, parts, n = motion.scene, motion.parts, len(motion.scene.q)
    keys = list(parts.M)
    entries = _compiled([*parts.M.values(), *parts.h], motion.floats, scene)
    M = np.zeros((n, n))

    def rates(t: float, y: Sequence[float]) -> np.ndarray:
        found = entries(t, y)
        for (i, j), x in zip(keys, found, strict=False):
            M[i, j] = M[j, i] = x
        right = np.array(found[len(keys):])
        a = right / -M[0, 0] if n == 1 else np.linalg.solve(M, -right)
        return np.concatenate([y[n:], a])

    return rates


def _compiled(nodes: "Sequence[Node]", floats: Mapping[str, float], scene: Any) -> Callable[[float, Any], list[float]]:
    """The nodes as a function of t and y."""
    function, known = in_floats(nodes, evaluable(nodes)), dict(floats)
    names, time = [*scene.coordinates, *(name + "'" for name in scene.coordinates)], scene.time.name

    def values(t: float, y: Any) -> "list[float]":
        known.update(zip(names, map(float, y), strict=True))
        known[time] = float(t)
        return function(known, None)

    return values


def _linear(motion: "Motion") -> LinearEquations:
    """(q̇, M⁻¹(Q(t) − C q̇ − K q)), u = −Q."""
    scene, n = motion.scene, len(motion.scene.q)
    M, C, K = (np.array([[motion.floats[f"{part}[{i};{j}]"] for j in range(n)] for i in range(n)]) for part in "MCK")
    inverse = np.linalg.inv(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ K, -inverse @ C]])
    drive, records = _drive(motion), driving_records(scene, motion.parts.nodes())

    def inputs(times: np.ndarray) -> np.ndarray:
        found = evaluate(drive, Arrays, {**motion.floats, scene.time.name: times})
        return np.array([np.broadcast_to(x, times.shape) for x in found]).T

    instants = [float(t) for record in records for t in record.instants(scene.time.name, motion.floats)]
    return LinearEquations(A, np.concatenate([np.zeros((n, n)), -inverse]), inputs, instants)


def _drive(motion: "Motion") -> "list[Node]":
    """What is left of the equations at rest."""
    scene = motion.scene
    return substitute(motion.parts.h, dict.fromkeys((*scene.q, *scene.v), scene.table.zero))


def _linear_rates(motion: "Motion", linear: LinearEquations) -> Callable[..., Any]:
    """A y + B u(t)"""
    A, B, drive = linear.A, linear.B, _drive(motion)
    if all(node.is_zero for node in drive):
        return lambda t, y: A @ y
    loads, rest = _compiled(drive, motion.floats, motion.scene), np.zeros(len(A))
    return lambda t, y: A @ y + B @ np.array(loads(t, rest))
