"""An output of a linear motion to any number of digits, by another way than the floats go.

The state and the waves that drive it form one autonomous system ż = G z, and z at the end of a stretch is e^{Gτ} z at
its start: Taylor's series of e^{Gτ/2ᵐ}, squared m times, in fixed-point numbers. It is computed with ever more bits
until two results agree.
"""

import math
from collections.abc import Sequence
from itertools import count
from typing import TYPE_CHECKING, cast

import numpy as np
from mpmath import mp

from vibcli.analyses.transient.descriptor_system import Descriptor, SummingSystem, real
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics import fixed_point as fx

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
    from vibcli.analyses.excitation.linear_output import LinearOutput

    Matrix = Sequence[list[float | mpmath.mpf]]

GUARD, MORE, TRIES = 64, 96, 12
NOTHING = 4096      # bits to which what is zero is looked at: it may have died out
SMALL = 8           # binary orders below 1 of what a series is of
EPSILON = 2.0**-50
ALIKE, KEPT = 2**20, 16     # rounding of a length of time between jumps; exponentials that are kept


def precise_value(M: "Matrix", C: "Matrix",
                  K: "Matrix", forcing: "Forcing",
                  q0: "Sequence[float | mpmath.mpf] | np.ndarray", v0: "Sequence[float | mpmath.mpf] | np.ndarray",
                  output: "LinearOutput", time: "float | Fraction | mpmath.mpf", digits: int,
                  order: int = 0) -> "mpmath.mpf":
    """The order-th derivative of an output at a time as mpmath.mpf, see precise_values."""
    return precise_values(M, C, K, forcing, q0, v0, [output], time, digits, order)[0]


def precise_values(M: "Matrix", C: "Matrix",
                   K: "Matrix", forcing: "Forcing",
                   q0: "Sequence[float | mpmath.mpf] | np.ndarray", v0: "Sequence[float | mpmath.mpf] | np.ndarray",
                   outputs: "Sequence[LinearOutput]", time: "float | Fraction | mpmath.mpf", digits: int,
                   order: int = 0) -> "list[mpmath.mpf]":
    """The order-th derivative of each output at a time, just after what jumps there, correct to `digits`.

    M, C, K: nested lists of numbers, as q0, v0 and those of the forcing and the outputs: float, Fraction, mpf or mpc.
    """
    bits, before = math.ceil(digits * math.log2(10)) + GUARD, None
    for _ in range(TRIES):
        with mp.workprec(bits + GUARD):
            state = precise_motion(M, C, K, forcing, q0, v0).at(time, bits)
            found = [state.read(output, order) for output in outputs]
            small = mp.mpf(10) ** (-digits - 1)
            if before is not None and all(abs(x - y) <= abs(x) * small for x, y in zip(found, before, strict=True)):
                break
        before, bits = found, max(bits + max(MORE, bits // 3), 0 if all(found) else NOTHING)
    return found


def precise_motion(M: "Matrix", C: "Matrix",
                   K: "Matrix", forcing: "Forcing",
                   q0: "Sequence[float | mpmath.mpf] | np.ndarray",
                   v0: "Sequence[float | mpmath.mpf] | np.ndarray") -> "PreciseMotion":
    """The PreciseMotion of M q̈ + C q̇ + K q = f(t) from q(0) = q0, q̇(0) = v0, as of precise_values."""
    system = Descriptor(M, C, K)
    start = [real(q0[i]) for i in system.places] + [real(v0[i]) for i in system.heavy]
    return PreciseMotion((M, C, K), system, forcing, start)


class PreciseMotion:
    """A motion at the working precision of mpmath; start: the state of its system of first order at t = 0; reached:
    those at the starts of the stretches of its loads, as far as they were looked at."""

    def __init__(self, matrices: "tuple[Matrix, Matrix, Matrix]",
                 system: Descriptor | SummingSystem, forcing: "Forcing", start: "list[mpmath.mpf]") -> None:
        self.matrices, self.system, self.forcing, self.start = matrices, system, forcing, start
        self.n, self.reached, self.found, self.exponentials = len(matrices[0]), [start], {}, []

    def under(self, forcing: "Forcing", start: "list[mpmath.mpf]") -> "PreciseMotion":
        """The same system driven and started otherwise."""
        return PreciseMotion(self.matrices, self.system, forcing, start)

    def summing(self, rows: "list[list[mpmath.mpf]]") -> "PreciseMotion":
        """The same with states ∫ r q dt at its end, r rows over the coordinates."""
        return PreciseMotion(self.matrices, SummingSystem(self.system, rows), self.forcing,
                             self.start + [mp.mpf(0)] * len(rows))

    def breaks(self, until: float) -> "list[mpmath.mpf]":
        """The instants up to a time at which the loads bend or jump."""
        return [real(piece.start) for piece in self.forcing.segments(until * (1 + EPSILON))]

    def at(self, time: "float | Fraction | mpmath.mpf", bits: int, before: bool = False) -> "PreciseState":
        """The PreciseState at a time, just after what jumps there, or just before it."""
        time = real(time)
        if (time, before) not in self.found:
            self.found = {(time, before): self._at(time, bits, before)}
        return cast("PreciseState", self.found[time, before])

    def _at(self, time: "mpmath.mpf", bits: int, before: bool) -> "PreciseState":
        pieces = self.forcing.segments(math.nextafter(float(time), math.inf))
        starts = [real(piece.start) for piece in pieces]
        last = max(k for k, start in enumerate(starts) if not k or start < time or (start == time and not before))
        for k in range(len(self.reached) - 1, last):
            *_, z = self._along(pieces[k], starts[k + 1] - starts[k], self.reached[k], bits)
            self.reached.append(list(z[:len(self.start)]))
        return PreciseState(*self._along(pieces[last], time - starts[last], self.reached[last], bits))

    def _along(self, piece: "Segment", length: "mpmath.mpf", state: "list[mpmath.mpf]",
               bits: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """G, rows of the forces, rows of q, and z a length of time after the start of a piece."""
        state = list(state)
        for channel, size in piece.impulses:
            for i in range(len(state) if channel < self.n else 0):
                state[i] += self.system.B[i, channel] * real(size)
        G, z, forces, Q = _generator(self.system, piece.waves, state, self.forcing.channels, self.n)
        return G, forces, Q, _times(self._exponential(G, len(state), piece.waves, length, bits), z) if length else z

    def _exponential(self, G: np.ndarray, first: int, waves: "tuple[Wave, ...]", length: "mpmath.mpf",
                     bits: int) -> tuple[np.ndarray, int]:
        """e^{Gτ} as of _exponential, known already where an equal stretch has been passed."""
        for known, tau, found in self.exponentials:
            if known is waves and abs(length - tau) <= tau * mp.eps * ALIKE:
                return cast("tuple[np.ndarray, int]", found)
        found = _exponential(G, first, length, bits)
        self.exponentials = [*self.exponentials[-KEPT:], (waves, length, found)]
        return found


class PreciseState(NamedTuple):
    """ż = G z, f = forces z, q = Q z at an instant."""

    G: np.ndarray
    forces: np.ndarray
    Q: np.ndarray
    z: np.ndarray

    def later(self, by: "mpmath.mpf") -> "PreciseState":
        """The state a little later, by Taylor's series: nothing may bend or jump on the way."""
        total = term = self.z
        k = 0
        while any(abs(x) > mp.eps * abs(y) for x, y in zip(term, total, strict=True)) and k < mp.prec:
            k += 1
            term = self.G.dot(term) * by / k
            total = total + term
        return self._replace(z=total)

    def read(self, output: "LinearOutput", order: int = 0) -> "mpmath.mpf":
        """The order-th derivative of an output: those of z are G z, G² z …"""
        row = np.zeros(len(self.z), object)
        for parts in (output.a, output.v, output.q):        # (a G + v) G + q
            row = row.dot(self.G) if row.any() else row
            for i, x in parts.items():
                row = row + self.Q[i] * real(x)
        for channel, x in output.channels.items():
            row = row + self.forces[channel] * real(x)
        for _ in range(order):
            row = row.dot(self.G)
        return real(row.dot(self.z)) + (real(output.constant) if not order else 0)


def _generator(system: Descriptor | SummingSystem, waves: "tuple[Wave, ...]", state: "list[mpmath.mpf]", channels: int,
               n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """(G, z, rows of the forces, rows of q): z = (y, parts of the waves), f = forces z, q = Q z."""
    first = len(state)
    size = first + sum(2 * (wave.power + 1) for wave in waves)
    G, forces, z, at = np.zeros((size, size), object), np.zeros((channels, size), object), np.zeros(size, object), first
    z[:first] = state
    for channel, coefficient, power, exponent in waves:
        s, c = mp.mpc(exponent), mp.mpc(coefficient) * mp.factorial(power)
        z[at] = mp.one
        for k in range(power + 1):
            re, im = at + 2 * k, at + 2 * k + 1
            G[re, re], G[re, im], G[im, re], G[im, im] = s.real, -s.imag, s.imag, s.real
            if k:
                G[re, re - 2] = G[im, im - 2] = mp.one
        forces[channel, re] += c.real
        forces[channel, im] -= c.imag
        at = im + 1
    loads = forces[:n, first:]
    G[:first] = np.concatenate([system.A, system.B.dot(loads)], axis=1)
    return G, z, forces, np.concatenate([system.Q, system.F.dot(loads)], axis=1)


def _exponential(G: np.ndarray, first: int, tau: "mpmath.mpf", bits: int) -> tuple[np.ndarray, int]:
    """(e^{Gτ} in fixed point, its bits): Taylor's series in powers of a power of G, Paterson and Stockmeyer."""
    size = len(G)
    norm = np.abs(G).sum(axis=1).max(initial=0) * abs(tau)
    halvings = max(0, int(mp.ceil(mp.log(norm, 2))) + SMALL) if norm else 0
    wide = bits + 2 * halvings + GUARD
    step = np.array([fx.fixed(x, wide - halvings) for x in (G * tau).flat], object).reshape(G.shape)
    last = next(k for k in count(1) if SMALL * k + math.lgamma(k + 1) / math.log(2) > wide)
    powers, together = [fx.identity(size, wide), step], math.isqrt(last) + 1
    while len(powers) <= together:
        powers.append(_product(powers[-1], step, first, wide))
    total = np.zeros_like(step)
    for k in reversed(range(0, last + 1, together)):
        total = _product(total, powers[-1], first, wide) + sum(
            power // math.factorial(k + i) for i, power in enumerate(powers[:-1]))
    for _ in range(halvings):
        total = _product(total, total, first, wide)
    return total, wide


def _product(a: np.ndarray, b: np.ndarray, first: int, bits: int) -> np.ndarray:
    """a b of what drives the first coordinates and does not feel them."""
    found = np.zeros_like(a)
    found[:first, :first] = fx.product(a[:first, :first], b[:first, :first], bits)
    found[:first, first:] = fx.product(a[:first], b[:, first:], bits)
    found[first:, first:] = fx.product(a[first:, first:], b[first:, first:], bits)
    return found


def _times(exponential: tuple[np.ndarray, int], z: np.ndarray) -> np.ndarray:
    """e^{Gτ} z."""
    total, wide = exponential
    return np.array([mp.fsum(mp.ldexp(mp.mpf(int(x)), -wide) * y for x, y in zip(row, z, strict=True))
                     for row in total], object)
