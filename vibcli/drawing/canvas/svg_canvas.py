"""Drawings as SVG, written from their primitives: words stay words, nothing is loaded, no script runs."""

from collections.abc import Sequence
from typing import Any

from vibcli.base.decoding import cleaned
from vibcli.drawing.canvas.primitives import COLOURS, Circle, LetterRuns, Polygon, extent

MARGIN = 10.0
DASHES = 4, 3       # widths of the line
FAMILY = "'STIX Two Text','STIX General',STIXGeneral,'Times New Roman','Liberation Serif','Nimbus Roman'," \
         "'TeX Gyre Termes',FreeSerif,'DejaVu Serif Condensed',serif"
# The module html loads a table of all names of characters.
ESCAPED = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#x27;"})
_DOCUMENT = """<?xml version="1.0" encoding="utf-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{width}pt" height="{height}pt" viewBox="{view}" role="img" fill="none" \
stroke-linecap="round" stroke-linejoin="round" font-family="{family}">
<title>{title}</title>{about}{style}
<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="{paper}"/>
{body}
</svg>
"""


def picture(primitives: Sequence[Any], title: str = "", about: str = "") -> bytes:
    """The bytes of a drawing; `title` and `about` are its name and its description for who cannot see it."""
    body = "\n".join(element(part) for part in sorted(primitives, key=lambda part: part.layer))
    return document(body, extent(primitives), title, about)


def document(body: str, box: tuple[float, float, float, float], title: str, about: str, style: str = "") -> bytes:
    """The bytes of an SVG of some elements within a box (left, bottom, right, top)."""
    left, top = number(box[0] - MARGIN), number(-box[3] - MARGIN)
    width, height = number(box[2] - box[0] + 2 * MARGIN), number(box[3] - box[1] + 2 * MARGIN)
    return _DOCUMENT.format(
        left=left, top=top, width=width, height=height, view=f"{left} {top} {width} {height}", family=FAMILY,
        title=words(title), about=f"\n<desc>{words(about)}</desc>" if about else "", style=style, body=body,
        paper=COLOURS["paper"]).encode()


def words(text: str) -> str:
    """Words as text or attribute of XML."""
    return cleaned(text).translate(ESCAPED)


def number(value: float) -> str:
    """A coordinate to a hundredth of a point."""
    return f"{round(value, 2) + 0.0:g}"


def element(part: Any, children: str = "", attributes: str = "") -> str:
    """The element of a primitive."""
    if isinstance(part, LetterRuns):
        return _letters(part, children, attributes)
    if isinstance(part, Circle):
        x, y = part.centre
        name, place = "circle", f'cx="{number(x)}" cy="{number(-y)}" r="{number(part.radius)}"'
    else:
        name, place = "path", f'd="{outline(part)}"'
    filled = getattr(part, "fill", None)
    fill = f' fill="{COLOURS[filled]}"' if filled else ""
    dashes = f' stroke-dasharray="{" ".join(number(part.width * dash) for dash in DASHES)}"' if part.dashed else ""
    style = f'{fill} stroke="{COLOURS[part.role]}" stroke-width="{part.width:g}"{dashes}{attributes}'
    return f"<{name} {place}{style}>{children}</{name}>" if children else f"<{name} {place}{style}/>"


def outline(part: Any) -> str:
    """The path of what has points; y downwards, as SVG has it."""
    if isinstance(part, Polygon):
        return _line(part.points) + "Z"
    return "".join(map(_line, part.strokes()))


def _line(points: tuple[tuple[float, float], ...]) -> str:
    return "M" + " ".join(f"{number(x)},{number(-y)}" for x, y in points)


def _held(text: str) -> str:
    """The letters with what is blank before and after them, which browsers leave out, as blanks that stay."""
    inner = text.strip(" ")
    first = text.find(inner)
    return "\u00a0" * first + inner + "\u00a0" * (len(text) - first - len(inner))


def _letters(part: LetterRuns, children: str, attributes: str) -> str:
    """A text for each run, since Firefox gives no width to parts of one."""
    from vibcli.drawing.layout import lettering

    x, y = part.place
    found = []
    for run in part.runs:
        for text, right, rise in lettering.set_apart(run):
            slant = ' font-style="italic"' if run.slanted else ""
            if text.strip():        # of another font, where this one is not there, letters are as wide as drawn
                own = number(lettering.width((run._replace(text=text),)) - lettering.BESIDE * run.size)
                slant += f' textLength="{own}" lengthAdjust="spacingAndGlyphs"'
            found.append(f'<text x="{number(x + right)}" y="{number(-y - rise)}" '
                         f'font-size="{number(run.size)}"{slant}>{words(_held(text))}</text>')
        x += lettering.width((run,))
    return f'<g fill="{COLOURS[part.role]}"{attributes}>{"".join(found)}{children}</g>'
