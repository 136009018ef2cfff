"""Room on paper: which cells of a fine grid are taken, and where a word or an arrow fits best."""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import pairwise
from math import ceil, cos, floor, hypot, inf, pi, sin
from typing import Any

from vibcli.drawing.canvas.primitives import ARROW, BODY, LEADER, Circle, LetterRuns, Polygon, Run
from vibcli.drawing.layout import lettering

CELL, TAKEN, INKED, FILLED, CLEAR = 2.5, 1000.0, 1.0, 0.02, 1.6
COLUMN = 1_000_003                          # the cell in row j of column i is i * COLUMN + j; odd: hashes differ
FOREIGN = 0.3                               # the cost of a cell inside a body for the name of another
REACHES = (2.0, 4.0, 7.0, 11.0, 16.0, 22.0, 30.0, 40.0, 55.0, 75.0, 100.0, 140.0, 200.0, 280.0)
DIRECTIONS = [(cos(pi * i / 8), sin(pi * i / 8)) for i in (4, 0, 12, 8, 2, 6, 14, 10, 1, 3, 5, 7, 9, 11, 13, 15)]
FARNESS, STRUCK = 0.25, 2.5        # the cost of a point away; by which a line through a word in its body counts more
WORDED = 1.6                                # the cost of an inked cell for a word
KEPT_CLEAR = "spring", "damper", "oil", "rope"  # roles of what no arrow may cross, beside bodies and other arrows
CROSSED = 30.0                              # the cost of a cell of theirs
COILS, COILED = 8, 0.5                      # points of a zigzag, the cost of a cell between its coils
SIDE, WITHIN = 2.0, 1.2                     # points kept from a word to what is beside it, in the body that it names
APART, NEAR = 6.0, 0.9                      # points between words that are not to be read as one, the cost of a cell
THICK = 1.5                                 # points: the width of a line whose edges words keep clear of
ROUNDED = 1e-9                              # by which costs may differ that are added in another order


class Space:
    """The cells that a drawing takes, with the cost of writing over them."""

    def __init__(self, primitives: Sequence[Any] = ()) -> None:
        self.cells, self.barred, self.kept, self.coils, self.beside = {}, set(), set(), set(), set()
        self.add(primitives)

    def add(self, primitives: Any) -> None:
        behind = [part for part in primitives if part.layer < BODY]
        hidden = {key for part in behind for line in _lines(part) for key in _cells_through(line)}
        for part in [*behind, *(part for part in primitives if part.layer >= BODY)]:
            if isinstance(part, LetterRuns):
                self.reserve(part.box)
                continue
            if isinstance(part, (Polygon, Circle)) and part.fill not in (None, "paper"):
                within = _cells_within(part.points)
                self.cells.update(dict.fromkeys(hidden.intersection(within), FILLED) if part.layer == BODY else {})
                self._taken(within, FILLED)
            for line in _lines(part):
                self._taken(_cells_through(line), INKED)
            for stroke in part.strokes():
                keys = _cells_through(stroke)
                if part.role == "spring" and len(stroke) >= COILS:
                    coiled = set(_cells_within([*stroke[1::2], *stroke[2::2][::-1]])) - keys
                    self._taken(coiled, COILED)
                    keys |= coiled
                    self.coils |= coiled | _cells_through(stroke[1:-1])
                if part.role in KEPT_CLEAR or part.layer == ARROW:
                    self.kept |= keys
                    self.barred |= keys
                elif part.layer == LEADER or (part.layer == BODY and getattr(part, "fill", 0)):
                    self.barred |= keys         # leaders may lie on one another

    def _taken(self, keys: Sequence[int] | set[int], cost: float) -> None:
        """Let some cells cost so much at least."""
        cells = self.cells
        for key in keys:
            if cells.get(key, 0.0) < cost:
                cells[key] = cost

    def bar(self, points: Sequence[tuple[float, float]]) -> None:
        """Let no arrow into an outline."""
        self.barred.update(_cells_within(points))

    def reserve(self, box: Sequence[float]) -> None:
        """Take a box for good."""
        left, bottom, right, top = box
        for _, column in _columns((left - APART, bottom, right + APART, top)):
            self.beside.update(column)
        for _, column in _columns((left - CLEAR, bottom - CLEAR, right + CLEAR, top + CLEAR)):
            self.cells.update(dict.fromkeys(column, TAKEN))

    def cost(self, box: Sequence[float], least: float = 0.0, most: float = inf, own: "set[Any] | None" = None) -> float:
        """The cost of writing in a box, as far as it is at `most` that; on the body that is named strokes alone count,
        which cost at `least` 1; beside it, `own` are the cells inside it and inside what it lies on."""
        get, beside, total = self.cells.get, self.beside, 0.0
        left, right = floor(box[0] / CELL), floor(box[2] / CELL)
        side = WITHIN if least else SIDE
        for i, column in _columns((box[0] - side, box[1], box[2] + side, box[3])):
            within = left <= i <= right
            for key in column:
                cost: float = get(key, 0.0)
                if cost == INKED:
                    cost = WORDED
                elif within and cost < NEAR and key in beside:
                    cost = NEAR
                if cost >= least:
                    total += cost
                    if total > most:
                        return total
                if own is not None and cost == FILLED and key not in own:
                    total += FOREIGN
        return total

    def path(self, points: Sequence[tuple[float, float]]) -> float:
        """The cost of a line along a path."""
        get = self.cells.get
        found: float = sum([get(key, 0.0) for key in _cells_of(tuple(points))])
        return found

    def arrow(self, points: Sequence[tuple[float, float]], within: float = FILLED) -> float:
        """The cost of an arrow along a path, which is to cross nothing that is kept clear; `within`: that of a cell
        inside an outline."""
        get = self.cells.get
        return self.crossings(points) + sum([within if (cost := get(key, 0.0)) == FILLED else cost
                                             for key in _cells_of(tuple(points))])

    def crossings(self, points: Sequence[tuple[float, float]]) -> float:
        """The cost of what a path crosses of springs, dampers, ropes, bodies and arrows."""
        return CROSSED * sum(map(self.barred.__contains__, _cells_of(tuple(points))))

    def meets(self, points: Sequence[tuple[float, float]]) -> float:
        """The same of springs, dampers, ropes and arrows alone."""
        return CROSSED * sum(map(self.kept.__contains__, _cells_of(tuple(points))))

    def coiled(self, points: Sequence[tuple[float, float]]) -> float:
        """The same of coils of springs, without the rods at their ends."""
        return CROSSED * sum(map(self.coils.__contains__, _cells_of(tuple(points))))

    def put(self, runs: Sequence[Run], anchors: Sequence[tuple[float, float]], role: str = "ink",
            inside: Sequence[tuple[float, float]] = (), most: float | None = None,
            of: "Sequence[Any] | None" = None) -> LetterRuns:
        """The Text of runs where it fits best near one of the anchors, which then is taken; centred in a place of
        `inside` where it is free. None where it costs more than `most`; `of`: the outlines of the body that it
        names, and of what that lies on."""
        width, height = lettering.size(runs)
        below, above = lettering.slack(runs)
        best, own = None, None if of is None else {key for part in of for key in _cells_within(part.points)}
        for x, y in inside:
            box = x - width / 2, y - height / 2, x + width / 2, y + height / 2
            cost = STRUCK * self.cost(box, 1.0)
            if best is None or cost < best[0]:
                best = cost, box
        for reach in REACHES:
            if best is not None and best[0] <= FARNESS * reach:
                break
            for rank, (dx, dy) in enumerate(DIRECTIONS):
                if best is not None and FARNESS * reach + 0.01 * rank >= best[0]:
                    continue
                for ax, ay in anchors:
                    x, y = ax + dx * (reach + width / 2), ay + dy * (reach + height / 2)
                    box = x - width / 2, y - height / 2, x + width / 2, y + height / 2
                    far = FARNESS * reach + 0.01 * rank
                    inked = box[0], box[1] + below, box[2], box[3] - above
                    cost = self.cost(inked, most=inf if best is None else best[0] - far + ROUNDED, own=own) + far
                    if best is None or cost < best[0]:
                        best = cost, box
        if best is None or (most is not None and best[0] > most):
            return None
        self.reserve(best[1])
        return lettering.text(runs, best[1][0], best[1][1], role)


def _columns(box: tuple[float, float, float, float]) -> Iterator[tuple[int, range]]:
    """(i, its cells in a box) of each column i."""
    left, bottom, right, top = box
    first, last = floor(bottom / CELL), floor(top / CELL) + 1
    for i in range(floor(left / CELL), floor(right / CELL) + 1):
        yield i, range(i * COLUMN + first, i * COLUMN + last)


def _lines(part: Any) -> Iterator[tuple[tuple[float, float], ...]]:
    """The strokes of a primitive, and the edges of one that is straight and thick."""
    for stroke in part.strokes():
        yield stroke
        if len(stroke) == 2 and getattr(part, "width", 0.0) >= THICK:
            yield from (_beside(stroke, side * part.width) for side in (-0.5, 0.5))


def _beside(stroke: tuple[tuple[float, float], tuple[float, float]],
            distance: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """A straight line as far on the left of another."""
    (ax, ay), (bx, by) = stroke
    share = distance / (hypot(bx - ax, by - ay) or 1.0)
    dx, dy = (ay - by) * share, (bx - ax) * share
    return (ax + dx, ay + dy), (bx + dx, by + dy)


@lru_cache(64)      # one line is asked for several costs
def _cells_of(points: tuple[tuple[float, float], ...]) -> list[int]:
    """The cells along a polyline, some of them twice."""
    found = []
    for (ax, ay), (bx, by) in pairwise(points):
        dx, dy = bx - ax, by - ay
        steps = max(1, ceil(hypot(dx, dy) / CELL))
        found += [floor((ax + dx * i / steps) / CELL) * COLUMN + floor((ay + dy * i / steps) / CELL)
                  for i in range(steps + 1)]
    return found


def _cells_through(points: tuple[tuple[float, float], ...]) -> set[int]:
    """All cells that a polyline passes: none that crosses it does so between two of them."""
    ends = [floor(x / CELL) * COLUMN + floor(y / CELL) for x, y in points]
    found = set(ends)
    for i, ((ax, ay), (bx, by)) in enumerate(pairwise(points)):
        if ends[i] == ends[i + 1]:
            continue
        cuts = sorted((0.0, 1.0, *_cuts(ax / CELL, bx / CELL), *_cuts(ay / CELL, by / CELL)))
        for first, last in pairwise(cuts):
            t = (first + last) / 2
            found.add(floor((ax + (bx - ax) * t) / CELL) * COLUMN + floor((ay + (by - ay) * t) / CELL))
    return found


def _cuts(a: float, b: float) -> list[float]:
    """The parts of the way from a to b at which whole numbers lie."""
    return [(i - a) / (b - a) for i in range(ceil(min(a, b)), floor(max(a, b)) + 1)] if a != b else []


def _cells_within(points: Sequence[tuple[float, float]]) -> list[int]:
    """The cells inside an outline, row by row."""
    ys = [y for _, y in points]
    crossed = {j: [] for j in range(ceil(min(ys) / CELL), floor(max(ys) / CELL) + 1)}
    for (ax, ay), (bx, by) in zip(points, [*points[1:], points[0]], strict=True):
        for j in range(floor(min(ay, by) / CELL) - 1, ceil(max(ay, by) / CELL) + 1):
            y = (j + 0.5) * CELL
            if (ay > y) != (by > y) and j in crossed:
                crossed[j].append(ax + (y - ay) * (bx - ax) / (by - ay))
    found = []
    for j, xs in crossed.items():
        xs.sort()
        for left, right in zip(xs[::2], xs[1::2], strict=False):
            found += range(ceil(left / CELL) * COLUMN + j, floor(right / CELL) * COLUMN + j, COLUMN)
    return found
