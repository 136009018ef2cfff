"""Numbers with their units in a text: `3 N/mm^2`, `2 kg*m^(1/2)`."""

import re
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.units import UNITS
from vibcli.symbolic.syntax import ExpressionError, Number, UnitPower

if TYPE_CHECKING:
    from re import Match

SMALLEST, LARGEST = 1e-60, 1e60
RANGE = "in SI units a value is zero or between 1e-60 and 1e60 in size"
_UNIT = re.compile(r"\s*([*/·])?\s*([A-Za-zµ°%]+)(?:\s*(?:\^|\*\*)\s*(?:"
                   r"(-?\d+(?:\.\d+)?)(?!\d)|\(\s*(-?\d+(?:\.\d+|\s*/\s*\d+)?)\s*\))|([²³⁴]))?(?![\w.(\[])")
_SUPERSCRIPTS = {"²": "2", "³": "3", "⁴": "4"}


def literal(text: str, number: "Match[str]") -> Number:
    """The Number of a match of one in a text, with the units that follow it."""
    start, digits = number.start(), number.group()
    mantissa, _, exponent = digits.lower().partition("e")
    power = int(exponent) if exponent else 0
    if len(mantissa) > 80 or len(exponent) > 4 or abs(power) > 60:
        raise ExpressionError(start, len(digits), "this number is out of range", RANGE)
    end = number.end()
    chain, end = ((), end) if end == len(text) else _units(text.replace("μ", "µ"), start, end)
    whole, _, decimals = mantissa.partition(".")
    value, places = int(whole + decimals), power - len(decimals)
    value = Fraction(value * 10**places) if places >= 0 else Fraction(value, 10**-places)
    return Number(start, end, value, tuple(chain))


def _units(text: str, start: int, at: int) -> tuple[list[UnitPower], int]:
    """The longest chain of units at a place, after the number at `start`, and its end."""
    chain = []
    while True:
        match = _UNIT.match(text, at)
        if not match or bool(match.group(1)) != bool(chain):
            return chain, at
        word = match.group(2)
        if word not in UNITS:
            if not chain:
                raise _unknown_unit(text, match, start, at)
            return chain, at
        power = _unit_power(match)
        chain.append(UnitPower(word, -power if match.group(1) == "/" else power, match.start(2), match.end(2)))
        at = match.end()
        if text[at:].lstrip().startswith(("^", "**")):
            raise ExpressionError(match.start(2), len(word), f"the power of the unit '{word}' is no number",
                                  f"write {word}^2 or {word}^(1/2), or brackets around what is raised")


def _unit_power(match: Any) -> Fraction | int:
    """The power of a unit: 2, -1, 0.5 or (3/2)."""
    text = match.group(3) or match.group(4) or _SUPERSCRIPTS.get(match.group(5), "1")
    if text in ("1", "2", "3", "4"):
        return int(text)
    above, _, below = text.partition("/")
    if len(text) > 12 or (below and not int(below)) or abs(power := Fraction(above) / Fraction(below or 1)) > 12:
        raise ExpressionError(match.start(2), match.end() - match.start(2), "this power is out of range",
                              "units have powers such as -2, 1/2 or 1.5, at most 12")
    return int(power) if power.denominator == 1 else power


def _unknown_unit(text: str, match: re.Match[str], start: int, at: int) -> ExpressionError:
    from vibcli.base.unit_suggestions import TAKEN, unit_meant

    word = match.group(2)
    if word in "xX":
        from vibcli.symbolic.foreign_signs import of_digits

        if ten := of_digits(text, match.start(2)):
            return ExpressionError(match.start(2), 1, f"'{word}' is not a unit", ten)
    if set(word) <= set("Oo"):
        return ExpressionError(match.start(2), len(word), f"'{word}' is not a unit", "a zero is a digit, no letter")
    meant = None if word == "pi" else unit_meant(word)
    product = f"a product is written with *: {text[start:at]}*{word}"
    hint = product
    if word in TAKEN:
        hint = f"write {meant}; {product}"
    elif meant:
        close = text[match.start(2) - 1] != " "         # 2k is a product that somebody forgot, 2 kgs a unit
        hint = (f"{product}; " if close else "") + f"did you mean '{meant}'?"
    return ExpressionError(match.start(2), len(word), f"'{word}' is not a unit", hint)
