"""Proof that a search has met all zeros of the forces in a box, by interval arithmetic.

Around a zero z let Y ≈ J(z)⁻¹. A box X on which |I − Y J(X)| < 1 holds one zero at most, and one in which Krawczyk's
operator z − Y F(z) + (I − Y J(X)) (X − z) lies holds one (Neumaier 1990, Interval Methods for Systems of Equations,
ch. 5). What such boxes leave is halved until F, or Y F by the theorem of the mean, has no zero on any piece. A piece
about which that cannot be said is a place to search on from.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.mechanics.equilibrium.newton import zero_from
from vibcli.mechanics.linearisation import residual_terms
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.interval_arithmetic import Interval, Intervals, exact, inverse, outward

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.distinct_roots import Found
    from vibcli.mechanics.equilibrium.scaled_forces import Forces
    from vibcli.symbolic.node import Node

BOXES = {1: 50_000, 2: 50_000, 3: 20_000}            # by coordinates
TOGETHER, LEFT, NARROW = 2048, 200, 1e-9            # NARROW: in radians, or sizes of the figure
RADII = 0.5 ** np.arange(0, 40)
ROUNDS, STARTS, SLACK, NEAR = 8, 40, 1e-10, 1e-2
JUMPING = ("sign", *PULSES)


def proved(forces: "Forces", found: "Found") -> bool:
    """Are these (Found) proved to be all zeros of the forces in their box? What turns up on the way is added."""
    if len(forces.names) not in BOXES or forces.looped or found.families:
        return False
    try:
        enclosed = ForceBounds(forces)
    except (KeyError, ArithmeticError):
        return False
    if enclosed.jumps:
        return False
    with forces.work.task("the proof that no equilibrium is missed", BOXES[len(forces.names)]) as task, task.kept():
        return _closed(forces, found, enclosed)
    return False


def _closed(forces: "Forces", found: "Found", enclosed: "ForceBounds") -> bool:
    low, high = found.box
    slack, beside = SLACK * (high - low), []
    for _ in range(ROUNDS):
        centres = [z for place in found.isolated for z in _turned(forces, place.z, found.box)]
        regions = [enclosed.region(z) for z in centres]
        known = [region for region in regions if region is not None] + beside
        left = enclosed.undecided(low - slack, high + slack, known)
        if not len(left):
            return len(known) == len(regions) + len(beside)
        if not _searched_on(forces, found, enclosed, left, known, beside):
            return False
    return False


def _turned(forces: "Forces", z: np.ndarray, box: Sequence[np.ndarray]) -> Iterator[np.ndarray]:
    """z and its places a turn of periodic angles apart, as far as they lie in the box or next to it."""
    turns = product(*((-1, 0, 1) if periodic else (0,) for periodic in forces.periodic))
    for turn in turns:
        there = z + math.tau * np.array(turn)
        if np.all(there > box[0] - NEAR) and np.all(there < box[1] + NEAR):
            yield there


def _searched_on(forces: "Forces", found: "Found", enclosed: "ForceBounds", left: np.ndarray,
                 known: list[tuple[np.ndarray, float]], beside: list[Any]) -> bool:
    """Newton's method from pieces that are left: does it find a zero that is proved and new, in the box or beside it
    (whose region `beside` takes)?"""
    before = found.count + len(beside)
    for z in left[::-(-len(left) // STARTS)]:
        place = zero_from(forces, z, found.box)
        if place is None or not len(outside(place.z[None], place.z[None], known)[0]):
            continue
        region = enclosed.region(place.z)
        if region is None or any(len(outside(other.z[None], other.z[None], [region])[0]) == 0
                                 for other in found.isolated):
            continue
        if not found.add(place) and not found.holds(place):
            beside.append(region)
    return found.count + len(beside) > before


class ForceBounds:
    """Bounds of F and J over boxes of z. `jumps`: do the forces jump somewhere, so that J does not tell of it?"""

    def __init__(self, forces: "Forces") -> None:
        numeric, self.forces = forces.numeric, forces
        scene, form = numeric.scene, numeric.system.linearisation
        q = [scene.q[row] for row in forces.rows]
        terms = residual_terms(form)
        F = [scene.table.total(terms[row]) for row in forces.rows]
        slopes = [gradient(node) for node in F]
        self.nodes = F + [slope.get(symbol, scene.table.zero) for slope in slopes for symbol in q]
        self.of_coordinates, self.symbols = q, [symbol.name for symbol in q]
        self.jumps = any(part.name in JUMPING and any(part.mask & symbol.mask for symbol in q)
                         for part in reachable(F))
        drawn = {name: exact(x) for name, x in numeric.drawn_floats.items()}
        still = {v.name: exact(0.0) for v in scene.v}
        self.values = {**numeric.values(Intervals), scene.time.name: exact(0.0), **still, **drawn}
        self.over(forces.vector(numeric.drawn_floats)[None], forces.vector(numeric.drawn_floats)[None])

    def over(self, low: np.ndarray, high: np.ndarray) -> tuple[list[Interval], list[list[Interval]]]:
        """(F, J) over boxes given by arrays of their corners: a list and a list of rows of Intervals."""
        n, D, E = len(self.symbols), self.forces.D, self.forces.E
        found = self.of(self.nodes, low, high)
        F = [exact(D[i] / E) * found[i] for i in range(n)]
        J = [[exact(D[i] / E) * found[n + i * n + j] * exact(D[j]) for j in range(n)] for i in range(n)]
        return F, J

    def of(self, nodes: "Sequence[Node]", low: np.ndarray, high: np.ndarray) -> list[Interval]:
        """Intervals of expressions over these boxes, whose corners are of the shape (boxes, coordinates)."""
        boxes = {}
        for i, name in enumerate(self.symbols):
            ends = exact(low[:, i]) * exact(self.forces.D[i]), exact(high[:, i]) * exact(self.forces.D[i])
            boxes[name] = outward(ends[0].low, ends[1].high)
        return evaluate(nodes, Intervals, {**self.values, **boxes})

    def region(self, z: np.ndarray) -> tuple[np.ndarray, float] | None:
        """(z, radius) of a box about it that is proved to hold one zero and no other; None where that fails."""
        n, radius = len(z), RADII[:, None]
        F, J = self.over(z[None], z[None])
        at = np.array([[_middle(x)[0] for x in row] for row in J])
        if not np.isfinite(at).all() or abs(np.linalg.det(at)) < 1e-300:
            return None
        Y = np.linalg.inv(at)
        off = np.array([summed(exact(Y[i, k]) * F[k] for k in range(n)).size for i in range(n)])[:, 0].max()
        _, J = self.over(z - radius, z + radius)
        sizes: list[Any] = []
        for i in range(n):
            row = [exact(float(i == j)) - summed(exact(Y[i, k]) * J[k][j] for k in range(n)) for j in range(n)]
            sizes.append(sum(entry.size for entry in row))
        bend = np.max(sizes, axis=0) * (1 + 1e-12)
        single = np.flatnonzero(bend < 1)
        holding = np.flatnonzero(off * (1 + 1e-12) + bend * RADII < RADII * (1 - 1e-12))
        if not len(single) or not len(holding) or holding[-1] < single[0]:
            return None
        return z, RADII[single[0]]

    def undecided(self, low: np.ndarray, high: np.ndarray, regions: Sequence[tuple[np.ndarray, float]]) -> np.ndarray:
        """The middles of the pieces of a box that are too small to be halved, about which nothing is proved."""
        stack, left = [(low[None], high[None])], []
        while stack:
            low, high = stack.pop()
            self.forces.work.step(len(low))
            low, high = outside(*self._open(*outside(low, high, regions)), regions)
            wide = high - low
            small = wide.max(axis=1) < NARROW if len(low) else np.zeros(0, bool)
            left += list(0.5 * (low + high)[small])
            low, high, wide = low[~small], high[~small], wide[~small]
            if len(left) > LEFT:
                break
            if len(low):
                stack += chunks(*halved(low, high, wide))
        return np.array(left)

    def _open(self, low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The boxes on which F may vanish."""
        if not len(low):
            return low, high
        F, J = self.over(low, high)
        may = np.logical_and.reduce([np.broadcast_to(part.holds_zero(), len(low)) for part in F])
        low, high, J = low[may], high[may], [[_taken(x, may) for x in row] for row in J]
        smooth = np.logical_and.reduce([np.isfinite(x.size) for row in J for x in row])     # no pole, no vertical slope
        smooth = np.broadcast_to(smooth, len(low))
        if not smooth.any():
            return low, high
        part = self._contracted(low[smooth], high[smooth], [[_taken(x, smooth) for x in row] for row in J])
        return np.concatenate([low[~smooth], part[0]]), np.concatenate([high[~smooth], part[1]])

    def _contracted(self, low: np.ndarray, high: np.ndarray,
                    J: Sequence[list[Interval]]) -> tuple[np.ndarray, np.ndarray]:
        """The parts of boxes in which F may vanish by the theorem of the mean, 0 = Y F(m) + Y J(X) (x − m), solved for
        each xᵢ in turn."""
        middle, n = 0.5 * (low + high), low.shape[1]
        F, _ = self.over(middle, middle)
        Y = _inverses(np.moveaxis(np.array([[_middle(x) for x in row] for row in J]), 2, 0))
        low, high, may = low.copy(), high.copy(), np.ones(len(low), bool)
        for i in range(n):
            away = [outward(low[:, j] - middle[:, j], high[:, j] - middle[:, j]) for j in range(n)]
            slopes = [summed(exact(Y[:, i, k]) * J[k][j] for k in range(n)) for j in range(n)]
            rest = summed(exact(Y[:, i, k]) * F[k] for k in range(n))
            for j in range(n):
                rest = rest if j == i else rest + slopes[j] * away[j]
            may &= (rest + slopes[i] * away[i]).holds_zero()
            place = exact(middle[:, i]) - rest * inverse(slopes[i])
            low[:, i], high[:, i] = np.maximum(low[:, i], place.low), np.minimum(high[:, i], place.high)
            may &= low[:, i] <= high[:, i]
            low[:, i], high[:, i] = np.minimum(low[:, i], high[:, i]), np.maximum(low[:, i], high[:, i])
        return low[may], high[may]


def outside(low: np.ndarray, high: np.ndarray,
            regions: Sequence[tuple[np.ndarray, float]]) -> tuple[np.ndarray, np.ndarray]:
    """The boxes that lie in none of the regions."""
    inside = np.zeros(len(low), bool)
    for z, radius in regions:
        inside |= np.all((low > z - radius) & (high < z + radius), axis=1)
    return low[~inside], high[~inside]


def halved(low: np.ndarray, high: np.ndarray, wide: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The boxes cut in two across their widest side, twice as many rows."""
    each, side = np.arange(len(low)), wide.argmax(axis=1)
    middle = 0.5 * (low + high)[each, side]
    upper, lower = low.copy(), high.copy()
    lower[each, side] = upper[each, side] = middle
    return np.concatenate([low, upper]), np.concatenate([lower, high])


def chunks(low: np.ndarray, high: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    return [(low[i:i + TOGETHER], high[i:i + TOGETHER]) for i in range(0, len(low), TOGETHER)]


def summed(parts: Iterable[Interval]) -> Interval:
    total, *others = parts
    for part in others:
        total = total + part
    return total


def _middle(interval: Interval) -> np.ndarray:
    with np.errstate(invalid="ignore"):
        return np.atleast_1d(0.5 * (interval.low + interval.high))


def _taken(interval: Interval, which: np.ndarray) -> Interval:
    """An interval of those boxes alone, a constant one at each."""
    return outward(*(np.broadcast_to(end, len(which))[which] for end in (interval.low, interval.high)))


def _inverses(matrices: np.ndarray) -> np.ndarray:
    """The inverses of matrices, the unit matrix for those that have none."""
    with np.errstate(all="ignore"):
        regular = np.isfinite(matrices).all(axis=(1, 2))
        regular[regular] = np.abs(np.linalg.det(matrices[regular])) > 1e-300
    found = np.broadcast_to(np.eye(matrices.shape[1]), matrices.shape).copy()
    found[regular] = np.linalg.inv(matrices[regular])
    return found
