"""Where lumped bodies stand on paper."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import inf
from typing import Any

from vibcli.base.named_tuple import NamedTuple

KEPT = 11.0         # points of a gap in which a spring is seen as one


class LumpedPlace(NamedTuple):
    """Where a lumped body stands: its middle, half its width and height, and whether it turns; `gear`: 1 of one with
    its mate below it, −1 of that, 4 of one between two, 2 of a rack, 3 of a gear on a rack alone."""

    middle: tuple[float, float]
    half: float
    height: float
    turns: bool
    gear: int = 0

    @property
    def leg(self) -> float:
        """How far from its middle what runs over others stands on it."""
        return max(self.half - 6, 0.0)


class Layout(NamedTuple):
    """A row on paper: `places` by body, the walls (None where there is none), the height of the highest lane; `kind`
    is "frame" of storeys above one another and "tube" of a column of liquid; `sunk`: how far below the middle of bodies
    its elements are."""

    row: Any
    places: dict[str, LumpedPlace]
    left: float | None
    right: float | None
    y: float
    top: float
    kind: str = "row"
    sunk: float = 0.0


def most(layouts: Sequence[Layout], positions: Sequence[Mapping[str, float]]) -> float:
    """The points for one metre up to which bodies in rows that move so far in each of some positions keep apart from
    one another and from walls."""
    found = inf
    for layout in layouts:
        for (one, end), (other, start) in pairwise(_edges(layout)) if layout.kind == "row" else ():
            closer = max(position.get(one, 0.0) - position.get(other, 0.0) for position in positions)
            if closer > 0.0:
                found = min(found, max(start - end - KEPT, 0.0) / closer)
    return found


def _edges(layout: Layout) -> list[tuple[str, float]]:
    """[(a body that slides, its left edge), (the same, its right edge), …] from wall to wall, without name."""
    found = [("", layout.left)] if layout.left is not None else []
    for name in layout.row.bodies:
        place = layout.places[name]
        if not place.turns:
            found += [(name, place.middle[0] - place.half), (name, place.middle[0] + place.half)]
    return [*found, *([("", layout.right)] if layout.right is not None else [])]
