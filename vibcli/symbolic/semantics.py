"""The meaning of a syntax tree: its dimension, checked part by part, and the expression it stands for."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.node import ALL_PURE, UNITS, Node, rooted_square
from vibcli.symbolic.parser import FUNCTIONS
from vibcli.symbolic.rationals import HALF, ONE
from vibcli.symbolic.syntax import (
    ExpressionError,
    NameRef,
    Number,
    Power,
    Product,
    Sum,
    UnitPower,
    rebuilt,
    whole_literal,
)

if TYPE_CHECKING:
    from vibcli.base.units import Unit
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.syntax import Call, QuantityRef, SyntaxTree

ALL_NUMBERS = "all"
ANY = None          # the dimension of what fits everywhere: 0, and bare numbers in a scene without units


def literal_unit(chain: Sequence[UnitPower]) -> "Unit":
    return units.combine(tuple((name, power) for name, power, _, _ in chain))


def is_factor(tree: Any, free_numbers: bool | str) -> bool:
    """Is a bare number of a scene without units a factor, and no quantity?"""
    return tree.value < 10 and tree.value.denominator == 1 and free_numbers != ALL_NUMBERS


class DimensionCheck(NamedTuple):
    """The dimension of trees, given `of(name, primes)`, that of a name, and `quantity(tree)`, that of a quantity (None:
    any); every misfit is raised as an ExpressionError, which quotes the text. `free_numbers`: the scene uses no units
    at all, so a bare number may stand for any quantity; small whole ones are factors, unless it is ALL_NUMBERS: then
    everything fits, as a factor 1 with a unit is not written."""

    dimensions: units.Dimensions
    of: "Callable[[str, int], Mapping[str, Fraction | int]]"
    free_numbers: bool | str = False
    quantity: "Callable[[Any], Mapping[str, Fraction | int] | None] | None" = None
    text: str = ""

    def _same(self, one: Mapping[str, Fraction | int], other: Mapping[str, Fraction | int]) -> bool:
        return self.dimensions.equate(one, other) or self.free_numbers == ALL_NUMBERS

    def dimension(self, tree: Any) -> Mapping[str, Fraction | int] | None:
        found: Mapping[str, Fraction | int] | None = getattr(self, "_" + tree.kind)(tree)
        return found

    def _number(self, tree: Number) -> Mapping[str, Fraction | int] | None:
        if tree.units:
            return literal_unit(tree.units).dimension
        if not tree.value or (self.free_numbers and not is_factor(tree, self.free_numbers)):
            return ANY
        return units.NONE

    def _name(self, tree: NameRef) -> Mapping[str, Fraction | int]:
        if tree.name == "pi" and not tree.primes:
            return units.NONE
        return self.of(tree.name, tree.primes)

    def _quantity(self, tree: "QuantityRef") -> Mapping[str, Fraction | int] | None:
        return self.quantity(tree) if self.quantity else ANY

    def _sum(self, tree: Sum, done: str = "added") -> Mapping[str, Fraction | int] | None:
        found, first = ANY, None
        for _, part in tree.parts:
            dimension = ANY if self.free_numbers and whole_literal(part) else self.dimension(part)
            if dimension is ANY:
                continue
            if found is ANY:
                found, first = dimension, part
            elif not self._same(found, dimension):
                raise ExpressionError(part.start, part.end - part.start, f"these cannot be {done}: "
                                      f"{self._quoted(first)} is {self._words(found)}, "
                                      f"{self._quoted(part)} {self._words(dimension)}",
                                      "terms of one sum measure the same")
        if found is ANY and not self.free_numbers and all(whole_literal(part) for _, part in tree.parts):
            found = ANY if all(not whole_literal(part).value for _, part in tree.parts) else units.NONE
        return found

    def _quoted(self, part: "SyntaxTree") -> str:
        return quoted(self.text[part.start:part.end].strip())

    def _words(self, dimension: Mapping[str, Fraction | int] | None) -> str:
        return units.name(self.dimensions.resolve(dimension))

    def _product(self, tree: Product) -> Mapping[str, Fraction | int] | None:
        found = units.NONE
        for power, part in tree.parts:
            dimension = self.dimension(part)
            if dimension is ANY:
                return ANY
            found = units.times(found, dimension, power)
        return found

    def _power(self, tree: Power) -> Mapping[str, Fraction | int] | None:
        base = self.dimension(tree.base)
        exponent = constant(tree.exponent)
        if exponent is None:
            self._pure(tree.exponent, "an exponent")
            if base is not ANY:
                self._pure(tree.base, "the base of a power that is not a number")
            return units.NONE
        if abs(exponent) > 100:
            inner = tree.exponent
            raise ExpressionError(inner.start, inner.end - inner.start, "this power is out of range",
                                  "powers lie between -100 and 100")
        return base if base is ANY else units.raised(base, exponent)

    def _pure(self, tree: "SyntaxTree", what: str) -> None:
        dimension = self.dimension(tree)
        if dimension is not ANY and not self._same(dimension, units.NONE):
            raise ExpressionError(tree.start, tree.end - tree.start,
                                  f"{what} is a pure number, found {self._words(dimension)}",
                                  "a rate has its unit, as in 2 rad/s*t" if self._same(dimension, units.TIME) else None)

    def _call(self, tree: "Call") -> Mapping[str, Fraction | int] | None:
        name, args = tree.name, tree.args
        if name not in FUNCTIONS:
            return self._record(tree, name, args)
        if name == "sqrt":
            dimension = self.dimension(args[0])
            return dimension if dimension is ANY else units.raised(dimension, HALF)
        if name in ("abs", "ramp"):
            return self.dimension(args[0])
        if name == "impulse":
            dimension = self.dimension(args[0])
            return dimension if dimension is ANY else units.raised(dimension, -1)
        if name in ("sign", "step"):
            self.dimension(args[0])
            return units.NONE
        if name in ("min", "max", "atan2"):
            found = self._sum(Sum(tree.start, tree.end, tuple((1, arg) for arg in args)), "compared")
            return units.NONE if name == "atan2" else found
        self._pure(args[0], f"the argument of {name}")
        return units.NONE

    def _record(self, tree: "SyntaxTree", name: str,
                args: "Sequence[SyntaxTree]") -> Mapping[str, Fraction | int] | None:
        """The dimension of a record, at a time."""
        if len(args) != 1:
            raise ExpressionError(tree.start, tree.end - tree.start, f"{name} takes one argument, found {len(args)}",
                                  f"write {name}(t)")
        dimension = self.dimension(args[0])
        if dimension is not ANY and not self._same(dimension, units.TIME):
            raise ExpressionError(args[0].start, args[0].end - args[0].start, f"the argument of {name} is a time (s), "
                                  "found " + self._words(dimension))
        return self.dimensions.of(name + "()")


def constant(tree: Any) -> Any:
    """The rational value of a tree made of plain numbers, else None."""
    if isinstance(tree, Number):
        return None if tree.units else tree.value
    if tree.kind in ("sum", "product"):
        total = Fraction(0) if tree.kind == "sum" else ONE
        for sign, part in tree.parts:
            value = constant(part)
            if value is None or (tree.kind == "product" and sign < 0 and not value):
                return None
            total = total + sign * value if tree.kind == "sum" else total * value**sign
        return total
    return None


def lower(tree: Any, table: "Table", symbol: Callable[..., Node]) -> "Node":
    """The expression that a tree stands for; `symbol(name, primes, tree)` gives the node of a name or quantity."""
    if tree.kind == "number":
        return _literal(tree, table)
    if tree.kind == "name":
        return table.pi if tree.name == "pi" and not tree.primes else symbol(tree.name, tree.primes, tree)
    if tree.kind == "quantity":
        return symbol(tree.text, 0, tree)
    try:
        if tree.kind == "sum":
            return table.sum(*((lower(part, table, symbol), sign) for sign, part in tree.parts))
        if tree.kind == "product":
            factors = [(lower(part, table, symbol), power) for power, part in tree.parts]
            if any(power < 0 and node.is_zero for node, power in factors):
                raise ZeroDivisionError
            return table.product(*factors)
        if tree.kind == "power":
            return _raised(lower(tree.base, table, symbol), lower(tree.exponent, table, symbol))
        if tree.kind == "equation":
            return lower(tree.left, table, symbol) - lower(tree.right, table, symbol)
        args = [lower(arg, table, symbol) for arg in tree.args]
        return _raised(args[0], HALF) if tree.name == "sqrt" else table.call(tree.name, *args)
    except ZeroDivisionError:
        raise ExpressionError(tree.start, tree.end - tree.start, "this divides by zero",
                              "look for a difference that vanishes") from None


def lower_measured(tree: Any, table: "Table", symbol: Callable[[str, int, NameRef], Node]) -> "Node":
    """The same with literals times the letters of their units, where the table has these."""
    return lower(rebuilt(tree, _lettered) if table.hidden is ALL_PURE else tree, table, symbol)


def _lettered(part: "SyntaxTree") -> "SyntaxTree":
    if not isinstance(part, Number) or not part.units:
        return part
    start, end = part.start, part.end
    factors: list[tuple[int, Any]] = [(1, part)]
    for base, exponent in literal_unit(part.units).dimension.items():
        size = Number(start, end, abs(Fraction(exponent)), ())
        factors.append((1 if exponent > 0 else -1, Power(start, end, NameRef(start, end, UNITS[base], 0), size)))
    return Product(start, end, tuple(factors)) if factors[1:] else part


def _raised(base: Node, exponent: Fraction | Node) -> Node:
    """base^exponent, |x| for √(x²), which has a slope at x = 0 on both sides."""
    known: Any = exponent.coefficient if isinstance(exponent, Node) and exponent.op == "number" else exponent
    if base.mask and not isinstance(known, Node):
        return base.table.power(*rooted_square(base, known))
    return base.table.power(base, exponent)


def _literal(tree: Number, table: "Table") -> Node:
    if not tree.units:
        return table.number(tree.value)
    unit = literal_unit(tree.units)
    node = table.number(tree.value if unit.value == 1 else tree.value * unit.value)
    if not (unit.pi or unit.roots):
        return node
    roots = [(table.number(base), exponent) for base, exponent in unit.roots]
    return table.product((node, ONE), (table.pi, Fraction(unit.pi)), *roots)
