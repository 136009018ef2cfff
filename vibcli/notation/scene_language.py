"""Expressions in the scene's own language, so that a result can be pasted into a file."""

import re

from vibcli.notation.plain import Plain, enclosed
from vibcli.symbolic.rationals import ONE


class Language(Plain):
    """The scene's own expression language, so that a result can be pasted into a file."""

    minus, dot, rounds = "-", "*", False

    def symbol(self, name):
        return name

    def number(self, value):
        return str(value.numerator) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"

    def power(self, base, exponent):
        return f"{base}^{exponent}" if re.fullmatch(r"\w+", exponent) else f"{base}^({exponent})"

    def call(self, name, arg, exponent):
        text = f"{name}({self.write(arg, 0)})"
        return text if exponent == 1 else self.power(text, self.number(exponent))

    def powered(self, base, exponent, alone):
        """A lone base as well: a number too long to be multiplied out may be negative."""
        return super().powered(base, exponent, False)

    def root(self, above, below):
        inner = self.product(ONE, (*above, *((base, -e) for base, e in below)))
        return f"sqrt({inner[1:-1] if enclosed(inner) else inner})"


language = Language()
