"""How far the numbers that were searched for may be from the true ones: where the conditions f = L − R are known to e,

    |δx| ≤ |J⁻¹| (|f| + e),   J = ∂f/∂x,

at a zero that f only touches |δx| ≤ √(2 (|f| + e)/|f″|), and what they move is off by |∂y/∂x| |δx|. Slopes are central
differences; of balanced forces and what holds an equilibrium, more conditions than numbers perhaps, each weighs
as much as it is known.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import islice
from math import inf, sqrt
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.quantities.expression import bounded
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.running_errors import UNIT, Rounded, RunningErrors, error_in

if TYPE_CHECKING:
    import numpy as np

    from vibcli.inverse.conditions import ConditionSystem
    from vibcli.results.problem import Problem

BY = 2.0**-17           # of a number: how far it is moved
SIZES = (1.0, -1.0, 0.5, -0.5)
SMALL = 2.0**-26        # of what is usual: a number that may be 0 is moved as one so large at least
SLACK = 2.0             # of what is found to first order
TOUCHES = 2.5           # the same where f may only touch zero
OF_STIFFNESS = 16.0     # roundings of what is left of a stiffness, a term


class Move(NamedTuple):
    """The scene with one of the numbers searched for moved by so much, L − R of each condition there, and their
    bounds."""

    problem: "Problem"
    by: float
    differences: Any
    errors: Any


class SearchedNumbers:
    """The numbers of a solution that were searched for, in a ConditionSystem."""

    def __init__(self, system: "ConditionSystem", values: "Sequence[Fraction]") -> None:
        self._system, self._values = system, list(values)
        self._moves: list[list[Move]] | None = None

    def errors(self) -> dict[str, float]:
        """{name: the bound of its error}, infinite where the scene has no such answers beside it."""
        system, values = self._system, self._values
        rounding = [UNIT * abs(float(x)) for x in values]
        limit = system.limit(values)        # a fold is solved for beyond the digits of floats
        found = [0.0] if limit is not None and limit.fold else _solved(*self._linearised())
        return {name: a + b for name, a, b in zip(system.names, found, rounding, strict=True)}

    def moves(self) -> list[list[Move]]:
        """Of each number the scenes with somewhat more of it and with less, or both more or less where there is nothing
        on the other side."""
        if self._moves is None:
            self._moves = [list(islice(filter(None, (self._moved(i, size) for size in SIZES)), 2))
                           for i in range(len(self._values))]
        return self._moves

    def _moved(self, i: int, size: float) -> Move | None:
        import numpy as np

        x, span = float(self._values[i]), self._system.ranges[i]
        usual = max(abs(x), SMALL * span.scale) if span.low < 0 < span.high else abs(x)
        by = size * BY * (usual or span.scale)
        place = [Fraction(x + by) if k == i else value for k, value in enumerate(self._values)]
        if not self._system.admits(place):
            return None
        try:
            instance = self._system.instance(place)
            return Move(instance, float(place[i]) - x, *_known(self._system, instance, self._system.seen(instance)))
        except (SpecError, PhysicsError, ArithmeticError, np.linalg.LinAlgError):
            return None

    def _linearised(self) -> "tuple[np.ndarray, np.ndarray, np.ndarray]":
        """(what f may be off by where the solution is, its slopes, its bends), a condition a row."""
        import numpy as np

        here, errors = _known(self._system, *self._system.substituted(self._values))
        slopes, bends = np.full((2, len(here), len(self._values)), np.nan)
        for i, moves in enumerate(self.moves()):
            if len(moves) == 2:
                (_, h, *one), (_, k, *other) = moves
                up, down = (one[0] - here) / h, (other[0] - here) / k
                slopes[:, i], bends[:, i] = (up * k - down * h) / (k - h), 2 * (down - up) / (k - h)
            errors = np.max([errors, *(move.errors for move in moves)], axis=0)
        return np.abs(here) + errors, slopes, bends


def _solved(off: Any, slopes: Any, bends: Any) -> list[float]:
    """The bounds of what is searched, to first order, of one number that f may touch to second."""
    import numpy as np

    if not np.isfinite(slopes).all():
        return [inf] * slopes.shape[1]
    if slopes.shape[1] == 1:
        return [min(_of_one(*row) for row in zip(off.tolist(), slopes[:, 0].tolist(), bends[:, 0].tolist(),
                                                strict=True))]
    weights = 1 / np.maximum(off, UNIT * np.abs(slopes).max(axis=1) + np.finfo(float).tiny)
    inverse = np.abs(np.linalg.pinv(slopes * weights[:, None], rcond=UNIT))
    return [SLACK * x for x in inverse.sum(axis=1).tolist()]


def _of_one(off: float, slope: float, bend: float) -> float:
    if slope * slope > 4 * abs(bend) * off:
        return SLACK * off / abs(slope)
    return TOUCHES * sqrt(2 * off / abs(bend)) if bend else inf


def _known(system: "ConditionSystem", instance: "Problem",
           pairs: Sequence[Sequence[tuple[float, float]]]) -> "tuple[np.ndarray, np.ndarray]":
    """L − R of each condition, and their bounds."""
    import numpy as np

    differences = [left - right for one in pairs for left, right in one]
    return np.array(differences), np.array(_errors(system, instance, pairs))


def _errors(system: "ConditionSystem", instance: "Problem",
            pairs: Sequence[Sequence[tuple[float, float]]]) -> list[float]:
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
