"""`vibcli grade MANIFEST --student s123 --answer 'omega_d[1]=21.9 rad/s'`: marks, with the mistakes that they show."""

import csv
import io
from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from vibcli.base.diagnostics import escaped
from vibcli.base.errors import Diagnostic, SpecError
from vibcli.cli.common import color_option
from vibcli.cli.pictures import FILE

if TYPE_CHECKING:
    from vibcli.homework.marks import AnswerMark, Marker

COLUMNS = "id", "problem", "quantity", "answer", "points", "of", "verdict", "mistake", "said"
FOR_WHO_MARKS = "off", "band", "unit"       # with the answer they tell the key: in no table, which is given back


@click.command("grade")
@click.argument("manifest", type=click.Path())
@click.option("--student", metavar="ID", help="Whose answers these are.")
@click.option("--problem", metavar="NAME", help="Of which problem of a sheet with several.")
@click.option("--answer", "answers", multiple=True, metavar="QUANTITY=TEXT", help="An answer as it was written.")
@click.option("--csv", "table", metavar="FILE", help="The answers of all: columns id, problem, one for each quantity.")
@click.option("-o", "--output", metavar="FILE", type=FILE, help="Write the marks to a CSV file.")
@click.option("--force", is_flag=True, help="Replace the file if it exists.")
@click.option("--json", "as_json", is_flag=True, help="The marks as JSON.")
@color_option
def command(manifest: str, student: str | None, problem: str | None, answers: Sequence[str], table: str | None,
            output: str | None, force: bool, as_json: bool) -> int:
    """Mark answers by the manifest of the sheets that `vibcli homework` handed out.

    The exit code is 0 whatever the marks are: vibcli explain grade.
    """
    from vibcli.cli.pictures import target
    from vibcli.homework.manifest import read_manifest
    from vibcli.homework.marks import Marker

    if (table is None) == (student is None):
        raise click.UsageError("give one student's answers, --student ID --answer 'omega[1]=20 rad/s', or a table, "
                               "--csv FILE")
    if as_json and output is not None:
        raise click.UsageError("--json prints the marks, and -o writes them as CSV: choose one")
    path = None if output is None else target(None, output, (".csv",), force)
    marker = Marker(read_manifest(manifest))
    marks = _of_one(marker, student, problem, answers) if table is None else _of_table(marker, table)
    if path is not None:
        from vibcli.cli.pictures import write

        write(path, _table(marks).encode(), force)
    else:
        click.echo(_data(marks) if as_json else _shown(marks) if table is None else _table(marks).rstrip())
    return 0


def _of_one(marker: "Marker", student: str, problem: str | None, answers: Sequence[str]) -> "list[AnswerMark]":
    try:
        name = marker.problem(student, problem)
        found = []
        for answer in answers:
            quantity, equals, text = _parted(answer)
            if not equals:
                raise ValueError(f"--answer {answer}: write QUANTITY=TEXT, as in 'omega[1]=20 rad/s'")
            found.append((quantity, text))
        return list(marker.marks(student, name, _by_quantity(marker, name, found)))
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def _parted(answer: str) -> tuple[str, str, str]:
    """A quantity and the text behind the equals sign that follows it."""
    return answer.partition("=")


def _by_quantity(marker: "Marker", problem: str, answers: "Sequence[tuple[str, str]]") -> dict[str, str]:
    """{quantity: answer} of those that are given to a problem, each once."""
    found: dict[str, str] = {}
    for text, answer in answers:
        asked = marker.quantity(problem, text)
        if asked in found:
            raise ValueError(f"{asked} is answered twice")
        found[asked] = answer
    return found


def _of_table(marker: "Marker", path: str) -> "list[AnswerMark]":
    """The marks of a table; SpecError with every line that is none."""
    from vibcli.homework.tables import read_table

    _, rows = read_table(path, "the answers")
    found, wrong, seen = [], [], {}
    for row in rows:
        line, cells = row.line, row.cells
        try:
            if "id" not in cells:
                raise ValueError("these answers have no id")
            student = cells["id"]
            name = marker.problem(student, cells.get("problem"))
            if (student, name) in seen:
                raise ValueError(f"the answers of {student} to {name} stand in line {seen[student, name]} already")
            seen[student, name] = line
            answers = [(key, text) for key, text in cells.items() if key not in ("id", "problem", "name")]
            found += marker.marks(student, name, _by_quantity(marker, name, answers))
        except ValueError as error:
            wrong.append(Diagnostic(row.place(), str(error)))
    if wrong:
        raise SpecError(wrong)
    return found


def _table(marks: "Sequence[AnswerMark]") -> str:
    """The marks as CSV; texts of students that a spreadsheet would take for formulas have a quote before them."""
    from vibcli.homework.tables import as_text

    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(COLUMNS)
    for one in marks:
        rows.writerow([one.student, one.problem, one.quantity, as_text(one.answer), f"{one.points:g}",
                       f"{one.of:g}", one.verdict, one.mistake, as_text(one.said)])
    return text.getvalue()


def _data(marks: "Sequence[AnswerMark]") -> str:
    """{marks: [a mapping by COLUMNS and FOR_WHO_MARKS], points, of}, null for a text that is empty."""
    import json

    from vibcli.homework.marks import total

    columns = COLUMNS + FOR_WHO_MARKS
    rows = [dict(zip(columns, (text if text != "" else None for text in one), strict=True)) for one in marks]
    points, most = total(marks)
    return json.dumps({"marks": rows, "points": points, "of": most}, ensure_ascii=False, allow_nan=False, indent=1)


def _shown(marks: "Sequence[AnswerMark]") -> str:
    from vibcli.homework import RIGHT
    from vibcli.homework.marks import total

    lines = []
    for one in marks:
        mark = click.style("✓", fg="green") if one.verdict == RIGHT else click.style("✗", fg="red")
        said = ": ".join(part for part in (one.mistake, one.said if one.said != one.mistake else "") if part)
        said = "; ".join(part for part in (said, one.far) if part)
        lines.append(f"{mark} {one.quantity} = {escaped(one.answer) or '–'}: {one.verdict}, "
                     f"{one.points:g} of {one.of:g}" + (f" ({escaped(said)})" if said else ""))
    points, most = total(marks)
    return "\n".join([*lines, f"{points:g} of {most:g} points"])
