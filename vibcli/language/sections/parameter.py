"""Parameters: what is given, as numbers with units, as expressions of one another, or left as symbols."""

from typing import TYPE_CHECKING, Any

from vibcli.base.spelling import nearest
from vibcli.base.units import UNITS
from vibcli.language.document.document import Mapping, Scalar
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Choice, Quantity, Text
from vibcli.language.reader import Record
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError, Number

if TYPE_CHECKING:
    from vibcli.base.errors import Where


class _Unit(Text):
    """A unit, kept as its text."""

    wants = "a unit such as N/m"

    def read(self, node: Any, reader: Any) -> Any:
        text = super().read(node, reader)
        if text is None:
            return None
        try:
            literal = parse("1 " + text)
        except ExpressionError:
            literal = None
        plain = isinstance(literal, Number) and literal.value == 1
        if not text.strip() or not plain or not (literal.units or text.strip() == "1"):
            return reader.expected(node, self.wants, nearest(text, UNITS) if text.isalpha() else None)
        return text


UNIT = _Unit()


class _Parameter(Element):
    """`m: 3 kg`, `J: m*L^2/3`, `k:` (a symbol), or a mapping."""

    def read(self, node: Any, reader: Any, name: str | None = None, where: "Where | None" = None) -> Any:
        where = where or node.where
        if isinstance(node, Scalar) and not node.text.strip() and not node.quoted:
            return Record(self, name, where, {}, {})
        record = super().read(node, reader, name, where)
        if record is not None and "unit" in record and "value" in record and isinstance(node, Mapping):
            reader.report(record.place("unit"), "'unit' is for a symbol without value",
                          "write the unit after the value")
        return record


ELEMENT = _Parameter(
    "parameter",
    "A given quantity: `m: 3 kg`, an expression of other parameters, or nothing at all: then it stays a symbol in "
    "every answer. Symbols are positive unless `sign: any`; their dimension follows from where they are used.",
    {
        "value": Field(Quantity(), "the value: a number with its unit, or an expression of other parameters"),
        "unit": Field(UNIT, "the unit of a symbol without value"),
        "about": Field(Text(), "what it is, in words"),
        "sign": Field(Choice("positive", "any"), "whether a symbol is known to be positive (the default) or not"),
        "unused": Field(Choice("allowed"), "`allowed` where nothing in the scene uses it"),
    },
    short="value",
    example="mass_spring_damper",
)
