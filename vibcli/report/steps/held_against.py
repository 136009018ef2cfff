"""What is asked, written down by an expression that the engine finds as well."""

from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.as_printed import as_printed
from vibcli.notation.plain import plain
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Words
from vibcli.report.steps.characteristic import LONG
from vibcli.report.steps.instances import INSTANCES, found_at, is_found, vanishes
from vibcli.report.steps.place_of_rest import as_counted
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.report.steps.waves_in_numbers import with_numbers
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


WIDE = 300          # columns of an expression, three lines of print, beyond which it is told by its number alone


def is_short(node: Any) -> bool:
    """Is an expression one to read?"""
    return letters(node) <= LONG and len(plain(node)) <= WIDE


def _is_readable(told: "Sequence[Node | str | Words]") -> bool:
    """Is each expression of what is told short?"""
    nodes = [getattr(part, "node", part) for part in told]
    return all(is_short(node) for node in nodes if hasattr(node, "op"))


def tell_found(problem: "Problem", sheet: WorkedSolution, asked: "Expression",
               forms: "Iterable[tuple[Node, Sequence[Any]]]", uses: "Sequence[int]", least: int = INSTANCES) -> bool:
    """Is the first of the forms, (expression, parts that tell it), that is the engine's written down? Not a long one;
    `least`: instances of a scene in letters that have it; 0 of what a form defines."""
    known = None
    with suppress(PhysicsError):
        for node, told in forms:
            known = found_at(problem, sheet, asked, least) if known is None else known
            if _is_readable(told) and (is_found(node, known) or not (known or least)):
                nothing = vanishes(node, known)
                _write(problem, sheet, asked, problem.scene.table.zero if nothing else node, [
                    *told, " = 0"] if nothing else told, uses)
                return True
    return False


def _write(problem: "Problem", sheet: WorkedSolution, asked: "Expression", node: "Node", told: Sequence[Any],
           uses: Sequence[int]) -> None:
    value, unit = None, ""
    if not problem.numeric.has_free_symbols:
        value, unit = float(value_of(problem, asked)[0]), unit_told(problem.spec, asked)
    text = as_printed(asked.text, {*problem.spec.parameters, *problem.spec.coordinates})
    shown = [] if is_number(node) and value is not None else [Words(":  "), *with_numbers(sheet, told)]
    sheet.write(Words(text), *shown, *(() if value is None else number(value, unit)), *as_counted(problem, asked.tree),
                settles=asked.text, node=node, value=value, unit=unit, uses=uses)
