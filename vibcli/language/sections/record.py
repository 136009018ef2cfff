"""Records: measured functions of time from a file, linear between their samples and zero before and after them."""

from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, Where
from vibcli.base.spelling import nearest
from vibcli.language.data_columns import read_columns
from vibcli.language.document.document import Scalar
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Quantity, Text
from vibcli.language.sections.parameter import UNIT
from vibcli.symbolic.literals import LARGEST, SMALLEST
from vibcli.symbolic.parser import parse
from vibcli.symbolic.sampled_functions import Samples
from vibcli.symbolic.semantics import literal_unit
from vibcli.symbolic.syntax import Number, whole_literal

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from fractions import Fraction

    from vibcli.base.units import Unit
    from vibcli.language.data_columns import Columns
    from vibcli.language.reader import Reader, Record


class _Column(Text):
    """A column of a file: the text of its header or its number, with its place."""

    wants = "a column: its name in the first line, or its number from 1"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Scalar) or not node.text.strip():
            return reader.expected(node, self.wants)
        return node


class _Record(Element):
    """A Record whose values hold `samples` beside what is written."""

    def read(self, node: Any, reader: Any, name: str | None = None, where: Where | None = None) -> Any:
        record = super().read(node, reader, name, where)
        if record is None:
            return None
        samples = _samples(record, reader)
        if samples is None:
            return None
        record["samples"] = samples
        return record


class _FileName(_Column):
    """The name of a file, with its place."""

    wants = "the name of a file, such as quake.csv"


COLUMN = _Column()
ELEMENT = _Record(
    "record",
    "A measured function of time: `ag: {file: quake.csv, unit: m/s^2}` reads a file that lies beside the scene, and "
    "`ag(t)` stands in loads and driven motions, `ag(t - t0)` later. It is linear between its samples, and zero "
    "before the first and after the last.",
    {
        "file": Field(_FileName(), "the file, in the folder of the scene or below: columns of numbers, apart by "
                      "commas, semicolons, tabs or blanks; the first line may name them, lines that start with # are "
                      "skipped", required=True),
        "time": Field(COLUMN, "the column of the times, ascending: its name or its number (default: the first)"),
        "every": Field(Quantity("s"), "the time from one row to the next, where no column holds it: `every: 0.02 s`"),
        "value": Field(COLUMN, "the column of the values (default: the second; the first beside `every`)"),
        "unit": Field(UNIT, "the unit of the values, as in m/s^2; without it they are pure numbers"),
        "time_unit": Field(UNIT, "the unit of the times (default: s)"),
    },
    short="file",
    exclusive=(("time", "every"), ("time_unit", "every")),
    example="measured_ground_motion",
)


def samples_by_text(records: "Mapping[str, Record]") -> dict[tuple[str | None, ...], Samples]:
    """{what a record says: its Samples}, with which a scene that says the same is read without its files."""
    return {_said(record): record["samples"] for record in records.values()}


def _said(record: "Record") -> tuple[str | None, ...]:
    texts = (getattr(record.get(key), "text", record.get(key)) for key in ELEMENT.fields)
    return record["file"].where.file, *texts


def _samples(record: "Record", reader: "Reader") -> Samples | None:
    """The Samples of a record; None with a report where there are none."""
    if (said := _said(record)) in reader.files:
        samples: Samples = reader.files[said]
        return samples
    file = record["file"]
    columns, problem = reader.columns_of(file.where.file, file.text.strip(), read_columns)
    if isinstance(problem, Diagnostic):
        return reader.report(problem.where, problem.message, problem.hint)
    if problem:
        return reader.report(file.where, *problem)
    values = _scaled(record, reader, "unit", _column(record, reader, columns, "value", 0 if "every" in record else 1))
    times = _spaced(record, reader, len(columns.texts)) if "every" in record else _times(record, reader, columns)
    return None if times is None or values is None else Samples(times, values)


def _column(record: "Record", reader: "Reader", columns: "Columns", key: str,
            default: int) -> "tuple[Sequence[float] | None, Columns, int] | None":
    """The numbers of the column that a key names."""
    i = default
    if key in record:
        node, text = record[key], record[key].text.strip()
        if text.isdecimal():
            i = int(text) - 1
        elif columns.header is None:
            return reader.report(node.where, f"the file has no line that names its columns, found {quoted(text)}",
                                 "write the number of the column, from 1")
        elif text not in columns.header:
            return reader.report(node.where, f"the file has no column {quoted(text)}", nearest(text, columns.header))
        else:
            i = columns.header.index(text)
    if not 0 <= i < columns.count:
        where = record[key if key in record else "file"].where
        return reader.report(where, f"the file has no column {i + 1}: it has {columns.count}",
                             "columns are counted from 1")
    return columns.numbers(i, reader.report), columns, i


def _times(record: "Record", reader: "Reader", columns: "Columns") -> "Sequence[float] | None":
    if "time_unit" in record and _unit(record["time_unit"]).dimension != units.TIME:
        return reader.report(record.place("time_unit"), f"expected a unit of time, found '{record['time_unit']}'",
                             "write s or ms")
    found = _column(record, reader, columns, "time", 0)
    times = _scaled(record, reader, "time_unit", found)
    if times is None:
        return None
    late = next((row for row in range(1, len(times)) if times[row] <= times[row - 1]), None)
    if late is not None:
        return reader.report(columns.place(late, found[2]), "the times must ascend: this one is not later than the one "
                             "before", "sort the rows, and leave out what stands twice")
    return times


def _spaced(record: "Record", reader: "Reader", count: int) -> list[float] | None:
    """0, Δ, 2Δ, …: each rounded once."""
    literal = whole_literal(record["every"].tree)
    step = literal and literal.value * (literal_unit(literal.units).value if literal.units else 1)
    if not step or step <= 0 or not isinstance(record["every"].tree, Number):
        return reader.report(record["every"].where, f"expected a positive time, found {quoted(record['every'].text)}",
                             "write for example every: 0.02 s")
    return [float(i * step) for i in range(count)]


def _scaled(record: "Record", reader: "Reader", key: str,
            found: "tuple[Sequence[float] | None, Columns, int] | None") -> "Sequence[float] | None":
    """The numbers of a column in SI units."""
    if found is None or found[0] is None:
        return None
    numbers, columns, i = found
    unit = _unit(record[key]) if key in record else None
    factor = unit.in_si(1) if unit else 1.0
    scaled = numbers if factor == 1 else [number * factor for number in numbers]
    for row, number in enumerate(scaled):
        if number and not SMALLEST <= abs(number) <= LARGEST:
            return reader.report(columns.place(row, i), "this number is out of range",
                                 "in SI units a value is zero or between 1e-60 and 1e60 in size")
    return scaled


def _unit(text: str) -> "Unit":
    return literal_unit(parse("1 " + text).units)


def dimension(record: "Record") -> "Mapping[str, Fraction | int] | None":
    """The dimension of the values; None where no unit is given."""
    return _unit(record["unit"]).dimension if "unit" in record else None
