"""Formulas in which the numbers of the file keep their units."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


def with_units(problem: "Problem") -> "Problem":
    """The same with letters for the units of numbers that stand in its expressions, which are printed beside these."""
    if not problem.scene.table.hidden or problem.scene.table.dimension is None or problem.scene.pieces:
        return problem
    from vibcli.language.units_as_letters import with_unit_letters

    return problem.with_spec(with_unit_letters(problem.spec)).with_choice(problem.choice, problem)
