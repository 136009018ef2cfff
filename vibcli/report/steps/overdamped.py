"""The roots s₁, s₂ = −δ ± √(δ² − ω²) of an over-damped motion x = A e^{s₁t} + B e^{s₂t}, where it passes zero, and
where it, or its speed, turns back: the n-th rate of change vanishes at

    t = ln(−B s₂ⁿ/(A s₁ⁿ))/(s₁ − s₂)."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

EXTREMES, INSTANTS = ("max", "min"), ("argmax", "argmin")


def tell_root(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is a real root of one degree of freedom, eigenvalue[1, 2], written down by the letters of its damping?"""
    tree, table = asked.tree, problem.scene.table
    names = [sheet.letter(letter) for letter in ("delta", "omega")]
    told = {line.letter: line.number for line in sheet.steps if line.letter}
    if tree.head != "eigenvalue" or len(tree.indices) != 2 or len(problem.scene.q) != 1:
        return False
    if not told.keys() >= set(names):
        return False
    delta, omega = map(table.parameter, names)
    spread = table.sqrt(delta ** 2 - omega ** 2)
    return tell_found(problem, sheet, asked, [(node, [node]) for node in (spread - delta, -spread - delta)],
                      [told[name] for name in names])


def tell_of_overdamped(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked of such a motion written down?"""
    tree, names = asked.tree, problem.scene.coordinates
    of_one = len(names) == 1 and tree.args and isinstance(tree.args[0], NameRef) and tree.args[0].name == names[0]
    letters = [sheet.letter(letter) for letter in ("s1", "s2", "A", "B")] if of_one else []
    told = {line.letter: line.number for line in sheet.steps if line.letter}
    if not letters or not told.keys() >= set(letters):
        return False
    forms = ((node, [node]) for node in _forms(tree, *map(problem.scene.table.parameter, letters)))
    return tell_found(problem, sheet, asked, forms, [told[letter] for letter in letters[1:]])


def _forms(tree: Any, s1: "Node", s2: "Node", A: "Node", B: "Node") -> "Iterator[Node]":
    primes, table = tree.args[0].primes, s1.table

    def vanishes(n: int) -> "Node":
        return table.call("log", -(B * s2 ** n / (A * s1 ** n))) / (s1 - s2)

    if tree.head == "zero" and tree.indices == ("1",):
        yield vanishes(primes)
    if tree.head in INSTANTS:
        yield vanishes(primes + 1)
    if tree.head in EXTREMES:
        t = vanishes(primes + 1)
        yield A * s1 ** primes * table.call("exp", s1 * t) + B * s2 ** primes * table.call("exp", s2 * t)
