"""The period of the actual motion of one conservative degree of freedom, by quadrature.

½ m(q) q̇² + V(q) = E between the places q₁ < q₂ at which it comes to rest, so T = 2 ∫ √(m/(2(E − V))) dq, in floats
(period_in_floats.py), or in more digits where rounding would be felt, as next to an unstable place
(high_precision_period.py).
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.period_in_floats import period_between, periods_between
from vibcli.analyses.nonlinear.turning_points import RESTS, TurningPoint, require_motion, turning_point
from vibcli.analyses.nonlinear.well import Well
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from collections.abc import Sequence

    import mpmath

    from vibcli.analyses.nonlinear.motions_by_amplitude import MotionsOfFamily
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

GOOD, ENOUGH = 1e-14, 1e-6      # relative errors of a period: more digits are not asked for, nothing is told
IN_A_TABLE = 5e-13              # the same of each of many; it bounds more than rounding does
LIMIT = ("the period of this motion is not found: it comes to rest only in the limit",
         "start it a little off the unstable equilibrium")


def exact_period(scene: "Scene", values: "Mapping[str, float | mpmath.mpf]", q: "float | mpmath.mpf",
                 v: "float | mpmath.mpf") -> tuple[float, float] | None:
    """(period [s], relative error) of the motion from (q, v); None where the scene has several coordinates, or is not
    conservative. Numbers may be floats or mpmath's.

    PhysicsError where the motion does not come back."""
    if len(scene.q) != 1 or not is_conservative(scene):
        return None
    well, place = Well(scene, {name: float(value) for name, value in values.items()}), float(q)
    speed = 0.5 * float(well.inertia(np.array([place]))[0]) * float(v) ** 2
    require_motion(well, place, speed)
    left, right = (turning_point(well, place, speed, side) for side in (-1, 1))
    if left.q == right.q:
        raise PhysicsError(*RESTS)
    return period_of(well, scene, values, (q, v), (left, right))


def period_of(well: Well, scene: "Scene", values: "Mapping[str, float | mpmath.mpf]",
              start: "tuple[float | mpmath.mpf, float | mpmath.mpf]",
              ends: "tuple[TurningPoint, TurningPoint]") -> tuple[float, float]:
    """(period [s], relative error) of the motion from a start (q, v) that comes to rest at two ends: in more digits
    where floats know it by less than they could, if V is known in letters."""
    from vibcli.analyses.nonlinear.high_precision_period import Energies, precise_period

    return _known(*period_between(well, *ends), GOOD,
                  lambda: precise_period(Energies(scene, values), well, start, ends))


def periods_of(well: Well, scene: "Scene", values: "Mapping[str, float | mpmath.mpf]", signal: "Node",
               motions: "MotionsOfFamily", amplitudes: "Sequence[float]") -> list[tuple[float, float]]:
    """The same of the motions in which a signal, an expression of the coordinate, has these amplitudes."""
    from vibcli.analyses.nonlinear.high_precision_period import Energies, period_at_amplitude

    def sharply(k: int) -> "tuple[float, float]":
        ends = TurningPoint(*motions.left[:, k]), TurningPoint(*motions.right[:, k])
        return period_at_amplitude(Energies(scene, values), well, signal, amplitudes[k], ends)

    good = IN_A_TABLE if len(amplitudes) > 1 else GOOD
    found = zip(*map(np.ndarray.tolist, periods_between(well, motions.left, motions.right)), strict=True)
    return [_known(period, error, good, partial(sharply, k)) for k, (period, error) in enumerate(found)]


def _known(period: float, error: float, good: float,
           sharply: Callable[..., tuple[float, float]]) -> tuple[float, float]:
    """(the period, its relative error), in more digits where it is not good so."""
    if error <= good * period:
        return period, error / period
    found = sharply()
    if found is None and not error <= ENOUGH * period:
        raise PhysicsError(*LIMIT)
    return found or (period, error / period)


def is_conservative(scene: "Scene") -> bool:
    """Is the energy ½ m(q) q̇² + V(q) constant?"""
    return not has_dampers(scene) and has_potential(scene)


def has_dampers(scene: "Scene") -> bool:
    """Does anything lose energy by its speed?"""
    lost = bool(scene.dampers) or "C" in scene.matrices or not scene.energies["Phi"].is_zero
    return lost or any(law.damper for law in scene.laws)


def has_potential(scene: "Scene") -> bool:
    """Have all forces a potential, but for those of dampers? Steady forces along the way have one."""
    return not (scene.timed or any(force.weight.mask for force in scene.forces) or scene.loops is not None)
