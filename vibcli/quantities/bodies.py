"""Masses, moments of inertia and mass centres of bodies."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.quantities.quantity import Declaration, measured, unit

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


def _inertia(problem: "Problem", tree: "QuantityRef") -> "Node":
    """J about the mass centre, or by the parallel axis theorem about a point as drawn."""
    scene, indices = problem.scene, tree.indices
    body = scene.bodies[indices[0]]
    node = body.inertia if body.inertia is not None else scene.table.zero
    if len(indices) == 2:
        x, y = _drawn(scene, indices[1])
        mass = body.mass if body.mass is not None else scene.table.zero
        node = node + mass * ((x - body.centre[0]) ** 2 + (y - body.centre[1]) ** 2)
    return scene.at_drawn(node)[0]


def _mass(problem: "Problem", tree: "QuantityRef") -> "Node":
    return problem.scene.bodies[tree.indices[0]].mass


def _drawn(scene: "Scene", name: str) -> "tuple[Node, Node]":
    if name in scene.bodies:
        return scene.bodies[name].centre
    return scene.pair(scene.spec.get("points")[name]["at"])


def _centre(problem: "Problem", tree: "QuantityRef") -> "Node":
    return problem.scene.bodies[tree.indices[0]].centre["xy".index(tree.component)]


def _value(symbolic: "Callable[..., Node]") -> "Callable[[Problem, QuantityRef, Sequence[Any]], tuple[Any, float]]":
    def value(problem: "Problem", tree: "QuantityRef", args: "Sequence[Any]") -> "tuple[Any, float]":
        from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
        from vibcli.symbolic.running_errors import RunningErrors

        arithmetic = RunningErrors(Floats if problem.digits is None else multiprecision(), unit(problem))
        found, = evaluate([symbolic(problem, tree)], arithmetic, problem.numeric.values(arithmetic))
        return measured(found)
    return value


def _turned(problem: "Problem", tree: "QuantityRef") -> float:
    body, size = problem.scene.bodies[tree.indices[0]], problem.numeric.figure_size
    return (problem.scene.number(body.mass) if body.mass is not None else 1.0) * size * size


QUANTITIES = {
    "mass": Declaration("mass of a body, that of all its parts together less that of its holes", "kg", _value(_mass),
                        ("body",), symbolic=_mass),
    "J": Declaration("moment of inertia of a body about its mass centre, or about a point", "kg*m^2", _value(_inertia),
                     ("body", "place"), size=_turned, symbolic=_inertia, spare=1),
    "centre": Declaration("mass centre of a body as drawn", "m", _value(_centre), ("body",), components=("x", "y"),
                          size=lambda problem, tree: problem.numeric.figure_size, symbolic=_centre),
}
