"""What answers ask of a motion that what drives it prescribes, at their instants: without being asked otherwise."""

from collections.abc import Iterator
from contextlib import suppress
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.notation.as_printed import as_printed
from vibcli.notation.numbers import with_minus, with_unit
from vibcli.quantities.dimensions import unit_of
from vibcli.report.blocks import Section, Words, equations, line, section
from vibcli.report.sections.requested_signals import dimension_of
from vibcli.report.steps.asked import known

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


def prescribed(problem: "Problem", _: "Report") -> Iterator[Section]:
    if problem.numeric.has_free_symbols:
        return
    asked = [answer.asked for answer in problem.spec.answers if any(one.args for one in answer.asked.parts.quantities)]
    found = []
    for one in asked:
        with suppress(PhysicsError, SpecError):
            found.append(line(_valued(problem, one)))
    yield from section("Motion in time (prescribed by what drives it)", equations(found))


def _valued(problem: "Problem", asked: "Expression") -> Words:
    """`x(t₁) = 3 mm`; an error where it has no value."""
    value = known(problem, asked)
    unit = unit_of(problem.spec, asked)
    told = f"{with_minus(value)} {unit}" if unit == "J" else with_unit(value, dimension_of(problem, asked.tree))
    return Words(f"{as_printed(asked.text, {*problem.spec.parameters, *problem.spec.coordinates})} = {told}")
