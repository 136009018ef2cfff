"""Solutions tried by substitution: the closed forms of all that is chosen, and whether the conditions hold there."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.inverse import infeasible
from vibcli.inverse.conditions import HOLDS, balance, misfit
from vibcli.inverse.solution import Solution
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.equations.univariate import depends
from vibcli.symbolic.expression_graph import called_functions
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def held_by_balance(problem: "Problem", rest: "Problem") -> "dict[str, Node]":
    """{name: definition} of the parameters that equilibrium determined, in the letters of `rest`."""
    return {name: rest.scene.parameters.definitions[name] for name in problem.spec.choices
            if name not in rest.spec.choices}


def forms_of(problem: "Problem", rest: "Problem", nodes: "Sequence[Node | None]") -> "dict[str, Node | None]":
    """{name: closed form or None} of the parameters found and of those that they define."""
    symbols = rest.scene.parameters.nodes
    held = {symbols[name]: node for name, node in held_by_balance(problem, rest).items()}
    found = {symbols[name]: node for name, node in zip(rest.spec.choices, nodes, strict=True) if node is not None}
    unknown = [symbols[name] for name in rest.spec.choices if symbols[name] not in found]
    held = dict(zip(held, substitute(list(held.values()), found), strict=True))
    found = dict(zip(found, substitute(list(found.values()), held), strict=True))
    forms = {node.name: textbook(form) for node, form in {**found, **held}.items()}
    known = {name: form for name, form in forms.items() if not (depends(form, unknown) or called_functions([form]))}
    return {name: known.get(name) for name in problem.spec.choices}


def tried(problem: "Problem", system: Any, values: "Mapping[str, Fraction]", forms: Any) -> Solution:
    """The Solution of these values, tried by substitution; PhysicsError where they do not hold after all."""
    in_order = [values[name] for name in system.names]
    for name, value, span in zip(system.names, in_order, system.ranges, strict=True):
        if not span.holds(value):
            raise infeasible.not_admissible(problem, name, forms[name], value, span)
    system.settle_scales([[float(x) * factor for x in in_order] for factor in (0.4, 0.9, 1.7)])
    good, residual = system.holds(in_order)
    if not good:
        instance = system.instance(in_order)
        pairs = balance(instance)
        if any(c.is_balance for c in system.conditions) and any(abs(misfit(pair, 0.0)) > HOLDS for pair in pairs):
            raise infeasible.unbalanced(problem, instance, pairs)
        raise infeasible.not_held(system)
    limit = system.limit(in_order)
    return Solution(dict(zip(system.names, in_order, strict=True)), forms, residual, limit is not None and limit.fold)
