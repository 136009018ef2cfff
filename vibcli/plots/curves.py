"""The curves of a panel on a canvas: lines told apart by their dots, points by letters, each with its label beside."""

import math

from vibcli.plots.canvas import Canvas
from vibcli.plots.paper import Sheet, thinned
from vibcli.plots.words import cells, shortened

_PATTERNS = ("x", "xxxxx    ", "xx  ", "xxxxxxx  x  ", "xxx       ")
_OF_KIND = {"envelope": "x   ", "guide": "x    ", "orbit": "x   "}
_HEADS = "→↗↑↖←↙↓↘"
_POINTS = "×o#@◆"
_DOT = "o"         # of a line of one point
_LONGEST = 14      # columns of a label beside its curve
_NAME = 24         # of a name beside a point
_COVERED = 3       # orbits are as bad to cover as one part in so many of another line
_APART = 3         # rows between such a label and any other line


def draw(canvas: Canvas, sheet: Sheet) -> list[str]:
    """Draw everything within the axes; returns the legend, one entry a labelled curve where there are several."""
    _behind(canvas, sheet)
    curves, samples, lines, points = sheet.panel.curves, [], [], 0
    for number, (curve, runs) in enumerate(zip(curves, sheet.strokes, strict=True)):
        if curve.kind == "markers":
            samples.append(_POINTS[points % len(_POINTS)])
            points += 1
            canvas.layer()      # no dots: layers are counted as the curves are
            _points(canvas, sheet, runs, samples[-1])
            continue
        if curve.kind == "arrow":
            samples.append("")
            canvas.layer()
            continue
        pattern = _OF_KIND.get(curve.kind) or _PATTERNS[len(lines) % len(_PATTERNS)]
        _line(canvas, sheet, runs, canvas.layer(), pattern)
        samples.append(_DOT if runs and all(len(run) == 1 for run in runs) else _sample(pattern))
        lines += [] if curve.kind in _OF_KIND else [number]
    _arrows(canvas, sheet)
    _names(canvas, sheet)
    if not any(sheet.strokes):
        canvas.write(canvas.rows // 2, canvas.columns // 2 - 4, "no values")
    rows = canvas.rows_used() if len(lines) > 1 else []
    for number in lines if rows else ():
        _beside(canvas, rows, number, cells(shortened(curves[number].label, _LONGEST)))
    entries = [f"{sample} {curve.label}" for sample, curve in zip(samples, curves, strict=True)
               if curve.label and curve.kind != "guide"]
    return entries if len(entries) > 1 else []


def _line(canvas: Canvas, sheet: Sheet, runs: list[list[tuple[float, float]]], layer: bytearray, pattern: str) -> None:
    for run in runs:
        points = thinned(run, sheet.x, 2 * canvas.columns)
        canvas.polyline(layer, [canvas.dots(sheet.x.part(x), sheet.y.part(y)) for x, y in points], pattern)
        if len(run) == 1:
            canvas.write(*_cell(canvas, sheet, *run[0]), _DOT)


def _sample(pattern: str) -> str:
    """A short piece of line for the legend."""
    sample = Canvas(6, 1)
    sample.polyline(sample.layer(), [(0, 2), (11, 2)], pattern)
    return sample.lines()[0]


def _cell(canvas: Canvas, sheet: Sheet, x: float, y: float) -> tuple[int, int]:
    """(row, column) of a point."""
    return canvas.row(sheet.y.part(y)), canvas.column(sheet.x.part(x))


def _points(canvas: Canvas, sheet: Sheet, runs: list[list[tuple[float, float]]], letter: str) -> None:
    for run in runs:
        for x, y in run:
            canvas.write(*_cell(canvas, sheet, x, y), letter)


def _arrows(canvas: Canvas, sheet: Sheet) -> None:
    """A head for each arrow, in the nearest of eight directions."""
    for curve, runs in zip(sheet.panel.curves, sheet.strokes, strict=True):
        for (x, y), (to_x, to_y) in runs if curve.kind == "arrow" else ():
            (a, b), (c, d) = (canvas.dots(sheet.x.part(p), sheet.y.part(q)) for p, q in ((x, y), (to_x, to_y)))
            canvas.write(*_cell(canvas, sheet, to_x, to_y), _HEADS[round(math.atan2(b - d, c - a) / (math.pi / 4)) % 8])


def _behind(canvas: Canvas, sheet: Sheet) -> None:
    """The zero line and the marks, where nothing else is."""
    if not sheet.y.log and sheet.y.low < 0 < sheet.y.high:
        row = _cell(canvas, sheet, sheet.x.low, 0.0)[0]
        canvas.behind.update({(row, column): "┈" for column in range(canvas.columns)})
    for mark in sheet.panel.marks:
        place = sheet.x.place(mark.at)
        if place is not None and sheet.x.low <= place <= sheet.x.high:
            column = _cell(canvas, sheet, place, sheet.y.low)[1]
            canvas.behind.update({(row, column): "┊" for row in range(canvas.rows)})


def _names(canvas: Canvas, sheet: Sheet) -> None:
    """The texts beside points: right of them, left, above or below, wherever there is room first; among orbits, where
    they cover least."""
    orbits = {i for i, curve in enumerate(sheet.panel.curves) if curve.kind == "orbit"}
    for curve in sheet.panel.curves:
        for x, y, name in zip(curve.x, curve.y, curve.names, strict=False):
            x, y, text = sheet.x.place(x), sheet.y.place(y), cells(shortened(name, _NAME))
            if not text or x is None or y is None:
                continue
            row, column = _cell(canvas, sheet, x, y)
            n = len(text)
            places = [(row, column + 2), (row, column - n - 1), (row - 1, column - n // 2),
                      (row + 1, column - n // 2), (row - 1, column + 1), (row + 1, column + 1)]
            place = next((place for place in places if canvas.free(*place, n)), None)
            if place is None and orbits:
                place = _least_covered(canvas, places, n, orbits)
            if place is not None:
                canvas.write(*place, text)


def _least_covered(canvas: Canvas, places: list[tuple[int, int]], length: int,
                   orbits: set[int]) -> tuple[int, int] | None:
    """Of the places without text, the one at which a text covers least; None where there is none."""
    costs = []
    for row, column in places:
        here = [(row, c) for c in range(column - 1, column + length + 1)]
        if not (0 <= row < canvas.rows and column >= 0 and column + length <= canvas.columns) or any(
                cell in canvas.letters for cell in here[1:-1]):
            continue
        costs.append((sum(1 if layer in orbits else _COVERED for cell in here for layer in canvas.used(*cell)),
                      (row, column)))
    return min(costs, default=(0, None), key=lambda cost: cost[0])[1]


def _beside(canvas: Canvas, rows: list[dict[int, list[int]]], number: int, text: list[str]) -> None:
    """Write the label of a line over or under it, where the other lines are farthest away."""
    best, place = _APART - 1, None
    for column in range(1, canvas.columns - len(text)):
        own = rows[column + len(text) // 2].get(number)
        if not own:
            continue
        others = [row for layer, found in rows[column + len(text) // 2].items() if layer != number for row in found]
        for row in (min(own) - 1, max(own) + 1):
            if not canvas.free(row, column - 1, len(text) + 2):
                continue
            distance = min((abs(row - other) for other in others), default=canvas.rows)
            if distance > best:
                best, place = distance, (row, column)
    if place is not None and text:
        canvas.write(*place, text)
