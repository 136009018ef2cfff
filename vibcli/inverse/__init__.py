"""Inverse questions: the parameters that a scene chooses, and the scene with them.

    settled(problem)      the problem with values for its chosen parameters; its `chosen` says which, and how well

Parameters chosen for equilibrium are solved for first, in letters, where its conditions are linear in them; the rest
in letters where the conditions are known in letters, and by a search over the admissible range. Every solution is
substituted into a scene built anew; solutions of scenes with letters at several values of these.
"""

from fractions import Fraction
from itertools import islice

from vibcli.algebra.calculus import substitute
from vibcli.algebra.normal import textbook
from vibcli.analyses.solving import depends
from vibcli.draws import drawn
from vibcli.elements.choose import BALANCE
from vibcli.errors import PhysicsError, SpecError
from vibcli.inverse import refusals
from vibcli.inverse.letters import balanced, candidates
from vibcli.inverse.search import solve
from vibcli.inverse.solution import Chosen, Solution, choosing, defined, in_numbers, stable_in_floats
from vibcli.inverse.system import HOLDS, System, balance, misfit

TRIALS, ENOUGH = 12, 3


def settled(problem, thorough=False):
    """The problem with the first solution for its chosen parameters; itself where nothing is chosen.

    `thorough`: SymPy may look for closed forms that the project's own algebra does not find.
    """
    if not problem.spec.choices or problem.chosen is not None:
        return problem
    rest = _balanced_first(problem)
    if problem.letters:
        return _in_letters(problem, rest)
    return _in_numbers(problem, rest, thorough)


def _balanced_first(problem):
    """The problem with the parameters chosen for equilibrium defined in letters, where that is possible."""
    if not any(record["so"].word == BALANCE for record in problem.spec.choices.values()):
        return problem
    if all(node.is_zero for terms in problem.drawn_residual for node in terms):
        raise refusals.undetermined(problem)
    forms = balanced(problem)
    found = defined(problem, forms) if forms is not None else None
    left = {name: record for name, record in problem.spec.choices.items() if name not in (forms or ())}
    return problem if found is None else choosing(found, left)


def _in_numbers(problem, rest, thorough):
    system, solutions, refusal = System(problem), [], None
    found = solve(rest, thorough, system.limits) if rest.spec.choices else [((), ())]
    for values, nodes in found:
        everything = _all_values(problem, rest, values)
        try:
            solutions.append(_tried(problem, system, everything, _forms(problem, rest, nodes)))
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
    return _chosen(system.numeric(list(first.values.values())) if found is None else found, problem, solutions)


def _chosen(found, problem, solutions):
    found.costs, found.end = problem.costs, problem.end
    found.chosen = Chosen(problem.spec.choices, solutions)
    return found


def _held(problem, rest):
    """{name: definition} of the parameters that equilibrium determined, in the letters of `rest`."""
    return {name: rest.scene.parameters.definitions[name] for name in problem.spec.choices
            if name not in rest.spec.choices}


def _all_values(problem, rest, values):
    """{name: Fraction} of the parameters found and of those that they define."""
    found = {name: Fraction(value) for name, value in zip(rest.spec.choices, values, strict=True)}
    held = _held(problem, rest)
    numbers = in_numbers(rest.sharing(found), list(held.values()))
    if numbers is None:
        raise refusals.none_found(System(problem), None)
    return {**found, **dict(zip(held, numbers, strict=True))}


def _forms(problem, rest, nodes):
    """{name: closed form or None} of the parameters found and of those that they define."""
    symbols = rest.scene.parameters.nodes
    held = {symbols[name]: node for name, node in _held(problem, rest).items()}
    found = {symbols[name]: node for name, node in zip(rest.spec.choices, nodes, strict=True) if node is not None}
    unknown = [symbols[name] for name in rest.spec.choices if symbols[name] not in found]
    held = dict(zip(held, substitute(list(held.values()), found), strict=True))
    found = dict(zip(found, substitute(list(found.values()), held), strict=True))
    forms = {node.name: textbook(form) for node, form in {**found, **held}.items()}
    known = {name: form for name, form in forms.items() if not depends(form, unknown)}
    return {name: known.get(name) for name in problem.spec.choices}


def _tried(problem, system, values, forms):
    """The Solution of these values, tried by substitution; PhysicsError where they do not hold after all."""
    in_order = [values[name] for name in system.names]
    for name, value, span in zip(system.names, in_order, system.ranges, strict=True):
        if not span.holds(value):
            raise refusals.not_admissible(problem, name, forms[name], value, span)
    system.settle_about(in_order)
    good, residual = system.holds(in_order)
    if not good:
        numeric = system.numeric(in_order)
        pairs = balance(numeric)
        if any(c.word == BALANCE for c in system.conditions) and any(abs(misfit(pair, 0.0)) > HOLDS for pair in pairs):
            raise refusals.unbalanced(problem, numeric, pairs)
        raise refusals.none_found(system, None)
    limit = system.limit(in_order)
    return Solution(dict(zip(system.names, in_order, strict=True)), forms, residual, limit is not None and limit.fold)


def _in_letters(problem, rest):
    found = candidates(rest, True) if rest.spec.choices else None
    if rest.spec.choices and (found is None or not (found.tuples or found.always)):
        raise refusals.no_closed_form(problem)
    if found is not None and found.always:
        raise refusals.undetermined(rest)
    everywhere = [_forms(problem, rest, nodes) for nodes in (found.tuples if found else [()])]
    tried, refusal = {}, None
    for number, draw in enumerate(islice(drawn(problem), TRIALS)):
        for i, forms in enumerate(everywhere):
            values = in_numbers(rest.with_values(draw.given), list(forms.values()))
            try:
                if values is not None:
                    solution = _tried(draw, System(draw), dict(zip(forms, values, strict=True)), forms)
                    tried.setdefault(i, []).append((number, solution))
            except (PhysicsError, SpecError) as error:
                refusal = refusal or error
        if tried and max(map(len, tried.values())) >= ENOUGH:
            break
    if not tried:
        raise refusals.never_in_letters(problem) if refusal is None or len(everywhere) > 1 else refusal
    return _with_letters(problem, [everywhere[i] for i in _ascending(tried)],
                         [tried[i] for i in _ascending(tried)])


def _ascending(tried):
    """The numbers of the solutions, those first that hold at the first draw, by their values there."""
    return sorted(tried, key=lambda i: (tried[i][0][0], list(tried[i][0][1].values.values())))


def _with_letters(problem, forms, tried):
    solutions = [Solution(dict.fromkeys(form), {name: form[name] for name in problem.spec.choices},
                          max(solution.residual for _, solution in trials))
                 for form, trials in zip(forms, tried, strict=True)]
    found = defined(problem, solutions[0].forms)
    if found is None:
        raise refusals.no_closed_form(problem)
    return _chosen(found, problem, solutions)
