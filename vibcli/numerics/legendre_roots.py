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
ROUNDS, NEAR = 4, 1e-10     # of Newton's method; a step whose square is nothing, wherever signs tell of the root


def overshoot(count: int) -> float:
    """By what the largest size of a series of so many terms at the places of `sampled` grows between them at most."""
    return float(1.0 / np.cos(0.5 * np.pi * (count - 1) / NODES))


def sampled(series: np.ndarray) -> np.ndarray:
    """The values of Legendre series, rows of coefficients, at the ends and the roots of a Chebyshev polynomial between
    them, ascending: the ends of cells."""
    return series @ _basis(series.shape[1])


def slopes(series: np.ndarray) -> np.ndarray:
    """The rows of coefficients of the slopes of Legendre series, as many."""
    return series @ _derivative(series.shape[1])


def coming_to(level: float, series: np.ndarray, values: np.ndarray) -> np.ndarray:
    """In which cells may a series, of these values at their ends, have a maximum that comes to a level? Of shape (rows,
    cells). About a maximum s is within max |s″| δ²/2 of it, δ being no more than half a cell to the nearer end."""
    bends = _most(sampled(slopes(slopes(series))), series.shape[1])
    return np.maximum(values[:, 1:], values[:, :-1]) >= level - bends[:, None] * (_gaps() ** 2 / 8)


def roots(series: np.ndarray) -> list[np.ndarray]:
    """The real roots in [−1, 1] of each row of Legendre coefficients, ascending; none of what vanishes."""
    rows, places = numbered_roots(series)
    return np.split(places, np.searchsorted(rows, np.arange(1, len(series)))) if len(series) else []


def numbered_roots(series: np.ndarray, cells: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """(the row of each root, these roots), ascending; cells: where roots are sought, of shape (rows, cells); elsewhere
    some may be found."""
    sizes = np.abs(series)
    series = np.where(sizes > NOTHING * sizes.max(axis=1, keepdims=True, initial=0.0), series, 0.0)
    sizes = np.abs(series)
    rows = np.flatnonzero(sizes[:, 1:].any(axis=1) & (sizes[:, 1:].sum(axis=1) >= sizes[:, 0]))
    if not len(rows):
        return rows, np.zeros(0)
    row, places = _found(series[rows], None if cells is None else cells[rows])
    return rows[row], places


def _found(series, sought):
    """The same of rows that may have roots."""
    count, of_slopes = series.shape[1], slopes(series)
    values, rates, bends = map(sampled, (series, of_slopes, slopes(of_slopes)))
    near = _most(rates, count)[:, None] * _gaps()
    row, cell = np.nonzero(_least(values[:, 1:], values[:, :-1]) <= near if sought is None else sought)
    ends = [(both[row, cell], both[row, cell + 1]) for both in (values, rates, bends)]
    unclear, bent = np.zeros(len(series), dtype=bool), _most(bends, count)[row] * _gaps()[cell]
    unclear[row[(_least(*ends[0]) <= near[row, cell]) & (_least(*ends[1]) <= bent)]] = True
    passed = ((ends[0][0] < 0) != (ends[0][1] < 0)) & ~unclear[row]
    row, cell, ends = row[passed], cell[passed], [(one[passed], other[passed]) for one, other in ends]
    places = _polished(series[row], of_slopes[row], _places()[cell] + _about(*ends, _gaps()[cell]))
    for k in np.flatnonzero(unclear):
        more = _of_companion(series[k])
        row, places = np.concatenate([row, np.full(len(more), k)]), np.concatenate([places, more])
    touched = np.abs(values[:, [0, -1]]) <= EDGE * np.abs(rates[:, [0, -1]])
    touched[row[places < EDGE - 1], 0] = touched[row[places > 1 - EDGE], 1] = False
    more, end = np.nonzero(touched)
    row, places = np.concatenate([row, more]), np.concatenate([places, 2.0 * end - 1.0])
    order = np.lexsort((places, row))
    return row[order], places[order]


def _about(values, rates, bends, gap):
    """How far after the start of a cell a root is in it: by the polynomial of degree 5 of the inverse, whose slope is
    1/s′ and whose bend −s″/s′³ at both ends; by a line where that leaves the cell."""
    s, change = values[0] / (values[0] - values[1]), values[1] - values[0]
    slope, bend = [change / rate for rate in rates], [-change**2 * b / r**3 for b, r in zip(bends, rates, strict=True)]
    left = 1 - s
    found = s**3 * (gap * (10 - 15 * s + 6 * s * s) - left * (slope[1] * (4 - 3 * s) - bend[1] * left / 2)) + (
        s * left**3 * (slope[0] * (1 + 3 * s) + bend[0] * s / 2))
    return np.where((found >= 0) & (found <= gap), found, s * gap)


def _least(one, other):
    """The smaller |value| of both ends of cells."""
    return np.minimum(np.abs(one), np.abs(other))


def _most(values, count):
    """The largest |value| that series of so many terms have between their samples at most."""
    return overshoot(count) * np.abs(values).max(axis=1)


def _polished(series, of_slopes, x):
    """Roots by Newton's method, each of its own row, until steps are so small that the next would be none."""
    for _ in range(ROUNDS):
        P = legendre.legvander(x, series.shape[1] - 1)
        bottom = np.einsum("ij,ij->i", P, of_slopes)
        step = np.einsum("ij,ij->i", P, series) / np.where(bottom == 0, np.inf, bottom)
        x = np.clip(x - np.clip(step, -1.0 / NODES, 1.0 / NODES), -1.0, 1.0)
        if np.abs(step).max(initial=0.0) <= NEAR:
            break
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
def _gaps():
    """The lengths of the cells between them."""
    return np.diff(_places())


@cache
def _basis(count):
    """The values of so many Legendre polynomials at these places, of shape (polynomials, places)."""
    return np.ascontiguousarray(legendre.legvander(_places(), count - 1).T)


@cache
def _derivative(count):
    """The matrix that takes rows of coefficients to those of the slope, as many."""
    return np.pad(legendre.legder(np.eye(count), axis=1), ((0, 0), (0, 1)))
