"""Numbers of small motions found to more digits: those that are asked for, and where the bound of the floats exceeds
what a number may be off by."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.work import Spent
from vibcli.results.escalation import ASKED, DIGITS, MOST, ROUNDED

if TYPE_CHECKING:

    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

LIKE = 1e-4         # relative to the bound in floats and to this: how near the two values are


def settled(problem: "Problem", tree: "QuantityRef", found: float, error: float) -> tuple[float, float]:
    """(value, relative error bound) of a number found in floats, or to more digits where these are asked for or its
    bound exceeds what is asked."""
    if problem.response.KIND != "small" or (problem.digits is None and error <= ASKED):
        return found, error
    import mpmath

    from vibcli.quantities.precise_forms import NUMBERS

    if tree.head not in NUMBERS:
        return found, error
    digits = max(problem.digits or 0, DIGITS)
    try:
        value = NUMBERS[tree.head](problem, tree, digits, MOST if problem.digits is None else 30 * MOST)
    except (PhysicsError, Spent, mpmath.libmp.NoConvergence):
        return found, error
    near = float(value)
    if abs(near - found) > (10 * error + LIKE) * max(abs(found), abs(near)) and abs(found) > 1e-300:
        return found, error         # the floats see another extreme or zero
    return near, 2 * ROUNDED
