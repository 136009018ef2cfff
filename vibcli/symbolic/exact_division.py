"""Quotients of polynomials {monomial: coefficient} without a rest."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.node import times
from vibcli.symbolic.rationals import ZERO

if TYPE_CHECKING:
    from vibcli.symbolic.node import Monomial, Node


def without(total: "Node", terms: Any, cleared: "Callable[[Mapping[Monomial, Fraction | int], Any], dict[Any, Any]]",
            expanded: Callable[..., dict[Any, Any]]) -> Any:
    """The polynomial without a sum that it is divided by, where that goes into all of it, and without brackets that
    stood for it above the line; itself where it does not. `cleared(terms, below)`: what stands above."""
    below = max((0, *(-dict(monomial).get(total, 0) for monomial in terms)))
    try:
        found, divisor = cleared(terms, ((total, below),)), expanded(total, ())
    except ArithmeticError:
        return terms
    for _ in range(int(below)):
        found = found and divided(found, divisor)
    return terms if found is None else found


def divided(terms: "Mapping[Monomial, Fraction | int]", divisor: Any) -> dict[Any, Any] | None:
    """The polynomial terms/divisor where the division leaves no rest, else None."""
    lead = max(divisor, key=_rank)
    rest: dict[Any, Any] = dict(terms)
    found = {}
    while rest:
        top = max(rest, key=_rank)
        power = times(top, lead, -1)
        if any(e < 0 for _, e in power) or len(found) > len(terms):
            return None
        value = Fraction(rest[top]) / divisor[lead]
        found[power] = value
        for monomial, c in divisor.items():
            product = times(power, monomial)
            left = rest.pop(product, ZERO) - value * c
            if left:
                rest[product] = left
    return found


def _rank(monomial: "Monomial") -> tuple[Fraction | int, list[tuple[int, Fraction | int]]]:
    """Lexicographic order by the indices of the atoms, the degree first."""
    return sum(e for _, e in monomial), [(-atom.index, e) for atom, e in monomial]
