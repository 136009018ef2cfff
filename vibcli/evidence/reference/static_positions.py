"""Static positions and forces to many digits: forces at rest vanish, with those of constraints, whose gaps are closed.

    hᵢ(q, q̇ = 0) + Σ λₖ ∂Gₖ/∂qᵢ = 0,      Gₖ(q) = 0,      R = h_ρ + Σ λₖ ∂Gₖ/∂ρ at ρ = 0

of a support that a displacement ρ would release. The forces are those of the full equations of motion, without loads in
time; their root is found by Newton's method in mpmath, with differences for the derivatives, from what floats know."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.mechanics.equations_of_motion import Dynamics, dynamics
from vibcli.mechanics.high_precision import in_its_place
from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING
from vibcli.mechanics.linearise import without_time
from vibcli.mechanics.static_preload import take_over
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LIMIT, STEPS = 240, 60      # digits; steps of Newton's method


class StaticEquations(NamedTuple):
    """r(x) = 0 of x = (q, λ), in the names of these; `near`: q as floats know it, and λ = 0; forces: {signal: node} of
    constraints, and of supports that are released; still: {symbol: 0} of what does not move; parts: the Dynamics of
    which it is, without loads in time."""

    scene: "Scene"
    residuals: "list[Node]"
    names: Sequence[str]
    near: list[float]
    forces: "dict[str, Node]"
    still: "dict[Node, Node]"
    parts: Dynamics

    def root(self, known: Mapping[str, Any]) -> dict[str, Any]:
        """{name: number} of x at the working precision, {parameter: number} being known."""
        arithmetic = multiprecision()

        def residual(*x: Any) -> "list[mpmath.mpf]":
            return evaluate(self.residuals, arithmetic, {**known, **dict(zip(self.names, x, strict=True))})

        return dict(zip(self.names, newton(residual, self.near), strict=True))


def equations(configuration: "Configuration", released: bool = False, rests: bool = True) -> StaticEquations:
    """Of the equilibrium of a Configuration, with its supports `released` where they are asked for; PhysicsError where
    members bend or forces jump; not `rests`: where it moves alone, jumps there being no matter."""
    if configuration.scene.members or (rests and configuration.equilibrium.jumps is not None):
        raise PhysicsError("no reference is found of static positions of members, or where forces jump")
    scene = _unloaded(configuration, released)
    redundant = configuration.scene.freedom.redundant
    if released and redundant:
        raise PhysicsError("the scene is supported by more than it needs: no reference is found of its reactions")
    parts, table = dynamics(scene, redundant), scene.table
    parts = parts._replace(h=[without_time(scene, h) for h in parts.h])
    if not parts.h:
        raise PhysicsError("nothing moves: there is no position to be found")
    still = dict.fromkeys((*scene.v, scene.time, *scene.released), table.zero)
    ties = [table.parameter(f"force[{name}]", positive=False) for name in parts.names]
    forces = [table.total([h, *(slope * ties[k] for (k, j), slope in parts.slopes.items() if j == i)])
              for i, h in enumerate(parts.h)]
    forces, count = substitute(forces, still), len(scene.q) - len(scene.released)
    signs = {tie.name: (tie.signal, 1 if tie.form in LENGTHENING else -1) for tie in scene.constraints}
    told = {signs[name][0]: tie * signs[name][1] for name, tie in zip(parts.names, ties, strict=True)}
    told |= dict(zip([q.name for q in scene.released], forces[count:], strict=True))
    known = {**configuration.at_rest, **configuration.dependent_values}
    near = [float(known[q.name]) for q in scene.q[:count]] + [0.0] * len(ties)
    return StaticEquations(scene, [*forces[:count], *substitute(parts.gaps, still)],
                           [*(q.name for q in scene.q[:count]), *(tie.name for tie in ties)], near, told, still, parts)


def resting_place(configuration: "Configuration", static: StaticEquations, known: Mapping[str, Any]) -> dict[str, Any]:
    """{coordinate: number} at the working precision where it rests: as drawn, if that is there and nothing is tied."""
    if configuration.equilibrium.drawn and not static.parts.gaps:
        return in_its_place(static.scene.drawn, known, multiprecision())
    return static.root(known)


def _unloaded(configuration: "Configuration", released: bool) -> "Scene":
    """The scene with all its coordinates, what drives it held as drawn, without loads in time."""
    system = configuration.system
    scene = configuration.scene.with_released_supports() if released else system.scene_with_multipliers
    if scene.static_preloads:
        scene = take_over(scene, system.preloads)
    scene = scene.resting
    steady = [load._replace(weight=load.steady, offset=None) for load in scene.forces]
    return scene.with_parts(contents=scene.contents._replace(forces=steady))


def true_position(problem: "Problem", static: StaticEquations, node: "Node", size: float) -> TrueValues:
    """An expression of the coordinates there, whose digits count from a size on where it is smaller."""
    def found() -> "tuple[list[mpmath.mpf], float | mpmath.mpf]":
        arithmetic = multiprecision()
        known = problem.numeric.values(arithmetic)
        value, = evaluate([node], arithmetic, {**known, **static.root(known)})
        nothing = abs(value) <= size * mpmath.mpf(10) ** (-mpmath.mp.dps // 2)
        return [mpmath.mpf(0) if nothing else value], max(size, abs(value))

    return settled(found, limit=LIMIT, sized=True)


def newton(residual: Callable[..., Sequence[Any]], near: Sequence[Any]) -> Any:
    """Where the steps get no smaller; RuntimeError where they do not become small."""
    x, last = mpmath.matrix(near), mpmath.inf
    for _ in range(STEPS):
        step = mpmath.lu_solve(mpmath.mp.jacobian(residual, x), -mpmath.matrix(residual(*x)))
        size = mpmath.norm(step, mpmath.inf)
        large = 1 + mpmath.norm(x, mpmath.inf)
        if size <= mpmath.eps * large or (size >= last and size < mpmath.sqrt(mpmath.eps) * large):
            return x
        x, last = x + step, size
    raise RuntimeError("Newton's method does not end")
