"""Fourier series of periodic forcing, in closed form from its pieces.

    f(t) ~ Σ cₙ e^{i n ω t},   cₙ = (1/P) ∫ f e^{−i n ω t} dt over one period P = 2π/ω

Every piece adds integrals of τᵏ e^{zτ}; an impulse of size J at t₁ adds J e^{−i n ω t₁}/P.
"""

import cmath
import math
from typing import NamedTuple


class FourierSeries(NamedTuple):
    """`coefficients[n]` = cₙ for n = 0 … N, c₋ₙ = conj cₙ; `rest`: the root mean square of what is left out beyond N,
    None where impulses make it infinite."""

    omega: float
    coefficients: tuple
    rest: float

    def amplitude(self, n):
        """Of the nth harmonic, aₙ cos nωt + bₙ sin nωt: √(aₙ² + bₙ²)."""
        return abs(self.coefficients[n]) * (2 if n else 1)


def fourier(forcing, channel, harmonics):
    """The Series of one channel of a periodic Forcing up to a number of harmonics."""
    P, omega = forcing.period, math.tau / forcing.period
    pieces = _one_period(forcing, channel)
    found = []
    for n in range(harmonics + 1):
        total = sum((_transformed(piece, n * omega) for piece in pieces), 0j) / P
        found.append(complex(total.real) if n == 0 else total)
    if any(blow for _, _, _, blow in pieces):
        return FourierSeries(omega, tuple(found), None)
    square = sum(_mean_square(waves, length) for _, length, waves, _ in pieces) / P
    kept = abs(found[0]) ** 2 + 2 * sum(abs(c) ** 2 for c in found[1:])
    return FourierSeries(omega, tuple(found), math.sqrt(max(square - kept, 0.0) + 4e-16 * square))


def _one_period(forcing, channel):
    """[(start, length, waves, impulse)] of the pieces that repeat."""
    pieces = [piece for piece in forcing.pieces if piece.start >= forcing.since]
    ends = [piece.start for piece in pieces[1:]] + [forcing.since + forcing.period]
    return [(piece.start, end - piece.start, [wave for wave in piece.waves if wave.channel == channel],
             sum(size for where, size in piece.impulses if where == channel))
            for piece, end in zip(pieces, ends, strict=True)]


def _transformed(piece, angular):
    """∫ f e^{−i·angular·t} dt over a piece; Re(c τᵏ e^{sτ}) is half of that and its conjugate."""
    start, length, waves, blow = piece
    total = complex(blow)
    for _, c, k, s in waves:
        total += 0.5 * (c * integral(k, s - 1j * angular, length)
                        + c.conjugate() * integral(k, s.conjugate() - 1j * angular, length))
    return total * cmath.exp(-1j * angular * start)


def _mean_square(waves, length):
    """∫ f² over a piece: of waves x and y, Re x·Re y = Re(x y + x ȳ)/2."""
    total = 0.0
    for _, c, k, s in waves:
        for _, d, j, r in waves:
            total += 0.5 * (c * d * integral(k + j, s + r, length)
                            + c * d.conjugate() * integral(k + j, s + r.conjugate(), length)).real
    return total


def integral(k, z, h):
    """∫₀ʰ τᵏ e^{zτ} dτ; by a series that does not cancel where |zh| ≤ k + 1, by parts elsewhere.

    hᵏ⁺¹ e^{zh} Σ (−zh)ʲ k!/(k + 1 + j)!   or   I_k = (hᵏ e^{zh} − k I_{k−1})/z
    """
    x = z * h
    if abs(x) <= k + 1:
        term, total, j = 1 / (k + 1), 0.0, 0
        while abs(term) > 1e-18 * abs(total):
            total += term
            j += 1
            term *= -x / (k + 1 + j)
        return h ** (k + 1) * cmath.exp(x) * total
    total = (cmath.exp(x) - 1) / z
    for power in range(1, k + 1):
        total = (h**power * cmath.exp(x) - power * total) / z
    return total
