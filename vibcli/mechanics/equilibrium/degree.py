"""The degree of the forces over a box, which the indices of their zeros within it sum to.

Where F is continuous in a box and has no zero on its boundary, its degree is that of every G which points nowhere on
the boundary against F: (1 − t) F + t G leads from one to the other without a zero (Poincaré 1886, Bohl 1904). G is an
affine map near to F there, and on each piece of the boundary some ℓ with ℓ·F > 0 and ℓ·G > 0 is found by interval
arithmetic. An angle over its whole turn has no boundary; with one G cannot have a degree but 0.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.mechanics.equilibrium.completeness import ForceBounds, chunks, halved, summed
from vibcli.mechanics.equilibrium.multistart import spread
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.interval_arithmetic import exact, outward

if TYPE_CHECKING:
    from vibcli.symbolic.interval_arithmetic import Interval
    from vibcli.symbolic.node import Node

NARROW, LEAST, SAMPLES = 1e-4, 1e-9, 12       # NARROW: of the box; LEAST: of what G is steepest along
PARTS = 4000                                  # into which a box is cut to show that a part of F is continuous in it
CONTINUOUS = ("sin", "cos", "sinh", "cosh", "tanh", "exp", "atan", "abs", "min", "max", "ramp")


def degree(enclosed: ForceBounds, low: np.ndarray, high: np.ndarray) -> int | None:
    """The degree of the forces over the box; None where it is not proved."""
    wraps = [_wraps(enclosed, i) for i in range(len(low))]
    if None in wraps or enclosed.jumps or not _continuous(enclosed, low, high):
        return None
    wrapped = np.array(wraps) & (high - low >= math.tau * (1 - 1e-12))
    if wrapped.all():
        return 0
    Y, centre, sign = _reference(enclosed, low, high, ~wrapped)
    if not _Boundary(enclosed, Y, centre, ~wrapped, low, high).one_way():
        return None
    return sign if not wrapped.any() and np.all((low < centre) & (centre < high)) else 0


def _wraps(enclosed: ForceBounds, i: int) -> bool | None:
    """Are the forces, as they are written, the same after a turn of a coordinate? None where floats say so alone."""
    if not enclosed.forces.periodic[i]:
        return False
    angle = enclosed.of_coordinates[i]
    turning = {part: angle.table.zero for part in reachable(enclosed.nodes[:len(enclosed.symbols)])
               if part.op == "call" and part.name in ("sin", "cos") and _whole(part.args[0], angle)}
    rest = substitute(enclosed.nodes[:len(enclosed.symbols)], turning) if turning else enclosed.nodes
    return True if not any(node.mask & angle.mask for node in rest) else None


def _whole(argument: "Node", angle: "Node") -> bool:
    """Is this n·angle + rest with a whole number n, the rest being free of the angle?"""
    if argument.op == "sum":
        times = dict(argument.args).get(angle, 0)
    else:
        times = argument.coefficient if argument.op == "product" and argument.args == ((angle, 1),) else (
            int(argument is angle))
    return bool(times) and times.denominator == 1 and not (argument - times * angle).mask & angle.mask


def _continuous(enclosed: ForceBounds, low: np.ndarray, high: np.ndarray) -> bool:
    """Is each part of F that may have poles or ends bounded? Shown over the coordinates that it depends on."""
    for part in reachable(enclosed.nodes[:len(enclosed.symbols)]):
        smooth = part.name in CONTINUOUS if part.op == "call" else part.op != "product" or all(
            e.denominator == 1 and e > 0 for _, e in part.args)
        if not smooth and not _bounded(enclosed, part, low, high):
            return False
    return True


def _bounded(enclosed: ForceBounds, part: "Node", low: np.ndarray, high: np.ndarray) -> bool:
    felt = np.array([bool(part.mask & symbol.mask) for symbol in enclosed.of_coordinates])
    low, high = low[None], high[None]
    looked = 0
    while len(low):
        looked += len(low)
        if looked > PARTS:
            return False
        enclosed.forces.work.step(len(low))
        left = ~np.broadcast_to(np.isfinite(enclosed.of([part], low, high)[0].size), len(low))
        low, high = low[left], high[left]
        if not felt.any():
            return not len(low)
        low, high = halved(low, high, np.where(felt, high - low, 0.0))
    return True


def _reference(enclosed: ForceBounds, low: np.ndarray, high: np.ndarray,
               bounded: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """(Y, c, sign): Y F is near to x − c along the bounded coordinates x on the boundary, and sign is that of det Y."""
    n = len(low)
    points = []
    for fractions in spread(n, SAMPLES):
        for j in np.flatnonzero(bounded):
            points += [low + (high - low) * np.where(np.arange(n) == j, end, fractions) for end in (0.0, 1.0)]
    points = np.array(points)
    F, _ = enclosed.over(points, points)
    values = np.array([np.broadcast_to(0.5 * (part.low + part.high), len(points)) for part in F]).T
    known = np.isfinite(values).all(axis=1)
    middle = 0.5 * (low + high)
    rows = np.hstack([(points - middle)[:, bounded], np.ones((len(points), 1))])
    fitted = np.linalg.lstsq(rows[known], values[known], rcond=None)[0]
    slopes, rest = fitted[:-1].T, fitted[-1]
    U, sizes, Vt = np.linalg.svd(slopes)
    sizes = np.maximum(sizes, LEAST * max(sizes[0], np.abs(rest).max()) or 1.0)
    M = np.zeros((n, n))
    M[:, bounded] = U[:, :len(sizes)] * sizes @ Vt
    M[:, ~bounded] = U[:, len(sizes):]
    Y = np.linalg.inv(M)
    return Y, middle - np.where(bounded, Y @ rest, 0.0), int(np.linalg.slogdet(M)[0])


class _Boundary:
    """The faces of a box, on which H = Y F is compared with G = x − c along the bounded coordinates, 0 along others."""

    def __init__(self, enclosed: ForceBounds, Y: np.ndarray, centre: np.ndarray, bounded: np.ndarray, low: np.ndarray,
                 high: np.ndarray) -> None:
        self.enclosed, self.Y, self.centre, self.bounded, self.low, self.high = enclosed, Y, centre, bounded, low, high

    def one_way(self) -> bool:
        """Do H and G point nowhere in opposite directions?"""
        stack = []
        for j in np.flatnonzero(self.bounded):
            for end in (self.low[j], self.high[j]):
                face = np.where(np.arange(len(self.low)) == j, end, np.array([self.low, self.high]))
                stack.append((face[:1], face[1:]))
        while stack:
            low, high = stack.pop()
            self.enclosed.forces.work.step(len(low))
            open_, wide = self._open(low, high)
            if not open_.any():
                continue
            low, high, wide = low[open_], high[open_], wide[open_]
            each, side = np.arange(len(low)), wide.argmax(axis=1)
            if np.any((high - low)[each, side] < NARROW * (self.high - self.low)[side]):
                return False
            stack += chunks(*halved(low, high, wide))
        return True

    def _open(self, low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(on which of these pieces no ℓ is found, how much each side of them moves H)."""
        n, middle = low.shape[1], 0.5 * (low + high)
        F, J = self.enclosed.over(low, high)
        at, _ = self.enclosed.over(middle, middle)
        away = [outward(low[:, j] - middle[:, j], high[:, j] - middle[:, j]) for j in range(n)]
        G = [outward(low[:, i] - self.centre[i], high[:, i] - self.centre[i]) if self.bounded[i] else exact(0.0)
             for i in range(n)]

        def along(weights: "Sequence[Interval]") -> "tuple[np.ndarray, np.ndarray, list[float | np.ndarray]]":
            """Bounds of Σ wₖ Fₖ, as it stands and by the theorem of the mean, and |slopes|."""
            plain = summed(w * f for w, f in zip(weights, F, strict=True))
            slopes = [summed(w * J[k][j] for k, w in enumerate(weights)) for j in range(n)]
            mean = summed([summed(w * f for w, f in zip(weights, at, strict=True)),
                           *(s * d for s, d in zip(slopes, away, strict=True))])
            return np.maximum(plain.low, mean.low), np.minimum(plain.high, mean.high), [s.size for s in slopes]

        one_way, moved = np.zeros(len(low), bool), np.zeros((len(low), n))
        for i in range(n):
            least, most, slopes = along([exact(y) for y in self.Y[i]])
            one_way |= ((least > 0) & (G[i].low > 0)) | ((most < 0) & (G[i].high < 0))
            moved += np.array([np.broadcast_to(size, len(low)) for size in slopes]).T
        directions = self._between(at, middle)
        weights = [summed(exact(directions[:, i]) * exact(self.Y[i, k]) for i in range(n)) for k in range(n)]
        least, _, _ = along(weights)
        one_way |= (least > 0) & (summed(exact(directions[:, i]) * G[i] for i in range(n)).low > 0)
        moved = np.where(np.isfinite(moved), moved, 1.0) * (high - low)
        return ~one_way, np.where(moved.any(axis=1)[:, None], moved, high - low)

    def _between(self, at: "Sequence[Interval]", middle: np.ndarray) -> np.ndarray:
        """Halfway between the directions of H and G in the middle of each piece."""
        F = np.array([np.broadcast_to(0.5 * (part.low + part.high), len(middle)) for part in at])
        found = []
        for vectors in ((self.Y @ F).T, np.where(self.bounded, middle - self.centre, 0.0)):
            with np.errstate(all="ignore"):
                found.append(np.nan_to_num(vectors / np.linalg.norm(vectors, axis=1)[:, None]))
        result: np.ndarray = found[0] + found[1]
        return result
