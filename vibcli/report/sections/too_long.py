"""Expressions that are too long to read."""

from vibcli.report.blocks import Words

LONGEST = 2400


def brief(node):
    """An expression, or words about its size where it is too long to read."""
    from vibcli.notation.plain import plain

    size = len(plain(node))
    return node if size <= LONGEST else Words(f"(an expression of {size} characters; see --json)")
