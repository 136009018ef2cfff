"""Quantities in letters, as sides of conditions: omega[1] of one degree, K[x, x], equilibrium[s.stretch], J[disc]."""

from vibcli.base.errors import NotInLetters
from vibcli.inverse.symbolic_response_conditions import response_of, size_of
from vibcli.quantities.expression import lowered
from vibcli.quantities.quantity import OF_STATE, declared
from vibcli.symbolic.semantics import quantities_in
from vibcli.symbolic.syntax import QuantityRef


def side(problem, expression):
    """A side of a condition as an expression of the parameters."""
    scene = problem.scene
    found = {tree.text: quantity_in_letters(problem, tree) for tree in quantities_in(expression.tree)}
    return lowered(expression, scene.table, lambda name, primes, tree: found[name] if isinstance(tree, QuantityRef)
                   else scene.parameters.nodes[name])


def quantity_in_letters(problem, tree):
    """A quantity as an expression of the parameters; NotInLetters where it is found in numbers."""
    response = response_of(problem, tree)
    if response is not None:
        return size_of(problem, response)
    quantity = declared(tree)
    known = quantity is not None and quantity.symbolic is not None and quantity.kind not in OF_STATE
    if not known or len(tree.indices) > len(quantity.indices):
        raise NotInLetters(f"'{tree.text}' is found in numbers")
    return quantity.symbolic(problem, tree)
