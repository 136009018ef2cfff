"""The path of equilibria r(q, p) = 0 through one of them, by arc-length (Keller 1977, Riks 1979).

Each step goes along the tangent (q′, p′) of the path and back to it square to that, so that limit points are passed.
Along a path without a branching the determinant of [K ∂r/∂p; q′ p′] keeps its sign: where it changes the path meets
another one, or a step has come upon another one, which is told by halving it.
"""

from collections.abc import Callable, Iterator, Mapping

import numpy as np

from vibcli.analyses.limit_points.equations import ParametricEquilibrium
from vibcli.analyses.limit_points.path_step import PathPoint, PathStep
from vibcli.base.errors import PhysicsError

CORRECTIONS, CONTRACTS, CONVERGED, GOOD = 8, 0.5, 1e-13, 1e-9
NOISE, LEFT = 64 * 2.0**-52, 1e-3       # of the terms of r: its rounding; of a step: what that may amount to
FIRST, SHORTEST, STEPS = 0.01, 1e-10, 2000
STRAIGHT, NEAR, MILD = 0.99, 0.05, 0.998     # cosines of the angle of a step; how far it may miss, relative to it
STRIDE, FAR, TURN = 0.1, 100.0, 2 * np.pi   # of the figure or 1 rad, how far is followed: figures, a full turn
BEYOND, CLIMB, GONE = 1e6, 0.5, 1e-5         # of the size of p: followed so far, a step at most, nothing
ASIDE = 0.03                # of a bracket
LEVEL, CLOSE = 1e-7, 1e-7      # of p′, of a step: a limit point or branching is met
FLAT, RIGID, HALVINGS, APART, AWAY, LEAST, CHANGED = 1e-3, 1e-12, 60, 4.0, 0.3, 1e-4, 0.5


class EquilibriumPath:
    """That of a ParametricEquilibrium through the equilibrium reached at the given values."""

    def __init__(self, equations: ParametricEquilibrium) -> None:
        self.equations, self.n = equations, len(equations.names)
        q = np.array([equations.rest[one] for one in equations.names]) / equations.scale
        self.unit, self.metric, self.ended, self.broken = 1.0, 1.0, "", False
        self._measure(q)
        self.first = self._first(q)

    def _measure(self, q: np.ndarray) -> None:
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

    def _first(self, q: np.ndarray) -> PathPoint:
        y = self._joined(q, self.equations.start)
        found = self._jacobian(y, self.equations.rest)
        if found is None:
            raise PhysicsError("the forces of this scene have no slopes in its equilibrium")
        sizes = np.linalg.svd(found[1], compute_uv=False)
        if sizes[-1] <= RIGID * sizes[0]:
            raise PhysicsError("the equilibrium is no single one: something moves freely, or paths of equilibria cross "
                               "in it", "hold what moves freely, or start from other values of the parameters")
        return self._point(y, found[1], found[2], None)

    def _joined(self, q: np.ndarray, p: float) -> np.ndarray:
        return np.append(q / self.metric, p / self.unit)

    def parted(self, y: np.ndarray) -> tuple[np.ndarray, float]:
        """(q in sizes of the figure, p)."""
        return y[:-1] * self.metric, float(y[-1] * self.unit)

    def _jacobian(self, y: np.ndarray,
                  near: Mapping[str, float]) -> tuple[np.ndarray, np.ndarray, dict[str, float], np.ndarray] | None:
        """(r, [K ∂r/∂p], position, rounding of r) in units of the metric; None where undefined."""
        q, p = self.parted(y)
        found = self.equations.slopes(q, p, near)
        if found is None:
            return None
        rates, position = found
        noise = NOISE * (rates.size + max(self.size, float(np.abs(rates.K).max())) * (1 + float(np.abs(q).max())))
        return rates.r, np.column_stack([rates.K * self.metric, rates.dr * self.unit]), position, noise

    def _point(self, y: np.ndarray, slopes: np.ndarray, position: dict[str, float], before: PathPoint | None,
               moved: float = 0.0) -> PathPoint:
        """With the tangent in the sense of that before, towards growing p where there is none."""
        tangent = np.linalg.svd(slopes)[2][-1]
        if (tangent @ before.tangent if before is not None else tangent[-1]) < 0:
            tangent = -tangent
        sense = int(np.linalg.slogdet(np.vstack([slopes / np.abs(slopes).max(), tangent]))[0])
        eigenvalues = np.linalg.eigvals(slopes[:, :-1])
        unstable = int(((eigenvalues.real < 0) & (eigenvalues.imag == 0)).sum())
        return PathPoint(y, position, tangent, sense, unstable, slopes[:, :-1] / self.metric, moved)

    def corrected(self, point: PathPoint, step: float, corner: bool = False) -> PathPoint | None:
        """The point a step along the tangent and back square to it, beyond a corner at the same q along it; None where
        Newton's method does not contract."""
        self.equations.numeric.work.step()
        start = y = point.y + step * point.tangent
        square = point.tangent * np.append(np.ones(self.n), 0.0 if corner else 1.0)
        last, near = np.inf, point.position
        for _ in range(CORRECTIONS):
            found = self._jacobian(y, near)
            if found is None:
                return None
            r, slopes, near, noise = found
            try:
                change = np.linalg.solve(np.vstack([slopes, square * np.abs(slopes).max()]), np.append(-r, 0.0))
            except np.linalg.LinAlgError:
                return None
            y, length = y + change, float(np.linalg.norm(change))
            small = CONVERGED * (1.0 + float(np.linalg.norm(y)))
            rounding = length <= LEFT * abs(step) and bool((np.abs(r) <= noise).all())
            if length <= small:         # so are K and ∂r/∂p the same
                return self._point(y, slopes, near, point, float(np.linalg.norm(y - start)))
            if rounding:
                found = self._jacobian(y, near)
                return found and self._point(y, found[1], found[2], point, float(np.linalg.norm(y - start)))
            if not np.isfinite(length) or length > CONTRACTS * last:
                return None
            last = length
        return None

    def stretches(self, sense: int) -> Iterator[PathStep]:
        """The steps of the path towards growing p (1) or the other way (−1), as far as it is followed; `ended` tells
        why no further."""
        point, step = self.first, FIRST
        if sense < 0:
            point = point._replace(tangent=-point.tangent, sense=-point.sense)
        begin, way, self.broken = point, 0.0, False
        for _ in range(STEPS):
            step = min(step, self._longest(point))
            found = self.corrected(point, step)
            stretch = None if found is None else self._stretch(point, found, step)
            if stretch is None:
                step /= 3
                if step >= (least := SHORTEST * (1 + float(np.linalg.norm(point.y)))):
                    continue
                stretch, step = self._round_corner(point, 10 * least), FIRST
                if stretch is None:
                    self.ended, self.broken = self._why(point, least)
                    return
            yield stretch
            way += stretch.step
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
        self.ended, self.broken = f"{STEPS} steps were taken", True

    def _round_corner(self, point: PathPoint, step: float) -> PathStep | None:
        """The PathStep past a place where forces bend, on which the tangent turns sharply; None where there is none.
        There too det [K ∂r/∂p; tangent] keeps its sign (Eaves 1976)."""
        found = self.corrected(point, step, True) if self.equations.bends else None
        if found is None or found.moved > APART * step or self.corrected(point, 0.01 * step) is None:
            return None
        if found.sense != point.sense:
            found = found._replace(tangent=-found.tangent, sense=point.sense)
        return PathStep(point, found, step, False, True)

    def _longest(self, point: PathPoint) -> float:
        """No step is longer than a tenth of the figure, 0.1 rad, a third of a long way so far, or half of p."""
        q, p = self.parted(point.y)
        away = np.where(self.equations.angle, 1.0, np.maximum(1.0, 3 * np.abs(q - self.parted(self.first.y)[0]) - 2))
        rate, climb = point.tangent[:-1] * self.metric, abs(point.tangent[-1]) * self.unit
        longest = float((STRIDE * away / np.maximum(np.abs(rate), 1e-300)).min())
        found: float = min(longest, CLIMB * max(abs(p), self.unit) / max(climb, 1e-300))
        return found

    def _stretch(self, point: PathPoint, found: PathPoint, step: float) -> PathStep | None:
        """The PathStep to a point; None where it may lead elsewhere."""
        units = (1.0, self._widened(point), self._narrowed(point))
        if not (all(self._straight(point, found, step, unit) for unit in units) and self._alike(point.K, found.K)):
            return None
        turns = (found.tangent[-1] < 0) != (point.tangent[-1] < 0)
        crossed = found.sense != point.sense
        if abs(found.unstable - point.unstable) > 1 and step > FLAT:
            return None
        if not crossed:
            odd = abs(found.unstable - point.unstable) != turns
            return PathStep(point, found, step, odd and not self._folds(point, found))
        return PathStep(point, found, step, True) if self._crosses(point, found, step) else None

    def _alike(self, one: np.ndarray, other: np.ndarray) -> bool:
        """Does K change by little? Where it changes its sign through infinity no path goes on."""
        largest = max(self.size, float(np.abs(one).max()), float(np.abs(other).max()))
        return float(np.abs(one - other).max()) <= CHANGED * largest

    def _widened(self, point: PathPoint) -> float:
        """The metric far from where the path began, relative to that there: q counts by how far it has gone."""
        away = float(np.abs(point.y[:-1] - self.first.y[:-1]).max()) * self.metric
        return max(1.0, AWAY * min(away, 1.0) / self.metric)

    def _narrowed(self, point: PathPoint) -> float:
        """The metric in which q goes as far as p where it goes less far."""
        return float(np.clip(np.linalg.norm(point.tangent[:-1]) / max(abs(point.tangent[-1]), 1e-300), LEAST, 1.0))

    def _straight(self, point: PathPoint, found: PathPoint, step: float, unit: float) -> bool:
        """Does a step miss by little, and turn by little, where q counts in other units?"""
        weights = np.append(np.full(self.n, 1 / unit), 1.0)
        one, other = weights * point.tangent, weights * found.tangent
        missed = weights * (found.y - point.y) - step * one
        return bool(np.linalg.norm(missed) <= NEAR * step * np.linalg.norm(one)
                    and one @ other >= STRAIGHT * np.linalg.norm(one) * np.linalg.norm(other))

    def _folds(self, point: PathPoint, found: PathPoint) -> bool:
        """Do both lie on one side or is one the limit point itself?"""
        result: bool = min(abs(point.tangent[-1]), abs(found.tangent[-1])) < GOOD
        return result

    def _crosses(self, point: PathPoint, found: PathPoint, step: float) -> bool:
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

    def _closes(self, begin: PathPoint, stretch: PathStep, way: float) -> bool:
        """Does a step pass the place where the path began, the same way?"""
        if way < 4 * stretch.step or begin.tangent @ stretch.end.tangent < STRAIGHT:
            return False
        before, after = ((begin.y - one.y) @ begin.tangent for one in (stretch.start, stretch.end))
        off = begin.y - stretch.start.y - before * begin.tangent
        return before > 0 >= after and float(np.linalg.norm(off)) < NEAR * stretch.step

    def _left(self, point: PathPoint) -> str | None:
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

    def _why(self, point: PathPoint, step: float) -> tuple[str, bool]:
        """(why a path is not followed beyond a point, is that for want of a method?)."""
        ahead = self._jacobian(point.y + step * point.tangent, point.position)
        if ahead is None:
            return "beyond it the forces of this scene are not defined, or its loops cannot close", False
        if abs(self.parted(point.y)[1]) <= GONE * max(abs(self.equations.start), self.unit):
            return f"'{self.equations.name}' vanishes there, and forces have no slopes", False
        return "forces jump there, or the path turns too sharply to be followed", True

    def between(self, stretch: PathStep, wanted: Callable[[PathPoint], float]) -> tuple[PathPoint, float]:
        """The point of a stretch next to where a function changes its sign, and how far that may be."""
        low, high, at_low, at_high = 0.0, stretch.step, wanted(stretch.start), wanted(stretch.end)
        best = stretch.end if abs(at_high) < abs(at_low) else stretch.start
        for i in range(HALVINGS):
            share = at_low / (at_low - at_high) if i % 3 != 2 else 0.5
            middle = low + float(np.clip(share, 0.02, 0.98)) * (high - low)
            point = self.corrected(stretch.start, middle, stretch.corner)
            if point is None:       # a branching itself
                middle += ASIDE * (high - low)
                point = self.corrected(stretch.start, middle, stretch.corner)
            if point is None:
                break
            if stretch.corner and point.sense != stretch.start.sense:
                point = point._replace(tangent=-point.tangent, sense=stretch.start.sense)
            there = wanted(point)
            best = point if abs(there) <= abs(wanted(best)) or abs(there) == 1.0 else best
            if (there < 0) == (at_low < 0):
                low, at_low = middle, there
            else:
                high, at_high = middle, there
            if abs(there) < LEVEL or high - low < CLOSE * stretch.step:
                break
        return best, high - low
