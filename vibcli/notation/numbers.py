"""Numbers as they are printed: the digits that a result supports, its unit after it."""

import math
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.symbolic.node import is_measured

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node

SHOWN = 6
FEWER = "?"         # behind a number with fewer digits than are asked for, all that the bound of its error allows
NEGATIVE = re.compile(r"(?<![\w.])-(?=[\d.])")        # the sign of a number in a text, not of an exponent
COMBINING = re.compile("[\u0300-\u036f]")      # dots over letters
LARGEST = 48        # denominators up to here are written as fractions
LONGEST, FIGURES = 999, 4       # up to here they may be, where a decimal has more figures than so many


def figure(value: float | None, error: float = 0.0, digits: int = SHOWN, mark: str = FEWER) -> str:
    """A number with at most `digits` significant digits, fewer where its relative error bound allows fewer; with a mark
    behind it where these are fewer than six."""
    if value is None:
        return "–"
    if not isinstance(value, (int, float)):
        return str(value)
    asked = min(digits, SHOWN)
    if error and error > 0:
        digits = max(1, min(digits, int(-math.log10(min(error, 0.5)))))
    text = f"{value:.{digits}g}"
    return "0" if text in ("-0", "0") else _short_exponent(text) + mark * (digits < asked)


def _short_exponent(text: str) -> str:
    """1.2e7 of 1.2e+07, 3e-5 of 3e-05."""
    return text.replace("e+0", "e").replace("e-0", "e-").replace("e+", "e")


def with_minus(value: float, digits: int = SHOWN) -> str:
    """The same as mathematics: −1.5e-6."""
    return ("−" if value < 0 else "") + figure(abs(value), digits=digits)


def plainly(value: float, digits: int = 2) -> str:
    """A number to so many digits, without an exponent below a million: 120, not 1.2e2."""
    near = float(f"{value:.{digits}g}")
    return f"{near:.0f}" if 10**digits <= abs(near) < 1e6 else figure(value, digits=digits)


def rounded_up(bound: float, digits: int = 1) -> float:
    """The least number of so many significant digits that is not below a bound: 1.11e-16 → 2e-16, as bounds are
    printed."""
    near = f"{bound:.{digits - 1}e}"
    if not float(near) < bound:
        return float(near)
    number, power = near.split("e")
    return float(f"{int(number.replace('.', '')) + 1}e{int(power) - digits + 1}")


def supported(value: float, error: float, digits: int = SHOWN, mark: str = FEWER, beside: float = 0.0) -> str:
    """A number with the digits that its absolute error allows; where that is all of it, how far it may be from 0, if so
    many digits of what is as large as `beside` show that."""
    if is_lost(value, error):
        off = abs(value) + error
        return "0" if off <= 0.5 * 10.0**-digits * beside < math.inf else f"0 ± {figure(rounded_up(off), digits=1)}"
    return figure(value, error / abs(value) if value else 0.0, digits, mark)


def is_lost(value: float, error: float) -> bool:
    """Is the absolute error as good as all of a number?"""
    return error >= 0.5 * abs(value) and error > 0 and bool(value)


def with_bound(value: float, error: float) -> str:
    """17.121 ± 0.003: a number to the first figure of its absolute error, and how far what is written may be off."""
    if error >= 0.5 * abs(value):
        return supported(value, error)
    places = math.floor(math.log10(abs(value))) - math.floor(math.log10(error)) + 1
    written = f"{value:.{min(places, 17)}g}"
    off = error + abs(float(written) - value)
    return f"{_short_exponent(written)} ± {figure(rounded_up(off), digits=1)}"


def with_unit(value: float, dimension: "Mapping[str, Fraction | int]") -> str:
    """`0.0785 m`: a number and the SI unit of its dimension."""
    return NEGATIVE.sub("−", "".join(quantity(value, dimension)))


def quantity(value: float, dimension: "Mapping[str, Fraction | int]", error: float = 0.0) -> tuple[str, str]:
    """The number, and what is written behind it: ("0.0785", " m")."""
    unit = "rad" if dimension == {} else units.text(dimension)
    degrees = f" ({with_minus(math.degrees(value), 4)}°)" if dimension == {} and value else ""
    return figure(value, error), f" {unit}".rstrip() + degrees


def table(rows: Sequence[list[str]], head: Sequence[str]) -> list[str]:
    """Lines of an aligned table; columns two spaces apart."""
    cells = [head, *rows]
    widths = [max(width(row[i]) for row in cells) for i in range(len(head))]
    return ["  ".join(padded(cell, w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in cells]


def width(text: str) -> int:
    """Columns of a text: combining dots take none."""
    return len(text) if text.isascii() else len(text) - len(COMBINING.findall(text))


def padded(text: str, columns: int) -> str:
    return text + " " * (columns - width(text))


def centred(text: str, columns: int) -> str:
    left = (columns - width(text)) // 2
    return padded(" " * left + text, columns)


def wrapped(text: str, columns: int = 100, indent: int = 2, gap: str = " ", first: int = 0) -> list[str]:
    """Text broken at gaps into lines of at most `columns`, the lines after the first indented."""
    lines, line = [], ""
    for word in text.split(gap):
        if line and width(line) + width(gap) + width(word) > columns:
            lines.append(line.rstrip())
            line = " " * indent + word if gap == " " else word
        elif lines and not line.strip():
            line += word
        else:
            line = f"{line}{gap}{word}" if line else " " * first + word
    return [*lines, line] if line else lines

def in_figures(value: float, figures: int) -> str:
    """A value with so many figures, without an exponent."""
    if not value:
        return "0"
    rounded = f"{value:.{figures - 1}e}"
    return f"{float(rounded):.{max(figures - 1 - int(rounded.partition('e')[2]), 0)}f}"


def shown_as_decimal(value: "Fraction | int") -> bool:
    """0.18·m·L² reads better as a decimal, 3/4·m·L² and π·d⁴/64 as fractions: those of denominators up to 48, of others
    those whose decimal is longer."""
    if value.denominator <= LARGEST:
        return False
    return value.denominator > LONGEST or abs(value.numerator) > LONGEST or len(
        f"{float(abs(value)):.12g}".replace("0.", "").lstrip("0")) <= FIGURES


def decimal(value: Any) -> str:
    """A rational as text: an integer, p/q, or a decimal where that is short enough, else 12 digits."""
    if value.denominator == 1:
        text = str(value.numerator)
        return text if len(text) < 16 else _short_exponent(f"{float(value):.12g}")
    if not shown_as_decimal(value):
        return f"{value.numerator}/{value.denominator}".replace("-", "−")
    return ("−" if value < 0 else "") + _short_exponent(f"{float(abs(value)):.12g}")


def added_as_decimal(node: "Node", value: "Fraction | int", measured: bool) -> bool:
    """Is the number in a sum written as a decimal, 0.3 beside L, as the numbers of the sum were? measured: has it a
    unit?"""
    if measured and value.denominator > 1 and _terminates(value):
        return True
    written = [node.coefficient, *(c for _, c in node.args)]
    return value.denominator > 1 and bool(node.args) and all(map(_terminates, written)) and any(
        c.denominator % 5 == 0 for c in written)


def _terminates(value: "int | Fraction") -> bool:
    """Is a rational a decimal of few digits?"""
    return (value * 1000).denominator == 1


def common_denominator(node: "Node", values: "Sequence[Fraction | int]") -> int:
    """The denominator that all terms of a sum of parameters share; 1 where they do not, or all have units."""
    if all(is_measured(part) for part, _ in node.args):
        return 1
    values = [*values, node.coefficient] if node.coefficient else values
    below = {value.denominator for value in values}
    return 1 if node.mask or len(below) > 1 or shown_as_decimal(values[0]) else below.pop()
