"""Columns of numbers in a text file that lies beside a scene: CSV, or columns apart by blanks.

The file is only ever read as text: of a bounded size, from the folder of the scene or below it.
"""

import os
import stat
from array import array
from collections.abc import Callable, Sequence
from math import isfinite

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, Where

MAX_BYTES, MAX_ROWS, MAX_PROBLEMS = 100 * 2**20, 2_000_000, 5
SEPARATORS = (";", ",", "\t")


class Columns:
    """`header`: the names of the columns, None without; `texts`: of each row of numbers, `lines`: its number in the
    file."""

    __slots__ = ("count", "file", "header", "lines", "separator", "texts")

    def __init__(self, file: str, separator: str | None, header: Sequence[str] | None, lines: Sequence[int],
                 texts: Sequence[str]) -> None:
        self.file, self.separator, self.header, self.lines, self.texts = file, separator, header, lines, texts
        self.count = len(header or texts[0].split(separator))

    def numbers(self, i: int, report: Callable[[Where, str, str], None]) -> Sequence[float] | None:
        """The numbers of column i, from 0; None where one of them is none, after `report(where, message, hint)`."""
        found = self._plain(i)
        return self._checked(i, report) if found is None else found

    def _plain(self, i: int) -> list[float] | None:
        """The same where all rows are plain at the first look; else None."""
        count, separator, found = self.count, self.separator, []
        try:
            for text in self.texts:
                row = text.split(separator)
                cell = row[i]
                if len(row) != count or not cell.isascii() or "_" in cell:
                    return None
                found.append(float(cell))
        except (ValueError, IndexError):
            return None
        return found if all(map(isfinite, found)) else None

    def _checked(self, i: int, report: Callable[[Where, str, str], None]) -> list[float] | None:
        found, wrong = [], 0
        for line, text in zip(self.lines, self.texts, strict=True):
            cells = text.split(self.separator)
            value = _number(cells[i]) if i < len(cells) == self.count else None
            if value is None:
                wrong += 1
                if wrong <= MAX_PROBLEMS:
                    report(*self._not_a_number(line, text, i))
            found.append(value)
        return None if wrong else found

    def place(self, row: int, i: int) -> Where:
        """The place of the cell of a row (from 0) and a column."""
        return self._cell(self.lines[row], self.texts[row], i)[0]

    def _cell(self, line: int, text: str, i: int) -> tuple[Where, str]:
        """(place, text) of a cell."""
        at, cells = 0, text.split(self.separator)
        for cell in cells[:i]:
            at = text.index(cell, at) + len(cell) + len(self.separator or "")
        at = text.index(cells[i], at)
        inner = cells[i].strip()
        return Where(self.file, line, at + 1 + cells[i].find(inner), max(len(inner), 1)), inner

    def _not_a_number(self, line: int, text: str, i: int) -> tuple[Where, str, str]:
        cells = text.split(self.separator)
        if len(cells) != self.count:
            more = self.separator == "," and len(cells) > self.count
            hint = "every row has the same columns" + ("; decimals are written with a point: 0.5" if more else "")
            return Where(self.file, line, 1, max(len(text), 1)), (
                f"expected {self.count} columns, found {len(cells)}"), hint
        where, cell = self._cell(line, text, i)
        comma = self.separator != "," and "," in cell
        hint = "decimals are written with a point: 0.5" if comma else "write a finite number such as 0.5 or 1e-3"
        if line == self.lines[0] and self.header is None and _is_name(cell):
            hint = "a first line of names has a name for every column"
        return where, f"expected a number, found {quoted(cell) if cell else 'nothing'}", hint


def _number(text: str) -> float | None:
    text = text.strip().strip('"')
    try:
        value = float(text)
    except ValueError:
        return None
    return value if value - value == 0 and text.isascii() and "_" not in text else None


def _is_name(text: str) -> bool:
    """Does a cell look like the name of a column: is it no number, not even one with a slip such as 1.O or 1e400?"""
    text = text.strip().strip('"').strip()
    try:
        float(text)     # nan and inf too
    except ValueError:
        return any(map(str.isalpha, text)) and not (text[0].isdigit() or text[0] in "+-−.,")
    return False


def read_columns(scene: str, name: str) -> tuple[Columns | None, tuple[str, str] | Diagnostic | None]:
    """(Columns, None) of the file `name` beside the file `scene`, or (None, (message, hint) or Diagnostic)."""
    data, problem = data_beside(scene, name)
    return (None, problem) if data is None else columns_in(scene, name, data)


def columns_in(scene: str, name: str, data: bytes) -> tuple[Columns | None, Diagnostic | None]:
    """The same of what such a file holds."""
    return _parsed(os.path.join(os.path.dirname(scene) or ".", name), data)


def data_beside(scene: str, name: str) -> tuple[bytes | None, tuple[str, str] | None]:
    """(what stands in the file `name` beside the file `scene`, None), or (None, (message, hint))."""
    folder = os.path.dirname(scene) or "."
    path = os.path.join(folder, name)
    problem = _outside(folder, path, name)
    if problem:
        return None, problem
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):     # a pipe without writer would wait for ever
            return None, (f"{quoted(name)} is no file", "give the name of a text file with columns of numbers")
        with open(path, "rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except (FileNotFoundError, NotADirectoryError):
        return None, (f"there is no file {quoted(name)} beside the scene", _near(path))
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        return None, (f"{quoted(name)} cannot be read: {reason.lower()}", "give the name of a readable file")
    if len(data) > MAX_BYTES:
        return None, (f"{quoted(name)} holds more than {MAX_BYTES // 2**20} MB", "thin the record out, or cut it")
    return data, None


def _outside(folder: str, path: str, name: str) -> tuple[str, str] | None:
    """The fault of a name that leads out of the folder of the scene."""
    parts = name.replace("\\", "/").split("/")
    if not name.strip() or "\0" in name or os.path.isabs(name) or name.startswith("\\") or ".." in parts or ":" in name:
        return (f"expected the name of a file beside the scene, found {quoted(name)}",
                "it lies in the folder of the scene or below it: quake.csv, data/quake.csv")
    base = os.path.realpath(folder)
    if os.path.commonpath([base, os.path.realpath(path)]) != base:
        return f"{quoted(name)} leads out of the folder of the scene", "copy the file there"
    return None


def _near(path: str) -> str:
    from difflib import get_close_matches

    folder, name = os.path.split(path)
    try:
        near = get_close_matches(name, os.listdir(folder or "."), 1)
    except OSError:
        near = ()
    return f"did you mean '{near[0]}'?" if near else "it lies in the folder of the scene or below it"


def _parsed(path: str, data: bytes) -> tuple[Columns | None, Diagnostic | None]:
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = 1 + data.count(b"\n", 0, error.start)
        return None, Diagnostic(Where(path, line, 1), "this line is not UTF-8", "save the file as UTF-8 text")
    lines, texts = array("L"), []
    for line, row in enumerate(text.replace("\r\n", "\n").split("\n"), 1):
        start = row.lstrip()[:1]
        if start and start != "#":
            lines.append(line)
            texts.append(row)
    if len(texts) > MAX_ROWS:
        return None, Diagnostic(Where(path, lines[MAX_ROWS], 1), f"more than {MAX_ROWS} rows",
                                "thin the record out, or cut it")
    separator = next((sign for sign in SEPARATORS if texts and sign in texts[0]), None)
    header = None
    if texts and all(map(_is_name, texts[0].split(separator))):
        header = [cell.strip().strip('"') for cell in texts.pop(0).split(separator)]
        del lines[0]
    if len(texts) < 2:
        return None, Diagnostic(Where(path, 1, 1, 0), "expected at least two rows of numbers",
                                "write a time and a value in each row: 0.01, 0.35")
    return Columns(path, separator, header, lines, texts), None


def shown_lines(file: str) -> list[str]:
    """The lines of a file of columns, for a message; none where it cannot be read."""
    try:
        with open(file, "rb") as stream:
            return stream.read(MAX_BYTES).decode("utf-8-sig", "replace").replace("\r\n", "\n").split("\n")
    except (OSError, ValueError):
        return []
