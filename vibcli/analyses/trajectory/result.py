"""A motion in time: its state at any instant, its energy balance, its events."""

from typing import NamedTuple

import numpy as np

from vibcli.analyses.trajectory.collocation import rule
from vibcli.mechanics.compiled import Compiled

POINTS = 40             # at most in a window


class Event(NamedTuple):
    """Something that happens at an instant: `kind` is what, `name` to which element."""

    time: float
    kind: str
    name: str


class Balance(NamedTuple):
    """E(t) − E(0) = work of the loads − dissipated + work of what drives the motion, at the ends of all windows.

    error: the largest difference of both sides, relative to the largest of all these energies; `driven`: does the
    motion depend on the time by what drives it? The energy then is Σ q̇ ∂T/∂q̇ − T + V."""

    times: np.ndarray
    energy: np.ndarray
    work: np.ndarray
    dissipated: np.ndarray
    driving: np.ndarray
    error: float


class Trajectory:
    """names: the coordinates; windows: their polynomials; events; balance; drift: the largest gaps of the constraints
    (positions, velocities) relative to the motion, None without closed loops."""

    def __init__(self, system, windows, until, events, balance, drift):
        self.system, self.names = system, list(system.scene.coordinates)
        self.windows, self.until, self.events = windows, until, tuple(events)
        self.balance, self.drift = balance, drift
        self.lengths = np.array([window.length for window in windows])
        self.starts = np.array([window.start for window in windows])

    def at(self, times):
        """(q, q̇, q̈), each of shape (coordinates, times), at times within 0 and `until` [s]."""
        times = np.atleast_1d(np.asarray(times, dtype=float))
        found = np.empty((3, len(self.names), len(times)))
        number = np.clip(np.searchsorted(self.starts, times, side="right") - 1, 0, len(self.windows) - 1)
        P = rule(POINTS).basis(2 * (times - self.starts[number]) / self.lengths[number] - 1)
        order = np.argsort(number, kind="stable")
        cuts = np.flatnonzero(np.diff(number[order])) + 1
        for group in np.split(order, cuts):
            if len(group):
                window = self.windows[number[group[0]]]
                found[:, :, group] = window.summed(times[group] - window.start,
                                                         P[:window.rule.points + 2, group])
        return found[0], found[1], found[2]

    def values(self, nodes, times):
        """Expressions of the coordinates, velocities and the time at the times: an array for each."""
        compiled = Compiled(self.system.scene, self.system.floats, None, nodes)
        times = np.atleast_1d(np.asarray(times, dtype=float))
        q, v, _ = self.at(times)
        return [np.broadcast_to(value, times.shape) for value in compiled(times, q, v)]
