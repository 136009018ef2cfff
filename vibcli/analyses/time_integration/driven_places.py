"""What is prescribed in time and need not be felt by any coordinate: the places of driven bodies and points.

Its work and its extremes are those of the windows, which therefore resolve it, too.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.time_integration.error_scales import EPSILON
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.numerics.collocation_rule import Rule
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LAST = 3            # Legendre coefficients which must be small
ROUNDINGS = 8
SHORTER, MOST = 0.7, 60
TOLERANCE = 1e-11   # of how far they go


def driven_places(scene: "Scene") -> "list[Node]":
    """The places and turns of bodies and points that hold the time."""
    frames = [body.frame for body in scene.bodies.values() if body.frame is not None]
    nodes = [node for frame in frames for node in (*frame.place, frame.angle)]
    nodes += [body.lumped[1] for body in scene.bodies.values() if body.lumped is not None]
    nodes += [node for _, place in scene.points.values() for node in place]
    return [node for node in dict.fromkeys(nodes) if node.mask & scene.time.mask]


class Driven:
    """Functions of the time alone in the places of a scene; `reach`: how far each has gone from where it started."""

    def __init__(self, system: "NumericEquations") -> None:
        scene = system.scene
        self.nodes = [node for node in reachable(driven_places(scene)) if node.mask == scene.time.mask
                      and node is not scene.time]
        self.n, self.reach = system.n, 0.0
        if self.nodes:
            self._compiled = Compiled(scene, system.floats, None, self.nodes)
            self.start = self._values(np.zeros(1))

    def _values(self, times: np.ndarray) -> np.ndarray:
        still = np.zeros((self.n, len(times)))
        return np.array([np.broadcast_to(value, times.shape) for value in self._compiled(times, still, still)])

    def resolved(self, t: float, H: float, rule: "Rule") -> float:
        """The longest window of at most H that resolves them; H where none does."""
        shorter = H
        for _ in range(MOST if self.nodes else 0):
            if self._tail(t, shorter, rule) <= 1:
                return shorter
            shorter *= SHORTER
        return H

    def _tail(self, t: float, H: float, rule: "Rule") -> float:
        """What is left of their series in a window, relative to what is allowed."""
        times = t + H * rule.c
        with np.errstate(all="ignore"):
            values = self._values(times)
            reach = np.maximum(self.reach, np.abs(values - self.start).max(axis=1))
            speed = np.abs(np.diff(values) / np.diff(times)).max(axis=1)
            allowed = TOLERANCE * reach + ROUNDINGS * EPSILON * (np.abs(values).max(axis=1) + times[-1] * speed)
            left = np.abs(values @ rule.to_series)[:, -LAST:].max(axis=1) / np.maximum(allowed, 1e-300)
        self.reach = np.fmax(self.reach, reach)
        return float(left[np.isfinite(left)].max(initial=0.0))
