"""Sines and cosines of sums in those of one angle: sin(2φ − α) by the addition theorems."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

MOST = 6        # multiples of the angle that are opened


def opened(nodes: "Sequence[Node]", angle: "Node") -> "list[Node]":
    """The nodes with sin and cos of c·angle + rest, c whole, in sin(angle) and cos(angle)."""
    known = openings(nodes, angle)
    return substitute(nodes, known) if known else list(nodes)


def openings(nodes: "Sequence[Node]", angle: "Node") -> dict[Any, Any]:
    """{sin or cos of c·angle + rest below the nodes: the same in sin(angle) and cos(angle)}."""
    calls = [part for part in reachable(nodes) if part.op == "call" and part.name in ("sin", "cos")
             and part.args[0] is not angle and part.mask & angle.mask]
    known = {}
    for call in calls:
        split = _split(call.args[0], angle)
        if split is not None:
            sine, cosine = _combined(*split, angle)
            known[call] = sine if call.name == "sin" else cosine
    return known


def _split(argument: "Node", angle: "Node") -> "tuple[int, Node] | None":
    """(c, rest) of c·angle + rest, None where it has another form."""
    table = angle.table
    if argument.op == "product" and argument.args == ((angle, 1),):
        times, rest = argument.coefficient, table.zero
    elif argument.op == "sum":
        times = dict(argument.args).get(angle, 0)
        rest = argument - times * angle
    else:
        return None
    whole = times.denominator == 1 and 0 < abs(times) <= MOST
    return (int(times), rest) if whole and not rest.mask & angle.mask else None


def _combined(times: int, rest: "Node", angle: "Node") -> "tuple[Node, Node]":
    """(sin, cos) of times·angle + rest."""
    table = angle.table
    turn = table.call("sin", angle), table.call("cos", angle)
    if times < 0:
        turn = -turn[0], turn[1]
    sine, cosine = table.call("sin", rest), table.call("cos", rest)
    for _ in range(abs(times)):
        sine, cosine = sine * turn[1] + cosine * turn[0], cosine * turn[1] - sine * turn[0]
    return sine, cosine
