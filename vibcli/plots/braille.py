"""A figure as text for the terminal: dots of braille, axes with ticks, labels beside their curves. Nothing heavy."""

from itertools import pairwise
from typing import TYPE_CHECKING

from vibcli.plots.canvas import Canvas
from vibcli.plots.curves import draw
from vibcli.plots.paper import scaled, sheets
from vibcli.plots.ticks import ticks
from vibcli.plots.words import printable, shortened
from vibcli.plots.words import width as columns_of

if TYPE_CHECKING:
    from vibcli.plots.figure import Figure
    from vibcli.plots.paper import Axis, Sheet

NARROWEST, WIDEST = 40, 200
FEWEST_ROWS = 5
_EQUAL_MARGIN = 6      # columns of numbers left of axes with equal scales, about


def braille(figure: "Figure", width: int = 80, height: int = 20) -> str:
    """The figure in lines of at most `width` columns; `height`: rows of a panel of usual height, without its axes."""
    columns = min(max(width, NARROWEST), WIDEST)
    found = [(sheet, max(FEWEST_ROWS, round(height * sheet.panel.tall))) for sheet in sheets(figure)]
    found = [(scaled(sheet, (columns - _EQUAL_MARGIN) / (2 * rows)), rows) for sheet, rows in found]
    labels = [_y_ticks(sheet.y, Canvas(columns, rows)) for sheet, rows in found]
    margin = max((columns_of(label) for ticks in labels for label in ticks.values()), default=0) + 2
    lines = _wrapped(printable(figure.title).split(" "), columns, " ")
    for i, (sheet, rows) in enumerate(found):
        canvas = Canvas(columns - margin, rows)
        legend = draw(canvas, sheet)
        lines += _heading(sheet.panel.y_label, legend if sheet.legend else [], columns)
        lines += _mark_labels(sheet, canvas, margin)
        for row, line in enumerate(canvas.lines()):
            label = labels[i].get(row, "")
            lines.append(" " * (margin - 2 - columns_of(label)) + label + (" ┤" if label else " │") + line)
        lines += _x_axis(sheet, canvas, margin)
    return "\n".join(line.rstrip() for line in lines)


def _wrapped(words: list[str], columns: int, gap: str) -> list[str]:
    """The words in lines of that width; one that is longer is cut."""
    lines, line = [], ""
    for word in words:
        if line and columns_of(line) + len(gap) + columns_of(word) > columns:
            lines.append(line)
            line = word
        else:
            line = f"{line}{gap}{word}" if line else word
    return [shortened(line, columns) for line in [*lines, line] if line]


def _heading(label: str, legend: list[str], columns: int) -> list[str]:
    """The label of y on the left, the legend on its right, on lines of its own where there is no room."""
    label = shortened(label, columns)
    right = "   ".join(legend)
    if columns_of(label) + 4 + columns_of(right) <= columns:
        return [label + " " * (columns - columns_of(label) - columns_of(right)) + right] if label or right else []
    return [label, *(_wrapped([shortened(entry, columns) for entry in legend], columns, "   ") or [""])]


def _y_ticks(axis: "Axis", canvas: Canvas) -> dict[int, str]:
    """{row: label}"""
    apart = 3 if canvas.rows >= 9 else 2

    def rows(found: list[tuple[float, str]]) -> list[int]:
        return [canvas.row(axis.part(place)) for place, _ in found]

    def fits(found: list[tuple[float, str]]) -> bool:
        return all(a - b >= apart for a, b in pairwise(rows(found)))

    half = (axis.high - axis.low) / (8 * canvas.rows)      # of a dot: a tick just beyond the end is at the end
    found = ticks(axis.low - half, axis.high + half, fits, axis.log, axis.degrees)
    return dict(zip(rows(found), (label for _, label in found), strict=True))


def _x_axis(sheet: "Sheet", canvas: Canvas, margin: int) -> list[str]:
    """The line of the axis with its ticks; below the last panel of a group the numbers and the label."""
    panel, axis = sheet.panel, sheet.x

    def placed(found: list[tuple[float, str]]) -> list[tuple[int, str]]:
        return [(canvas.column(axis.part(place)), label) for place, label in found]

    def fits(found: list[tuple[float, str]]) -> bool:
        return _row(placed(found), canvas, margin, gap=3) is not None

    found = ticks(axis.low, axis.high, fits, axis.log)
    at = {column for column, _ in placed(found)}
    lines = [" " * (margin - 1) + "└" + "".join("┬" if column in at else "─" for column in range(canvas.columns))]
    if not sheet.last:
        return lines
    label = shortened(panel.x_label, canvas.columns)
    row = _row(placed(found), canvas, margin, gap=1) or ""
    return [*lines, row, " " * (margin + (canvas.columns - columns_of(label)) // 2) + label]


def _row(placed: list[tuple[int, str]], canvas: Canvas, margin: int, gap: int) -> str | None:
    """Labels centred below (or above) their columns in one line; None where they do not fit."""
    line, taken = "", 0
    for column, label in placed:
        start = min(margin + column - columns_of(label) // 2, margin + canvas.columns - columns_of(label))
        if start < 0 or (line and start < taken + gap):
            return None
        line += " " * (start - taken) + label
        taken = start + columns_of(label)
    return line


def _mark_labels(sheet: "Sheet", canvas: Canvas, margin: int) -> list[str]:
    """The labels of vertical marks above the canvas, in two lines where they crowd; what finds no room is left out."""
    places = [(sheet.x.place(mark.at), mark.label) for mark in sheet.panel.marks]
    placed = sorted((canvas.column(sheet.x.part(place)), label) for place, label in places
                    if label and place is not None and sheet.x.low <= place <= sheet.x.high)
    lines = [[], []]
    for entry in placed:
        for line in lines:
            if _row([*line, entry], canvas, margin, gap=2) is not None:
                line.append(entry)
                break
    return [_row(line, canvas, margin, gap=2) for line in reversed(lines) if line]
