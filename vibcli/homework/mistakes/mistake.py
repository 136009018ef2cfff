"""A mistake, as its file declares it: what it tells the student, and how its wrong value is found."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.results.problem import Problem

RATES = "omega", "omega_d"
FREQUENCIES = "frequency",
PERIODS = "period", "period_d", "beat_period"
AMPLITUDES = "amplitude", "envelope"
UNPREFIXED = "", "1", "%", "rad", "deg", "rad/s", "1/s", "s^-1", "rpm", "Hz"        # without prefixes

Part = dict[str, Any]


class CommonMistake(NamedTuple):
    """sentence: what the student is told. One of these is given:

    reading(value, head, unit)      the wrong number for a right one, both in the unit (its text) in which the quantity
                                    `head` ('' of an expression) is asked; None where it does not concern it
    formula(quantity)               the text of the wrong expression for a quantity, a QuantityRef; None likewise
    model(problem)                  (what it concerns, part of a scene that it changes) of each way to make it; numbers
                                    in it are in SI units, None takes a key out

    single: it concerns scenes of one degree of freedom alone.
    """

    sentence: str
    reading: "Callable[[float, str, str], float | None] | None" = None
    formula: "Callable[[QuantityRef], str | None] | None" = None
    model: "Callable[[Problem], Iterator[tuple[str, Part]]] | None" = None
    single: bool = False


def by_reading(factor: float, heads: tuple[str, ...]) -> "Callable[[float, str, str], float | None]":
    """The reading that multiplies what these quantities are."""
    return lambda value, head, unit: factor * value if head in heads else None


def by_formula(text: str, heads: tuple[str, ...]) -> "Callable[[QuantityRef], str | None]":
    """The formula that stands for these quantities: {} the quantity itself, {i} its index."""
    def wrong(asked: QuantityRef) -> str | None:
        if asked.head not in heads:
            return None
        return text.format(asked.text, i=",".join(asked.indices), args=asked.text.partition("(")[2].rstrip(")"))

    return wrong
