"""The parameters that a scene chose: as a section of a report, and as data."""

import re
from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import figure, quantity
from vibcli.reader.sections.choose import BALANCE, LIMIT
from vibcli.report.blocks import Name, Section, Words, equations, line, maths, paragraph, section, separated
from vibcli.report.keys import Key

if TYPE_CHECKING:
    from vibcli.inverse.solution import Chosen, Solution
    from vibcli.reader.sections.choose import Condition
    from vibcli.report.blocks import Line
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

QUANTITY = re.compile(r"-?[\d.]+(e[+-]?\d+)? [^\W\d]")      # a number with a unit
WORDS = {BALANCE: "the drawn position is an equilibrium", LIMIT: "the equilibrium is at its limit of stability"}


def chosen(problem: "Problem", _: "Report") -> Iterator[Section]:
    """Conditions, solutions with closed form and number, and how well they hold."""
    found = problem.choice
    texts = dict.fromkeys(condition_told(text, names_of(problem)) for text in found.conditions.values())
    told = paragraph(*separated(maths(Name(name)) for name in found.conditions), f" so that {', '.join(texts)}")
    several = len(found.solutions) > 1
    residual = figure(max(solution.residual for solution in found.solutions), digits=2)
    where = " at several values of the letters" if problem.symbolic.letters else ""
    checked = f"checked by substitution{where}: what is left of the conditions is {residual} of their terms"
    checked += " at most" * several
    if any(_with_units(record["so"]) for record in problem.spec.choices.values()) and _any_form(found):
        checked += "; closed forms in SI units"
    yield from section("Chosen", told, equations(_lines(problem, several)), paragraph(checked, hang=None),
                       paragraph("what follows is with the first solution", hang=None) if several else None)


def condition_told(text: str, names: Collection[str] = ()) -> str:
    """A condition in words, or what was typed as it is printed: c = 0.2 N·s/m, ω₂ = 3·ω₁; `names`: those of the
    scene."""
    from vibcli.notation.as_printed import as_printed

    return WORDS.get(text) or as_printed(text, names)


def names_of(problem: "Problem") -> list[str]:
    """The names that a condition may hold."""
    return [*problem.spec.parameters, *problem.scene.coordinates]


def _lines(problem: "Problem", several: bool) -> "Iterator[Line]":
    for number, solution in enumerate(problem.choice.solutions, 1):
        for i, name in enumerate(problem.choice.conditions):
            mark, inset = ((Words(f"{number}.  "),), 0) if several and not i else ((), 4 * several)
            fold = (Words(FOLD),) * solution.fold
            yield line(*mark, *_equation(problem, name, solution), *fold, hang=6 if several else 2, inset=inset)
        if solution.counts:
            counts = [part for condition in solution.counts for part in (", ", *condition_parts(condition))][1:]
            yield line(Words("for "), *counts, hang=6, inset=4 if several else 2)


def condition_parts(condition: Any) -> list[Any]:
    """Parts of a Condition under which a solution in letters counts."""
    if condition.words is not None:
        return [Words(f"values at which it gives {condition.words}")]
    if not condition.relation:
        return [Words("real "), Name(condition.name)]
    side = Name(condition.name) if condition.node is None else condition.node
    return [side, f" {condition.relation} ", condition.bound]


def _told(condition: Any) -> str:
    """The same as a text of the language."""
    if condition.words is not None or not condition.relation:
        return condition.words or f"real {condition.name}"
    from vibcli.notation.scene_language import language

    side = condition.name if condition.node is None else language(condition.node)
    return f"{side} {condition.relation.replace('≥', '>=').replace('≤', '<=')} {language(condition.bound)}"


FOLD = "   a limit point (fold): there the equilibrium meets an unstable one, and beyond it both are gone"


def _equation(problem: "Problem", name: str, solution: "Solution") -> "list[Name | Node | str | Words]":
    """Parts of c = closed form = number."""
    form, value = solution.forms[name], solution.values[name]
    parts: list[Any] = [Name(name)]
    if form is not None and (value is None or _has_letters(form)):
        parts += [" = ", form]
    if value is not None:
        number, unit = quantity(float(value), problem.spec.dimensions.of(name))
        parts += [" = ", number, Words(unit)]
    about = problem.spec.parameters[name].get("about")
    return parts + [Words(f"   {about}")] * bool(about)


def _has_letters(node: "Node") -> bool:
    from vibcli.symbolic.expression_graph import reachable

    return any(part.op == "symbol" for part in reachable([node]))


def _any_form(chosen: "Chosen") -> bool:
    return any(form is not None and _has_letters(form) for solution in chosen.solutions
               for form in solution.forms.values())


def _with_units(condition: "Condition") -> bool:
    return any(literal.units for side in condition.sides for literal in side.parts.numbers)


def _chosen(problem: "Problem") -> "Iterator[dict[str, list[float | list[str] | Node | None] | str]]":
    """What the keys tell of each parameter."""
    solutions = problem.choice.solutions
    for name, condition in problem.choice.conditions.items():
        forms = [solution.forms[name] for solution in solutions]
        values = [form if solution.values[name] is None else float(solution.values[name])
                  for solution, form in zip(solutions, forms, strict=True)]
        yield CHOSEN.row(name, condition, values, forms, [solution.residual for solution in solutions],
                         [solution.fold for solution in solutions],
                         [list(map(_told, solution.counts)) for solution in solutions])


CHOSEN = Key("chosen", "only where the scene chooses: a list, one entry to each chosen parameter", _chosen, each=(
    Key("parameter", "its name"),
    Key("condition", "the condition as written"),
    Key("values", "its value in each solution, ascending; all else is of the first"),
    Key("closed_forms", "the same as expressions of the language of scenes, null where none was found"),
    Key("residuals", "what is left of the conditions after substitution, relative to their terms"),
    Key("limit_points", "is it a limit point (fold), where the equilibrium and an unstable one vanish?"),
    Key("counts_for", "in letters: the conditions under which each is a solution, none where it always is")))
