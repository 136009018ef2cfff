"""Amplitudes as functions of ω: short where those in letters alone are long, as of two roots with a letter under √.

Of two coordinates q₂/q₁ = −(K₁₁ − ω²M₁₁)/(K₁₂ − ω²M₁₂) or from the second row, whichever is shorter; where G turns and
nothing else couples them, q₂/q₁ = i·(K₁₁ − ω²M₁₁)/(ω G₁₂).
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.rational_functions import Quotients, factored

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.closed_forms import ClosedMode
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

OMEGA = "ω"


def of_omega(quotients: Quotients, element: Sequence[Any]) -> "Node":
    """u₀ + u₁λ of a field as a node with ω² for λ."""
    u, v = (list(element) + [quotients.field(0)] * 2)[:2]
    node = quotients.node(u + v * quotients.unknown)
    return substitute([node], {quotients.symbol: quotients.table.parameter(OMEGA) ** 2})[0]


def ratio(table: "Table", M: Any, K: Any) -> "Node":
    """q₂/q₁ of two coordinates as the shorter of what their two equations say."""
    own, across, back, other = (_entry(table, M, K, *pair) for pair in ((0, 0), (0, 1), (1, 0), (1, 1)))
    parts = [factored(-above / below) for above, below in ((own, across), (back, other)) if not below.is_zero]
    return min((part for part in parts if not part.is_zero), key=letters)


def with_ratio(table: "Table", mode: "ClosedMode", M: "Mapping[tuple[int, int], Node]", G: Mapping[Any, Any],
               K: "Mapping[tuple[int, int], Node]") -> "ClosedMode":
    """A mode of two coordinates with its pattern."""
    if mode.pattern and not G:
        return mode._replace(pattern=[table.one, min((ratio(table, M, K), mode.pattern[1]), key=letters)])
    if G and not mode.square.is_zero and (0, 1) not in M and (0, 1) not in K:
        return mode._replace(turns=True, pattern=[table.one, _quarter_period_apart(table, mode, M, G, K)])
    return mode


def _quarter_period_apart(table: "Table", mode: "ClosedMode", M: "Mapping[tuple[int, int], Node]", G: Mapping[Any, Any],
                          K: "Mapping[tuple[int, int], Node]") -> "Node":
    """q₂/(i q₁), a number where ω solves a quadratic equation and that makes it one."""
    whole = factored(_entry(table, M, K, 0, 0) / (table.parameter(OMEGA) * G[0, 1]))
    if mode.solves is None:
        return whole
    element = mode.solves.ratio([K.get((0, 0), table.zero), table.zero, -M[0, 0]], [table.zero, G[0, 1]])
    return whole if element is None else element


def _entry(table: "Table", M: "Mapping[tuple[int, int], Node]", K: "Mapping[tuple[int, int], Node]", i: int,
           j: int) -> "Node":
    return K.get((i, j), table.zero) - table.parameter(OMEGA) ** 2 * M.get((i, j), table.zero)
