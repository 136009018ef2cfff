"""`vibcli grade MANIFEST --student s123 --answer 'omega_d[1]=21.9 rad/s'`: marks, with the mistakes that they show."""

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.cli.common import color_option
from vibcli.cli.pictures import FILE

if TYPE_CHECKING:
    from vibcli.homework.marks import AnswerMark, Marker

COLUMNS = "id", "problem", "quantity", "answer", "points", "of", "verdict", "mistake", "said"
MAX_BYTES = 50 * 2**20


@click.command("grade")
@click.argument("manifest", type=click.Path())
@click.option("--student", metavar="ID", help="Whose answers these are.")
@click.option("--problem", metavar="NAME", help="Of which problem of a sheet with several.")
@click.option("--answer", "answers", multiple=True, metavar="QUANTITY=TEXT", help="An answer as it was written.")
@click.option("--csv", "table", metavar="FILE", help="The answers of all: columns id, problem, one for each quantity.")
@click.option("-o", "--output", metavar="FILE", type=FILE, help="Write the marks to a CSV file.")
@click.option("--force", is_flag=True, help="Replace the file if it exists.")
@color_option
def command(manifest: str, student: str | None, problem: str | None, answers: Sequence[str], table: str | None,
            output: str | None, force: bool) -> int:
    """Mark answers by the manifest of the sheets that `vibcli homework` handed out.

    The exit code is 0 whatever the marks are: vibcli explain homework.
    """
    from vibcli.cli.pictures import target
    from vibcli.homework.manifest import read_manifest
    from vibcli.homework.marks import Marker

    if (table is None) == (student is None):
        raise click.UsageError("give one student's answers, --student ID --answer 'omega[1]=20 rad/s', or a table, "
                               "--csv FILE")
    path = None if output is None else target(None, output, (".csv",), force)
    marker = Marker(read_manifest(manifest))
    marks = _of_one(marker, student, problem, answers) if table is None else _of_table(marker, table)
    if path is not None:
        from vibcli.cli.pictures import write

        write(path, _table(marks).encode(), force)
    else:
        click.echo(_shown(marks) if table is None else _table(marks).rstrip())
    return 0


def _of_one(marker: "Marker", student: str, problem: str | None, answers: Sequence[str]) -> "list[AnswerMark]":
    try:
        name = marker.problem(student, problem)
        found = {}
        for answer in answers:
            quantity, equals, text = _parted(answer)
            if not equals:
                raise ValueError(f"--answer {answer}: write QUANTITY=TEXT, as in 'omega[1]=20 rad/s'")
            found[marker.quantity(name, quantity)] = text
        return list(marker.marks(student, name, found))
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def _parted(answer):
    """A quantity and the text behind the equals sign that follows it."""
    return answer.partition("=")


def _of_table(marker: "Marker", path: str) -> "list[AnswerMark]":
    """The marks of a table; SpecError with every line that is none."""
    try:
        data = Path(path).read_bytes()[:MAX_BYTES + 1]
        text = data.decode("utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise SpecError([Diagnostic(Where(path, 1, 1, 0), f"the answers cannot be read: {error}")]) from None
    separator = ";" if ";" in text.partition("\n")[0] else ","
    rows = list(csv.reader(io.StringIO(text), delimiter=separator))
    heading = [cell.strip() for cell in rows[0]] if rows else []
    if "id" not in heading:
        raise SpecError([Diagnostic(Where(path, 1, 1, 0), "the first line names the columns, and one of them is 'id'",
                                    "write for example: id,problem,omega[1]")])
    found, wrong = [], []
    for line, row in enumerate(rows[1:], 2):
        if not any(cell.strip() for cell in row):
            continue
        cells = dict(zip(heading, (cell.strip() for cell in row), strict=False))
        try:
            name = marker.problem(cells["id"], cells.get("problem") or None)
            answers = {marker.quantity(name, key): value for key, value in cells.items()
                       if key not in ("id", "problem", "name") and value}
            found += marker.marks(cells["id"], name, answers)
        except ValueError as error:
            wrong.append(Diagnostic(Where(path, line, 1, 0), str(error)))
    if wrong:
        raise SpecError(wrong)
    return found


def _table(marks: "Sequence[AnswerMark]") -> str:
    """The marks as CSV; texts of students that a spreadsheet would take for formulas have a quote before them."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(COLUMNS)
    for one in marks:
        answer = "'" + one.answer if one.answer[:1] in ("=", "+", "@", "\t") else one.answer
        rows.writerow([one.student, one.problem, one.quantity, answer, f"{one.points:g}", f"{one.of:g}", one.verdict,
                       one.mistake, one.said])
    return text.getvalue()


def _shown(marks: "Sequence[AnswerMark]") -> str:
    from vibcli.homework.marks import RIGHT, total

    lines = []
    for one in marks:
        mark = click.style("✓", fg="green") if one.verdict == RIGHT else click.style("✗", fg="red")
        said = ": ".join(part for part in (one.mistake, one.said if one.said != one.mistake else "") if part)
        lines.append(f"{mark} {one.quantity} = {one.answer or '–'}: {one.verdict}, {one.points:g} of {one.of:g}"
                     + (f" ({said})" if said else ""))
    points, most = total(marks)
    return "\n".join([*lines, f"{points:g} of {most:g} points"])
