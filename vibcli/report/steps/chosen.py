"""The last lines of a scene that chooses parameters: each condition solved, and which root was taken."""

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.notation.numbers import figure, quantity
from vibcli.report.blocks import Name, Words
from vibcli.report.sections.design_parameters import condition_parts, condition_told, names_of
from vibcli.report.sections.parameters import as_given
from vibcli.report.steps.asked import short_quantity
from vibcli.report.steps.characteristic import LONG
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.instants import at_instant
from vibcli.report.steps.one_degree import OneDegree
from vibcli.report.steps.place_of_rest import about_rest
from vibcli.report.steps.small_oscillations import Derivation
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.syntax import parts_of

if TYPE_CHECKING:
    from vibcli.reader.sections.choose import Condition
    from vibcli.results.problem import Problem


def with_letters(problem: "Problem") -> "Problem":
    """The same with letters for what was chosen in letters, but for equilibrium: its conditions are solved last."""
    spec = problem.spec
    if problem.choice is None or not problem.symbolic.letters:
        return problem
    kept = [name for name, record in spec.choices.items() if not record["so"].is_balance]
    if not kept:
        return problem
    parameters = {name: record.with_values({key: value for key, value in record.items() if key != "value"})
                  if name in kept else record for name, record in spec.parameters.items()}
    return problem.with_spec(spec.with_parameters(parameters))


def tell_chosen(problem: "Problem", sheet: WorkedSolution) -> None:
    """Each chosen parameter by its condition, the first of the solutions that hold being taken."""
    first, *others = problem.choice.solutions
    for name, condition in problem.choice.conditions.items():
        form, value = first.forms[name], first.values[name]
        parts: list[Any] = [Name(name), *([" = ", form] if form is not None and not is_number(form) else [])]
        unit = ""
        if value is not None:
            number, unit = quantity(float(value), problem.spec.dimensions.of(name))
            parts += [" = ", number, Words(unit)]
        counts = [part for one in first.counts for part in (Words(",  "), *condition_parts(one))][1:]
        parts += [Words("   for "), *counts] if counts else []
        left = "" if form is not None else f"   (by a search; what is left is {figure(first.residual, digits=2)})"
        more = [f"{figure(float(one.values[name]))}{unit}" for one in others if one.values[name] is not None]
        left += f"   (the first of the solutions; others: {', '.join(more)})" if more else ""
        uses = [line.number for line in sheet.steps if line.settles and line.settles in condition]
        told = f"so that {condition_told(condition, names_of(problem))}:  "
        written = _written_out(problem, sheet, problem.spec.choices[name]["so"])
        sheet.write(Words(told), *written, *parts, Words(left), settles=name, node=form, uses=uses or [sheet.last],
                    value=None if value is None else float(value), unit=unit.strip())


def tell_chosen_motion(problem: "Problem", sheet: WorkedSolution) -> None:
    """The free motion of one degree of freedom whose damping is chosen in letters: how it goes follows from that."""
    letters = with_letters(problem)
    if letters is problem or len(problem.scene.q) != 1 or any(line.settles == "free motion" for line in sheet.steps):
        return
    with suppress(PhysicsError):
        aside = WorkedSolution([])
        about = about_rest(problem, aside)
        degree = Degree(about, sheet, Derivation(about, aside).equations())
        OneDegree(degree).write_motion([sheet.last])


def _written_out(problem: "Problem", sheet: WorkedSolution, condition: "Condition") -> list[Any]:
    """Parts of a condition on a quantity by its expression in letters, where no line tells that; none of others."""
    if condition.word or parts_of(condition.right.tree).quantities:
        return []
    asked = condition.left
    if any(line.settles == asked.text for line in sheet.steps):
        return []
    with suppress(PhysicsError, SpecError):
        node = at_instant(problem, sheet, asked) or short_quantity(with_letters(problem), asked.tree)
        if letters(node) <= LONG and not is_number(node):
            told = as_given(condition.right, names_of(problem))
            return [node, " = ", *([Words(told)] if isinstance(told, str) else told.parts), Words(",  ")]
    return []
