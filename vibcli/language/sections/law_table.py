"""Laws of springs and dampers: expressions of the deflection or rate, or tables of points."""

from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.spelling import nearest
from vibcli.language.data_columns import read_columns
from vibcli.language.document.document import Scalar, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Choice, Kind, Many, OneOf, Quantity, Text
from vibcli.language.reader import Expression
from vibcli.language.sections.parameter import UNIT
from vibcli.symbolic.literals import LARGEST, RANGE, SMALLEST
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import literal_unit
from vibcli.symbolic.syntax import whole_literal

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.base.units import Unit
    from vibcli.language.data_columns import Columns
    from vibcli.language.document.nodes import DocumentNode
    from vibcli.language.reader import Reader, Record

MOST = 1000
POINTS = "a list of points, as in [[0 mm, 0 N], [2 mm, 40 N]]"
MINUS = -1
EXAMPLES = {"m": "mm, N", "rad": "deg, N*m", "m/s": "mm/s, N", "rad/s": "rad/s, N*m"}


class Entry(NamedTuple):
    """A number of a table in SI units, its place, and the Expression that says it; None in a file."""

    value: Fraction
    where: Where
    expression: Any = None

    def fits(self, dimension: Any) -> bool:
        """Has it this dimension, as far as it is written with a unit?"""
        number = None if self.expression is None else whole_literal(self.expression.tree)
        return number is None or not number.units or literal_unit(number.units).dimension == dimension


class LawTable(NamedTuple):
    """Points (deflection or rate, force); `linear`: is it a straight line beyond its ends? `dimensions`: those of the
    columns of a file that says them."""

    points: "list[tuple[Entry, Entry]] | list[list[Entry]]"
    where: Where
    linear: bool = False
    dimensions: "tuple[Mapping[str, Fraction | int], ...]" = ()

    def check(self, reader: "Reader", name: str, argument: str, force: str) -> None:
        """Report what is wrong with it as a law of `name` (d or v), in the units of that and of its force."""
        for i, unit in enumerate((argument, force)):
            wanted = units.parse_unit(unit).dimension
            if self.dimensions and self.dimensions[i] != wanted:
                reader.report(self.where, f"expected {units.name(wanted)} in column {i + 1} of this table, found "
                              f"{units.name(self.dimensions[i])}", f"write for example units: [{EXAMPLES[argument]}]")
            for entry in [point[i].expression for point in self.points if point[i].expression]:
                reader.expressions[entry.scalar] = Expression(entry.scalar, entry.tree, unit, wanted)
        values = [point[0].value for point in self.points]
        wanted = units.parse_unit(argument).dimension
        late = next((b[0] for a, b in pairwise(self.points) if b[0].value <= a[0].value
                     and a[0].fits(wanted) and b[0].fits(wanted)), None)
        if late is not None:
            reader.report(late.where, f"{name} must increase from point to point: this one is not larger than the one "
                          "before", "sort the points, and leave out what stands twice")
        elif not values[0] <= 0 <= values[-1]:
            reader.report(self.points[0 if values[0] > 0 else -1][0].where, f"{name} = 0 is not within this table",
                          f"let it reach {name} = 0: its energy counts from there")


class _Points(Kind):
    """Pairs of numbers."""

    wants = POINTS

    def read(self, node: Any, reader: Any) -> Any:
        pairs = node.items if isinstance(node, Sequence) else ()
        odd = next((pair for pair in pairs if not isinstance(pair, Sequence) or len(pair.items) != 2), None)
        if not isinstance(node, Sequence) or odd is not None:
            count = len(odd.items) if isinstance(odd, Sequence) else None
            if count is not None:
                return reader.report(odd.where, "expected a point [deflection or rate, force], found "
                                     + ("one item" if count == 1 else f"{count} items"))
            return reader.expected(odd or node, "a point [deflection or rate, force]" if odd else self.wants)
        if len(pairs) < 2:
            return reader.report(node.where, f"expected at least two points, found {len(pairs)}",
                                 "the law runs through its points: give two or more")
        if len(pairs) > MOST:
            return _too_long(reader, node.where)
        points = [[_entry(item, reader) for item in pair.items] for pair in pairs]
        return None if any(None in point for point in points) else points

    def schema(self) -> dict[str, Any]:
        pair = {"type": "array", "items": {"type": ["string", "number"]}, "minItems": 2, "maxItems": 2}
        return {"type": "array", "items": pair, "minItems": 2, "maxItems": MOST}


def _too_long(reader: "Reader", where: Where) -> None:
    return reader.report(where, f"a table of a law has at most {MOST} points", "thin it out: the law is smooth between "
                         "its points")


def _entry(node: "DocumentNode", reader: "Reader") -> Entry | None:
    """The Entry of one number with its unit."""
    expression = Quantity().read(node, reader)
    if expression is None:
        return None
    number = whole_literal(expression.tree)
    if number is None:
        return reader.report(node.where, f"expected a number with its unit, found {quoted(expression.text)}",
                             "a table is made of numbers; a law with letters is written as an expression")
    negative = number is not expression.tree and expression.tree.parts[0][0] == MINUS
    value = Fraction(number.value) * (_factor(literal_unit(number.units)) if number.units else 1)
    return Entry(-value if negative else value, node.where, expression)


def _factor(unit: "Unit") -> Fraction:
    """A unit in SI units."""
    return unit.value if not (unit.pi or unit.roots) else Fraction(unit.in_si(1))


COLUMN = Text()
TABLE = Element(
    "table of a law",
    "A law from points: monotone cubics run through them, with the slopes of Fritsch and Butland, and their energy is "
    "exact. It has no value beyond its ends unless `beyond: linear`.",
    {
        "table": Field(OneOf("the name of a file, or " + POINTS, scalar=Text(), sequence=_Points()),
                       "the points, or the file that holds them, in the folder of the scene or below: columns of "
                       "numbers as those of `records`", required=True),
        "columns": Field(Many(COLUMN, 2, 2, "two columns, by name or number"),
                         "the columns of a file: that of the deflection (of dampers the rate) and that of the force "
                         "(default: [1, 2])"),
        "units": Field(Many(UNIT, 2, 2, "two units"), "the units of these columns, as in [mm, N] (default: SI)"),
        "beyond": Field(Choice("linear"), "`linear`: it goes on straight beyond its ends"),
    },
    short="table",
    example="spring_from_a_table",
)


class LawKind(Kind):
    """An expression, or a LawTable."""

    wants = "an expression, " + POINTS + ", or {table: stiffness.csv}"

    def read(self, node: Any, reader: Any) -> Any:
        if isinstance(node, Scalar):
            return Quantity().read(node, reader)
        if isinstance(node, Sequence):
            points = _Points().read(node, reader)
            return None if points is None else LawTable(points, node.where)
        record = TABLE.read(node, reader)
        return None if record is None else _tabulated(record, reader)

    def schema(self) -> dict[str, Any]:
        return {"anyOf": [Quantity().schema(), TABLE.schema()]}


KIND = LawKind()


def _tabulated(record: "Record", reader: "Reader") -> LawTable | None:
    linear, points = "beyond" in record, record["table"]
    if isinstance(points, list):
        for key in ("columns", "units"):
            if key in record:
                return reader.report(record.place(key), f"'{key}' is for the columns of a file",
                                     "write the units with the points, as in [2 mm, 40 N]")
        return LawTable(points, record.where, linear)
    found = _from_file(record, reader)
    if found is None:
        return None
    dimensions = tuple(_unit(text).dimension for text in record.get("units", ()))
    return LawTable(found, record.place("units" if dimensions else "table"), linear, dimensions)


def _unit(text: str) -> "Unit":
    return literal_unit(parse("1 " + text).units)


def _from_file(record: "Record", reader: "Reader") -> list[tuple[Entry, Entry]] | None:
    """The points of a file; None where something was reported."""
    where = record.place("table")
    columns, problem = reader.columns_of(record.where.file, record["table"].strip(), read_columns)
    if isinstance(problem, Diagnostic):
        return reader.report(problem.where, problem.message, problem.hint)
    if problem:
        return reader.report(where, *problem)
    if len(columns.texts) > MOST:
        return _too_long(reader, where)
    found = []
    for number in range(2):
        i = _number_of(record, reader, columns, number)
        column = None if i is None else _column(record, reader, columns, i, number)
        if column is None:
            return None
        found.append(column)
    return list(zip(*found, strict=True))


def _number_of(record: "Record", reader: "Reader", columns: "Columns", which: int) -> int | None:
    """The number of a column, from 0."""
    text = record["columns"][which].strip() if "columns" in record else str(which + 1)
    where = record.place("columns" if "columns" in record else "table")
    names = columns.header or ()
    if text in names:
        return names.index(text)
    if text.isdecimal() and 1 <= int(text) <= columns.count:
        return int(text) - 1
    if text.isdecimal():
        return reader.report(where, f"the file has no column {text}: it has {columns.count}",
                             "columns are counted from 1")
    return reader.report(where, f"the file has no column {quoted(text)}", nearest(text, names) if names else
                         "the file has no line that names its columns: write their numbers, from 1")


def _column(record: "Record", reader: "Reader", columns: "Columns", i: int, which: int) -> list[Entry] | None:
    """The Entries of a column, in SI units."""
    numbers = columns.numbers(i, reader.report)
    if numbers is None:
        return None
    factor, found = _factor(_unit(record["units"][which])) if "units" in record else 1, []
    for row, number in enumerate(numbers):
        value = Fraction(repr(number)) * factor
        if value and not SMALLEST <= abs(value) <= LARGEST:
            return reader.report(columns.place(row, i), "this number is out of range", RANGE)
        found.append(Entry(value, columns.place(row, i)))
    return found
