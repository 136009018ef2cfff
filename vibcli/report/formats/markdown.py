"""A report as Markdown as GitHub reads it: mathematics between dollars, tables with bars."""

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from vibcli.base.decoding import on_one_line
from vibcli.notation.latex import Latex
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

_SPECIAL = re.compile(r"[\\`*_#|~]|\](?=[(\[:])")
_OTHERS = {"&": "&amp;", "<": "&lt;", ">": "&gt;", "$": r"<span>\$</span>", "://": r":\//", "www.": r"www\."}
_OTHER = re.compile("|".join(map(re.escape, _OTHERS)), re.IGNORECASE)


_WIDE: dict[str, str | int] = {letter: chr(ord(letter) + 0xFEE0) for letter in r"\${}%&#_^~<>`"}


class Protected(Latex):
    """LaTeX that Markdown leaves as it is, should it look into formulas: no backslash before a sign, no index that
    could begin emphasis. Web pages read words within it as they stand: what is special is written as a wide letter."""

    thin, thick, newline = r"\mkern3mu", r"\mkern5mu", r"\cr"

    def word(self, text: str) -> str:
        first, _, rest = text.partition("_")
        return self.indexed(rf"\mathrm{{{first}}}", self.word(rest)) if rest else rf"\mathrm{{{first}}}"

    def indexed(self, letter: str, below: str) -> str:
        return f"{letter} _ {{{below}}}"

    def words(self, text: Any) -> str:
        return rf"\text{{{on_one_line(text).translate(str.maketrans(_WIDE))}}}" if text else ""


latex = Protected()


def escaped(text: str) -> str:
    """Words that Markdown shows as they are: no link, markup, formula or HTML."""
    text = _SPECIAL.sub(r"\\\g<0>", on_one_line(text))
    return _OTHER.sub(lambda found: _OTHERS[found[0].lower()], text)


def beginning(text: str) -> str:
    """What begins a line, so that it begins neither a list nor a rule."""
    text = text.strip()
    if re.match(r"[-+=]", text):
        return "\\" + text
    return re.sub(r"^(\d+)([.)])", r"\1\\\2", text)


def render(documents: Sequence[Document], place: Callable[[Picture], str] | None) -> str:
    """The Markdown of all documents; `place(picture)` is the name of the file that a picture is written to."""
    return "\n\n".join(part for document in documents for part in _document(document, place))


def _document(document: Document, place: Callable[[Picture], str] | None) -> Iterator[str]:
    yield f"# {escaped(document.title)}"
    if document.source:
        yield f"Source: {escaped(document.source)}"
    if document.question:
        yield beginning(_running(document.question))
    for section in document.sections:
        yield f"## {escaped(section.title)}"
        for block in section.blocks:
            yield _picture(block, place) if isinstance(block, Picture) else _RENDER[type(block)](block)
    if document.refusal:
        yield _refusal(document.refusal)


def _running(parts: Sequence[str | Maths], bar: str = "|") -> str:
    return "".join(f"${formula(part.parts, latex).replace('|', bar)}$" if isinstance(part, Maths) else escaped(part)
                   for part in without_words(parts))


def _equations(block: Equations) -> str:
    """A display each, in an alignment where a formula has a label or is broken."""
    found = aligned(block, latex)
    if len(found) == 1 and not block.lines[0].label:
        return f"$$\n{re.sub(r'& {} (?![-+=])|& ', '', found[0], count=1)}\n$$"
    text = " \\cr\n".join(found)
    return f"$$\n\\begin{{aligned}}\n{text}\n\\end{{aligned}}\n$$"


def _paragraph(block: Paragraph) -> str:
    """Running text; a formula that is wider than a line stands apart."""
    return "\n\n".join(beginning(_running(one.parts)) if isinstance(one, Paragraph) else _equations(one)
                       for one in apart(block.parts, COLUMNS))


def _heading(block: Heading) -> str:
    return f"### {escaped(block.text.rstrip(':'))}"


def _table(block: TableBlock) -> str:
    head, *body = ("| " + " | ".join(map(_cell, row)) + " |" for row in (block.head, *block.rows))
    return "\n".join([INDEXED.sub(r"$\1 _ \2$", head), "|" + " --- |" * len(block.head), *body])


def _cell(cell: str | Maths) -> str:
    return f"${latex.numeral(cell)}$" if is_signed(cell) else _running((cell,), r"\vert ")


def _definitions(block: Definitions) -> str:
    items = [_running(item.term) + (f" — {escaped(item.about)}" if item.about else "") for item in block.items]
    return ",\n".join(items) if block.flowing else "\n".join(f"- {item}" for item in items)


def _refusal(refusal: Refusal) -> str:
    return f"**Not found:** {refusal.told(escaped)}"


def _picture(block: Picture, place: Callable[[Picture], str] | None) -> str:
    return f"![{escaped(block.caption)}]({place(block)})"


_RENDER: dict[type, Callable[[Any], str]] = {
    Equations: _equations, Paragraph: _paragraph, Heading: _heading, TableBlock: _table,
    Definitions: _definitions, Refusal: _refusal}
