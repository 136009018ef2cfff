"""The steady state and the transient of a motion in more digits.

After its last breakpoint a force Re(F e^{iΩτ}) keeps up q = Re((K + iΩ C − Ω² M)⁻¹ F e^{iΩτ}); under periodic forcing
the state at the start of a period is that which a period repeats, (1 − Φ) y = what the period brings from rest.
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from mpmath import mp

from vibcli.analyses.excitation.forcing import Forcing
from vibcli.analyses.transient.descriptor_system import real
from vibcli.analyses.transient.high_precision import PreciseMotion
from vibcli.analyses.transient.time_shift import turned
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.excitation.linear_output import LinearOutput


def steady_motion(motion: "PreciseMotion | SteadyWaves | TransientMotion") -> "PreciseMotion | SteadyWaves":
    """What is reached, continued back to t = 0. It is asked for of motions that have a steady state alone."""
    if isinstance(motion, SteadyWaves):
        return motion
    if isinstance(motion, TransientMotion):
        raise PhysicsError("more digits of what lasts of a transient are not found", "it dies out: leave --digits out")
    return SteadyWaves(motion) if motion.forcing.period is None else _repeating(motion)


def _repeating(motion: PreciseMotion) -> PreciseMotion:
    forcing = Forcing(motion.forcing.channels, turned(motion.forcing), motion.forcing.period)
    rests, system, size = _rests(motion), motion.system, len(motion.start)
    summed, bits, period = motion.summing([rest.mean for rest in rests]), mp.prec, motion.forcing.period
    beside = [[rest.damping[i] for i in system.places] + [rest.momentum[i] for i in system.heavy] for rest in rests]

    def after(start: "list[mpmath.mpf]") -> "list[mpmath.mpf]":
        """What a period adds, and what of it is to vanish in the mean."""
        end = summed.under(forcing, start + [mp.mpf(0)] * len(rests)).at(period, bits, before=True).z
        return [y - x + mp.fdot([column[i] for column in beside], end[size:size + len(rests)])
                for i, (x, y) in enumerate(zip(start, end[:size], strict=True))]

    brought = after([mp.mpf(0)] * size)
    columns = [[y - x for x, y in zip(brought, after([mp.mpf(int(i == j)) for i in range(size)]), strict=True)]
               for j in range(size)]
    return motion.under(forcing, list(_solved(mp.matrix(columns).T, [-x for x in brought])))


class Rest(NamedTuple):
    """A rest l, lᵀK = 0, that nothing holds; damping: lᵀC, momentum: lᵀM; mean: the row of q whose mean is taken as 0,
    the damping, or the momentum where no damper resists."""

    left: "list[mpmath.mpf]"
    damping: "list[mpmath.mpf]"
    momentum: "list[mpmath.mpf]"
    mean: "list[mpmath.mpf]"


def _rests(motion: PreciseMotion) -> list[Rest]:
    M, C, K = (mp.matrix([[real(x) for x in row] for row in matrix]) for matrix in motion.matrices)
    left, _ = _left_nulls(K, mp.mnorm(K))
    if not left.cols:
        return []
    found = []
    for turn, resisted in zip(_left_nulls(left.T * C * left, mp.mnorm(C)), (False, True), strict=True):
        for one in (left * turn).T.tolist() if turn.cols else ():
            damping, momentum = (list(mp.matrix([one]) * matrix) for matrix in (C, M))
            found.append(Rest(one, damping, momentum, damping if resisted else momentum))
    return found


def _left_nulls(matrix: "mpmath.matrix", size: "mpmath.mpf") -> "tuple[mpmath.matrix, mpmath.matrix]":
    """(left null vectors of a square matrix of sums of such a size, those orthogonal to them), columns."""
    U, sizes, _ = mp.svd_r(matrix)
    columns: tuple[list[list[Any]], list[list[Any]]] = [], []
    for i, length in enumerate(sizes):
        columns[length > size * mp.sqrt(mp.eps)].append(list(U[:, i]))
    rests, others = (mp.matrix(some).T if some else mp.matrix(len(U), 0) for some in columns)
    return rests, others


def _solved(matrix: "mpmath.matrix", right: "list[mpmath.mpc]") -> "mpmath.matrix":
    try:
        return mp.lu_solve(matrix, mp.matrix(right))
    except (ZeroDivisionError, TypeError):      # TypeError: mpmath's, of a column of zeros
        raise PhysicsError("a steady state beside which something vibrates freely at a frequency of the load is not "
                           "found in more digits", "leave --digits out") from None


class SteadyWaves:
    """waves: [(s, Q, F)] of Re(Q e^{sτ}) and of the forces Re(F e^{sτ}) that keep it up, τ counted from `since`."""

    def __init__(self, motion: PreciseMotion) -> None:
        last = motion.forcing.segments(math.inf)[-1]
        self.since, forces = real(last.start), {}
        for wave in last.waves:
            if not wave.exponent.real:
                if wave.power:
                    raise PhysicsError("more digits of a steady state that grows are not found", "leave --digits out")
                s, c = mp.mpc(0, wave.exponent.imag), mp.mpc(wave.coefficient)
                s, c = (s.conjugate(), c.conjugate()) if s.imag < 0 else (s, c)
                row = forces.setdefault(s.imag, np.zeros(motion.forcing.channels, object))
                row[wave.channel] += c if s.imag else c.real
        self.waves = [(mp.mpc(0, speed), kept_up(motion, mp.mpc(0, speed), row), row)
                      for speed, row in sorted(forces.items())]

    def breaks(self, until: float) -> "list[mpmath.mpf]":
        """None."""
        return []

    def at(self, time: "mpmath.mpf", bits: int, before: bool = False) -> "WavesAt":
        """The WavesAt a time; they do not jump."""
        return WavesAt(self.waves, real(time) - self.since)

    def phasors(self, output: "LinearOutput") -> "list[tuple[mpmath.mpf, mpmath.mpc]]":
        """[(Ω, X)] with Re Σ X e^{iΩt} the output but for its constant, Ω ascending."""
        return [(s.imag, amplitude(output, s, Q, F) * mp.expj(-s.imag * self.since)) for s, Q, F in self.waves]


def kept_up(motion: PreciseMotion, s: "mpmath.mpc", forces: Any) -> "list[mpmath.mpc]":
    """Q of q = Re(Q e^{st}) under the forces Re(F e^{st}) on the coordinates."""
    n, (M, C, K) = motion.n, motion.matrices
    if not any(forces[:n]):
        return [mp.mpf(0)] * n
    dynamic = mp.matrix([[(real(M[i][j]) * s + real(C[i][j])) * s + real(K[i][j]) for j in range(n)] for i in range(n)])
    for rest in [] if s else _rests(motion):
        pushed = [left * force for left, force in zip(rest.left, forces[:n], strict=True)]
        if abs(mp.fsum(pushed)) > mp.sqrt(mp.eps) * mp.fsum(map(abs, pushed)):
            raise PhysicsError("more digits of what a steady force drives off are not found", "leave --digits out")
        dynamic += mp.matrix(rest.left) * mp.matrix([rest.mean])
    return list(_solved(dynamic, [mp.mpmathify(x) for x in forces[:n]]))


def harmonic(motion: PreciseMotion, output: "LinearOutput", n: int) -> "mpmath.mpc":
    """X of the n-th harmonic Re(X e^{inωt}) of an output of the motion that periodic forcing repeats, of its force
    F = (2/T) ∫ f e^{−st} dt over a period, s = inω; for n = 0 the mean."""
    pieces, period = motion.forcing.pieces, real(motion.forcing.period)
    s = mp.mpc(0, 2 * mp.pi * n / period)
    F = np.zeros(motion.forcing.channels, object)
    for piece, end in zip(pieces, [*(real(after.start) for after in pieces[1:]), period], strict=True):
        start = real(piece.start)
        for channel, size in piece.impulses:
            F[channel] += 2 * real(size) * mp.exp(-s * start)
        for wave in piece.waves:
            c, rate = mp.mpc(wave.coefficient), mp.mpc(wave.exponent)
            both = (c * _integral(rate - s, wave.power, end - start)
                    + mp.conj(c) * _integral(mp.conj(rate) - s, wave.power, end - start))
            F[wave.channel] += both * mp.exp(-s * start)
    F = F / (period * (1 if n else 2))
    return amplitude(output, s, kept_up(motion, s, F), F) + (real(output.constant) if not n else 0)


def _integral(rate: "mpmath.mpc", power: int, length: "mpmath.mpf") -> "mpmath.mpc":
    """∫ τᵏ e^{rate τ} dτ from 0 to a length."""
    if not rate:
        return length ** (power + 1) / (power + 1)
    grown, found = mp.exp(rate * length), mp.mpf(0)
    for k in range(power + 1):
        found = ((grown - 1) if not k else length**k * grown - k * found) / rate
    return found


def amplitude(output: "LinearOutput", s: "mpmath.mpc", Q: Any, F: Any) -> "mpmath.mpc":
    """The complex amplitude of an output of q = Re(Q e^{st}) under the forces Re(F e^{st}), without its constant."""
    parts = ((output.q, 1), (output.v, s), (output.a, s * s))
    return mp.fsum([real(x) * factor * Q[i] for rows, factor in parts for i, x in rows.items()]
                   + [real(x) * F[channel] for channel, x in output.channels.items()])


class WavesAt:
    """SteadyWaves at an instant, read like a PreciseState."""

    def __init__(self, waves: Any, tau: "mpmath.mpf") -> None:
        self.waves, self.tau = waves, tau

    def later(self, by: "mpmath.mpf") -> "WavesAt":
        """The same a little later."""
        return WavesAt(self.waves, self.tau + by)

    def read(self, output: "LinearOutput", order: int = 0) -> "mpmath.mpf":
        """The order-th derivative of an output."""
        terms = [amplitude(output, s, Q, F) * s**order * mp.exp(s * self.tau) for s, Q, F in self.waves]
        return mp.re(mp.fsum(terms)) + (real(output.constant) if not order else 0)


class TransientMotion:
    """A motion less its steady state."""

    def __init__(self, motion: PreciseMotion | SteadyWaves) -> None:
        self.whole, self.steady = motion, steady_motion(motion)

    def breaks(self, until: float) -> "list[mpmath.mpf]":
        """The instants up to a time at which the loads of either bend or jump."""
        return [*self.whole.breaks(until), *self.steady.breaks(until)]

    def at(self, time: "mpmath.mpf", bits: int, before: bool = False) -> "DifferenceAt":
        """The DifferenceAt a time, as of PreciseMotion."""
        return DifferenceAt(self.whole.at(time, bits, before), self.steady.at(time, bits, before))


class DifferenceAt:
    """The difference of two motions at an instant, read like a PreciseState."""

    def __init__(self, whole: Any, steady: Any) -> None:
        self.whole, self.steady = whole, steady

    def later(self, by: "mpmath.mpf") -> "DifferenceAt":
        """The same a little later."""
        return DifferenceAt(self.whole.later(by), self.steady.later(by))

    def read(self, output: "LinearOutput", order: int = 0) -> "mpmath.mpf":
        """The order-th derivative of an output."""
        return self.whole.read(output, order) - self.steady.read(output, order)
