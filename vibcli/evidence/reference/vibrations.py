"""The vibrations in a linear signal from t = 0 on, y = y₀ + Re Σ a e^{λt}, Im λ > 0: free ones by the eigenvectors of
the state matrix, ẏ = A y, and one that loads of one frequency keep up; and what is read off them, as their envelope,

    E(t) = |Σ a e^{λt}|.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.frequency_response import at
from vibcli.evidence.reference.motion import Motion
from vibcli.evidence.reference.periodic import state_matrix
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.evidence.reference.steady_state import HarmonicLoads, driven, middles, response, transfer
from vibcli.symbolic.derivatives import substitute

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

DIGITS, START = 36, 60
FEW = 2                 # vibrations whose envelope is told
LOOKS = 48              # at an envelope, in a beat
Waves = Sequence[tuple[Any, Any]]


class Vibrations:
    """Of a linear signal of a small motion; drives: what keeps it up, None where nothing does."""

    def __init__(self, motion: Motion, node: "Node") -> None:
        scene = motion.scene
        still = dict.fromkeys((*scene.q, *scene.v), scene.table.zero)
        self.motion, self.node = motion, node
        loaded = any(h.mask & scene.time.mask for h in substitute(motion.parts.h, still))
        self.drives = driven(motion) if loaded else None

    def waves(self) -> Waves:
        """[(a, λ)] at the working precision, by ascending frequency; PhysicsError where something creeps."""
        kept, start = self._kept_up()
        rates, shapes = mpmath.eig(state_matrix(self.motion, mpmath.mp.prec))
        shares = mpmath.lu_solve(shapes, mpmath.matrix(start))
        slopes = response(self.drives or HarmonicLoads(self.motion, [None] * len(self.motion.scene.q), []), self.node,
                          lambda nodes: [mpmath.mpf(0)] * len(nodes)).c
        found, small = list(kept), mpmath.mpf(10) ** (-mpmath.mp.dps // 3)
        for k, rate in enumerate(rates):
            q = shapes[:len(start) // 2, k]
            size = shares[k] * sum(rate**power * sum(x * y for x, y in zip(row, q, strict=True))
                                   for power, row in enumerate(slopes))
            turns = mpmath.im(rate)
            if abs(turns) <= small * abs(rate):
                found.append((size, mpmath.re(rate)))
            elif turns > 0:
                even = abs(mpmath.re(rate)) <= small * turns
                found.append((2 * size, mpmath.mpc(0, turns) if even else rate))
        largest = max(abs(a) for a, _ in found)
        found = [(a, rate) for a, rate in found if abs(a) > small * largest]
        if any(not mpmath.im(rate) for _, rate in found):
            raise PhysicsError("no reference is found of the vibrations of what creeps")
        return sorted(found, key=lambda wave: mpmath.im(wave[1]))

    def _kept_up(self) -> tuple[list[tuple[mpmath.mpc, mpmath.mpc]], list[mpmath.mpf]]:
        """([(a, λ) of what loads keep up], [q, q̇] of what is free at t = 0)."""
        bits = mpmath.mp.prec
        start = [mpmath.ldexp(x, -bits) for x in self.motion.start(bits)]
        for instant, jumps in self.motion.blows(bits) if self.motion.blows else ():
            if instant:
                raise PhysicsError("no reference is found of vibrations that a blow changes")
            start[len(jumps):] = [x + mpmath.ldexp(j, -bits) for x, j in zip(start[len(jumps):], jumps, strict=True)]
        if self.drives is None:
            return [], start
        Omega, phasors, means = middles(self.drives)
        steady = [*(mpmath.re(X) + mean for X, mean in zip(phasors, means, strict=True)),
                  *(-Omega * mpmath.im(X) for X in phasors)]
        wave = at(*transfer(self.drives, self.node))[0], mpmath.mpc(0, Omega)
        return [wave], [x - y for x, y in zip(start, steady, strict=True)]


def read(known: Vibrations, what: Callable[[Waves], Any], least: int = 0) -> TrueValues:
    """A number of the one free vibration; about: its size, so much at least."""
    def found() -> "tuple[list[mpmath.mpf], int | mpmath.mpf]":
        waves = known.waves()
        if len(waves) > 1 or known.drives is not None:
            raise PhysicsError("a reference is found of the only vibration of a signal")
        value = what(waves)
        return [value], max(abs(value), least)

    return settled(found, DIGITS, START, sized=True)


def beat_period(known: Vibrations) -> TrueValues:
    """2π/|ω₁ − ω₂| of two vibrations."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        (_, one), (_, other) = _two(known.waves())
        period = 2 * mpmath.pi / abs(mpmath.im(one) - mpmath.im(other))
        return [period], period

    return settled(found, DIGITS, START)


def _two(waves: Sequence[tuple[Any, Any]]) -> Sequence[tuple[Any, Any]]:
    if len(waves) != FEW:
        raise PhysicsError(f"the reference finds {len(waves)} vibrations, not two")
    return waves


def envelope_at(known: Vibrations, time: Callable[[], Any], until: Any) -> TrueValues:
    """The envelope at an instant, at the working precision; about: its largest value until another one."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        waves, instant = _few(known), time()
        return [abs(_arrow(waves, instant))], max(abs(_arrow(waves, t)) for t in [*_looks(waves, until), instant])

    return settled(found, DIGITS, START, sized=True)


def envelope_extreme(known: Vibrations, until: Any, sense: int, instant: bool) -> TrueValues:
    """The largest (sense 1) or smallest value of the envelope, or the first instant at which it has it; about: the
    largest magnitude, of an instant `until`."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        waves = _few(known)
        times = [mpmath.mpf(0), *_turns(waves, until), until]
        values = [sense * abs(_arrow(waves, t)) for t in times]
        size, best = max(map(abs, values)), max(values)
        if instant:
            near = size * mpmath.mpf(10) ** (-mpmath.mp.dps // 2)
            return [next(t for t, x in zip(times, values, strict=True) if x >= best - near)], until
        return [sense * best if abs(best) > size * mpmath.mpf(10) ** (-mpmath.mp.dps // 2) else mpmath.mpf(0)], size

    return settled(found, DIGITS, START, sized=True)


def envelope_zero(known: Vibrations, until: Any, number: int) -> TrueValues:
    """The instant of a zero of the envelope, counted from 1; about: `until`."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        waves = _few(known)
        times = [mpmath.mpf(0), *_turns(waves, until), until]
        small = mpmath.mpf(10) ** (-mpmath.mp.dps // 3) * max(abs(_arrow(waves, t)) for t in times)
        near = until * mpmath.mpf(10) ** (-mpmath.mp.dps // 3)
        zeros = [t for t, before in zip(times, [-until, *times], strict=False)
                 if t > before + near and abs(_arrow(waves, t)) <= small]
        if len(zeros) < number:
            raise PhysicsError(f"the reference finds {len(zeros)} zeros")
        return [zeros[number - 1]], until

    return settled(found, DIGITS, START, sized=True)


def _few(known: Vibrations) -> Sequence[tuple[mpmath.mpc, mpmath.mpc]]:
    waves = known.waves()
    if len(waves) > FEW:
        raise PhysicsError(f"the reference finds {len(waves)} vibrations: an envelope is told of one and of two")
    return waves


def _arrow(waves: Sequence[tuple[mpmath.mpc, mpmath.mpc]], t: mpmath.mpf, order: int = 0) -> mpmath.mpc:
    """Σ a e^{λt}, or a derivative of it."""
    return mpmath.fsum(a * rate**order * mpmath.exp(rate * t) for a, rate in waves)


def _looks(waves: Sequence[tuple[mpmath.mpc, mpmath.mpc]], until: mpmath.mpf) -> list[mpmath.mpf]:
    """Instants from 0 to an end, so many in each beat."""
    apart = abs(mpmath.im(waves[0][1]) - mpmath.im(waves[-1][1]))
    count = LOOKS * (1 + int(mpmath.ceil(until * apart / (2 * mpmath.pi))))
    return [until * k / count for k in range(count + 1)]


def _turns(waves: Sequence[tuple[mpmath.mpc, mpmath.mpc]], until: mpmath.mpf) -> list[mpmath.mpf]:
    """The instants at which the envelope turns, ascending: roots of the rate of its square."""
    def slope(t: mpmath.mpf) -> mpmath.mpf:
        return mpmath.re(mpmath.conj(_arrow(waves, t)) * _arrow(waves, t, 1))

    times = _looks(waves, until)
    slopes = [slope(t) for t in times]
    return [t if not x else mpmath.findroot(slope, (t, later), solver="anderson", verify=False)
            for t, later, x, y in zip(times, times[1:], slopes, slopes[1:], strict=False) if x * y < 0 or (t and not x)]
