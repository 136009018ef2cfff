"""The path of equilibria r(q, p) = 0 through one of them, by arc-length (Keller 1977, Riks 1979).

Each step goes along the tangent (q′, p′) of the path and back to it square to that, so that limit points are passed.
Along a path without a branching the determinant of [K ∂r/∂p; q′ p′] keeps its sign: where it changes the path meets
another one, or a step has come upon another one, which is told by halving it.
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from vibcli.analyses.limit_points.equations import ParametricEquilibrium
from vibcli.base.errors import PhysicsError

CORRECTIONS, CONTRACTS, CONVERGED, GOOD = 8, 0.5, 1e-13, 1e-9
FIRST, SHORTEST, STEPS = 0.01, 1e-8, 2000
STRAIGHT, NEAR, MILD = 0.97, 0.1, 0.995     # cosines of the angle of a step; how far it may miss, relative to it
STRIDE, FAR, TURN = 0.1, 100.0, 2 * np.pi   # of the figure or 1 rad, how far is followed: figures, a full turn
BEYOND, CLIMB = 1e6, 0.5                    # of the size of p; how much of it a step may be
FLAT, RIGID, HALVINGS, APART = 1e-3, 1e-12, 60, 4.0


class PathPoint(NamedTuple):
    """An equilibrium of the path: y = (q, p) in units of the metric, {coordinate: float}, the tangent, the sign of
    det [K ∂r/∂p; tangent], how many eigenvalues of K are negative, how far Newton's method moved."""

    y: np.ndarray
    position: dict
    tangent: np.ndarray
    sense: int
    unstable: int
    moved: float = 0.0


class Stretch(NamedTuple):
    """A step from one point to another. `branching`: do other paths cross it? `corner`: does it bend sharply there?"""

    start: PathPoint
    end: PathPoint
    step: float
    branching: bool
    corner: bool = False


class EquilibriumPath:
    """That of a ParametricEquilibrium through the equilibrium reached at the given values."""

    def __init__(self, equations: ParametricEquilibrium):
        self.equations, self.n = equations, len(equations.names)
        q = np.array([equations.rest[one] for one in equations.names]) / equations.scale
        self.unit, self.metric, self.ended = 1.0, 1.0, ""
        self._measure(q)
        self.first = self._first(q)

    def _measure(self, q):
        """Units of p and q in which the path bends about as much as it is long: the p at which K would be singular if
        it went on as it goes, and how far q goes with it."""
        eq = self.equations
        found = eq.rates(q, eq.start, None, 1.0, eq.rest)
        if found is None:
            raise PhysicsError(f"the forces of this scene have no slopes by '{eq.name}' in its equilibrium",
                               "where a force bends or jumps no path of equilibria is followed")
        rates = found[0]
        self.size = float(np.abs(rates.K).max(initial=0.0))
        if not (rates.dr.any() or rates.dK.any()):
            raise PhysicsError(f"the equilibrium does not depend on '{eq.name}': no two of its equilibria meet as that "
                               "changes", "ask about a parameter of a load, a spring or a length")
        self.unit = abs(eq.start) or 1.0
        if not self.size or np.linalg.cond(rates.K) > 1 / RIGID:
            return
        along = -np.linalg.solve(rates.K, rates.dr)
        further = eq.rates(q, eq.start, along, 1.0, eq.rest)
        fastest = 0.0 if further is None else float(np.abs(np.linalg.eigvals(
            np.linalg.solve(rates.K, further[0].dK))).max())
        way = float(np.linalg.norm(along))
        if fastest * max(abs(eq.start), 1 / (way or np.inf)) > 1e-9:
            self.unit = 1 / fastest
        elif way:
            self.unit = 1 / way
        self.metric = float(np.clip(way * self.unit, FLAT, 1.0))

    def _first(self, q):
        y = self._joined(q, self.equations.start)
        found = self._jacobian(y, self.equations.rest)
        if found is None:
            raise PhysicsError("the forces of this scene have no slopes in its equilibrium")
        sizes = np.linalg.svd(found[1], compute_uv=False)
        if sizes[-1] <= RIGID * sizes[0]:
            raise PhysicsError("the equilibrium is no single one: something moves freely, or paths of equilibria cross "
                               "in it", "hold what moves freely, or start from other values of the parameters")
        return self._point(y, found[1], found[2], None)

    def _joined(self, q, p):
        return np.append(q / self.metric, p / self.unit)

    def parted(self, y: np.ndarray) -> tuple[np.ndarray, float]:
        """(q in sizes of the figure, p)."""
        return y[:-1] * self.metric, float(y[-1] * self.unit)

    def _jacobian(self, y, near):
        """(r, [K ∂r/∂p], position) in units of the metric; None where undefined."""
        q, p = self.parted(y)
        found = self.equations.rates(q, p, None, 1.0, near)
        if found is None:
            return None
        rates, position = found
        return rates.r, np.column_stack([rates.K * self.metric, rates.dr * self.unit]), position

    def _point(self, y, slopes, position, before, moved=0.0):
        """With the tangent in the sense of that before, towards growing p where there is none."""
        tangent = np.linalg.svd(slopes)[2][-1]
        if (tangent @ before.tangent if before is not None else tangent[-1]) < 0:
            tangent = -tangent
        sense = int(np.linalg.slogdet(np.vstack([slopes / np.abs(slopes).max(), tangent]))[0])
        eigenvalues = np.linalg.eigvals(slopes[:, :-1])
        unstable = int(((eigenvalues.real < 0) & (eigenvalues.imag == 0)).sum())
        return PathPoint(y, position, tangent, sense, unstable, moved)

    def corrected(self, point: PathPoint, step: float) -> PathPoint | None:
        """The point a step along the tangent and back square to it; None where Newton's method does not contract."""
        start = y = point.y + step * point.tangent
        last, near = np.inf, point.position
        for _ in range(CORRECTIONS):
            found = self._jacobian(y, near)
            if found is None:
                return None
            r, slopes, near = found
            try:
                change = np.linalg.solve(np.vstack([slopes, point.tangent * np.abs(slopes).max()]), np.append(-r, 0.0))
            except np.linalg.LinAlgError:
                return None
            y, length = y + change, float(np.linalg.norm(change))
            small = CONVERGED * (1.0 + float(np.linalg.norm(y)))
            if length <= small or (length <= GOOD * abs(step) and length > CONTRACTS * last):
                found = self._jacobian(y, near)
                return found and self._point(y, found[1], found[2], point, float(np.linalg.norm(y - start)))
            if not np.isfinite(length) or length > CONTRACTS * last:
                return None
            last = length
        return None

    def stretches(self, sense: int) -> Iterator[Stretch]:
        """The steps of the path towards growing p (1) or the other way (−1), as far as it is followed; `ended` tells
        why no further."""
        point, step = self.first, FIRST
        if sense < 0:
            point = point._replace(tangent=-point.tangent, sense=-point.sense)
        begin, way = point, 0.0
        for _ in range(STEPS):
            step = min(step, self._longest(point))
            found = self.corrected(point, step)
            stretch = None if found is None else self._stretch(point, found, step)
            if stretch is None:
                step /= 3
                if step < SHORTEST * (1 + float(np.linalg.norm(point.y))):
                    self.ended = self._why(point, step)
                    return
                continue
            yield stretch
            way += step
            point = stretch.end
            if self._closes(begin, stretch, way):
                self.ended = "the path of equilibria closes there"
                return
            if (why := self._left(point)) is not None:
                self.ended = why
                return
            turned = stretch.start.tangent @ point.tangent
            if turned > MILD and point.moved < 0.25 * NEAR * step:
                step *= 2
        self.ended = f"{STEPS} steps were taken"

    def _longest(self, point):
        """No step is longer than a tenth of the figure, 0.1 rad, or of the way so far, or half of p."""
        q, p = self.parted(point.y)
        away = np.where(self.equations.angle, 1.0, np.maximum(1.0, np.abs(q - self.parted(self.first.y)[0])))
        rate, climb = point.tangent[:-1] * self.metric, abs(point.tangent[-1]) * self.unit
        longest = float((STRIDE * away / np.maximum(np.abs(rate), 1e-300)).min())
        return min(longest, CLIMB * max(abs(p), self.unit) / max(climb, 1e-300))

    def _stretch(self, point, found, step):
        """The Stretch to a point; None where it may lead elsewhere."""
        if found.moved > NEAR * step or point.tangent @ found.tangent < STRAIGHT:
            return None
        turns = (found.tangent[-1] < 0) != (point.tangent[-1] < 0)
        crossed = found.sense != point.sense
        if abs(found.unstable - point.unstable) > 1 and step > FLAT:
            return None
        if not crossed:
            odd = abs(found.unstable - point.unstable) != turns
            return Stretch(point, found, step, odd and not self._folds(point, found))
        return Stretch(point, found, step, True) if self._crosses(point, found, step) else None

    def _folds(self, point, found):
        """Do both lie on one side or is one the limit point itself?"""
        return min(abs(point.tangent[-1]), abs(found.tangent[-1])) < GOOD

    def _crosses(self, point, found, step):
        """Is there a branching between two points, and not a gap from one path to another?"""
        low, high, a, b = 0.0, step, point, found
        for _ in range(HALVINGS):
            if high - low <= 1e-9 * step:
                break
            middle = self.corrected(point, 0.5 * (low + high))
            if middle is None:
                return True if high - low <= 1e-6 * step else float(np.linalg.norm(b.y - a.y)) <= APART * (high - low)
            if middle.sense == point.sense:
                low, a = 0.5 * (low + high), middle
            else:
                high, b = 0.5 * (low + high), middle
            if float(np.linalg.norm(b.y - a.y)) > APART * (high - low) + GOOD * (1 + float(np.linalg.norm(a.y))):
                return False
        return True

    def _closes(self, begin, stretch, way):
        """Does a step pass the place where the path began, the same way?"""
        if way < 4 * stretch.step or begin.tangent @ stretch.end.tangent < STRAIGHT:
            return False
        before, after = ((begin.y - one.y) @ begin.tangent for one in (stretch.start, stretch.end))
        off = begin.y - stretch.start.y - before * begin.tangent
        return before > 0 >= after and float(np.linalg.norm(off)) < NEAR * stretch.step

    def _left(self, point):
        """Why the path is followed no further than a point; None where it is."""
        q, p = self.parted(point.y)
        away = np.abs(q - self.parted(self.first.y)[0])
        for one, angle, far in zip(self.equations.names, self.equations.angle, away, strict=True):
            if far > (TURN if angle else FAR):
                return f"'{one}' has made a full turn there" if angle else (
                    f"'{one}' has gone by {FAR:.0f} times the size of the figure there")
        if abs(p) > BEYOND * max(abs(self.equations.start), self.unit):
            return f"'{self.equations.name}' is {BEYOND:.0e} times as large as it was"
        return None

    def _why(self, point, step):
        ahead = self._jacobian(point.y + step * point.tangent, point.position)
        if ahead is None:
            return "beyond it the forces of this scene are not defined, or its loops cannot close"
        return "forces bend or jump there"

    def between(self, stretch: Stretch, wanted: Callable[[PathPoint], float]) -> PathPoint:
        """The point of a stretch at which a function changes its sign, to about 1e-6 of it."""
        low, high, best = 0.0, stretch.step, stretch.start
        at_low, at_high = wanted(stretch.start), wanted(stretch.end)
        if abs(at_high) < abs(at_low):
            best = stretch.end
        for i in range(HALVINGS):
            share = at_low / (at_low - at_high) if i % 3 != 2 and at_low != at_high else 0.5
            middle = low + float(np.clip(share, 0.02, 0.98)) * (high - low)
            point = self.corrected(stretch.start, middle)
            if point is None:
                return best
            there = wanted(point)
            if abs(there) <= abs(wanted(best)):
                best = point
            if (there < 0) == (at_low < 0):
                low, at_low = middle, there
            else:
                high, at_high = middle, there
            if abs(there) < 1e-7 or high - low < 1e-7 * stretch.step:
                break
        return best
