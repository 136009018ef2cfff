"""Formulas in which the numbers of the file keep their units."""

from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.node import UNITS

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def with_units(problem: "Problem") -> "Problem":
    """The same with letters for the units of numbers that stand in its expressions, which are printed beside these."""
    if not problem.scene.table.hidden or problem.scene.table.dimension is None:
        return problem
    from vibcli.language.units_as_letters import with_unit_letters

    return problem.with_spec(with_unit_letters(problem.spec)).with_choice(problem.choice, problem)


def without_units(node: "Node") -> "Node":
    """The same in SI units, with 1 for the letters of units."""
    table = node.table
    return substitute([node], {table.parameter(name): table.one for name in UNITS.values()})[0]
