"""Products of coordinates and their rates by which energies are expanded: x^2*y^2, x^2*x'^2."""

from typing import TYPE_CHECKING, Any

from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError, NameRef, Number, Power, Product

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.symbolic.syntax import SyntaxTree


def powers_in(spec: "Spec", text: str, highest: int) -> "dict[tuple[str, int], int] | None":
    """{(coordinate, primes): power} of a product; None of what is none, or of too high an order."""
    try:
        tree = parse(text)
    except ExpressionError:
        return None
    found: dict[tuple[str, int], int] = {}
    for side, factor in tree.parts if isinstance(tree, Product) else ((1, tree),):
        base: Any = factor.base if isinstance(factor, Power) else factor
        n = _whole(factor.exponent) if isinstance(factor, Power) else 1
        name = spec.coordinate_name(base.name) if isinstance(base, NameRef) and base.primes < 2 else None
        if name is None or not n or side != 1:
            return None
        found[name, base.primes] = found.get((name, base.primes), 0) + n
    return found if sum(found.values()) <= highest else None


def _whole(tree: "SyntaxTree") -> int | None:
    """A whole number from 1; None of anything else."""
    if isinstance(tree, Number) and not tree.units and tree.value.denominator == 1 and tree.value > 0:
        return int(tree.value)
    return None


def is_product(spec: "Spec", text: str, highest: int, rates: bool = False) -> bool:
    """Is it one, of coordinates alone unless with `rates`?"""
    found = powers_in(spec, text, highest)
    return found is not None and (rates or not any(primes for _, primes in found))
