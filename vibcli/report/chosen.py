"""The parameters that a scene chose: as lines of a report, and as data."""

from vibcli.algebra.expression import reachable
from vibcli.algebra.meaning import literals_in
from vibcli.elements.choose import BALANCE, LIMIT
from vibcli.report.figures import figure, with_unit, wrapped
from vibcli.report.language import language
from vibcli.report.notation import plain

WORDS = {BALANCE: "the drawn position is an equilibrium", LIMIT: "the equilibrium is at its limit of stability"}


def chosen_lines(problem):
    """Conditions, solutions with closed form and number, and how well they hold."""
    chosen = problem.chosen
    texts = dict.fromkeys(WORDS.get(text, text) for text in chosen.conditions.values())
    lines = wrapped(f"{', '.join(map(plain.symbol, chosen.conditions))} so that {', '.join(texts)}")
    several = len(chosen.solutions) > 1
    for number, solution in enumerate(chosen.solutions, 1):
        mark, inset = (f"{number}.  ", 4) if several else ("", 0)
        for i, name in enumerate(chosen.conditions):
            text = _equation(problem, name, solution)
            lines += wrapped(mark + text, indent=inset + 2) if not i else wrapped(text, indent=inset + 2, first=inset)
    residual = figure(max(solution.residual for solution in chosen.solutions), digits=2)
    where = " at several values of the letters" if problem.letters else ""
    checked = f"checked by substitution{where}: relative residual {residual}" + " at most" * several
    if any(_with_units(record["so"]) for record in problem.spec.choices.values()) and _any_form(chosen):
        checked += "; closed forms in SI units"
    return [*lines, checked] + ["what follows is with the first solution"] * several


def _equation(problem, name, solution):
    """c = closed form = number."""
    form, value = solution.forms[name], solution.values[name]
    parts = [plain.symbol(name)]
    if form is not None and (value is None or _has_letters(form)):
        parts.append(plain(form))
    if value is not None:
        parts.append(with_unit(float(value), problem.spec.dimensions.of(name)))
    about = problem.spec.parameters[name].get("about")
    return " = ".join(parts) + (f"   {about}" if about else "")


def _has_letters(node):
    return any(part.op == "symbol" for part in reachable([node]))


def _any_form(chosen):
    return any(form is not None and _has_letters(form) for solution in chosen.solutions
               for form in solution.forms.values())


def _with_units(condition):
    return any(literal[4] for side in condition.sides for literal in literals_in(side.tree))


def chosen_data(problem):
    """[{parameter, condition, values, closed_forms, residuals}], a list entry of the last three to each solution."""
    chosen = problem.chosen
    found = []
    for name, condition in chosen.conditions.items():
        forms = [solution.forms[name] for solution in chosen.solutions]
        texts = [None if form is None else language(form) for form in forms]
        values = [solution.values[name] for solution in chosen.solutions]
        found.append({"parameter": name, "condition": condition,
                      "values": [text if value is None else float(value)
                                 for value, text in zip(values, texts, strict=True)],
                      "closed_forms": texts, "residuals": [solution.residual for solution in chosen.solutions]})
    return found
