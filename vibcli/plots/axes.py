"""One panel by Matplotlib: its curves, ticks, labels and legend."""

import math
from typing import TYPE_CHECKING, Any

from vibcli.plots import style
from vibcli.plots.marking import draw_marks, draw_names
from vibcli.plots.response import turns
from vibcli.plots.ticks import OF_A_TURN, decade
from vibcli.plots.words import shortened, width, with_its_unit

if TYPE_CHECKING:
    from vibcli.plots.paper import Axis, Sheet

_MARGIN = 0.05              # of the height, above and below the curves
_MOST = 10                  # stretches between ticks upwards
_LONGEST, _AN_INCH = 9.3, 8  # columns to an inch of a label, of one that is written upwards
_IN_A_ROW = 12              # columns of an inch of a row of the legend, of which each entry's line takes some
_OF_A_LINE = 8
_ALONG, _UPWARDS = 1.55, 3.5  # stretches between ticks to an inch of the panel, at most


def draw(axes: Any, sheet: "Sheet", inches: float) -> None:
    """Everything of a panel so many inches high."""
    panel = sheet.panel
    sheet = sheet._replace(x=_with_margin(sheet.x, _MARGIN * panel.equal), y=_with_margin(sheet.y, _MARGIN))
    across = axes.figure.get_figwidth()
    _scale(axes.xaxis, sheet.x, int(_ALONG * across) if _wide(sheet.x) else int(_ALONG * across / 2))
    _scale(axes.yaxis, sheet.y, min(int(_UPWARDS * inches), _MOST))
    axes.tick_params(axis="x", labelbottom=sheet.last)
    axes.set_xlabel(shortened(panel.x_label, int(_LONGEST * across)) if sheet.last else "")
    axes.set_ylabel(with_its_unit(panel.y_label, int(_AN_INCH * inches)))
    if panel.equal:
        axes.set_box_aspect(1 / style.RATIO)
    if not any(sheet.strokes):
        axes.text(0.5, 0.5, "no values", transform=axes.transAxes, ha="center", va="center", color=style.GREY)
    _zero_lines(axes, sheet)
    handles = _curves(axes, sheet)
    draw_names(axes, sheet, inches)
    top = draw_marks(axes, sheet)
    if sheet.legend and len(handles) > 1:
        _legend(axes, handles, top)


def _wide(axis: "Axis") -> bool:
    """Do few digits tell the ends apart, so that the numbers along it are short?"""
    return axis.high - axis.low > 1e-3 * max(abs(axis.low), abs(axis.high))


def _with_margin(axis: "Axis", part: float) -> "Axis":
    margin = part * (axis.high - axis.low)
    return axis._replace(low=axis.low - margin, high=axis.high + margin)


def _scale(axis: Any, shown: "Axis", most: int) -> None:
    """The range of an axis, linear or logarithmic, and its ticks, at most so many where it is linear."""
    from matplotlib import ticker

    axis.axes.set(**{f"{axis.axis_name}scale": "log" if shown.log else "linear",
                     f"{axis.axis_name}lim": (shown.value(shown.low), shown.value(shown.high))})
    axis.set_minor_formatter(ticker.NullFormatter())
    if shown.log and shown.high - shown.low >= 1:
        axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5) if shown.high - shown.low < 2.5 else (1,)))
        plain = shown.low > -4 and shown.high < 5
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: decade(value, plain)))
    elif shown.degrees and shown.high - shown.low >= 90:
        axis.set_major_locator(ticker.MultipleLocator(next(
            (step for step in OF_A_TURN if shown.high - shown.low < 6 * step), OF_A_TURN[-1])))
    else:
        axis.set_major_locator(ticker.MaxNLocator(most, steps=(1, 2, 5, 10)))
        axis.set_major_formatter(ticker.ScalarFormatter())


def _zero_lines(axes: Any, sheet: "Sheet") -> None:
    """Thin lines at zero."""
    if not sheet.y.log and sheet.y.low < 0 < sheet.y.high:
        axes.axhline(0.0, color=style.MIDDLE, linewidth=0.7, zorder=1)
    if not sheet.x.log and sheet.x.low < 0 < sheet.x.high:
        axes.axvline(0.0, color=style.MIDDLE, linewidth=0.7, zorder=1)


def _curves(axes: Any, sheet: "Sheet") -> list[tuple[Any, str]]:
    """Draw the curves; [(artist, label)] of those that a legend tells."""
    handles, lines, points = [], 0, 0
    for curve, runs in zip(sheet.panel.curves, sheet.strokes, strict=True):
        if curve.kind == "markers":
            colour, marker = style.POINTS[points % len(style.POINTS)]
            colour = colour if curve.label or not lines else style.BLACK        # of points on lines: that of none
            points += 1
            artist = _points(axes, sheet, runs, colour, marker)
        elif curve.kind == "arrow":
            _arrow(axes, sheet, runs)
            continue
        elif curve.kind == "orbit":
            artist = _line(axes, sheet, runs, style.MIDDLE, "-", 0.8, 2.0)
        elif curve.kind in ("envelope", "guide"):
            envelope = curve.kind == "envelope"
            artist = _line(axes, sheet, runs, style.GREY if envelope else style.MIDDLE, (0, (4, 2.5)), 0.9 if envelope
                           else 0.7, 1.5)
        else:
            colour = style.COLOURS[lines % len(style.COLOURS)]
            dashes = style.DASHES[(lines + lines // len(style.COLOURS)) % len(style.DASHES)]
            lines += 1
            artist = _line(axes, sheet, runs, colour, dashes, 1.5, 2.5)
        if curve.label and curve.kind != "guide":
            handles.append((artist, shortened(curve.label, int(_LONGEST * axes.figure.get_figwidth()))))
    return handles


def _line(axes: Any, sheet: "Sheet", runs: list[list[tuple[float, float]]], colour: str,
          dashes: str | tuple[int, tuple[float, ...]], width: float, order: float) -> Any:
    """What stands for it in the legend: a dot where it is nothing but dots."""
    if sum(turns([y for _, y in run]) for run in runs) > style.CROWDED:
        width, dashes = 0.5 * width, "-"
    artist, = axes.plot(*_values(sheet, runs), color=colour, linestyle=dashes, linewidth=width, zorder=order,
                        solid_joinstyle="round", scalex=False, scaley=False)
    single = [run for run in runs if len(run) == 1]
    dots, = axes.plot(*_values(sheet, single), linestyle="", marker="o", markersize=3, color=colour, scalex=False,
                      scaley=False)
    return dots if single and len(single) == len(runs) else artist


def _arrow(axes: Any, sheet: "Sheet", runs: list[list[tuple[float, float]]]) -> None:
    """A head at the second of two points, which looks away from the first."""
    for start, end in runs:
        (x, y), (to_x, to_y) = ((sheet.x.value(p), sheet.y.value(q)) for p, q in (start, end))
        axes.annotate("", (to_x, to_y), (x, y), zorder=2.8, annotation_clip=True, arrowprops={
            "arrowstyle": "-|>", "color": style.GREY, "linewidth": 0, "mutation_scale": 11, "shrinkA": 0, "shrinkB": 0})


def _values(sheet: "Sheet", runs: list[list[tuple[float, float]]]) -> tuple[list[float], list[float]]:
    """The runs one after the other, NaN between them: x and y."""
    points = [point for run in runs for point in (*run, (math.nan, math.nan))][:-1]
    return [sheet.x.value(x) for x, _ in points], [sheet.y.value(y) for _, y in points]


def _points(axes: Any, sheet: "Sheet", runs: list[list[tuple[float, float]]], colour: str, marker: str) -> Any:
    face = "white" if any(curve.kind == "orbit" for curve in sheet.panel.curves) else "none"
    artist, = axes.plot(*_values(sheet, runs), linestyle="", marker=marker, color=colour,
                        markersize=6 if marker == "x" else 5, markeredgewidth=1.4, zorder=3, scalex=False, scaley=False,
                        markerfacecolor=face, clip_on=False)
    artist.set_in_layout(bool(runs))        # none would stand at the corner of the page
    return artist


def _legend(axes: Any, handles: list[tuple[Any, str]], top: float) -> None:
    """The legend above the axes, so many points above them, in as few rows as its entries take."""
    from matplotlib.transforms import ScaledTranslation

    longest = max(width(label) for _, label in handles) + _OF_A_LINE
    rows = -(-len(handles) // max(int(_IN_A_ROW * axes.figure.get_figwidth()) // longest, 1))
    raised = axes.transAxes + ScaledTranslation(0, top / 72, axes.figure.dpi_scale_trans)
    legend = axes.legend([artist for artist, _ in handles], ["."] * len(handles), loc="lower right",
                         ncols=-(-len(handles) // rows), bbox_to_anchor=(1, 1), bbox_transform=raised)
    for text, (_, label) in zip(legend.get_texts(), handles, strict=True):      # one that starts with _ is left out
        text.set_text(label)
