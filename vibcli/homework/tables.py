"""Tables of students: CSV files in UTF-8 whose first line names the columns, one of them `id`."""

import csv
import io
import re

from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.base.named_tuple import NamedTuple

MAX_BYTES = 50 * 2**20
SHOWN = 500                 # characters of a cell
UNSEEN = "\N{REPLACEMENT CHARACTER}"
FORMULA = "=+-@\t\r"          # what a formula of a spreadsheet begins with
_NUMBER = re.compile(r"[-+]?[\d.,]+(?:[eE][-+]?\d+)?(?: \S+)?")
WORDS = "id", "name", "problem"     # columns that are named in capitals, too


class TableRow(NamedTuple):
    """A line of a table: its number in the file, {column: text} of the cells that are filled, the file and what stands
    in that line of it."""

    line: int
    cells: dict[str, str]
    path: str
    source: str

    def place(self, column: str = "id") -> Where:
        """Where the cell of a column stands, or the line begins."""
        cell = self.cells.get(column, "")
        return Where(self.path, self.line, max(self.source.find(cell), 0) + 1, max(len(cell), 1))


def read_table(path: str, what: str) -> tuple[list[str], list[TableRow]]:
    """(columns, rows) of a file, lines without anything left out; SpecError where it is none. what: the roster, or the
    answers."""
    text = _text(path, what)
    separator = next((sign for sign in ";\t" if sign in text.partition("\n")[0]), ",")
    lines = text.splitlines() or [""]
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True)
    rows: list[TableRow] = []
    try:
        heading = [word if (word := cell.strip().lower()) in WORDS else cell.strip() for cell in next(reader, [])]
        _require_columns(path, heading)
        for row in reader:
            cells = [cell.strip() for cell in row]
            if any(cells[len(heading):]):
                raise _wrong(path, reader.line_num, f"this line has {len(cells)} cells, and the first names "
                             f"{len(heading)} columns", "a cell with a separator in it stands in quotes")
            filled = {name: cell for name, cell in zip(heading, cells, strict=False) if cell}
            source = lines[min(reader.line_num, len(lines)) - 1]
            rows += [TableRow(reader.line_num, filled, path, source)] if filled else []
    except csv.Error as error:
        hint = "a quote is left open" if "unexpected end" in str(error) else "a quote within a cell is written twice" \
            if "expected after" in str(error) else None
        raise _wrong(path, max(reader.line_num, 1), f"{what} cannot be read: {error}", hint) from None
    return heading, rows


def as_text(cell: str) -> str:
    """A cell that no spreadsheet takes for a formula, and no screen for an order: what would be one has a quote before
    it, which numbers have not; signs that are not seen are replaced, and what is longer than anybody reads is cut."""
    cell = "".join(letter if letter.isprintable() else UNSEEN for letter in cell[:SHOWN]) + "…" * (len(cell) > SHOWN)
    return "'" + cell if cell and cell[0] in FORMULA and not _NUMBER.fullmatch(cell) else cell


def _text(path: str, what: str) -> str:
    try:
        with open(path, "rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except OSError as error:
        raise _wrong(path, 1, f"{what} cannot be read: {error.strerror}", width=0) from None
    if len(data) > MAX_BYTES:
        raise _wrong(path, 1, f"the file is longer than {MAX_BYTES} bytes", "divide it", 0)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise _wrong(path, data[:error.start].count(b"\n") + 1, f"{what}: this is no text in UTF-8",
                     "save it as UTF-8") from None


def _require_columns(path: str, heading: list[str]) -> None:
    if "id" not in heading:
        raise _wrong(path, 1, "the first line names the columns, and one of them is 'id'", "write for example: id,name")
    twice = next((name for i, name in enumerate(heading) if name and name in heading[:i]), None)
    if twice is not None:
        raise _wrong(path, 1, f"the column '{twice}' stands twice", "leave one of them out")


def _wrong(path: str, line: int, message: str, hint: str | None = None, width: int = 1) -> SpecError:
    return SpecError([Diagnostic(Where(path, line, 1, width), message, hint)])
