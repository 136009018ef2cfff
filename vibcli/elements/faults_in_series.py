"""What keeps a law from standing in series: there is to be one inner equilibrium, undeformed where no force acts."""

from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import called_functions, reachable

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

RISES = ("parts in series need laws that rise everywhere: sums of odd powers, d*abs(d), sinh(d) with positive factors; "
         "otherwise several inner equilibria may exist")
JUMPS = "sign", "step"
MOST = 30           # powers of a polynomial


class Fault(NamedTuple):
    """What a part does, and a hint."""

    what: str
    hint: str


def not_in_series(force: "Node", x: "Node", scene: Any, rises: bool, unit: str) -> Fault | None:
    """What is wrong with a law as a part in series; `rises`: is it shown to rise? unit: that of x."""
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
    if rises:
        return None
    end = None if called else _falls_beyond(force, x, scene)
    return Fault("is not shown to rise" if end is None else f"falls beyond {end:.6g} {unit}", RISES)


def _falls_beyond(force, x, scene):
    """The least size of x > 0 at which the slope of an odd polynomial vanishes; None of another function."""
    import numpy as np

    coefficients, node = [], force
    while not node.is_zero and len(coefficients) < MOST:
        node = gradient(node).get(x, x.table.zero)
        coefficients.append(scene.number(substitute([node], {x: x.table.zero})[0]))
    if not node.is_zero or any(coefficients[1::2]) or not coefficients or not coefficients[0] > 0:
        return None
    scale = np.cumprod([1.0, *range(1, len(coefficients))])
    roots = np.roots((np.array(coefficients) / scale)[::-1])
    real = [root.real for root in roots if abs(root.imag) <= 1e-9 * abs(root) and root.real > 0]
    return min(real, default=None)
