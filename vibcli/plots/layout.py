"""Panels on the page: each is drawn, its labels are measured, and the axes are placed so that nothing is cut off."""

from vibcli.plots import style
from vibcli.plots.axes import draw, letter
from vibcli.plots.lettering import wrapped
from vibcli.plots.paper import equal_scales, repeats, shares_x, sheets
from vibcli.plots.words import printable


def drawn(figure):
    """The Matplotlib figure, complete."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    page = Figure(figsize=(style.WIDTH, style.ROOM), dpi=style.DOTS, facecolor="white")
    renderer = FigureCanvasAgg(page).get_renderer()
    found = [_equal(sheet) for sheet in sheets(figure)]
    axes = [page.add_axes((0.2, 0.5, 0.6, _height(sheet.panel, len(found)) / style.ROOM)) for sheet in found]
    handles = []
    for i, (one, sheet) in enumerate(zip(axes, found, strict=True)):
        last = i + 1 == len(found) or not shares_x(sheet.panel, found[i + 1].panel)
        entries = draw(one, sheet, last, renderer)
        handles.append([] if i and repeats(sheet.panel, found[i - 1].panel) else entries)
    left, right = _fit_across(axes, found, renderer)
    for one, sheet, entries in zip(axes, found, handles, strict=True):
        letter(one, sheet, entries, renderer)
    title, note = (_text(page, text, size, (left + right) / 2, renderer)
                   for text, size in ((figure.title, style.TITLE), (figure.note, style.SMALL)))
    _place_down(page, axes, title, note, renderer)
    return page


def _equal(sheet):
    """The sheet with one scale for both axes where its panel wants it."""
    if not sheet.panel.equal:
        return sheet
    x, y = equal_scales(sheet.x, sheet.y, style.RATIO)
    return sheet._replace(x=x, y=y)


def _height(panel, panels):
    """Height of the axes in inches; where scales are equal it follows from their width later on."""
    return style.HEIGHT * panel.tall * (1.0 if panels == 1 else 0.75)


def _fit_across(axes, found, renderer):
    """Give all axes the width between the widest labels; returns their ends in inches."""
    outside = [_outside(one, renderer) for one in axes]
    left = max((edges[0] for edges in outside), default=0.0) + style.PAD
    right = style.WIDTH - max((edges[2] for edges in outside), default=0.0) - style.PAD
    for one, sheet in zip(axes, found, strict=True):
        height = (right - left) / style.RATIO if sheet.panel.equal else one.get_position().height * style.ROOM
        one.set_position((left / style.WIDTH, 0.2, (right - left) / style.WIDTH, height / style.ROOM))
    return left, right


def _outside(axes, renderer):
    """Inches by which labels stand out of the axes: left, below, right, above."""
    outer, inner = axes.get_tightbbox(renderer), axes.get_window_extent(renderer)
    edges = (inner.x0 - outer.x0, inner.y0 - outer.y0, outer.x1 - inner.x1, outer.y1 - inner.y1)
    return tuple(max(edge, 0.0) / style.DOTS for edge in edges)


def _text(page, text, size, middle, renderer):
    """A text across the page in lines that fit, its middle as near to that place as they allow; None where empty."""
    text = printable(text)
    if not text:
        return None
    artist = page.text(0, 0, "", fontsize=size, ha="center", va="top")
    wrapped(artist, text, (style.WIDTH - 2 * style.PAD) * style.DOTS, renderer)
    half = artist.get_window_extent(renderer).width / style.DOTS / 2 + style.PAD
    artist.set_x(min(max(middle, half), style.WIDTH - half) / style.WIDTH)
    return artist


def _place_down(page, axes, title, note, renderer):
    """Give the page its height and every part its place, in inches from the top."""
    down, tops = style.PAD, []
    if title is not None:
        down += _lines(title, renderer) + style.GAP / 2
    for one in axes:
        _, below, _, above = _outside(one, renderer)
        tops.append(down + above)
        down = tops[-1] + one.get_position().height * style.ROOM + below + style.GAP
    down += style.PAD - style.GAP
    note_top = down
    if note is not None:
        down += _lines(note, renderer) + style.PAD
    page.set_size_inches(style.WIDTH, down)
    for one, top in zip(axes, tops, strict=True):
        place = one.get_position()
        height = place.height * style.ROOM
        one.set_position((place.x0, 1 - (top + height) / down, place.width, height / down))
    for text, top in ((title, style.PAD), (note, note_top)):
        if text is not None:
            text.set_y(1 - top / down)


def _lines(text, renderer):
    return text.get_window_extent(renderer).height / style.DOTS
