"""A report as AsciiDoc: mathematics in LaTeX as `stem`, tables between bars."""

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from vibcli.base.decoding import on_one_line
from vibcli.notation.latex import latex
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
from vibcli.report.formats.formula import INDEXED, apart, formula, without_words
from vibcli.report.formats.latex import COLUMNS, aligned, is_signed

_SPECIAL = re.compile(r"[*_`#^~+{<>&|\\@]|(?<!\s)\[|\[(?=\[)|:(?=[:/])|\((?=\(|[CR]\)|TM\))|(?<=-)-|\.(?=\.\.)|"
                      r"(?<![\w\s)]);")
_PLAIN = re.compile(r"(?:stem:|[^\W\d_]+[ ,;])")     # what may begin a line as it stands


def escaped(text: str) -> str:
    """Words that AsciiDoc shows as they are: what could be markup is a character by its number."""
    return _SPECIAL.sub(lambda found: f"&#{ord(found[0])};", on_one_line(text))


def beginning(text: str) -> str:
    """What begins a line, so that it begins no list, title, block or note."""
    text = text.strip()
    return text if _PLAIN.match(text) else "{empty}" + text


def render(documents: Sequence[Document], place: Callable[[Picture], str] | None) -> str:
    """The AsciiDoc of all documents, those after the first as chapters of it; `place(picture)` is the name of the file
    that a picture is written to."""
    return "\n\n".join(part for i, document in enumerate(documents) for part in _document(document, place, i > 0))


def _document(document: Document, place: Callable[[Picture], str] | None, chapter: bool) -> Iterator[str]:
    level = "=" * (1 + chapter)
    yield f"{level} {escaped(document.title)}" + "\n:stem: latexmath" * (not chapter)
    if document.source:
        yield f"Source: {escaped(document.source)}"
    if document.question:
        yield beginning(_running(document.question))
    for section in document.sections:
        yield f"{level}= {escaped(section.title)}"
        for block in section.blocks:
            if isinstance(block, Heading):
                yield f"{level}== {escaped(block.text.rstrip(':'))}"
            else:
                yield _picture(block, place) if isinstance(block, Picture) else _RENDER[type(block)](block)
    if document.refusal:
        yield _refusal(document.refusal)


def _running(parts: Sequence[str | Maths]) -> str:
    return "".join(_stem(formula(part.parts, latex)) if isinstance(part, Maths) else escaped(part)
                   for part in without_words(parts))


def _stem(text: str) -> str:
    text = text.replace("|", r"\vert ").replace("]", r"\]")
    return f"stem:[{text}]"


def _equations(block: Equations) -> str:
    """A display, in an alignment where a formula has a label or is broken."""
    found = aligned(block, latex)
    if len(found) == 1 and not block.lines[0].label:
        text = re.sub(r"& {} (?![-+=])|& ", "", found[0], count=1)
    else:
        text = "\\begin{aligned}\n" + " \\\\\n".join(found) + "\n\\end{aligned}"
    return f"[stem]\n++++\n{text}\n++++"


def _paragraph(block: Paragraph) -> str:
    """Running text; a formula that is wider than a line stands apart."""
    return "\n\n".join(beginning(_running(one.parts)) if isinstance(one, Paragraph) else _equations(one)
                       for one in apart(block.parts, COLUMNS))


def _table(block: TableBlock) -> str:
    head, *body = ("".join(f"|{_cell(cell)} " for cell in row).rstrip() for row in (block.head, *block.rows))
    return "\n".join(["[%autowidth,options=header]", "|===", INDEXED.sub(r"stem:[\1_\2]", head), "", *body, "|==="])


def _cell(cell: str | Maths) -> str:
    return _stem(latex.numeral(cell)) if is_signed(cell) else _running((cell,))


def _definitions(block: Definitions) -> str:
    items = [_running(item.term) + (f" — {escaped(item.about)}" if item.about else "") for item in block.items]
    return beginning(",\n".join(items)) if block.flowing else "\n".join(f"* {beginning(item)}" for item in items)


def _refusal(refusal: Refusal) -> str:
    return f"*Not found:* {refusal.told(escaped)}"


def _picture(block: Picture, place: Callable[[Picture], str] | None) -> str:
    caption = escaped(block.caption).replace('"', "&#34;").replace("]", "&#93;")
    return f'image::{place(block)}["{caption}"]'


_RENDER: dict[type, Callable[[Any], str]] = {
    Equations: _equations, Paragraph: _paragraph, TableBlock: _table, Definitions: _definitions,
    Refusal: _refusal}
