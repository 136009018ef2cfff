"""What keeps a law from standing in series: its force is to be continuous, and undeformed it is to rest."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import called_functions, reachable

if TYPE_CHECKING:
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

JUMPS = "sign", "step"


class Fault(NamedTuple):
    """What a part does, and a hint."""

    what: str
    hint: str


def not_in_series(force: "Node", x: "Node", scene: "Builder") -> Fault | None:
    """What is wrong with a law as a part in series."""
    sides = [part for part in reachable([force]) if part.op == "call" and part.name in JUMPS and part.mask & x.mask]
    one_side = {part: part.table.one for part in sides}
    if any(part.args[0] is not x for part in sides) or scene.number(
            substitute(substitute([force], one_side), {x: x.table.zero})[0]):
        if sides:
            return Fault("jumps", "inner equilibria are found of parts whose force is continuous: put a body between")
        return Fault("begins with a force at zero deflection", "its law counts from where it is undeformed")
    called = called_functions([force])
    if any(function.ends for function in called):
        return Fault("ends where its table ends", "parts in series share every force: let it go on with beyond: linear")
    slope = gradient(force).get(x, x.table.zero)
    if scene.number(substitute([slope], {x: x.table.zero})[0]) < 0:
        return Fault("falls from rest", "undeformed a part is to be stable: its force rises with its deflection")
    return None
