"""Inverse questions: the parameters that a scene chooses, and the scene with them.

    settled(problem)      the problem with values for its chosen parameters; its `chosen` says which, and how well

Parameters chosen for equilibrium are solved for first, in letters, where its conditions are linear in them; the rest
in letters where the conditions are known in letters, and by a search over the admissible range. Every solution is
substituted into a scene built anew; solutions of scenes with letters at several values of these.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.enumeration import listed
from vibcli.base.errors import PhysicsError
from vibcli.inverse import infeasible
from vibcli.inverse.conditions import ConditionSystem
from vibcli.inverse.search import solve
from vibcli.inverse.solution import Chosen, choosing, defined, in_numbers, stable_in_floats
from vibcli.inverse.solution_errors import SearchedNumbers
from vibcli.inverse.substitution import forms_of, held_by_balance, tried
from vibcli.inverse.symbolic_conditions import balanced

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

MOST = 30_000       # places at which the scene is looked at, and steps of its motions there


def settled(problem: "Problem", thorough: bool = False) -> "Problem":
    """The problem with the first solution for its chosen parameters; itself where nothing is chosen. `thorough`: SymPy
    may look for closed forms that the project's own algebra does not find."""
    if not problem.spec.choices or problem.choice is not None:
        return problem
    rest = _balanced_first(problem)
    if problem.symbolic.letters:
        from vibcli.inverse.symbolic_solutions import solved

        with problem.work.task("the search for closed forms"):
            return solved(problem, rest)
    return _in_numbers(problem, rest, thorough)


def _balanced_first(problem: "Problem") -> "Problem":
    """The problem with the parameters chosen for equilibrium defined in letters, where that is possible."""
    if not any(record["so"].is_balance for record in problem.spec.choices.values()):
        return problem
    if all(node.is_zero for terms in problem.system.drawn_residual for node in terms):
        raise infeasible.undetermined(problem)
    forms = balanced(problem)
    found = defined(problem, forms) if forms is not None else None
    left = {name: record for name, record in problem.spec.choices.items() if name not in (forms or ())}
    return problem if found is None else choosing(found, left)


def _in_numbers(problem: "Problem", rest: "Problem", thorough: bool) -> "Problem":
    system, solutions, refusal = ConditionSystem(problem), [], None
    searched = system if rest is problem else ConditionSystem(rest, system.limits)
    with problem.work.task(f"the search for {listed(problem.spec.choices)}", MOST):
        found = solve(searched, thorough) if rest.spec.choices else [((), ())]
    for values, nodes in found:
        everything = _all_values(problem, rest, values)
        try:
            solutions.append(tried(problem, system, everything, forms_of(problem, rest, nodes)))
        except PhysicsError as error:
            refusal = refusal or error
    if not solutions:
        raise refusal
    first = solutions[0]
    found = None
    if all(form is not None for form in first.forms.values()):
        nodes = list(first.forms.values())
        if not system.limits and stable_in_floats(rest, nodes, [first.values[name] for name in first.forms]):
            found = defined(problem, first.forms)
    if found is None:
        found = system.substituted(list(first.values.values()))[0]
    searched = [SearchedNumbers(system, list(one.values.values())) for one in solutions]
    return found.with_choice(Chosen(problem.spec.choices, solutions, searched=searched), problem)


def _all_values(problem: "Problem", rest: "Problem", values: Sequence[Fraction]) -> dict[str, Fraction]:
    """{name: Fraction} of the parameters found and of those that they define."""
    found = {name: Fraction(value) for name, value in zip(rest.spec.choices, values, strict=True)}
    held = held_by_balance(problem, rest)
    numbers = in_numbers(rest.sharing(found), list(held.values()))
    if numbers is None:
        raise infeasible.not_held(ConditionSystem(problem))
    return {**found, **dict(zip(held, numbers, strict=True))}
