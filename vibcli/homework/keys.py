"""Keys: the quantities that are asked of a variant, in the units in which they are asked, and their values."""

from collections.abc import Callable, Sequence
from decimal import Decimal
from functools import partial
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.units import Unit
from vibcli.homework.bands import Band, KeyBand
from vibcli.homework.gates import BOUND, SAME, Wrong, is_same, told_apart
from vibcli.language.given_values import unit_of_text
from vibcli.notation.numbers import in_figures
from vibcli.quantities.dimensions import unit_of
from vibcli.quantities.expression import value_of
from vibcli.quantities.quantity import quantity_of

if TYPE_CHECKING:
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec
    from vibcli.reader.sections.variants import AskedQuantity
    from vibcli.results.problem import Problem

ROUTES = 1e-9               # relative: by so much two ways to a key may differ
SEEN = 1e-9                 # relative: what is no rounding


class KeyValue(NamedTuple):
    """The key of a variant that is a number: value and error bound in its unit, its Band, what mistakes give."""

    value: float
    error: float
    band: Band
    wrong: tuple[Wrong, ...]

    @property
    def written(self) -> str:
        return self.said(self.value)

    @property
    def figures(self) -> str:
        """To how many an answer is asked."""
        return str(self.band.figures)

    @property
    def spread(self) -> str:
        """How far an answer may be off, without an exponent."""
        return f"± {Decimal(f'{self.band.width:.2g}'):f}"

    @property
    def hidden(self) -> tuple[str, ...]:
        """Texts that no sheet may tell."""
        return ()

    def said(self, value: float) -> str:
        """The key, or what a mistake makes of it, to the figures that are asked."""
        return in_figures(value, self.band.figures)

    def data(self) -> dict[str, Any]:
        """What a manifest keeps of it."""
        return {"value": self.value, "error": self.error, "figures": self.band.figures, "band": self.band.width,
                "mistakes": [{"name": one.mistake, "value": one.value} for one in self.wrong]}


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

    @property
    def in_letters(self) -> bool:
        """Are answers compared in a scene?"""
        return False

    @property
    def form(self) -> str:
        """How an answer is written, in a sentence; '' where figures and unit say it."""
        return ""

    def printed(self, problem: "Problem", written: str) -> Any:
        """The key, or what a mistake makes of it, as it is set in print."""
        return written

    def value(self, problem: "Problem", expression: "Expression | None" = None) -> tuple[float, float]:
        """(value, absolute error bound) in its unit of what is asked, or of another expression, in a scene."""
        return self.in_unit(*value_of(problem, expression or self.asked))

    def in_unit(self, found: float, error: float) -> tuple[float, float]:
        """(value, absolute error bound) in its unit of (value, relative error bound) as quantities are found."""
        return found / self.factor, abs(error * found / self.factor)

    def found(self, problem: "Problem") -> Any:
        """What a scene answers: (value, absolute error bound) in its unit."""
        return self.value(problem)

    def hangs_on(self, problem: "Problem", name: str, moved: "Problem | None") -> bool:
        """Does it change with a parameter, which has another value in the scene `moved`?"""
        if moved is None:
            return True
        (value, error), (other, its) = self.value(problem), self.value(moved)
        return abs(value - other) > SEEN * max(abs(value), abs(other)) + error + its

    def mistaken(self, mistake: "KnownMistake", scene: "Problem", found: Any) -> Any:
        """What a mistake gives, in the scene that it takes for the right one, None where it does not concern it or has
        no such answer; found: the right answer."""
        return self.mistaken_by(mistake, partial(value_of, scene), found)

    def mistaken_by(self, mistake: "KnownMistake", value: "Callable[[Expression], tuple[float, float]]",
                    found: Any) -> Any:
        """The same; value(expression): (value, relative error bound) in that scene."""
        try:
            return mistake.wrong(self.asked, self.unit, found[0],
                                 lambda expression: self.in_unit(*value(expression))[0])
        except (SpecError, PhysicsError):
            return None

    def equal(self, problem: "Problem", found: Any, wrong: Sequence[Any], instances: Any = None) -> list[bool]:
        """Does each of what mistakes give equal the key? instances: the Instances of a scene in letters."""
        return [is_same(found[0], one) for one in wrong]

    def is_mistaken_so(self, problem: "Problem", one: KeyValue, wrong: float, again: float) -> bool:
        """Is what a mistake gives, as a key has it, what it gives again, within a tenth of its band?"""
        share = abs(again / one.value) if one.value else 1.0
        return abs(wrong - again) <= BOUND * one.band.width * share + SAME * abs(one.value or again)

    def settled(self, hangs_on: KeyBand, found: Any, wrong: tuple[Wrong, ...], equal: list[bool]) -> tuple[Any, Any]:
        """(the key with what it allows, why mistakes are not told from it or None)."""
        value, error = found
        band, reason = told_apart(self, hangs_on, value, wrong)
        return KeyValue(value, error, band, wrong), reason

    def require_same(self, fresh: "Problem", one: Any, at: str) -> None:
        """RuntimeError, a fault of ours, where a scene read anew does not give the key; at: the values in words."""
        value, error = self.value(fresh)
        if abs(value - one.value) > ROUTES * abs(value) + error + one.error:
            raise RuntimeError(f"two ways to {self.text} differ, {value!r} and {one.value!r}, at {at}")


def number_key(spec: "Spec", one: "AskedQuantity") -> AnswerKey:
    """The AnswerKey of a number that is asked."""
    unit = one.unit or si_unit(spec, one.asked)
    factor = _factor(spec, one.asked, unit_of_text(unit) if unit else None)
    return AnswerKey(one.asked, unit, factor, one.points, one.rtol)


def si_unit(spec: "Spec", asked: "Expression") -> str:
    """The text of the SI unit of a quantity, '' of a pure number."""
    found = unit_of(spec, asked)
    return "" if found == "1" else found


def _factor(spec: "Spec", asked: "Expression", unit: Unit | None) -> float:
    """What one of a unit is in that in which a quantity is found: a cycle is one where cycles are counted, else 2π."""
    if unit is None:
        return 1.0
    quantity = quantity_of(spec, asked.tree)
    counted = quantity is not None and quantity.unit == "Hz"
    return unit.in_si(1) * (tau**unit.cycles if unit.cycles and not counted else 1.0)
