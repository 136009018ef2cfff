"""The syntax tree of an expression: what each part holds, and where it stands in the text."""

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from typing import Literal

REMEMBERED = 1024           # trees


class ExpressionError(Exception):
    """Not an expression: offset and width of the place in the text, what is wrong, and what to write."""

    def __init__(self, offset: int, width: int, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.offset, self.width, self.message, self.hint = offset, max(width, 1), message, hint


class UnitPower(NamedTuple):
    """One unit of a literal: `mm` and −2 of `3 N/mm^2`."""

    unit: str
    power: int | Fraction
    start: int
    end: int


class Number(NamedTuple):
    """A literal; `units` is empty for a plain number."""

    start: int
    end: int
    value: Fraction
    units: tuple[UnitPower, ...]
    kind: 'Literal["number"]' = "number"
    children = ()


class NameRef(NamedTuple):
    """A name, perhaps of parts as in `tip.x`; primes: 1 for x', 2 for x''."""

    start: int
    end: int
    name: str
    primes: int
    kind: 'Literal["name"]' = "name"
    children = ()


class QuantityRef(NamedTuple):
    """omega[1], J[disc, O], centre[rod].x, frf[x, F](5 Hz), amplitude(x); of x(2 s) the head is VALUE, and the first
    argument x. `alone`: the last index stands in square brackets of its own, as in K[x,y][2]."""

    start: int
    end: int
    text: str
    head: str
    indices: tuple[str, ...] = ()
    component: str = ""
    args: tuple[Any, ...] = ()
    kind: 'Literal["quantity"]' = "quantity"
    alone: bool = False
    children = ()


class Sum(NamedTuple):
    """parts: (sign, tree) of each term."""

    start: int
    end: int
    parts: "tuple[tuple[int, SyntaxTree], ...]"
    kind: 'Literal["sum"]' = "sum"
    children = property(lambda self: [part for _, part in self.parts])


class Product(NamedTuple):
    """parts: (power, tree) of each factor, the power 1 or −1."""

    start: int
    end: int
    parts: "tuple[tuple[int, SyntaxTree], ...]"
    kind: 'Literal["product"]' = "product"
    children = property(lambda self: [part for _, part in self.parts])


class Power(NamedTuple):
    """base^exponent."""

    start: int
    end: int
    base: "SyntaxTree"
    exponent: "SyntaxTree"
    kind: 'Literal["power"]' = "power"
    children = property(attrgetter("base", "exponent"))


class Call(NamedTuple):
    """A function or record of its arguments."""

    start: int
    end: int
    name: str
    args: tuple[Any, ...]
    kind: 'Literal["call"]' = "call"
    children = property(attrgetter("args"))


class Equation(NamedTuple):
    """left = right."""

    start: int
    end: int
    left: "SyntaxTree"
    right: "SyntaxTree"
    kind: 'Literal["equation"]' = "equation"
    children = property(attrgetter("left", "right"))


if TYPE_CHECKING:
    SyntaxTree = Number | NameRef | QuantityRef | Sum | Product | Power | Call | Equation


class Parts(NamedTuple):
    """The parts of a tree by their kinds: (name, primes, start, end) of each name, the numbers, the calls of functions
    and records, the quantities (`omega[1]`); `whole`: the number that it is as a whole, perhaps signed, or None."""

    names: list[tuple[str, int, int, int]]
    numbers: list[Number]
    calls: list[Call]
    quantities: list[QuantityRef]
    whole: Number | None


def parts_of(tree: Any) -> Parts:
    """The Parts of a tree, in one walk, the same for trees that are alike."""
    return Parts([], [tree], [], [], tree) if tree.kind == "number" else _parts_of(tree)


@lru_cache(REMEMBERED)
def _parts_of(tree: "SyntaxTree") -> Parts:
    names, numbers, calls, quantities, pending = [], [], [], [], [tree]
    while pending:
        part = pending.pop()
        if part.kind == "name":
            names.append((part.name, part.primes, part.start, part.end))
        elif part.kind == "number":
            numbers.append(part)
        elif part.kind == "quantity":
            quantities.append(part)
        else:
            if part.kind == "call":
                calls.append(part)
            pending.extend(part.children)
    return Parts(names, numbers, calls, quantities, whole_literal(tree))


def names_within(tree: Any) -> list[str]:
    """All names, those in the arguments of quantities too."""
    parts = parts_of(tree)
    return [name for name, *_ in parts.names] + [name for part in parts.quantities for arg in part.args
                                                for name in names_within(arg)]


def rebuilt(tree: Any, change: "Callable[[SyntaxTree], SyntaxTree]") -> Any:
    """The tree in which `change(part)` stands for every part, those within it changed first."""
    if isinstance(tree, (Sum, Product)):
        tree = tree._replace(parts=tuple((sign, rebuilt(part, change)) for sign, part in tree.parts))
    elif isinstance(tree, (Call, QuantityRef)):
        tree = tree._replace(args=tuple(rebuilt(arg, change) for arg in tree.args))
    elif isinstance(tree, Power):
        tree = tree._replace(base=rebuilt(tree.base, change), exponent=rebuilt(tree.exponent, change))
    elif isinstance(tree, Equation):
        tree = tree._replace(left=rebuilt(tree.left, change), right=rebuilt(tree.right, change))
    return change(tree)


def whole_literal(tree: Any) -> Number | None:
    """The number tree of a field that is one literal, perhaps with a sign; else None."""
    if isinstance(tree, Sum) and len(tree.parts) == 1:
        tree = tree.parts[0][1]
    return tree if isinstance(tree, Number) else None
