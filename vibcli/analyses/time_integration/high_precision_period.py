"""The period of one conservative degree of freedom from V in letters, to more digits than floats have.

Just below an unstable place the time hangs on E − V(top), a small difference of large energies: floats lose it, mpmath
does not. T = 2 ∫ √(m/(2(E − V))) dq is found by the double exponential rule

    q = q₂ − (q₂ − q₁)/(1 + e^{π sinh u})          dq/du = (q₂ − q₁) (π/4) cosh u / cosh²(½π sinh u)

on each side of the bottom of the well: it stands roots at the ends and what is steep or flat near them. The step is
halved until nothing changes.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.energies import effective_potential
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

DIGITS, SHOWN = 60, 1e-15
FARTHEST, HALVINGS = 4.2, 12        # of u: beyond it the ends are nearer than 10⁻⁴⁴ of the way


class Energies:
    """V and m of the one coordinate of a scene at mpmath numbers, at the working precision."""

    def __init__(self, scene: "Scene", values: "Mapping[str, float | mpmath.mpf]"):
        import mpmath

        self.nodes, self.name = [effective_potential(scene), dynamics(scene).M[0, 0]], scene.q[0].name
        self.arithmetic = multiprecision()
        self.known = {key: mpmath.mpf(value) for key, value in values.items()}

    def known_at(self, q: "mpmath.mpf") -> bool:
        """Can they be evaluated there? The energy of some laws has no closed form."""
        try:
            self(q)
        except (KeyError, TypeError, ValueError, ArithmeticError):
            return False
        return True

    def gain(self, start: "mpmath.mpf", end: "mpmath.mpf") -> "mpmath.mpf":
        """V(end) − V(start), nan where one of them is no real number."""
        import mpmath

        try:
            return self(end)[0] - self(start)[0]
        except (ValueError, ArithmeticError):
            return mpmath.nan

    def __call__(self, q: "mpmath.mpf") -> "list[mpmath.mpf]":
        """(V, m); ArithmeticError where they are no real numbers there."""
        import mpmath

        found = evaluate(self.nodes, self.arithmetic, {**self.known, self.name: q})
        if not all(mpmath.isfinite(x) and not mpmath.im(x) for x in found):
            raise ArithmeticError
        return [mpmath.re(x) for x in found]


def time_between(energies: Any, energy: "Node", left: Any, right: Any):
    """∫ √(m/(2(E − V))) dq."""
    import mpmath

    way, pi = right - left, mpmath.pi

    def part(u):
        far = mpmath.exp(-pi * mpmath.sinh(abs(u)))
        gap = way * far / (1 + far)                 # to the nearer end
        V, m = energies(right - gap if u > 0 else left + gap)
        if energy <= V:
            return mpmath.mpf(0)                    # nearer to the end than it is known
        return pi * mpmath.cosh(u) * way * far / (1 + far) ** 2 * mpmath.sqrt(m / (2 * (energy - V)))

    step, found, total = mpmath.mpf(1), mpmath.inf, part(mpmath.mpf(0))
    first = apart = step                            # the new points: ±first, ±(first + apart) …
    for _ in range(HALVINGS):
        before = found
        places = [first + k * apart for k in range(int((FARTHEST - first) / apart) + 1)]
        total += sum(part(u) + part(-u) for u in places)
        found = total * step
        if abs(found - before) <= SHOWN * found:
            return found
        apart, step, first = step, step / 2, step / 2
    raise PhysicsError("the period of this motion is not found: it comes to rest only in the limit",
                       "start it a little off the unstable equilibrium")
