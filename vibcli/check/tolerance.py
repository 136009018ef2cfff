"""How far what is found may lie from the number that is expected: by its tolerance, by the digits written, or by
rounding. This hangs on what is written alone, never on how well the result is known."""

from typing import TYPE_CHECKING

from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.base.written_digits import SHORT, digits_written, half_a_unit
from vibcli.quantities.expression import bounded, measure, value_of
from vibcli.quantities.quantity import parts_that_cancel, quantity_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.reader.sections.answer import Answer
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

EXACT, WIDEST, SMALL, EPSILON = 1e-9, 0.005, 1e-12, 2.0**-52
DOUBLE = 17     # digits: a float has at most so many
ULPS = {16: 16, 17: 16}     # of a float printed in full, its last digits are the rounding of whoever computed it


def tolerance(problem: "Problem", answer: "Answer", expected: float) -> float:
    """The absolute tolerance of an answer."""
    if answer.rtol is not None:
        share = _share(problem, answer.rtol)
        return (share * (1 + EXACT) or 4 * EPSILON) * abs(expected) if expected else _small(problem, answer)
    if not expected or is_exact(answer):
        return EXACT * abs(expected) + 1e-300 if expected else _small(problem, answer)
    text, number = answer.expected.text, answer.expected.parts.whole
    half = min(half_a_unit(text) / abs(float(number.value)), WIDEST) * (1 + EXACT)
    if digits_written(text) > DOUBLE:
        return half * abs(expected)
    return (half + ULPS.get(digits_written(text), 4) * EPSILON) * abs(expected)


def is_exact(answer: "Answer") -> bool:
    """Does an answer claim no digits, as an expression and a number of few digits do?"""
    is_number = answer.expected.parts.whole is not None
    return answer.rtol is None and not (is_number and digits_written(answer.expected.text) >= SHORT)


def _share(problem: "Problem", rtol: "Expression") -> float:
    share = value_of(problem, rtol)[0]
    if not 0 <= share < 1:
        raise SpecError([Diagnostic(rtol.where, f"the tolerance is {share:.6g}, expected 0 to 1",
                                    "write for example rtol: 0.5 %")])
    return share


def _small(problem: "Problem", answer: "Answer") -> float:
    """What counts as zero: rounding beside the largest number of its kind, and what is found as 0, whatever its
    bound."""
    found, error = map(float, bounded(problem, answer.asked))
    if not found and answer.expected.parts.whole is not None:
        return error
    try:
        return max(_rounding(problem, answer), 0.0 if found else error)
    except PhysicsError:        # how large its kind become is not found: its own bound tells it from 0
        return 4 * error


def _rounding(problem: "Problem", answer: "Answer") -> float:
    tree, quantities = answer.asked.tree, answer.asked.parts.quantities
    quantity = quantity_of(problem.spec, tree)
    if quantity is not None and quantity.size is not None:
        return _share_of(tree) * max(float(quantity.size(problem, part)) for part in parts_that_cancel(tree))
    parts = [_share_of(part) * float(abs(measure(problem, part)[0])) for part in quantities]
    return max(parts) if parts else 4 * float(bounded(problem, answer.asked)[1])


def _share_of(tree: "QuantityRef") -> float:
    """What is rounding beside a quantity; in motions the roots of equations and sums of many terms are rounded, too."""
    return EXACT if tree.args else SMALL
