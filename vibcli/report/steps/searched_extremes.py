"""Extremes of signals whose motion lines tell as functions of the time: a search finds the instant at which ṡ(t) = 0,
and the motion how far it goes there."""

from collections.abc import Callable, Sequence
from itertools import count
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import measure
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.instances import instances
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

INSTANTS = {"max": "argmax", "min": "argmin", "argmax": "argmax", "argmin": "argmin"}
TURN = "turning back at"
STILL = 1e-6        # relative: of an instant that a search found, and of that where the rate vanishes


def tell_searched(problem: "Problem", sheet: WorkedSolution, asked: "Expression",
                  value: "Callable[[Node, float], Node]", told: "Callable[[Node, float, Node], Sequence[Any]]",
                  uses: "Sequence[int]") -> bool:
    """Is an extreme told so? value(t, at): of the signal at an instant, which is `at` in numbers; told(t, at, node):
    parts that say it."""
    tree = asked.tree
    try:
        letter, at = _turn(problem, sheet, tree, value, uses)
        node = letter if tree.head in INSTANTS.values() else value(letter, at)
        shown = [node] if node is letter else told(letter, at, node)
    except PhysicsError:
        return False
    return tell_found(problem, sheet, asked, [(node, shown)], [sheet.last])


def _turn(problem: "Problem", sheet: WorkedSolution, tree: "QuantityRef", value: "Callable[[Node, float], Node]",
          uses: Sequence[int]) -> "tuple[Node, float]":
    """The letter of the instant, written down once, and it in numbers; NotInLetters where the signal does not turn
    back there."""
    known, table = next(instances(problem, sheet))[1], problem.scene.table
    at = float(measure(problem, tree._replace(head=INSTANTS[tree.head]))[0])
    time, zero = problem.scene.time, table.zero
    rate = gradient(value(time, at)).get(time, zero)
    speed, bent = evaluate([rate, gradient(rate).get(time, zero)], Floats, {**known, time.name: at})
    if not abs(speed) <= STILL * abs(bent * at):
        raise NotInLetters("this signal does not turn back there")
    turns = [one for one in sheet.steps if one.settles.startswith(TURN)]
    line = next((one for one in turns if abs(one.value - at) <= STILL * at), None)
    if line is not None:
        return table.parameter(line.letter), at
    taken = {one.letter for one in sheet.steps}
    name = next(name for n in count(1) for name in [sheet.letter(f"t{n}")] if name not in taken)
    letter = table.parameter(name)
    sheet.write(*_rate_told(problem, tree), " = 0", Words(" at  "), letter, *number(at, "s"), Words(
        "  (by a search)"), letter=name, settles=f"{TURN} {name}", value=at, unit="s", uses=uses, opens=True,
        vanishes=substitute([rate], {time: letter})[0])
    return letter, at


def _rate_told(problem: "Problem", tree: "QuantityRef") -> list[Name | Words]:
    signal = tree.args[0]
    if not isinstance(signal, NameRef):
        written = tree.text[signal.start - tree.start:signal.end - tree.start]
        return [Words(f"the rate of {as_printed(written)}")]
    name = signal.name + "'" * signal.primes
    own = signal.name in problem.scene.coordinates
    return [Name(name + "'")] if own else [Words(f"the rate of {as_printed(name)}")]
