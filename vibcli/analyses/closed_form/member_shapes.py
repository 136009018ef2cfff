"""Shapes of modes of one uniform member in letters, by its frequency equation, and the roots of that where no letter is
left in it.

    bars, shafts, strings   X = sin βx,  cos βx,  cos βx + Z/(S β) sin βx where Z acts on the left end
    beams                   X = f(βx) − σ g(βx), f and g by the left end, σ by one condition at the right one;
                            under an axial force N with αx in sinh and cosh, a = α/β, Q = EI X‴ − N X′
"""

from collections.abc import Mapping, Sequence
from math import pi
from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.textbook_equation import quotient, sides
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.root_finding import bracketed
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import UNITS
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.symbolic.node import Node

    Sum = Mapping[str, int | Node]          # {name of a function: what stands before it}
    Terms = Sequence[tuple[int | Node, Sum]]

ALONG, SECOND = "βx", "αx"      # products, as notation.names reads them
HYPERBOLIC = "sinh", "cosh"
SLOPE = {"cosh": ("sinh", 1), "sinh": ("cosh", 1), "cos": ("sin", -1), "sin": ("cos", 1)}
# by whether the displacement is held, whether the turn is
LEFT: dict[tuple[bool, bool], tuple[dict[str, int], dict[str, int]]] = {
    (True, True): ({"cosh": 1, "cos": -1}, {"sinh": 1, "sin": -1}), (True, False): ({"sin": 1}, {"sinh": 1}),
    (False, True): ({"cos": 1}, {"cosh": 1}), (False, False): ({"cosh": 1, "cos": 1}, {"sinh": 1, "sin": 1})}
STEP, LEAST, FACTOR = 0.05, 1e-3, 1.15      # of βL, below one step by factors; under 2·STEP rounding leaves few digits


class MemberShape(NamedTuple):
    """X = first − σ second, functions of βx and αx; σ as (above, below), functions of βL; None where X is the first
    alone."""

    first: "Node"
    second: "Node"
    sigma: "tuple[Node, Node] | None"


def shape(found: "FrequencyEquation") -> MemberShape | None:
    """The shape of one uniform member; None of others, and where something couples displacement and turn of its left
    end."""
    if len(found.pieces) > 1 or len(found.standing[0]) > 2:
        return None
    table, left = found.wave_number.table, found.standing[0]
    along = table.parameter(ALONG), table.parameter(SECOND if found.second is not None else ALONG)
    if found.order == 2:
        return MemberShape(_sum(_of_second_order(found, *left), along), table.zero, None)
    one, two = _of_fourth_order(found, *left)
    held = [Z is None for Z in left]
    alone = sides(found)[0].name if found.impedances[1][0] is None or held[0] != held[1] else None
    if alone in ("sin", "cos") and len(one) == len(one[0][1]) == 1:
        return MemberShape(_sum(one, along), table.zero, None)
    at_right = [_at_right(found, terms) for terms in (one, two)]
    ends = found.wave_number, found.second or found.wave_number
    above, below = (_sum(terms, ends) for terms in at_right)
    if found.second is not None or any(len(terms) > 1 for terms in at_right):
        above, below = quotient(single(above) / single(below))
    return MemberShape(_sum(one, along), _sum(two, along), (above, below))


def on_both_sides(found: "FrequencyEquation", place: "Node") -> "list[tuple[Node, Node, Node]]":
    """[(start, end, X)] of a bar, shaft or string that is two pieces, where the place between them moves: each piece as
    its own end holds it, times what the other is there; nothing of others. `place`: x."""
    if len(found.pieces) != 2 or found.order != 2:
        return []
    sides = []
    for placed, argument, (Z,), way in zip(found.pieces, found.arguments, (found.standing[0], found.standing[-1]), (
            1, -1), strict=True):
        piece = placed.piece
        end = textbook(placed.start + piece.length)
        along = textbook(place - placed.start if way > 0 else end - place)
        terms: Terms = [(1, {"sin": 1})] if Z is None else [(1, {"cos": 1})] if Z.is_zero else [(1, {"cos": 1}), (
            textbook(Z * piece.length / (piece.tension * argument)), {"sin": 1})]
        values = [_sum(terms, (at, at)) for at in (textbook(argument * along / piece.length), argument)]
        sides.append((placed.start, end, *values))
    (a, b, left, here), (c, d, right, there) = sides
    return [(a, b, there * left), (c, d, here * right)]


def _by_units(found: "FrequencyEquation", Z: "Node", order: int) -> "Node":
    """Z/(S β) of a force along the one motion or of a moment, Z/(S β³) of a shear force."""
    piece = found.pieces[0].piece
    stiffness = piece.tension if piece.bending.is_zero else piece.bending
    return textbook(Z / (stiffness * (found.wave_number / piece.length) ** order))


def _of_second_order(found: "FrequencyEquation", Z: "Node | None") -> "Terms":
    """S X′(0) = Z X(0)."""
    if Z is None:
        return [(1, {"sin": 1})]
    return [(1, {"cos": 1})] if Z.is_zero else [(1, {"cos": 1}), (_by_units(found, Z, 1), {"sin": 1})]


def _ratio(found: "FrequencyEquation") -> "Node":
    """a = α/β; 1 without an axial force."""
    return found.wave_number.table.one if found.second is None else found.second / found.wave_number


def _of_fourth_order(found: "FrequencyEquation", Z: "Node | None", turn: "Node | None") -> "Sequence[Terms]":
    """Two functions with Q(0) = −Z X(0) or X(0) = 0, and EI X″(0) = Z X′(0) or X′(0) = 0."""
    a = _ratio(found)
    if (Z is None) != (turn is None) and all(one is None or one.is_zero for one in (Z, turn)):
        return [[(1, terms)] for terms in LEFT[Z is None, turn is None]]
    sheared: Sum = {"sinh": 1 / a, "sin": -1}
    bent: Sum = {"cosh": 1, "cos": -1}
    one: Terms = [(1, {name: a * c for name, c in sheared.items()})]
    two: Terms = [(1, bent)]
    if Z is not None:
        shear: Terms = [] if Z.is_zero else [(-_by_units(found, Z, 3), sheared)]
        one = [(1, {"cosh": 1, "cos": a ** 2}), *shear]
    if turn is not None:
        moment: Terms = [] if turn.is_zero else [(_by_units(found, turn, 1), bent)]
        two = [(1, {"sinh": a, "sin": 1}), *moment]
    return (two, one) if Z is turn is None else (one, two)


def _at_right(found: "FrequencyEquation", terms: "Terms") -> "Terms":
    """What vanishes of the shape at the right end: X, X′, X″, Q, or EI X″ + Z X′ + what a coupling adds, Z X."""
    across, turn, *both = found.standing[1]
    a = _ratio(found)
    for order, Z in ((0, across), (1, turn)):
        if Z is None:
            return _derivative(terms, order, a)
    if not both and turn.is_zero:
        return _derivative(terms, 2, a)
    if not both and across.is_zero:
        return _shear(terms, a)
    factor = _by_units(found, turn, 1)
    more = [(size * _by_units(found, both[0], 2), one) for size, one in terms] if both else []
    return [*_derivative(terms, 2, a), *((size * factor, slope) for size, slope in _derivative(terms, 1, a)), *more]


def _derivative(terms: "Terms", order: int, a: "Node") -> "Terms":
    """By βx."""
    for _ in range(order):
        terms = [(size, {SLOPE[name][0]: (a if name in HYPERBOLIC else 1) * SLOPE[name][1] * c
                         for name, c in one.items()}) for size, one in terms]
    return terms


def _shear(terms: "Terms", a: "Node") -> "Terms":
    """Q/(EI β³): a sinh of cosh, a² sin of cos; the third derivative without an axial force."""
    return [(size, {SLOPE[name][0]: (a if name in HYPERBOLIC else -a ** 2) * SLOPE[name][1] * c
                    for name, c in one.items()}) for size, one in terms]


def _sum(terms: "Terms", arguments: "tuple[Node, Node]") -> "Node":
    """Σ factor·(sum of functions), sin and cos of the first argument, sinh and cosh of the second."""
    table = arguments[0].table
    return table.total([size * table.total([table.call(name, arguments[name in HYPERBOLIC]) * c
                                            for name, c in one.items()]) for size, one in terms])


def unstrained(found: "FrequencyEquation") -> int:
    """How many motions with βL = 0 vibrate, ω² = k/μ: those of a member on a foundation that bend or stretch nothing
    and that what acts on its stations leaves alone; under an axial force it turns no more without strain."""
    return 0 if found.pieces[0].piece.foundation.is_zero else rigid_motions(found)


def rigid_motions(found: "FrequencyEquation") -> int:
    """How many motions strain nothing: springs at stations hold as supports do, masses only on a foundation."""
    x = found.wave_number
    held = [sum(Z is None or not substitute([Z], {x: x.table.zero})[0].is_zero for Z in (end[part] for end in (
        found.impedances))) for part in range(found.order // 2)]
    if found.order == 2:
        return int(not held[0])
    across, turning = held
    pulled = found.pieces[0].piece.tension
    return int(not across) if not pulled.is_zero else max(2 - across - min(turning, 1), 0)


def roots(found: "FrequencyEquation", count: int) -> list[float] | None:
    """The first positive βL that fulfil the equation; None where they hang on letters but those of units, or the first
    is so low that rounding leaves few digits. Beside poles of impedances that stand as letters two may hide."""
    x = found.wave_number
    whole = x.table.total(found.terms)
    letters = {node.name for node in reachable(found.by_wave_number(*sides(found))) if node.op == "symbol"}
    if letters - {x.name, *UNITS.values()}:
        return None
    values = {node.name: 1.0 for node in reachable([whole]) if node.op == "symbol"}

    def residual(at: float) -> float:
        found: float = evaluate([whole], Floats, {**values, x.name: at})[0]
        return found

    told, at = [0.0] * unstrained(found), LEAST
    while len(told) < count and at < (count + 2) * pi:
        beyond = at + STEP if at >= STEP else at * FACTOR
        here, there = residual(at), residual(beyond)
        if here * there < 0 and (root := bracketed(residual, at, here, beyond, there)) is not None:    # no pole
            if root < 2 * STEP:
                return None
            told.append(root)
        at = beyond
    return told
