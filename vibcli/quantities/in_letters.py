"""Quantities in letters: omega[1] of one degree, K[x, x], equilibrium[s.stretch], J[disc], and amplitudes of responses:
amplitude(x), abs(frf[x, F](Ω)), transmissibility[x, base](Ω)."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.quantities.cycle_count import counts_cycles
from vibcli.quantities.quantity import OF_STATE, about_which, declared
from vibcli.symbolic.semantics import lower_measured
from vibcli.symbolic.syntax import Call, NameRef, QuantityRef, parts_of
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.frequency_response import Formula
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def quantity_in_letters(problem: "Problem", tree: Any) -> "Node":
    """A quantity as an expression of the parameters; NotInLetters where it is found in numbers."""
    response = response_of(problem, tree)
    if response is not None:
        return size_of(problem, response)
    if not isinstance(tree, QuantityRef):
        raise NotInLetters("expressions of quantities are found in numbers")
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
    found: Formula | None = problem.symbolic_frequency_response(*tree.indices, frequency_of(problem, tree.args[0]))
    return found


def _steady(problem: "Problem", signal: NameRef | str) -> "Formula":
    asked = signal.name + "'" * signal.primes if isinstance(signal, NameRef) else signal
    found: Formula = problem.symbolic_steady_state(asked).formula
    return found


def frequency_of(problem: "Problem", tree: Any) -> "Node":
    """The angular frequency at which a response is asked for, as a node of the scene."""
    if parts_of(tree).quantities:
        raise NotInLetters("a response at such a frequency is found in numbers")
    scene = problem.scene
    node = lower_measured(tree, scene.table, lambda name, primes, part: scene.parameters.nodes[name])
    return node * 2 * scene.table.pi if counts_cycles(problem.spec, tree) else node


def size_of(problem: "Problem", response: "Formula") -> "Node":
    """|H| as an expression."""
    table = problem.scene.table
    size, = copied([response.amplitude], table)
    return size if table.is_positive(size) else table.call("abs", size)
