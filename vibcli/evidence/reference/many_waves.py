"""Means under loads of several frequencies that have no common period: of a signal as a function of the angles of their
waves, each of which runs through all values beside all of the others (Weyl 1916),

    lim (1/T) ∫ x dt = (2π)⁻ᵐ ∫ x(θ₁ … θₘ) dθ,     q = K⁻¹ Q₀ + Σ Re (K + iΩC − Ω²M)⁻¹ Q e^{iΩt},

by more and more samples of each angle until two of their numbers give the same.
"""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.motion import Motion
from vibcli.evidence.reference.periodic import state_matrix
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.evidence.reference.waves import WavesInTime, in_frequencies, waves
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:

    from vibcli.symbolic.node import Node

SAMPLES = (6, 9, 14, 21, 32)        # of each angle
MOST = 2500             # samples of all angles
TIMES, RELATED = 20, 1000       # a frequency in another one, and the numbers of a relation between several


class ManyWaves(NamedTuple):
    """A Motion, its loads and the signal in WavesInTime."""

    motion: Motion
    waves: WavesInTime


def steady_waves(motion: Motion, node: "Node") -> ManyWaves:
    """Of a small motion that neither blows nor free vibrations move without end."""
    scene = motion.scene
    if motion.blows:
        raise PhysicsError("no reference is found of steady states under blows")
    loads = substitute(motion.parts.h, dict.fromkeys((*scene.q, *scene.v), scene.table.zero))
    return ManyWaves(motion, waves([*(-load for load in loads), node], scene))


def over_all_times(known: ManyWaves, head: str) -> TrueValues:
    """The mean or rms value of the signal; about: its largest magnitude."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        number, size = _mean(known, 2 if head == "rms" else 1)
        return [mpmath.sqrt(number) if head == "rms" else number], size

    return settled(found, DIGITS, sized=True)


def at_the_start(known: ManyWaves) -> tuple[float, list[float], list[float]]:
    """(the period of the slowest wave, [q, q̇] at t = 0, the largest values of each)."""
    motion, loads = known.motion, known.waves._replace(nodes=known.waves.nodes[:-1])
    numbers = {**motion.values(mpmath.mp.prec), motion.scene.time.name: mpmath.mpf(0)}
    middle, moved = _moved(motion, *in_frequencies(loads, numbers))
    rows = [[(0 if primes else middle[i], [X[i] * mpmath.mpc(0, Omega) ** primes for Omega, X in moved])
             for i in range(len(middle))] for primes in range(2)]
    start = [mean + mpmath.fsum(map(mpmath.re, waves)) for row in rows for mean, waves in row]
    sizes = [float(abs(mean) + mpmath.fsum(map(abs, waves))) for row in rows for mean, waves in row]
    least = sum(sizes) * 2.0**-52
    return (float(2 * mpmath.pi / min(Omega for Omega, _ in moved)), list(map(float, start)),
            [max(size, least) for size in sizes])


def _mean(known: ManyWaves, power: int) -> tuple[mpmath.mpf, mpmath.mpf]:
    """(the mean of a power of the signal, its largest magnitude)."""
    motion, (node, found) = known.motion, (known.waves.nodes[-1], known.waves._replace(nodes=known.waves.nodes[:-1]))
    numbers = {**motion.values(mpmath.mp.prec), motion.scene.time.name: mpmath.mpf(0)}
    middle, moved = _moved(motion, *in_frequencies(found, numbers))
    seen = found.phasors(numbers)
    bases, times = _independent([Omega for Omega, _ in (*moved, *seen) if Omega])
    small, before = mpmath.mpf(10) ** (8 - mpmath.mp.dps), None
    for count in SAMPLES:
        if count ** len(bases) > MOST:
            break
        values = [_at(known, node, numbers, (middle, moved, seen), times, [mpmath.mpf(k) / count for k in turns])
                  for turns in product(range(count), repeat=len(bases))]
        size = max(map(abs, values))
        mean = mpmath.fsum(x**power for x in values) / len(values)
        if before is not None and abs(mean - before) <= small * size**power:
            return (mean if abs(mean) > small * size**power else mpmath.mpf(0)), size
        before = mean
    raise PhysicsError("no reference is found of the mean of a signal that bends, or has very many waves")


def _moved(motion: Motion, still: list[mpmath.mpf],
           loads: Sequence[tuple[Any, list[Any]]]) -> tuple[mpmath.matrix, list[tuple[mpmath.mpf, mpmath.matrix]]]:
    """(where loads hold the coordinates in the mean, [(Ω, phasors of the coordinates)])."""
    n = len(motion.scene.q)
    numbers = motion.values(mpmath.mp.prec)
    M, C, K = (mpmath.matrix([[numbers[f"{part}[{i};{j}]"] for j in range(n)] for i in range(n)]) for part in "MCK")
    growing = max(mpmath.re(x) for x in mpmath.eig(state_matrix(motion, mpmath.mp.prec), left=False, right=False))
    if growing >= -mpmath.mpf(10) ** (8 - mpmath.mp.dps // 2):
        raise PhysicsError("this motion never settles: no reference is found of its steady state")
    middle = mpmath.lu_solve(K, mpmath.matrix(still)) if any(still) else mpmath.zeros(n, 1)
    return middle, [(Omega, mpmath.lu_solve(K + mpmath.mpc(0, Omega) * C - Omega**2 * M, mpmath.matrix(Q)))
                    for Omega, Q in loads]


def _at(known: ManyWaves, node: "Node", numbers: Mapping[str, mpmath.mpf],
        parts: tuple[mpmath.matrix, list[tuple[mpmath.mpf, mpmath.matrix]], list[tuple[mpmath.mpf, mpmath.mpc]]],
        times: Any, turns: Sequence[mpmath.mpf]) -> mpmath.mpf:
    """The signal where the angles of the independent waves have turned so far."""
    scene, (middle, moved, seen) = known.motion.scene, parts
    angle = [mpmath.expjpi(2 * sum(n * turn for n, turn in zip(one, turns, strict=True))) for one in times]
    values = {**numbers}
    for (_, P), name, wave in zip([one for one in seen if one[0]], [letter for letter, one in zip(
            known.waves.letters, seen, strict=True) if one[0]], angle[len(moved):], strict=True):
        values[name] = mpmath.re(P * wave)
    values |= {letter: mpmath.re(P) for letter, (Omega, P) in zip(known.waves.letters, seen, strict=True) if not Omega}
    for primes in range(3):
        for i, name in enumerate(scene.coordinates):
            values[name + "'" * primes] = (0 if primes else middle[i]) + mpmath.fsum(
                mpmath.re(X[i] * mpmath.mpc(0, Omega) ** primes * wave)
                for (Omega, X), wave in zip(moved, angle, strict=False))
    return evaluate([node], multiprecision(), values)[0]


def _independent(every: Sequence[mpmath.mpf]) -> tuple[list[mpmath.mpf], list[tuple[int, ...]]]:
    """(frequencies of which each of all is a whole multiple of one, {multiples of them} of each); PhysicsError where
    other relations of whole numbers hold between these."""
    bases: list[Any] = []
    for Omega in every:
        for k, base in enumerate(bases):
            if shares := _shares(Omega / base):
                bases[k] = base / shares[1]
                break
        else:
            bases.append(Omega)
    if len(bases) > 1 and mpmath.pslq(bases, maxcoeff=RELATED, maxsteps=10**5):
        raise PhysicsError("no reference is found of loads whose frequencies are sums of each other")
    return bases, [tuple(int(mpmath.nint(Omega / base)) if _shares(Omega / base) else 0 for base in bases)
                   for Omega in every]


def _shares(ratio: mpmath.mpf) -> tuple[int, int] | None:
    """(p, q) of a ratio p/q of small whole numbers, else None."""
    for q in range(1, TIMES + 1):
        p = mpmath.nint(q * ratio)
        if p and abs(q * ratio - p) <= mpmath.mpf(10) ** (10 - mpmath.mp.dps) * p:
            return int(p), q
    return None
