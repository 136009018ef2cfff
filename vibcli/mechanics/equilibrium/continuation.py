"""An equilibrium followed as a parameter p goes: r(q, p) = 0, by tangent steps that Newton's method corrects.

A step is halved until Newton's method contracts from the start, so that no other branch is taken for this one. Where
the steps shrink the branch turns back (a fold: K v = 0 there, wᵀ∂r/∂p ≠ 0), runs off, or ends. A fold is solved for
with its null vector, r = 0, K v = 0, l·v = 1, which is regular where the fold is a simple one (Keller 1977).
"""

from collections.abc import Mapping
from fractions import Fraction
from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats, multiprecision

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.numeric_system import NumericSystem

CONTRACTS, CORRECTIONS, CONVERGED = 0.3, 12, 1e-12
SHORTEST, STEPS = 2.0**-24, 400         # of the way that is to be followed
APPROACH = 1e-6
DIFFERENCE, REGULAR, SETTLED = 1e-6, 1e-9, 1e-8
FINER = 40              # digits in which the forces at a fold are known beside their rounding


class BranchPoint(NamedTuple):
    """An equilibrium of the branch: p, scaled coordinates, {coordinate: float}, and K in scaled coordinates."""

    value: float
    q: Any
    position: dict[str, float]
    K: Any


class Followed(NamedTuple):
    """The last place reached, whether that is the one asked for, all places of the way."""

    place: BranchPoint
    arrived: bool
    way: tuple[BranchPoint, ...]


class Branch:
    """The equilibria of a system as one parameter goes."""

    def __init__(self, numeric: "NumericSystem", name: str) -> None:
        import numpy as np

        self.np, self.numeric, self.name = np, numeric, name
        self.names = numeric.scene.coordinates
        self.scale = np.array(list(map(numeric.size_along, self.names)))
        self.size: float | None = None
        self._floats: dict[Any, dict[str, float]] = {}

    def floats(self, value: Any) -> dict[str, float]:
        """The parameters where the one that goes has this value, at t = 0."""
        if value not in self._floats:
            numeric = self.numeric.sharing({self.name: Fraction(value)})
            self._floats[value] = {**numeric.floats, numeric.scene.time.name: 0.0}
        return self._floats[value]

    def start(self, value: Any, position: Any) -> BranchPoint | None:
        """The Place of an equilibrium that was found, polished; None where it is none."""
        q = self.np.array([position[name] for name in self.names]) / self.scale
        found = self.forces(value, q, position, value)
        if found is None:
            return None
        drawn = self.numeric.drawn_floats
        known = self.forces(value, self.np.array([drawn[name] for name in self.names]) / self.scale, drawn, value)
        self.size = max(float(abs(part[1]).max()) for part in (found, known) if part is not None) or 1.0
        return self.corrected(value, BranchPoint(value, q, position, found[1]), q, 1e-3)

    def forces(self, value: float, q: "np.ndarray", near: Any,
               of: Any) -> "tuple[np.ndarray, np.ndarray, dict[str, float]] | None":
        """(r, K, position) in scaled coordinates; None where they are not defined. `near`: a position closed for the
        value `of`."""
        self.numeric.work.step()
        target = dict(zip(self.names, map(float, q * self.scale), strict=True))
        floats, loops = self.floats(value), self.numeric.scene.loops
        if loops is not None:
            closed = loops.followed({**self.floats(of), **near}, {**floats, **near, **target})
            if closed is None:
                return None
            target = {name: closed[name] for name in near}
        try:
            numbers = in_numbers(self.numeric.system.statics, Floats, {**floats, **target})
        except (ArithmeticError, ValueError, PhysicsError):
            return None
        r = self.np.array(numbers.residual, float) * self.scale
        K = numbers.elements.stiffness_array() * self.np.outer(self.scale, self.scale)
        return (r, K, target) if self.np.isfinite(r).all() and self.np.isfinite(K).all() else None

    def corrected(self, value: Any, place: Any, q: "np.ndarray", reach: float | Fraction) -> BranchPoint | None:
        """The Place at a value by Newton's method from q, if it contracts and ends within `reach` of q; else None."""
        np, last, start = self.np, None, q
        near, of = place.position, place.value
        for _ in range(CORRECTIONS):
            found = self.forces(value, q, near, of)
            if found is None:
                return None
            r, K, near = found
            of = value
            try:
                step = np.linalg.solve(K, -r)
            except np.linalg.LinAlgError:
                return None
            length = float(np.linalg.norm(step))
            if not isfinite(length) or (last is not None and length > max(CONTRACTS * last, self._tiny(q))):
                return None
            q, last = q + step, length
            if float(np.linalg.norm(q - start)) > reach:
                return None
            if length <= self._tiny(q):
                found = self.forces(value, q, near, of)
                return found and BranchPoint(value, q, found[2], found[1])
        return None

    def _tiny(self, q: "np.ndarray") -> float:
        return CONVERGED * (1.0 + float(self.np.linalg.norm(q)))

    def tangent(self, place: Any) -> "np.ndarray | None":
        """dq/dp at a place, by coordinate; None where the branch has none."""
        slope = self.load(place)
        try:
            return None if slope is None else self.np.linalg.solve(place.K, -slope)
        except self.np.linalg.LinAlgError:
            return None

    def load(self, place: Any) -> "np.ndarray | None":
        """∂r/∂p at a place, by coordinate."""
        h = DIFFERENCE * (abs(place.value) or 1.0)
        sides = [self.forces(place.value + sign * h, place.q, place.position, place.value) for sign in (1, -1)]
        found: np.ndarray | None = None if None in sides else (sides[0][0] - sides[1][0]) / (2 * h)
        return found

    def followed(self, place: Any, target: Any) -> Followed:
        """The Followed from a place towards a value."""
        whole = target - place.value
        step, way = whole, [place]
        for _ in range(STEPS):
            if place.value == target or abs(step) < SHORTEST * abs(whole):
                break
            value = target if abs(target - place.value) <= abs(step) else place.value + step
            slope = self.tangent(place)
            found = None
            if slope is not None:
                ahead = slope * (value - place.value)
                reach = 0.5 * float(self.np.linalg.norm(ahead)) + 1e-6
                found = self.corrected(value, place, place.q + ahead, reach)
            if found is None or not self._turned_little(place, found):
                step *= 0.5
                continue
            place, step = found, 2 * step
            way.append(place)
        return Followed(place, place.value == target, tuple(way))

    def _turned_little(self, place: BranchPoint, found: BranchPoint) -> bool:
        """Does the stiffness change by less than its size on the way: no more than one change of stability?"""
        return bool(abs(found.K - place.K).max() <= 0.5 * max(self.size, abs(place.K).max()))

    def alike(self, one: Mapping[str, float], other: Mapping[str, float]) -> bool:
        """Are two positions one?"""
        a, b = ([position[name] / size for name, size in zip(self.names, self.scale, strict=True)]
                for position in (one, other))
        return all(abs(x - y) <= APPROACH * (1 + abs(x)) for x, y in zip(a, b, strict=True))

    def fold(self, place: Any) -> BranchPoint | None:
        """The Place of a simple fold near by that Newton's method reaches from a place; None of none."""
        np = self.np
        along = np.linalg.svd(place.K)[2][-1]
        unit = abs(place.value) or 1.0
        y, last = np.concatenate([place.q, [place.value / unit], along]), None
        for _ in range(2 * CORRECTIONS):
            F = self._singular(y, unit, along, place)
            slopes = None if F is None else self._slopes(y, unit, along, place)
            if slopes is None or np.linalg.cond(slopes) > 1 / REGULAR**1.5:
                return None
            step = np.linalg.solve(slopes, -F)
            y, length = y + step, float(np.linalg.norm(step))
            if length <= 10 * self._tiny(y) or (last is not None and last < SETTLED and length >= last):
                return self._verified(y, unit, along, place)
            last = length
        return None

    def _singular(self, y: "np.ndarray", unit: float, along: "np.ndarray", place: BranchPoint) -> "np.ndarray | None":
        """(r, K v, l·v − 1), relative to the size of K."""
        n = len(self.names)
        q, value, v = y[:n], float(y[n] * unit), y[n + 1:]
        found = self.forces(value, q, place.position, place.value)
        return None if found is None else self.np.concatenate([found[0] / self.size, found[1] @ v / self.size,
                                                               [along @ v - 1.0]])

    def _slopes(self, y: "np.ndarray", unit: float, along: "np.ndarray", place: BranchPoint) -> "np.ndarray | None":
        columns = []
        for j in range(len(y)):
            h = self.np.zeros(len(y))
            h[j] = DIFFERENCE * max(1.0, abs(y[j]))
            sides = [self._singular(y + sign * h, unit, along, place) for sign in (1, -1)]
            if any(side is None for side in sides):
                return None
            columns.append((sides[0] - sides[1]) / (2 * h[j]))
        return self.np.array(columns).T

    def _verified(self, y: "np.ndarray", unit: float, along: "np.ndarray", place: BranchPoint) -> BranchPoint | None:
        """The Place where r and K v vanish and the load works along the left null vector: no branching."""
        np, n = self.np, len(self.names)
        value = float(y[n] * unit)
        if float(np.abs(self._singular(y, unit, along, place)).max()) > REGULAR:
            return None
        _, K, position = self.forces(value, y[:n], place.position, place.value)
        found = BranchPoint(value, y[:n], position, K)
        w, load = np.linalg.svd(K)[0][:, -1], self.load(found)
        if load is None or abs(w @ load) <= 1e-6 * float(np.linalg.norm(load)):
            return None
        return found._replace(value=value - self._rest_along(w, found) / float(w @ load))

    def _rest_along(self, w: "np.ndarray", place: BranchPoint) -> float:
        """wᵀ r at a fold in numbers of more digits: as wᵀ K = 0, the value moves by what rounding left of it alone, and
        the place no more than that squared; 0 where loops close in floats."""
        import mpmath

        if self.numeric.scene.loops is not None:
            return 0.0
        with mpmath.workdps(FINER):
            arithmetic = multiprecision()
            known = self.numeric.sharing({self.name: Fraction(place.value)}).values(arithmetic)
            place_there = {name: mpmath.mpf(x) for name, x in place.position.items()}
            numbers = in_numbers(self.numeric.system.statics, arithmetic,
                                 {**known, self.numeric.scene.time.name: mpmath.mpf(0), **place_there})
            return float(sum(x * y for x, y in zip(w * self.scale, numbers.residual, strict=True)))
