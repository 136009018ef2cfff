"""Values of parameters that are given beside a file, as numbers in a unit: how they are written, and what they are."""

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.errors import Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.document.nodes import Scalar
from vibcli.language.reader import Expression
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import literal_unit
from vibcli.symbolic.syntax import Sum, whole_literal

if TYPE_CHECKING:
    from vibcli.base.units import Unit
    from vibcli.symbolic.syntax import Number

FIGURES = 12        # of values that are computed


class GivenValue(NamedTuple):
    """A value of a parameter: as it would stand in the file, and in SI units, the next float of what is irrational;
    so many of a unit, '' of none."""

    expression: Expression
    exact: Fraction
    number: Fraction
    unit: str

    @property
    def text(self) -> str:
        return self.expression.text


def giver(unit: str, name: str) -> "Callable[[float | Fraction], GivenValue]":
    """number ↦ the GivenValue of so many of a unit, '' of none."""
    factor, one = unit_of_text(unit), whole_literal(parse(f"1 {unit}".strip()))

    def given(number: float | Fraction) -> GivenValue:
        number = rounded(number) if isinstance(number, float) else number
        digits = decimal(number)
        text = f"{digits} {unit}".strip()
        tree = _moved(one, number, len(digits) - 1) if number >= 0 else parse(text)
        exact = number if factor is None else (
            number * factor.value if not factor.pi and not factor.roots else Fraction(factor.in_si(number)))
        return GivenValue(Expression(Scalar(text, Where(name, 1, 1, len(text))), tree), exact, number, unit)

    return given


def _moved(one: "Number", number: Fraction, width: int) -> "Number":
    """The literal 1 with another number, which is wider by so much."""
    units = tuple(part._replace(start=part.start + width, end=part.end + width) for part in one.units)
    return one._replace(value=number, units=units, end=one.end + width)


def number_and_unit(expression: Expression) -> tuple[Fraction, str] | None:
    """(number, text of its unit) of an expression that is one literal, perhaps with a sign; None of another."""
    tree, sign = expression.tree, 1
    if isinstance(tree, Sum) and len(tree.parts) == 1:
        (sign, tree), = tree.parts
    literal = whole_literal(tree)
    if literal is None:
        return None
    text = expression.text
    return sign * literal.value, text[literal.units[0].start:literal.end].strip() if literal.units else ""


def unit_of_text(text: str) -> "Unit | None":
    """The unit of a text, None of none."""
    return literal_unit(whole_literal(parse(f"1 {text}")).units) if text else None


def converted(number: Fraction, unit: "Unit", other: "Unit") -> Fraction:
    """A number of one unit in another, exact where their ratio is rational."""
    if unit.pi == other.pi and not unit.roots and not other.roots:
        return number * unit.value / other.value
    return rounded(Fraction(unit.in_si(number) / other.in_si(1)))


def rounded(number: float | Fraction) -> Fraction:
    """A number to FIGURES figures."""
    return Fraction(f"{float(number):.{FIGURES}g}")


def decimal(number: Fraction) -> str:
    """A rational as a decimal, to so many figures as floats have where it has more."""
    found = f"{float(number):.{FIGURES}g}"
    return found if Fraction(found) == number else repr(float(number))
