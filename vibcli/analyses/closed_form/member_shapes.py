"""Shapes of modes of one uniform member in letters, by its frequency equation, and the roots of that where no letter is
left in it.

    bars, shafts, strings   X = sin βx,  cos βx
    beams                   X = f(βx) − σ g(βx), f and g by the left end, σ by one condition at the right one
"""

from collections.abc import Mapping
from math import pi
from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.textbook_equation import sides
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.root_finding import bracketed
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.symbolic.node import Node

ALONG = "βx"            # of notation.PRODUCTS
SLOPE = {"cosh": ("sinh", 1), "sinh": ("cosh", 1), "cos": ("sin", -1), "sin": ("cos", 1)}
LEFT = {(True, True): ({"cosh": 1, "cos": -1}, {"sinh": 1, "sin": -1}), (True, False): ({"sin": 1}, {"sinh": 1}),
        (False, True): ({"cos": 1}, {"cosh": 1}), (False, False): ({"cosh": 1, "cos": 1}, {"sinh": 1, "sin": 1})}
STEP = 0.05


class MemberShape(NamedTuple):
    """X = first − σ second, functions of βx; σ as (above, below), functions of βL; None where X is the first alone."""

    first: "Node"
    second: "Node"
    sigma: "tuple[Node, Node] | None"


def shape(found: "FrequencyEquation") -> MemberShape | None:
    """The shape of one uniform member whose left end is held or free; None of others."""
    if len(found.pieces) > 1 or any(Z is not None and not Z.is_zero for Z in found.impedances[0]):
        return None
    table = found.wave_number.table
    along = table.parameter(ALONG)
    ends = found.impedances[0]
    left = ends[0] is None, ends[-1] is None
    if found.order == 2:
        return MemberShape(table.call("sin" if left[0] else "cos", along), table.zero, None)
    one, two = LEFT[left]
    alone = sides(found)[0].name if found.impedances[1][0] is None or left[0] != left[1] else None
    if alone in ("sin", "cos") and len(one) == 1:
        return MemberShape(_sum(one, along), table.zero, None)
    order = _right_condition(found.impedances[1])
    if order is None:
        return None
    sigma = tuple(_sum(_derivative(terms, order), found.wave_number) for terms in (one, two))
    return MemberShape(_sum(one, along), _sum(two, along), sigma)


def _right_condition(impedance):
    """The derivative of u that vanishes at the right end; None where none does."""
    displacement, turn = impedance
    if displacement is None:
        return 0
    if turn is None:
        return 1
    return 2 if turn.is_zero else 3 if displacement.is_zero else None


def _derivative(terms: "Mapping[str, int]", order):
    for _ in range(order):
        terms = {SLOPE[name][0]: sign * SLOPE[name][1] for name, sign in terms.items()}
    return terms


def _sum(terms, argument):
    table = argument.table
    return table.sum(*((table.call(name, argument), sign) for name, sign in terms.items()))


def unstrained(found: "FrequencyEquation") -> int:
    """How many motions with βL = 0 vibrate, ω² = k/μ: those of a bare member on a foundation that its ends let go."""
    ends = found.impedances
    if found.pieces[0].piece.foundation.is_zero or any(Z is not None and not Z.is_zero for end in ends for Z in end):
        return 0
    held = [sum(end[part] is None for end in ends) for part in range(found.order // 2)]
    if found.order == 2:
        return int(not held[0])
    across, turning = held
    return max(2 - across - min(turning, 1), 0)


def roots(found: "FrequencyEquation", count: int) -> list[float] | None:
    """The first positive βL that fulfil the equation; None where they hang on letters."""
    x, table = found.wave_number, found.wave_number.table
    letters = {node.name for side in sides(found) for node in reachable([side]) if node.op == "symbol"}
    if letters - {x.name}:
        return None
    names = {node.name for term in found.function.values() for node in reachable([term]) if node.op == "symbol"}
    values = dict.fromkeys(names | {x.name}, 1.0)
    whole = table.total([
        coefficient * table.product(*((table.call(name, found.arguments[i]), 1)
                                      for i, *called in functions for name in called))
        for functions, coefficient in found.function.items()])

    def residual(at: float) -> float:
        return evaluate([whole], Floats, {**values, x.name: at})[0]

    told, at = [0.0] * unstrained(found), STEP
    while len(told) < count and at < (count + 2) * pi:
        here, there = residual(at), residual(at + STEP)
        if here * there < 0:
            told.append(bracketed(residual, at, here, at + STEP, there))
        at += STEP
    return told
