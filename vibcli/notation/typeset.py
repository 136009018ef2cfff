"""Typeset notations: fractions stand on a line, roots under one. A subclass says how each is written:

    numeral(text)   lettered(letter, below, primes)   marked(text, marks)   functional(name)   applied(head, text, bare)
    times(texts)   fraction(above, below)   sqrt(text)   power(base, exponent)   brackets(text)   magnitude(text)
    flat(text), in brackets that need not grow   operator(symbol)   gap(columns)   words(text)   beside(*texts)
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.names import factors_of, split_marks, split_name
from vibcli.notation.notation_text import read
from vibcli.notation.numbers import decimal, shown_as_decimal
from vibcli.notation.plain import Notation, plain
from vibcli.notation.radicals import place
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node

KNOWN = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "ln"}


class Stacked(Notation):
    """Nodes with fractions and roots; texts in notation are read into the same pieces."""

    lettered: Callable[[str, str, str], str]
    marked: Callable[[str, int], str]
    functional: Callable[[str], str]
    applied: Callable[..., str]
    times: Callable[..., str]
    fraction: Callable[[str, str], str]
    sqrt: Callable[[str], str]
    magnitude: Callable[[str], str]
    words: Callable[[str], str]

    def notation(self, text: str) -> str:
        return read(text, self)

    def number(self, value: "Fraction | int") -> str:
        if value.denominator == 1 or shown_as_decimal(value):
            return self.numeral(decimal(value))
        found = self.fraction(self.numeral(str(abs(value.numerator))), self.numeral(str(value.denominator)))
        return self.signed(value < 0, found, first=True)

    def symbol(self, name: str) -> str:
        if factors := factors_of(name):
            return self.times(list(map(self.symbol, factors)))
        if "(" in name:
            return self.words(plain.symbol(name))
        name, marks = split_marks(name)
        letter, rest, primes = split_name(name)
        found = self.lettered(letter, rest.removeprefix("_"), primes)
        return self.marked(found, marks) if marks else found

    def call(self, name: str, arg: "Node", exponent: int) -> str:
        inner = self.write(arg, 0)
        if name == "abs":
            return self.magnitude(inner)
        head = self.functional(KNOWN.get(name, name))
        head = head if exponent == 1 else self.power(head, self.numeral(decimal(exponent)))
        bare = arg.op in ("symbol", "pi")
        return self.applied(head, inner if bare else self.brackets(inner), bare)

    def over(self, text: str, below: int) -> str:
        return self.fraction(text, self.numeral(str(below)))

    def product(self, value: Any, args: Any):
        value, above, below, root_above, root_below = self.factors(value, args)
        alone = len(above) == 1 and value.numerator == 1 and not (root_above or root_below)
        lone_root = root_below and not root_above
        flat = not below and not lone_root and (value.denominator == 1 or shown_as_decimal(value))
        tops = [self.powered(base, e, alone and (not flat or value == 1)) for base, e in above]
        if root_above:
            tops.insert(place(above, root_above), self.root(root_above, root_below))
        if flat:
            if value != 1 or not tops:
                tops.insert(0, self.numeral(decimal(value)))
            return self.times(tops)
        only = len(below) == 1 and value.denominator == 1 and not lone_root
        bottoms = [self.powered(base, e, only) for base, e in below]
        if lone_root:
            bottoms.append(self.root(root_below, []))
        if value.denominator > 1:
            bottoms.insert(0, self.numeral(str(value.denominator)))
        if value.numerator != 1 or not tops:
            tops.insert(0, self.numeral(str(value.numerator)))
        return self.fraction(self.times(tops), self.times(bottoms))

    def root(self, above: "Sequence[tuple[Node, Fraction | int]]",
             below: "Sequence[tuple[Node, Fraction | int]]") -> str:
        return self.sqrt(self.product(ONE, (*above, *((base, -e) for base, e in below))))
