"""The unit of a number beside letters: m in L + 0.5 m. What multiplies all terms, and has a unit as well, stands as a
number alone, as in 2·(L + 0.5 m); where a number may be the factor of some of them alone, none is told: 300·x + 2 of a
spring of 300 N/m are newtons."""

from collections.abc import Callable, Collection, Mapping
from functools import reduce
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.symbolic.node import ALL_PURE
from vibcli.symbolic.parser import FUNCTIONS

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node

SMALL = 12      # numerator and denominator of what is a pure number where no number has hidden its unit
PURE = FUNCTIONS.keys() - {"abs", "max", "min", "ramp", "impulse", "sqrt"}     # functions whose values have no unit


def unit_beside(node: "Node") -> str:
    """The SI unit of the number in a sum; '' of a pure one, and where the terms of letters alone do not tell it."""
    return units.text(_of_sum(node, node.table.dimension, node.table.hidden) or units.NONE)


def _of_sum(node: "Node", dimension: Callable[[str], "Mapping[str, Fraction] | None"],
            hidden: "Collection[Any]") -> dict[str, Any] | None:
    """The dimension that all terms of letters have; None where they differ, one has none that is known, or each has a
    factor that may have a unit."""
    found = [dimension_of(part, dimension, hidden) for part, _ in node.args]
    factors = [c * part.coefficient if part.op == "product" else c for part, c in node.args]
    if hidden is not ALL_PURE and not any(_is_pure(hidden, factor) for factor in factors):
        return None
    return found[0] if all(one == found[0] for one in found) else None


def _is_pure(hidden: "Collection[Any]", c: "int | Fraction") -> bool:
    """Is a coefficient a number without a unit, where those of `hidden` literals are not told? Halves and thirds are:
    products of 0.3 m and 300 N/m have factors 5."""
    if abs(c) == 1:
        return 1 not in hidden
    return max(abs(c.numerator), c.denominator) <= SMALL and (not hidden or (
        _of_twos_and_threes(c) and not any(map(_of_twos_and_threes, hidden))))


def _of_twos_and_threes(c: "int | Fraction") -> bool:
    return 6**64 % c.numerator == 0 == 6**64 % c.denominator


def dimension_of(node: "Node", dimension: Callable[..., Any],
                 hidden: "Collection[Any] | None" = None) -> dict[str, Any] | None:
    """That of an expression by those of its letters; None where they do not tell it. `hidden`: numbers whose units are
    not told, those of literals in the file unless given."""
    hidden = node.table.hidden if hidden is None else hidden
    if node.op == "symbol":
        known = None if node.name.endswith("'") else dimension(node.name)
        return None if known is None or any(base.startswith("?") for base in known) else dict(known)
    if node.op == "product":
        parts = [(dimension_of(base, dimension, hidden), exponent) for base, exponent in node.args]
        if any(part is None for part, _ in parts):
            return None
        return reduce(lambda whole, part: units.times(whole, *part), parts, dict(units.NONE))
    if node.op == "sum":
        return _of_sum(node, dimension, hidden)
    pure = not hidden if node.op in ("pi", "number") else node.op == "call" and node.name in PURE
    return units.NONE if pure else None
