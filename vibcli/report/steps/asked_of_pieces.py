"""What is asked of a motion that lines tell as the sum of what pieces of a load bring about, and of signals that follow
it: values at an instant, and in numbers the largest and the smallest, where a search finds that ṡ(t) = 0."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.mechanics.symbolic_linear import outputs
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.responses_in_letters import at_rest
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.instances import instances
from vibcli.report.steps.motion_by_pieces import LATE
from vibcli.report.steps.parts_of_a_turn import shortest
from vibcli.report.steps.searched_extremes import INSTANTS, tell_searched
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.parser import VALUE
from vibcli.symbolic.semantics import lower, lower_measured
from vibcli.symbolic.syntax import NameRef, parts_of
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

SHORT = 12          # letters of a value that is told as it is


def tell_of_pieces(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is it written down by these lines?"""
    tree = asked.tree
    if set(sheet.by_pieces) != set(problem.scene.coordinates) or not tree.args:
        return False
    signal, lines = _Signal(problem, sheet, tree.args[0]), [motion.line for motion in sheet.by_pieces.values()]
    if tree.head == VALUE and not parts_of(tree.args[1]).quantities:
        return tell_found(problem, sheet, asked, _at_instant(problem, sheet, signal, tree.args[1]), lines)
    if tree.head == "final" and signal.alone:
        return tell_found(problem, sheet, asked, _final(signal), lines)
    if tree.head not in INSTANTS:
        return False
    if problem.numeric.has_free_symbols:
        return tell_found(problem, sheet, asked, _by_coordinate(signal), [sheet.last]) if signal.alone else False
    return tell_searched(problem, sheet, asked, signal.value, signal.told, lines)


def _at_instant(problem: "Problem", sheet: WorkedSolution, signal: "_Signal",
                tree: Any) -> "Iterator[tuple[Node, list[Any]]]":
    """The value by the pieces that have begun, in letters by its simplest form as well."""
    t = lower_measured(tree, problem.scene.table, lambda name, *_: problem.scene.parameters.nodes[name])
    if t.op == "number" and not t.is_zero and problem.numeric.has_free_symbols:
        return      # its unit would not stand beside letters
    at, = evaluate([t], Floats, signal.known)
    node = signal.value(t, at)
    shown, simple = signal.told(t, at, node), shortest(problem, sheet, node)
    if simple is not node:
        yield simple, [*shown, " = ", simple] if shown != [node] else [simple]
    yield node, shown


class _Signal:
    """A function of signals that follow coordinates which move by pieces."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution, tree: Any) -> None:
        self.problem, self.sheet, self.tree, self.table = problem, sheet, tree, problem.scene.table
        self.names, self.time = problem.scene.coordinates, problem.scene.time
        self.known = next(instances(problem, sheet), ({}, {}))[1]

    @property
    def alone(self) -> bool:
        """Is it one signal of a scene with one coordinate?"""
        return len(self.names) == 1 and isinstance(self.tree, NameRef)

    def value(self, t: "Node", at: float) -> "Node":
        """At an instant, which is `at` in numbers."""
        def signal(name: str, primes: int, part: NameRef) -> "Node":
            if not isinstance(part, NameRef):
                raise NotInLetters("parts of signals are found in numbers")
            if name in self.problem.scene.parameters.nodes and not primes:
                return self.problem.scene.parameters.nodes[name]
            rows, fixed = self.parts(name, primes, t, at)
            return fixed + self.table.total([factor * self._moved(*key, t, at) for key, factor in rows.items()])

        return lower(self.tree, self.table, signal)

    def _moved(self, name: str, order: int, t: "Node", at: float) -> "Node":
        motion = self.sheet.by_pieces[name]
        return motion.value(motion.begun(at, self.known), t, self.time, order)

    def told(self, t: "Node", at: float, node: "Node") -> list[Any]:
        """Parts of that: by the names of unit responses that of a coordinate, by coordinates that of another where its
        own expression is longer."""
        if not isinstance(self.tree, NameRef) or letters(node) <= SHORT:
            return [node]
        name, primes = self.tree.name, self.tree.primes
        if name in self.names:
            motion = self.sheet.by_pieces[name]
            return motion.told(motion.begun(at, self.known), t, primes)
        rows, fixed = self.parts(name, primes, t, at)
        parts: list[Any] = [] if fixed.is_zero else [fixed]
        for (coordinate, order), row in rows.items():
            negative = row.op != "sum" and row.coefficient < 0
            size, sign = -row if negative else row, " − " if negative else " + "
            parts += [sign if parts else "−" * negative, *([Factor(size), "·"] if size is not self.table.one else []),
                      Name(coordinate + "'" * order), "(", t, ")"]
        return [part for part in parts if part != ""]

    def parts(self, name: str, primes: int, t: "Node", at: float) -> "tuple[dict[tuple[str, int], Node], Node]":
        """({(coordinate, order of its rate): its factor}, what it is beside) of a signal."""
        rest = self._rest(name, primes)
        if name in self.names:
            return {(name, primes): self.table.one}, rest
        rows, direct = outputs(self.problem.symbolic, name + "'" * primes)
        beside = rest + direct
        calls = [part for part in reachable([beside]) if part.op == "call" and part.name in PULSES]
        if any(call.name not in ("step", "ramp") for call in calls):
            raise NotInLetters("this signal is driven by what has no value")
        taken = evaluate([call.args[0] for call in calls], Floats, {**self.known, self.time.name: at})
        put_in = {call: self.table.zero if late <= LATE * abs(at) else self.table.one if call.name == "step"
                  else call.args[0] for call, late in zip(calls, taken, strict=True)}
        fixed, = substitute(substitute([beside], put_in), {self.time: t})
        return {(self.names[i], order): copied([node], self.table)[0] for order, row in enumerate(rows)
                for i, node in row.items()}, textbook(fixed)

    def _rest(self, name: str, primes: int) -> "Node":
        """In equilibrium; by the letter of a line where a search found it."""
        line = next((line for line in self.sheet.steps if line.settles == f"equilibrium[{name}]" and line.letter), None)
        if line is not None and not primes:
            return self.table.parameter(line.letter, positive=False)
        return at_rest(self.problem, name, primes)

    def of_one(self) -> "tuple[Node, Node] | None":
        """(its factor of the only coordinate, what it is beside); None of one that follows the speed, or the time."""
        rows, fixed = self.parts(self.tree.name, self.tree.primes, self.time, 0.0)
        return (rows[self.names[0], 0], fixed) if list(rows) == [(self.names[0], 0)] and not fixed.mask else None


def _final(signal: _Signal) -> "Iterator[tuple[Node, list[Any]]]":
    """The limit of a signal, where the coordinate settles."""
    found, settles = signal.of_one(), signal.sheet.by_pieces[signal.names[0]].settles
    if found is not None and settles is not None:
        node = textbook(found[1] + found[0] * settles)
        yield node, [node]


def _by_coordinate(signal: _Signal) -> "Iterator[tuple[Node, list[Any]]]":
    """The extremes of a signal that is proportional to the coordinate, beside what is fixed, by those of that."""
    found, (name, *_) = signal.of_one(), signal.names
    for line in signal.sheet.steps if found is not None else ():
        if line.settles in (f"max({name})", f"min({name})") and line.node is not None:
            factor, fixed = found
            negative = factor.op != "sum" and factor.coefficient < 0
            before = ["−"] * negative if fixed.is_zero else [fixed, " − " if negative else " + "]
            node = textbook(fixed + factor * line.node)
            yield node, [*before, Factor(-factor if negative else factor), "·", Words(as_printed(
                line.settles, {name})), " = ", node]
