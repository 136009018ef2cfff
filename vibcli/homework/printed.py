"""Chosen parameters as they are printed: rounded, and the scene solved again with what the student reads."""

from fractions import Fraction
from math import floor, log10
from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.base.errors import PhysicsError
from vibcli.inverse import settled
from vibcli.language.given_values import GivenValue, giver, unit_of_text
from vibcli.language.parameters import unit_text
from vibcli.reader.variants import preferred
from vibcli.results.variants import with_given

if TYPE_CHECKING:
    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem

FIGURES = "3"


def with_printed(problem: "Problem", rules: "VariantRules") -> "Problem":
    """The problem with values for what it chooses: those that are not asked as they are printed."""
    found = settled(problem)
    values = printed_values(found, rules)
    return found if not values else settled(with_given(problem, values))


def printed_values(found: "Problem", rules: "VariantRules") -> dict[str, GivenValue]:
    """{chosen parameter: its value as it is printed} of a Problem with what it chose."""
    asked = {one.asked.text for one in rules.ask}
    return {name: _rounded(found, name, rules.printed.get(name, FIGURES))
            for name in found.spec.choices if name not in asked and found.choice is not None}


def _rounded(found: "Problem", name: str, how: str) -> GivenValue:
    """A chosen value to so many figures, or the nearest of a series by ratio."""
    unit = unit_text(found.spec.parameters[name]) or units.text(
        found.spec.dimensions.resolve(found.spec.dimensions.of(name)))
    factor = unit_of_text(unit if unit != "1" else "")
    number = found.choice.value(name, 1) / (factor.in_si(1) if factor is not None else 1.0)
    unit = "" if factor is None else unit
    if how.isdecimal() or not number:
        return giver(unit, name)(Fraction(f"{number:.{int(how) - 1 if how.isdecimal() else 0}e}"))
    if number < 0:
        raise PhysicsError(f"{name} is negative, and preferred numbers are positive", "print it to so many figures")
    decade = Fraction(10)**floor(log10(number))
    nearest = min(preferred(how, decade, 10 * decade), key=lambda one: abs(log10(one / number)))
    return giver(unit, name)(nearest)
