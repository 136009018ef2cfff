"""Derivatives by numbers alone: K and C + G by central differences of the forces, M by the kinetic energies of unit
velocities, which are quadratic in them."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from vibcli.evidence.subject import BY_DIFFERENCES, Deadline, MethodAnswer, MethodRun, Subject

if TYPE_CHECKING:
    from vibcli.evidence.subjects.matrices import PlainForces

STEPS = tuple(10.0**-k for k in range(1, 9))        # of the size of a coordinate


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """With shorter and shorter steps; none where loops are closed."""
    plain = subject.data
    if plain is None:
        return
    if subject.kind != BY_DIFFERENCES and plain.head == "M":
        yield MethodRun("kinetic energies", "", partial(_energies, plain))
        return
    run = _estimate if subject.kind == BY_DIFFERENCES else _differences
    for step in STEPS:
        yield MethodRun("central differences", f"{step:.0e}", partial(run, plain, step))


def _estimate(estimate: Callable[[float], float], step: float, _: Deadline) -> MethodAnswer:
    return MethodAnswer([estimate(step)])


def _energies(plain: "PlainForces", _: Deadline) -> MethodAnswer:
    i, j = plain.pair
    rest = [0.0] * len(plain.units)

    def energy(*moved: int) -> float:
        return plain.at(rest, [float(moved.count(k)) for k in range(len(rest))])[0]

    T = (energy(i, j) - energy() if i == j else energy(i, j) + energy() - energy(i) - energy(j))
    return MethodAnswer([T / 2 if i == j else T])


def _differences(plain: "PlainForces", step: float, _: Deadline) -> MethodAnswer:
    i, j = plain.pair
    if plain.head == "K":
        return MethodAnswer([_slope(plain, i, j, step, 0)])
    one, other = _slope(plain, i, j, step, 1), _slope(plain, j, i, step, 1)
    return MethodAnswer([(one + other) / 2 if plain.head == "C" else (one - other) / 2])


def _slope(plain: "PlainForces", i: int, j: int, step: float, rate: int) -> float:
    """∂hᵢ/∂qⱼ, or by the velocity of that coordinate."""
    rest = [0.0] * len(plain.units)
    ends = []
    for way in (1, -1):
        moved = rest.copy()
        moved[j] = way * step * plain.units[j]
        ends.append(plain.at(*((rest, moved) if rate else (moved, rest)))[1 + i])
    return (ends[0] - ends[1]) / (2 * step * plain.units[j])
