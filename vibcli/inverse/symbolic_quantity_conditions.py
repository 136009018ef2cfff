"""Quantities in letters, as sides of conditions: omega[1] of one degree, K[x, x], equilibrium[s.stretch], J[disc], and
amplitudes of responses: amplitude(x), abs(frf[x, F](Ω)), transmissibility[x, base](Ω)."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.quantities.cycle_count import counts_cycles
from vibcli.quantities.expression import lowered
from vibcli.quantities.quantity import OF_STATE, about_which, declared
from vibcli.symbolic.equations.univariate import polynomial
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import Call, NameRef, QuantityRef, parts_of
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


def quantity_in_letters(problem: "Problem", tree: QuantityRef) -> "Node":
    """A quantity as an expression of the parameters; NotInLetters where it is found in numbers."""
    response = response_of(problem, tree)
    if response is not None:
        return size_of(problem, response)
    quantity = declared(tree)
    known = quantity is not None and quantity.symbolic is not None and quantity.kind not in OF_STATE
    if not known or about_which(tree)[1] is not None:
        raise NotInLetters(f"'{tree.text}' is found in numbers")
    return quantity.symbolic(problem, tree)


def response_of(problem: Any, tree: Any) -> "Formula | None":
    """The Formula of amplitude(x), abs(frf[…](…)) or transmissibility[…](…); None of another tree."""
    asked = tree.head if isinstance(tree, QuantityRef) else None
    if isinstance(tree, Call) and tree.name == "abs" and getattr(tree.args[0], "head", None) == "frf":
        tree = tree.args[0]
    elif asked == "amplitude":
        return _steady(problem, tree.args[0])
    elif asked != "transmissibility":
        return None
    return problem.symbolic_frequency_response(*tree.indices, _frequency(problem, tree.args[0]))


def _steady(problem, signal):
    if not isinstance(signal, NameRef):
        raise NotInLetters("amplitudes of sums and products are found in numbers")
    return problem.symbolic_steady_state(signal.name + "'" * signal.primes).formula


def _frequency(problem, tree):
    """The angular frequency at which a response is asked for, as a node of the scene."""
    if parts_of(tree).quantities:
        raise NotInLetters("a response at such a frequency is found in numbers")
    scene = problem.scene
    node = lower(tree, scene.table, lambda name, primes, part: scene.parameters.nodes[name])
    return node * 2 * scene.table.pi if counts_cycles(problem.spec, tree) else node


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


def size_of(problem: "Problem", response: "Formula"):
    """|H| as an expression."""
    table = problem.scene.table
    size, = copied([response.amplitude], table)
    return size if table.is_positive(size) else table.call("abs", size)


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
