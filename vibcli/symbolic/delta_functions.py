"""Factors of an impulse, which count at its instant alone: f(t) δ(t − a) = f(a) δ(t − a), nothing where f(a) = 0; and
of its rate f(t) δ′(t − a) = f(a) δ′(t − a) − f′(a) δ(t − a).
"""

from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import TooLong, expanded, is_zero
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def at_impulses(node: "Node", time: "Node") -> "Node":
    """The node with what multiplies its impulses taken at their instants; as it is where it is too long for that."""
    table = node.table
    try:
        terms = expanded(node)
    except (TooLong, ZeroDivisionError):
        return node
    kept, blows = [], {}
    for monomial, value in terms.items():
        blow = next((atom for atom, power in monomial if power == 1 and _is_impulse(atom)), None)
        place = None if blow is None else _place(blow.args[0], time)
        rest = table.product(*((atom, power) for atom, power in monomial if atom is not blow))
        if place is None:
            kept.append((rest if blow is None else rest * blow, value))
            continue
        for one, factor in _taken(rest, blow, time, *place):
            blows.setdefault(one, []).append((factor, value))
    for blow, factors in blows.items():
        factor = table.sum(*factors)
        if not is_zero(factor):
            kept.append((factor * blow, ONE))
    return table.sum(*kept)


def _is_impulse(atom: "Node") -> bool:
    """δ or δ′?"""
    return atom.op == "call" and atom.name == "impulse" and (len(atom.args) == 1 or atom.args[1].coefficient == 1)


def _taken(rest: "Node", blow: "Node", time: "Node", slope: "Node", instant: "Node") -> "list[tuple[Node, Node]]":
    """[(impulse, factor)] of rest·blow with the rest at the instant of the blow."""
    at = {time: instant}
    value, = substitute([rest], at)
    if len(blow.args) == 1:
        return [(blow, value)]
    rate, = substitute([gradient(rest).get(time, rest.table.zero)], at)
    return [(blow, value), (rest.table.call("impulse", blow.args[0]), rest.table.scaled(rate / slope, -ONE))]


def _place(argument: "Node", time: "Node") -> "tuple[Node, Node] | None":
    """(slope, time at which it vanishes) of a linear function of the time; None of others."""
    slope = gradient(argument).get(time)
    if slope is None or slope.mask or argument.mask != time.mask:
        return None
    start = substitute([argument], {time: argument.table.zero})[0]
    return slope, argument.table.product((start, ONE), (slope, -ONE)) * -1
