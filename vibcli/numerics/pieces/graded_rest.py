"""Bending of a beam piece at rest whose tension varies along it, under a load:

    B u⁗ − ((N + n x) u′)′ + k u = q(x)

By Galerkin's method: u is the cubic of the end values and Σ aⱼ ∬Pⱼ, j ≥ 2, which rests at both ends. So u″ is a series
in Legendre's polynomials, whose coefficients fall the faster the smoother q is.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial import legendre

from vibcli.numerics.pieces.arithmetic import arithmetic_of

if TYPE_CHECKING:
    from vibcli.numerics.pieces.loads import LoadForm
    from vibcli.numerics.pieces.piece import Piece

DEGREES = 16, 32, 64, 128, 256
NEAR = np.array([1e-9, 1e-6])       # of the largest u″ and u‴: where twice the degree changes no more
SHARES, IN_FLOATS = np.linspace(-1.0, 1.0, 41), arithmetic_of(0.0)


def bent_at_rest(piece: "Piece", ends: np.ndarray,
                 loads: "Sequence[LoadForm]") -> Callable[[np.ndarray, int], np.ndarray] | None:
    """(places, order) → u or its derivative of this order, up to 3, at places from the left end, (n,); ends: (u₀, θ₀,
    u_l, θ_l); loads: q is their sum. None where no such degree gives u″ and u‴."""
    half, before = piece.length / 2, np.full((2, len(SHARES)), np.inf)
    for degree in DEGREES:
        bend = _bend(piece, ends, loads, degree)
        bends = bend, legendre.legder(bend) / half
        found = np.array([legendre.legval(SHARES, one) for one in bends])
        if (abs(found - before).max(axis=1) <= NEAR * abs(found).max(axis=1)).all():
            slope = legendre.legint(half * bend, lbnd=-1, k=[ends[1]])
            series = legendre.legint(half * slope, lbnd=-1, k=[ends[0]]), slope, *bends
            return lambda places, order: legendre.legval(places / half - 1, series[order])
        before = found
    return None


def _bend(piece: "Piece", ends: np.ndarray, loads: "Sequence[LoadForm]", degree: int) -> np.ndarray:
    """u″ as a series in Legendre's polynomials of 2x/l − 1, up to a degree."""
    half, cubic = piece.length / 2, _cubic(ends, piece.length / 2)
    xi, weights = legendre.leggauss(degree + 16)
    value, slope = _resting(xi, degree)
    tension = (piece.tension / half + piece.gradient * (1 + xi)) * weights
    bed = piece.foundation * half * weights
    K = (slope * tension) @ slope.T + (value * bed) @ value.T
    K += np.diag(2 * piece.bending / half**3 / (2 * np.arange(2, degree + 1) + 1))
    F = -value @ (bed * legendre.legval(xi, cubic)) - slope @ (tension * legendre.legval(xi, legendre.legder(cubic)))
    for one in (stretch for form in loads for stretch in form.stretches):
        share = (one.end - one.start) / 2
        x = one.start + share * (1 + xi)
        F += _resting(x / half - 1, degree)[0] @ (one.at(x, IN_FLOATS) * share * weights)
    found = np.concatenate([[0.0, 0.0], np.linalg.solve(K, F)])
    found[:2] += legendre.legder(cubic, 2)
    curvature: np.ndarray = found / half**2
    return curvature


def _resting(xi: np.ndarray, degree: int) -> tuple[np.ndarray, np.ndarray]:
    """∬Pⱼ, j = 2 … degree, which vanish with their slopes at both ends, and ∫Pⱼ: (j, places) each."""
    P = legendre.legvander(xi, degree + 2).T
    j = np.arange(1, degree + 2)[:, None]
    once = (P[2:] - P[:-2]) / (2 * j + 1)           # of Pⱼ, j = 1 … degree + 1
    return (once[2:] - once[:-2]) / (2 * j[1:-1] + 1), once[1:-1]


def _cubic(ends: np.ndarray, half: float) -> np.ndarray:
    """That of end values as a series in Legendre's polynomials."""
    u0, u1 = ends[0], ends[2]
    v0, v1 = half * ends[1], half * ends[3]
    return legendre.poly2leg([(u0 + u1) / 2 + (v0 - v1) / 4, 3 * (u1 - u0) / 4 - (v0 + v1) / 4, (v1 - v0) / 4,
                              (u0 - u1 + v0 + v1) / 4])
