"""What vanishes at the turning places l < r and the period T of a free motion of one degree of freedom in which a
signal s has the amplitude A,

    V(l) = V(r),   |s(a) − s(b)| = 2A,   T = 2 ∫ dq/√(2 (V(r) − V(q))/M(q)),

a and b being two of l, r and the place of rest; the integral by the midpoint rule in θ of
q = (l + r)/2 + (r − l)/2 sin θ, which is Gauss's for the weight 1/√((q − l)(r − q)).
"""

from contextlib import suppress
from itertools import permutations
from math import cos, pi, sin
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.results.motion_signals import node_of
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

POINTS = 32
CLOSE = 1e-9        # relative: of twice an amplitude


class TurningPlaces(NamedTuple):
    """Symbols of the places where a motion turns and of its period, with their numbers."""

    left: "tuple[Node, float]"
    right: "tuple[Node, float]"
    period: "tuple[Node, float]"


def vanishing(problem: "Problem", tree: "QuantityRef", turning: TurningPlaces, V: "Node", M: "Node"
              ) -> "list[Node] | None":
    """What vanishes at l, r and T, to be found together; None where the ends of the signal are at other places."""
    q, (left, right, period) = problem.free_motions.scene.q[0], (symbol for symbol, _ in turning)
    of_signal = _range(problem, tree, turning)
    if of_signal is None:
        return None
    table, middle, half, total = q.table, (left + right) / 2, (right - left) / 2, []
    low, high = (substitute([V], {q: end})[0] for end in (left, right))
    for j in range(POINTS):
        theta = (j + 0.5) * pi / POINTS - pi / 2
        aside, along = (table.number(fraction_of(x)) for x in (sin(theta), 2 * pi / POINTS * cos(theta)))
        at, inertia = substitute([V, M], {q: middle + half * aside})
        energy = (low + high + aside * (high - low)) / 2        # so that no root is negative on the way to the ends
        total.append(along * half / table.sqrt(2 * (energy - at) / inertia))
    return [high - low, of_signal, period - table.total(total)]


def _range(problem: "Problem", tree: "QuantityRef", turning: TurningPlaces) -> "Node | None":
    """s(a) − s(b) − 2A."""
    signal, amplitude = (node_of(problem, arg) for arg in tree.args)
    q = problem.free_motions.scene.q[0]
    places = {turning.left[0]: turning.left[1], turning.right[0]: turning.right[1]}
    with suppress(PhysicsError):
        rest = problem.symbolic.equilibrium_position[q.name]
        places[rest] = evaluate([rest], Floats, problem.numeric.floats)[0]
    floats = problem.numeric.floats
    twice = 2 * evaluate([amplitude], Floats, floats)[0]
    for a, b in permutations(places, 2):
        high, low = (evaluate([signal], Floats, {**floats, q.name: places[place]})[0] for place in (a, b))
        if abs(high - low - twice) <= CLOSE * twice:
            return substitute([signal], {q: a})[0] - substitute([signal], {q: b})[0] - 2 * amplitude
    return None
