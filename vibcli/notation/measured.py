"""Numbers with the units that multiply them, as one factor of a product: 0.03 and the letter of a metre are 0.03 m."""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.notation.numbers import figure
from vibcli.symbolic.node import UNITS
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.notation.plain import Notation
    from vibcli.symbolic.node import Node

LETTERS = {letter: base for base, letter in UNITS.items()}
MOST = 1000     # 1/1000: decimals of so many places are written out


def measured(value: Any, factors: "Sequence[tuple[Node, Any]]", told: bool) -> "tuple[Any, Sequence[tuple[Node, Any]]]":
    """(value, factors) of a product of letters of units, which stand with the number in one factor; not at all where
    they are not `told`. Below the line stands what has a unit there alone: k/(0.3 m)."""
    dimension, others, number = {}, [], value
    for base, exponent in factors:
        if base.name in LETTERS and exponent.denominator == 1:
            dimension[LETTERS[base.name]] = exponent
        elif told and base.op == "number" and exponent.denominator == 1:
            number *= Fraction(base.coefficient) ** int(exponent)
        else:
            others.append((base, exponent))
    if not dimension:
        return value, factors
    if not told:
        return value, others
    below = others and "s" not in dimension and all(exponent < 0 for exponent in dimension.values())
    sign = -1 if below and _is_short(1 / Fraction(number)) else 1
    size = Fraction(number) ** sign
    unit = units.text({base: sign * exponent for base, exponent in dimension.items()})
    name = f"{_written(abs(size))} {unit.replace('rad', '1')}"      # no angle is known to be in it
    return ONE if number > 0 else -ONE, [(factors[0][0].table.parameter(name), sign * ONE), *others]


def _written(size: Fraction) -> str:
    return f"{float(size):.12g}" if _is_short(size) else figure(float(size))


def _is_short(size: Fraction) -> bool:
    return (size * MOST).denominator == 1


def with_unit(write: "Notation", name: str, tightness: int) -> str:
    """A number with its unit, 0.3 m, of the name that it has as a node; alone where units are not told."""
    number, _, unit = name.partition(" ")
    text = write.numeral(number)
    if write.values or not write.measures:
        return text
    text = write.beside(text, write.unit(unit))
    return write.brackets(text) if tightness else text
