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
TINY = 1e-150           # in place of nothing
ROUNDS, NEAR = 4, 1e-10     # of Newton's method; a step whose square is nothing, wherever signs tell of the root


def overshoot(count: int) -> float:
    """By what the largest size of a series of so many terms at the places of `sampled` grows between them at most."""
    return float(1.0 / np.cos(0.5 * np.pi * (count - 1) / NODES))


def sampled(series: np.ndarray) -> np.ndarray:
    """The values of Legendre series, rows of coefficients, at the ends and the roots of a Chebyshev polynomial between
    them, ascending: the ends of cells."""
    found: np.ndarray = series @ _basis(series.shape[1])
    return found


def slopes(series: np.ndarray) -> np.ndarray:
    """The rows of coefficients of the slopes of Legendre series, as many."""
    found: np.ndarray = series @ _derivative(series.shape[1])
    return found


def coming_to(level: float, series: np.ndarray, values: np.ndarray) -> np.ndarray:
    """In which cells may a series, of these values at their ends, have a maximum that comes to a level? Of shape (rows,
    cells). About a maximum s is within max |s″| δ²/2 of it, δ being no more than half a cell to the nearer end."""
    bends, gaps = _most(slopes(slopes(series))), _gaps()
    found = np.zeros((len(values), len(gaps)), dtype=bool)
    row, end = _true(values >= (level - bends * (gaps.max() ** 2 / 8))[:, None])
    for cell in (np.maximum(end - 1, 0), np.minimum(end, len(gaps) - 1)):
        found[row, cell] |= values[row, end] >= level - bends[row] * gaps[cell] ** 2 / 8
    return found


def roots(series: np.ndarray) -> list[np.ndarray]:
    """The real roots in [−1, 1] of each row of Legendre coefficients, ascending; none of what vanishes."""
    rows, places = numbered_roots(series)
    return np.split(places, np.searchsorted(rows, np.arange(1, len(series)))) if len(series) else []


def numbered_roots(series: np.ndarray, cells: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """(the row of each root, these roots), ascending; cells: where roots are sought, of shape (rows, cells); elsewhere
    some may be found."""
    if cells is not None:
        return _found(series, cells)
    rows = np.flatnonzero(_may_vanish(series))
    row, places = _found(series[rows])
    return rows[row], places


def _may_vanish(series: np.ndarray) -> np.ndarray:
    """Whether each is no constant that outweighs the rest."""
    sizes = np.abs(series)
    found: np.ndarray = (sizes[:, 1:].sum(axis=1) >= sizes[:, 0]) & sizes.any(axis=1)
    return found


def _found(series: np.ndarray, sought: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """The same of rows that may have roots."""
    of_slopes = slopes(series)
    of_bends = slopes(of_slopes)
    most = _most(of_slopes)
    if sought is None:
        values = sampled(series)
        sought = _least(values[:, 1:], values[:, :-1]) <= most[:, None] * _gaps()
    row, cell = _true(sought & (most > 0)[:, None])
    near, bent = most[row] * _gaps()[cell], _most(of_bends)[row] * _gaps()[cell]
    ends = np.einsum("ijk,ljk->ilj", np.array([series, of_slopes, of_bends])[:, row],
                     _rows_of_basis(series.shape[1])[np.array([cell, cell + 1])])
    unclear = np.zeros(len(series), dtype=bool)
    unclear[row[(_least(*ends[0]) <= near) & (_least(*ends[1]) <= bent)]] = True
    passed = ((ends[0][0] < 0) != (ends[0][1] < 0)) & ~unclear[row]
    row, cell, ends = row[passed], cell[passed], ends[:, :, passed]
    places = _polished(series[row], of_slopes[row], _places()[cell] + _about(*ends, _gaps()[cell]))
    for k in np.flatnonzero(unclear):
        more = _of_companion(series[k])
        row, places = np.concatenate([row, np.full(len(more), k)]), np.concatenate([places, more])
    at_edges, rates = (np.abs(one @ _edges(series.shape[1])) for one in (series, of_slopes))
    touched = at_edges <= EDGE * rates
    if touched.any():
        touched &= _may_vanish(series)[:, None]
    touched[row[places < EDGE - 1], 0] = touched[row[places > 1 - EDGE], 1] = False
    more, end = np.nonzero(touched)
    row, places = np.concatenate([row, more]), np.concatenate([places, 2.0 * end - 1.0])
    order = np.lexsort((places, row))
    return row[order], places[order]


def _about(values: np.ndarray, rates: np.ndarray, bends: np.ndarray, gap: np.ndarray) -> np.ndarray:
    """How far after the start of a cell a root is in it: by the polynomial of degree 5 of the inverse, whose slope is
    1/s′ and whose bend −s″/s′³ at both ends; by a line where that leaves the cell."""
    change = values[1] - values[0]
    s, slope = -values[0] / change, change / rates
    left, bend = 1 - s, -bends * slope**3 / change
    found = s**3 * (gap * (10 - 15 * s + 6 * s * s) - left * (slope[1] * (4 - 3 * s) - bend[1] * left / 2)) + (
        s * left**3 * (slope[0] * (1 + 3 * s) + bend[0] * s / 2))
    result: np.ndarray = np.where((found >= 0) & (found <= gap), found, s * gap)
    return result


def _true(table: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(rows, columns) of what is true in a table."""
    return np.divmod(np.flatnonzero(table), table.shape[1])


def _least(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The smaller |value| of both ends of cells."""
    found: np.ndarray = np.minimum(np.abs(one), np.abs(other))
    return found


def _most(series: np.ndarray) -> np.ndarray:
    """The largest |value| that each has on [−1, 1] at most."""
    at_few, beyond = _few(series.shape[1])
    found: np.ndarray = beyond * np.abs(series @ at_few).max(axis=1)
    return found


def _polished(series: np.ndarray, of_slopes: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Roots by Newton's method, each of its own row, until steps are so small that the next would be none."""
    for _ in range(ROUNDS):
        P = _polynomials(x, series.shape[1])
        bottom = np.einsum("ij,ij->i", P, of_slopes)
        step = np.einsum("ij,ij->i", P, series) / np.where(bottom == 0, np.inf, bottom)
        x = np.clip(x - np.clip(step, -1.0 / NODES, 1.0 / NODES), -1.0, 1.0)
        if np.abs(step).max(initial=0.0) <= NEAR:
            break
    return x


def _polynomials(x: np.ndarray, count: int) -> np.ndarray:
    """The values of so many Legendre polynomials at places, of shape (places, polynomials): by the barycentric formula
    from those at Chebyshev's (Berrut & Trefethen 2004)."""
    nodes, weights, values = _chebyshev(count)
    away = x[:, None] - nodes
    parts = weights / np.where(away == 0, TINY, away)
    found: np.ndarray = (parts / parts.sum(axis=1, keepdims=True)) @ values
    return found


def _of_companion(series: np.ndarray) -> np.ndarray:
    """The roots of one series."""
    sizes = np.abs(series)
    kept = series[:np.flatnonzero(sizes > NOTHING * sizes.max())[-1] + 1]
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
def _places() -> np.ndarray:
    """The ends, and the roots of a Chebyshev polynomial between them."""
    return np.concatenate([[-1.0], -np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES), [1.0]])


@cache
def _gaps() -> np.ndarray:
    """The lengths of the cells between them."""
    return np.diff(_places())


@cache
def _basis(count: int) -> np.ndarray:
    """The values of so many Legendre polynomials at these places, of shape (polynomials, places)."""
    return np.ascontiguousarray(legendre.legvander(_places(), count - 1).T)


@cache
def _rows_of_basis(count: int) -> np.ndarray:
    """The same, of shape (places, polynomials)."""
    return np.ascontiguousarray(_basis(count).T)


@cache
def _edges(count: int) -> np.ndarray:
    """The same at both ends."""
    return np.ascontiguousarray(_basis(count)[:, [0, -1]])


@cache
def _few(count: int) -> tuple[np.ndarray, float]:
    """(the values of so many Legendre polynomials at the roots of a Chebyshev polynomial of three times the degree, by
    what the largest size there of a sum of them grows at most)."""
    nodes = 3 * count
    x = np.cos(np.pi * (np.arange(nodes) + 0.5) / nodes)
    return np.ascontiguousarray(legendre.legvander(x, count - 1).T), 1.0 / np.cos(0.5 * np.pi * (count - 1) / nodes)


@cache
def _chebyshev(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(Chebyshev's points, their barycentric weights, the values of so many Legendre polynomials there)."""
    angles = np.pi * (np.arange(count) + 0.5) / count
    return np.cos(angles), np.sin(angles) * (-1.0) ** np.arange(count), legendre.legvander(np.cos(angles), count - 1)


@cache
def _derivative(count: int) -> np.ndarray:
    """The matrix that takes rows of coefficients to those of the slope, as many."""
    return np.pad(legendre.legder(np.eye(count), axis=1), ((0, 0), (0, 1)))
