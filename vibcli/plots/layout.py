"""Panels on the page; Matplotlib's constrained layout gives every label its room."""

from textwrap import wrap
from typing import TYPE_CHECKING, Any

from vibcli.plots import style
from vibcli.plots.axes import draw
from vibcli.plots.paper import scaled, sheets
from vibcli.plots.words import printable, shortened

if TYPE_CHECKING:
    from vibcli.plots.figure import Figure, Panel

_LINE, _WORD, _LINES = 10.2, 6.2, 3      # columns of an inch of a line and of a word of the title; its lines


def drawn(figure: "Figure", inches: float = style.WIDTH) -> Any:
    """The Matplotlib figure, complete, so many inches wide."""
    from matplotlib.figure import Figure

    found = [scaled(sheet, style.RATIO) for sheet in sheets(figure)]
    heights = [_height(sheet.panel, len(found), inches) for sheet in found]
    page = Figure(figsize=(inches, sum(heights) or style.HEIGHT), facecolor="white", layout="constrained")
    grid = page.add_gridspec(max(len(found), 1), 1, height_ratios=heights or None)
    for i, sheet in enumerate(found):
        draw(page.add_subplot(grid[i]), sheet, heights[i])
    words = [shortened(word, int(_WORD * inches)) for word in printable(figure.title).split()]
    page.suptitle("\n".join(wrap(" ".join(words), int(_LINE * inches), max_lines=_LINES, placeholder="…")))
    return page


def _height(panel: "Panel", panels: int, inches: float) -> float:
    """Inches of a panel with its labels."""
    if panel.equal:
        return inches / style.RATIO
    return style.HEIGHT * panel.tall * (0.75 if panels > 1 else 1.0 if inches == style.WIDTH else 0.9)
