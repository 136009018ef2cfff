"""The period of one conservative degree of freedom from V in letters, to more digits than floats have.

Just below an unstable place the time hangs on E − V(top), a small difference of large energies: floats lose it, mpmath
does not. T = 2 ∫ √(m/(2(E − V))) dq is found by the double exponential rule

    q = q₂ − (q₂ − q₁)/(1 + e^{π sinh u})          dq/du = (q₂ − q₁) (π/4) cosh u / cosh²(½π sinh u)

on each piece between the places where V bends or is stationary: it stands roots at the ends and what is steep or flat
near them. The step is halved until nothing changes.
"""

from collections.abc import Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.analyses.nonlinear.well import EPS
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.energies import effective_potential
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.numerics.root_finding import last_place
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.nonlinear.turning_points import TurningPoint
    from vibcli.analyses.nonlinear.well import Well
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

DIGITS, SHOWN = 60, 1e-15
FARTHEST, HALVINGS = 4.2, 12        # of u: beyond it the ends are nearer than 10⁻⁴⁴ of the way
STEPS, SECANTS = 60, 40
NEAR = 2.0**-50
LOST = ("this motion does not come back: nothing turns it round", "ask for its value at a time")
ROUNDING = 1e-14
ABOUT, ALIKE = 1e-3, 1e-50          # of the range of a signal: it is about that, and that


class Energies:
    """V and m of the one coordinate of a scene at mpmath numbers, at the working precision."""

    def __init__(self, scene: "Scene", values: "Mapping[str, float | mpmath.mpf]") -> None:
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

    def left(self, energy: "mpmath.mpf", q: "mpmath.mpf") -> "mpmath.mpf":
        """E − V; negative where V is no real number."""
        try:
            return energy - self(q)[0]
        except (ValueError, ArithmeticError):
            return -1

    def of(self, node: "Node", q: "mpmath.mpf") -> "mpmath.mpf":
        """The value of an expression of q."""
        return evaluate([node], self.arithmetic, {**self.known, self.name: q})[0]

    def __call__(self, q: "mpmath.mpf") -> "list[mpmath.mpf]":
        """(V, m); ArithmeticError where they are no real numbers there."""
        import mpmath

        found = evaluate(self.nodes, self.arithmetic, {**self.known, self.name: q})
        if not all(mpmath.isfinite(x) and not mpmath.im(x) for x in found):
            raise ArithmeticError
        return [mpmath.re(x) for x in found]


def precise_period(energies: Energies, well: "Well", start: "tuple[Any, Any]",
                   ends: "tuple[TurningPoint, TurningPoint]") -> tuple[float, float] | None:
    """(period, relative error) of the motion from a start (q, v) between turning points that floats know; None where V
    is not known in letters, or the turning points stand for one place in these digits."""
    import mpmath

    with mpmath.workdps(DIGITS):
        q, v = map(mpmath.mpf, start)
        found = _period(energies, well, q, v, ends) if energies.known_at(q) else None
        return (float(found), ROUNDING) if found else None


def period_at_amplitude(energies: Energies, well: "Well", signal: "Node", amplitude: float,
                        ends: "tuple[TurningPoint, TurningPoint]") -> tuple[float, float] | None:
    """The same of the motion in which a signal has an amplitude, its turning points being known about; the error is
    that of a float for the amplitude, too."""
    import mpmath

    with mpmath.workdps(DIGITS):
        right = mpmath.mpf(ends[1].q)
        if not energies.known_at(right):
            return None
        rights = [_right_end(energies, well, signal, 2 * amplitude * (1 + part), ends) for part in (0, mpmath.mpf(EPS))]
        if None in rights:
            rights = [right, right - ends[1].error]
        period, other = (_period(energies, well, q, mpmath.mpf(0), ends) for q in rights)
        return (float(period), ROUNDING + float(abs(other / period - 1))) if period else None


def _right_end(energies: Energies, well: "Well", signal: "Node", wanted: "float | mpmath.mpf",
               ends: "tuple[TurningPoint, TurningPoint]") -> "mpmath.mpf | None":
    """The right turning point of the motion in which a signal differs so much at the two, by secants; None where it
    does not about there."""
    import mpmath

    def missing(right: "mpmath.mpf") -> "mpmath.mpf":
        left = _end(energies, well, energies(right)[0], right, 0, ends[0], -1)
        return abs(energies.of(signal, right) - energies.of(signal, left)) - wanted

    x = mpmath.mpf(ends[1].q)
    y = x - mpmath.mpf(2) ** -60 * (x - ends[0].q)
    at_x, at_y = missing(x), missing(y)
    if abs(at_x) > ABOUT * wanted:
        return None
    for _ in range(SECANTS):
        if at_x == at_y or abs(at_x) <= ALIKE * wanted:
            break
        x, y = x - at_x * (y - x) / (at_y - at_x), x
        at_x, at_y = missing(x), at_x
    return x


def _period(energies: Energies, well: "Well", q: "mpmath.mpf", v: "mpmath.mpf",
            ends: "tuple[TurningPoint, TurningPoint]") -> "mpmath.mpf":
    level, m = energies(q)
    energy = level + m * v**2 / 2
    stops = [_end(energies, well, energy, q, v, end, side) for end, side in zip(ends, (-1, 1), strict=True)]
    places = sorted(_kink(energies, well, place) for place in well.breaks(*map(float, stops)))
    stops[1:1] = [place for place in places if stops[0] < place < stops[1]]
    return 2 * sum(time_between(energies, energy, *piece) for piece in pairwise(stops))


def _end(energies: Energies, well: "Well", energy: "mpmath.mpf", q: "mpmath.mpf", v: "int | mpmath.mpf",
         end: "TurningPoint", side: int) -> "mpmath.mpf":
    """A turning point to more digits, looked for from where floats have it; PhysicsError where there is none."""
    import mpmath

    if not v and end.q == float(q) and not end.error:
        return q
    step = mpmath.mpf(max(end.error, NEAR * abs(end.q), 1e-300))
    inner, outer = (mpmath.mpf(end.q) + sense * side * step for sense in (-1, 1))
    for _ in range(STEPS):
        if energies.left(energy, inner) > 0:
            break
        inner -= side * step
        step *= 2
    step = abs(outer - end.q)
    for _ in range(STEPS):
        is_beyond = side * well.force_at(float(outer)) <= 0
        if is_beyond:
            outer = last_place(lambda x: side * energies.of(well.slope, x) > 0, inner, outer)[1]
        if energies.left(energy, outer) <= 0:
            return last_place(lambda x: energies.left(energy, x) > 0, inner, outer)[1]
        if is_beyond:
            break
        outer += side * step
        step *= 2
    raise PhysicsError(*LOST)


def _kink(energies: Energies, well: "Well", place: float) -> "mpmath.mpf":
    """A place where V bends, to more digits; where it is stationary as it is."""
    import mpmath

    for u in well.bends:
        x, y = mpmath.mpf(place), mpmath.mpf(place) * (1 + mpmath.mpf(2) ** -40) + mpmath.mpf(2) ** -1000
        at_x, at_y = energies.of(u, x), energies.of(u, y)
        slope = (at_y - at_x) / (y - x)
        if not slope or abs(at_x / slope) > 2.0**-40 * abs(place):
            continue
        for _ in range(SECANTS):
            if not at_x or at_x == at_y:
                break
            x, y = x - at_x * (y - x) / (at_y - at_x), x
            at_x, at_y = energies.of(u, x), at_x
        return x
    return mpmath.mpf(place)


def time_between(energies: Any, energy: "Node", left: Any, right: Any) -> "mpmath.mpf":
    """∫ √(m/(2(E − V))) dq."""
    import mpmath

    way, pi = right - left, mpmath.pi

    def part(u: "mpmath.mpf") -> "mpmath.mpf":
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
