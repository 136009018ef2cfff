"""Nonlinear springs and dampers: V_e(s) and Φ_e(ṡ) from their laws, F = dV/ds and F = dΦ/dṡ."""

from typing import NamedTuple

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable

BENT = ("abs", "sign", "min", "max", "step", "ramp")


class Law(NamedTuple):
    """The element `owner` with the stretch s; `integral`, its V or Φ, and `derivative`, its force, as functions of x,
    which is s of a spring and ṡ of a damper; `bound`: the largest force of dry friction at rest over that in motion."""

    owner: str
    s: object
    x: object
    integral: object
    derivative: object
    damper: bool = False
    bound: object = None

    @property
    def nodes(self):
        """The expressions of the coordinates that it is made of."""
        return [self.s]

    def over(self, new):
        """Itself with its stretch replaced, {node: node}."""
        return self._replace(s=new[self.s])

    def potential(self, scene):
        """V of a spring, Φ of a damper, as a function of the coordinates and velocities."""
        return self._at(scene, self.integral)

    def force(self, scene):
        """F = dV/ds, or dΦ/dṡ."""
        return self._at(scene, self.derivative)

    def energy(self, scene):
        """V of a spring; None of a damper, which stores nothing."""
        return None if self.damper else self.potential(scene)

    def power(self, scene):
        """F ṡ, which a damper dissipates; None of a spring."""
        return self.force(scene) * scene.rate(self.s) if self.damper else None

    def _at(self, scene, node):
        return substitute([node], {self.x: scene.rate(self.s) if self.damper else self.s})[0]



def switches(scene):
    """({argument: owner}, {argument: σ₀}) of what bends or jumps in the laws of a scene."""
    owners, bounds = {}, {}
    for law in scene.laws:
        for part in reachable([law.potential(scene)]):
            if part.name in BENT and part.mask:
                u = part.args[0] - part.args[1] if part.name in ("min", "max") else part.args[0]
                sign = scene.table.call("sign", u)
                if sign.op != "call":
                    sign = scene.table.call("sign", -u)
                owners[sign.args[0]] = law.owner
                if law.bound is not None:
                    bounds[sign.args[0]] = law.bound
    return owners, bounds
