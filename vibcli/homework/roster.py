"""The students of a course, from a CSV file with a heading, or numbered sheets without names."""

import csv
import re
from typing import NamedTuple

from vibcli.base.errors import Diagnostic, SpecError, Where

MOST, MAX_BYTES = 100_000, 20 * 2**20
ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9._@-]{0,63}")
FORMULA = "=+-@\t\r"


class Student(NamedTuple):
    """A student: the id by which marks are kept, and a name, '' of none."""

    id: str
    name: str = ""


def roster(path: str) -> list[Student]:
    """The students of a file, in its order; SpecError where it is no roster."""
    try:
        with open(path, "rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except OSError as error:
        raise SpecError([Diagnostic(Where(path, 1, 1, 0), f"the roster cannot be read: {error.strerror}")]) from None
    if len(data) > MAX_BYTES:
        raise SpecError([Diagnostic(Where(path, 1, 1, 0), f"the roster is longer than {MAX_BYTES} bytes")])
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[:error.start].count(b"\n") + 1
        raise SpecError([Diagnostic(Where(path, line, 1, 0), "the roster is no text in UTF-8")]) from None
    rows = list(csv.reader(text.splitlines(), delimiter=";" if ";" in text.partition("\n")[0] else ","))
    heading = [cell.strip().lower() for cell in rows[0]] if rows else []
    if "id" not in heading:
        raise SpecError([Diagnostic(Where(path, 1, 1, 0), "the first line of a roster names its columns, and one of "
                                    "them is 'id'", "write for example: id,name")])
    return _students(path, rows[1:], heading.index("id"), heading.index("name") if "name" in heading else None)


def _students(path, rows, at, named):
    found, seen, wrong = [], {}, []
    for line, row in enumerate(rows, 2):
        if not any(cell.strip() for cell in row):
            continue
        where, own = Where(path, line, 1, 0), row[at].strip() if at < len(row) else ""
        if not own:
            wrong.append(Diagnostic(where, "this student has no id"))
        elif own[0] in FORMULA:
            wrong.append(Diagnostic(where, f"the id '{own}' would be a formula in a spreadsheet",
                                    "ids begin with a letter or digit"))
        elif not ID.fullmatch(own):
            wrong.append(Diagnostic(where, f"'{own}' is no id", "ids have letters, digits and . _ @ -, at most 64"))
        elif own.casefold() in seen:
            wrong.append(Diagnostic(where, f"the id '{own}' stands in line {seen[own.casefold()]} already"))
        else:
            seen[own.casefold()] = line
            found.append(Student(own, row[named].strip() if named is not None and named < len(row) else ""))
    if len(found) > MOST:
        wrong.append(Diagnostic(Where(path, 1, 1, 0), f"{len(found)} students; the limit is {MOST}"))
    if wrong or not found:
        raise SpecError(wrong or [Diagnostic(Where(path, 1, 1, 0), "there is no student in this roster")])
    return found


def numbered(count: int) -> list[Student]:
    """So many sheets without names."""
    return [Student(str(number).zfill(len(str(count)))) for number in range(1, count + 1)]
