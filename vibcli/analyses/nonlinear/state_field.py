"""The motion of one degree of freedom as a field in its phase plane: (q, q̇) moves with (q̇, a(q, q̇)), a = −h/m."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.mechanics.numeric_equations import massless
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.derivatives import gradient

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene

CREEP = 1e-9            # of a speed: by so much less or more than at rest
SAMPLES, JUMPS, SAME = 9, 1e-6, 1e-13


class StateField:
    """That of a scene of one coordinate, with numbers for its parameters. `driven`: does it depend on the time?"""

    def __init__(self, scene: "Scene", floats: Mapping[str, float]) -> None:
        parts, zero = dynamics(scene), scene.table.zero
        if (0, 0) not in parts.M:
            raise massless(scene.coordinates[0])
        (h,), M, slopes = parts.h, parts.M[0, 0], gradient(parts.h[0])
        self.driven = any(node.mask & scene.time.mask for node in (M, h))
        self._plain = Compiled(scene, floats, None, [M, h])
        self._sloped = Compiled(scene, floats, None, [M, *(slopes.get(x, zero) for x in (scene.q[0], scene.v[0]))])

    def acceleration(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """a(q, q̇)."""
        M, h = self._values(self._plain, q, v)
        with np.errstate(all="ignore"):
            found: np.ndarray = -h / M
            return found

    def slopes(self, q: float) -> tuple[float, float]:
        """(∂a/∂q, ∂a/∂q̇) in an equilibrium."""
        M, by_q, by_v = (float(row[0]) for row in self._values(self._sloped, np.array([q]), np.zeros(1)))
        return -by_q / M, -by_v / M

    def is_reversible(self, low: float, high: float, speed: float) -> bool:
        """Do motions run backwards as they run forwards, a(q, −q̇) = a(q, q̇)?"""
        q, v = np.linspace(low, high, SAMPLES), speed * np.linspace(0.1, 1.0, SAMPLES)
        there, back, still = (self.acceleration(q, sense * v) for sense in (1, -1, 0))
        known = np.isfinite(there) & np.isfinite(back)
        size = np.abs(there) + np.abs(back) + np.abs(still)
        return bool(np.all(np.abs(there - back)[known] <= SAME * size[known]))

    def jumps_with_speed(self, low: float, high: float, speed: float) -> bool:
        """Does a force jump where the motion turns round, as that of dry friction?"""
        q = np.linspace(low, high, SAMPLES)
        there, back, fast = (self.acceleration(q, np.full(SAMPLES, v)) for v in (CREEP * speed, -CREEP * speed, speed))
        known = np.isfinite(there) & np.isfinite(back) & np.isfinite(fast)
        size = np.abs(there) + np.abs(fast)
        return bool(np.any(np.abs(there - back)[known] > JUMPS * size[known]))

    def _values(self, compiled: Compiled, q: np.ndarray, v: np.ndarray) -> list[np.ndarray]:
        with np.errstate(all="ignore"):
            rows = compiled(np.zeros(q.size), q.reshape(1, -1), v.reshape(1, -1))
        return [np.asarray(row) if np.shape(row) == q.shape else np.full(q.shape, row) for row in rows]
