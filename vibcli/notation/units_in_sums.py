"""The unit of a number beside letters: m in L + 0.5 m. What multiplies all terms, and has a unit as well, stands as a
number alone, as in 2·(L + 0.5 m)."""

from functools import reduce
from typing import TYPE_CHECKING

from vibcli.base import units

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def unit_beside(node: "Node") -> str:
    """The SI unit of the number in a sum; '' of a pure one, and where the terms of letters alone are not of one
    dimension."""
    return units.text(_of_sum(node, node.table.dimension) or units.NONE)


def _of_sum(node, dimension) -> dict | None:
    """The dimension that all terms of letters have; None where they differ or one has none that is known."""
    found = [_of(part, dimension) for part, _ in node.args]
    return found[0] if found and all(one == found[0] for one in found) else None


def _of(node, dimension) -> dict | None:
    if node.op == "symbol":
        known = None if node.name.endswith("'") else dimension(node.name)
        return None if known is None or any(base.startswith("?") for base in known) else known
    if node.op == "product":
        parts = [(_of(base, dimension), exponent) for base, exponent in node.args]
        if any(part is None for part, _ in parts):
            return None
        return reduce(lambda whole, part: units.times(whole, *part), parts, units.NONE)
    return _of_sum(node, dimension) if node.op == "sum" else units.NONE if node.op in ("call", "pi", "number") else None
