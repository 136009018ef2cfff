"""Frames of a drawing as an animated GIF, by Pillow: bounded in pixels and in frames, the same bytes each time."""

import io
from collections.abc import Callable, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any

from vibcli.base.work import under_way
from vibcli.drawing.canvas.primitives import COLOURS, Circle, LetterRuns, Polygon, Primitive, extent

if TYPE_CHECKING:
    pass

WIDEST, HIGHEST, MARGIN, FINER, MOST = 560, 420, 10.0, 2, 240
SHADES, FOOT, NARROW, LARGEST = 256, 26.0, 230.0, 2_000_000      # the last: bytes


def gif(frames: Sequence[list[Any]], caption: str, milliseconds: int = 40) -> bytes:
    """The bytes of a GIF that repeats the frames (lists of primitives)."""
    from PIL import Image

    boxes = [extent(frame) for frame in frames]
    box = (min(b[0] for b in boxes) - MARGIN, min(b[1] for b in boxes) - MARGIN - FOOT * bool(caption),
           max(b[2] for b in boxes) + MARGIN, max(b[3] for b in boxes) + MARGIN)
    spare = max(0.0, NARROW - (box[2] - box[0])) / 2
    box = box[0] - spare, box[1], box[2] + spare, box[3]
    scale = min(WIDEST / (box[2] - box[0]), HIGHEST / (box[3] - box[1]), 1.6)
    size = max(1, round((box[2] - box[0]) * scale)), max(1, round((box[3] - box[1]) * scale))
    frames = frames[:MOST]
    palette, task, indexed = _palette(frames), under_way(), []
    for number, frame in enumerate(frames, 1):
        page = _page(frame, caption, box, scale, size)
        indexed.append(page.quantize(palette=palette, dither=Image.Dither.NONE))
        if task is not None:
            task.step(number / len(frames))
    data = _animated(indexed, milliseconds)
    while len(data) > LARGEST and len(indexed) > 8:
        indexed, milliseconds = indexed[::2], 2 * milliseconds
        data = _animated(indexed, milliseconds)
    return data


def _animated(pages: list[Any], milliseconds: int) -> bytes:
    data = io.BytesIO()
    pages[0].save(data, format="GIF", save_all=True, append_images=pages[1:], duration=milliseconds, loop=0,
                  optimize=False, disposal=1)
    return data.getvalue()


def _palette(frames: "Sequence[list[Primitive]]") -> Any:
    """The colours of the roles that occur, and of edges between any two of them."""
    from PIL import Image, ImageColor

    roles = {"paper", "ink"} | {name for frame in frames for part in frame if not isinstance(part, LetterRuns)
                                for name in (part.role, getattr(part, "fill", None)) if name}
    colours = [ImageColor.getrgb(COLOURS[role]) for role in sorted(roles)]
    blends = [tuple(round(x + (y - x) * i / 4) for x, y in zip(one, two, strict=True))
              for one, two in combinations(colours, 2) for i in (1, 2, 3)]
    flat = [part for colour in list(dict.fromkeys(colours + blends))[:SHADES] for part in colour]
    found = Image.new("P", (1, 1))
    found.putpalette(flat + flat[:3] * (256 - len(flat) // 3))
    return found


def _page(frame: "Sequence[Primitive]", caption: str, box: tuple[float, float, float, float],
          scale: float, size: tuple[int, int]) -> Any:
    from PIL import Image, ImageDraw

    fine = scale * FINER
    page = Image.new("RGB", (size[0] * FINER, size[1] * FINER), COLOURS["paper"])
    pen = ImageDraw.Draw(page)
    for part in sorted(frame, key=lambda part: part.layer):
        if not isinstance(part, LetterRuns):
            _draw(part, pen, lambda p: ((p[0] - box[0]) * fine, (box[3] - p[1]) * fine), fine)
    if caption:
        _letters(caption, pen, (MARGIN * fine, (box[3] - box[1] - MARGIN - 4) * fine), fine)
    return page.resize(size, Image.Resampling.BOX)


def _draw(part: "Primitive", pen: Any, place: Callable[..., int | tuple[float, float]],
          fine: float) -> None:
    width = max(1, round(part.width * fine))
    fill = part.fill if isinstance(part, (Polygon, Circle)) else None
    for stroke in part.strokes():
        points = [place(p) for p in stroke]
        if fill:
            pen.polygon(points, fill=COLOURS[fill])
        pen.line(points, fill=COLOURS[part.role], width=width, joint="curve")


def _letters(text: str, pen: Any, place: tuple[float, float], fine: float) -> None:
    from PIL import ImageFont

    from vibcli.drawing.layout import fonts, lettering

    run, = lettering.words(text)
    font = ImageFont.truetype(fonts.path(lettering.file_of(run.text, False)), run.size * fine)
    pen.text(place, run.text, fill=COLOURS["ink"], font=font, anchor="ls")
