"""Keys: the quantities that are asked of a variant, in the units in which they are asked."""

from math import floor, log10, tau
from typing import TYPE_CHECKING, NamedTuple

from vibcli.base.units import Unit
from vibcli.language.given_values import unit_of_text
from vibcli.quantities.dimensions import unit_of
from vibcli.quantities.expression import value_of
from vibcli.quantities.quantity import quantity_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec
    from vibcli.reader.sections.variants import AskedQuantity
    from vibcli.results.problem import Problem


class AnswerKey(NamedTuple):
    """A quantity that is asked: its expression, the text of its unit, '' of pure numbers, what one of that is in the
    units in which quantities are found; points; the relative tolerance that the file gives, None where it follows from
    rounding."""

    asked: "Expression"
    unit: str
    factor: float
    points: int
    rtol: float | None = None

    @property
    def text(self) -> str:
        return self.asked.text

    def value(self, problem: "Problem", expression: "Expression | None" = None) -> tuple[float, float]:
        """(value, absolute error bound) in its unit of what is asked, or of another expression, in a scene."""
        found, error = value_of(problem, expression or self.asked)
        return found / self.factor, abs(error * found / self.factor)


def key_of(spec: "Spec", one: "AskedQuantity") -> AnswerKey:
    """The AnswerKey of a quantity that is asked."""
    unit = one.unit or _si(spec, one.asked)
    factor = _factor(spec, one.asked, unit_of_text(unit) if unit else None)
    return AnswerKey(one.asked, unit, factor, one.points, one.rtol)


def _si(spec: "Spec", asked: "Expression") -> str:
    """The text of the SI unit of a quantity, '' of a pure number."""
    found = unit_of(spec, asked)
    return "" if found == "1" else found


def _factor(spec, asked, unit: Unit | None):
    """What one of a unit is in that in which a quantity is found: a cycle is one where cycles are counted, else 2π."""
    if unit is None:
        return 1.0
    quantity = quantity_of(spec, asked.tree)
    counted = quantity is not None and quantity.unit == "Hz"
    return unit.in_si(1) * (tau**unit.cycles if unit.cycles and not counted else 1.0)


def half_a_unit(value: float, figures: int) -> float:
    """Half a unit of the last figure of a value that is written with so many."""
    return 0.5 * 10.0**(floor(log10(abs(value))) - figures + 1) if value else 0.0

