"""The period of a free motion of one coordinate that loses no energy, by a quadrature between its turning points:

    T = 2 ∫ dq √(M(q) / 2 E(q)),     E(q) = ½ M q̇² there = −∫ h dq from a turning point on,     M q̈ = −h(q) − ½ M′ q̇².

Forces may bend or jump: each panel ends where one does, those from turning points run over the square root of the way.
Nothing is followed in time.
"""

from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.motion import Motion
from vibcli.evidence.reference.periodic import rule
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

BENT = ("abs", "min", "max", "ramp", "sign", "step")
DIGITS, START, GROWTH, LIMIT = 30, 40, 1.4, 160
STEPS, FAR = 400, 100_000       # of the size of a motion, and at most
SPEEDS = (0.4, 1.7)     # at which energy is looked at, of that size
PLACES = 1.2            # of a quadrature, for each digit


class SwingingCoordinate:
    """The M and h of a Motion of one coordinate as functions of its place, at the working precision; bends: what
    vanishes where they bend or jump."""

    def __init__(self, motion: Motion) -> None:
        self.motion, scene = motion, motion.scene
        (self.inertia,), (force,) = motion.parts.M.values(), motion.parts.h
        (q,), (v,) = scene.q, scene.v
        self.names = q.name, v.name
        self.force, = substitute([force], {v: scene.table.zero})
        self.lost = force - self.force - gradient(self.inertia).get(q, scene.table.zero) * v * v * HALF
        self.bends = [bend for part in reachable([self.force, self.inertia])
                      if part.op == "call" and part.name in BENT and part.mask for bend in _bends(part)]

    def at(self, node: "Node", q: Any, speed: Any = 0) -> Any:
        """An expression at a place."""
        place = dict(zip(self.names, (q, mpmath.mpf(speed)), strict=True))
        return evaluate([node], _arithmetic(mpmath.mp.prec), {**self.motion.values(mpmath.mp.prec), **place})[0]

    def near(self, nodes: "list[Node]", q: float) -> list[float]:
        """Expressions at a place in floats."""
        return evaluate(nodes, Floats, {**self.motion.floats, **dict(zip(self.names, (q, 0.0), strict=True))})

    def start(self) -> tuple[Any, Any]:
        """(q, ½ M q̇²) at t = 0."""
        bits = mpmath.mp.prec
        q, v = (mpmath.ldexp(x, -bits) for x in self.motion.start(bits))
        return q, self.at(self.inertia, q) * v * v / 2

    def work(self, a: Any, b: Any) -> Any:
        """∫ h dq from one place to another, between which nothing bends."""
        return (b - a) * mpmath.fsum(w * self.at(self.force, a + (b - a) * x) for x, w in _places())

    def time(self, a: Any, b: Any, E: Any) -> Any:
        """From one place to another, with the energy of motion E at the first."""
        return abs(b - a) * mpmath.fsum(w * mpmath.sqrt(self.at(self.inertia, x) / (2 * (E - self.work(a, x))))
                                        for x, w in ((a + (b - a) * x, w) for x, w in _places()))

    def time_from(self, turn: Any, b: Any) -> Any:
        """From where it turns to a place: of q = turn + L u², E = −L u² times the mean of h on the way there."""
        L = b - turn
        return mpmath.fsum(w * mpmath.sqrt(-2 * self.at(self.inertia, x) * L * (x - turn) / self.work(turn, x))
                           for x, w in ((turn + L * u * u, w) for u, w in _places()))


@cache
def _arithmetic(_: int) -> Any:
    """That of a precision."""
    return multiprecision()


def _places() -> Any:
    return rule(int(PLACES * mpmath.mp.dps), 2 * mpmath.mp.prec)


def _bends(part: "Node") -> "list[Node]":
    """What vanishes where a call bends or jumps."""
    return [part.args[0] - other for other in part.args[1:]] or [part.args[0]]


def period(motion: Motion, size: float) -> TrueValues:
    """Of a free motion of one coordinate, about so large; PhysicsError where it loses energy or does not come back."""
    one = SwingingCoordinate(motion)
    with mpmath.workdps(START):
        q, E = one.start()
        for part in SPEEDS:
            place, speed = q + part * size, part * size
            if abs(one.at(one.lost, place, speed)) > mpmath.mpf(10) ** (10 - START) * (
                    abs(one.at(one.force, place)) + abs(speed)):
                raise PhysicsError("no reference is found of periods of motions that lose energy")
    senses = (-1, 1) if E else (1 if one.near([one.force], float(q))[0] < 0 else -1,)
    ways = [_way(one, float(q), float(E), sense * size / STEPS) for sense in senses]

    def found() -> "tuple[list[Any], Any]":
        T = 2 * _between(one, [_followed(one, *way) for way in ways])
        return [T], T

    return settled(found, DIGITS, START, LIMIT, GROWTH, sized=True)


def _way(one: SwingingCoordinate, q: float, E: float, step: float) -> Any:
    """(between which places it turns, [between which places what bends]) of a motion that sets out from q in one sense
    with the energy of motion E."""
    nodes, bends = [one.force, *one.bends], []
    before = one.near(nodes, q)
    for _ in range(FAR):
        after = one.near(nodes, q + step)
        bends += [(q, q + step, bend) for bend, x, y in zip(one.bends, before[1:], after[1:], strict=True)
                  if x * y < 0 or (x and not y)]
        E -= one.near(nodes[:1], q + step / 2)[0] * step
        if E <= 0:
            return (q, q + step), bends
        q, before = q + step, after
    raise PhysicsError("the reference finds that this motion does not come back to where it was")


def _followed(one: SwingingCoordinate, turns: Any, bends: Any) -> Any:
    """(where it turns, [(a place where a force bends, its energy of motion there)] up to there, from the start on)."""
    q, E = one.start()
    found, small = [], mpmath.mpf(10) ** (5 - mpmath.mp.dps) * abs(turns[1] - q)
    for place in sorted((_bend(one, *bend) for bend in bends), key=lambda x: abs(x - q)):
        left = E - one.work(q, place)
        if left <= 0:
            break
        if abs(place - q) > small:
            found.append((place, left))
            q, E = place, left
    low = mpmath.mpf(turns[0]) if E or found else (mpmath.mpf(turns[0]) + turns[1]) / 2
    return _root(lambda x: E - one.work(q, x), low, 2 * mpmath.mpf(turns[1]) - turns[0]), found


def _between(one: SwingingCoordinate, ways: Any) -> Any:
    """The time between two turning points, the first of which is the start where it starts at rest."""
    if len(ways) == 1:
        ways = [(one.start()[0], []), *ways]
    (first, before), (last, after) = ways
    places = [*before[::-1], *after]
    if not places:
        middle = (first + last) / 2
        return one.time_from(first, middle) + one.time_from(last, middle)
    return one.time_from(first, places[0][0]) + one.time_from(last, places[-1][0]) + mpmath.fsum(
        one.time(a, b, E) for (a, E), (b, _) in pairwise(places))


def _bend(one: SwingingCoordinate, low: float, high: float, node: "Node") -> Any:
    return _root(lambda x: one.at(node, x), low, high)


def _root(function: Callable[[Any], Any], low: float, high: float) -> Any:
    return mpmath.findroot(function, (mpmath.mpf(low), mpmath.mpf(high)), solver="anderson", verify=False)
