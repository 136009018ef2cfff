"""Limit points (folds) of a path of equilibria, at which two of them meet and vanish, to any number of digits.

At a smooth one K is singular along φ while the load ∂r/∂p works along its left null vector, so that p turns back. With
a vector l

    r(q, p) = 0      K φ = 0      l·φ = 1

has a regular zero (q, p, φ) at a quadratic one (Moore & Spence 1980): Newton's method with the derivatives in floats
and the residual in mpmath gains their digits at each step. At a branching, where paths cross, it has none.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.limit_points.dips import cut_at_dips
from vibcli.analyses.limit_points.equations import UNDEFINED, ParametricEquilibrium
from vibcli.analyses.limit_points.path import EquilibriumPath
from vibcli.analyses.limit_points.path_step import PathPoint, PathStep
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from types import ModuleType

GUARD, SURE, ROUNDS, RENEWED, FASTER = 25, 8, 60, 6, 0.1     # digits beyond those asked; steps; how they fall
STRAYED, TRANSVERSE, REGULAR = 0.3, 1e-9, 1e14      # relative: how far from where it was met; of w·∂r/∂p; condition
EQUAL, LEVEL, FAINT, CORNER = 1e-10, 1e-4, 1e-10, 1e-11     # of p; of its rate; the error of p at a corner


class LimitPoint(NamedTuple):
    """p, {coordinate: number} and {symbol: number} of everything at rest there, numbers of mpmath, floats where forces
    bend there; bounds of the error of p, relative, and `blur` of coordinates, by the size of the figure."""

    value: Any
    position: Mapping[str, Any]
    values: Mapping[str, Any]
    error: float
    blur: float


class PathEnd(NamedTuple):
    """Where a path is followed no further: p, why, and whether it goes on there."""

    value: float
    why: str
    broken: bool


class FollowedPath(NamedTuple):
    """The limit points by ascending |p|, those of the sign of `start` first where |p| is the same; p of branchings and
    of limit points that are not resolved; the least and the largest p that were met; where it ends, followed towards
    larger and towards smaller p at first."""

    start: float
    limits: list[LimitPoint]
    branchings: list[float]
    unresolved: list[float]
    reached: tuple[float, float]
    ends: tuple[PathEnd, ...]

    def counted(self, both: bool) -> list[LimitPoint]:
        """The limit points of the sign of the start, positive of 0, or of both signs."""
        negative = self.start < 0
        return [one for one in self.limits if both or (one.value < 0) == negative]


def followed_path(equations: ParametricEquilibrium, digits: int) -> FollowedPath:
    """The FollowedPath through the equilibrium that is reached, its limit points good to so many digits."""
    path = EquilibriumPath(equations)
    limits, branchings, unresolved, values, ends = [], [], [], [equations.start], []
    for sense in (1, -1):
        for stretch in cut_at_dips(path, path.stretches(sense)):
            values.append(path.parted(stretch.end.y)[1])
            if stretch.branching:
                branchings.append(_branching(path, stretch))
            elif _turns(stretch):
                point, width = path.between(stretch, _climb)
                found = _limit_point(path, stretch, point, digits) or _corner(path, point, width)
                values.append(path.parted(point.y)[1])
                limits += [found] if found else []
                unresolved += [] if found else values[-1:]
        ends.append(PathEnd(values[-1], path.ended, path.broken))
    return FollowedPath(equations.start, _ordered(limits, equations.start < 0), branchings, unresolved,
                        (min(values), max(values)), tuple(ends))


def _turns(stretch: PathStep) -> bool:
    """Does p turn back on a stretch, by more than rounding?"""
    before, after = _climb(stretch.start), _climb(stretch.end)
    return (before < 0) != (after < 0) and max(abs(before), abs(after)) > FAINT


def _ordered(limits: list[LimitPoint], negative: bool) -> list[LimitPoint]:
    """Each value once."""
    kept: list[LimitPoint] = []
    for one in sorted(limits, key=lambda one: abs(one.value)):
        if not any(abs(one.value - other.value) <= EQUAL * abs(one.value) for other in kept):
            kept.append(one)
    kept.sort(key=lambda one: (float(f"{float(abs(one.value)):.10g}"), (one.value < 0) != negative))
    return kept


def _climb(point: PathPoint) -> float:
    return float(point.tangent[-1])


def _branching(path: EquilibriumPath, stretch: PathStep) -> float:
    point, _ = path.between(stretch, lambda one: 1.0 if one.sense == stretch.start.sense else -1.0)
    return path.parted(point.y)[1]


def _limit_point(path: EquilibriumPath, stretch: PathStep, point: PathPoint, digits: int) -> LimitPoint | None:
    """The LimitPoint of a stretch on which p turns back, near a point; None where it is no regular one."""
    q, p = path.parted(point.y)
    if abs(_climb(point)) > LEVEL:
        return None
    found = _ExtendedSystem(path.equations, q, p, path.unit, point.position).solved(digits)
    if found is None:
        return None
    gone = path.metric * float(np.linalg.norm(stretch.end.y - stretch.start.y))
    strayed = max(abs(float(found.position[one]) / scale - x) for one, scale, x in
                  zip(path.equations.names, path.equations.scale, q, strict=True))
    near = abs(float(found.value) - p) <= STRAYED * max(abs(p), path.unit) and strayed <= max(gone, 1e-6)
    return found if near else None


def _corner(path: EquilibriumPath, point: PathPoint, width: float) -> LimitPoint | None:
    """The LimitPoint at which forces bend, so that p turns back sharply; None elsewhere."""
    p = path.parted(point.y)[1]
    if not path.equations.bends or abs(_climb(point)) <= LEVEL or not p:
        return None
    error = 2 * width * path.unit / abs(p) + CORNER
    blur = width * path.metric + CORNER**0.75
    return LimitPoint(p, point.position, {**path.equations.at_rest(p), **point.position}, error, blur)


class _ExtendedSystem:
    """(r, K φ, l·φ − 1) about a place near a limit point: q in figures, p in units."""

    def __init__(self, equations: ParametricEquilibrium, q: np.ndarray, p: float, unit: float,
                 position: Mapping[str, float]) -> None:
        self.equations, self.unit, self.position = equations, unit, position
        self.n, self.q, self.p = len(q), q, p
        found = equations.rates(q, p, None, 1.0, position)
        self.size = 0.0 if found is None else float(max(np.abs(found[0].K).max(), np.abs(found[0].dr).max() * unit))
        self.along = np.linalg.svd(found[0].K)[2][-1] if found is not None else np.zeros(self.n)

    def _slopes(self, q: np.ndarray, p: float, phi: np.ndarray) -> np.ndarray | None:
        """The matrix of derivatives by (q, p/unit, φ); None where it is singular, as at a branching."""
        n, eq = self.n, self.equations
        straight = eq.rates(q, p, None, 1.0, self.position)
        bent = eq.rates(q, p, phi, 0.0, self.position)
        if straight is None or bent is None:
            return None
        rates, found = straight[0], np.zeros((2 * n + 1, 2 * n + 1))
        found[:n, :n], found[:n, n] = rates.K, rates.dr * self.unit
        found[n:2 * n, :n], found[n:2 * n, n] = bent[0].dK, rates.dK @ phi * self.unit
        found[n:2 * n, n + 1:], found[2 * n, n + 1:] = rates.K, self.along * self.size
        w = np.linalg.svd(rates.K)[0][:, -1]
        load = float(np.linalg.norm(rates.dr))
        if not load or abs(w @ rates.dr) <= TRANSVERSE * load:
            return None
        rows = np.abs(found).max(axis=1, keepdims=True)
        if not rows.all():
            return None
        columns = np.maximum(np.abs(found / rows).max(axis=0, keepdims=True), 1e-300)
        return found if np.linalg.cond(found / rows / columns) < REGULAR else None

    def solved(self, digits: int) -> LimitPoint | None:
        """The limit point to so many digits."""
        import mpmath

        with mpmath.workdps(digits + GUARD):
            try:
                return self._solved(mpmath, digits)
            except (*UNDEFINED, np.linalg.LinAlgError):
                return None

    def _solved(self, mpmath: "ModuleType", digits: int) -> LimitPoint | None:
        n, scale = self.n, self.equations.scale
        q, p = [mpmath.mpf(float(x)) for x in self.q], mpmath.mpf(self.p)
        phi, position, last, slopes = [mpmath.mpf(float(x)) for x in self.along], self.position, mpmath.inf, None
        for i in range(ROUNDS):
            r, K, position, values = self.equations.precisely([x * s for x, s in zip(q, scale, strict=True)], p,
                                                              position)
            bent = [sum(x * y for x, y in zip(row, phi, strict=True)) for row in K]
            left = [*r, *bent, (sum(x * float(y) for x, y in zip(phi, self.along, strict=True)) - 1) * self.size]
            if i < RENEWED:
                slopes = self._slopes(np.array(q, float), float(p), np.array(phi, float))
                if slopes is None:
                    return None
            largest = max(map(abs, left))
            if not largest:
                step, length = None, mpmath.mpf(0)
            else:
                step = [mpmath.mpf(float(x)) * largest for x in
                        np.linalg.solve(slopes, [-float(x / largest) for x in left])]
                length = max(map(abs, step))
            if length <= mpmath.mpf(10) ** -(digits + GUARD // 2) * (1 + abs(p) / self.unit):
                error, rest = float(10 * length * self.unit / abs(p)) if p else 0.0, 10.0 ** -(digits + SURE)
                return LimitPoint(p, position, values, error + rest, float(10 * length) + rest)
            if i > RENEWED and length > FASTER * last:
                return None
            last = length
            q = [x + y for x, y in zip(q, step[:n], strict=True)]
            p += step[n] * self.unit
            phi = [x + y for x, y in zip(phi, step[n + 1:], strict=True)]
        return None
