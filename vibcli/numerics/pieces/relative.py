"""The dynamic stiffness of a short piece of a beam by how its right end leaves the line that its left end points along:

    u = u₀ + θ₀ x + w (3ξ² − 2ξ³) + l ψ (ξ³ − ξ²) + Σ cⱼ bⱼ(ξ),     ξ = x/l,  u_l = u₀ + θ₀ l + w,  θ_l = θ₀ + ψ.

As d of u₀, θ₀, u_l, θ_l it holds 12 B/l³ in every entry, beside which nothing else is left; here what moves as a rigid
body feels κ and N alone. The bⱼ are integrals of Legendre's polynomials, bᵢ″ bⱼ″ orthonormal, and are eliminated.

w and ψ are small differences, of which u‴ = (6 l ψ − 12 w)/l³ is one again: it is told by the force and the moment that
bend it as a cantilever, w = F l³/3B + P l²/2B, ψ = F l²/2B + P l/B, u‴ = −F/B. These its neighbours tell.
"""

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.numerics.pieces.piece import Piece

FUNCTIONS, POINTS = 10, 24      # bⱼ, and of Gauss's rule, exact for all products
SHORT = 16.0        # κ l⁴/B, N l²/B and n l³/B up to which the bⱼ tell d to rounding


@cache
def _functions() -> list[np.ndarray]:
    """1, ξ, 3ξ² − 2ξ³, ξ³ − ξ² and the bⱼ as Legendre series of t = 2ξ − 1."""
    from numpy.polynomial import legendre

    shapes = [np.array(c) for c in ([1.0], [0.5, 0.5], [0.5, 0.6, 0.0, -0.1], [-1 / 12, -0.05, 1 / 12, 0.05])]
    for j in range(FUNCTIONS):
        bend = np.zeros(j + 3)
        bend[-1] = np.sqrt(2 * j + 5) / 4       # ξ = (1 + t)/2: two integrals over t are four of those over ξ
        shapes.append(legendre.legint(bend, 2, lbnd=-1))
    return shapes


@cache
def _derived(order: int) -> np.ndarray:
    """The same of their order-th derivatives by ξ, (coefficients, functions)."""
    from numpy.polynomial import legendre

    series = [2**order * legendre.legder(c, order) for c in _functions()]
    found = np.zeros((max(map(len, series)), len(series)))
    for k, own in enumerate(series):
        found[:len(own), k] = own
    return found


def _values(t: np.ndarray, order: int) -> np.ndarray:
    """The order-th derivatives by ξ of all functions, (functions, …)."""
    from numpy.polynomial import legendre

    found: np.ndarray = legendre.legval(t, _derived(order))
    return found


@cache
def _integrals() -> tuple[np.ndarray, ...]:
    """∫ f″g″, ∫ f′g′, ∫ ξ f′g′ and ∫ f g over 0 ≤ ξ ≤ 1, f and g of all functions."""
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    u, slope = _values(at, 0), _values(at, 1)
    S = np.diag([0.0, 0, 0, 0, *np.ones(FUNCTIONS)])
    S[2:4, 2:4] = [[12, -6], [-6, 4]]
    return S, (slope * weights / 2) @ slope.T, (slope * weights * (1 + at) / 4) @ slope.T, (u * weights / 2) @ u.T


def told(piece: "Piece", kappa: np.ndarray) -> np.ndarray:
    """Where relative_stiffness holds, as kappa broadcasts."""
    with np.errstate(all="ignore"):
        force = (np.abs(piece.tension) + np.abs(piece.gradient) * piece.length) * piece.length**2
        found: np.ndarray = (np.abs(kappa) * piece.length**4 <= SHORT * piece.bending) & (
            force <= SHORT * piece.bending)
        return found


def relative_stiffness(piece: "Piece", kappa: np.ndarray, bent: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """(d, ∂d/∂κ), each (…, 4, 4), of the motions u₀, θ₀, w, ψ; not `bent`: without what bends it as a cantilever; of
    doubles."""
    L, M = np.asarray(np.broadcast_arrays(piece.length, kappa)[0])[..., None, None], _integrals()[-1]
    stiff, rest, moved = _moved(piece, kappa)
    d = rest[..., :4, :4] + np.swapaxes(rest[..., 4:, :4], -1, -2) @ moved[..., 4:, :]
    if bent:
        d = d + stiff[..., :4, :4]
    slope = L * (np.swapaxes(moved, -1, -2) @ (M @ moved))
    turn = np.ones((*d.shape[:-2], 4))
    turn[..., 1::2] = L[..., 0]
    return tuple(part * turn[..., :, None] * turn[..., None, :] for part in (d, slope))


def _moved(piece: "Piece", kappa: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """What bending adds to the stiffness of all functions, and all else, and what each does as u₀, θ₀ l, w and ψ l are
    1, (…, functions, 4)."""
    S, T, T_along, M = _integrals()
    L, B, N, n, kappa = (np.asarray(x)[..., None, None] for x in np.broadcast_arrays(
        piece.length, piece.bending, piece.tension, piece.gradient, kappa))
    stiff, rest = (B / L**3) * S, (N / L) * T + n * T_along + (kappa * L) * M
    inner = -np.linalg.solve((stiff + rest)[..., 4:, 4:], rest[..., 4:, :4])
    return stiff, rest, np.concatenate([np.broadcast_to(np.eye(4), (*inner.shape[:-2], 4, 4)), inner], axis=-2)


def cantilever(piece: "Piece") -> np.ndarray:
    """(2, 2): F and P of w and ψ."""
    L, B = piece.length, piece.bending
    return np.array([[12 * B / L**3, -6 * B / L**2], [-6 * B / L**2, 4 * B / L]])


def leaning(piece: "Piece", bends: np.ndarray) -> np.ndarray:
    """u₀, θ₀, w, ψ of u₀, θ₀, F, P, (…, 4)."""
    L, B, (u, turn, F, P) = piece.length, piece.bending, np.moveaxis(bends, -1, 0)
    return np.stack([u, turn, L * L * (F * L / 3 + P / 2) / B, L * (F * L / 2 + P) / B], axis=-1)


def relative_fields(piece: "Piece", kappa: np.ndarray, bends: np.ndarray, x: np.ndarray) -> np.ndarray:
    """(u, u′, u″, u‴) at 0 ≤ x ≤ l of a piece in floats of which u₀, θ₀, F, P, (…, 4), are `bends`, as fields."""
    L = piece.length
    parts = (_moved(piece, kappa)[2] @ (leaning(piece, bends) * [1.0, L, 1.0, L])[..., None])[..., 0]
    t = 2 * np.asarray(x) / L - 1
    found = [np.einsum("f...,...f->...", _values(t, order), parts) / L**order for order in range(3)]
    bend = np.einsum("f...,...f->...", _values(t, 3)[4:], parts[..., 4:]) / L**3
    return np.stack([*found, bend - bends[..., 2] / piece.bending], axis=-1)


def in_relative_motions(piece: "Piece", kappa: np.ndarray, d: np.ndarray, slope: np.ndarray, bent: bool = True
                        ) -> tuple[np.ndarray, np.ndarray]:
    """(d, ∂d/∂κ) of u₀, θ₀, u_l, θ_l as those of u₀, θ₀, w, θ_l − θ₀, of long waves without what rounds, and where they
    are not `bent` as a cantilever without that."""
    turned = np.zeros((*np.broadcast_shapes(d.shape[:-2], np.shape(piece.length)), 4, 4))
    turned[..., range(4), range(4)] = turned[..., 2, 0] = turned[..., 3, 1] = 1.0
    turned[..., 2, 1] = piece.length
    found = [np.swapaxes(turned, -1, -2) @ part @ turned for part in (d, slope)]
    long = told(piece, kappa)[..., None, None]
    if long.any():
        found = [np.where(long, exact, part)
                 for exact, part in zip(relative_stiffness(piece, kappa, bent), found, strict=True)]
    return tuple(found)
