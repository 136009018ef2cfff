"""Nonlinear springs and dampers: V_e(s) and Φ_e(ṡ) from their laws, F = dV/ds and F = dΦ/dṡ."""

from typing import NamedTuple

from vibcli.symbolic.antiderivatives import from_zero
from vibcli.symbolic.derivatives import gradient, substitute
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


class Laws:
    """The part of a Scene that knows its nonlinear springs and dampers."""

    def law_variable(self, damper=False):
        return self.table.variable("the rate" if damper else "the deflection")

    def integrated(self, force, x, where):
        """∫₀ˣ force dx; None where it is not found, which is reported."""
        found = from_zero(force, x)
        if found is None:
            self.report(where, "the energy of this law is not found", "write it as a sum of powers, |d|^n, sines and "
                        "exponentials of d; other energies stand under `energies`")
        return found

    def value_at(self, node, x, place=None):
        """A function of x at a place, 0 if none is given."""
        return substitute([node], {x: self.table.zero if place is None else place})[0]

    def add_law(self, s, x, energy, damper=False, bound=None):
        """V(s) of a spring or Φ(ṡ) of a damper, given as a function of x."""
        force = gradient(energy).get(x, self.table.zero)
        self.laws.append(Law(self.owner, s, x, energy, force, damper, bound))

    def settle_laws(self):
        """Add all laws to V and Φ."""
        for law in self.laws:
            key = "Phi" if law.damper else "V"
            self.energies[key] = self.energies[key] + law.potential(self)

    def law_switches(self):
        """({argument: owner}, {argument: σ₀}) of what bends or jumps in the laws."""
        owners, bounds = {}, {}
        for law in self.laws:
            for part in reachable([law.potential(self)]):
                if part.name in BENT and part.mask:
                    u = part.args[0] - part.args[1] if part.name in ("min", "max") else part.args[0]
                    sign = self.table.call("sign", u)
                    if sign.op != "call":
                        sign = self.table.call("sign", -u)
                    owners[sign.args[0]] = law.owner
                    if law.bound is not None:
                        bounds[sign.args[0]] = law.bound
        return owners, bounds
