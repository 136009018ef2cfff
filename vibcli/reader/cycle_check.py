"""Cycles and radians in a file: where cycles stand for radians."""

from typing import TYPE_CHECKING

from vibcli.quantities.cycle_count import cycles, known_dimension
from vibcli.symbolic.cycles import agree, fits_both, left_over
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from fractions import Fraction
    from typing import TypeVar

    from vibcli.language.reader import Expression, Reader
    from vibcli.language.spec import Spec
    from vibcli.symbolic.cycles import Cycles

    T = TypeVar("T")


def check_radians(spec: "Spec", reader: "Reader", expression: "Expression") -> None:
    """Report cycles where radians are due: in an angle, an angular frequency, a stiffness …"""
    message = "expected an angular frequency (rad/s), found Hz" if expression.unit == "rad/s" else (
        "this counts cycles (Hz) where radians are due")
    _reported(reader, expression, lambda counter: counter.require_radians(expression.tree, message, True), spec)


def check_terms(spec: "Spec", reader: "Reader", expression: "Expression") -> "Mapping[str, Fraction | int] | None":
    """Report terms that cannot be added, one counting cycles and the other radians."""
    count: Mapping[str, Fraction | int] | None = _reported(
        reader, expression, lambda counter: counter.count(expression.tree), spec)
    return count


def check_same(spec: "Spec", reader: "Reader", asked: "Expression", expected: "Expression") -> None:
    """Report an expected value that counts cycles where what is asked does not, or the reverse."""
    counts = [check_terms(spec, reader, part) for part in (asked, expected)]
    dimensions = [known_dimension(spec, part.tree) for part in (asked, expected)]
    if None not in counts and not agree(counts, dimensions):
        more = left_over(counts[1]) > left_over(counts[0])
        reader.report(expected.where, "this counts cycles (Hz), and what it is compared with does not" if more else
                      "this counts no cycles (Hz), and what it is compared with does",
                      "an angular frequency is 2*pi*f, a frequency omega/(2*pi)")


def is_frequency(spec: "Spec", expression: "Expression") -> bool:
    """Can it be a frequency in Hz: does it count one cycle, or neither cycles nor radians?"""
    count = cycles(spec, expression.text).count(expression.tree)
    return left_over(count) == 1 or fits_both(count, known_dimension(spec, expression.tree))


def _reported(reader: "Reader", expression: "Expression", check: "Callable[[Cycles], T]", spec: "Spec") -> "T | None":
    try:
        return check(cycles(spec, expression.text))
    except ExpressionError as error:
        return reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
