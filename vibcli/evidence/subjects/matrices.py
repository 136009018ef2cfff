"""Entries of the matrices of small oscillations about an equilibrium."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.matrices import entry
from vibcli.evidence.reference.static_positions import equations
from vibcli.evidence.subject import Subject, of_number
from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.energies import kinetic
from vibcli.quantities import equilibrium
from vibcli.quantities.matrices import coordinate_number
from vibcli.quantities.quantity import about_which, declared
from vibcli.symbolic.evaluation_code import in_floats
from vibcli.symbolic.expression_graph import evaluable

if TYPE_CHECKING:
    from vibcli.evidence.reference.static_positions import StaticEquations
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef


class PlainForces(NamedTuple):
    """What others are given: T and the forces h(q, q̇) of a scene in floats, `units` of its coordinates; at(shift,
    speeds): [T, h …] beside the equilibrium."""

    head: str
    pair: tuple[int, int]
    units: Sequence[float]
    at: Callable[[Sequence[float], Sequence[float]], list[float]]


def of_entry(problem: "Problem", tree: "QuantityRef") -> Subject:
    """K[x,y], M, C or G of that; about one of several equilibria where it says so."""
    if problem.scene.members:
        raise PhysicsError("no reference is found of matrices of members")
    asked, number = about_which(tree)
    one = problem if number is None else equilibrium.about(problem, int(number))
    configuration, (i, j) = one.configuration, (coordinate_number(problem, name) for name in asked.indices)
    static = equations(configuration)
    size = declared(asked).size(one, asked)
    true = entry(configuration, static, asked.head, (i, j), size)
    scale = abs(float(true.values[0])) or size or 1.0

    plain = None if static.parts.gaps else _plain(one, static, asked.head, (i, j))
    return of_number("matrix entry", one, tree, "an entry of a matrix of small oscillations", true, plain, scale,
                     lambda: problem.about(Configuration(problem.numeric)))


def _plain(problem: "Problem", static: "StaticEquations", head: str, pair: tuple[int, int]) -> PlainForces:
    scene = static.scene
    nodes: list[Any] = [kinetic(scene), *static.parts.h]
    function, known = in_floats(nodes, evaluable(nodes)), {**problem.numeric.floats, scene.time.name: 0.0}
    near = static.near[:len(scene.q)]

    def at(shift: "Sequence[float]", speeds: "Sequence[float]") -> "list[float]":
        known.update(zip(scene.coordinates, (x + dx for x, dx in zip(near, shift, strict=True)), strict=True))
        known.update(zip((name + "'" for name in scene.coordinates), speeds, strict=True))
        return function(known, None)

    return PlainForces(head, pair, [scene.unit_of(name) for name in scene.coordinates], at)
