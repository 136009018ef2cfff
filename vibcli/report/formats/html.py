"""A report as one HTML page that opens offline: formulas as MathML with their plain text beside, pictures inline."""

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.mathml import mathml, row
from vibcli.notation.plain import plain
from vibcli.report.blocks import (
    Definitions,
    Document,
    Equations,
    Heading,
    Maths,
    Paragraph,
    Picture,
    Refusal,
    TableBlock,
)
from vibcli.report.formats.formula import INDEXED, formula, rows, without_words
from vibcli.report.formats.html_page import page, words
from vibcli.report.formats.latex import is_signed

if TYPE_CHECKING:
    from vibcli.report.blocks import Line

COLUMNS = 105       # of plain text, in a row of a formula
DISPLAYED = ' displaystyle="true"'
_PROLOGUE = re.compile(r"<\?xml.*?\?>|<!DOCTYPE[^>]*>|<metadata>.*?</metadata>", re.DOTALL)
_GAPS = re.compile(r"<path(?![^>]*\sd=)")       # letters without strokes, as gaps are drawn
_TEXT = re.compile(r'<text[^>]* font-size="([^"]*)"')
_WIDE = re.compile(r'<svg\b[^>]*? width="([\d.]+)pt"')
READABLE = 8.5      # pixels of a screen: the least size of the main letters of a picture
LOWERED = r"\1<sub>\2</sub>"
_DEFINED = re.compile(r'\bid="|href="#|url\(#')


def render(documents: Sequence[Document], _: Callable[[Picture], str] | None = None, listed: bool = True) -> str:
    """The page with all documents, the first at its top, the others below it as cases; `listed`: with their list."""
    contents = _contents(documents) if listed and len(documents) > 1 else ""
    articles = [article(number, document) for number, document in enumerate(documents)]
    return page(documents[0].title, contents + "\n".join(articles))


def fragment(document: Document) -> str:
    """One document as a piece of a page."""
    return article(0, document)


def _contents(documents: Sequence[Document]) -> str:
    items = "".join(f'<li><a href="#scene{i}">{words(one.title)}</a></li>' for i, one in enumerate(documents))
    return f'<nav aria-label="Contents"><ul>{items}</ul></nav>\n'


def article(number: int, document: Document) -> str:
    """One document as the part of a page that has this number."""
    level = 2 if number else 1
    parts = [f'<article id="scene{number}">\n<h{level}>{words(document.title)}</h{level}>']
    parts += [f'<p class="source">Source: {words(document.source)}</p>'] if document.source else []
    parts += [f'<p class="question">{_running(document.question)}</p>'] if document.question else []
    for section in document.sections:
        parts.append(f"<section>\n<h{level + 1}>{words(section.title)}</h{level + 1}>")
        parts += [_RENDER[type(block)](block, level + 2) for block in section.blocks]
        parts.append("</section>")
    parts += [_refusal(document.refusal, level)] if document.refusal else []
    return "\n".join([*parts, "</article>"])


def _math(inner: str, said: str, displayed: str = "") -> str:
    return f'<math alttext="{words(said)}"{displayed}>{inner}</math>'


def _said(parts: Sequence[Any]) -> str:
    return formula(parts, plain).replace("\u00a0", " ").strip()


def _running(parts: Sequence[str | Maths]) -> str:
    return "".join(_math(row(formula(part.parts, mathml)), _said(part.parts)) if isinstance(part, Maths)
                   else words(part) for part in without_words(parts))


def _equations(block: Equations, _: int) -> str:
    return "\n".join(map(_equation, block.lines))


def _equation(line: "Line") -> str:
    """A formula on its own line; where it is long, as the rows of a table, the later ones set in."""
    label = ""
    if line.label:
        label = f'<span class="label">{_math(row(formula(line.label, mathml)), _said(line.label))}:</span>'
    first, *others = rows(line.parts, mathml, COLUMNS)
    inner = row(first)
    if others:
        cells = [first, *(f'<mspace width="2em"/>{other}' for other in others)]
        inner = (f'<mtable columnalign="left"{DISPLAYED}>'
                 + "".join(f"<mtr><mtd>{row(cell)}</mtd></mtr>" for cell in cells) + "</mtable>")
    return f'<div class="equation">{label}{_math(inner, _said(line.parts), DISPLAYED)}</div>'


def _paragraph(block: Paragraph, _: int) -> str:
    return f"<p>{_running(block.parts).strip()}</p>"


def _heading(block: Heading, level: int) -> str:
    return f"<h{level}>{words(block.text.rstrip(':'))}</h{level}>"


def _table(block: TableBlock, _: int) -> str:
    head = "".join(f'<th scope="col">{INDEXED.sub(LOWERED, _cell(cell))}</th>' if cell else "<td></td>"
                   for cell in block.head)
    body = "\n".join(map(_row, block.rows))
    return f'<div class="wide"><table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table></div>'


def _row(cells: Sequence[str | Maths]) -> str:
    first, *others = map(_cell, cells)
    return f'<tr><th scope="row">{first}</th>{"".join(f"<td>{cell}</td>" for cell in others)}</tr>'


def _cell(cell: str | Maths) -> str:
    if is_signed(cell):
        return words(cell.replace("-", "−")) if "e" not in cell else _math(row(mathml.numeral(cell)), cell)
    return _running((cell,))


def _definitions(block: Definitions, _: int) -> str:
    items = "\n".join(f"<li>{_running(item.term)}"
                      + (f' <span class="about">{words(item.about)}</span>' if item.about else "") + "</li>"
                      for item in block.items)
    return f'<ul class="items{" flowing" * block.flowing}">\n{items}\n</ul>'


def _refusal(refusal: Refusal, _: int) -> str:
    return f'<p class="refusal" role="note"><strong>Not found:</strong> {refusal.told(words)}</p>'


def _picture(block: Picture, _: int) -> str:
    """The SVG, as wide as the page as long as its letters can be read, with names of its own for what it defines, so
    that pictures of one page do not mix."""
    drawn = block.draw("svg") if block.animated is None else block.animated()
    svg = _PROLOGUE.sub("", drawn.decode()).strip()
    svg = _DEFINED.sub(rf"\g<0>{re.sub('[^A-Za-z0-9]', '-', block.name)}-", svg)
    svg = _GAPS.sub('<path d=""', svg)
    return f"<figure>{_readable(svg)}<figcaption>{words(block.caption)}</figcaption></figure>"


def _readable(svg: str) -> str:
    """The SVG, at least so wide that its main letters can be read."""
    letters, wide = _TEXT.findall(svg), _WIDE.match(svg)
    if not letters or wide is None:
        return svg
    least = READABLE * float(wide[1]) / max(map(float, letters))
    return svg.replace("<svg ", f'<svg style="min-width: {least:.0f}px" ', 1)


_RENDER: dict[type, Callable[[Any, int], str]] = {
    Equations: _equations, Paragraph: _paragraph, Heading: _heading, TableBlock: _table,
    Definitions: _definitions, Refusal: _refusal, Picture: _picture}
