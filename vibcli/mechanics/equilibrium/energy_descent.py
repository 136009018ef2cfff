"""The potential energy of a scene as a function to be descended, or its forces to be followed where they have none.

Steps are those of a trust region on V(q) with its exact Hessian (Conn, Gould & Toint 2000, alg. 7.3.1): where the
Hessian is singular or indefinite the step goes downhill. Where loads have no potential, or motions are driven, the
force −r is followed by implicit Euler steps that grow as it fades (pseudo-transient continuation, Kelley & Keyes 1998).
Coordinates are scaled by the size of the figure (angles by 1), so that units change nothing; dependent coordinates
follow by closing their loops. The end is polished by plain Newton steps until the residual is that of rounding.
"""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equilibrium.no_equilibrium import FAR, Undefined
from vibcli.mechanics.linearisation import residual_terms
from vibcli.mechanics.numeric_linearisation import Numbers, in_numbers
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.numeric_system import NumericSystem

EPSILON = 2.0**-52
KNOWN = 1e-7        # of the figure: places nearer than 1e-9 of this are one
POLISH, FARTHEST, HUGE = 12, 1e60, 1e140
BESIDE = 1e-6       # of the figure
HIDDEN, SOFT, MOST_IN_DIGITS = 1e-14, 1e-4, 100     # of the forces at the start; of what holds best; coordinates
GROWN, LOWERED, CARRIED = 1e3, 1e-2, 100.0      # of the terms at the start; of the forces there; of the figure


class EnergyDescent:
    """The potential energy of a scene as a function to be descended. q: an array of its n independent coordinates."""

    first_drift = 0.1
    first: Numbers

    def __init__(self, numeric: "NumericSystem", start: Mapping[str, float]) -> None:
        import numpy as np

        self.np, self.numeric, self.scene = np, numeric, numeric.scene
        self.names = self.scene.coordinates
        self.scale = np.array(list(map(numeric.size_along, self.names)))
        self.first_radius = 0.5 if numeric.figure_size else math.inf
        self.met, self.first = [0.0] * len(self.names), None
        self.here, self.blocked, self.undefined = dict(start), False, False

    def forget(self) -> None:
        """Begin a step: nothing has stood in its way."""
        self.blocked = self.undefined = False

    def vector(self, values: Mapping[str, float]) -> "np.ndarray":
        return self.np.array([values[name] for name in self.names], dtype=float)

    def named_plainly(self, q: "np.ndarray") -> dict[str, float]:
        return {name: float(value) + 0.0 for name, value in zip(self.names, q, strict=True)}

    def named(self, q: "np.ndarray") -> dict[str, float]:
        """The position as {coordinate: float}, the dependent ones closed from the last position; None where they
        cannot be."""
        target = self.named_plainly(q)
        loops, floats = self.scene.resting.loops, {**self.numeric.floats, self.scene.time.name: 0.0}
        if loops is None:
            return target
        found = loops.followed({**floats, **self.here}, {**floats, **self.here, **target})
        self.blocked |= found is None
        return None if found is None else {name: found[name] for name in self.here}

    def at(self, q: "np.ndarray") -> Numbers:
        """The Numbers of a position, which becomes the present one."""
        position = self.named(q)
        if position is None:
            raise PhysicsError("the search for the equilibrium reaches a position in which the loops of this scene "
                               "cannot close", "draw the scene nearer to its equilibrium")
        numbers = in_numbers(self.numeric.system.statics, Floats, {**self.numeric.floats, **position})
        stiffness = self.np.abs(numbers.elements.stiffness_array())
        if not (all(map(math.isfinite, numbers.residual)) and self.np.isfinite(stiffness).all()):
            raise Undefined("the forces of this scene are not finite numbers at the place where the search for its "
                            "equilibrium starts", "draw the scene elsewhere, or start elsewhere with `equilibrium:`")
        self.here = position
        bend = stiffness @ (self.np.abs(q) + KNOWN * self.scale)
        numbers = numbers._replace(
            residual_size=[size + float(b) for size, b in zip(numbers.residual_size, bend, strict=True)])
        self.met = list(map(max, self.met, numbers.residual_size))
        if self.first is None:
            self.first = numbers
        return numbers

    def defined(self, q: "np.ndarray") -> Numbers:
        """The Numbers of a position that is tried; None where they are not finite."""
        try:
            return self.at(q)
        except Undefined:
            self.undefined = True
            return None

    def relative(self, numbers: Numbers) -> float:
        """The residual relative to the largest terms met: at q = 0 the terms of a condition may all vanish."""
        return max((abs(r) / size for r, size in zip(numbers.residual, self.met, strict=True) if size), default=0.0)

    def balanced(self, numbers: Numbers) -> bool:
        """Is nothing left of the forces but what rounding leaves?"""
        return self.relative(numbers) <= 1e-9 or _may_vanish(self.numeric, self.here)

    def faded(self, numbers: Numbers) -> bool:
        """Did the force along a coordinate fade away without anything that holds it, as of V = exp(−x)?"""
        held = self.np.abs(numbers.elements.stiffness_array()) @ self.scale
        return any(met and (not (size or k) or abs(r) > max(1e-9 * size, 1e-3 * k)) for met, size, k, r in
                   zip(self.met, numbers.residual_size, held, numbers.residual, strict=True))

    def drowned(self, q: "np.ndarray", numbers: Numbers) -> bool:
        """Did the terms grow so much on the way that what the forces at the start amount to is lost in their rounding?
        Nothing holds what has been carried so far: the forces that act on it as a whole never vanish."""
        def largest(values: "list[float]") -> float:
            return float(self.np.max(self.np.abs(values) * self.scale))

        carried = self.np.abs(q) > CARRIED * self.scale
        left = largest(numbers.residual) + 4 * EPSILON * largest(self.met)
        grown = largest(self.met) > GROWN * largest(self.first.residual_size)
        return bool(carried.any()) and grown and left > LOWERED * largest(self.first.residual)

    def in_doubt(self, numbers: Numbers) -> bool:
        """Does the rounding of the largest terms hide part of the forces at the start, along a motion that is held far
        more softly than others? Floats do not tell how far it goes."""
        np = self.np
        hidden, at_start = (np.max(np.abs(x) * self.scale) for x in (self.met, self.first.residual))
        return EPSILON * hidden > HIDDEN * at_start and self.soft(numbers)

    def soft(self, numbers: Numbers) -> bool:
        """Is some motion held far more softly than others, in a scene that more digits can look into?"""
        np = self.np
        if len(self.names) > MOST_IN_DIGITS:
            return False
        K = numbers.elements.stiffness_array()
        sizes = np.sqrt(np.maximum(np.abs(K).max(axis=1), np.abs(K).max(axis=0)))
        held = np.linalg.svd(K / np.outer(sizes, sizes), compute_uv=False) if sizes.all() else np.zeros(1)
        return bool(held[-1] < SOFT * held[0])

    def at_a_pole(self, q: "np.ndarray", numbers: Numbers) -> bool:
        """Is the force far larger there than on both sides, and as large as at the start? It then grows without bound
        towards a place beside it, and only its slope, which is larger still, makes it look like rounding."""
        np = self.np
        force = np.array(numbers.residual) * self.scale
        size, kept = float(np.linalg.norm(force)), (self.here, self.met, self.first)
        if not size > LOWERED * float(np.linalg.norm(np.array(self.first.residual) * self.scale)):
            return False
        beside = [self.defined(q + side * BESIDE * self.scale * force / size) for side in (-1, 1)]
        self.here, self.met, self.first = kept
        return all(one is not None and GROWN * float(np.linalg.norm(np.array(one.residual) * self.scale)) < size
                   for one in beside)

    def newton(self, numbers: Numbers) -> "np.ndarray":
        """−K⁻¹ r in scaled coordinates; nothing along what is not held."""
        slope = -self.np.array(numbers.residual) * self.scale
        found: np.ndarray = self.np.linalg.lstsq(self.hessian(numbers), slope, rcond=1e-14)[0]
        return found

    def energy(self, q: "np.ndarray") -> float:
        position = self.named(q)
        return math.inf if position is None else evaluate([self.numeric.system.potential], Floats,
                                                          {**self.numeric.floats, **position})[0]

    def flat(self, numbers: Numbers) -> bool:
        return self.relative(numbers) <= 1e-13

    def far(self, q: "np.ndarray") -> bool:
        limit = FAR if math.isfinite(self.first_radius) else FARTHEST
        return bool(self.np.any(self.np.abs(q) > limit * self.scale))

    def hessian(self, numbers: Numbers) -> "np.ndarray":
        """K in scaled coordinates, n × n."""
        K = numbers.elements.stiffness_array()
        if not self.np.all(self.np.isfinite(K)):
            raise PhysicsError("the forces of this scene have no finite slope in a position that the search for its "
                               "equilibrium passes", "draw the scene nearer to its equilibrium")
        return K * self.np.outer(self.scale, self.scale)

    def step(self, q: "np.ndarray", numbers: Numbers, radius: float) -> "tuple[np.ndarray, Numbers, float, bool]":
        """One accepted step: (q, numbers, radius, True), or False where no step lowers V any more."""
        np = self.np
        gradient = np.array(numbers.residual) * self.scale
        values, vectors = np.linalg.eigh(self.hessian(numbers))
        slope = vectors.T @ gradient
        if math.isinf(radius) and values[0] <= _tiny(values):
            with np.errstate(over="ignore"):        # where V hardly bends no step is too long
                radius = float(np.linalg.norm(slope) / max(np.max(np.abs(values)), 1e-300)) or 1.0
        before = self.energy(q)
        for _ in range(60):
            p = _trust_step(values, slope, radius)
            predicted = -(slope @ p + 0.5 * p @ (values * p))
            trial = q + self.scale * (vectors @ p)
            gained = before - self.energy(trial)
            noise = 64 * EPSILON * (abs(before) + abs(predicted))
            falls = abs(gained) < HUGE and (gained >= 0.1 * predicted or predicted <= noise)
            after = self.defined(trial) if falls else None
            if after is not None:
                if predicted <= noise and not self.relative(after) < self.relative(numbers):
                    return q, numbers, radius, False
                length = float(np.linalg.norm(p))
                if gained > 0.75 * predicted and length > 0.9 * radius:
                    radius *= 2.0
                elif math.isinf(radius) and gained < 0.5 * predicted:
                    radius = length
                return trial, after, radius, True
            radius = 0.25 * min(radius, float(np.linalg.norm(p)))
        return q, numbers, radius, False

    def drift(self, q: "np.ndarray", numbers: Numbers, dt: float) -> "tuple[np.ndarray, Numbers, float, bool]":
        """One implicit Euler step of q̇ = −r in scaled coordinates, twice as long as the last where the force fades as
        it should, shorter where K pushes away (else it would turn back) or the force grows by much."""
        np = self.np
        force = -np.array(numbers.residual) * self.scale
        K = self.hessian(numbers)
        size = float(np.max(np.abs(K))) or float(np.max(np.abs(force))) or 1.0
        least = float(np.linalg.eigvalsh((K + K.T) / 2)[0])
        if least < 0.0:
            dt = min(dt, 0.5 * size / -least)
        here = self.here
        for _ in range(60):
            p = np.linalg.lstsq(K + size / dt * np.eye(len(q)), force, rcond=None)[0]
            longest = float(np.max(np.abs(p)))
            trial = q + self.scale * p * min(1.0, 0.5 / longest if longest else 1.0)
            after = self.defined(trial) if self.named(trial) is not None else None
            if after is not None:
                left = float(np.linalg.norm(np.array(after.residual) * self.scale))
                ratio = float(np.linalg.norm(force)) / (left or 1e-300)
                if ratio > 0.2:
                    if np.array_equal(trial, q):
                        return q, numbers, dt, False
                    return trial, after, dt * min(max(2.0 * ratio, 0.5), 10.0), True
                self.here = here
            dt *= 0.25
        return q, numbers, dt, False

    def polished(self, q: "np.ndarray", numbers: Numbers) -> "tuple[np.ndarray, Numbers]":
        """Newton steps as long as they lower the residual."""
        for _ in range(POLISH):
            trial, here = q + self.scale * self.newton(numbers), self.here
            after = self.defined(trial)
            if after is None or self.relative(after) >= self.relative(numbers):
                self.here = here
                break
            q, numbers = trial, after
        return q, numbers


def _may_vanish(numeric: "NumericSystem", position: Mapping[str, float]) -> bool:
    """May every force be zero in a position ({coordinate: float}), within the rounding of what it is computed from, by
    interval arithmetic? The force of a stiff spring, k (ℓ − ℓ₀), is not known to the last digit of a small load."""
    from vibcli.symbolic.interval_arithmetic import Intervals, exact

    values = {name: exact(x) for name, x in (*numeric.floats.items(), *position.items())}
    rows = residual_terms(numeric.system.linearisation)
    try:
        found = iter(evaluate([term for row in rows for term in row], Intervals, values))
    except KeyError:            # of a function without bounds
        return False
    forces = [sum((next(found) for _ in row), exact(0.0)) for row in rows]
    return all(force.holds_zero() and math.isfinite(force.size) for force in forces)


def _tiny(values: "np.ndarray") -> float:
    """What counts as no curvature beside these."""
    return 1e-14 * (max(map(abs, values)) or 1.0)


def _trust_step(values: "np.ndarray", slope: "np.ndarray", radius: float) -> "np.ndarray":
    """argmin slope·p + ½ Σ values p² within |p| ≤ radius, in the axes of the Hessian."""
    import numpy as np

    from vibcli.numerics.root_finding import last_place

    least = values[0]
    tiny = _tiny(values)

    def at(shift: float) -> "np.ndarray":
        bottom = values + shift
        return np.where(np.abs(slope) > 0, -slope / np.where(bottom > tiny, bottom, tiny), 0.0)

    if least > tiny or (least >= -tiny and not np.any(slope[values <= tiny])):
        p = at(0.0)
        if np.linalg.norm(p) <= radius:
            return p
    low = max(0.0, -least)
    high = low + float(np.linalg.norm(slope)) / radius + tiny
    pairs = [(s, value) for s, value in zip(slope.tolist(), values.tolist(), strict=True) if s]

    def beyond(shift: float) -> bool:      # without arrays: those of a few take ten times as long, some sixty a step
        return math.hypot(*(s / (bottom if (bottom := value + shift) > tiny else tiny) for s, value in pairs)) > radius

    return at(last_place(beyond, float(low), high, 80)[1])
