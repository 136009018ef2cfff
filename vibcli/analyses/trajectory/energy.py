"""The energy balance of a motion: dE/dt = loads − dissipated + driving, integrated at the Gauss points."""

import numpy as np

from vibcli.analyses.trajectory.collocation import rule
from vibcli.analyses.trajectory.result import Balance
from vibcli.mechanics.compiled import Compiled
from vibcli.mechanics.dynamics import powers

POINTS = 40


def balance(system, windows, ends):
    """The Balance over all windows, each of which may have been cut short; ends: the states (q, q̇) there."""
    r = rule(POINTS)
    compiled = Compiled(system.scene, system.floats, None, powers(system.scene))
    parts = [_at_points(window, r) for window in windows]
    q, v = (np.concatenate([part[i] for part in parts], axis=1) for i in (0, 1))
    t = np.concatenate([window.start + r.c * window.end for window in windows])
    _, kinetic, *rates = (np.broadcast_to(value, t.shape) for value in compiled(t, q, v))
    lengths = np.array([window.end for window in windows])
    loads, lost, driving = (np.concatenate([[0.0], np.cumsum(rate.reshape(-1, POINTS) @ r.w * lengths)])
                            for rate in rates)
    times = np.array([windows[0].start, *(window.start + window.end for window in windows)])
    q, v = (np.column_stack([windows[0].q if i == 0 else windows[0].v, *(end[i] for end in ends)]) for i in (0, 1))
    energy = np.array(np.broadcast_to(compiled(times, q, v)[0], times.shape))
    gap = energy - energy[0] - loads + lost - driving
    size = max(float(np.abs(part).max()) for part in (loads, lost, driving, kinetic))
    return Balance(times, energy, loads, lost, driving, float(np.abs(gap).max() / size) if size else 0.0)


def _at_points(window, rule):
    """(q, q̇) at the Gauss points of what a window holds."""
    tau = rule.c * window.end
    known = window.end == window.length and window.rule is rule
    return window.summed(tau, rule.at_points)[:2] if known else window.states(tau)[:2]

