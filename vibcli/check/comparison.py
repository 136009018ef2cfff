"""Numbers compared as intervals: what is found with its bound, against what is expected with its tolerance.

    |found − expected| + bound ≤ tolerance      agrees, whatever the error is
    |found − expected| − bound > tolerance      differs, whatever it is
    else                                        open: found anew to more digits, and uncertain where that leaves it open

A bound that grows can turn either into uncertain, never one into the other.
"""

from collections.abc import Iterator
from math import log10
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.check.tolerance import tolerance
from vibcli.quantities.expression import bounded

if TYPE_CHECKING:
    from vibcli.reader.sections.answer import Answer
    from vibcli.results.problem import Problem

DIGITS, MORE = 25, 8        # found anew at least; beyond those of the tolerance
LEAST = 1e-100              # relative: the smallest tolerance for which digits are sought
MOST = 100                  # steps of a million products


class Comparison(NamedTuple):
    """agrees: True, False, or None where `error`, an absolute bound of what is found, leaves it open; `tolerance`:
    absolute too; digits: expected and found with the digits that tell them apart, where floats do not."""

    agrees: bool | None
    expected: float
    found: float
    error: float
    tolerance: float
    digits: tuple[str, str] | None = None


def compared(problem: "Problem", answer: "Answer") -> Comparison:
    """The Comparison of an answer that is a number."""
    comparison = _compared(problem, answer)
    for digits in _more_digits(problem, comparison):
        if comparison.agrees is not None:
            return comparison
        try:
            sharper = _compared(problem.with_digits(digits), answer)
        except PhysicsError:        # no more digits are to be had
            break
        if not sharper.error < comparison.error / 2 or _contradict(comparison, sharper):
            break
        comparison = sharper
    return comparison


def _contradict(rough: Comparison, sharp: Comparison) -> bool:
    """Do two values of one number differ by more than their bounds? Then one of them is of another extreme or zero."""
    return abs(sharp.found - rough.found) > 2 * (rough.error + sharp.error)


def _compared(problem: "Problem", answer: "Answer") -> Comparison:
    """The Comparison in floats, or to the digits that the problem is asked for."""
    found, error = bounded(problem, answer.asked)
    expected, doubt = bounded(problem, answer.expected)
    return verdict(expected, found, error + doubt, tolerance(problem, answer, expected))


def verdict(expected: float, found: float, error: float, tolerance: float) -> Comparison:
    """What numbers (of any kind) say: agrees, differs, or open."""
    apart = abs(found - expected)
    agrees = True if apart + error <= tolerance else False if apart - error > tolerance else None
    alike = agrees is False and float(expected) == float(found)
    digits = _told_apart(expected, found) if alike else None
    return Comparison(agrees, float(expected), float(found), float(error), float(tolerance), digits)


def _told_apart(expected: float, found: float) -> tuple[str, str]:
    """Two numbers that are the same float, in the digits in which they differ."""
    import mpmath

    count = 2 - int(mpmath.floor(mpmath.log10(abs(found - expected) / abs(expected))))
    with mpmath.workdps(count + 5):
        return mpmath.nstr(mpmath.mpmathify(expected), count), mpmath.nstr(mpmath.mpmathify(found), count)


def _more_digits(problem: "Problem", comparison: Comparison) -> Iterator[int]:
    """To how many digits to find anew what floats leave open, so that its bound is far below the tolerance; none where
    the scene holds a number that was searched for, or where they take long."""
    if problem.choice is not None and not problem.choice.exact:
        return
    share = comparison.tolerance / abs(comparison.expected) if comparison.expected else 1.0
    first = max(DIGITS, MORE + round(-log10(max(share, LEAST))))
    for digits in (first, 2 * first):
        if problem.modal.steps_to_digits(digits) <= MOST * problem.work.patience:
            yield digits
