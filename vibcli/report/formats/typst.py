"""A report as a Typst document, complete in itself but for its pictures."""

import re
from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from typing import Any

from vibcli.base.decoding import on_one_line
from vibcli.notation.numbers import width
from vibcli.notation.plain import plain
from vibcli.notation.typst import quoted, typst
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
from vibcli.report.formats.formula import INDEXED, apart, formula, rows, without_words
from vibcli.report.formats.latex import is_signed

COLUMNS = 95        # of plain text, in a row of a formula
TOGETHER = 12       # rows that one alignment, or a table that stays on a page, has at most
WIDEST = 85         # characters of a row of a table that surely fits a page,
GAP = 2             # with those that a gap between its columns takes
WORDS = 20          # characters that are left at least to a column that is broken into lines
_SPECIAL = re.compile(r"[\\#$*_`<>@~\[\]]|-(?=[-?\d])|\.(?=\.\.)|/(?=[/*])")
_STARTING = re.compile(r"[-+=/]|\d+\.")
HEAD = """\
#let fitted(it) = layout(size => {
  let wide = measure(it).width
  if wide > size.width { scale(size.width / wide * 100%, origin: left, reflow: true, it) } else { it }
})
#let picture(file, words) = figure(layout(size => {
  let drawn = measure(image(file))
  image(file, width: calc.min(drawn.width, 0.95 * size.width, drawn.width / drawn.height * tallest))
}), caption: words, numbering: none)
#set page(paper: "a4", margin: 22mm, numbering: "1")
#set text(size: 10.5pt)
#set smartquote(enabled: false)
#set table(stroke: none, inset: (x: 0.6em, y: 0.35em), align: left)
#set math.equation(numbering: none)
#show math.equation.where(block: true): set align(left)
#show math.equation.where(block: true): set block(breakable: true, spacing: 0.85em)
#show math.equation.where(block: true): it => pad(left: 1.5em, fitted(it))
#show heading: set block(above: 1.3em, below: 0.7em)
"""


def escaped(text: str) -> str:
    """Words that Typst shows as they are; blanks at which no line is broken stay so."""
    return _SPECIAL.sub(r"\\\g<0>", on_one_line(text)).replace("\N{NO-BREAK SPACE}", "~")


def beginning(text: str) -> str:
    """What begins a line, so that it begins no list, heading or term."""
    text = text.strip()
    start = _STARTING.match(text)
    return text if start is None else f"{text[:start.end() - 1]}\\{text[start.end() - 1:]}"


def render(documents: Sequence[Document], place: Callable[[Picture], str] | None, apart: bool = True) -> str:
    """The Typst of all documents; `place(picture)` is the name of the file that a picture is written to; `apart`: each
    on pages of its own, else with less high figures."""
    title = f"#set document(title: {quoted(documents[0].title)})\n#let tallest = {9 if apart else 7}cm\n"
    between = "\n#pagebreak()\n" if apart else "\n"
    return title + HEAD + between.join("\n".join(_document(one, place)) for one in documents)


def _document(document: Document, place: Callable[[Picture], str] | None) -> Iterator[str]:
    yield f"= {escaped(document.title)}\n"
    if document.source:
        yield f"Source: {escaped(document.source)}\n"
    if document.question:
        yield beginning(_running(document.question)) + "\n"
    for section in document.sections:
        yield f"== {escaped(section.title)}\n"
        yield from (_picture(block, place) if isinstance(block, Picture) else _RENDER[type(block)](block)
                    for block in section.blocks)
    if document.refusal:
        yield _refusal(document.refusal)


def _running(parts: Sequence[str | Maths]) -> str:
    return "".join(f"${formula(part.parts, typst)}$" if isinstance(part, Maths) else escaped(part)
                   for part in without_words(parts))


def _equations(block: Equations) -> str:
    """Formulas, broken where they are long: few lines as one alignment, labels before them; many one by one, since what
    is made smaller stays on one page."""
    lines = []
    for line in block.lines:
        first, *others = rows(line.parts, typst, COLUMNS)
        label = f"{formula(line.label, typst)}: quad " if line.label else ""
        lines.append([f"{label}& {first}", *(f"& quad {other}" for other in others)])
    together = [list(chain(*lines))] if sum(map(len, lines)) <= TOGETHER else lines
    return "\n".join("$ " + " \\\n  ".join(one) + " $\n" for one in together)


def _paragraph(block: Paragraph) -> str:
    """Running text; a formula that is wider than a line stands apart."""
    return "".join(beginning(_running(one.parts)) + "\n" if isinstance(one, Paragraph) else _equations(one)
                   for one in apart(block.parts, COLUMNS))


def _heading(block: Heading) -> str:
    return f"=== {escaped(block.text.rstrip(':'))}\n"


def _table(block: TableBlock) -> str:
    """A table; where it may be too wide, the words of its widest column are broken, or all of it is made smaller."""
    rows_of_all = [block.head, *block.rows]
    sizes = [max(map(_size, column)) for column in zip(*rows_of_all, strict=True)]
    widest, total = max(sizes), sum(sizes) + GAP * len(sizes)
    broken = total > WIDEST and total - widest < WIDEST - WORDS
    columns = ", ".join("1fr" if broken and i == sizes.index(widest) else "auto" for i in range(len(sizes)))
    head, *body = (", ".join(map(_cell, row)) for row in rows_of_all)
    head = INDEXED.sub(r"$\1_\2$", head)
    lines = "".join(f"  {row},\n" for row in body)
    table = f"table(columns: ({columns},),\n  table.header({head}),\n  table.hline(stroke: 0.5pt),\n{lines})"
    if total > WIDEST and not broken:
        return f"#fitted({table})\n"
    return f"#block(breakable: false, {table})\n" if len(block.rows) <= TOGETHER else f"#{table}\n"


def _size(cell: str | Maths) -> int:
    """Of a cell, in characters of plain text."""
    return width(formula(cell.parts, plain) if isinstance(cell, Maths) else cell)


def _cell(cell: str | Maths) -> str:
    return f"[${typst.numeral(cell)}$]" if is_signed(cell) else f"[{beginning(_running((cell,)))}]"


def _definitions(block: Definitions) -> str:
    items = [_running(item.term) + (f" #h(1em) {escaped(item.about)}" if item.about else "") for item in block.items]
    return (" #h(1.5em)\n".join(f"#box[{item}]" for item in items) if block.flowing else
            " \\\n".join(map(beginning, items))) + "\n"


def _refusal(refusal: Refusal) -> str:
    return f"*Not found:* {refusal.told(escaped)}\n"


def _picture(block: Picture, place: Callable[[Picture], str] | None) -> str:
    return f"#picture({quoted(place(block))}, [{escaped(block.caption)}])\n"


_RENDER: dict[type, Callable[[Any], str]] = {
    Equations: _equations, Paragraph: _paragraph, Heading: _heading, TableBlock: _table,
    Definitions: _definitions, Refusal: _refusal}
