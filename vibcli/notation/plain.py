"""Expressions as text, m·L²·φ̈/3, in the notation of the field: dots for time derivatives, roots as √(…)."""

import itertools
import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from vibcli.notation.names import BESSEL, GREEK, SUBSCRIPT, factors_of, split_marks, split_name
from vibcli.notation.numbers import NEGATIVE, added_as_decimal, common_denominator, decimal, shown_as_decimal
from vibcli.notation.ordering import factor_rank, is_difference, is_rooted, positive_first, term_rank, upright
from vibcli.notation.radicals import enclosed, is_constant, place, split
from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.node import is_measure, is_number
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from typing import Self

    from vibcli.symbolic.node import Node

_SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_DOTS = {"": "", "'": "\u0307", "''": "\u0308"}
_COMPOSED = (("\u0307", "ABCDEFGHMNOPRSTWXYZabcdefghmnoprstwxyz",
              "ȦḂĊḊĖḞĠḢṀṄȮṖṘṠṪẆẊẎŻȧḃċḋėḟġḣṁṅȯṗṙṡṫẇẋẏż"),
             ("\u0308", "AEHOUWXYaehotuwxy", "ÄËḦÖÜẄẌŸäëḧöẗüẅẍÿ"))
PRECOMPOSED = {letter + dots: single for dots, letters, singles in _COMPOSED
               for letter, single in zip(letters, singles, strict=True)}


class Notation:
    """Writes nodes; the subclasses say how symbols, products, powers and brackets look. values: {symbol: number as
    text} of those that are put in."""

    minus, measures = "−", True         # are numbers written with their units?
    number: Callable[..., str]
    symbol: Callable[..., str]
    call: Callable[..., str]
    product: Callable[..., str]
    function: Callable[..., str]
    power: Callable[..., str]
    brackets: Callable[..., str]
    beside: Callable[..., str]
    words: Callable[..., str]

    def __init__(self, values: Mapping[str, str] = MappingProxyType({})) -> None:
        self.values = values

    def __call__(self, node: "Node") -> str:
        return self.write(node, 0)

    def write(self, node: "Node", tightness: int) -> str:
        """`tightness`: 0 within a sum, 1 within a product, 2 as the base of a power or argument."""
        text: str = getattr(self, "_" + node.op)(node, tightness)
        return text

    def _number(self, node: "Node", tightness: int) -> str:
        text = self.number(node.coefficient)
        loose = node.coefficient < 0 or (tightness > 1 and not decimal(node.coefficient).isdigit())
        return self.brackets(text) if loose and tightness else text

    def numeral(self, text: str) -> str:
        """A number as floats are printed, 1.2e+06."""
        return text

    def _pi(self, node: "Node", tightness: int) -> str:
        return self.symbol("pi")

    def with_values(self, values: Mapping[str, str]) -> "Self":
        """The same notation with numbers put in for symbols."""
        return type(self)(values)

    def _symbol(self, node: "Node", tightness: int) -> str:
        value = self.values.get(node.name)
        if is_measure(node):
            from vibcli.notation.measured import with_unit

            return with_unit(self, node.name, tightness)
        if value is None:
            return self.symbol(node.name)
        text = self.numeral(value)
        loose = value[0] in "-−" or ("e" in value and tightness > 1)
        return self.brackets(text) if loose and tightness else text

    def _sum(self, node: "Node", tightness: int) -> str:
        text = self.added(self.terms(node))
        return self.brackets(text) if tightness else text

    def terms(self, node: "Node") -> list[tuple[bool, str]]:
        """[(negative, text)] of the terms of a sum; one of a sum over a denominator, and of anything else."""
        if node.op != "sum":
            return [self._alone(node)]
        terms = sorted(node.args, key=term_rank)
        parts = [(c * part.coefficient if part.op == "product" else c, part) for part, c in terms]
        rooted = sum(is_rooted(part) for part, _ in terms)
        below = common_denominator(node, [value for value, _ in parts])
        pieces = [(value < 0, self.product(abs(value) * below, args))
                  for value, args in itertools.starmap(upright, parts)]
        if node.coefficient:
            place = 0 if all(is_constant(part) for part, _ in node.args) else len(pieces)
            pieces.insert(place, (node.coefficient < 0, self._added_number(node, below)))
        if pieces[0][0]:
            pieces = positive_first(pieces, rooted)
        if below == 1:
            return pieces
        turned = pieces[0][0]
        return [(turned, self.over(self.added([(sign is not turned, text) for sign, text in pieces]), below))]

    def _added_number(self, node: "Node", below: int) -> str:
        value = below * (-node.coefficient if node.coefficient < 0 else node.coefficient)
        unit = self.unit_beside(node)
        as_decimal = added_as_decimal(node, value, bool(unit))
        text = self.numeral(f"{float(value):.12g}") if as_decimal else self.number(value)
        return self.beside(text, self.unit(unit)) if unit and not self.values else text

    def unit_beside(self, node: "Node") -> str:
        """The unit that the number in a sum has."""
        if node.table.dimension is None:
            return ""
        from vibcli.notation.units_in_sums import unit_beside

        return unit_beside(node)

    def unit(self, text: str) -> str:
        """A unit behind a number."""
        return self.words(" " + text)

    def _alone(self, node: "Node") -> tuple[bool, str]:
        """(negative, text of the magnitude) of what is no sum."""
        if node.op == "number":
            return node.coefficient < 0, self.number(abs(node.coefficient))
        if node.op == "product":
            value, args = upright(node.coefficient, node, alone=True)
            return value < 0, self.product(abs(value), args)
        return False, self.write(node, 0)

    def signed(self, negative: bool, text: str, first: bool = False) -> str:
        """A term of a sum with the sign before it."""
        sign = self.minus if negative else "+"
        return (sign * negative if first else f" {sign} ") + text

    def added(self, pieces: Sequence[tuple[bool, str]]) -> str:
        """The sum of (negative, text)."""
        return "".join(self.signed(negative, text, not i) for i, (negative, text) in enumerate(pieces))

    def over(self, text: str, below: int) -> str:
        return f"({text})/{below}"

    def _product(self, node: "Node", tightness: int) -> str:
        text = self.added([self._alone(node)])
        loose = node.coefficient < 0 or is_number(node)
        return self.brackets(text) if tightness > 1 or (tightness and loose) else text

    def _call(self, node: "Node", tightness: int) -> str:
        if node.name == "power":
            return self.power(self.write(node.args[0], 2), self.write(node.args[1], 0))
        if node.name in PULSES or node.name in node.table.records:
            order = node.args[1].coefficient if len(node.args) > 1 else 0
            return self.function(node.name + "'" * order, [self.write(node.args[0], 0)])
        if node.name in node.table.functions:
            return self.symbol(node.table.functions[node.name].symbol) + self.brackets(self.write(node.args[0], 0))
        if len(node.args) == 1:
            return self.call(node.name, node.args[0], ONE)
        return self.function(node.name, [self.write(arg, 0) for arg in node.args])

    @staticmethod
    def bare(call: "Node") -> bool:
        """Does the argument of a function stand behind it without brackets?"""
        table = call.table
        return call.args[0].op in ("symbol", "pi") and not (
            call.name in PULSES or call.name in table.records or call.name in table.functions)

    def factors(self, value: Fraction | int, args: "Sequence[tuple[Node, Fraction | int]]") -> tuple[Any, ...]:
        """(value, above, below, under the root above, below it): a rational and lists of (node, exponent)."""
        if any(is_measure(base) for base, _ in args):
            from vibcli.notation.measured import measured

            value, args = measured(value, args, self.measures and not self.values)
            if not args:
                return value, [], [], [], []
        return split(value, sorted(args, key=factor_rank))

    def powered(self, base: Any, exponent: Any, alone: Any) -> str:
        if base.op == "call" and exponent != 1:
            angled = base.name in ("sin", "cos", "tan", "sinh", "cosh", "tanh")
            if angled and exponent.denominator == 1:
                return self.call(base.name, base.args[0], exponent)
            if base.name == "abs":
                return self.power(self.write(base, 0), self.number(exponent))
            if angled or base.name == "sign" or self.bare(base):      # exp φ² is exp(φ²)
                return self.power(self.brackets(self.write(base, 0)), self.number(exponent))
        if exponent == 1:
            return self.write(base, 0 if alone else 1)
        if base.op == "sum" and exponent.denominator == 1 and exponent.numerator % 2 == 0:
            leading, told = min(base.args, key=term_rank), base.table.squares_at_sample or is_difference(base)
            base = -base if leading[1] < 0 and not told else base
        text, bracketed = self.write(base, 2), base.op == "symbol" and (
            factors_of(base.name) or "dt\u00a0" in plain.symbol(base.name))
        return self.power(self.brackets(text) if bracketed else text, self.number(exponent))


WRITTEN = {"log": "ln"}     # functions that print has under another name


class Plain(Notation):
    """Unicode text; a no-break space holds a function and its argument together."""

    dot, rounds = "·", True     # rationals with a large denominator are written as decimals

    def notation(self, text: str) -> str:
        return NEGATIVE.sub("−", text)

    def unit(self, text: str) -> str:
        return "\u00a0" + text

    def words(self, text: str) -> str:
        return text

    def beside(self, *texts: str) -> str:
        return "".join(texts)

    def number(self, value: Any) -> str:
        return "−" + decimal(-value) if value < 0 else decimal(value)

    def symbol(self, name: str) -> str:
        if factors := factors_of(name):
            return "".join(map(self.symbol, factors))
        if "(" in name:
            from vibcli.notation.typed_values import placed

            return placed(name, self.symbol)
        name, marks = split_marks(name)
        letter, rest, primes = split_name(name)
        letter = GREEK.get(letter, letter)
        below = rest.translate(SUBSCRIPT) if rest.isdigit() else rest
        if len(letter) > 1:
            return letter + "′" * marks + primes
        dotted = letter + _DOTS[primes]
        return PRECOMPOSED.get(dotted, dotted) + below + "′" * marks

    def brackets(self, text: str) -> str:
        return f"({text})"

    def power(self, base: str, exponent: str) -> str:
        if re.fullmatch(r"-?\d+", exponent):
            return base + exponent.translate(_SUPERSCRIPT)
        return f"{base}^{exponent}" if re.fullmatch(r"\w+", exponent) else f"{base}^({exponent})"

    def function(self, name: str, args: Sequence[str]) -> str:
        return f"{name}({', '.join(args)})"

    def divisors(self, below: "Sequence[tuple[Node, int]]") -> list[str]:
        """The factors below a line; a quotient has brackets: x/(y/z) is not x/y/z."""
        texts = [self.powered(base, e, False) for base, e in below]
        return [self.brackets(text) if base.op in ("product", "number") and "/" in text else text
                for (base, _), text in zip(below, texts, strict=True)]

    def call(self, name: str, arg: "Node", exponent: int) -> str:
        if name == "abs":
            return f"|{self.write(arg, 0)}|"
        indexed = name in BESSEL
        name = self.symbol(name) if indexed else WRITTEN.get(name, name)
        head = name if exponent == 1 else name + decimal(exponent).translate(_SUPERSCRIPT)
        inner = self.write(arg, 0)
        return f"{head}\u00a0{inner}" if arg.op in ("symbol", "pi") and not indexed else f"{head}({inner})"

    @staticmethod
    def as_decimal(value: Fraction | int) -> bool:
        """Does a product begin with a decimal, rather than have its denominator below the line?"""
        return shown_as_decimal(value)

    def product(self, value: Any, args: Any) -> str:
        value, above, below, root_above, root_below = self.factors(value, args)
        single = len(above) == 1 and value.numerator == 1 and not (below or root_above or root_below)
        tops = [self.powered(base, e, single and value == 1) for base, e in above]
        bottoms = self.divisors(below)
        if root_above:
            tops.insert(place(above, root_above), self.root(root_above, root_below))
        elif root_below:
            bottoms.append(self.root(root_below, []))
        if value.denominator > 1 and not self.as_decimal(value):
            bottoms.insert(0, str(value.denominator))
            value = Fraction(value.numerator)
        if value != 1 or not tops:
            tops.insert(0, decimal(value) if self.rounds else self.number(value))
        text = self.dot.join(tops)
        if not bottoms:
            return text
        return text + "/" + (bottoms[0] if len(bottoms) == 1 else f"({self.dot.join(bottoms)})")

    def root(self, above: "Sequence[tuple[Node, int]]", below: "Sequence[tuple[Node, int]]") -> str:
        inner = self.product(ONE, (*above, *((base, -e) for base, e in below)))
        simple = re.fullmatch(r"[\w₀-₉]+", inner)
        return "√" + (inner if simple or enclosed(inner) else f"({inner})")


plain = Plain()
