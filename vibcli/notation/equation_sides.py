"""The two sides of an equation as a textbook writes it: what depends on the time alone stands on the right."""

from typing import TYPE_CHECKING, Any

from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.notation.plain import Notation
    from vibcli.symbolic.node import Node


def sides(scene: Any, node: "Node") -> "tuple[Node, Node]":
    """(left, right) of node = 0."""
    time = scene.time.mask
    if node.op != "sum" or not node.mask & time:
        return node, scene.table.zero
    driving = [(part, -c) for part, c in node.args if part.mask & time and not part.mask & ~time]
    if len(driving) == len(node.args):
        return node, scene.table.zero
    right = scene.table.sum(*driving)
    return scene.table.sum((node, ONE), (right, ONE)), right


def equation(scene: Any, node: "Node", write: "Notation") -> str:
    """node = 0 as text."""
    left, right = sides(scene, node)
    return f"{write(left)} = {write(right)}"
