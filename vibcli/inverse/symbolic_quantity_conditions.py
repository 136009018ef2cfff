"""Conditions on quantities in letters: their sides, responses of a given size, fixed points equally high."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.quantities.expression import lowered
from vibcli.quantities.in_letters import quantity_in_letters
from vibcli.symbolic.equations.univariate import polynomial
from vibcli.symbolic.syntax import QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.frequency_response import Formula
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def side(problem: "Problem", expression: "Expression") -> "Node":
    """A side of a condition as an expression of the parameters."""
    scene = problem.scene
    found = {tree.text: quantity_in_letters(problem, tree) for tree in expression.parts.quantities}
    return lowered(expression, scene.table, lambda name, primes, tree: found[name] if isinstance(tree, QuantityRef)
                   else scene.parameters.nodes[name])


def response_is(problem: "Problem", response: "Formula", value: "Node") -> "list[Node]":
    """[expression] that vanishes where |H| has a value: the parts of N where that is 0, else |N|² − value² |D|², in
    factors where there is no damping."""
    table = problem.scene.table
    if value.is_zero:
        return [part for part in copied(list(response.numerator), table) if not part.is_zero]
    if response.undamped:
        above, below = copied([response.scale * response.numerator[0], response.denominator[0]], table)
        return [(above - value * below) * (above + value * below)]
    above, below = copied(response.square, table)
    return [above - value * value * below]


def equal_heights(problem: "Problem", one: Any, other: Any) -> "Node | None":
    """An expression that vanishes where the fixed points 1 and 2 of the only damper are equally high; None of another
    condition.

    With H = (N_r + iΩ N_i)/(D_r + iΩ D_i) they are the roots of N_r D_i + N_i D_r = a Ω⁴ + b Ω² + e, of heights
    |N_i/D_i|: for D_i/N_i = α + βΩ² these are equal where α + βΩ² has opposite values, 2αa = βb.
    """
    if not all(isinstance(tree, QuantityRef) and (tree.head, tree.component) == ("fixed_point", "value")
               for tree in (one, other)):
        return None
    damper, curve = one.indices[1], one.args[0].indices
    if {one.indices[0], other.indices[0]} != {"1", "2"} or (other.indices[1], other.args[0].indices) != (damper, curve):
        return None
    found = problem.symbolic_frequency_response(*curve)
    (a, b), (c, d) = found.numerator, found.denominator
    if list(problem.spec.get("dampers")) != [damper] or b.is_zero or d.is_zero:
        raise NotInLetters("these fixed points are found in numbers")
    heights, places = polynomial(d / b, found.Omega), polynomial(a * d + b * c, found.Omega)
    if heights is None or places is None or not set(heights) <= {0, 2} or set(places) != {0, 2, 4}:
        raise NotInLetters("these fixed points are found in numbers")
    parts = [heights.get(0, found.table.zero), heights.get(2, found.table.zero), places[4], places[2]]
    alpha, beta, a, b = copied(parts, problem.scene.table)
    return 2 * alpha * a - beta * b
