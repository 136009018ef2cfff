"""Why a parameter cannot be chosen, in words."""

from collections.abc import Sequence
from math import inf, isfinite, pi, tau
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.enumeration import listed
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.work import longer
from vibcli.inverse.conditions import ConditionSystem, misfit
from vibcli.notation.numbers import figure
from vibcli.notation.plain import plain

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.base.errors import Where
    from vibcli.inverse.admissible_ranges import Range
    from vibcli.inverse.folds import End
    from vibcli.numerics.root_finding import Scan
    from vibcli.reader.sections.choose import Condition
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def undetermined(problem: "Problem", tried: Sequence[float] | None = None) -> PhysicsError:
    """The conditions hold whatever is chosen, as letters prove; or at all the values that were `tried` in a range."""
    names, where = listed(problem.spec.choices), _where(problem)
    if [record["so"].is_balance for record in problem.spec.choices.values()] == [True]:
        return PhysicsError(f"the drawn position is in equilibrium whatever {names} is: that does not determine it",
                            "ask for another condition", where)
    reach = f"whatever {names} is"
    if tried is not None:
        unit = units.text(problem.spec.dimensions.of(next(iter(problem.spec.choices))))
        ends = f"{_figure(tried[0])} to {_figure(tried[-1])} {unit}".rstrip()
        reach = f"at all {len(tried)} values of {names} tried from {ends}"
    return PhysicsError(f"{texts(problem)}: this holds {reach}, so it does not determine it",
                        "ask for another condition", where)


def _where(problem: "Problem") -> "Where":
    return next(iter(problem.spec.choices.values())).where


def texts(problem: "Problem") -> str:
    """The conditions in words."""
    return listed(list(dict.fromkeys(_in_words(record["so"]) for record in problem.spec.choices.values())))


def _in_words(condition: "Condition") -> str:
    if condition.word is None:
        return condition.text
    return "equilibrium as drawn" if condition.is_balance else "a limit of stability"


def none_found(system: ConditionSystem, scan: "Scan | None", proven: bool = False) -> PhysicsError | SpecError:
    """No solution: what the quantity does at the values that were tried, or why it is never defined. `proven`: do
    letters tell that there is none? Else none was found where it was looked for."""
    where, condition = _where(system.problem), system.conditions[0]
    if scan is None:
        return _of_several(system, proven)
    name, span = system.names[0], system.ranges[0]
    none = f"no value of {name} {_within(system, span)}" + " was found that" * (not proven)
    gives = f"{none} gives {texts(system.problem)}"
    if not scan.defined():
        error = system.refusal
        if isinstance(error, SpecError):
            return error
        message = error.message if error is not None else "nothing there has a finite value"
        return PhysicsError(f"{gives}: {message}", getattr(error, "hint", None), where)
    if condition.is_balance:
        return PhysicsError(f"{none} keeps the drawn position in equilibrium",
                            "look at the forces that act as drawn: does one depend on it, in the right sense?", where)
    if condition.word:
        return PhysicsError(f"{none} is a limit of stability{_stability(system, scan, proven)}",
                            "choose another parameter", where)
    reach, within = _reach(system, scan)
    return PhysicsError(f"{gives}: {reach}", "give a narrower range with from and to, or choose another parameter"
                        if within else "ask for what lies in that range, or choose another parameter", where)


class NotHeld(PhysicsError):
    """The conditions do not hold where the scene comes to rest with the values that they ask for."""


def not_held(system: ConditionSystem) -> NotHeld:
    """No solution is left once those in letters are tried in the scene."""
    if len(system.names) > 1:
        error = _of_several(system, False)
        return NotHeld(error.message, error.hint, error.where)
    return NotHeld(f"no admissible value of {system.names[0]} was found that gives {texts(system.problem)}",
                   "give its range with from and to, or choose another parameter", _where(system.problem))


def _of_several(system: ConditionSystem, proven: bool) -> PhysicsError:
    """No common solution of several conditions."""
    names, where = listed(system.names), _where(system.problem)
    found = "" if proven else "were found that "
    return PhysicsError(f"no admissible values of {names} {found}give {texts(system.problem)}",
                        "is each of these within reach of the scene? try one of them alone" + (
                            "" if proven else ", or give the range of each with from and to"), where)


def _stability(system: ConditionSystem, scan: "Scan", proven: bool) -> str:
    """Is the equilibrium stable or unstable wherever it was looked at, and where does it end?"""
    if system.ends:
        end = system.ends[0]
        unit = units.text(system.problem.spec.dimensions.of(system.names[0]))
        up = end.value > end.start
        way = f" from {figure(_stable_since(scan, end, up))} {'up' if up else 'down'} to {figure(end.value)} {unit}"
        goes = f"runs off without bound along '{end.runs}'" if end.runs else "is lost: none was found beyond"
        return f": the equilibrium is stable{way.rstrip()}, where it {goes}"
    signs = {(h > 0) - (h < 0) for _, h in scan.defined()}
    if len(signs) > 1 or signs == {0}:
        return ""
    kind = "stable" if signs == {1} else "unstable"
    return f": the equilibrium is {kind} " + ("for all of them" if proven else _tried(system, scan))


def _stable_since(scan: "Scan", end: "End", up: bool) -> float | None:
    """The value farthest from an End to which the equilibrium is stable at all that were tried, going back from it."""
    since, places = end.start, scan.defined()
    for x, h in reversed(places) if up else places:
        if (x < end.start) if up else (x > end.start):
            if not h > 0:
                break
            since = x
    return since


def _tried(system: ConditionSystem, scan: "Scan") -> str:
    """The values at which there is an answer, in words, and why there is none at others."""
    places, unit = [x for x, _ in scan.defined()], units.text(system.problem.spec.dimensions.of(system.names[0]))
    count = f"all {len(places)}" if len(places) == len(scan.points) else f"{len(places)} of {len(scan.points)}"
    found = f"at {count} values tried, from {figure(places[0])} to {figure(places[-1])} {unit}".rstrip()
    if len(places) == len(scan.points) or system.refusal is None or isinstance(system.refusal, SpecError):
        return found
    return f"{found} (elsewhere for example: {system.refusal.message})"


def _reach(system: ConditionSystem, scan: "Scan") -> tuple[str, bool]:
    """(from where to where the sides of an equation go, does that hold what is asked for?)"""
    pairs = [system.measured([x])[0][0] for x, _ in scan.defined()]
    left, right = zip(*pairs, strict=True)
    condition, tried = system.conditions[0], _tried(system, scan)
    for side, values, other in ((condition.left, left, right), (condition.right, right, left)):
        if min(other) == max(other):
            low, high = _figure(min(values)), _figure(max(values))
            within = min(values) <= other[0] <= max(values)
            return f"{side.text} " + (f"is {low} {tried}" if low == high else f"ranges from {low} to {high} {tried}" + (
                ", and jumps over this" * within)), within
    senses = {misfit(pair, 0.0) > 0 for pair in pairs}
    if len(senses) > 1:
        return f"{condition.left.text} jumps from one side of {condition.right.text} to the other {tried}", True
    sense = "larger" if senses == {True} else "smaller"
    return f"{condition.left.text} is {sense} than {condition.right.text} {tried}", False


def _figure(value: float) -> str:
    return figure(value, digits=4)


def _within(system: ConditionSystem, span: "Range") -> str:
    """The admissible range in words."""
    unit = units.text(system.problem.spec.dimensions.of(system.names[0]))

    def end(x: float) -> str:
        known = {0.0: "0", inf: "∞", -inf: "−∞", pi: "π", -pi: "−π", tau: "2π"}
        return known.get(x) or f"{figure(x)} {unit}".strip()

    if (span.low, span.high) == (-inf, inf):
        return "of either sign"
    left, right = "[" if span.low_given else "(", "]" if span.high_given else ")"
    return f"in {left}{end(span.low)}, {end(span.high)}{right}"


def not_admissible(problem: "Problem", name: str, node: "Node", value: "Fraction", span: "Range") -> PhysicsError:
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


def unbalanced(problem: "Problem", instance: Any, pairs: Sequence[tuple[float, float]]) -> PhysicsError:
    """Conditions of equilibrium that are left over, at the values that the other conditions ask for."""
    names = [name for name, record in problem.spec.choices.items() if record["so"].is_balance]
    errors = [abs(misfit(pair, 0.0)) for pair in pairs]
    i = errors.index(max(errors))
    left = pairs[i][0] - pairs[i][1]
    coordinate = instance.scene.coordinates[i]
    others = [_valued(problem, name, instance.numeric.floats[name])
              for name in problem.spec.choices if name not in names]
    given = f"with {listed(others)}, as is chosen, " if others else ""
    return PhysicsError(f"{given}no value of {listed(names)} makes the drawn position an equilibrium: the condition "
                        f"for '{coordinate}' is left with {figure(left)}",
                        "choose as many parameters as there are conditions, or draw the position of equilibrium",
                        problem.spec.choices[names[0]].where)


def _valued(problem: "Problem", name: str, value: float) -> str:
    return f"{name} = {figure(value)} {units.text(problem.spec.dimensions.of(name))}".rstrip()


def no_closed_form(problem: "Problem") -> PhysicsError:
    hint = "give the other parameters values in the file or with --set: then it is found in numbers"
    return PhysicsError(f"no closed form of {listed(problem.spec.choices)} was found",
                        f"{hint}; {longer(problem.work)}" if problem.work.cut else hint, _where(problem))


def never_in_letters(problem: "Problem") -> PhysicsError:
    return PhysicsError(f"no admissible value of {listed(problem.spec.choices)} was found that gives {texts(problem)}, "
                        "at any of the values of the letters that were tried",
                        "give the other parameters values with --set, to see what is possible", _where(problem))
