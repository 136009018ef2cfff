"""What is too long to read: expressions, and lists of very many coordinates."""

from typing import TYPE_CHECKING

from vibcli.report.blocks import Paragraph, Words, paragraph

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

LONGEST = 2400
TALL, TOLD = 200, 40        # coordinates, a row each; else so many of them


def brief(node: "Node", whole: str = "; see --json") -> "Node | Words":
    """An expression, or words about its size where it is too long to read; `whole`: where all of it stands."""
    from vibcli.notation.plain import plain

    size = len(plain(node))
    return node if size <= LONGEST else Words(f"(an expression of {size} characters{whole})")


def places_told(count: int, most: int = TALL, told: int = TOLD) -> list[int]:
    """The numbers of the coordinates that are told of so many: `told` evenly spread ones of more than `most`, both ends
    included."""
    return list(range(count)) if count <= most else [i * (count - 1) // (told - 1) for i in range(told)]


def passed_over(told: int, count: int) -> Paragraph | None:
    """What is said where not all of so many coordinates are told."""
    return paragraph(f"{told} of {count} coordinates, evenly spread; --json tells all") if told < count else None
