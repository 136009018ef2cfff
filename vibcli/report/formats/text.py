"""A report as plain text: sections under their titles, formulas on one line as far as they fit."""

from collections.abc import Sequence
from typing import Any

from vibcli.base.decoding import cleaned
from vibcli.notation.numbers import table, width, wrapped
from vibcli.notation.plain import plain
from vibcli.report.blocks import Definitions, Document, Equations, Heading, Maths, Paragraph, Section, TableBlock
from vibcli.report.formats.formula import formula

COLUMNS = 100
NARROW = 98     # of what explains the lines above


def render(documents: Sequence[Document], _: Any = None) -> str:
    """The text of all documents."""
    return "\n\n\n".join(map(_document, documents))


def _document(document):
    lines = [document.title, "=" * width(document.title)]
    lines += [f"Source: {document.source}"] if document.source else []
    lines += ["", *wrapped(running(document.question), indent=0)] if document.question else []
    return shown(lines + section_lines(document.sections))


def section_lines(sections: Sequence[Section]) -> list[str]:
    """Lines of sections, each after an empty one."""
    lines = []
    for section in sections:
        body = [line for block in section.blocks for line in _RENDER.get(type(block), _nothing)(block)]
        lines += ["", section.title, *(("  " + line).rstrip() for line in body)]
    return lines


def shown(lines: Sequence[str]) -> str:
    return cleaned("\n".join(lines)).replace("\u00a0", " ")


def running(parts: Sequence[str | Maths]) -> str:
    """Words and Maths as text."""
    return "".join(formula(part.parts, plain) if isinstance(part, Maths) else part for part in parts)


def _equations(block):
    return [line for one in block.lines for line in _line(one)]


def _line(line):
    text = formula(line.label, plain) + ":  " * bool(line.label) + formula(line.parts, plain)
    return [text] if line.hang is None else wrapped(text, COLUMNS, indent=line.hang, first=line.inset)


def _paragraph(block):
    text = running(block.parts)
    return [text] if block.hang is None else wrapped(text, NARROW if block.aside else COLUMNS, indent=block.hang)


def _heading(block):
    return ["", block.text]


def _table(block):
    return table([list(map(_cell, row)) for row in block.rows], list(map(_cell, block.head)))


def _cell(cell):
    return running((cell,))


def _definitions(block):
    texts = [running(item.term) + (block.gap + item.about if item.about else "") for item in block.items]
    return wrapped(block.gap.join(texts), COLUMNS, gap=block.gap) if block.flowing else texts


def _nothing(_):
    return []


_RENDER = {Equations: _equations, Paragraph: _paragraph, Heading: _heading, TableBlock: _table,
           Definitions: _definitions}
