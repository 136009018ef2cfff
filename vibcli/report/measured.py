"""Formulas in which the numbers of the file keep their units."""

from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.node import UNITS
from vibcli.symbolic.syntax import parts_of

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def with_units(problem: "Problem", asked: bool = False) -> "Problem":
    """The same with letters for the units of numbers that stand in its expressions, which are printed beside these;
    `asked`: or at which an answer asks for something."""
    told = problem.scene.table.hidden or (asked and _asks_at_numbers(problem.spec))
    if not told or problem.scene.table.dimension is None:
        return problem
    from vibcli.language.units_as_letters import with_unit_letters

    return problem.with_spec(with_unit_letters(problem.spec)).with_choice(problem.choice, problem)


def _asks_at_numbers(spec: "Spec") -> bool:
    """Does an answer ask for something at an instant or a frequency in numbers?"""
    return any(number.units and number.value for answer in spec.answers
               for tree in answer.asked.parts.quantities for arg in tree.args for number in parts_of(arg).numbers)


def without_units(node: "Node") -> "Node":
    """The same in SI units, with 1 for the letters of units."""
    table = node.table
    return substitute([node], {table.parameter(name): table.one for name in UNITS.values()})[0]
