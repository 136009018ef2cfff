"""Numbers that are read off the steady state of a signal which loads keep up."""

from collections.abc import Sequence
from math import tau
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.results.signals import LinearSignal

COMMENSURATE, MOST = 1e-9, 1000
ALONE = 1e-10       # amplitude of another harmonic, relative to the largest, that counts as none


def harmonics(signal: "LinearSignal") -> list[tuple[float, complex]]:
    """[(Ω, X)] of the waves of the steady state that is no constant, where it has finitely many."""
    steady = signal.motion.steady
    if steady.period is not None:
        raise PhysicsError("this steady state has harmonics without end", "ask for harmonic[1](x), or max(steady(x))")
    found = [(Omega, X) for Omega, X in steady.phasors(signal.output) if Omega]
    largest = max((abs(X) for _, X in found), default=0.0)
    return [(Omega, X) for Omega, X in found if abs(X) > ALONE * largest]


def fundamental(signal: "LinearSignal") -> float:
    """The angular frequency of a periodic steady state; PhysicsError where it is not periodic."""
    steady = signal.motion.steady
    if steady.period is not None:
        result: float = tau / steady.period
        return result
    speeds = [Omega for Omega, _ in harmonics(signal)]
    if not speeds:
        raise PhysicsError("this steady state is at rest: it has no period", "ask for max(steady(x))")
    found = common(speeds)
    if found is None:
        raise PhysicsError("the frequencies of this steady state have no common period", "ask for max(x) and min(x)")
    return found


def common(speeds: Sequence[float]) -> float | None:
    """The angular frequency of which all are multiples; None where there is none."""
    for parts in range(1, MOST):
        ratios = [parts * speed / speeds[0] for speed in speeds]
        if all(abs(ratio - round(ratio)) <= COMMENSURATE * ratio for ratio in ratios):
            return speeds[0] / parts
    return None


def harmonic(signal: "LinearSignal", number: int) -> complex:
    """The complex amplitude X of harmonic n of a periodic steady state."""
    steady = signal.motion.steady
    if steady.period is None and signal.motion.forcing.period is not None:     # of one harmonic alone
        return sum((X for _, X in harmonics(signal)), 0j)
    Omega = fundamental(signal)
    if steady.period is not None:
        return steady.harmonic(signal.output, number)
    near = [X for speed, X in harmonics(signal) if abs(speed - number * Omega) <= COMMENSURATE * speed]
    return near[0] if near else 0j


def amplitude(signal: "LinearSignal") -> float:
    """Of one harmonic |X|, of several half the range over a period."""
    if signal.motion.steady.period is None:
        found = harmonics(signal)
        if len(found) < 2:
            return abs(found[0][1]) if found else 0.0
    period, steady = tau / fundamental(signal), signal.steady
    return 0.5 * (steady.extreme(0.0, period, 1)[1] - steady.extreme(0.0, period, -1)[1])
