"""One panel by Matplotlib, in the coordinates of its paper: logarithms are taken already, ticks are our own."""

from itertools import pairwise

from vibcli.plots import style
from vibcli.plots.lettering import fitted
from vibcli.plots.marking import draw_marks, draw_names
from vibcli.plots.paper import thinned
from vibcli.plots.ticks import minor, ticks
from vibcli.plots.words import printable

_MARGIN = 0.05      # of the height, above and below the curves


def draw(axes, sheet, last, renderer):
    """Curves, ticks and the label of y; `last`: the panel of its group that carries the numbers along x.

    Returns what stands in the legend: [(artist, label)].
    """
    panel = sheet.panel
    x, y = _with_margin(sheet.x, _MARGIN * panel.equal), _with_margin(sheet.y, _MARGIN)
    axes.set_xlim(x.low, x.high)
    axes.set_ylim(y.low, y.high)
    _frame(axes, sheet)
    _ticks(axes, panel, x, y, last)
    if panel.y_label:
        axes.yaxis.label.set_fontsize(style.LABEL)
        fitted(axes.yaxis.label, printable(panel.y_label), axes.get_window_extent(renderer).height * 1.1, renderer,
               across=False)
    if not any(sheet.strokes):
        axes.text(0.5, 0.5, "no values", transform=axes.transAxes, ha="center", va="center", color=style.GREY)
    return _curves(axes, sheet)


def letter(axes, sheet, handles, renderer):
    """The texts that need the final width: label of x, names of points, labels of marks, legend, title."""
    panel, width = sheet.panel, axes.get_window_extent(renderer).width
    if panel.x_label and any(label.get_visible() for label in axes.get_xticklabels()):
        axes.xaxis.label.set_fontsize(style.LABEL)
        fitted(axes.xaxis.label, printable(panel.x_label), width, renderer)
    draw_names(axes, sheet, renderer)
    top = draw_marks(axes, sheet, renderer)
    if handles:
        top = _legend(axes, handles, top, renderer)
    if panel.title:
        title = axes.annotate("", (0, 1), (0, top), xycoords="axes fraction", textcoords="offset points",
                              fontsize=style.LABEL, va="bottom", fontweight="bold")
        fitted(title, printable(panel.title), width, renderer)


def _frame(axes, sheet):
    """An L of axes, and thin lines at zero."""
    for side, spine in axes.spines.items():
        spine.set_visible(side in ("left", "bottom"))
        spine.set_linewidth(0.8)
    if not sheet.y.log and sheet.y.low < 0 < sheet.y.high:
        axes.axhline(0.0, color=style.MIDDLE, linewidth=0.7, zorder=1)
    if not sheet.x.log and sheet.x.low < 0 < sheet.x.high:
        axes.axvline(0.0, color=style.MIDDLE, linewidth=0.7, zorder=1)


def _with_margin(axis, part):
    margin = part * (axis.high - axis.low)
    return axis._replace(low=axis.low - margin, high=axis.high + margin)


def _ticks(axes, panel, x, y, last):
    from matplotlib.ticker import FixedFormatter, FixedLocator

    high = axes.get_position().height * style.ROOM
    along = ticks(x.low, x.high, lambda found: _fits_across(found, x, style.WIDTH - 1.0), x.log)
    up = ticks(y.low, y.high, lambda found: _fits_up(found, y, high), y.log, y.degrees)
    for axis, found, of in ((axes.xaxis, along, x), (axes.yaxis, up, y)):
        axis.set_major_locator(FixedLocator([place for place, _ in found]))
        axis.set_major_formatter(FixedFormatter([label for _, label in found]))
        if of.log:
            _minor_ticks(axes, axis, minor(of.low, of.high))
    axes.set_axisbelow(True)
    axes.grid(True, color=style.LIGHT, linewidth=0.7)
    axes.tick_params(labelsize=style.TICK, length=3.5, width=0.8)
    axes.tick_params(axis="x", labelbottom=last)


def _minor_ticks(axes, axis, places):
    """All of them in one line of markers: Matplotlib's own take a millisecond each."""
    if not places:      # a line without points would be taken to lie in the corner of the page
        return
    across = axis is axes.xaxis
    zeros = [0.0] * len(places)
    x, y, transform, marker = ((places, zeros, axes.get_xaxis_transform(), 3) if across
                               else (zeros, places, axes.get_yaxis_transform(), 0))     # 3: TICKDOWN, 0: TICKLEFT
    axes.plot(x, y, linestyle="", marker=marker, markersize=2.5, markeredgewidth=0.5, color="black", clip_on=False,
              transform=transform, scalex=False, scaley=False)


def _fits_across(found, axis, inches):
    """Is there an em and a half between the labels?"""
    em = style.TICK / 72
    ends = [(axis.part(place) * inches, 0.65 * em * len(label)) for place, label in found]
    return all(b - a > (wide + next_wide) / 2 + 1.5 * em
               for (a, wide), (b, next_wide) in pairwise(ends))


def _fits_up(found, axis, inches):
    places = [axis.part(place) * inches for place, _ in found]
    return all(b - a > 0.25 for a, b in pairwise(places))


def _curves(axes, sheet):
    """Draw the curves; [(artist, label)] of those that stand in the legend."""
    handles, lines, points = [], 0, 0
    for curve, runs in zip(sheet.panel.curves, sheet.strokes, strict=True):
        if curve.kind == "markers":
            colour, marker = style.POINTS[points % len(style.POINTS)]
            points += 1
            artist = _points(axes, runs, colour, marker)
        elif curve.kind in ("envelope", "guide"):
            envelope = curve.kind == "envelope"
            artist = _line(axes, sheet, runs, style.GREY if envelope else style.MIDDLE, (0, (4, 2.5)), 0.9 if envelope
                           else 0.7, 1.5)
        else:
            colour = style.COLOURS[lines % len(style.COLOURS)]
            dashes = style.DASHES[(lines + lines // len(style.COLOURS)) % len(style.DASHES)]
            lines += 1
            artist = _line(axes, sheet, runs, colour, dashes, 1.5, 2.5)
        if printable(curve.label) and curve.kind != "guide":
            handles.append((artist, printable(curve.label)))
    return handles if len(handles) > 1 else []


def _line(axes, sheet, runs, colour, dashes, width, order):
    runs = [thinned(run, sheet.x, style.FINE) for run in runs]
    if sum(map(_turns, runs)) > style.CROWDED:
        width, dashes = 0.5 * width, "-"
    x, y = _joined(runs)
    artist, = axes.plot(x, y, color=colour, linestyle=dashes, linewidth=width, zorder=order, solid_joinstyle="round",
                        scalex=False, scaley=False)
    for run in runs:
        if len(run) == 1:
            axes.plot(*run[0], marker="o", markersize=3, color=colour, scalex=False, scaley=False)
    return artist


def _turns(run):
    """How often a line turns between up and down."""
    steps = [b - a for (_, a), (_, b) in pairwise(run)]
    return sum(a * b < 0 for a, b in pairwise(steps))


def _joined(runs):
    """The runs one after the other, NaN between them."""
    points = [point for run in runs for point in (*run, (float("nan"), float("nan")))][:-1]
    return [x for x, _ in points], [y for _, y in points]


def _points(axes, runs, colour, marker):
    points = [point for run in runs for point in run]
    artist, = axes.plot([x for x, _ in points], [y for _, y in points], linestyle="", marker=marker, color=colour,
                        markersize=6 if marker == "x" else 5, markeredgewidth=1.4, zorder=3, scalex=False, scaley=False,
                        markerfacecolor="none", clip_on=False)
    return artist


def _legend(axes, handles, top, renderer):
    """The legend above the axes, in as few rows as its entries take; returns the height in points where it ends."""
    from matplotlib.transforms import ScaledTranslation

    room = axes.get_window_extent(renderer).width
    raised = axes.transAxes + ScaledTranslation(0, top / 72, axes.figure.dpi_scale_trans)
    for columns in range(min(len(handles), 6), 0, -1):
        legend = axes.legend([artist for artist, _ in handles], ["."] * len(handles), loc="lower right", ncols=columns,
                             bbox_to_anchor=(1, 1), bbox_transform=raised, frameon=False, fontsize=style.TICK,
                             borderaxespad=0, borderpad=0.2, handlelength=2.6, columnspacing=1.5)
        for text, (_, label) in zip(legend.get_texts(), handles, strict=True):
            fitted(text, label, 0.8 * room, renderer)
        extent = legend.get_window_extent(renderer)
        if extent.width <= room:
            break
    return top + extent.height / style.DOTS * 72
