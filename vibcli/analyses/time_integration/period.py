"""The period of the actual motion of one conservative degree of freedom, by quadrature.

½ m(q) q̇² + V(q) = E between the places q₁ < q₂ at which it comes to rest, so T = 2 ∫ √(m/(2(E − V))) dq. Where V
is known in letters this is found to more digits than floats have (precise_period.py), else from V′ alone: with
q = (q₁ + q₂)/2 + (q₂ − q₁)/2 sin θ the integrand is smooth and periodic in θ, and the midpoint rule converges with
every power; E − V is found as an integral of −V′ from the nearer end, where the difference would lose its digits.
"""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial.legendre import leggauss

from vibcli.analyses.time_integration.high_precision_period import DIGITS, Energies, time_between
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.energies import effective_potential
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.numerics.root_finding import last_place
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.numeric_code import SWITCHED, Compiled

if TYPE_CHECKING:
    import mpmath

    from vibcli.scene.scene import Scene

FIRST, MOST = 16, 1 << 15
ACCURACY, ENOUGH, ROUNDING, EPS = 1e-14, 1e-9, 1e-14, 2.0**-52
INNER, MOST_PARTS = 28, 64
AT_REST = 4 * EPS
RESTS = ("the scene is at rest: its motion has no period", "give it an `initial` state that is none of equilibrium")
STEPS, WIDEST = 400, 20.0     # of a twentieth of the way that a linear spring would go
FARTHER = 0.05                # of the way gone and of q, if more: near an unstable place a spring says little


def exact_period(scene: "Scene", values: "Mapping[str, float | mpmath.mpf]", q: "float | mpmath.mpf",
                 v: "float | mpmath.mpf") -> tuple[float, float] | None:
    """(period [s], relative error) of the motion from (q, v); None where the scene has several coordinates, or is not
    conservative. Numbers may be floats or mpmath's.

    PhysicsError where the motion does not come back."""
    import mpmath

    if len(scene.q) != 1 or not _conservative(scene):
        return None
    slope, inertia = _functions(scene, {name: float(value) for name, value in values.items()})
    with mpmath.workdps(DIGITS):
        energies, place = Energies(scene, values), mpmath.mpf(q)
        if energies.known_at(place):
            level, m = energies(place)
            speed = m * mpmath.mpf(v) ** 2 / 2
            _require_motion(slope, float(place), float(speed))
            left, right = (_turn(slope, energies.gain, place, speed, side) for side in (-1, 1))
            _require_way(left, right)
            bottom = last_place(lambda q: float(slope(np.array([float(q)]))[0]) < 0, left, right)[1]
            halves = (left, bottom), (bottom, right)
            return float(2 * sum(time_between(energies, level + speed, *ends) for ends in halves)), ROUNDING
    return _of_forces(slope, inertia, float(q), float(v))


def _of_forces(slope, inertia, q, v):
    """(period, relative error) from V′ and m alone, in floats."""
    def gain(start, end):
        return float(_integrals(slope, np.array([start]), np.array([end - start]))[0])

    speed = 0.5 * inertia(np.array([q]))[0] * v * v
    _require_motion(slope, q, float(speed))
    left, right = (_turn(slope, gain, q, speed, side) for side in (-1, 1))
    _require_way(left, right)
    found, change = _by_midpoints(slope, inertia, left, right)
    wider = left - _known_to(slope, left, right), right + _known_to(slope, right, left)
    moved, _ = _by_midpoints(slope, inertia, *wider)
    return found, ROUNDING + change + 2 * abs(moved / found - 1)


def _require_motion(slope, q, speed):
    """PhysicsError at rest in an equilibrium, as well as floats know the place of it."""
    force = abs(float(slope(np.array([q]))[0]))
    if not speed and force <= AT_REST * abs(q) * _stiffness(slope, q):
        raise PhysicsError(*RESTS)


def _require_way(left, right):
    if left == right:
        raise PhysicsError(*RESTS)


def _known_to(slope, end, other):
    """How well the place of an end is known, from the rounding of what V gains on the way to it."""
    places = np.linspace(other, end, 64)
    force = np.abs(slope(places))
    return EPS * (abs(end) + abs(end - other) * float(force.mean()) / max(float(force[-1]), 1e-300))


def _by_midpoints(slope, inertia, left, right):
    """(period, relative change at the last doubling of the points)."""
    middle, reach = 0.5 * (left + right), 0.5 * (right - left)
    points, before, found, change = FIRST, np.inf, 0.0, np.inf
    while points <= MOST:
        theta = (np.arange(points) + 0.5) * (math.pi / points) - 0.5 * math.pi
        drops = _drops(slope, middle, reach, theta)
        q_theta = middle + reach * np.sin(theta)
        with np.errstate(all="ignore"):
            found = math.tau / points * np.sum(reach * np.cos(theta) * np.sqrt(inertia(q_theta) / (2 * drops)))
        last, change = change, abs(found - before)
        if change <= ACCURACY * found or (change <= ENOUGH * found and change > 0.25 * last):
            return float(found), float(change / found)
        points, before = 2 * points, found
    if change <= ENOUGH * found:
        return float(found), float(change / found)
    raise PhysicsError("the period of this motion is not found: it comes to rest only in the limit",
                       "start it a little off the unstable equilibrium")


def _conservative(scene):
    """Is the energy ½ m(q) q̇² + V(q) constant, with smooth forces?"""
    lost = scene.dampers or "C" in scene.matrices or not scene.energies["Phi"].is_zero
    return not (scene.timed or lost or scene.forces or scene.loops is not None
                or scene.table.called.intersection(SWITCHED))


def _functions(scene, floats):
    """V′ and m as functions of arrays of places."""
    force = gradient(effective_potential(scene)).get(scene.q[0], scene.table.zero)
    compiled = Compiled(scene, floats, None, [force, dynamics(scene).M[0, 0]])

    def part(number):
        def values(q):
            found = compiled(np.zeros(q.size), q.reshape(1, -1), np.zeros((1, q.size)))[number]
            return np.broadcast_to(found, (q.size,)).reshape(q.shape)
        return values
    return part(0), part(1)


def _turn(slope, gain, q, speed, side):
    """Where the motion comes to rest on one side: V(q*) = V(q) + speed."""
    force = float(slope(np.array([float(q)]))[0])
    if not speed and side * force >= 0 and force:
        return q
    scale = _scale(slope, float(q), float(speed))
    low, high, gained, step = q, None, 0.0, scale
    for _ in range(STEPS):
        trial = _not_beyond_a_top(slope, low, low + side * step, side)
        more = gain(low, trial)
        if gained + more >= speed and (speed or gained + more > 0):
            high = trial
            break
        low, gained = trial, gained + more
        step = min(1.1 * step, max(WIDEST * scale, FARTHER * min(abs(low - q), abs(q))))
        if not math.isfinite(gained):
            break
    if high is None:
        raise PhysicsError("this motion does not come back: nothing turns it round",
                           "ask for its value at a time")
    for _ in range(200):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        more = gain(low, middle)
        if gained + more >= speed:
            high = middle
        else:
            low, gained = middle, gained + more
    return high


def _not_beyond_a_top(slope, low, trial, side):
    """The trial, or the greatest V on the way to it where that lies between."""
    def climbs(q):
        return side * float(slope(np.array([float(q)]))[0]) > 0

    if climbs(trial) or not climbs(low):
        return trial
    return last_place(climbs, low, trial)[1]


def _scale(slope, q, speed):
    """A small part of how far the motion goes."""
    stiffness = _stiffness(slope, q)
    force = abs(float(slope(np.array([q]))[0]))
    far = math.sqrt(2 * speed / stiffness) if speed and stiffness else force / stiffness if stiffness else abs(q) or 1.0
    return 0.05 * far


def _stiffness(slope, q):
    """|V″|, by a difference."""
    step = 1e-6 * (abs(q) or 1.0)
    return abs(float(np.diff(slope(np.array([q - step, q + step])))[0])) / (2 * step)


def _drops(slope, middle, reach, theta):
    """E − V at the places, each integrated from the nearer end: with s = sin θ, the way to it is reach·(1 ∓ s)."""
    side = np.where(theta >= 0, 1.0, -1.0)
    gap = reach * 2 * np.sin(0.25 * math.pi - 0.5 * np.abs(theta)) ** 2       # 1 − sin|θ| without a difference
    return -_integrals(slope, middle + side * reach, -side * gap)


def _integrals(slope, starts, ways):
    """V(start + way) − V(start) = ∫ V′ of each, by Gauss's rule on 1, 2, 4 … equal parts, until halving them changes
    nothing."""
    x, w = leggauss(INNER)

    def by(parts):
        c = ((np.arange(parts)[:, None] + 0.5 * (1 + x)) / parts).ravel()
        return ways * (slope(starts[:, None] + ways[:, None] * c) @ np.tile(0.5 * w / parts, parts))

    parts, found = 1, by(1)
    while parts < MOST_PARTS:
        parts, before, found = 2 * parts, found, by(2 * parts)
        if not np.any(np.abs(found - before) > ACCURACY * np.abs(found)):
            break
    return found
