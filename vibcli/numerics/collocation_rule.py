"""Collocation of q̈ = f(t, q, q̇): q̈ is a polynomial of degree s − 1 that obeys f at s points of Gauss, or of Radau.

Its integrals are exact, so q̇ and q are polynomials too: with the values A of q̈ at the points of a window of length H

    q̇ = q̇₀ + H A V₁ᵀ        q = q₀ + H c q̇₀ + H² A V₂ᵀ

(Hairer, Nørsett & Wanner 1993, II.7.) At Gauss's points the method is symplectic and symmetric, of order 2s at the ends
of windows. At Radau's, of order 2s − 1, it damps what is stiff (Hairer & Wanner 1996, IV.5) if q̇ is taken for the
polynomial through its values at the points before it is integrated: with the exact integral of that of q̈ fast
oscillations would grow (van der Houwen, Sommeijer & Cong 1991).
"""

from functools import lru_cache

import numpy as np
from numpy.polynomial.legendre import leggauss

LONG = np.longdouble
FEW = 12        # places at which a recurrence in plain floats is cheaper than one in arrays


class Rule:
    """Points c and weights w on [0, 1]; V1, V2: integrals at the points, transposed; b2: weights w (1 − c) of the
    double integral to the end; to_series: values at the points to Legendre coefficients (transposed); once, twice:
    coefficients of the integrals of Pₖ; at_points: P₀ … P_{s+1} and their slopes at the points x = 2c − 1. Found in
    extended precision: their rounding errors would be the same in each window, and add up."""

    __slots__ = ("V1", "V2", "_known", "at_points", "b2", "c", "once", "points", "to_series", "twice", "w", "x")

    def __init__(self, points: int, radau: bool = False) -> None:
        x, w = (_radau if radau else _gauss)(points)
        P = _legendre(x, points + 1)
        once = _integrated(points)
        to_series = P[:points].T * w[:, None] * (np.arange(points) + LONG(0.5))
        if radau:
            to_series = np.linalg.inv(P[:points].astype(float)).astype(LONG)
            to_series += to_series @ (np.eye(points) - P[:points] @ to_series)
            twice = np.pad(once @ P[:-1] @ to_series @ once, ((0, 0), (0, 1)))
        else:
            twice = once @ _integrated(points + 1)
        self.points, self._known = points, {}
        self.c, self.w, self.x = _rounded((x + 1) / 2), _rounded(w / 2), _rounded(x)
        self.b2 = _rounded(to_series @ twice.sum(axis=1) if radau else w * (1 - x) / 4)
        self.to_series, self.once, self.twice = _rounded(to_series), _rounded(once), _rounded(twice)
        self.V1 = _rounded(to_series @ once @ P[:-1])
        self.V2 = _rounded(to_series @ twice @ P)
        self.at_points = _rounded(P), _rounded(_slopes(points + 1) @ P)

    def basis(self, x: np.ndarray) -> np.ndarray:
        """P₀ … P_{s+1} at places x in [−1, 1], of shape (s + 2, places)."""
        return _legendre(x, self.points + 1)

    def basis_at(self, c: np.ndarray) -> np.ndarray:
        """The same at parts c of [0, 1], kept for the next window."""
        key = c.tobytes()
        if key not in self._known:
            self._known[key] = _rounded(self.basis(2 * c.astype(LONG) - 1))
        return np.asarray(self._known[key])

    def within(self, values: np.ndarray, part: float) -> np.ndarray:
        """The values at the points of the first part of a window, of polynomials through values at those of all."""
        found: np.ndarray = values @ self.to_series @ self.basis_at(part * self.c)[:-2]
        return found


def _rounded(array: np.ndarray) -> np.ndarray:
    return np.ascontiguousarray(array, dtype=float)


def _gauss(points: int) -> tuple[np.ndarray, np.ndarray]:
    """Gauss's points and weights on [−1, 1]: those of NumPy and one Newton step in extended precision."""
    x = leggauss(points)[0].astype(LONG)
    for _ in range(2):
        P = _legendre(x, points)
        slope = points * (x * P[-1] - P[-2]) / (x * x - 1)
        x = x - P[-1] / slope
    P = _legendre(x, points)
    slope = points * (x * P[-1] - P[-2]) / (x * x - 1)
    return x, 2 / ((1 - x * x) * slope * slope)


def _radau(points: int) -> tuple[np.ndarray, np.ndarray]:
    """Radau's points on [−1, 1], the last at 1: zeros of Pₛ₋₁ − Pₛ, near those of the Jacobi polynomial (1, 0)."""
    k = np.arange(points - 1)
    off = np.sqrt(k[1:] * (k[1:] + 1.0)) / (2 * k[1:] + 1)
    matrix = np.diag(-1.0 / ((2 * k + 1) * (2 * k + 3))) + np.diag(off, 1) + np.diag(off, -1)
    x = np.append(np.linalg.eigvalsh(matrix), 1.0).astype(LONG)
    for _ in range(2):
        inner = x[:-1]
        P = _legendre(inner, points)
        bottom = inner * inner - 1
        slope = ((points - 1) * (inner * P[-2] - P[-3]) - points * (inner * P[-1] - P[-2])) / bottom
        x[:-1] = inner - (P[-2] - P[-1]) / slope
    return x, (1 + x) / (points * _legendre(x, points)[-2]) ** 2


def _legendre(x: np.ndarray, degree: int) -> np.ndarray:
    """P₀ … P_degree at the places x, by their recurrence; at few places in plain floats, which do the same."""
    if len(x) <= FEW and x.dtype == float:
        return np.ascontiguousarray(np.array([_legendre_at(y, degree) for y in x.tolist()]).reshape(-1, degree + 1).T)
    P = np.empty((degree + 1, len(x)), dtype=x.dtype)
    P[0], P[1] = 1, x
    for k, (two_before, before, row) in enumerate(zip(P, P[1:], P[2:], strict=False), 1):
        np.multiply(2 * k + 1, x, out=row)
        row *= before
        row -= k * two_before
        row /= k + 1
    return P


def _legendre_at(y: float, degree: int) -> list[float]:
    """The same at one place."""
    before, last = 1.0, y
    values = [before, last]
    for twice, k, after in _factors(degree):
        before, last = last, (twice * y * last - k * before) / after
        values.append(last)
    return values


@lru_cache
def _factors(degree: int) -> list[tuple[float, float, float]]:
    """2k + 1, k and k + 1 of the recurrence (k + 1) Pₖ₊₁ = (2k + 1) x Pₖ − k Pₖ₋₁."""
    return [(2 * k + 1.0, float(k), k + 1.0) for k in range(1, degree)]


def _integrated(count: int) -> np.ndarray:
    """Rows of Legendre coefficients of ∫₀^c Pₖ dc, x = 2c − 1, for k below `count`: (Pₖ₊₁ − Pₖ₋₁)/(2 (2k + 1))."""
    rows = np.zeros((count, count + 1), dtype=LONG)
    rows[0, :2] = LONG(0.5)
    for k in range(1, count):
        rows[k, k + 1] = LONG(0.5) / (2 * k + 1)
        rows[k, k - 1] = -rows[k, k + 1]
    return rows


def _slopes(degree: int) -> np.ndarray:
    """Rows of Legendre coefficients of the slopes of P₀ … P_degree: Pₖ₊₁′ = Pₖ₋₁′ + (2k + 1) Pₖ."""
    rows = np.zeros((degree + 1, degree + 1), dtype=LONG)
    for k in range(degree):
        rows[k + 1] = rows[k - 1] if k else 0
        rows[k + 1, k] = 2 * k + 1
    return rows


@lru_cache
def rule(points: int, radau: bool = False) -> Rule:
    return Rule(points, radau)
