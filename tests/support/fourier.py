"""Fourier coefficients of periodic forcing from its pieces, by integrals in closed form: textbook series to compare.

    f(t) ~ Σ cₙ e^{i n ω t},   cₙ = (1/P) ∫ f e^{−i n ω t} dt over one period P = 2π/ω
"""

import cmath
import math


def coefficients(forcing, channel, harmonics):
    """[c₀, c₁, …] of one channel of a periodic Forcing; an impulse of size J at t₁ adds J e^{−i n ω t₁}/P."""
    pieces = [piece for piece in forcing.pieces if piece.start >= forcing.since]
    ends = [piece.start for piece in pieces[1:]] + [forcing.since + forcing.period]
    omega = 2 * math.pi / forcing.period
    return [sum(_transformed(piece, end - piece.start, channel, n * omega)
                for piece, end in zip(pieces, ends, strict=True)) / forcing.period for n in range(harmonics + 1)]


def _transformed(piece, length, channel, angular):
    """∫ f e^{−i·angular·t} dt over a piece; Re(c τᵏ e^{sτ}) is half of that and its conjugate."""
    total = complex(sum(size for where, size in piece.impulses if where == channel))
    for where, c, k, s in piece.waves:
        if where == channel:
            total += 0.5 * (c * integral(k, s - 1j * angular, length)
                            + c.conjugate() * integral(k, s.conjugate() - 1j * angular, length))
    return total * cmath.exp(-1j * angular * piece.start)


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
