"""Diagnostics as plain text: place, source line with a caret, hint; nothing in it can steer a terminal."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.base.errors import Diagnostic

ROOM = 100  # columns of a source line that are shown; longer lines are cut around the caret
LONGEST = 500  # characters of a message


def escaped(text: str) -> str:
    """The text with every character that does not print (controls, bidi, no-break spaces …) spelt out."""
    if text.isprintable():
        return text
    return "".join(map(_cell, text))


def lines_escaped(text: str) -> str:
    """The same of a text of several lines."""
    return "\n".join(map(escaped, text.split("\n")))


def quoted(text: str, room: int = 40) -> str:
    """The text for use inside a message: in single quotes, escaped, cut where it is long."""
    return f"'{escaped(text if len(text) <= room else text[: room - 1] + '…')}'"


def distinct_figures(a: float, b: float) -> tuple[str, str]:
    """Two numbers that differ, with six digits or as many as tell them apart."""
    return next((f"{a:.{digits}g}", f"{b:.{digits}g}") for digits in (6, 9, 12, 17)
                if digits == 17 or f"{a:.{digits}g}" != f"{b:.{digits}g}")


def render(diagnostic: "Diagnostic", lines: Sequence[str], color: bool = False) -> str:
    """`file:line:column: error: message`, the source line, a caret line, the hint. A place of width 0 means the file as
    a whole: neither line nor column is named then."""
    bold, red, blue, plain = ("\x1b[1m", "\x1b[1;31m", "\x1b[36m", "\x1b[0m") if color else ("", "", "", "")
    where, parts = diagnostic.where, []
    if where:
        place = escaped(where.file) + (f":{where.line}:{where.column}" if where.width else "")
        parts.append(f"{bold}{place}:{plain} ")
    parts.append(f"{red}{diagnostic.WORD}:{plain} {_bounded(diagnostic.message)}")
    if where and where.width and 1 <= where.line <= len(lines):
        source, caret = _excerpt(lines[where.line - 1], where.column - 1, where.width)
        parts.append(f"\n  {source}\n  {red}{caret}{plain}")
    if diagnostic.hint:
        parts.append(f"\n{blue}hint:{plain} {_bounded(diagnostic.hint)}")
    return "".join(parts)


def _bounded(text: str) -> str:
    return escaped(text if len(text) <= LONGEST else text[: LONGEST - 1] + "…")


def _cell(char: str) -> str:
    return char if char.isprintable() else char.encode("unicode_escape").decode("ascii")


def _columns(cell: str) -> int:
    """Terminal columns of one shown character (two for East Asian wide ones, none for combining marks)."""
    if cell.isascii():
        return len(cell)
    import unicodedata

    if unicodedata.combining(cell):
        return 0
    return 2 if unicodedata.east_asian_width(cell) in "WF" else 1


def _excerpt(line: str, start: int, width: int) -> tuple[str, str]:
    """A line of at most about ROOM columns that holds the caret, and the caret line beneath it."""
    start = min(max(start, 0), len(line))
    end = min(start + max(width, 1), max(len(line), start + 1))
    first = 0 if end <= ROOM else max(0, start - ROOM // 4)
    cells = [_cell(char) for char in line[first : first + ROOM]]
    before, under = _widths(cells[: start - first]), _widths(cells[start - first : end - first])
    if before > ROOM:  # escapes take several columns each: start at the caret instead
        cells, first, before = cells[start - first :], start, 0
    cells, under = _fitting(cells, ROOM), min(under, ROOM - before)
    head = "…" if first else ""
    tail = "…" if first + len(cells) < len(line) else ""
    return head + "".join(cells) + tail, " " * (len(head) + before) + "^" * max(under, 1)


def _widths(cells: list[str]) -> int:
    return sum(map(_columns, cells))


def _fitting(cells: list[str], room: int) -> list[str]:
    for count, cell in enumerate(cells):
        room -= _columns(cell)
        if room < 0:
            return cells[:count]
    return cells
