"""The steady state under loads of one frequency, Q(t) = Re (A − iB) e^{iΩt} + constants, as a frequency response to
them all: x = Re H e^{iΩt}. Ω is the rate of the angle in their sines and cosines; A and B are read off at quarters of a
period, and hold at other instants.
"""

from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.frequency_response import Transfer, at
from vibcli.evidence.reference.motion import Motion, small
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

TRIED = ("0.137", "0.421", "0.773")     # parts of a period


class HarmonicLoads(NamedTuple):
    """A Motion with the expressions of its loads and of the rates of their angles."""

    motion: Motion
    loads: list
    rates: list


def driven(problem: "Problem") -> HarmonicLoads:
    """Of a scene whose loads are sines and cosines of one angle; PhysicsError of others."""
    motion = small(problem)
    scene = motion.scene
    still = dict.fromkeys((*scene.q, *scene.v), scene.table.zero)
    loads = [-node for node in substitute(motion.parts.h, still)]
    waves = [part for part in reachable(loads) if part.op == "call" and part.mask & scene.time.mask]
    rates = [gradient(part.args[0]).get(scene.time) for part in waves if part.name in ("sin", "cos")]
    if not waves or len(rates) < len(waves) or any(rate is None or rate.mask for rate in rates):
        raise PhysicsError("a reference of steady states is found of loads that are sines and cosines alone")
    return HarmonicLoads(motion, loads, rates)


def transfer(known: HarmonicLoads, name: str, primes: int) -> tuple[Transfer, Any]:
    """(the response of a rate of a coordinate to all loads, Ω) at the working precision."""
    motion, n = known.motion, len(known.loads)
    numbers = motion.values(mpmath.mp.prec)
    Omega, *others = (abs(x) for x in evaluate(known.rates, multiprecision(), numbers))
    if any(abs(x - Omega) > mpmath.mpf(10) ** (5 - mpmath.mp.dps) * Omega for x in others):
        raise PhysicsError("a reference of steady states is found of loads of one frequency")
    M, C, K = (mpmath.matrix([[numbers[f"{part}[{i};{j}]"] for j in range(n)] for i in range(n)]) for part in "MCK")
    zero = mpmath.zeros(n, 1)
    row = mpmath.matrix([int(other == name) for other in motion.scene.coordinates])
    c = [zero] * 3
    c[primes] = row
    b = [mpmath.matrix(_loads_over_a_period(known, numbers, Omega)[0]), zero, zero]
    return Transfer(M, C, K, b, c, [mpmath.mpf(0)] * 3), Omega


def _loads_over_a_period(known, numbers, Omega):
    """(the phasors of the loads, their means)."""
    period = 2 * mpmath.pi / Omega

    def loads(part):
        return evaluate(known.loads, multiprecision(), {**numbers, known.motion.scene.time.name: part * period})

    start, quarter, half, last = (loads(mpmath.mpf(k) / 4) for k in range(4))
    found = [mpmath.mpc((a - c) / 2, (d - b) / 2) for a, b, c, d in zip(start, quarter, half, last, strict=True)]
    means = [(a + c) / 2 for a, c in zip(start, half, strict=True)]
    size = max(map(abs, found))
    for part in map(mpmath.mpf, TRIED):
        wave = mpmath.expjpi(2 * part)
        if any(abs(mpmath.re(x * wave) + mean - load) > mpmath.mpf(10) ** (8 - mpmath.mp.dps) * (size + abs(mean))
               for x, mean, load in zip(found, means, loads(part), strict=True)):
            raise PhysicsError("a reference of steady states is found of loads of one frequency")
    return found, means


def middle(known: HarmonicLoads, name: str, primes: int) -> Any:
    """The mean of a coordinate in the steady state, at the working precision: where it rests, moved by K⁻¹ of the mean
    loads; of its rates 0."""
    if primes:
        return mpmath.mpf(0)
    motion, n = known.motion, len(known.loads)
    numbers = motion.values(mpmath.mp.prec)
    exact, Omega = transfer(known, name, 0)
    found, means = _loads_over_a_period(known, numbers, Omega)
    rounding = mpmath.mpf(10) ** (8 - mpmath.mp.dps) * max(map(abs, found))
    loaded = max(map(abs, means)) > rounding
    moved = mpmath.lu_solve(exact.K, mpmath.matrix(means)) if loaded else mpmath.zeros(n, 1)
    rest, = evaluate([motion.coordinate(name)], multiprecision(), {**numbers, **dict.fromkeys(
        motion.scene.coordinates, mpmath.mpf(0))})
    return rest + moved[motion.scene.coordinates.index(name)]


def feature(known: HarmonicLoads, name: str, primes: int, head: str) -> TrueValues:
    """The amplitude |X| in the steady state or the rms value √(x̄² + |X|²/2) of a coordinate, or of a rate of it."""
    def found():
        size = abs(at(*transfer(known, name, primes))[0])
        return size if head == "amplitude" else mpmath.sqrt(middle(known, name, primes) ** 2 + size**2 / 2)

    return settled(lambda: ([found()], None), DIGITS)
