"""The roots of many Legendre series in [−1, 1] at once: signs at the roots of a Chebyshev polynomial tell about where,
Newton's method the rest; where signs may not tell all, those of a companion matrix (Boyd 2013).

Two roots may be where a series and its slope are both so small at one end of a cell that each may vanish in it. A
polynomial of degree n that is within ±1 at the m > n roots of Tₘ is within ±1/cos(πn/2m) on [−1, 1] (Ehlich and Zeller
1964), which bounds both slopes.
"""

from functools import cache

import numpy as np
from numpy.polynomial import legendre

NODES = 400
NOTHING = 1e-15         # of the largest coefficient
EDGE = 1e-6             # how far beyond the ends a root may be, by rounding
ROUNDS = 4              # of Newton's method


def overshoot(count: int) -> float:
    """By what the largest size of a series of so many terms at the places of `sampled` grows between them at most."""
    return float(1.0 / np.cos(0.5 * np.pi * (count - 1) / NODES))


def sampled(series: np.ndarray) -> np.ndarray:
    """The values of Legendre series, rows of coefficients, at the roots of a Chebyshev polynomial, ascending."""
    return series @ _basis(series.shape[1])[:, 1:-1]


def roots(series: np.ndarray) -> list[np.ndarray]:
    """The real roots in [−1, 1] of each row of Legendre coefficients, ascending; none of what vanishes."""
    sizes = np.abs(series)
    series = np.where(sizes > NOTHING * sizes.max(axis=1, keepdims=True, initial=0.0), series, 0.0)
    sizes = np.abs(series)
    rows = np.flatnonzero(sizes[:, 1:].any(axis=1) & (sizes[:, 1:].sum(axis=1) >= sizes[:, 0]))
    found = [np.zeros(0) for _ in series]
    for row, places in zip(rows, _found(series[rows]) if len(rows) else (), strict=True):
        found[row] = places
    return found


def _found(series):
    """The same of rows that may have roots."""
    count, x = series.shape[1], _places()
    slopes = series @ _derivative(count)
    values, rates, bends = (rows @ _basis(count) for rows in (series, slopes, slopes @ _derivative(count)))
    small = [_least(rows) <= np.diff(x) * overshoot(count) * np.abs(more).max(axis=1, keepdims=True)
             for rows, more in ((values, rates), (rates, bends))]
    unclear = (small[0] & small[1]).any(axis=1)
    row, cell = np.nonzero(((values[:, :-1] < 0) != (values[:, 1:] < 0)) & ~unclear[:, None])
    part = values[row, cell] / (values[row, cell] - values[row, cell + 1])
    places = _polished(series[row], slopes[row], x[cell] + part * (x[cell + 1] - x[cell]))
    touched = np.abs(values[:, [0, -1]]) <= EDGE * np.abs(rates[:, [0, -1]])
    for k, one in enumerate(series):
        inside = np.sort(places[row == k]) if not unclear[k] else _of_companion(one)
        first, last = (touched[k] & [not (inside < EDGE - 1).any(), not (inside > 1 - EDGE).any()]).tolist()
        yield np.concatenate([[-1.0][:first], inside, [1.0][:last]])


def _least(rows):
    """The smaller |value| of both ends of each cell."""
    rows = np.abs(rows)
    return np.minimum(rows[:, 1:], rows[:, :-1])


def _polished(series, slopes, x):
    """Roots by Newton's method, each of its own row."""
    for _ in range(ROUNDS):
        P = legendre.legvander(x, series.shape[1] - 1)
        bottom = np.einsum("ij,ij->i", P, slopes)
        step = np.einsum("ij,ij->i", P, series) / np.where(bottom == 0, np.inf, bottom)
        x = np.clip(x - np.clip(step, -1.0 / NODES, 1.0 / NODES), -1.0, 1.0)
    return x


def _of_companion(series):
    """The roots of one series."""
    kept = series[:np.flatnonzero(series)[-1] + 1]
    found = legendre.legroots(kept)
    real = found[np.abs(found.imag) <= 1e-7].real
    real = np.clip(real[np.abs(real) <= 1 + EDGE], -1.0, 1.0)
    slope = legendre.legder(kept)
    for _ in range(ROUNDS):
        bottom = legendre.legval(real, slope)
        step = np.where(bottom == 0, 0.0, legendre.legval(real, kept) / np.where(bottom == 0, 1.0, bottom))
        real = np.where(np.abs(step) < 1e-5, real - step, real)
    return np.sort(np.clip(real[np.abs(real) <= 1 + 1e-12], -1.0, 1.0))


@cache
def _places():
    """The ends, and the roots of a Chebyshev polynomial between them."""
    return np.concatenate([[-1.0], -np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES), [1.0]])


@cache
def _basis(count):
    """The values of so many Legendre polynomials at these places, of shape (polynomials, places)."""
    return np.ascontiguousarray(legendre.legvander(_places(), count - 1).T)


@cache
def _derivative(count):
    """The matrix that takes rows of coefficients to those of the slope, as many."""
    return np.pad(legendre.legder(np.eye(count), axis=1), ((0, 0), (0, 1)))
