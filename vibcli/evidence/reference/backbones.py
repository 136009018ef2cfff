"""The free motion of one coordinate about an equilibrium in which a signal has an amplitude, half its range, without
dampers and loads in time: between the places a, b with V(a) = V(b) where it turns, and which the range tells,

    T = 2 ∫ dq √(M/2(V(a) − V))

by tanh-sinh quadratures (Takahasi & Mori 1974) between these and where forces bend or jump, over the square root of the
way from where it turns.
"""

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.motion import FULL, Motion
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.evidence.reference.static_positions import StaticEquations
from vibcli.evidence.reference.swings import SwingingCoordinate
from vibcli.mechanics.energies import effective_potential
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.symbolic.node import Node

DIGITS, START, LIMIT, GROWTH = 30, 40, 120, 1.4
DEEPER = 3              # times the digits: V(a) − V cancels next to a
SAMPLES = 2001          # of a function between two places
CLOSE = 1e-6            # relative: of where it turns, in floats and in more digits


class FreeSwing(NamedTuple):
    """A free motion of one coordinate, its signal with its amplitude; near: about where the coordinate turns."""

    motion: Motion
    signal: "Node"
    amplitude: Callable[[], Any]
    near: tuple[float, float]

    def at(self, node: "Node", q: Any) -> Any:
        """An expression at a place, at the working precision."""
        scene = self.motion.scene
        return evaluate([node], multiprecision(), {**self.motion.values(mpmath.mp.prec), scene.q[0].name: q,
                                                   scene.v[0].name: mpmath.mpf(0)})[0]

    def roots(self, node: "Node") -> list[Any]:
        """Places between at which an expression passes through zero."""
        scene, places = self.motion.scene, np.linspace(*self.near, SAMPLES)[1:-1]
        found = np.broadcast_to(evaluate([node], Arrays, {
            **self.motion.floats, scene.q[0].name: places, scene.v[0].name: 0.0})[0], places.shape)
        passed = [mpmath.findroot(partial(self.at, node), tuple(map(mpmath.mpf, places[i:i + 2])), solver="anderson",
                                  verify=False) for i in np.flatnonzero(found[:-1] * found[1:] < 0)]
        return [*passed, *map(mpmath.mpf, places[found == 0])]

    def turns(self) -> tuple[Any, Any]:
        """(a, b)"""
        V, slopes = effective_potential(self.motion.scene), gradient(self.signal)
        between = [self.at(self.signal, x) for x in self.roots(slopes.get(
            self.motion.scene.q[0], self.motion.scene.table.zero))]

        def conditions(a: Any, b: Any) -> Sequence[Any]:
            known = [self.at(self.signal, a), self.at(self.signal, b), *between]
            return [self.at(V, a) - self.at(V, b), (max(known) - min(known)) / 2 - self.amplitude()]

        a, b = mpmath.findroot(conditions, self.near, tol=mpmath.mpf(10) ** (-1.5 * mpmath.mp.dps), maxsteps=60)
        if max(abs(a - self.near[0]), abs(b - self.near[1])) > CLOSE * (b - a):
            raise PhysicsError("the reference finds that this motion turns elsewhere")
        return a, b

    def period(self) -> Any:
        """T at the working precision."""
        own, one = mpmath.mp.dps, SwingingCoordinate(self.motion)
        with mpmath.workdps(DEEPER * own):
            a, b = self.turns()
            bends = sorted(x for bend in one.bends for x in self.roots(bend)) or [(a + b) / 2]
            inner = pairwise(sorted(bends))
        total = self._time(a, bends[0] - a, own, True) + self._time(b, bends[-1] - b, own, True)
        return 2 * mpmath.fsum([total, *(self._time(c, d - c, own, False, a) for c, d in inner)])

    def _time(self, begin: mpmath.mpf, way: mpmath.mpf, own: int, turned: bool, top: Any = None) -> mpmath.mpf:
        """From one place on, on a way; turned: it turns there, else at `top`."""
        V, (M,) = effective_potential(self.motion.scene), self.motion.parts.M.values()
        with mpmath.workdps(DEEPER * own):
            E = self.at(V, begin if turned else top)

        def rate(u: Any) -> Any:
            with mpmath.workdps(DEEPER * own):
                q = begin + way * (u * u if turned else u)
                return abs(way) * (2 * u if turned else 1) * mpmath.sqrt(self.at(M, q) / (2 * (E - self.at(V, q))))

        return mpmath.quad(rate, [0, 1])


def free_motion(numeric: "NumericSystem", static: StaticEquations) -> Motion:
    """The Motion without what is lost, its start left open: of the forces what stays where all velocities are turned
    about."""
    scene, parts = static.scene, static.parts
    if parts.gaps:
        raise PhysicsError("no reference is found of free motions where loops are closed")
    if scene.dampers or any(law.damper for law in scene.laws):
        back = substitute(parts.h, {v: -v for v in scene.v})
        parts = parts._replace(h=[(h + other) * HALF for h, other in zip(parts.h, back, strict=True)])

    def values(bits: int) -> Any:
        with mpmath.workprec(2 * bits):
            return {**numeric.values(multiprecision()), scene.time.name: mpmath.mpf(0)}

    return Motion(scene, parts, values, lambda bits: [0] * 2 * len(scene.q), {**numeric.floats, scene.time.name: 0.0},
                  FULL, False)


def true_period(swing: FreeSwing) -> TrueValues:
    """T of a motion."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        T = swing.period()
        return [T], T

    return settled(found, DIGITS, START, LIMIT, GROWTH, sized=True)


def from_its_turn(swing: FreeSwing) -> Motion:
    """The Motion from where it turns."""
    def start(bits: int) -> list[int]:
        with mpmath.workprec(2 * bits):
            return [fixed_point(swing.turns()[0], bits), 0]

    return swing.motion._replace(start=start)
