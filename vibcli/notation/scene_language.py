"""Expressions in the scene's own language, so that a result can be pasted into a file."""

import re
from collections.abc import Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Any

from vibcli.notation.plain import Plain
from vibcli.notation.radicals import enclosed
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node


COMPUTED = 10 ** 6      # denominators from which on a number is a decimal


class Language(Plain):
    """The scene's own expression language, so that a result can be pasted into a file."""

    minus, dot, rounds, measures = "-", "*", False, False

    def symbol(self, name: str) -> str:
        return name

    def number(self, value: "Fraction | int") -> str:
        if self.as_decimal(value):
            return f"{Decimal(value.numerator) / value.denominator:f}"
        return str(value.numerator) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"

    def unit_beside(self, node: "Node") -> str:
        """None, for programs that read it."""
        return ""

    @staticmethod
    def as_decimal(value: "Fraction | int") -> bool:
        """Those of so many figures that they were measured or computed, and that a decimal is exactly."""
        return value.denominator >= COMPUTED and Decimal(value.numerator) / value.denominator == value

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^{exponent}" if re.fullmatch(r"\w+", exponent) else f"{base}^({exponent})"

    def call(self, name: str, arg: "Node", exponent: int) -> str:
        text = f"{name}({self.write(arg, 0)})"
        return text if exponent == 1 else self.power(text, self.number(exponent))

    def powered(self, base: Any, exponent: Any, alone: Any) -> str:
        """A lone base as well: a number too long to be multiplied out may be negative."""
        return super().powered(base, exponent, False)

    def root(self, above: "Sequence[tuple[Node, Fraction | int]]", below: "Sequence[tuple[Node, int]]") -> str:
        inner = self.product(ONE, (*above, *((base, -e) for base, e in below)))
        return f"sqrt({inner[1:-1] if enclosed(inner) else inner})"


language = Language()

_RAISED = re.compile("[⁰¹²³⁴-⁹⁻ᐟ]+")
_DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᐟ", "0123456789-/")


def unit_in_scene(text: str) -> str:
    """A unit as a value in a scene has it: kg·m² → kg*m^2, 1/s → s^-1, kg/(m·s) → kg/m/s; nothing for a pure number."""
    above, _, below = _RAISED.sub(_power, text).replace("·", "*").partition("/") if "ᐟ" not in text else (
        _RAISED.sub(_power, text).replace("·", "*"), "", "")
    parts = below.strip("()").split("*") if below else []
    if above == "1":
        above = re.sub(r"(\^(.*))?$", lambda found: f"^-{found[2] or 1}", parts.pop(0), count=1) if parts else ""
    return "/".join([above, *parts])


def _power(found: re.Match[str]) -> str:
    power = found.group().translate(_DIGITS)
    return f"^({power})" if "/" in power else f"^{power}"
