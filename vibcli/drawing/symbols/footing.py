"""Where what slides on the level stands: rollers and pieces of floor beside the springs that lead down from it."""

from collections.abc import Sequence
from math import hypot
from typing import TYPE_CHECKING

from vibcli.drawing.canvas.primitives import DEPTH
from vibcli.drawing.symbols.support import ROLLER

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch

EDGE, BESIDE, INNER, STEP, FAR = 6.0, 8.5, 5.0, 2.0, 60.0       # points: of a roller from the edge of a body
SHORT = 8.0         # of what is no floor

Gap = tuple[float, float]


def gaps(name: str, bottom: float, sketch: "Sketch") -> list[Gap]:
    """[(from, to)] where springs and dampers lead from a body down through the floor, with room for their coils."""
    low, found = bottom - 2 * ROLLER - DEPTH, []
    for record in sketch.spec.connections:
        ends = [sketch.attachment(end) for end in record.get("between", ())]
        for one, other in zip(ends, ends[::-1], strict=True):
            if None not in ends and one.carrier == name and other.drawn[1] < low < one.drawn[1]:
                (x, y), (u, v) = one.drawn, other.drawn
                xs = [x + (u - x) * (level - y) / (v - y) for level in (bottom, low)]
                room = BESIDE * hypot(u - x, v - y) / (y - v)
                found.append((min(xs) - room, max(xs) + room))
    return found


def stance(middle: float, half: float, among: Sequence[Gap]) -> float:
    """How far to either side of its middle the rollers of a body stand, `half` being half its width: near its edges,
    further in, or beyond them where there is no room under it."""
    usual = max(half - EDGE, 0.0)
    inner = [usual - i * STEP for i in range(int((usual - INNER) / STEP) + 1)]
    for far in (*inner, *(usual + i * STEP for i in range(1, int(FAR / STEP)))):
        if all(not low < middle + side * far + nudge < high for low, high in among for side in (-1, 1)
               for nudge in (-ROLLER, ROLLER)):
            return far
    return usual


def floors(low: float, high: float, among: Sequence[Gap]) -> list[Gap]:
    """The pieces of a floor between two places that nothing leads through."""
    found = []
    for start, end in sorted(among):
        found.append((low, min(start, high)))
        low = max(low, end)
    return [(a, b) for a, b in (*found, (low, high)) if b - a > SHORT]
