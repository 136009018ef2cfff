"""The energy balance of a motion: d(T + V)/dt = loads − dissipated + drive, integrated at the Gauss points."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import along
from vibcli.analyses.time_integration.trajectory import POINTS, Balance
from vibcli.mechanics.power_balance import powers
from vibcli.numerics.collocation_rule import rule
from vibcli.symbolic.compiled_arrays import Compiled

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.mechanics.power_balance import Powers
    from vibcli.mechanics.switching import Switching
    from vibcli.numerics.collocation_rule import Rule

BESIDE = 1e-14      # relative: an instant is left by more than the rounding of t − t1

SOON, ROUNDINGS = 1e-6, 64      # of a window, of its last instant: how far inside it its end is looked at from


def balance(system: "NumericEquations", switching: "Switching", windows: "Sequence[Window]",
            ends: Sequence[tuple[np.ndarray, np.ndarray]],
            struck: Sequence[tuple[float, np.ndarray, np.ndarray, np.ndarray]], corners: Any = ()) -> Balance:
    """The Balance over all windows, each of which may have been cut short; ends: the states (q, q̇) there; struck:
    [(instant, q, q̇ before, q̇ after)] of impulses, whose work is that of loads, or of what drives the scene; corners:
    instants at which that jumps or bends."""
    r, flow = rule(POINTS), powers(system.scene, system.parts.gaps)
    q, v, a = along(windows, r.c)
    t = np.concatenate([window.start + r.c * window.end for window in windows])
    senses = _senses(switching, windows, q, v, r)
    kinetic, *rates = _rates(system, flow, t, q, v, a, senses)
    lengths = np.array([window.end for window in windows])
    loads, lost, drive = (np.concatenate([[0.0], np.cumsum(rate.reshape(-1, POINTS) @ r.w * lengths)])
                          for rate in rates)
    times = np.array([windows[0].start, *(window.start + window.end for window in windows)])
    states = [(windows[0].q, windows[0].v), *ends]
    energy, after = _at_ends(system, flow, windows, times, states, corners)
    blows = np.concatenate([[0.0], np.cumsum(after - energy)[:-1]])    # of what is prescribed and jumps
    for instant, *state in struck:
        if instant > windows[0].start and not flow.driven:
            blows = blows + _gained(system, flow, instant, *state) * (times > instant * (1 + 1e-14))
    loads, drive = (loads, drive + blows) if flow.driven else (loads + blows, drive)
    gap = energy - energy[0] - loads + lost - drive
    size = max(float(np.abs(part).max()) for part in (loads, lost, drive, kinetic))
    return Balance(times, energy, loads, lost, drive, float(np.abs(gap).max() / size) if size else 0.0)


def _rates(system: "NumericEquations", flow: "Powers", t: np.ndarray, q: np.ndarray, v: np.ndarray, a: np.ndarray,
           senses: np.ndarray) -> list[np.ndarray]:
    """[T, power of the loads, dissipated power, power of the drive] at the Gauss points."""
    drift, slopes = system.rate_of(flow.carried)
    nodes = [flow.kinetic, flow.loads, flow.lost, flow.drive + drift, *slopes.values(), *flow.ties]
    compiled = system.compiled(nodes)
    values = [np.broadcast_to(value, t.shape) for value in compiled(t, q, v, _all(system, senses, t, q, v))]
    drive, pulled = values[3], values[4:4 + len(slopes)]
    for i, slope in zip(slopes, pulled, strict=True):
        drive = drive + slope * a[i]
    if any(not tie.is_zero for tie in flow.ties):
        multipliers = system.solved(t, q, v, senses)[1]
        drive = drive + sum(tie * multiplier for tie, multiplier in zip(values[4 + len(slopes):], multipliers,
                                                                        strict=True))
    return [*values[:3], drive]


def _at_ends(system: "NumericEquations", flow: "Powers", windows: "Sequence[Window]", times: np.ndarray,
             states: Sequence[tuple[np.ndarray, np.ndarray]], corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """T + V at the ends of windows, just before and just after each of these instants: what is prescribed may jump, or
    turn at another speed, at one of the `corners`. There they are the limits from either side, what strikes there
    included."""
    compiled = Compiled(system.scene, system.floats, None, [flow.energy])
    q, v = (np.column_stack([state[i] for state in states]) for i in (0, 1))
    after = np.array(np.broadcast_to(compiled(times, q, v)[0], times.shape))
    if not flow.driven:
        return after, after
    before = after.copy()
    starts = [window.start for window in windows]
    for i in [*np.flatnonzero(np.isin(starts, [starts[0], *corners])), len(windows)]:
        if i < len(windows):
            after[i] = _limit(compiled, windows[i], 0.0, 1.0)
        before[i] = _limit(compiled, windows[i - 1], windows[i - 1].end, -1.0) if i else after[0]
    after[-1] = before[-1]
    return before, after


def _limit(compiled: Compiled, window: "Window", end: float, sense: float) -> float:
    """An energy at the end of a window by the parabola through three instants within it."""
    step = max(SOON * window.end, ROUNDINGS * np.spacing(window.start + window.end))
    tau = end + sense * step * np.array([1.0, 2.0, 3.0])
    q, v, _ = window.states(tau)
    return float(np.array([3.0, -3.0, 1.0]) @ np.broadcast_to(compiled(window.start + tau, q, v)[0], 3))


def _gained(system: "NumericEquations", flow: "Powers", instant: float, place: np.ndarray, before: np.ndarray,
            after: np.ndarray) -> float:
    """What an impulse adds to T + V."""
    compiled = Compiled(system.scene, system.floats, None, [flow.energy])
    times = np.full(2, instant * (1 + BESIDE))
    found = compiled(times, np.column_stack([place] * 2), np.column_stack([before, after]))[0]
    result: float = np.diff(np.broadcast_to(found, 2))[0]
    return result


def _senses(switching: "Switching", windows: "Sequence[Window]", q: np.ndarray, v: np.ndarray,
            rule: "Rule") -> np.ndarray:
    """The senses of the switches at the Gauss points of all windows, those that slide included."""
    found = np.repeat(np.array([window.g for window in windows], dtype=float).T, rule.points, axis=1)
    for k, window in enumerate(windows):
        if window.slides:
            here = slice(k * rule.points, (k + 1) * rule.points)
            found[list(window.slides), here] = switching.sliding(
                window.slides, window.start + rule.c * window.end, q[:, here], v[:, here], window.g)[1]
    return found


def _all(system: "NumericEquations", senses: np.ndarray, t: np.ndarray, q: np.ndarray,
         v: np.ndarray) -> list[np.ndarray]:
    """The same with the senses of what bends in the energies alone."""
    more = system.switches[len(senses):]
    signs = Compiled(system.scene, system.floats, None, more)(t, q, v) if more else ()
    return [*senses, *(np.sign(np.broadcast_to(value, t.shape)) for value in signs)]
