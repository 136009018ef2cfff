"""Expressions that are too long to read."""

from typing import TYPE_CHECKING

from vibcli.report.blocks import Words

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

LONGEST = 2400


def brief(node: "Node", whole: str = "; see --json"):
    """An expression, or words about its size where it is too long to read; `whole`: where all of it stands."""
    from vibcli.notation.plain import plain

    size = len(plain(node))
    return node if size <= LONGEST else Words(f"(an expression of {size} characters{whole})")
