"""Panels on the page; Matplotlib's constrained layout gives every label its room."""

from textwrap import wrap
from typing import TYPE_CHECKING, Any

from vibcli.plots import style
from vibcli.plots.axes import draw
from vibcli.plots.paper import scaled, sheets
from vibcli.plots.words import printable, shortened

if TYPE_CHECKING:
    from vibcli.plots.figure import Figure, Panel

_LINE, _WORD, _LINES = 66, 40, 3      # columns of a line and of a word of the title; its lines


def drawn(figure: "Figure") -> Any:
    """The Matplotlib figure, complete."""
    from matplotlib.figure import Figure

    found = [scaled(sheet, style.RATIO) for sheet in sheets(figure)]
    heights = [_height(sheet.panel, len(found)) for sheet in found]
    page = Figure(figsize=(style.WIDTH, sum(heights) or style.HEIGHT), facecolor="white", layout="constrained")
    grid = page.add_gridspec(max(len(found), 1), 1, height_ratios=heights or None)
    for i, sheet in enumerate(found):
        draw(page.add_subplot(grid[i]), sheet, heights[i])
    words = [shortened(word, _WORD) for word in printable(figure.title).split()]
    page.suptitle("\n".join(wrap(" ".join(words), _LINE, max_lines=_LINES, placeholder="…")))
    return page


def _height(panel: "Panel", panels: int) -> float:
    """Inches of a panel with its labels."""
    if panel.equal:
        return style.WIDTH / style.RATIO
    return style.HEIGHT * panel.tall * (1.0 if panels == 1 else 0.75)
