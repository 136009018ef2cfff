"""What is asked of a free motion that lines tell by letters, x = Σ e^{−δₖt} (aₖ cos ωₖt + bₖ sin ωₖt): its value at an
instant, and of one vibration

    amplitude √(a² + b²),   phase atan2(b, a),   period 2π/ω,   decrement 2πδ/ω;

its envelope falls to 1/n in the time ln n/δ, in ln n over the decrement cycles; one that is critically damped passes
zero at −a/b. Two vibrations have the envelope √(A₁² + A₂² + 2 A₁A₂ cos (Δω t − Δφ)) and beat in 2π/Δω. Largest are
cosines of one sign at t = 0."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.notation.as_printed import as_printed
from vibcli.notation.plain import plain
from vibcli.report.blocks import Words
from vibcli.report.steps.agreement import same, samples_of
from vibcli.report.steps.free_waves import lines_of, value_at, waves_of
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.searched_extremes import INSTANTS, tell_searched
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.parser import VALUE, parse
from vibcli.symbolic.rationals import HALF
from vibcli.symbolic.semantics import lower, lower_measured
from vibcli.symbolic.syntax import NameRef, QuantityRef, parts_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.report.steps.free_waves import FreeWave
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

WIDE = 120      # columns of a root with numbers, which is not broken
ZEROS = 3       # passages through zero that are looked at
EXTREMES = {"max": 1, "argmax": 1, "min": -1, "argmin": -1}


def tell_of_free(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked a number of a free motion, and is it written down by the lines that tell that?"""
    tree, numeric = asked.tree, not problem.numeric.has_free_symbols
    of_one = len(problem.scene.coordinates) == 1
    if not sheet.waves or not tree.args or (tree.head == VALUE and numeric and of_one and isinstance(
            tree.args[0], NameRef)):
        return False
    least = {"least": 0} if tree.head == "beat_period" else {}
    if tell_found(problem, sheet, asked, _forms(problem, sheet, tree), lines_of(sheet), **least):
        return True
    return tree.head in INSTANTS and numeric and not isinstance(tree.args[0], QuantityRef) and tell_searched(
        problem, sheet, asked, lambda t, _: value_at(problem, sheet, tree.args[0], t), lambda t, at, node: [node],
        lines_of(sheet))


def _forms(problem: "Problem", sheet: WorkedSolution, tree: Any) -> "Iterator[tuple[Node, list[Any]]]":
    first, table = tree.args[0], problem.scene.table
    if tree.head == VALUE:
        yield from _at_instant(problem, sheet, tree)
        return
    of_envelope = isinstance(first, QuantityRef) and first.head == "envelope"
    squared = getattr(first, "kind", "") == "power" and tree.head == "mean"
    signal = first.args[0] if of_envelope else first.base if squared else first
    waves = waves_of(problem, sheet, signal)
    if of_envelope:
        found = _of_envelope(waves, tree.head) if len(waves) == 2 else []
    elif tree.head in EXTREMES:
        found = _extremes(problem, sheet, tree, waves)
    elif tree.head in ("mean", "rms"):
        rest = value_at(problem, sheet, signal, table.zero) - table.total([wave.a for wave in waves])
        found = [_mean(waves, rest, tree.head == "mean", squared)]
    elif len(waves) == 2:
        if tree.head == "beat_period":
            yield _beats(*sorted(waves, key=lambda wave: wave.rate.name or ""))
        found = []
    else:
        found = list(_of_one(problem, sheet, tree, *waves)) if len(waves) == 1 else []
    yield from ((node, [node]) for node in found)


def _beats(one: "FreeWave", other: "FreeWave") -> "tuple[Node, list[Node | str | Words]]":
    """2π/(ω₂ − ω₁), or its magnitude where letters leave open which is greater."""
    names = [wave.rate.name or "" for wave in (one, other)]
    if "omega" in names or not all(name.startswith("omega") for name in names):
        return 2 * one.rate.table.pi / one.rate.table.call("abs", other.rate - one.rate), ["2·π/|", one.rate, " − ",
                                                                                          other.rate, "|"]
    return 2 * one.rate.table.pi / (other.rate - one.rate), ["2·π/(", other.rate, " − ", one.rate, ")", Words(
        "   (where the frequencies are near each other)")]


def _of_one(problem: "Problem", sheet: WorkedSolution, tree: QuantityRef, wave: "FreeWave") -> "Iterator[Node]":
    """A number of one vibration."""
    table, (a, b, rate, delta) = problem.scene.table, wave
    if tree.head == "amplitude":
        yield table.sqrt(wave.square)
    if tree.head == "phase":
        yield table.call("atan2", b, a)
    if rate.is_zero and tree.head == "zero":
        yield -a / b
    if rate.is_zero:
        return
    if tree.head == "zero":
        nothing = {table.parameter(line.letter): line.node for line in sheet.steps if line.letter and (
            line.node is not None and line.node.is_zero)}
        b, = substitute([b], nothing)
        yield from ((turn + HALF) * table.pi / rate if textbook(b).is_zero else (table.call(
            "atan", -a / b) + turn * table.pi) / rate for turn in range(ZEROS))
    if tree.head == "period":
        yield 2 * table.pi / rate
    if delta.is_zero:
        return
    decrement = 2 * table.pi * delta / rate
    if tree.head == "decrement":
        yield decrement
    if tree.head in ("time_to", "cycles_to"):
        falls = table.call("log", 1 / lower(parse(tree.indices[0]), table, _parameters(problem)))
        yield falls / (delta if tree.head == "time_to" else decrement)


def _parameters(problem: "Problem") -> "Callable[..., Node]":
    return lambda name, *_: problem.scene.parameters.nodes[name]


def _at_instant(problem: "Problem", sheet: WorkedSolution, tree: QuantityRef) -> Iterator[tuple[Any, list[Any]]]:
    """A value, or that of an envelope, at an instant; the time has its letter where that is a number with a unit."""
    first, instant = tree.args
    if parts_of(instant).quantities:
        raise NotInLetters("instants that are asked for as quantities are found in numbers")
    time = problem.scene.time
    if isinstance(first, QuantityRef):
        if first.head != "envelope":
            return
        node = _envelope(waves_of(problem, sheet, first.args[0]), time)
        if sheet.in_numbers and len(plain(node)) > WIDE:
            return
    else:
        node = value_at(problem, sheet, first, time)
    t = lower_measured(instant, problem.scene.table, _parameters(problem))
    found, = substitute([node], {time: t})
    found = min(found, textbook(substitute([found], _in_file(problem, sheet))[0]), key=letters)
    if is_number(t) and not t.is_zero:
        given = as_printed(tree.text[instant.start - tree.start:instant.end - tree.start])
        yield found, [Words("with  "), time, Words(f" = {given}:  "), node]
    else:
        yield found, [found]


def _in_file(problem: "Problem", sheet: WorkedSolution) -> "dict[Node, Node]":
    """{letter of a line: the parameter that the file has for the same}."""
    table, samples = problem.scene.table, samples_of(problem, {})
    told = {line.letter: line.node for line in sheet.steps if line.letter and line.settles.startswith("omega")
            and line.node is not None and problem.numeric.has_free_symbols}
    with suppress(KeyError):        # of letters that lines define by others
        return {table.parameter(name): node for name, of in told.items()
                for node in problem.scene.parameters.nodes.values() if same(node, of, samples)}
    return {}


def _envelope(waves: "list[FreeWave]", t: "Node") -> "Node":
    """√(A₁² + A₂² + 2 A₁A₂ cos (Δω t − Δφ)), each with its decay."""
    table = t.table
    if len(waves) > 2:
        raise NotInLetters("envelopes are those of one or two vibrations")
    decays = [table.one if wave.delta.is_zero else table.call("exp", -(wave.delta * t)) for wave in waves]
    if len(waves) == 1:
        return table.sqrt(waves[0].square) * decays[0]
    (one, other), spread = waves, (waves[1].rate - waves[0].rate) * t
    mixed = (one.a * other.a + one.b * other.b) * table.call("cos", spread) + (
        one.a * other.b - one.b * other.a) * table.call("sin", spread)
    return table.sqrt(table.total([wave.square * decay ** 2 for wave, decay in zip(waves, decays, strict=True)])
                      + 2 * decays[0] * decays[1] * mixed)


def _of_envelope(waves: "list[FreeWave]", head: str) -> "list[Node]":
    """The sum and the difference of the amplitudes of two vibrations that nothing damps."""
    table = waves[0].rate.table
    if head not in ("max", "min") or not all(wave.delta.is_zero for wave in waves):
        return []
    A, B = (table.sqrt(wave.square) for wave in waves)
    return [A + B] if head == "max" else [A - B, B - A]


def _mean(waves: "Sequence[FreeWave]", rest: "Node", mean: bool, squared: bool) -> "Node":
    """Of a signal whose vibrations do not die out, or of its square, or the root of that."""
    if mean and not squared:
        return rest
    square = rest ** 2 + rest.table.total([wave.square for wave in waves]) / 2
    return square if mean else rest.table.sqrt(square)


def _extremes(problem: "Problem", sheet: WorkedSolution, tree: QuantityRef,
              waves: "list[FreeWave]") -> "Iterator[Node]":
    """Of vibrations that all start at rest on one side that side, at t = 0; of one the other side as well, and where it
    is critically damped ẋ = 0 at 1/δ − a/b."""
    table, sense, instant = problem.scene.table, EXTREMES[tree.head], tree.head.startswith("arg")
    t0, starts = table.zero, {table.parameter(line.letter): line.node for line in sheet.steps
                              if line.settles in ("A", "B") and line.node is not None}
    still = [wave for wave in waves if textbook(substitute([wave.speed.a], starts)[0]).is_zero]
    begin = value_at(problem, sheet, tree.args[0], t0)
    if len(still) == len(waves) and all(table.is_positive(sense * wave.a) for wave in waves):
        yield t0 if instant else begin
    if len(waves) != 1 or (waves[0].rate.is_zero and waves[0].delta.is_zero):
        return
    wave, = waves
    rest = begin - wave.a
    if wave.rate.is_zero:
        begun = t0 if textbook(substitute([wave.a], starts)[0]).is_zero else wave.a / wave.b
        yield 1 / wave.delta - begun if instant else rest + wave.b * table.call(
            "exp", wave.delta * begun - 1) / wave.delta
    elif wave.delta.is_zero:
        first = table.call("atan2", wave.b, wave.a)
        yield from ((first + turn * table.pi) / wave.rate for turn in ((0, 2) if sense > 0 else (1, -1))) if (
            instant) else [rest + sense * table.sqrt(wave.square)]
    elif still:
        yield table.pi / wave.rate if instant else rest - wave.a * table.call("exp", -(
            wave.delta * table.pi / wave.rate))
