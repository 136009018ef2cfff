"""The steady state under loads of one frequency, Q(t) = Re (A − iB) e^{iΩt} + constants, as a frequency response to
them all: x = Re H e^{iΩt}. Ω is the rate of the angle in their sines and cosines; A and B are read off at quarters of a
period, and hold at other instants.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.frequency_response import Transfer, at
from vibcli.evidence.reference.motion import Motion
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAMPLES = tuple(2**k for k in range(3, 11))
TRIED = ("0.137", "0.421", "0.773")     # parts of a period


class HarmonicLoads(NamedTuple):
    """A Motion with the expressions of its loads and of the rates of their angles."""

    motion: Motion
    loads: list[Any]
    rates: list[Any]


def driven(motion: Motion) -> HarmonicLoads:
    """Of a small motion whose loads are sines and cosines of one angle; PhysicsError of others."""
    scene = motion.scene
    still = dict.fromkeys((*scene.q, *scene.v), scene.table.zero)
    loads = [-node for node in substitute(motion.parts.h, still)]
    waves = [part for part in reachable(loads) if part.op == "call" and part.mask & scene.time.mask]
    rates = [gradient(part.args[0]).get(scene.time) for part in waves if part.name in ("sin", "cos")]
    if not waves or len(rates) < len(waves) or any(rate is None or rate.mask for rate in rates):
        raise PhysicsError("a reference of steady states is found of loads that are sines and cosines alone")
    return HarmonicLoads(motion, loads, rates)


def transfer(known: HarmonicLoads, node: "Node") -> tuple[Transfer, Any]:
    """(the response of a linear signal to all loads, Ω) at the working precision."""
    numbers, Omega = rate(known)
    return response(known, node, lambda nodes: _waves(known, nodes, numbers, Omega)[0]), Omega


def rate(known: HarmonicLoads) -> tuple[Any, Any]:
    """({name: number}, Ω) at the working precision; PhysicsError of several frequencies."""
    numbers = known.motion.values(mpmath.mp.prec)
    Omega, *others = (abs(x) for x in evaluate(known.rates, multiprecision(), numbers))
    if any(abs(x - Omega) > mpmath.mpf(10) ** (5 - mpmath.mp.dps) * Omega for x in others):
        raise PhysicsError("a reference of steady states is found of loads of one frequency")
    return numbers, Omega


def response(known: HarmonicLoads, node: "Node", phasors: Callable[..., Any]) -> Transfer:
    """That of a linear signal to all loads; phasors(functions of time): of their waves of a frequency."""
    motion, n = known.motion, len(known.loads)
    numbers = motion.values(mpmath.mp.prec)
    M, C, K = (mpmath.matrix([[numbers[f"{part}[{i};{j}]"] for j in range(n)] for i in range(n)]) for part in "MCK")
    zero = mpmath.zeros(n, 1)
    slopes, still = _slopes(motion.scene, node, numbers)
    return Transfer(M, C, K, [mpmath.matrix(phasors(known.loads)), zero, zero], slopes,
                    [phasors([still])[0], *[mpmath.mpf(0)] * 2])


def _slopes(scene: "Scene", node: "Node", numbers: Mapping[str, Any]) -> "tuple[list[mpmath.matrix], Node]":
    """([∂node/∂q, ∂node/∂q̇, ∂node/∂q̈], what is left of it where all of these rest)."""
    slopes, state = gradient(node), (*scene.q, *scene.v, *scene.a)
    moved = [slopes.get(symbol, scene.table.zero) for symbol in state]
    if any(node.mask & symbol.mask for node in moved for symbol in (*state, scene.time)):
        raise PhysicsError("a reference of amplitudes and phases is found of linear signals alone")
    found, n = evaluate(moved, multiprecision(), numbers), len(scene.q)
    still, = substitute([node], dict.fromkeys(state, scene.table.zero))
    return [mpmath.matrix(found[k:k + n]) for k in (0, n, 2 * n)], still


def _waves(known: HarmonicLoads, nodes: "Sequence[Node]", numbers: Mapping[str, mpmath.mpf],
           Omega: mpmath.mpf) -> tuple[list[mpmath.mpc], list[mpmath.mpf]]:
    """(the phasors of loads or other functions of time, their means)."""
    period = 2 * mpmath.pi / Omega

    def loads(part: mpmath.mpf) -> "list[mpmath.mpf]":
        return evaluate(nodes, multiprecision(), {**numbers, known.motion.scene.time.name: part * period})

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


def middles(known: HarmonicLoads) -> tuple[Any, Any, Any]:
    """(Ω, phasors, means) of the coordinates: where they rest, moved by K⁻¹ of the mean loads."""
    scene, n = known.motion.scene, len(known.loads)
    numbers = known.motion.values(mpmath.mp.prec)
    exact, Omega = transfer(known, scene.table.zero)
    found, means = _waves(known, known.loads, numbers, Omega)
    rounding = mpmath.mpf(10) ** (8 - mpmath.mp.dps) * max(map(abs, found))
    loaded = max(map(abs, means)) > rounding
    moved = mpmath.lu_solve(exact.K, mpmath.matrix(means)) if loaded else mpmath.zeros(n, 1)
    s = mpmath.mpc(0, Omega)
    return Omega, mpmath.lu_solve(exact.K + s * (exact.C + s * exact.M), exact.b[0]), moved


def _along(known: HarmonicLoads, node: "Node", t: mpmath.mpf, Omega: mpmath.mpf, phasors: mpmath.matrix,
           means: mpmath.matrix) -> mpmath.mpf:
    """A signal at an instant of the steady state."""
    scene, wave = known.motion.scene, mpmath.expj(Omega * t)
    numbers = {**known.motion.values(mpmath.mp.prec), scene.time.name: t}
    for primes in range(3):
        turned = mpmath.mpc(0, Omega) ** primes * wave
        numbers |= {name + "'" * primes: mpmath.re(X * turned) + (0 if primes else mean)
                    for name, X, mean in zip(scene.coordinates, phasors, means, strict=True)}
    return evaluate([node], multiprecision(), numbers)[0]


def _over_a_period(known: HarmonicLoads, node: "Node", head: str) -> tuple[mpmath.mpf, mpmath.mpf]:
    """(the mean or rms value of a signal, its largest magnitude), by more and more samples until two of their numbers
    give the same: of powers of waves a few are all that it takes."""
    steady, before = middles(known), None
    period, small = 2 * mpmath.pi / steady[0], mpmath.mpf(10) ** (8 - mpmath.mp.dps)
    for count in SAMPLES:
        values = [_along(known, node, period * k / count, *steady) for k in range(count)]
        size = max(map(abs, values))
        found = sum(x if head == "mean" else x * x for x in values) / count
        if before is not None and abs(found - before) <= small * max(size, size**2 if head == "rms" else 0):
            found = found if head == "mean" else mpmath.sqrt(found)
            return (found if abs(found) > small * size else mpmath.mpf(0)), size
        before = found
    raise PhysicsError("no reference is found of the mean of a signal that bends")


def at_the_start(known: HarmonicLoads) -> tuple[float, list[float], list[float]]:
    """(2π/Ω, [q, q̇] of the steady state at t = 0, counted from rest, the largest values of each)."""
    Omega, phasors, means = middles(known)
    start = [*(mpmath.re(X) + mean for X, mean in zip(phasors, means, strict=True)),
             *(-Omega * mpmath.im(X) for X in phasors)]
    sizes = [*(abs(X) + abs(mean) for X, mean in zip(phasors, means, strict=True)), *(Omega * abs(X) for X in phasors)]
    least = sum(sizes) * mpmath.mpf(2) ** -52
    return float(2 * mpmath.pi / Omega), list(map(float, start)), [float(max(size, least)) for size in sizes]


def over_a_period(known: HarmonicLoads, node: "Node", head: str) -> TrueValues:
    """The mean or rms value of a signal, a power or product perhaps; about: its largest magnitude."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        number, size = _over_a_period(known, node, head)
        return [number], size

    return settled(found, DIGITS, sized=True)


def of_wave(known: HarmonicLoads, node: "Node", head: str) -> TrueValues:
    """The amplitude |X| of a linear signal in the steady state, or the lag θ of X sin(Ωt − θ), −π < θ ≤ π."""
    def found() -> "tuple[list[mpmath.mpf], None]":
        X = at(*transfer(known, node))[0]
        lag = -mpmath.arg(mpmath.mpc(0, 1) * X)
        return [abs(X) if head == "amplitude" else
                lag if abs(lag) < mpmath.pi * (1 - mpmath.mpf(10) ** (8 - mpmath.mp.dps)) else +mpmath.pi], None

    return settled(found, DIGITS)
