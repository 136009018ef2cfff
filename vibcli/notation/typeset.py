"""Typeset notations: fractions stand on a line, roots under one. A subclass says how each is written:

    numeral(text)   lettered(letter, below, primes)   marked(text, marks)   functional(name)   applied(head, text, bare)
    times(texts)   fraction(above, below)   sqrt(text)   power(base, exponent)   brackets(text)   magnitude(text)
    flat(text), in brackets that need not grow   operator(symbol)   gap(columns)   words(text)   beside(*texts)
    rows(texts), one below the other   matrix(rows)   markup, what its texts hold beside what is seen
"""

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.names import BESSEL, factors_of, split_marks, split_name
from vibcli.notation.notation_text import read
from vibcli.notation.numbers import decimal, shown_as_decimal
from vibcli.notation.plain import Notation, plain
from vibcli.notation.radicals import place
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node

SIGNS = re.compile("[-−+]")      # each between spaces
WIDEST = 80     # columns of a sum on one line within a fraction, a root or brackets
LEAST, STUB = 24, 12    # columns of factors that rows may part; that no row ends with
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
    rows: Callable[[list[str]], str]
    markup: re.Pattern[str]
    flat: Callable[[str], str]
    gap: Callable[[int], str]
    operator: Callable[[str], str]

    def __call__(self, node: "Node") -> str:
        """A sum that stands by itself is on one line: who sets it breaks it, if it is long."""
        return super().added(self.terms(node)) if node.op == "sum" else self.write(node, 0)

    def added(self, pieces: Sequence[tuple[bool, str]]) -> str:
        """The sum; in rows where it is too wide for one, since nothing breaks what stands in a fraction or brackets."""
        return self.in_rows([self.signed(negative, text, not i) for i, (negative, text) in enumerate(pieces)])

    def multiplied(self, texts: list[str]) -> str:
        """The product; in rows where it is too wide for one, between factors that are no letters."""
        rows = texts[:1]
        for text in texts[1:]:
            sizes = self._columns(rows[-1]), self._columns(text)
            if sum(sizes) > WIDEST and min(sizes) > LEAST:
                rows.append(self.times(["", text]))
            else:
                rows[-1] = self.times([rows[-1], text])
        return self.rows(rows) if len(rows) > 1 else rows[0]

    def in_rows(self, texts: list[str]) -> str:
        """Texts side by side, as far as a line holds them."""
        rows, size = [""], 0
        for text in texts:
            columns = self._columns(text)
            if size > STUB and size + columns > WIDEST:
                rows.append("")
                size = 0
            rows[-1] += text
            size += columns
        return self.rows(rows) if len(rows) > 1 else rows[0]

    def _columns(self, text: str) -> int:
        """About those of a text as it is seen; none counts them of a short one."""
        if len(text) <= STUB:
            return len(text)
        seen = self.markup.sub("", text)
        return len(seen) + 2 * len(SIGNS.findall(seen))

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
        head = self.symbol(name) if name in BESSEL else self.functional(KNOWN.get(name, name))
        head = head if exponent == 1 else self.power(head, self.numeral(decimal(exponent)))
        bare = arg.op in ("symbol", "pi") and name not in BESSEL
        return self.applied(head, inner if bare else self.brackets(inner), bare)

    def over(self, text: str, below: int) -> str:
        return self.fraction(text, self.numeral(str(below)))

    def product(self, value: Any, args: Any) -> str:
        value, above, below, root_above, root_below = self.factors(value, args)
        alone = len(above) == 1 and value.numerator == 1 and not (root_above or root_below)
        lone_root = root_below and not root_above
        whole = value.denominator == 1 or shown_as_decimal(value)
        flat = whole and not below and not lone_root
        tops = [self.powered(base, e, alone and (not whole or value == 1)) for base, e in above]
        if root_above:
            tops.insert(place(above, root_above), self.root(root_above, root_below))
        if flat:
            if value != 1 or not tops:
                tops.insert(0, self.numeral(decimal(value)))
            return self.multiplied(tops)
        only = len(below) == 1 and whole and not lone_root
        bottoms = [self.powered(base, e, only) for base, e in below]
        if lone_root:
            bottoms.append(self.root(root_below, []))
        if not whole:
            bottoms.insert(0, self.numeral(str(value.denominator)))
        number = value if whole else value.numerator
        if number != 1 or not tops:
            tops.insert(0, self.numeral(decimal(number)))
        return self.fraction(self.multiplied(tops), self.multiplied(bottoms))

    def root(self, above: "Sequence[tuple[Node, Fraction | int]]",
             below: "Sequence[tuple[Node, Fraction | int]]") -> str:
        return self.sqrt(self.product(ONE, (*above, *((base, -e) for base, e in below))))
