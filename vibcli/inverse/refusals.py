"""Why a parameter cannot be chosen, in words."""

from math import inf, isfinite, pi

from vibcli import units
from vibcli.elements.choose import BALANCE, LIMIT
from vibcli.errors import PhysicsError, SpecError
from vibcli.inverse.system import misfit
from vibcli.report.figures import figure
from vibcli.report.notation import plain


def undetermined(problem, span=None):
    """The conditions hold whatever is chosen, or over a whole span of it."""
    names, where = listed(problem.spec.choices), _where(problem)
    if [record["so"].word for record in problem.spec.choices.values()] == [BALANCE]:
        return PhysicsError(f"the drawn position is in equilibrium whatever {names} is: that does not determine it",
                            "ask for another condition", where)
    reach = "whatever {} is" if span is None else f"for every {{}} from {_figure(span[0])} to {_figure(span[1])}"
    return PhysicsError(f"{_texts(problem)}: this holds {reach.format(names)}, so it does not determine it",
                        "ask for another condition", where)


def _where(problem):
    return next(iter(problem.spec.choices.values())).where


def _texts(problem):
    """The conditions in words."""
    words = {BALANCE: "equilibrium as drawn", LIMIT: "a limit of stability"}
    conditions = [record["so"] for record in problem.spec.choices.values()]
    return listed(list(dict.fromkeys(words.get(condition.word, condition.text) for condition in conditions)))


def none_found(system, scan):
    """No solution: what the quantity does over the admissible range, or why it is never defined."""
    where, condition = _where(system.problem), system.conditions[0]
    if scan is None:
        return PhysicsError(f"no admissible values of {listed(system.names)} give {_texts(system.problem)}",
                            "is each of these within reach of the scene? try one of them alone", where)
    name, span = system.names[0], system.ranges[0]
    if not scan.defined():
        error = system.refusal
        if isinstance(error, SpecError):
            return error
        message = error.message if error is not None else "nothing there has a finite value"
        return PhysicsError(f"no value of {name} {_within(system, span)} gives {_texts(system.problem)}: {message}",
                            getattr(error, "hint", None), where)
    if condition.word == BALANCE:
        return PhysicsError(f"no value of {name} {_within(system, span)} keeps the drawn position in equilibrium",
                            "look at the forces that act as drawn: does one depend on it, in the right sense?", where)
    if condition.word:
        signs = {h > 0 for _, h in scan.defined()}
        always = "stable" if signs == {True} else "unstable" if signs == {False} else None
        return PhysicsError(f"no value of {name} {_within(system, span)} is a limit of stability" + (
            f": the equilibrium is {always} for all of them" if always else ""), "choose another parameter", where)
    return PhysicsError(f"no value of {name} {_within(system, span)} gives {condition.text}: {_reach(system, scan)}",
                        "ask for what lies in that range, or choose another parameter", where)


def _reach(system, scan):
    """From where to where the sides of an equation go."""
    pairs = [system.measured([x])[0][0] for x, _ in scan.defined()]
    left, right = zip(*pairs, strict=True)
    condition = system.conditions[0]
    for side, values, other in ((condition.left, left, right), (condition.right, right, left)):
        if min(other) == max(other):
            low, high = _figure(min(values)), _figure(max(values))
            return f"{side.text} " + (f"is {low} for all of them" if low == high else f"ranges from {low} to {high}")
    sense = "larger" if misfit(pairs[0], 0.0) > 0 else "smaller"
    return f"{condition.left.text} is always {sense} than {condition.right.text}"


def _figure(value):
    return figure(value, digits=4)


def _within(system, span):
    """The admissible range in words."""
    unit = units.text(system.problem.spec.dimensions.of(system.names[0]))

    def end(x):
        known = {0.0: "0", inf: "∞", -inf: "−∞", pi: "π", -pi: "−π", 2 * pi: "2π"}
        return known.get(x) or f"{figure(x)} {unit}".strip()

    if (span.low, span.high) == (-inf, inf):
        return "of either sign"
    left, right = "[" if span.low_given else "(", "]" if span.high_given else ")"
    return f"in {left}{end(span.low)}, {end(span.high)}{right}"


def not_admissible(problem, name, node, value, span):
    """The only solution lies outside the range of its parameter."""
    record = problem.spec.choices[name]
    unit = units.text(problem.spec.dimensions.of(name))
    number = "" if value is None else f" = {figure(float(value))} {unit}".rstrip()
    form = f" = {plain(node)}" if node is not None and node.op != "number" else ""
    if span.low == 0.0 and not span.low_given and (value is None or value <= 0):
        return PhysicsError(f"the conditions need {name}{form}{number}, which is not positive",
                            f"turn it round in the scene, or allow it: parameters: {{{name}: {{sign: any}}}}",
                            record.where)
    low, high = (figure(x) if isfinite(x) else "∞" for x in (span.low, span.high))
    return PhysicsError(f"the conditions need {name}{form}{number}, which is not from {low} to {high}",
                        "widen its range", record.where)


def unbalanced(problem, numeric, pairs):
    """Conditions of equilibrium that are left over."""
    names = [name for name, record in problem.spec.choices.items() if record["so"].word == BALANCE]
    errors = [abs(misfit(pair, 0.0)) for pair in pairs]
    i = errors.index(max(errors))
    left = pairs[i][0] - pairs[i][1]
    coordinate = numeric.scene.coordinates[i]
    return PhysicsError(f"no value of {listed(names)} makes the drawn position an equilibrium: the condition for "
                        f"'{coordinate}' is left with {figure(left)}",
                        "choose as many parameters as there are conditions, or draw the position of equilibrium",
                        problem.spec.choices[names[0]].where)


def no_closed_form(problem):
    return PhysicsError(f"no closed form of {listed(problem.spec.choices)} was found",
                        "give the other parameters values in the file or with --set: then it is found in numbers",
                        _where(problem))


def never_in_letters(problem):
    return PhysicsError(f"no admissible value of {listed(problem.spec.choices)} gives {_texts(problem)}, at several "
                        "values of the letters", "give the other parameters values with --set, to see what is possible",
                        _where(problem))


def listed(names):
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last
