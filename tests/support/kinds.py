"""What the formats of a report tell apart in a document: what stands in what, and of which form it is."""

from collections.abc import Iterator
from string import ascii_letters, digits
from typing import Any

from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import Node

LETTERS = str.maketrans({**dict.fromkeys(ascii_letters, "a"), **dict.fromkeys(digits, "0")})


def kinds(part: Any, within: str = "") -> Iterator[tuple]:
    """Of blocks, mathematics, syntax and nodes the kind, with that of what they stand in, and how large formulas are
    (in powers of two); of texts the characters, all Latin letters being one, and all digits; of numbers the sign."""
    if isinstance(part, str):
        yield from ((within, "text", one) for one in set(part.translate(LETTERS)))
    elif isinstance(part, Node):
        nodes = reachable([part])
        yield within, "node", part.op, len(nodes).bit_length()
        for node in nodes:
            yield from _of_node(node)
    elif isinstance(part, dict):
        yield from kinds((*part, *part.values()), within)
    elif isinstance(part, tuple | list):
        own = within if part.__class__ in (tuple, list) else part.__class__.__name__
        yield within, own, len(part).bit_length()
        for one in part:
            yield from kinds(one, own)
    else:
        yield within, *_of_number(part)


def _of_node(node):
    if node.op == "call":       # `spring.energy` is written as that of another element
        yield node.op, node.name.rpartition(".")[2]
    else:
        yield node.op, *_of_number(node.coefficient)
    if node.op == "symbol":
        yield from kinds(node.name, node.op)
    for arg in node.args:
        one, number = arg if isinstance(arg, tuple) else (arg, 1)
        yield node.op, one.op, *_of_number(number)


def _of_number(number):
    if isinstance(number, bool) or not hasattr(number, "denominator"):
        return number.__class__.__name__, number if isinstance(number, bool) else None
    return (number > 0) - (number < 0), abs(number) == 1, number.denominator == 1, number.denominator == 2
