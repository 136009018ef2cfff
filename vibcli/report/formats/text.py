"""A report as plain text: sections under their titles, formulas on one line as far as they fit."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import zip_longest
from typing import TYPE_CHECKING, Any

from vibcli.base.decoding import cleaned
from vibcli.notation.numbers import padded, table, width, wrapped
from vibcli.notation.plain import plain
from vibcli.report.blocks import (
    Definitions,
    Document,
    Equations,
    Heading,
    Maths,
    Paragraph,
    Section,
    ShownMatrix,
    TableBlock,
)
from vibcli.report.formats.formula import flat, formula, rows_of_matrix

if TYPE_CHECKING:
    from vibcli.report.blocks import Line

COLUMNS = 98            # of a page of 100: sections are indented by two
SEPARATOR, NO_BREAK = ",  ", "\u2007"       # of statements in a line; what stands for a space within one
OPENS = re.compile("⎛")        # the first row of a matrix
HEAD = re.compile(r"(?<=  )(\S{1,8}) = ")         # what a clause tells, where that is short
LISTING, LEAST = ", ", 12       # what a cell is broken at, and to so many columns at least


def render(documents: Sequence[Document], _: Any = None) -> str:
    """The text of all documents."""
    return "\n\n\n".join(map(_document, documents))


def _document(document: Document) -> str:
    lines = [document.title, "=" * width(document.title)]
    lines += wrapped(f"Source: {document.source}") if document.source else []
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


def _equations(block: Equations) -> list[str]:
    return [line for one in block.lines for line in _line(one)]


def _line(line: "Line") -> list[str]:
    parts = [flat(part, NO_BREAK) for part in line.parts]
    text = formula(line.label, plain) + ":  " * bool(line.label) + formula(parts, plain)
    text = HEAD.sub(f"\\1{NO_BREAK}= ", text).replace("= ", f"={NO_BREAK}")       # at which no line ends
    lines = wrapped(text, COLUMNS, indent=line.hang, first=line.inset) if line.hang is not None else [text] if (
        width(text) <= COLUMNS) else _listed(text)
    matrices = (part for part in line.parts if isinstance(part, ShownMatrix))
    return [row for one in lines for row in _rows(one.replace(NO_BREAK, " "), matrices)]


def _rows(text: str, matrices: Iterator[Any]) -> list[str]:
    """A line, and below it the further rows of its matrices."""
    below = [(width(text[:at.start()]), rows_of_matrix(next(matrices))[1:]) for at in OPENS.finditer(text)]
    lines = [text]
    for rows in zip_longest(*(rows for _, rows in below), fillvalue=""):
        lines.append("")
        for (column, _), row in zip(below, rows, strict=True):
            lines[-1] = padded(lines[-1], column) + row
    return lines


def _listed(text: str) -> list[str]:
    """A line of several statements, broken between them where each fits, else wherever there is a gap."""
    statements = text.split(SEPARATOR)
    if max(map(width, statements)) + 4 > COLUMNS:
        return wrapped(text, COLUMNS, indent=4)
    held = f"{SEPARATOR.rstrip()} ".join(one.replace(" ", NO_BREAK) for one in statements)
    return wrapped(held, COLUMNS, indent=4)


def _paragraph(block: Paragraph) -> list[str]:
    text = running(block.parts)
    if block.hang is None and width(text) <= COLUMNS:
        return [text]
    return wrapped(text, COLUMNS, indent=2 if block.hang is None else block.hang)


def _heading(block: Heading) -> list[str]:
    return ["", *wrapped(block.text, COLUMNS)]


def _table(block: TableBlock) -> list[str]:
    """A table; where it is wider than a page, its lists in several lines and its columns one group below the other."""
    head, rows = list(map(_cell, block.head)), [list(map(_cell, row)) for row in block.rows]
    if _wide(head, rows):
        rows = [line for row in rows for line in _folded(row, _narrow(head, rows))]
    lines: list[str] = []
    for columns in _groups(head, rows):
        lines += [""] * bool(lines)
        lines += table([[row[i] for i in columns] for row in rows], [head[i] for i in columns])
    return lines


def _wide(head: Sequence[str], rows: Sequence[Sequence[str]]) -> bool:
    return sum(_widths(head, rows)) + 2 * (len(head) - 1) > COLUMNS


def _widths(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[int]:
    return [max(width(row[i]) for row in (head, *rows)) for i in range(len(head))]


def _narrow(head: Sequence[str], rows: Sequence[Sequence[str]]) -> dict[int, int]:
    """{column of lists: the width that it is folded to}, so that the table fits, if it can."""
    widths = _widths(head, rows)
    lists = [i for i in range(len(head)) if any(LISTING in row[i] for row in rows)]
    left = COLUMNS - 2 * (len(head) - 1) - sum(size for i, size in enumerate(widths) if i not in lists)
    return {i: max(LEAST, left // len(lists), width(head[i])) for i in lists}


def _folded(row: Sequence[str], sizes: Mapping[int, int]) -> list[list[str]]:
    """The lines of a row whose lists are broken."""
    cells = [wrapped(cell, sizes[i], indent=0) or [""] if i in sizes else [cell] for i, cell in enumerate(row)]
    return [list(line) for line in zip_longest(*cells, fillvalue="")]


def _groups(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[list[int]]:
    """The numbers of the columns of each table, the first in all of them."""
    widths, found = _widths(head, rows), [[0]]
    for i in range(1, len(head)):
        if len(found[-1]) > 1 and sum(widths[j] + 2 for j in found[-1]) + widths[i] > COLUMNS:
            found.append([0])
        found[-1].append(i)
    return found


def _cell(cell: str | Maths) -> str:
    return running((cell,))


def _definitions(block: Definitions) -> list[str]:
    texts = [running(item.term) + (block.gap + item.about if item.about else "") for item in block.items]
    if block.flowing:
        return wrapped(block.gap.join(texts), COLUMNS, gap=block.gap)
    return [line for text in texts for line in wrapped(text, COLUMNS, indent=4)]


def _nothing(_: Any) -> list[str]:
    return []


_RENDER: dict[type, Callable[[Any], list[str]]] = {
    Equations: _equations, Paragraph: _paragraph, Heading: _heading, TableBlock: _table,
    Definitions: _definitions}
