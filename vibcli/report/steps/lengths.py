"""Lengths under roots and turns of legs with letters of their own, told before the lines in which they come again."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.notation.abbreviations import abbreviated
from vibcli.report.blocks import Words
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

READ = 40       # letters of an expression, up to which it is read as it stands


def with_lengths(sheet: WorkedSolution, nodes: "Sequence[Node]") -> "list[Node]":
    """The expressions, long ones with ℓ₁ for √(…) and β₁ for atan2(…) of what moves."""
    return [_shorter(sheet, node) if letters(node) > READ else node for node in nodes]


def _shorter(sheet: WorkedSolution, node: "Node") -> "Node":
    (shown,), told = abbreviated([node], sheet.lengths, fixed=True)
    turns = [call for call in reachable([shown]) if call.op == "call" and call.name == "atan2" and call.mask]
    for symbol, length in told:
        sheet.write(Words("length  "), symbol, " = ", length, settles=symbol.name, node=length)
    for call in turns:
        if call not in sheet.turns:
            sheet.turns[call] = symbol = call.table.variable(sheet.letter(f"beta{len(sheet.turns) + 1}"))
            legs, _ = abbreviated(call.args, sheet.lengths, fixed=True)
            sheet.write(Words("turn  "), symbol, " = ", call.table.call("atan2", *legs), settles=symbol.name, node=call)
    return substitute([shown], {call: sheet.turns[call] for call in turns})[0] if turns else shown
