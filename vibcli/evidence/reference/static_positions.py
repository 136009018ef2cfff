"""Static positions to many digits: forces at rest vanish, with those of constraints, whose gaps are closed.

    hᵢ(q, q̇ = 0) + Σ λₖ ∂Gₖ/∂qᵢ = 0,      Gₖ(q) = 0

The forces are those of the full equations of motion; their root is found by Newton's method in mpmath, with differences
for the derivatives, from what floats know of it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.time_integration.prepared_motion import equations_of
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LIMIT, STEPS = 240, 60      # digits; steps of Newton's method


class StaticEquations(NamedTuple):
    """r(x) = 0 of x = (q, λ), in the names of these; `near`: q as floats know it, and λ = 0."""

    scene: "Scene"
    residuals: "list[Node]"
    names: Sequence[str]
    near: list[float]


def equations(problem: "Problem") -> StaticEquations:
    """Of the equilibrium that the problem is about; PhysicsError where loads vary, members bend or forces jump."""
    configuration, scene = problem.configuration, equations_of(problem.numeric)
    if problem.numeric.scene.loops is not None and problem.system.preloads:
        raise PhysicsError("static preloads in closed loops are known in floats alone: no reference is found")
    if scene.members or configuration.equilibrium.jumps is not None:
        raise PhysicsError("no reference is found of static positions of members, or where forces jump")
    parts, table = dynamics(scene, problem.scene.freedom.redundant), scene.table
    if any(node.mask & scene.time.mask for node in parts.h):
        raise PhysicsError("no reference is found of where what loads vary about rests")
    if not parts.h:
        raise PhysicsError("nothing moves: there is no position to be found")
    ties = [table.parameter(f"force[{name}]", positive=False) for name in parts.names]
    forces = [table.total([h, *(slope * ties[k] for (k, j), slope in parts.slopes.items() if j == i)])
              for i, h in enumerate(parts.h)]
    still = dict.fromkeys((*scene.v, scene.time), table.zero)
    known = {**configuration.at_rest, **configuration.dependent_values}
    near = [float(known[name]) for name in scene.coordinates]
    return StaticEquations(scene, substitute([*forces, *parts.gaps], still),
                           [*scene.coordinates, *(tie.name for tie in ties)], near + [0.0] * len(ties))


def true_position(problem: "Problem", static: StaticEquations, node: "Node", size: float) -> TrueValues:
    """An expression of the coordinates there, whose digits count from a size on where it is smaller."""
    def found() -> tuple[list, Any]:
        arithmetic = multiprecision()
        known = problem.numeric.values(arithmetic)

        def residual(*x: Any) -> list:
            return evaluate(static.residuals, arithmetic, {**known, **dict(zip(static.names, x, strict=True))})

        x = _root(residual, static.near)
        value, = evaluate([node], arithmetic, {**known, **dict(zip(static.names, x, strict=True))})
        return [value], max(size, abs(value))

    return settled(found, limit=LIMIT, sized=True)


def _root(residual, near):
    """Where the steps get no smaller; RuntimeError where they do not become small."""
    x, last = mpmath.matrix(near), mpmath.inf
    for _ in range(STEPS):
        step = mpmath.lu_solve(mpmath.mp.jacobian(residual, x), -mpmath.matrix(residual(*x)))
        size = mpmath.norm(step, mpmath.inf)
        if not size or (size >= last and size < mpmath.sqrt(mpmath.eps) * (1 + mpmath.norm(x, mpmath.inf))):
            return x
        x, last = x + step, size
    raise RuntimeError("Newton's method does not end")
