"""The order in which the terms of a sum and the factors of a product are written."""

import sys
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from vibcli.notation.radicals import is_constant
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import first_variable, is_measure, is_number
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from collections.abc import Sequence
    from fractions import Fraction

    from vibcli.symbolic.node import Node

LAST = sys.maxsize, 0       # behind all letters
ODD = "sin", "tan", "sinh", "tanh", "asin", "atan"


def positive_first(pieces: list[tuple[bool, str]], rooted: int) -> list[tuple[bool, str]]:
    """The terms of a sum, (negative, text), the positive ones first; the `rooted` last ones stay there if others can
    begin."""
    front = pieces[:len(pieces) - rooted]
    if rooted and not all(negative for negative, _ in front):
        return sorted(front, key=itemgetter(0)) + pieces[len(pieces) - rooted:]
    return sorted(pieces, key=itemgetter(0))


def is_rooted(node: "Node") -> bool:
    """Does a term of parameters hold the root of a letter or of a sum?"""
    return not node.mask and node.op == "product" and any(
        e.denominator == 2 and not is_constant(base) for base, e in node.args)


def term_rank(pair: "tuple[Node, Fraction | int]") -> "tuple[int | list[tuple[int, Fraction | int]], ...]":
    """Accelerations first, then velocities, then coordinates, each in the order of the coordinates; constants last."""
    node = pair[0]
    deepest = _most_primes(node)
    moving = min((base.index for base in _symbols(node) if base.mask and primes(base) == deepest), default=None)
    return -deepest, not node.mask, moving if deepest else first_variable(node.mask), *_letters(node), node.index


def _letters(node: "Node") -> "tuple[bool, list[tuple[int, int | Fraction]]]":
    """Of terms of parameters those without a root first, then in the order of letters, higher powers first; numbers
    with units last."""
    if node.mask:
        return False, []
    factors = node.args if node.op == "product" else ((node, ONE),)
    return is_rooted(node), sorted((_first_letter(base), -e) for base, e in factors if not is_measure(base)) or [LAST]


def _first_letter(node: "Node") -> int:
    return node.index if node.op == "symbol" else min(
        (part.index for part in reachable([node]) if part.op == "symbol"), default=node.index)


def primes(symbol: "Node") -> int:
    """1 for x', 2 for x''."""
    return len(symbol.name) - len(symbol.name.rstrip("'"))


def _symbols(node: "Node") -> "list[Node]":
    factors = [base for base, _ in node.args] if node.op == "product" else [node]
    return [base for base in factors if base.op == "symbol"]


def _most_primes(node: "Node") -> int:
    return max(map(primes, _symbols(node)), default=0)


def factor_rank(pair: "tuple[Node, Fraction | int]") -> tuple[int, int]:
    """Numbers, parameters, brackets, coordinates, then functions, so that no argument seems to go on: y·sin φ;
    velocities and accelerations last."""
    base = pair[0]
    if is_number(base) or (base.op == "sum" and is_constant(base)):
        kind = -1 if base.op != "sum" else 0
    elif base.op in ("symbol", "pi") and not base.mask:
        kind = 1
    elif base.op in ("sum", "call"):
        kind = 2 if base.op == "sum" else 4
    else:
        deepest = _most_primes(base)
        kind = 4 + deepest if deepest else 3
    return kind, base.index


def upright(value: Any, node: "Node", alone: bool = False) -> "tuple[Any, Sequence[tuple[Node, Fraction | int]]]":
    """(value, factors) of value times a node, in which −(−a − b)·c is (a + b)·c; of what moves and what stands `alone`,
    in which −k·(h − x) is k·(x − h), −(b·k − a·c)·x is (a·c − b·k)·x and −sin(b − t) is sin(t − b)."""
    args = node.args if node.op == "product" else ((node, ONE),)
    turned = [exponent in (1, -1) and _all_negative(base) for base, exponent in args]
    args = [(-base if turn else base, exponent) for turn, (base, exponent) in zip(turned, args, strict=True)]
    value *= (-1) ** sum(turned)
    if not (node.mask or alone) or (value > 0 and sum(base.op in ("sum", "call") for base, _ in args) < 2):
        return value, args
    args = sorted(args, key=factor_rank)
    better = {i: opposite for i, (base, exponent) in enumerate(args) if exponent == 1
              for opposite in [_opposite(base)] if opposite is not None}
    for i in list(better)[:len(better) - (len(better) % 2 == (value > 0))]:     # so many that a plus is left
        args[i], value = (better[i], ONE), -value
    return value, args


def _opposite(base: "Node") -> "Node | None":
    """The negative of a factor that reads better, of a sum and of an odd function of one; None of others."""
    if base.op == "call" and base.name in ODD:
        arg, = base.args
        return base.table.written(base.name, -arg) if any(map(_turns, _factors(arg))) else None
    return -base if _turns(base) else None


def _factors(node: "Node") -> "list[Node]":
    return [base for base, exponent in node.args if exponent == 1] if node.op == "product" else [node]


def _turns(node: "Node") -> bool:
    """Is it a sum with as many minus as plus that is a − x, or b·k − a·c of products of letters? R − r, which has one
    sign, 1 − x and R − a·cos φ are none."""
    if node.op != "sum" or node.coefficient or node.table.squares_at_sample or is_difference(node):
        return False
    signs = [(c * (part.coefficient if part.op == "product" else 1) > 0, part)
             for part, c in sorted(node.args, key=term_rank)]
    if 2 * sum(positive for positive, _ in signs) > len(signs):
        return False
    first = signs[0][1]
    return not (signs[0][0] or any(base.op == "call" and base.name == "cos" for base in _factors(first))
                ) if node.mask else any(part.op == "product" for _, part in signs)


def _all_negative(node: "Node") -> bool:
    """Is it a sum of negative terms alone?"""
    return node.op == "sum" and node.coefficient <= 0 and all(
        c * (part.coefficient if part.op == "product" else 1) < 0 for part, c in node.args)


def is_difference(total: "Node") -> bool:
    """Is a sum that of two letters, which has one sign by the values of its table: (R − r)² beside R − r?"""
    if len(total.args) != 2 or total.coefficient or total.mask or total.table.sample is None:
        return False
    return all(node.op == "symbol" for node, _ in total.args) and {c for _, c in total.args} == {1, -1}
