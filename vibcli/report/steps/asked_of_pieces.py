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
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef, parts_of
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Expression
    from vibcli.report.steps.motion_by_pieces import ToldPiece
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

SHORT = 12          # letters of a value that is told as it is


def tell_of_pieces(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is it written down by these lines?"""
    tree = asked.tree
    if sheet.by_pieces is None or not tree.args:
        return False
    if tree.head == VALUE and not parts_of(tree.args[1]).quantities:
        return tell_found(problem, sheet, asked, _at_instant(problem, sheet, tree), [sheet.by_pieces.line])
    if tree.head == "final" and sheet.by_pieces.settles is not None:
        return tell_found(problem, sheet, asked, _final(problem, sheet, tree.args[0]), [sheet.by_pieces.line])
    if tree.head not in INSTANTS:
        return False
    if problem.numeric.has_free_symbols:
        return tell_found(problem, sheet, asked, _by_coordinate(problem, sheet, tree.args[0]), [sheet.last])
    first, motion = tree.args[0], sheet.by_pieces

    def begun(at):
        return motion.begun(at, next(instances(problem, sheet))[1])

    return tell_searched(problem, sheet, asked, lambda t, at: _signal(problem, sheet, first, t, begun(at), at),
                         lambda t, at, node: _shown(problem, sheet, first, t, begun(at), at, node), [motion.line])


def _at_instant(problem, sheet, tree: Any) -> "Iterator[tuple[Node, list[Any]]]":
    """The value by the pieces that have begun, in letters by its simplest form as well."""
    table, motion = problem.scene.table, sheet.by_pieces
    t = lower(tree.args[1], table, lambda name, *_: problem.scene.parameters.nodes[name])
    fixed = t.op == "number" and not t.is_zero
    if fixed and problem.numeric.has_free_symbols:
        return      # its unit would not stand beside letters
    known = next(instances(problem, sheet), ({}, {}))[1]
    at, = evaluate([t], Floats, known)
    begun = motion.begun(at, known)
    node = _signal(problem, sheet, tree.args[0], t, begun, at)
    shown = _shown(problem, sheet, tree.args[0], t, begun, at, node)
    simple = shortest(problem, sheet, node)
    if simple is not node:
        yield simple, [*shown, " = ", simple] if shown != [node] else [simple]
    yield node, shown


def _shown(problem, sheet, tree, t, begun, at, node) -> list[Any]:
    """Parts of the value of a signal at an instant: by the names of unit responses that of the coordinate, by the
    coordinate that of another where its own expression is longer."""
    if not isinstance(tree, NameRef) or letters(node) <= SHORT:
        return [node]
    name, = problem.scene.coordinates
    if tree.name == name:
        return sheet.by_pieces.told(begun, t, tree.primes)
    rows, fixed = _of_signal(problem, sheet, tree.name, tree.primes, (t, at))
    parts = [] if fixed.is_zero else [fixed]
    for order, row in enumerate(rows):
        if row is not None:
            negative = row.op != "sum" and row.coefficient < 0
            sign = (" − " if parts else "−") if negative else " + " if parts else ""
            size = -row if negative else row
            parts += [sign, *([Factor(size), "·"] if size is not size.table.one else []), Name(
                name + "'" * order), "(", t, ")"]
    return [part for part in parts if part != ""]


def _signal(problem, sheet, tree, t, begun: "list[ToldPiece]", at: float) -> "Node":
    """A function of signals that follow the coordinate, at an instant, which is `at` in numbers."""
    table, motion = problem.scene.table, sheet.by_pieces

    def signal(name, primes, part):
        if not isinstance(part, NameRef):
            raise NotInLetters("parts of signals are found in numbers")
        if name in problem.scene.parameters.nodes and not primes:
            return problem.scene.parameters.nodes[name]
        rows, fixed = _of_signal(problem, sheet, name, primes, (t, at))
        return fixed + table.total([row * motion.value(begun, t, problem.scene.time, order)
                                    for order, row in enumerate(rows) if row is not None])

    return lower(tree, table, signal)


def _of_signal(problem, sheet, name, primes, instant):
    """([its factor of the coordinate, of the speed, of the acceleration, None where it has none], what it is beside) at
    an instant (as an expression, in numbers)."""
    table, (t, at), known = problem.scene.table, instant, next(instances(problem, sheet))[1]
    if [name] == problem.scene.coordinates:
        return [table.one if order == primes else None for order in range(3)], _rest(problem, sheet, name, primes)
    rows, direct = outputs(problem.symbolic, name + "'" * primes)
    beside = _rest(problem, sheet, name, primes) + direct
    calls = [part for part in reachable([beside]) if part.op == "call" and part.name in PULSES]
    if any(call.name not in ("step", "ramp") for call in calls):
        raise NotInLetters("this signal is driven by what has no value")
    taken = evaluate([call.args[0] for call in calls], Floats, {**known, problem.scene.time.name: at})
    put_in = {call: table.zero if late <= LATE * abs(at) else table.one if call.name == "step" else call.args[0]
              for call, late in zip(calls, taken, strict=True)}
    fixed, = substitute(substitute([beside], put_in), {problem.scene.time: t})
    return [copied([row[0]], table)[0] if row else None for row in rows], textbook(fixed)


def _rest(problem, sheet, name, primes):
    """Of a signal; by the letter of a line where a search found it."""
    line = next((line for line in sheet.steps if line.settles == f"equilibrium[{name}]" and line.letter), None)
    if line is not None and not primes:
        return problem.scene.table.parameter(line.letter, positive=False)
    return at_rest(problem, name, primes)


def _final(problem, sheet, tree) -> "Iterator[tuple[Node, list[Any]]]":
    """The limit of a signal, where the coordinate settles."""
    if not isinstance(tree, NameRef):
        return
    rows, fixed = _of_signal(problem, sheet, tree.name, tree.primes, (problem.scene.time, 0.0))
    if not fixed.mask:
        node = textbook(fixed + (rows[0] or problem.scene.table.zero) * sheet.by_pieces.settles)
        yield node, [node]


def _by_coordinate(problem, sheet, tree) -> "Iterator[tuple[Node, list[Any]]]":
    """The extremes of a signal that is proportional to the coordinate, beside what is fixed, by those of that."""
    if not isinstance(tree, NameRef):
        return
    rows, fixed = _of_signal(problem, sheet, tree.name, tree.primes, (problem.scene.time, 0.0))
    if rows[0] is None or rows[1:] != [None, None] or fixed.mask:
        return
    name, = problem.scene.coordinates
    for line in sheet.steps:
        if line.settles in (f"max({name})", f"min({name})") and line.node is not None:
            node = textbook(fixed + rows[0] * line.node)
            sign, factor = ("−", -rows[0]) if rows[0].coefficient < 0 and rows[0].op != "sum" else ("", rows[0])
            before = [sign] * bool(sign) if fixed.is_zero else [fixed, f" {sign or '+'} "]
            yield node, [*before, Factor(factor), "·", Words(as_printed(line.settles, {name})), " = ", node]
