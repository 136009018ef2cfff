"""A linear spring in series with one of k d + g d³, or with one of g d³, in closed form: where the whole is deflected
by D, the second one is by the real root d of

    (k₁ + k) d + g d³ = k₁ D        F = k d + g d³

(Kovacić & Radomirović 2018, 9.3).
"""

from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.functions_of_series import Force
from vibcli.symbolic.power_law import cubic_root, odd_powers
from vibcli.symbolic.transfer_between_tables import written_in

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def in_closed_form(force: "Node") -> "Node":
    """An expression in which the forces of such pairs are written out."""
    functions = force.table.functions
    calls = {part: _cubic(part, function) for part in reachable([force])
             if part.op == "call" and isinstance(function := functions.get(part.name), Force)}
    return substitute([force], {part: found for part, found in calls.items() if found is not None})[0]


def _cubic(call: "Node", function: Force) -> "Node | None":
    """The force of a pair; None of other parts in series."""
    parts = function.parts
    powers = [odd_powers(law, d) for law, d in zip(parts.forces, parts.d, strict=True)]
    if len(powers) != 2 or None in powers:
        return None
    linear, cubic = sorted(powers, key=max)
    if set(linear) != {1} or set(cubic) not in ({3}, {1, 3}):
        return None
    own = dict(zip([p.name for p in parts.p], call.args[1:], strict=True))
    stiff, k, g = written_in(call.table, [linear[1], cubic.get(1, parts.table.zero), cubic[3]], own)
    d = cubic_root(stiff * call.args[0] / (stiff + k), g / (stiff + k))
    return k * d + g * d**3
