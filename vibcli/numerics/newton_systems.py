"""Zeros of several functions of several positive or signed unknowns: damped Newton steps from many starting places.

Positive unknowns are solved for in logarithms, so that products of powers are linear. The starts are, of two unknowns,
the zeros of the functions as they are between the points of a grid over a box (linear on its triangles), then the
centre of the cube and those of a Halton sequence (Halton 1960); the search ends when further ones find nothing new.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import chain, islice, product
from typing import Any

import numpy as np

from vibcli.numerics.halton import halton

GRID, BESIDE = 24, 0.25         # cells along a side of the box; how far beside its triangle such a zero may lie
FACTORS = (-0.5, -0.2, 0.2, 0.5)
STEPS, STARTS, IDLE, STEP, CLOSE = 40, 48, 16, 1e-7, 1e-6
CONVERGED, LONGEST = 1e-13, 2.3


def common_zeros(function: Callable[..., Any], place: Callable[..., Any], dimensions: int) -> list[list[float]]:
    """[u], the distinct zeros found; `function(u)` gives a list of at least so many values, None where it is not
    defined; `place(p)` is the start at a point p of the unit cube."""
    found, idle = [], 0
    for start in _crossings(function, place) if dimensions == 2 else ():
        _add(found, newton(function, start))
    for point in chain([[0.5] * dimensions], islice(halton(dimensions), STARTS - 1)):
        idle = 0 if _add(found, newton(function, place(point))) else idle + 1
        if idle >= IDLE:
            break
    for u in found:
        for start in _across(function, u):
            _add(found, newton(function, start))
    return found


def _add(found: list[list[float]], u: list[float] | None) -> bool:
    """Keep a zero; is it new?"""
    new = u is not None and all(_distance(u, other) > CLOSE for other in found)
    found += [u] if new else []
    return new


def _across(function: Callable[..., Any], u: list[float]) -> Iterator[np.ndarray]:
    """Places to both sides of a zero in the direction in which the functions change least: of two zeros that are near
    to meet, the other lies there."""
    slope = _jacobian(function, np.array(u), _values(function, u))
    if slope is not None:
        softest = np.linalg.svd(slope)[2][-1]
        for factor in FACTORS:
            yield u + factor * softest


def _crossings(function: Callable[..., Any], place: Callable[..., Any]) -> Iterator[np.ndarray]:
    """Where two functions that are linear on each triangle of a grid, as at its corners, vanish."""
    line = range(GRID + 1)
    places = {(i, j): np.array(place([i / GRID, j / GRID])) for i, j in product(line, line)}
    values = {key: _values(function, u) for key, u in places.items()}
    for i, j in product(range(GRID), range(GRID)):
        for corners in (((i, j), (i + 1, j), (i, j + 1)), ((i + 1, j + 1), (i + 1, j), (i, j + 1))):
            found = [values[key] for key in corners]
            if any(value is None or len(value) != 2 for value in found):
                continue
            rows = np.vstack([np.array(found).T, np.ones(3)])
            if abs(np.linalg.det(rows)) > 1e-300:
                shares = np.linalg.solve(rows, [0.0, 0.0, 1.0])
                if shares.min() > -BESIDE:
                    yield shares @ np.array([places[key] for key in corners])


def _distance(a: Sequence[float], b: Sequence[float]) -> float:
    return max(abs(x - y) / max(1.0, abs(x), abs(y)) for x, y in zip(a, b, strict=True))


def newton(function: Callable[..., Any], u: Sequence[float] | np.ndarray) -> list[float] | None:
    """A zero reached from u by Newton steps (Gauss–Newton of more values than unknowns), halved until they lower the
    sum of squares; None where they do not get there."""
    value = _values(function, u)
    if value is None:
        return None
    u = np.array(u, float)
    for _ in range(STEPS):
        size = float(np.linalg.norm(value))
        slope = _jacobian(function, u, value)
        if slope is None:
            return None
        step = np.linalg.lstsq(slope, -value, rcond=1e-12)[0]
        longest = float(np.abs(step).max())
        step *= min(1.0, LONGEST / longest) if longest else 1.0
        for _ in range(12):
            trial = _values(function, u + step)
            if trial is not None and np.linalg.norm(trial) < size:
                break
            step = 0.5 * step
        else:
            return list(map(float, u)) if size <= 1e-8 else None
        u, value = u + step, trial
        if np.linalg.norm(value) <= CONVERGED:
            break
    return list(map(float, u)) if np.linalg.norm(value) <= 1e-8 else None


def _values(function: Callable[..., Any], u: np.ndarray | Sequence[float]) -> np.ndarray | None:
    value = function(list(map(float, u)))
    if value is None:
        return None
    value = np.array(value, float)
    return value if np.isfinite(value).all() else None


def _jacobian(function: Callable[..., Any], u: np.ndarray, value: np.ndarray) -> np.ndarray | None:
    columns = []
    for j in range(len(u)):
        step = STEP * max(1.0, abs(u[j]))
        moved = u.copy()
        moved[j] += step
        other = _values(function, moved)
        if other is None:
            return None
        columns.append((other - value) / step)
    return np.array(columns).T
