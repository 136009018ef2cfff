"""How far the numbers that were searched for may be from the true ones: where the conditions f = L − R are known to e,

    |δx| ≤ |J⁻¹| (|f| + e),   J = ∂f/∂x,

at a zero that f only touches |δx| ≤ √(2 (|f| + e)/|f″|), and what they move is off by |∂y/∂x| |δx|. Slopes are central
differences; of balanced forces and what holds an equilibrium, more conditions than numbers perhaps, each weighs
as much as it is known.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import inf, sqrt
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.quantities.expression import bounded
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.running_errors import UNIT, Rounded, RunningErrors, error_in

if TYPE_CHECKING:
    from vibcli.inverse.conditions import ConditionSystem
    from vibcli.results.problem import Problem

BY = 2.0**-17           # of a number: how far it is moved
SLACK = 2.0             # of what is found to first order
TOUCHES = 2.5           # the same where f may only touch zero
OF_STIFFNESS = 16.0     # roundings of what is left of a stiffness, a term


class Move(NamedTuple):
    """The scene with one of the numbers searched for moved by so much."""

    problem: "Problem"
    by: float


class SearchedNumbers:
    """The numbers of a solution that were searched for, in a ConditionSystem."""

    def __init__(self, system: "ConditionSystem", values: "Sequence[Fraction]"):
        self._system, self._values = system, list(values)
        self._moves: list[list[Move]] | None = None

    def errors(self) -> dict[str, float]:
        """{name: the bound of its error}, infinite where the conditions are met on neither side of it."""
        system, values = self._system, self._values
        rounding = [UNIT * abs(float(x)) for x in values]
        limit = system.limit(values)        # a fold is solved for beyond the digits of floats
        found = [0.0] if limit is not None and limit.fold else _solved(*self._linearised())
        return {name: a + b for name, a, b in zip(system.names, found, rounding, strict=True)}

    def moves(self) -> list[list[Move]]:
        """Of each number the scene with somewhat more of it, and with less, as far as there is such a one."""
        if self._moves is None:
            self._moves = [[move for sense in (1, -1) if (move := self._moved(i, sense)) is not None]
                           for i in range(len(self._values))]
        return self._moves

    def _moved(self, i, sense):
        x = float(self._values[i])
        by = sense * BY * (abs(x) or self._system.ranges[i].scale)
        place = [Fraction(x + by) if k == i else value for k, value in enumerate(self._values)]
        if not self._system.admits(place):
            return None
        try:
            return Move(self._system.instance(place), float(place[i]) - x)
        except (SpecError, PhysicsError, ArithmeticError):
            return None

    def _linearised(self):
        """(what f may be off by where the solution is, its slopes, its bends), a condition a row."""
        import numpy as np

        system = self._system
        instance, pairs = system.substituted(self._values)
        here = np.array(_differences(pairs))
        off = np.abs(here) + _errors(system, instance, pairs)
        slopes, bends = np.full((2, len(here), len(self._values)), np.nan)
        for i, moves in enumerate(self.moves()):
            found = [(move.by, np.array(_differences(system.seen(move.problem))) - here) for move in moves]
            if len(found) == 2:
                (h, up), (_, down) = found
                slopes[:, i], bends[:, i] = (up - down) / (2 * h), (up + down) / h**2
            elif found:
                h, up = found[0]
                slopes[:, i], bends[:, i] = up / h, 0.0
        return off, slopes, bends


def _solved(off: Any, slopes: Any, bends: Any) -> list[float]:
    """The bounds of what is searched, to first order, of one number that f may touch to second."""
    import numpy as np

    if not np.isfinite(slopes).all():
        return [inf] * slopes.shape[1]
    if slopes.shape[1] == 1:
        return [min(_of_one(*row) for row in zip(off.tolist(), slopes[:, 0].tolist(), bends[:, 0].tolist(),
                                                strict=True))]
    weights = 1 / np.maximum(off, np.finfo(float).tiny)
    inverse = np.abs(np.linalg.pinv(slopes * weights[:, None], rcond=UNIT))
    return [SLACK * x for x in inverse.sum(axis=1).tolist()]


def _of_one(off, slope, bend):
    if slope * slope > 4 * abs(bend) * off:
        return SLACK * off / abs(slope)
    return TOUCHES * sqrt(2 * off / abs(bend)) if bend else inf


def _differences(pairs):
    return [left - right for one in pairs for left, right in one]


def _errors(system, instance, pairs):
    """The bounds of L − R of each condition."""
    found: list[float] = []
    for condition, its in zip(system.conditions, pairs, strict=True):
        if condition.is_balance:
            arithmetic = RunningErrors(Floats)
            drawn = {name: Rounded(x, UNIT * abs(x)) for name, x in instance.numeric.drawn_floats.items()}
            place = {**instance.numeric.rounded, instance.scene.time.name: 0.0, **drawn}
            found += [error_in(sum(evaluate(terms, arithmetic, place))) for terms in instance.system.drawn_residual]
        elif condition.word:
            found += [OF_STIFFNESS * UNIT * len(instance.scene.q) * (left + right) for left, right in its]
        else:
            found.append(sum(bounded(instance, side)[1] for side in condition.sides))
    return found
