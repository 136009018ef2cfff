"""SI units of the stiffness Kᵢⱼ, an energy over qᵢqⱼ, of Mᵢⱼ, of loads Qᵢ, an energy over qᵢ, of receptances Hᵢⱼ, and
of determinants."""

from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.quantities.matrices import entry_dimension

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

RECEPTANCE = "m/N", "1/N", "rad/(N·m)"      # by how many of its coordinates are turns


def unit_of_entry(problem: "Problem", i: int, j: int, letter: str = "K") -> str:
    """Of Kᵢⱼ, or an entry of another matrix."""
    names, dimension = problem.scene.coordinates, problem.system.dimension
    return units.text(entry_dimension(letter, dimension(names[i]), dimension(names[j])))


def unit_of_receptance(problem: "Problem", i: int, j: int) -> str:
    """Of Hᵢⱼ, what qᵢ is by a load along qⱼ: qᵢqⱼ over an energy."""
    names, dimension = problem.scene.coordinates, problem.system.dimension
    return RECEPTANCE[sum(not dimension(names[k]) for k in (i, j))]


def unit_of_load(problem: "Problem", i: int) -> str:
    """Of Qᵢ."""
    return units.text(units.times(units.ENERGY, problem.system.dimension(problem.scene.coordinates[i]), -1))


def unit_of_determinant(problem: "Problem", power: int = 0) -> str:
    """Of det K times a power of the time."""
    found = units.times(units.NONE, units.TIME, power)
    for name in problem.scene.coordinates:
        of_coordinate = problem.system.dimension(name)
        found = units.times(found, entry_dimension("K", of_coordinate, of_coordinate))
    return units.text(found)
