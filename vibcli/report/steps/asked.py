"""What a sheet asks that no line before tells: by its expression in letters where that is short, else its number."""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import lowered, value_of
from vibcli.quantities.in_letters import response_of
from vibcli.quantities.letters import any_quantity
from vibcli.quantities.quantity import OF_STATE, is_choice, quantity_of
from vibcli.report.blocks import Words
from vibcli.report.steps.agreement import same, samples_of, tidy
from vibcli.report.steps.asked_of_pieces import tell_of_pieces
from vibcli.report.steps.averages import tell_average
from vibcli.report.steps.directions import tell_direction
from vibcli.report.steps.extremes import HEADS
from vibcli.report.steps.free_vibration import tell_of_free
from vibcli.report.steps.held_against import is_short
from vibcli.report.steps.in_numbers_alone import tell_left
from vibcli.report.steps.instants import tell_instant
from vibcli.report.steps.kept_up import tell_of_kept_up
from vibcli.report.steps.overdamped import tell_of_overdamped, tell_root
from vibcli.report.steps.periods import tell_period
from vibcli.report.steps.place_of_rest import as_counted
from vibcli.report.steps.receptances import tell_receptance
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.radicals import root, without_bars
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

BY_LETTERS = (tell_direction, tell_instant, tell_of_free, tell_of_overdamped, tell_root, tell_average,
              tell_period, tell_of_kept_up, tell_of_pieces)       # that have lines of their own
OF_EXPRESSIONS = tell_average, tell_receptance, tell_of_kept_up
CLOSE = 1e-9        # relative: of an expression and the engine's number
OF_SPRINGS = "stiffness", "damping", "law", "stiffness_correction"       # of springs, dashpots, and what these hold
ENERGIES = "V", "T", "Phi"      # of expansions, told by the factor of a power
OF_LETTERS = "period", "frequency", "decay", "zeta"      # told in letters, where no line settles them
BESIDE = "frequency", "period", "period_d", "eigenvalue"      # told beside another number of the mode


def tell_asked(problem: "Problem", sheet: WorkedSolution) -> None:
    """Write down a line to each number that the variants of a scene ask, or answers ask of a motion, of a node or by an
    expression of quantities, and no line settles; those of answers side by side."""
    rules = problem.spec.get("variants")
    if problem.numeric.has_free_symbols:
        _tell_in_letters(problem, sheet)
        return
    settled, before = {line.settles for line in sheet.steps}, sheet.last
    of_answers = [one for one in problem.spec.answers if _untold(problem.spec, one.asked)]
    extremes = {one.asked.text for one in of_answers if getattr(one.asked.tree, "head", "") in HEADS}
    for one in (*(rules.ask if rules is not None else ()), *of_answers):
        if one.asked.text not in settled and _is_number(problem.spec, one.asked.tree):
            settled.add(one.asked.text)
            beside = sheet.last > before or sheet.steps[-1].settles in extremes
            _tell(problem, sheet, one.asked, joined=one in of_answers and beside)


def _tell_in_letters(problem: "Problem", sheet: WorkedSolution) -> None:
    """The expressions of quantities that answers of a scene in letters ask, with a number where all that is left has
    one; then what is told in numbers alone."""
    settled, left = {line.settles for line in sheet.steps}, []
    for asked in [one.asked for one in problem.spec.answers if _untold(problem.spec, one.asked)
                  or getattr(one.asked.tree, "head", "") in OF_LETTERS]:
        if asked.text in settled:
            continue
        try:
            ways: tuple[Any, ...] = IN_LETTERS if isinstance(asked.tree, QuantityRef) else ()
            ways = *ways, tell_average, tell_of_kept_up, _told_as_expression
            if not any(tell(problem, sheet, asked) for tell in ways):
                left.append(asked)
        except (PhysicsError, SpecError):
            left.append(asked)
    tell_left(problem, sheet, left)


def _by_frequency(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is a period, or a frequency in Hz, told by the letter of its angular frequency?"""
    tree = asked.tree
    line = next((one for one in sheet.steps if tree.head in ("period", "frequency") and not tree.args and one.letter
                 and one.settles == f"omega[{', '.join(tree.indices)}]" and one.node is not None), None)
    if line is None:
        return False
    turn, omega = 2 * problem.scene.table.pi, problem.scene.table.parameter(line.letter)
    node = turn / omega if tree.head == "period" else omega / turn
    sheet.write(Words(f"{as_printed(asked.text)}:  "), node, settles=asked.text, node=node, uses=[line.number])
    return True


IN_LETTERS = _by_frequency, tell_root, tell_instant, tell_of_free, tell_period, tell_of_pieces


def _told_as_expression(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is its expression in letters written down, as it is not long?"""
    samples, known = samples_of(problem, {}), problem.scene.parameters.values(Floats)
    alone = isinstance(asked.tree, QuantityRef) or response_of(problem, asked.tree) is not None
    node = short_quantity(problem, asked.tree) if alone else tidy(_of_quantities(problem, asked), samples)
    value, unit = None, unit_told(problem.spec, asked)
    with suppress(KeyError):
        value, = evaluate([node], Floats, known)
    if not is_short(node) or is_number(node):
        return is_number(node)
    text = as_printed(asked.text, {*problem.spec.parameters, *problem.spec.coordinates})
    sheet.write(Words(f"{text}:  "), node, *(() if value is None else number(value, unit)), node=node,
                settles=asked.text, value=value, unit=unit * (value is not None), uses=[sheet.last])
    return True


def _of_quantities(problem: "Problem", asked: "Expression") -> "Node":
    found = {part.text: any_quantity(problem, part) for part in asked.parts.quantities}
    return lowered(asked, problem.scene.table, lambda name, primes, part: found[part.text] if isinstance(
        part, QuantityRef) else problem.scene.parameters.nodes[name])


def _untold(spec: "Spec", asked: "Expression") -> bool:
    """Is it of a motion, of a node, of springs, or an expression of quantities that the scene does not choose?"""
    quantities = asked.parts.quantities
    if isinstance(asked.tree, QuantityRef):
        tree = asked.tree
        return bool(tree.args) or tree.head in ("node", *OF_SPRINGS) or (
            tree.head in ENERGIES and bool(tree.indices)) or (tree.head == "eigenvalue" and len(tree.indices) == 2)
    return bool(quantities) and not any(is_choice(spec, tree) for tree in quantities)


def _is_number(spec: "Spec", tree: Any) -> Any:
    """Is it an expression of quantities, or one that is a number and has a line of its own?"""
    quantity = quantity_of(spec, tree)
    if quantity is None:
        return not isinstance(tree, QuantityRef)
    return quantity.value is not None and quantity.kind not in OF_STATE and (
        tree.head not in BESIDE or tree.args or len(tree.indices) == 2)


def _tell(problem: "Problem", sheet: WorkedSolution, asked: "Expression", joined: bool) -> None:
    for tell in BY_LETTERS if isinstance(asked.tree, QuantityRef) else OF_EXPRESSIONS:
        sheet.join_next(joined and tell not in (tell_direction, tell_instant, tell_receptance))
        with suppress(PhysicsError, SpecError):
            if tell(problem, sheet, asked):
                return
    try:
        value = known(problem, asked)
    except (PhysicsError, SpecError):
        return
    unit = unit_told(problem.spec, asked)
    node = _in_letters(problem, asked, value)
    text = as_printed(asked.text, {*problem.spec.parameters, *problem.spec.coordinates})
    shown = [Words(text)] if node is None or is_number(node) else [Words(f"{text}:  "), node]
    more = [Words("   (there the mode does not move)")] if getattr(asked.tree, "head", "") == "node" else as_counted(
        problem, asked.tree)
    sheet.write(*shown, *number(value, unit), *more, settles=asked.text, node=node,
                value=value, unit=unit, uses=[sheet.last], joined=joined)


def known(problem: "Problem", asked: "Expression") -> float:
    """Its number; zero where no more than rounding is known of it."""
    value, error = value_of(problem, asked)
    return float(value) if error < 1.0 else 0.0


def _in_letters(problem: "Problem", asked: "Expression", value: float) -> "Node | None":
    """Its expression where that is not long and has the engine's number; None of others."""
    try:
        node = short_quantity(problem, asked.tree)
    except (PhysicsError, SpecError):
        return None
    again, = evaluate([node], Floats, problem.numeric.floats)
    return node if is_short(node) and abs(again - value) <= CLOSE * abs(value) else None


def short_quantity(problem: "Problem", tree: Any) -> "Node":
    """A quantity in letters, in its shortest form; NotInLetters where it is found in numbers."""
    samples = samples_of(problem, {})
    found = without_bars(any_quantity(problem, tree), samples)
    shortest = min(tidy(found, samples), found, key=letters)
    return min(_rooted(shortest, samples), shortest, key=letters)


def _rooted(node: "Node", samples: Sequence[Mapping[str, float]]) -> "Node":
    """The same with what is a square taken out of the roots among its factors."""
    if node.op != "product" or not any(e.denominator == 2 for _, e in node.args):
        return node
    table = node.table
    found = table.product((table.number(node.coefficient), ONE), *(
        (root(base, samples), 2 * e) if e.denominator == 2 else (base, e) for base, e in node.args))
    return found if same(found, node, samples) else node
