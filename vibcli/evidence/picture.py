"""Run time over true error, both logarithmic: a line a method, our bound beside our error, crosses at the edge for
what was refused or stopped."""

from collections.abc import Callable, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from vibcli.plots.figure import Curve, Figure, Panel

if TYPE_CHECKING:
    from vibcli.evidence.compared import WorkPrecision

LEAST = 1e-17       # an error below it, as of a number that is exact, is drawn there
MARGIN = 10.0       # from the largest error to the edge


def figure(some: "Sequence[WorkPrecision]") -> Figure:
    """A panel for each quantity."""
    title = some[0].subject.asked if len(some) == 1 else ""
    return Figure(title, tuple(_panel(one, len(some) > 1) for one in some))


def _panel(one: "WorkPrecision", named: bool) -> Panel:
    ours, points = one.points[0], one.points
    edge = MARGIN * max(_drawn(x) for point in points for x in (point.error, point.bound) if x is not None)
    lost = [point.seconds[1] for point in points if point.error is None]
    curves = [Curve("refused or stopped" * bool(lost), (edge,) * len(lost), tuple(lost), "markers")]   # crosses
    for method, some in groupby(points, key=lambda point: point.method):
        found = [(_drawn(point.error), point.seconds[1]) for point in some if point.error is not None]
        if found:
            curves.append(Curve(method, tuple(x for x, _ in found), tuple(y for _, y in found)))
    if ours.error is not None and ours.bound is not None:
        curves.append(Curve("bound that is stated", (_drawn(ours.bound),), (ours.seconds[1],), "markers"))
    low = min(x for curve in curves for x in curve.x)
    label = "relative error" + f" of {one.subject.asked}" * named
    return Panel(label, "processor time [s]", True, True, tuple(curves), x_range=(low / MARGIN, edge))


def _drawn(error: float) -> float:
    return max(float(error), LEAST)


def picture_of(drawing: Figure) -> Callable[[str], bytes]:
    """What gives the bytes of a figure as svg, png or pdf."""
    def draw(kind: str) -> bytes:
        from vibcli.plots.picture import picture

        return picture(drawing, kind)
    return draw
