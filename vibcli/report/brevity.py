"""Expressions that are too long to read."""

from vibcli.report.notation import plain

LONGEST = 2400


def short(node):
    """An expression as text, or its size where it is too long to read."""
    text = plain(node)
    return text if len(text) <= LONGEST else f"(an expression of {len(text)} characters; see --json)"
