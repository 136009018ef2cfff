"""How far the only coordinate goes from a start or under a step, and when, where it moves as

    x = x_r + e^{−δτ} (A cos ω_dτ + B sin ω_dτ),   ẋ = 0 at  tan ω_dτ = (ω_d B − δ A)/(ω_d A + δ B);

from a start at rest first at τ = π/ω_d, with x = x_r − A e^{−πδ/ω_d}, so that e^{−πδ/ω_d} is the overshoot

(Thomson & Dahleh 1998, section 4.3)."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.instances import found_at, instances, is_found
from vibcli.report.steps.place_of_rest import as_counted
from vibcli.report.steps.step import number, unit_told
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.symbolic.node import Node

INSTANTS = "argmax", "argmin"
HEADS = ("max", "min", *INSTANTS, "overshoot")
SHORT = 4           # letters of what is put in for a letter
TURNS = 3           # places where it turns back that are looked at


class Swing(NamedTuple):
    """x_r + e^{−δτ} (A cos ω_dτ + B sin ω_dτ) from τ = t − begins = 0 on, the line that tells it; B is None where it
    starts at rest; `beside`: where it turns back is told beside it."""

    rest: "Node"
    A: "Node"
    B: "Node | None"
    begins: "Node"
    line: int
    beside: bool = False


class TurningBack(NamedTuple):
    """τ where it turns back, None of the start; x there; the letter of τ in that, None where it has none; which place
    of those that are looked at."""

    instant: "Node | None"
    place: "Node"
    letter: "Node | None" = None
    number: int = 0


def tell_extremes(degree: Degree, swing: Swing) -> None:
    """Write down the extremes that are asked of the coordinate, and their instants, where the engine finds the same."""
    asked = asked_extremes(degree)
    found = list(_found(degree, swing, asked, {}))
    numbers = sorted({turn.number for _, turn, _ in found if turn.letter is not None})
    if len(numbers) > 1:
        found = list(_found(degree, swing, asked, {number: place for place, number in enumerate(numbers, 1)}))
    lines: dict[Any, Any] = {}
    for turn in sorted((turn for _, turn, _ in found), key=lambda turn: turn.number):
        if turn.instant is not None and (swing.B is None or turn.letter is not None) and turn.number not in lines:
            lines[turn.number] = _tell_turn(degree, swing, turn, swing.beside or bool(lines))
    before = degree.sheet.last
    for one, turn, node in found:
        _tell(degree, one, node, lines.get(turn.number, swing.line), joined=degree.sheet.last > before)


def _found(degree: Degree, swing: Swing, asked: Sequence[Any],
           numbered: dict[Any, Any]) -> "Iterator[tuple[Expression, TurningBack, Node]]":
    """(what is asked, its TurningBack, its expression), with letters t₁, t₂ … by the numbers of places."""
    for one in asked:
        form = _form_of(degree, swing, one, found_at(degree.problem, degree.sheet, one), numbered)
        if form is not None:
            yield one, *form


def asked_extremes(degree: Degree) -> "list[Expression]":
    """What is asked of extremes of the coordinate, and no line tells."""
    spec, rules = degree.problem.spec, degree.problem.spec.get("variants")
    if spec.choices:
        return []
    settled = {line.settles for line in degree.sheet.steps}
    every = {one.asked.text: one.asked for one in (*(rules.ask if rules is not None else ()), *spec.answers)}
    return [one for one in every.values() if one.text not in settled and getattr(one.tree, "head", "") in HEADS
            and one.tree.args and isinstance(one.tree.args[0], NameRef)
            and (one.tree.args[0].name, one.tree.args[0].primes) == (degree.name, 0)]


def _tell_turn(degree: Degree, swing: Swing, turn: TurningBack, joined: bool) -> int:
    """The line of where it turns back."""
    table, t, rate = degree.about.table, degree.problem.scene.time, _rate(degree)
    if swing.B is None:
        wave = table.call("sin", rate * (t - swing.begins)) * _decay(degree, t - swing.begins)
        speed = -(swing.A * degree.omega ** 2 * wave / rate)
        return degree.sheet.write(Name(degree.name + "'"), " = ", speed, Words(",  zero first at  "), "t = ",
                                  swing.begins + turn.instant, settles="turning back", uses=[swing.line])
    value = None
    if not degree.problem.numeric.has_free_symbols:
        value = _at(turn, next(instances(degree.problem, degree.sheet))[1])[turn.letter.name]
    tangent = table.call("tan", rate * turn.letter)
    return degree.sheet.write(Name(degree.name + "'"), " = 0", Words(" at  "), turn.letter, Words("  with  "), tangent,
                              " = ", _tangent(degree, swing), *(() if value is None else (
                                  Words(":  "), turn.letter, *number(value, "s"))), settles=turn.letter.name,
                              value=value, unit="" if value is None else "s", letter=turn.letter.name,
                              uses=[swing.line], joined=joined)


def _tell(degree: Degree, asked: "Expression", node: "Node", line: int, joined: bool) -> None:
    """A number that is asked by its expression."""
    problem, value, unit = degree.problem, None, ""
    if not problem.numeric.has_free_symbols:
        value, unit = float(value_of(problem, asked)[0]), unit_told(problem.spec, asked)
    text = as_printed(asked.text, {*problem.spec.parameters, *problem.spec.coordinates})
    shown = [] if is_number(node) and value is not None else [Words(":  "), node, *_put_in(degree, node)]
    degree.sheet.write(Words(text), *shown, *(() if value is None else number(value, unit)), *as_counted(
        problem, asked.tree), settles=asked.text, node=node, value=value, unit=unit, uses=[line], joined=joined)


def _put_in(degree: Degree, node: "Node") -> "list[Node | str]":
    """Parts of ` = the same` of a scene in letters by what lines have for its letters, where that is short."""
    if not degree.problem.numeric.has_free_symbols:
        return []
    table = degree.about.table
    known = {table.parameter(line.letter): line.node for line in degree.sheet.steps if line.letter and (
        line.node is not None) and letters(line.node) <= SHORT}
    found, = substitute([node], known)
    with suppress(KeyError):        # of letters that are defined by others
        found = degree.about.tidy(found)
    return [" = ", found] if found is not node and letters(found) <= letters(node) + 1 else []


def _form_of(degree: Degree, swing: Swing, asked: "Expression", values: Sequence[tuple[Mapping[str, float], float]],
             numbered: dict[int, int]) -> "tuple[TurningBack, Node] | None":
    """(the TurningBack, its expression) of what the engine finds; None of others."""
    for turn in _turns(degree, swing, numbered):
        node = _form(degree, swing, asked.tree.head, turn)
        if node is not None and is_found(node, [(_at(turn, known), value) for known, value in values]):
            return turn, node
    return None


def _at(turn: TurningBack, known: Mapping[str, float]) -> Any:
    """With a number for the letter of the instant."""
    if turn.letter is None:
        return known
    return {**known, turn.letter.name: evaluate([turn.instant], Floats, known)[0]}


def _form(degree: Degree, swing: Swing, head: str, turn: TurningBack) -> "Node | None":
    """The expression of what is asked at a turn; None of what it has none of."""
    if head == "overshoot":
        at_rest = swing.B is None and turn.instant is not None and not degree.C.is_zero
        return _decay(degree, turn.instant) if at_rest else None
    if head in INSTANTS:
        return swing.begins if turn.instant is None else swing.begins + (turn.letter or turn.instant)
    return turn.place


def _turns(degree: Degree, swing: Swing, numbered: Mapping[int, int]) -> Iterator[TurningBack]:
    """The start, and the first places where it turns back."""
    table, A, B, rate = degree.about.table, swing.A, swing.B, _rate(degree)
    yield TurningBack(None, swing.rest + A)
    if B is None:
        turn = table.pi / rate
        yield TurningBack(turn, swing.rest - A * _decay(degree, turn), number=1)
        return
    for k in range(TURNS):
        if degree.C.is_zero:
            size = table.sqrt(A ** 2 + B ** 2)
            at = (table.call("atan2", B, A) + k * table.pi) / rate
            yield TurningBack(at, swing.rest + (size if k % 2 == 0 else -size), number=k + 1)
        else:
            of = ("t" if swing.begins.is_zero else "tau") + str(numbered.get(k + 1, 1))
            t = degree.about.letter(degree.sheet.letter(of))
            wave = A * table.call("cos", rate * t) + B * table.call("sin", rate * t)
            instant = (table.call("atan", _tangent(degree, swing)) + k * table.pi) / rate
            yield TurningBack(instant, swing.rest + _decay(degree, t) * wave, t, k + 1)


def _tangent(degree: Degree, swing: Swing) -> "Node":
    """tan ω_dτ where it turns back."""
    rate, delta = _rate(degree), degree.delta
    return (rate * swing.B - delta * swing.A) / (rate * swing.A + delta * swing.B)


def _rate(degree: Degree) -> "Node":
    return degree.omega if degree.C.is_zero else degree.omega_d


def _decay(degree: Degree, instant: "Node") -> "Node":
    return degree.about.table.one if degree.C.is_zero else degree.about.table.call("exp", -(degree.delta * instant))
