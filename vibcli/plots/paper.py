"""From a panel to its paper: strokes of finite points, logarithms taken where the axis is log, and the ranges shown."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.plots.words import printable

if TYPE_CHECKING:
    import numpy as np

    from vibcli.plots.figure import Curve, Figure, Panel

LARGEST, SMALLEST = 1e300, 1e-290      # beyond: no place; zero
MOST_DECADES = 12
MOST_PANELS = 40


class Axis(NamedTuple):
    """What an axis shows; of a log axis the decades."""

    low: float
    high: float
    log: bool = False
    degrees: bool = False

    def part(self, place: float) -> float:
        """0 at the low end, 1 at the high end."""
        return (place - self.low) / (self.high - self.low)

    def place(self, value: float) -> float:
        """Where a value stands; None for one that has no place."""
        return _places((value,), self.log)[0]

    def value(self, place: float) -> float:
        """What stands at a place."""
        return 10.0 ** place if self.log else place


class Sheet(NamedTuple):
    """A panel with its axes; `strokes`: for each curve its unbroken runs of points (x, y); `last`: of those that share
    their x it carries the numbers; `legend`: it tells the names of its curves, which none above it does."""

    panel: Any
    x: Axis
    y: Axis
    strokes: tuple[Any, ...]
    last: bool
    legend: bool


def sheets(figure: "Figure") -> list[Sheet]:
    """The sheets of a figure, all texts on them printable; neighbours with the same x share its range."""
    panels = [_printable(panel) for panel in figure.panels]
    if len(panels) > MOST_PANELS:
        raise PhysicsError(f"a figure of {len(panels)} panels is too large, {MOST_PANELS} are the most",
                           "show fewer signals or modes at once")
    drawn = [tuple(_strokes(curve, panel) for curve in panel.curves) for panel in panels]
    points = [[point for runs in strokes for run in runs for point in run] for strokes in drawn]
    ranges = [_limits([x for x, _ in found], panel.x_log, panel.x_range)
              for panel, found in zip(panels, points, strict=True)]
    heights = [_limits([y for _, y in found], panel.y_log, panel.y_range)
               for panel, found in zip(panels, points, strict=True)]
    return [Sheet(panel, Axis(*_shared(panels, ranges, i), panel.x_log),
                  Axis(*heights[i], panel.y_log, panel.degrees), drawn[i],
                  not _shares_x(panel, *panels[i + 1:i + 2]), not _repeats(panel, *panels[max(i - 1, 0):i]))
            for i, panel in enumerate(panels)]


def _printable(panel: "Panel") -> "Panel":
    def curve(one: "Curve") -> "Curve":
        return one._replace(label=printable(one.label), names=tuple(map(printable, one.names)))

    return panel._replace(
        x_label=printable(panel.x_label), y_label=printable(panel.y_label), curves=tuple(map(curve, panel.curves)),
        marks=tuple(mark._replace(label=printable(mark.label)) for mark in panel.marks))


def _shares_x(panel: "Panel", other: "Panel | None" = None) -> bool:
    """Can it stand above or below the other, if there is one, with one set of ticks?"""
    return other is not None and (panel.x_label, panel.x_log) == (other.x_label, other.x_log) and not (
        panel.equal or other.equal)


def _repeats(panel: "Panel", above: "Panel | None" = None) -> bool:
    """Are its curves those of the panel above, which has the legend?"""
    return _shares_x(panel, above) and [(c.label, c.kind) for c in panel.curves] == [
        (c.label, c.kind) for c in above.curves]


def _shared(panels: "list[Panel]", ranges: list[tuple[float, float]], i: int) -> tuple[float, float]:
    first = last = i
    while first > 0 and _shares_x(panels[first - 1], panels[i]):
        first -= 1
    while last + 1 < len(panels) and _shares_x(panels[last + 1], panels[i]):
        last += 1
    group = ranges[first:last + 1]
    return min(low for low, _ in group), max(high for _, high in group)


def _places(values: "Sequence[float] | np.ndarray", log: bool) -> list[float]:
    """Where numbers stand on an axis; None where they stand nowhere."""
    values = map(float, values)
    if log:
        return [math.log10(value) if 0 < value < math.inf else None for value in values]
    return [0.0 if -SMALLEST < value < SMALLEST else value if -LARGEST < value < LARGEST else None for value in values]


def _strokes(curve: "Curve", panel: "Panel") -> list[list[tuple[float, float]]]:
    xs, ys = _places(curve.x, panel.x_log), _places(curve.y, panel.y_log)
    if xs and None not in xs and None not in ys:
        return [list(zip(xs, ys, strict=True))]
    runs, run = [], []
    for x, y in zip(xs, ys, strict=True):
        if x is None or y is None:
            if run:
                runs.append(run)
            run = []
        else:
            run.append((x, y))
    return [*runs, run] if run else runs


def _limits(values: "Sequence[float] | np.ndarray", log: bool,
            given: tuple[float, float] | None) -> tuple[float, float]:
    """The range that holds all values; wider where there is only one of them, cut where poles would fill it."""
    if given is not None:
        return (math.log10(given[0]), math.log10(given[1])) if log else given
    low, high = min(values, default=0.0), max(values, default=1.0)
    if log:
        if high - low > MOST_DECADES:
            low, high = _without_poles(values, low, high)
        return (low, high) if high - low > 1e-9 else (low - 0.5, high + 0.5)
    size = max(abs(low), abs(high))
    if high - low > 1e-12 * size:
        return low, high
    return (-1.0, 1.0) if size == 0 else (min(0.0, 1.25 * low), max(0.0, 1.25 * high))


def _without_poles(values: "Sequence[float] | np.ndarray", low: float, high: float) -> tuple[float, float]:
    """The range of nine values in ten and three decades more: a pole on the grid or an exact zero is cut off."""
    ordered = sorted(values)
    tenth = len(ordered) // 20
    return max(low, ordered[tenth] - 3), min(high, ordered[-1 - tenth] + 3)


def thinned(run: Sequence[tuple[float, float]], axis: Axis, columns: int) -> Sequence[tuple[float, float]]:
    """Of the points that follow each other within one column the first, lowest, highest and last: the same drawing."""
    if len(run) <= 2 * columns:
        return run
    scale, found, group, column = columns / (axis.high - axis.low), [], [], None
    for point in run:
        here = int((point[0] - axis.low) * scale)
        if here != column and group:
            found += _extremes(group)
            group = []
        column = here
        group.append(point)
    return found + _extremes(group)


def fewer(x: Sequence[float], y: Sequence[float], most: int = 20000) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """(x, y) as tuples, of very many points the first, lowest, highest and last of each few that follow each other."""
    if len(x) > most:
        size = -(-4 * len(x) // most)
        parts = [list(zip(x[i:i + size], y[i:i + size], strict=True)) for i in range(0, len(x), size)]
        kept = [point for part in parts for point in (_extremes(part) if math.isfinite(sum(y for _, y in part))
                                                      else part)]
        x, y = zip(*kept, strict=True)
    return tuple(x), tuple(y)


def _extremes(group: list[tuple[float, float]]) -> list[tuple[float, float]]:
    if len(group) <= 4:
        return group
    ys = [y for _, y in group]
    kept = sorted({0, ys.index(min(ys)), ys.index(max(ys)), len(ys) - 1})
    return [group[i] for i in kept]


def scaled(sheet: Sheet, ratio: float) -> Sheet:
    """The sheet, with one scale where its panel wants it, for paper `ratio` times as wide as high: the axis with room
    to spare is widened."""
    width, height = sheet.x.high - sheet.x.low, sheet.y.high - sheet.y.low
    if not sheet.panel.equal:
        return sheet
    if width < ratio * height:
        return sheet._replace(x=_widened(sheet.x, ratio * height))
    return sheet._replace(y=_widened(sheet.y, width / ratio))


def _widened(axis: Axis, length: float) -> Axis:
    middle = (axis.low + axis.high) / 2
    return axis._replace(low=middle - length / 2, high=middle + length / 2)
