"""Drawings by Matplotlib: PNG and PDF, the same bytes each time. Its object interface alone is used."""

import io
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import COLOURS, Circle, LetterRuns, Polygon, Primitive, extent
from vibcli.drawing.layout import lettering
from vibcli.plots.picture import library

if TYPE_CHECKING:
    pass

MARGIN, DPI, WIDEST = 10.0, 150, 6000
SETTINGS = ("savefig.", "pdf.", "path.", "text.", "agg.", "font.", "patch.")
SILENT = {"png": {"Software": None},
          "pdf": {"CreationDate": None, "ModDate": None, "Creator": None, "Producer": None}}


def figure(primitives: Sequence[Any], dpi: float) -> Any:
    """A Matplotlib Figure of a drawing."""
    from matplotlib.figure import Figure
    from matplotlib.transforms import Affine2D

    left, bottom, right, top = extent(primitives)
    size = right - left + 2 * MARGIN, top - bottom + 2 * MARGIN
    made = Figure(figsize=(size[0] / 72, size[1] / 72), dpi=dpi, facecolor=COLOURS["paper"])
    place = Affine2D().translate(MARGIN - left, MARGIN - bottom).scale(1 / 72) + made.dpi_scale_trans
    for order, part in enumerate(sorted(primitives, key=lambda part: part.layer)):
        artists = _letters(part) if isinstance(part, LetterRuns) else [_patch(part)]
        for artist in artists:
            artist.set_transform(place)
            artist.set_zorder(order)
            made.add_artist(artist)
    return made


def _patch(part: "Primitive") -> Any:
    """The patch of strokes, filled where the primitive is."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    closed = isinstance(part, (Polygon, Circle))
    points, codes = [], []
    for stroke in part.strokes():
        points += stroke
        codes += [Path.MOVETO] + [Path.LINETO] * (len(stroke) - 1)
    if closed:
        codes[-1] = Path.CLOSEPOLY
    fill = getattr(part, "fill", None)
    return PathPatch(Path(points, codes), facecolor=COLOURS[fill] if fill else "none", edgecolor=COLOURS[part.role],
                     linewidth=part.width, linestyle=(0, (4, 3)) if part.dashed else "solid", capstyle="round",
                     joinstyle="round")


def _letters(part: LetterRuns) -> list[Any]:
    """One artist for each run; text is never taken for mathematics."""
    import matplotlib
    from matplotlib.font_manager import FontProperties
    from matplotlib.text import Text as Letters

    x, y = part.place
    found = []
    for run in part.runs:
        for text, right, rise in lettering.set_apart(run):
            file = lettering.file_of(text, run.slanted)
            font = FontProperties(fname=f"{matplotlib.get_data_path()}/fonts/ttf/{file}", size=run.size)
            found.append(Letters(x + right, y + rise, text, fontproperties=font, color=COLOURS[part.role],
                                 horizontalalignment="left", verticalalignment="baseline", parse_math=False))
        x += lettering.width((run,))
    return found


def picture(primitives: Any, kind: str) -> bytes:
    """The bytes of a png or pdf, whatever settings of Matplotlib the user has."""
    matplotlib = library()
    left, bottom, right, top = extent(primitives)
    dpi = min(DPI, 72 * WIDEST / max(right - left, top - bottom))

    ours = {key: value for key, value in matplotlib.rcParamsDefault.items() if key.startswith(SETTINGS)}
    with matplotlib.rc_context(ours):
        data = io.BytesIO()
        figure(primitives, dpi).savefig(data, format=kind, dpi=dpi, metadata=SILENT[kind])
    return data.getvalue()
