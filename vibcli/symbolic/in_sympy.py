"""Expressions handed over to SymPy: coordinates as functions of t, their rates as derivatives."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.symbolic.evaluation import evaluate, sympy_arithmetic
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    import sympy

    from vibcli.symbolic.node import Node


def in_sympy(nodes: "Sequence[Node]", moving: Sequence[str] = ()) -> "list[sympy.Expr]":
    """SymPy expressions of nodes of one table; names in `moving` are functions of the time t. Parameters are positive
    where the scene has them so."""
    import sympy

    time = next((node.table.time for node in nodes), None)
    t = sympy.Symbol("t" if time is None else time.name)

    def symbol(node: "Node") -> "sympy.Expr":
        name = node.name.rstrip("'")
        if name in moving:
            function = sympy.Function(name)(t)
            primes = len(node.name) - len(name)
            return sympy.Derivative(function, (t, primes)) if primes else function
        if node is time:
            return t
        return sympy.Symbol(name, positive=True) if node.table.is_positive(node) else sympy.Symbol(name, real=True)

    symbols = {node.name: symbol(node) for node in reachable(nodes) if node.op == "symbol"}
    return evaluate(nodes, sympy_arithmetic(), symbols)


def equation_in_sympy(sides: "Sequence[Node]", moving: Sequence[str] = ()) -> "sympy.Basic":
    """The SymPy equation of two nodes."""
    import sympy

    return sympy.Eq(*in_sympy(list(sides), moving), evaluate=False)
