"""Expressions in the scene's own language, so that a result can be pasted into a file."""

import re

from vibcli.notation.plain import Plain, enclosed
from vibcli.notation.radicals import place
from vibcli.symbolic.rationals import ONE


class Language(Plain):
    """The scene's own expression language, so that a result can be pasted into a file."""

    minus = "-"

    def symbol(self, name):
        return name

    def number(self, value):
        return self._ascii(value)

    @staticmethod
    def _ascii(value):
        return str(value.numerator) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"

    def power(self, base, exponent):
        return f"{base}^{exponent}" if re.fullmatch(r"\w+", exponent) else f"{base}^({exponent})"

    def call(self, name, arg, exponent):
        text = f"{name}({self.write(arg, 0)})"
        return text if exponent == 1 else self.power(text, self._ascii(exponent))

    def product(self, value, args):
        value, above, below, root_above, root_below = self.factors(value, args)
        tops = [self.powered(base, e, False) for base, e in above]
        bottoms = self.divisors(below)
        if root_above:
            tops.insert(place(above, root_above), self.root(root_above, root_below))
        elif root_below:
            bottoms.append(self.root(root_below, []))
        if value.denominator > 1:
            bottoms.insert(0, str(value.denominator))
        if value.numerator != 1 or not tops:
            tops.insert(0, str(value.numerator))
        text = "*".join(tops)
        return text if not bottoms else text + "/" + (bottoms[0] if len(bottoms) == 1 else f"({'*'.join(bottoms)})")

    def root(self, above, below):
        inner = self.product(ONE, (*above, *((base, -e) for base, e in below)))
        return f"sqrt({inner[1:-1] if enclosed(inner) else inner})"


language = Language()
