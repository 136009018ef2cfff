"""Limits, means and root mean squares of signals in letters: behind ramps, and of steady states of one harmonic."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.language.signal_names import signal_name
from vibcli.quantities.quantity import named
from vibcli.results.signal_nodes import node_of_signal
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.syntax import NameRef, QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree

GIVE_NUMBERS = "give numbers with --set"


def final(problem: "Problem", tree: QuantityRef) -> "Node":
    """What of a function of signals is left where all follow loads that are powers of the time."""
    scene = problem.scene

    def signal(name: str, primes: int, part: "SyntaxTree") -> "Node":
        if isinstance(part, QuantityRef):
            raise NotInLetters("limits of parts of signals are found in numbers", GIVE_NUMBERS)
        if name in scene.parameters.nodes and not primes:
            return scene.parameters.nodes[name]
        return at_rest(problem, name, primes) + problem.symbolic_following(name + "'" * primes, alone=True)

    found = textbook(node_of_signal(tree.args[0], scene.table, signal))
    if found.mask & scene.time.mask:
        raise NotInLetters("this signal grows without end: it has no limit", "ask for a difference that has one")
    return found


def at_rest(problem: "Problem", name: str, primes: int) -> "Node":
    """The value of a signal in equilibrium."""
    element, part, *_ = signal_name(name)
    if primes or (part == "force" and element in (problem.spec.get("dampers") or {})):
        return problem.scene.table.zero
    return named("equilibrium").symbolic(problem, QuantityRef(0, 0, "", "equilibrium", (name,), "", ()))


def mean(problem: "Problem", tree: QuantityRef) -> "Node":
    """Of a signal, or of its square."""
    signal = tree.args[0]
    squared = signal.kind == "power" and signal.exponent.kind == "number" and signal.exponent.value == 2
    return _of_one(problem, signal.base if squared else signal)[squared]


def rms(problem: "Problem", tree: QuantityRef) -> "Node":
    return problem.scene.table.sqrt(_of_one(problem, tree.args[0])[1])


def _of_one(problem: "Problem", signal: Any) -> "tuple[Node, Node]":
    """(mean, mean square) of a signal with one harmonic."""
    if not isinstance(signal, NameRef):
        raise NotInLetters("means of sums and products are found in numbers", GIVE_NUMBERS)
    steady, table = problem.symbolic_steady_state(signal.name + "'" * signal.primes), problem.scene.table
    rest = at_rest(problem, signal.name, signal.primes)
    middle = rest if steady.mean is None else rest + copied([steady.mean], table)[0]
    above, below = copied(list(steady.formula.square), table)
    return middle, middle * middle + above / below / 2
