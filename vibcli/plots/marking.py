"""What is written beside curves in a file: marks with their labels above the axes, names beside points."""

from typing import Any

from vibcli.plots import style
from vibcli.plots.paper import Sheet, thinned
from vibcli.plots.words import shortened, width

_LONGEST, _MOST_ROWS = 40, 3
_BESIDE = 68               # points of a figure beside its axes, about
_PAPER = {"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "boxstyle": "square,pad=0.1"}
_RIGHT, _LEFT, _ABOVE, _BELOW = (1, 0), (-1, 0), (0, 1), (0, -1)
_CORNERS = ((1, 1), (-1, 1), (1, -1), (-1, -1))
_AT_POINT, _AT_END = (_RIGHT, _LEFT, _ABOVE, _BELOW, *_CORNERS), (_ABOVE, _LEFT, _BELOW, _RIGHT, *_CORNERS)
_ANCHOR = {-1: ("right", "top"), 0: ("center", "center"), 1: ("left", "bottom")}


def draw_marks(axes: Any, sheet: Sheet) -> float:
    """Thin lines across the axes with their labels above, in rows; returns how high they reach, in points."""
    rows: list[float] = []
    wide = _across(axes)
    for mark in sorted(sheet.panel.marks, key=lambda mark: mark.at):
        place = sheet.x.place(mark.at)
        if place is None or not sheet.x.low <= place <= sheet.x.high:
            continue
        axes.axvline(mark.at, color=style.GREY, linewidth=0.8, linestyle=(0, (1, 2)), zorder=1.2)
        label = shortened(mark.label, _LONGEST)
        middle, half = wide * sheet.x.part(place), _long(label) / 2
        row = next((i for i, end in enumerate(rows) if middle - half > end + 3), len(rows))
        if label and row < _MOST_ROWS:
            rows[row:row + 1] = [middle + half]
            axes.annotate(label, (mark.at, 1), (0, 3 + 1.25 * style.SMALL * row), ha="center", va="bottom",
                          xycoords=("data", "axes fraction"), textcoords="offset points", fontsize=style.SMALL,
                          color=style.GREY)
    return 4 + 1.25 * style.SMALL * len(rows)


def _across(axes: Any) -> float:
    """Points from end to end of the axes, about."""
    return float(72 * axes.figure.get_figwidth() - _BESIDE)


def _long(text: str) -> float:
    """Points of a text, about."""
    return style.EM * style.SMALL * width(text)


def draw_names(axes: Any, sheet: Sheet, inches: float) -> None:
    """Texts beside points, on the side where they cover least: other texts, points, lines."""
    wide, high, texts = _across(axes), 72 * inches - 50, []
    lines = [(wide * sheet.x.part(x), high * sheet.y.part(y)) for runs in sheet.strokes for run in runs
             for x, y in thinned(run, sheet.x, int(wide))]
    for curve in sorted(sheet.panel.curves, key=lambda curve: curve.kind == "guide"):
        for x, y, name in zip(curve.x, curve.y, curve.names, strict=False):
            across, up, name = sheet.x.place(x), sheet.y.place(y), shortened(name, _LONGEST)
            if not name or across is None or up is None:
                continue
            guide = curve.kind == "guide"
            at = wide * sheet.x.part(across), high * sheet.y.part(up)
            sides = [(_box(*at, *side, _long(name)), side) for side in (_AT_END if guide else _AT_POINT)]
            box, (right, above) = min(sides, key=lambda side: _covered(side[0], texts, lines, (wide, high)))
            texts.append(box)
            axes.annotate(name, (x, y), (right * (5 if above else 7), above * (5 if right else 6)), zorder=4,
                          ha=_ANCHOR[right][0], va=_ANCHOR[above][1], textcoords="offset points",
                          fontsize=style.SMALL, color=style.GREY if guide else style.BLACK, bbox=_PAPER)


def _box(x: float, y: float, right: int, above: int, long: float) -> tuple[float, float, float, float]:
    """(left, below, right, above) of a text on that side of a point."""
    left = x + {-1: -long - 6, 0: -long / 2, 1: 6}[right]
    below = y + {-1: -style.SMALL - 6, 0: -style.SMALL / 2, 1: 5}[above]
    return left, below, left + long, below + style.SMALL


def _covered(box: tuple[float, float, float, float], texts: list[tuple[float, float, float, float]],
             points: list[tuple[float, float]], size: tuple[float, float]) -> tuple[bool, int, int]:
    """What a text would cover: to stand out of the axes is worse than another text, that worse than any points."""
    left, below, right, above = box
    inside = sum(left - 1 < x < right + 1 and below - 1 < y < above + 1 for x, y in points)
    over = sum(left < other[2] and other[0] < right and below < other[3] and other[1] < above for other in texts)
    out = left < 0 or right > size[0] or below < 0 or above > size[1] + 10
    return out, over, inside
