"""Numbers of small motions found to more digits: those that are asked for, and where the bound of the floats exceeds
what a number may be off by."""

from collections.abc import Sequence
from contextlib import suppress
from math import inf
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.work import Spent
from vibcli.quantities.quantity import SIGNAL, declared
from vibcli.results.escalation import ASKED, DIGITS, MOST, ROUNDED, largest

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

NEARLY = 2          # digits that a number may lose beside the largest of its kind
LIKE = 1e-4         # relative to the bound in floats and to this: how near the two values are


def settled(problem: "Problem", tree: "QuantityRef", args: Sequence[Any], found: float,
            error: float) -> tuple[float, float]:
    """(value, relative error bound) of a number found in floats, or to more digits where these are asked for or its
    bound exceeds what is asked."""
    small = problem.response_of(tree).KIND == "small"
    if not small or (problem.digits is None and not _exceeds(problem, tree, args, found, error)):
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
    if problem.digits is None:
        return near, 2 * ROUNDED
    size = declared(tree).size(problem, tree)
    return value, 10.0 ** (NEARLY - digits) * max(1.0, float(size / abs(value)) if value else 1.0)


def settled_response(problem: "Problem", tree: "QuantityRef", found: complex, error: float) -> tuple[Any, float]:
    """The same of a frequency response at a frequency, its error relative to its size; a number of mpmath where more
    digits are asked for."""
    value, error = _on_curve("response", problem, tree, error)
    return (found, error) if value is None else (complex(value) if problem.digits is None else value, error)


def found_response(problem: "Problem", tree: "QuantityRef", refusal: PhysicsError) -> tuple[Any, float]:
    """The same of one that floats do not find, whose refusal is what is said where more digits do not find it either.
    """
    value, error = _on_curve("response", problem, tree, inf)
    if value is None:
        raise refusal
    return (complex(value) if problem.digits is None else value), error


def settled_on_curve(problem: "Problem", tree: "QuantityRef", found: float, error: float) -> tuple[Any, float]:
    """The same of what is read off the curve of a frequency response."""
    value, error = _on_curve("place", problem, tree, error)
    return (found, error) if value is None else (float(value) if problem.digits is None else value, error)


def _on_curve(word: str, problem: "Problem", tree: "QuantityRef", error: float) -> tuple[None, float]:
    """(the number in more digits, its relative error); None and the error in floats where that is enough or refused."""
    if problem.digits is None and error <= ASKED:
        return None, error
    from vibcli.quantities import precise_forms

    digits = max(problem.digits or 0, DIGITS)
    try:
        value = getattr(precise_forms, word)(problem, tree, digits, MOST if problem.digits is None else 30 * MOST)
    except (PhysicsError, Spent):
        return None, error
    return value, 2 * ROUNDED if problem.digits is None else 10.0 ** (1 - digits)


def _exceeds(problem: "Problem", tree: "QuantityRef", args: Sequence[Any], found: float, error: float) -> bool:
    """Does a relative bound exceed what is asked? What has the unit of its signal is measured by the signal's largest.
    """
    if error <= ASKED:
        return False
    signal, instants = problem.response.signal(tree.args[0]), args[1:]
    if tree.head in ("max", "min"):
        instants = [signal.extreme(0.0, problem.response.until, 1 if tree.head == "max" else -1)[0]]
    if instants:
        return not all(signal.error(t) <= ASKED * largest(signal, t) for t in instants)
    with suppress(PhysicsError):
        return declared(tree).unit != SIGNAL or error * abs(found) > ASKED * largest(signal, problem.response.until)
    return True
