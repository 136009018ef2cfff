"""What is written beside curves in a file: marks with their labels above the axes, names beside points."""

from vibcli.plots import style
from vibcli.plots.lettering import fitted
from vibcli.plots.paper import thinned
from vibcli.plots.words import printable, shortened

_LONGEST, _MOST_ROWS = 40, 3
_PAPER = {"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "boxstyle": "square,pad=0.1"}


def draw_marks(axes, sheet, renderer):
    """Thin lines across the axes; labels of vertical ones above, in rows; returns how high they reach, in points."""
    rows = []
    for mark in sorted(sheet.panel.marks, key=lambda mark: mark.at):
        axis = sheet.x if mark.axis == "x" else sheet.y
        place = axis.place(mark.at)
        if place is None or not axis.low <= place <= axis.high:
            continue
        label = shortened(printable(mark.label), _LONGEST)
        if mark.axis == "x":
            axes.axvline(place, color=style.GREY, linewidth=0.8, linestyle=(0, (1, 2)), zorder=1.2)
            if label:
                _above(axes, place, label, rows, renderer)
        else:
            axes.axhline(place, color=style.GREY, linewidth=0.8, linestyle=(0, (1, 2)), zorder=1.2)
            text = axes.annotate("", (1, place), (-2, 2), xycoords=("axes fraction", "data"), va="bottom", ha="right",
                                 textcoords="offset points", fontsize=style.SMALL, color=style.GREY)
            fitted(text, label, axes.get_window_extent(renderer).width, renderer)
    return 4 + 1.25 * style.SMALL * len(rows)


def _above(axes, place, label, rows, renderer):
    """Write the label over its mark, within the width of the axes, in the lowest row that has room, if one has."""
    text = axes.annotate("", (place, 1), (0, 0), xycoords=("data", "axes fraction"), textcoords="offset points",
                         fontsize=style.SMALL, color=style.GREY, ha="center", va="bottom")
    inner = axes.get_window_extent(renderer)
    extent = fitted(text, label, inner.width, renderer).get_window_extent(renderer)
    shift = min(inner.x1 - extent.x1, 0.0) or max(inner.x0 - extent.x0, 0.0)
    row = next((i for i, end in enumerate(rows) if extent.x0 + shift > end + 6), len(rows))
    if row == _MOST_ROWS:
        text.remove()
        return
    rows[row:row + 1] = [extent.x1 + shift]
    text.set_position((shift * 72 / style.DOTS, 3 + 1.25 * style.SMALL * row))


def draw_names(axes, sheet, renderer):
    """Texts beside points, on the side where they cover least: other texts, points, lines."""
    names = [(curve, *entry) for curve in sheet.panel.curves
             for entry in zip(curve.x, curve.y, curve.names, strict=False)]
    if not names:
        return
    texts, points, inner = [], _points(axes, sheet), axes.get_window_extent(renderer)
    for curve, x, y, name in names:
        x, y, name = sheet.x.place(x), sheet.y.place(y), shortened(printable(name), _LONGEST)
        if not name or x is None or y is None:
            continue
        guide = curve.kind == "guide"
        text = axes.annotate("", (x, y), (0, 0), textcoords="offset points", fontsize=style.SMALL, zorder=4,
                             color=style.GREY if guide else style.BLACK, bbox=_PAPER)
        fitted(text, name, 0.4 * inner.width, renderer)
        sides = _AT_END if guide else _AT_POINT
        _, best = min((_covered(_moved(text, side, renderer), texts, points, inner), i)
                         for i, side in enumerate(sides))
        texts.append(_moved(text, sides[best], renderer))


_RIGHT, _LEFT = ((7, 0), "left", "center"), ((-7, 0), "right", "center")
_ABOVE, _BELOW = ((0, 6), "center", "bottom"), ((0, -6), "center", "top")
_CORNERS = (((5, 5), "left", "bottom"), ((-5, 5), "right", "bottom"), ((5, -5), "left", "top"),
            ((-5, -5), "right", "top"))
_AT_POINT, _AT_END = (_RIGHT, _LEFT, _ABOVE, _BELOW, *_CORNERS), (_ABOVE, _LEFT, _BELOW, _RIGHT, *_CORNERS)


def _moved(text, side, renderer):
    """Where the text is after it was moved to that side of its point."""
    offset, ha, va = side
    text.set_position(offset)
    text.set(ha=ha, va=va)
    return text.get_window_extent(renderer)


def _points(axes, sheet):
    """(x, y) in pixels of all points of curves, as an array."""
    found = [point for runs in sheet.strokes for run in runs for point in thinned(run, sheet.x, style.FINE)]
    return axes.transData.transform(found)


def _covered(extent, texts, points, inner):
    """What a text would cover: to stand out of the axes is worse than another text, that worse than any points."""
    x, y = points[:, 0], points[:, 1]
    inside = (x > extent.x0 - 3) & (x < extent.x1 + 3) & (y > extent.y0 - 2) & (y < extent.y1 + 2)
    out = extent.x0 < inner.x0 or extent.x1 > inner.x1 or extent.y1 > inner.y1 + 20
    return len(points) * (sum(extent.overlaps(other) for other in texts) + len(texts) * out + out) + inside.sum()
