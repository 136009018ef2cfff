"""What a syntax tree means: its dimension, checked part by part, and the expression it stands for."""

from fractions import Fraction

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.symbolic.parser import FUNCTIONS, ExpressionError
from vibcli.symbolic.rationals import HALF, ONE

ALL_NUMBERS = "all"
ANY = None          # the dimension of what fits everywhere: 0, and bare numbers in a scene without units


def _within(tree, kind):
    """The parts of a tree that are of one kind."""
    pending, found = [tree], []
    while pending:
        part = pending.pop()
        if part[0] == kind:
            found.append(part)
        pending.extend(children(part))
    return found


def names_in(tree):
    """(name, primes, start, end) of each name of a tree."""
    return [(part[3], part[4], part[1], part[2]) for part in _within(tree, "name")]


def quantities_in(tree):
    """The quantity trees (`omega[1]`) within a tree."""
    return _within(tree, "quantity")


def calls_in(tree):
    """The calls of functions and records within a tree."""
    return _within(tree, "call")


def literals_in(tree):
    """The number trees within a tree."""
    return _within(tree, "number")


def children(tree):
    kind = tree[0]
    if kind in ("sum", "product"):
        return [part for _, part in tree[3]]
    if kind == "call":
        return tree[4]
    if kind in ("power", "equation"):
        return tree[3:5]
    return ()


def literal_unit(chain):
    return units.combine(tuple((name, power) for name, power, _, _ in chain))


def whole_literal(tree):
    """The number tree of a field that is one literal, perhaps with a sign; else None."""
    if tree[0] == "sum" and len(tree[3]) == 1:
        tree = tree[3][0][1]
    return tree if tree[0] == "number" else None


class DimensionCheck:
    """The dimension of trees, given `of(name, primes) -> dimension`; every misfit is raised as an ExpressionError.

    `free_numbers`: the scene uses no units at all, so a bare number may stand for any quantity; small whole ones are
    factors, unless it is ALL_NUMBERS: then everything fits, as a factor 1 with a unit is not written.
    """

    def __init__(self, dimensions, of, free_numbers=False, quantity=None, text=""):
        self.dimensions, self.of, self.free_numbers, self.quantity = dimensions, of, free_numbers, quantity
        self.text = text

    def _same(self, one, other):
        return self.dimensions.equate(one, other) or self.free_numbers == ALL_NUMBERS

    def dimension(self, tree):
        return getattr(self, "_" + tree[0])(tree)

    def _number(self, tree):
        if tree[4]:
            return literal_unit(tree[4]).dimension
        small = tree[3] < 10 and tree[3].denominator == 1 and self.free_numbers != ALL_NUMBERS
        if not tree[3] or (self.free_numbers and not small):
            return ANY
        return units.NONE

    def _name(self, tree):
        if tree[3] == "pi" and not tree[4]:
            return units.NONE
        return self.of(tree[3], tree[4])

    def _quantity(self, tree):
        return self.quantity(tree) if self.quantity else ANY

    def _sum(self, tree, done="added"):
        found, first = ANY, None
        for _, part in tree[3]:
            dimension = ANY if self.free_numbers and whole_literal(part) else self.dimension(part)
            if dimension is ANY:
                continue
            if found is ANY:
                found, first = dimension, part
            elif not self._same(found, dimension):
                raise ExpressionError(part[1], part[2] - part[1], f"these cannot be {done}: {self._quoted(first)} is "
                                      f"{self._words(found)}, {self._quoted(part)} {self._words(dimension)}",
                                      "terms of one sum measure the same")
        if found is ANY and not self.free_numbers and all(whole_literal(part) for _, part in tree[3]):
            found = ANY if all(not whole_literal(part)[3] for _, part in tree[3]) else units.NONE
        return found

    def _quoted(self, part):
        return quoted(self.text[part[1]:part[2]].strip())

    def _words(self, dimension):
        return units.name(self.dimensions.resolve(dimension))

    def _product(self, tree):
        found = units.NONE
        for power, part in tree[3]:
            dimension = self.dimension(part)
            if dimension is ANY:
                return ANY
            found = units.times(found, dimension, power)
        return found

    def _power(self, tree):
        base = self.dimension(tree[3])
        exponent = constant(tree[4])
        if exponent is None:
            self._pure(tree[4], "an exponent")
            if base is not ANY:
                self._pure(tree[3], "the base of a power that is not a number")
            return units.NONE
        if abs(exponent) > 100:
            raise ExpressionError(tree[4][1], tree[4][2] - tree[4][1], "this power is out of range",
                                  "powers lie between -100 and 100")
        return base if base is ANY else units.raised(base, exponent)

    def _pure(self, tree, what):
        dimension = self.dimension(tree)
        if dimension is not ANY and not self._same(dimension, units.NONE):
            raise ExpressionError(tree[1], tree[2] - tree[1],
                                  f"{what} is a pure number, found {self._words(dimension)}")

    def _call(self, tree):
        name, args = tree[3], tree[4]
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
            found = self._sum(("sum", tree[1], tree[2], [(1, arg) for arg in args]), "compared")
            return units.NONE if name == "atan2" else found
        self._pure(args[0], f"the argument of {name}")
        return units.NONE


    def _record(self, tree, name, args):
        """The dimension of a record, at a time."""
        if len(args) != 1:
            raise ExpressionError(tree[1], tree[2] - tree[1], f"{name} takes one argument, found {len(args)}",
                                  f"write {name}(t)")
        dimension = self.dimension(args[0])
        if dimension is not ANY and not self._same(dimension, units.TIME):
            raise ExpressionError(args[0][1], args[0][2] - args[0][1], f"the argument of {name} is a time (s), found "
                                  + self._words(dimension))
        return self.dimensions.of(name + "()")


def constant(tree):
    """The rational value of a tree made of plain numbers, else None."""
    if tree[0] == "number":
        return None if tree[4] else tree[3]
    if tree[0] in ("sum", "product"):
        total = Fraction(0) if tree[0] == "sum" else ONE
        for sign, part in tree[3]:
            value = constant(part)
            if value is None or (tree[0] == "product" and sign < 0 and not value):
                return None
            total = total + sign * value if tree[0] == "sum" else total * value**sign
        return total
    return None


def lower(tree, table, symbol):
    """The expression that a tree stands for; `symbol(name, primes, tree)` gives the node of a name or quantity."""
    kind = tree[0]
    if kind == "number":
        return _literal(tree, table)
    if kind == "name":
        return table.pi if tree[3] == "pi" and not tree[4] else symbol(tree[3], tree[4], tree)
    if kind == "quantity":
        return symbol(tree[3], 0, tree)
    try:
        if kind == "sum":
            return table.sum(*((lower(part, table, symbol), sign) for sign, part in tree[3]))
        if kind == "product":
            factors = [(lower(part, table, symbol), power) for power, part in tree[3]]
            if any(power < 0 and node.is_zero for node, power in factors):
                raise ZeroDivisionError
            return table.product(*factors)
        if kind == "power":
            return table.power(lower(tree[3], table, symbol), lower(tree[4], table, symbol))
        if kind == "equation":
            return lower(tree[3], table, symbol) - lower(tree[4], table, symbol)
        args = [lower(arg, table, symbol) for arg in tree[4]]
        return table.sqrt(args[0]) if tree[3] == "sqrt" else table.call(tree[3], *args)
    except ZeroDivisionError:
        raise ExpressionError(tree[1], tree[2] - tree[1], "this divides by zero",
                              "look for a difference that vanishes") from None


def _literal(tree, table):
    value = table.number(tree[3])
    if not tree[4]:
        return value
    unit = literal_unit(tree[4])
    node = table.number(tree[3] * unit.value)
    if not (unit.pi or unit.roots):
        return node
    roots = [(table.number(base), exponent) for base, exponent in unit.roots]
    return table.product((node, ONE), (table.pi, Fraction(unit.pi)), *roots)
