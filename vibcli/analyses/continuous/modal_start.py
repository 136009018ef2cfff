"""What a motion starts with, in modes: η = Σ φᵀ M q + Σ ∫ μ φ u dx.

Of a shape that springs and pieces at rest take under forces r it is φᵀ r/ω² (Betti). Of a field u = c xᵏ e^{λx} on a
piece, with w = ∂ᵏ/∂λᵏ [e^{λx}/P(λ)], P = B λ⁴ − N λ² + κ, so that B w⁗ − N w″ + κ w = u, by Green's identity

    ∫ φ u dx = [B (φ w‴ − φ′ w″ + φ″ w′ − φ‴ w) − N (φ w′ − φ′ w)]
"""

from math import comb, factorial
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.load_forms import load_form
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.integrals import product_integral
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.numerics.pieces.loads import LoadForm

FAR = 50.0          # times what else is in P: κ
BLOCK = 64          # modes whose integrals are taken at a time


def of_field(basis: "ModeBasis", piece: int, given: "Forcing", channel: int) -> np.ndarray:
    """μ ∫ φ u dx of each mode over a piece, u being a channel of a Forcing over x."""
    whole = basis.placed[piece].piece
    return whole.inertia * of_load(basis, piece, load_form(given, channel, whole.length))


def of_drive(basis: "ModeBasis", drive: "SpreadDrive") -> np.ndarray:
    """∫ φ f dx of each mode over a member."""
    found = np.zeros(basis.shapes.shape[1], basis.shapes.dtype)
    for number, placed in enumerate(basis.placed):
        form = drive.on(placed)
        if form is not None:
            found += of_load(basis, number, form)
    return found


def of_load(basis: "ModeBasis", piece: int, form: "LoadForm") -> np.ndarray:
    """∫ φ f dx of each mode over a piece."""
    found = np.zeros(basis.shapes.shape[1], basis.shapes.dtype)
    for part in basis.parts[piece]:
        for one in form.stretches:
            a, b = max(one.start, part.start), min(one.end, part.start + part.piece.length)
            if b > a and one.terms:
                found[part.modes] += _integrals(part, one.origin, one.terms, a, b)
    return found


def of_shape(basis: "ModeBasis", piece: int, ends: np.ndarray) -> np.ndarray:
    """μ ∫ φ u dx of each mode over a piece at rest with these end values."""
    whole = basis.placed[piece].piece
    found = np.zeros(basis.shapes.shape[1], basis.shapes.dtype)
    if not np.any(ends):
        return found
    rest, half = whole.foundation, whole.order // 2
    for part in basis.parts[piece]:
        one = part.piece
        left, right = fields(whole, rest, ends, np.array([part.start, min(part.start + one.length, whole.length)]))
        own = np.concatenate([left[:half], right[:half]])
        force = stiffness(one, np.float64(rest)) @ own
        gap, stiff = part.kappa - rest, np.abs(force).max() / np.abs(own).max() / one.length
        far = np.abs(gap) > stiff
        with np.errstate(all="ignore"):
            values = (part.forces() @ own - part.ends @ force) / gap
        found[part.modes] += np.where(far, values, 0.0)
        for k in np.flatnonzero(~far):
            found[part.modes[k]] += product_integral(one, part.kappa[k], part.ends[k], rest, own)
    return whole.inertia * found


def _integrals(part, origin, waves, a, b):
    """∫ φ u dx from a to b, (modes,)."""
    piece, far = part.piece, np.zeros(len(part.modes), bool)
    if not piece.gradient:
        rate = max(abs(wave.exponent) + wave.power / (b - a) for wave in waves)
        rest = piece.bending * rate**4 + abs(piece.tension) * rate**2
        far = np.abs(part.kappa) > FAR * rest
    found = np.zeros(len(part.modes), part.ends.dtype)
    if far.any():
        found[far] = _by_ends(part, far, origin, waves, b) - _by_ends(part, far, origin, waves, a)
    near = np.flatnonzero(~far)
    for i in range(0, len(near), BLOCK):
        at = near[i:i + BLOCK]
        fastest = max(abs(wave.exponent) for wave in waves)
        cut = piece._replace(length=b - a)
        y, weights = panel_rule(cut, part.kappa[at], fastest, arithmetic_of(*cut, part.kappa))
        x = a + (b - a) * y
        u = np.real(sum(wave.coefficient * (x - origin) ** wave.power * np.exp(wave.exponent * (x - origin))
                        for wave in waves))
        phi = fields(piece, part.kappa[at], part.ends[at], (x - part.start)[:, None])[..., 0]
        found[at] = (weights * u * (b - a)) @ phi
    return found


def _by_ends(part, chosen, origin, waves, x):
    """The bracket of Green's identity at x."""
    piece, kappa = part.piece, part.kappa[chosen]
    phi = fields(piece, kappa, part.ends[chosen], np.clip(x - part.start, 0.0, piece.length))
    w = sum((factor * _particular(piece, kappa, rate, wave.power, x - origin) for wave in waves
             for factor, rate in _halves(wave)), np.zeros((4, len(kappa))))
    w = w if np.iscomplexobj(kappa) else np.real(w)
    found = -piece.tension * (phi[:, 0] * w[1] - phi[:, 1] * w[0])
    if piece.order == 4:
        found += piece.bending * (phi[:, 0] * w[3] - phi[:, 1] * w[2] + phi[:, 2] * w[1] - phi[:, 3] * w[0])
    return found


def _halves(wave):
    """(c/2, λ) and the conjugate of Re(c xᵏ e^{λx})."""
    factor, rate = complex(wave.coefficient), complex(wave.exponent)
    return (factor / 2, rate), (factor.conjugate() / 2, rate.conjugate())


def _particular(piece, kappa, rate, k, x):
    """w, w′, w″, w‴ for xᵏ e^{λx}, (4, modes)."""
    series = [kappa + piece.bending * rate**4 - piece.tension * rate**2,
              4 * piece.bending * rate**3 - 2 * piece.tension * rate, 6 * piece.bending * rate**2 - piece.tension,
              4 * piece.bending * rate, piece.bending]
    inverse = [1 / series[0]]
    for i in range(1, k + 1):
        inverse.append(-sum(series[m] * inverse[i - m] for m in range(1, min(i, 4) + 1)) / series[0])
    polynomial = [comb(k, i) * factorial(k - i) * inverse[k - i] for i in range(k + 1)]
    found = []
    for _ in range(4):
        found.append(np.exp(rate * x) * sum(c * x**i for i, c in enumerate(polynomial)))
        steeper = [(i + 1) * polynomial[i + 1] if i < k else 0 * polynomial[0] for i in range(k + 1)]
        polynomial = [rate * c + d for c, d in zip(polynomial, steeper, strict=True)]
    return np.array(found)
