"""Nonlinear springs and dampers: V_e(s) and Φ_e(ṡ) from their laws, F = dV/ds and F = dΦ/dṡ."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import substitute

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class Law(NamedTuple):
    """The element `owner` with the stretch s; `integral`, its V or Φ, and `derivative`, its force, as functions of x,
    which is s of a spring and ṡ of a damper; `bound`: the largest force of dry friction at rest over that in motion."""

    owner: str
    s: "Node"
    x: "Node"
    integral: "Node"
    derivative: "Node"
    damper: bool = False
    bound: "Node | None" = None

    @property
    def nodes(self) -> "list[Node]":
        """The expressions of the coordinates that it is made of."""
        return [self.s]

    def over(self, new: "Mapping[Node, Node]") -> "Law":
        """Itself with its stretch replaced, {node: node}."""
        return self._replace(s=new[self.s])

    def potential(self, scene: "Scene") -> "Node":
        """V of a spring, Φ of a damper, as a function of the coordinates and velocities."""
        return self._at(scene, self.integral)

    def force(self, scene: "Scene") -> "Node":
        """F = dV/ds, or dΦ/dṡ."""
        return self._at(scene, self.derivative)

    def energy(self, scene: "Scene") -> "Node | None":
        """V of a spring; None of a damper, which stores nothing."""
        return None if self.damper else self.potential(scene)

    def power(self, scene: "Scene") -> "Node | None":
        """F ṡ, which a damper dissipates; None of a spring."""
        return self.force(scene) * scene.rate(self.s) if self.damper else None

    def _at(self, scene: "Scene", node: "Node") -> "Node":
        return substitute([node], {self.x: scene.rate(self.s) if self.damper else self.s})[0]
