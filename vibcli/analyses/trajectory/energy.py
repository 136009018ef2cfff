"""The energy balance of a motion: dE/dt = loads − dissipated + driving, integrated at the Gauss points."""

import numpy as np

from vibcli.analyses.trajectory.collocation import rule
from vibcli.analyses.trajectory.result import POINTS, Balance
from vibcli.mechanics.compiled import Compiled
from vibcli.mechanics.dynamics import powers


def balance(system, switching, windows, ends, struck):
    """The Balance over all windows, each of which may have been cut short; ends: the states (q, q̇) there; struck:
    [(instant, q, q̇ before, q̇ after)] of impulses, whose work is that of loads."""
    r = rule(POINTS)
    compiled = system.compiled(powers(system.scene))
    parts = [_at_points(window, r) for window in windows]
    q, v = (np.concatenate([part[i] for part in parts], axis=1) for i in (0, 1))
    t = np.concatenate([window.start + r.c * window.end for window in windows])
    senses = _senses(system, switching, windows, parts, r)
    _, kinetic, *rates = (np.broadcast_to(value, t.shape) for value in compiled(t, q, v, _all(system, senses, t, q, v)))
    lengths = np.array([window.end for window in windows])
    loads, lost, driving = (np.concatenate([[0.0], np.cumsum(rate.reshape(-1, POINTS) @ r.w * lengths)])
                            for rate in rates)
    times = np.array([windows[0].start, *(window.start + window.end for window in windows)])
    states = [(windows[0].q, windows[0].v), *ends]
    energy = _energy(system, times, *(np.column_stack([state[i] for state in states]) for i in (0, 1)))
    for instant, place, before, after in struck:
        gained = np.diff(_energy(system, np.full(2, instant), np.column_stack([place] * 2),
                                 np.column_stack([before, after])))[0]
        if instant > windows[0].start:
            loads = loads + gained * (times > instant * (1 + 1e-14))
    gap = energy - energy[0] - loads + lost - driving
    size = max(float(np.abs(part).max()) for part in (loads, lost, driving, kinetic))
    return Balance(times, energy, loads, lost, driving, float(np.abs(gap).max() / size) if size else 0.0)


def _energy(system, t, q, v):
    """E at instants, where nothing is cut: |u|, min and max are what they are."""
    compiled = Compiled(system.scene, system.floats, None, powers(system.scene)[:1])
    return np.array(np.broadcast_to(compiled(t, q, v)[0], t.shape))


def _senses(system, switching, windows, parts, rule):
    """The senses of the switches at the Gauss points of all windows, those that slide included."""
    found = []
    for window, (q, v) in zip(windows, parts, strict=True):
        g = np.repeat(np.array(window.g, dtype=float).reshape(-1, 1), rule.points, axis=1)
        if window.slides:
            g[list(window.slides)] = switching.sliding(window.slides, window.start + rule.c * window.end, q, v,
                                                       window.g)[1]
        found.append(g)
    return np.concatenate(found, axis=1)


def _all(system, senses, t, q, v):
    """The same with the senses of what bends in the energies alone."""
    more = system.switches[len(senses):]
    signs = Compiled(system.scene, system.floats, None, more)(t, q, v) if more else ()
    return [*senses, *(np.sign(np.broadcast_to(value, t.shape)) for value in signs)]


def _at_points(window, rule):
    """(q, q̇) at the Gauss points of what a window holds."""
    tau = rule.c * window.end
    known = window.end == window.length and window.rule is rule
    return window.summed(tau, rule.at_points)[:2] if known else window.states(tau)[:2]
