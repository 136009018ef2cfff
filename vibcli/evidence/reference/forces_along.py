"""What constraints and supports exert along a motion, as expressions of coordinates, velocities and accelerations:

    G Gᵀ λ = −G (M q̈ + h),  G = ∂G_k/∂q        R_ρ = (M q̈ + h)_ρ + Σ λ_k ∂G_k/∂ρ   at ρ = 0

of a scene whose supports are released by displacements ρ.
"""

from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import CONTACT
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING
from vibcli.mechanics.signals import in_contact, normal_of, reaction_of
from vibcli.mechanics.static_preload import solve_linear, take_over
from vibcli.symbolic.transfer_between_tables import written_in

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class TrueForces:
    """Of a Problem, in the symbols of a scene whose equations are followed."""

    def __init__(self, problem: "Problem", scene: "Scene") -> None:
        if problem.scene.freedom.redundant:
            raise PhysicsError("the scene is supported by more than it needs: no reference is found of its reactions")
        self._problem, self._followed = problem, scene
        self._released = take_over(problem.scene.with_released_supports(), problem.system.preloads)
        self._all = self._found()

    def _found(self) -> "dict[str, Node]":
        """{signal: node} in the symbols of the released scene."""
        scene = self._released
        parts, table, n = dynamics(scene), scene.table, len(scene.q)
        left = [table.total([h, *(parts.M[pair] * scene.a[j] for j in range(n) if (
            pair := (min(i, j), max(i, j))) in parts.M)]) for i, h in enumerate(parts.h)]
        real, ties = range(n - len(scene.released)), range(len(parts.names))
        G = [[parts.slopes.get((k, i), table.zero) for i in range(n)] for k in ties]
        multipliers = solve_linear([[table.total([G[k][i] * G[m][i] for i in real]) for m in ties] + [
            -table.total([G[k][i] * left[i] for i in real])] for k in ties], table.zero)
        by_name = {tie.name: tie for tie in scene.constraints}
        found = {}
        for name, force in zip(parts.names, multipliers, strict=True):
            found[by_name[name].signal] = force * (1 if by_name[name].form in LENGTHENING else -1)
        for i, q in enumerate(scene.released, len(real)):
            found[q.name] = table.total([left[i], *(G[k][i] * multipliers[k] for k in ties)])
        return found

    def __getitem__(self, text: str) -> "Node":
        """That of a signal."""
        name, part, *_ = signal_name(text)
        if part in CONTACT:
            reaction = [self._all[f"{name}.reaction.{axis}"] for axis in "xy"]
            return cast("Node", self._written(in_contact(part, normal_of(self._released, name), reaction)))
        return cast("Node", self._written(self._all[reaction_of(self._problem.system, text, self._all)]))

    def _written(self, node: Any) -> Any:
        scene, followed = self._released, self._followed
        table, held = followed.table, {q.name for q in scene.released}
        known = {name: table.parameter(name, leaf in scene.table.positive)
                 for name, leaf in scene.parameters.nodes.items() if leaf.op == "symbol"}
        known[scene.time.name] = followed.time
        for name in scene.coordinates:
            for primes in range(3):
                known[name + "'" * primes] = table.zero if name in held else followed.symbol(name, primes)
        return written_in(table, [node], known)[0]
