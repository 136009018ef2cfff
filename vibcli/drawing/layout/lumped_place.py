"""Where lumped bodies stand on paper."""

from typing import Any

from vibcli.base.named_tuple import NamedTuple


class LumpedPlace(NamedTuple):
    """Where a lumped body stands: its middle, half its width and height, and whether it turns; `gear`: 1 of one with
    its mate below it, −1 of that, 4 of one between two, 2 of a rack, 3 of a gear on a rack alone."""

    middle: tuple
    half: float
    height: float
    turns: bool
    gear: int = 0


class Layout(NamedTuple):
    """A row on paper: `places` by body, the walls (None where there is none), the height of the highest lane; `kind`
    is "frame" of storeys above one another and "tube" of a column of liquid; `sunk`: how far below the middle of bodies
    its elements are."""

    row: Any
    places: dict
    left: float | None
    right: float | None
    y: float
    top: float
    kind: str = "row"
    sunk: float = 0.0
