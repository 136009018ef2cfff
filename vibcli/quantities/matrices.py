"""Entries of M, C, G and K."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from vibcli.base import units
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.quantities.quantity import ROUNDING, Declaration

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

POWERS = {"M": 2, "C": 1, "G": 1, "K": 0}       # of the time in an entry, which times two coordinates is an energy


def coordinate_number(problem: "Problem", index: str) -> int:
    """The number of an independent coordinate, from 0."""
    name = problem.spec.coordinate_name(index)
    if name not in problem.scene.coordinates:
        if not problem.scene.coordinates:
            raise PhysicsError(f"the constraints leave '{name}' no freedom: nothing here has an equation of motion",
                               "ask for a force that holds it, as `find: [reactions]` prints")
        raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints: it has no equation of its "
                           "own", "ask for " + " or ".join(f"'{other}'" for other in problem.scene.coordinates[:3]))
    return problem.scene.coordinates.index(name)


def _matrix(problem: "Problem", which: str) -> dict[tuple[int, int], float]:
    if problem.scene.pieces:
        raise PhysicsError("what vibrates with distributed inertia has no matrices of finite size",
                           "ask for its frequencies and modes, or leave out its density: K is then that at rest")
    return dict(zip("MCGK", problem.configuration.element_data.matrices(), strict=True))[which]


def _entry(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    from vibcli.symbolic.running_errors import error_in

    i, j = (coordinate_number(problem, index) for index in tree.indices)
    pair = i, j
    if problem.digits is not None:
        precise = problem.configuration.precise_system(problem.digits).matrices()["MCGK".index(tree.head)]
        return precise.get(pair, 0.0), 10.0**-problem.digits
    value = float(_matrix(problem, tree.head).get(pair, 0.0))
    bound = problem.configuration.bounded_matrices["MCGK".index(tree.head)].get(pair, 0.0)
    return value, error_in(bound) / abs(value) if value else ROUNDING


def largest(problem: "Problem", tree: "QuantityRef") -> float:
    """The largest entry of a matrix."""
    return max((abs(float(value)) for value in _matrix(problem, tree.head).values()), default=0.0)


def _symbolic(problem: "Problem", tree: "QuantityRef") -> "Node":
    matrix = dict(zip("MCGK", problem.symbolic.matrices, strict=True))[tree.head]
    names, coordinates = [problem.spec.coordinate_name(index) for index in tree.indices], problem.scene.coordinates
    if not set(names) <= set(coordinates):
        raise NotInLetters(f"'{tree.text}' is found in numbers")
    return cast("Node", matrix.get(tuple(map(coordinates.index, names)), problem.scene.table.zero))


def entry_dimension(which: str, q: Any, r: Mapping[str, Any]) -> "dict[str, Fraction | int]":
    """Of the entry of a matrix, given the dimensions of two coordinates: energy·timeᵖ/(q·r)."""
    return units.times(units.times(units.times(units.ENERGY, units.TIME, POWERS[which]), q, -1), r, -1)


def dimension(spec: "Spec", tree: "QuantityRef") -> "dict[str, Fraction | int]":
    """Of an entry."""
    return entry_dimension(tree.head, *(spec.dimensions.of(spec.coordinate_name(index)) for index in tree.indices))


def _of_matrix(word: str) -> Declaration:
    return Declaration(f"entry of the {word} matrix", None, _entry, ("coordinate", "coordinate"), dimension=dimension,
                       size=largest, symbolic=_symbolic, several=True)


QUANTITIES = {"M": _of_matrix("mass"), "C": _of_matrix("damping"), "G": _of_matrix("gyroscopic"),
              "K": _of_matrix("stiffness")}
