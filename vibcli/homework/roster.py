"""The students of a course, from a CSV file with a heading, or numbered sheets without names."""

import re

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.tables import FORMULA, read_table

MOST = 100_000
LONGEST, SHOWN = 200, 40        # characters of a name, and of one that is none
ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9._@-]{0,63}")


class Student(NamedTuple):
    """A student: the id by which marks are kept, and a name, '' of none."""

    id: str
    name: str = ""


def roster(path: str) -> list[Student]:
    """The students of a file, in its order; SpecError where it is no roster."""
    _, rows = read_table(path, "the roster")
    found, seen, wrong = [], {}, []
    for row in rows:
        cells, where, own = row.cells, row.place(), row.cells.get("id", "")
        if not own:
            wrong.append(Diagnostic(where, "this student has no id"))
        elif own[0] in FORMULA:
            wrong.append(Diagnostic(where, f"the id '{own}' would be a formula in a spreadsheet",
                                    "ids begin with a letter or digit"))
        elif not ID.fullmatch(own):
            wrong.append(Diagnostic(where, f"{quoted(own)} is no id",
                                    "ids have letters, digits and . _ @ -, at most 64"))
        elif own.casefold() in seen:
            wrong.append(Diagnostic(where, f"the id '{own}' stands in line {seen[own.casefold()]} already"))
        elif not _is_name(cells.get("name", "")):
            wrong.append(Diagnostic(row.place("name"), f"{quoted(cells['name'][:SHOWN])} is no name",
                                    f"a name stands in one line, of at most {LONGEST} characters; is a quote left "
                                    "open?"))
        else:
            seen[own.casefold()] = row.line
            found.append(Student(own, cells.get("name", "")))
    if len(found) > MOST:
        wrong.append(Diagnostic(Where(path, 1, 1, 0), f"{len(found)} students; the limit is {MOST}"))
    if wrong or not found:
        raise SpecError(wrong or [Diagnostic(Where(path, 1, 1, 0), "there is no student in this roster")])
    return found


def _is_name(text: str) -> bool:
    return len(text) <= LONGEST and text.isprintable()


def numbered(count: int) -> list[Student]:
    """So many sheets without names."""
    return [Student(str(number).zfill(len(str(count)))) for number in range(1, count + 1)]
