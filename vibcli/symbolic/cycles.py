"""Cycles told from radians: what each part of an expression counts, and where cycles meet what is due in radians.

A count is a dict of exponents like a dimension: CYCLE of Hz, PERIOD of the parameters that are periods T = 1/f, RADIAN
of rad and rpm, PI of the factors π. A factor π turns one cycle into radians, as in 2·π·f or m·4·π²·f²; what is left
counts CYCLE − PERIOD cycles. A rate v/R or a number n counts neither, and is added to both.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.parser import FUNCTIONS
from vibcli.symbolic.rationals import HALF
from vibcli.symbolic.semantics import ANY, constant, literal_unit
from vibcli.symbolic.syntax import ExpressionError, NameRef, Number, Product, Sum

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.base.units import Unit
    from vibcli.symbolic.syntax import Call, Equation, Power, QuantityRef, SyntaxTree

CYCLE, PERIOD, RADIAN, PI = "cycle", "period", "radian", "pi"
NEITHER = {}
OF_ANGLES = "an angular frequency is 2*pi*f: "


def count_of(unit: "Unit") -> "Mapping[str, Fraction | int]":
    return {key: power for key, power in ((CYCLE, unit.cycles), (RADIAN, unit.radians)) if power}


def left_over(count: "Mapping[str, Fraction | int]") -> Any:
    """The number of cycles that no factor π clears."""
    return count.get(CYCLE, 0) - count.get(PERIOD, 0)


def cleared(count: "Mapping[str, Fraction | int]") -> "Mapping[str, Fraction | int]":
    """The count with as many cycles turned into radians as it has factors π."""
    over, factors = left_over(count), count.get(PI, 0)
    if over > 0 and factors > 0:
        turned = min(over, factors)
    elif over < 0 and factors < 0 and count.get(CYCLE, 0) < 0:
        turned = max(over, factors, count[CYCLE])
    else:
        return count
    return units.times(count, {CYCLE: -1, PI: -1, RADIAN: 1}, turned)


def is_period(count: Any) -> bool:
    """Is it, if it is a time, one for each cycle: T = 1/f?"""
    return left_over(count) == -1 and not count.get(PERIOD) and count.get(PI, 0) <= 0


def in_radians(count: "Mapping[str, Fraction | int]", dimension: "Mapping[str, Fraction | int] | None") -> bool:
    """May it stand where radians are due? A period is a time like any other, and may be a factor of anything."""
    if left_over(count) > 0:
        return False
    return count.get(CYCLE, 0) >= 0 or left_over(count) == 0 or (dimension == units.TIME and is_period(count))


def fits_both(count: Any, dimension: "Mapping[str, Fraction | int] | None") -> bool:
    """Does it count neither, being a number or a rate, or what fits everywhere?"""
    angular = count.get(RADIAN, 0) > 0 and count.get(PI, 0) >= 0
    return left_over(count) == 0 and not angular and dimension in (units.NONE, units.RATE, ANY)


def agree(counts: "Sequence[Mapping[str, Fraction | int]]",
          dimensions: "Sequence[Mapping[str, Fraction | int]]") -> bool:
    """Can these be added or compared? All count as many cycles, or fit both."""
    over = set(map(left_over, counts))
    if over == {0, -1}:
        return all(map(in_radians, counts, dimensions))
    return len(over) <= 1 or (over == {0, 1} and all(
        left_over(count) or fits_both(count, dimension) for count, dimension in zip(counts, dimensions, strict=True)))


class Cycles(NamedTuple):
    """Counts of the parts of trees, given `of(name)` and `quantity(tree)`, the counts of names and quantities, and
    `dimension(tree)`; every misfit is raised as an ExpressionError."""

    of: "Callable[[str], Mapping[str, Fraction | int]]"
    quantity: "Callable[[Any], Mapping[str, Fraction | int]]"
    dimension: Callable[[Any], Any]
    text: str = ""

    def count(self, tree: Any) -> "Mapping[str, Fraction | int]":
        found: Mapping[str, Fraction | int] = getattr(self, "_" + tree.kind)(tree)
        return found

    def require_radians(self, tree: Any, message: str = "this counts cycles (Hz) where radians are due",
                        whole: bool = False) -> None:
        """Report a tree that counts cycles where an angle, a stiffness … is due."""
        count = self.count(tree)
        clear = left_over(count) <= 0 and count.get(CYCLE, 0) >= 0      # whatever it measures
        if not clear and not in_radians(count, self.dimension(tree)):
            start, end = (0, len(self.text)) if whole else (tree.start, tree.end)
            raise ExpressionError(start, end - start, message, self.advice(tree))

    def advice(self, tree: "SyntaxTree") -> str:
        """The place where a factor 2π is missing: at the first literal in Hz, or the first name that counts cycles."""
        if left_over(self.count(tree)) < 0 and self.dimension(tree) == units.TIME:
            return "the period of a frequency f in Hz is 1/f"
        part = self._uncleared(tree)
        count = self.count(part)
        if isinstance(part, NameRef) and count.get(PERIOD) == 1:
            found = OF_ANGLES + f"write 2*pi/{part.name}"
        elif isinstance(part, NameRef) and left_over(count) != 1:
            found = OF_ANGLES + f"write it so where '{part.name}' is defined"
        else:
            found = OF_ANGLES + f"write (2*pi*{self._text(part) if isinstance(part, (NameRef, Number)) else 'f'})"
        return found + ("; a period T = 1/f is a parameter of its own" if left_over(self.count(tree)) < 0 else "")

    def _uncleared(self, tree: "SyntaxTree") -> "SyntaxTree":
        """The first name or literal that brings in cycles without their factors π."""
        parts = tree.children
        while part := next((part for part in parts if left_over(self.count(part))), None):
            tree, parts = part, part.children
        return tree

    def _text(self, part: "SyntaxTree") -> str:
        return self.text[part.start:part.end].strip()

    def _number(self, tree: Number) -> "Mapping[str, Fraction | int]":
        if not tree.units:
            return NEITHER
        return count_of(literal_unit(tree.units))

    def _name(self, tree: NameRef) -> "Mapping[str, Fraction | int]":
        return {PI: 1} if tree.name == "pi" and not tree.primes else self.of(tree.name)

    def _quantity(self, tree: "QuantityRef") -> "Mapping[str, Fraction | int]":
        return self.quantity(tree)

    def _product(self, tree: Product) -> "Mapping[str, Fraction | int]":
        found = NEITHER
        for power, part in tree.parts:
            found = units.times(found, self.count(part), power)
        return cleared(found)

    def _power(self, tree: "Power") -> "Mapping[str, Fraction | int]":
        exponent = constant(tree.exponent)
        if exponent is None:
            self.require_radians(tree.exponent)
            self.require_radians(tree.base)
            return NEITHER
        return cleared(units.raised(self.count(tree.base), exponent))

    def _equation(self, tree: "Equation") -> "Mapping[str, Fraction | int]":
        return self._joined([tree.left, tree.right], "compared")

    def _sum(self, tree: Sum) -> "Mapping[str, Fraction | int]":
        return self._joined([part for _, part in tree.parts], "added")

    def _joined(self, parts: "Sequence[SyntaxTree]", done: str) -> "Mapping[str, Fraction | int]":
        """The count of terms that measure the same."""
        parts = [part for part in parts if not (isinstance(part, Number) and not part.value)]
        counts = [self.count(part) for part in parts]
        over = [left_over(count) for count in counts]
        if not agree(counts, [self.dimension(part) for part in parts] if len(set(over)) > 1 else ()):
            cyclic = max(range(len(parts)), key=lambda i: abs(over[i]))
            other = next(part for i, part in enumerate(parts) if over[i] != over[cyclic])
            cyclic = parts[cyclic]
            raise ExpressionError(cyclic.start, cyclic.end - cyclic.start, f"these cannot be {done}: "
                                  f"{quoted(self._text(cyclic))} counts cycles (Hz), as "
                                  f"{quoted(self._text(other))} does not", self.advice(cyclic))
        if counts and all(count == counts[0] for count in counts):
            return counts[0]
        most = max(over, default=0) or (min(over, default=0) if 0 not in over else 0)
        return {CYCLE: most} if most else NEITHER

    def _call(self, tree: "Call") -> "Mapping[str, Fraction | int]":
        name, args = tree.name, tree.args
        if name == "sqrt":
            return cleared(units.raised(self.count(args[0]), HALF))
        if name in ("abs", "ramp"):
            return self.count(args[0])
        if name == "impulse":
            return units.raised(self.count(args[0]), -1)
        if name in ("min", "max", "atan2"):
            found = self._joined(args, "compared")
            return NEITHER if name == "atan2" else found
        if name in ("sign", "step"):
            self.count(args[0])
            return NEITHER
        self.require_radians(args[0], f"the argument of {name} counts cycles (Hz)")
        return NEITHER if name in FUNCTIONS else self.of(name + "()")
