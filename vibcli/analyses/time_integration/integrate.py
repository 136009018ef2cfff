"""The motion of a scene from its start up to an instant."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.constraint_drift import drift
from vibcli.analyses.time_integration.energy_balance import balance
from vibcli.analyses.time_integration.error_scales import EPSILON
from vibcli.analyses.time_integration.events import first_event
from vibcli.analyses.time_integration.impulses import blow
from vibcli.analyses.time_integration.march_ends import endless
from vibcli.analyses.time_integration.motionless import starts_at_rest, stay
from vibcli.analyses.time_integration.prepared_motion import PreparedMotion, loose
from vibcli.analyses.time_integration.slack_ropes import slack
from vibcli.analyses.time_integration.time_stepping import FIRST, SECOND, March
from vibcli.analyses.time_integration.trajectory import Event, Trajectory
from vibcli.base.errors import PhysicsError
from vibcli.base.work import Spent
from vibcli.mechanics.numeric_equations import NumericEquations

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.analyses.time_integration.forcing_breaks import Breaks
    from vibcli.analyses.time_integration.refined_windows import RefinedWindows
    from vibcli.analyses.time_integration.series_windows import SeriesWindows
    from vibcli.analyses.time_integration.trajectory import Balance
    from vibcli.mechanics.configuration import Configuration

ACCURACY, BALANCED = 1e-12, 1e-8      # of a step relative to the motion; of the energies
MANY = 1e3          # errors of a step, that add up to one of the motion
MOST_STEPS = 100_000
MOST_AT_ONCE = 20       # events at one instant


class Unbalanced(PhysicsError):
    """A motion whose energies do not balance."""


def simulate(configuration: "Configuration", until: float, rtol: float = ACCURACY,
             initial: Mapping[str, float] | None = None) -> Trajectory:
    """The Trajectory of a system up to t = `until` [s].

    rtol: the error of each step relative to the motion, by collocation ACCURACY at most. initial: {x: m or rad,
    x': m/s or rad/s}; what is not given starts at rest in equilibrium. Where its work comes to its limit the motion is
    that which was found until then.
    """
    return solved(PreparedMotion(configuration, until, initial), rtol, max(BALANCED, MANY * rtol))


@np.errstate(all="ignore")      # what is not finite is refused with its instant
def solved(motion: PreparedMotion, rtol: float = ACCURACY, balanced: float = BALANCED) -> Trajectory:
    """The Trajectory of what is prepared; Unbalanced where its energies are off by more than `balanced` of them."""
    until, drawn = motion.until, motion.configuration.scene
    march, events, rests = _followed(motion, until, rtol, FIRST)
    system, numeric = march.system, motion.configuration.numeric
    energies = balance(system, march.switching, march.windows, march.ends, march.struck, motion.stops.times)
    if not energies.error <= balanced:
        rounding, gap = _rounding(motion.units, march, energies), energies.gap
        if not gap <= rounding:
            raise _unbalanced(energies)
        largest = abs(energies.energy).max()
        energies = energies._replace(error=gap / largest if gap <= balanced * largest else EPSILON * gap / rounding)
    found = Trajectory(march, until, events, rests, motion.stops, energies, drift(system, march.windows))
    if any(tie.form == "rope" for tie in drawn.constraints):
        free = system if system.m else NumericEquations(loose(numeric), numeric.floats, drawn.freedom.redundant)
        gone = slack(numeric, free, found)
        if gone is not None:
            found.cut(*gone)
    if march.t < until and not found.reason:
        found.stop(march.t, *endless(march))
    return found


@np.errstate(all="ignore")
def solved_again(motion: PreparedMotion, first: Trajectory, rtol: float = ACCURACY) -> Trajectory:
    """A second solution to the end of the first: by rules of another order, from a start that differs in its last
    digit, its energies left alone."""
    march, events, rests = _followed(motion, first.end, rtol, SECOND, first)
    return Trajectory(march, march.t, events, rests, motion.stops)


def _followed(motion: PreparedMotion, until: float, rtol: float, points: tuple[int, int],
              first: Trajectory | None = None) -> tuple[March, list[Event], float]:
    """(the March to its end or as far as it may, the Events on the way, up to when it rests)."""
    again, work = first is not None, motion.configuration.numeric.work
    with work.task("the integration" + " once more" * again, MOST_STEPS * (1 + again)) as task:
        q, v = (x * (1 + EPSILON * again) for x in motion.start)
        march, events = March(motion.system, motion.switching, q, v, min(rtol, ACCURACY), until, task, points), []
        if not v.any():
            stay(march, motion.stops, starts_at_rest(motion.initial) and not motion.configuration.falls)
        rests = march.t
        try:
            _marched(march, motion.stops, events, motion.other_windows(rtol, first))
        except Spent as spent:
            if spent.task is not task or not march.windows:
                raise
    return march, events, rests


def _rounding(units: np.ndarray, march: March, energies: "Balance") -> float:
    """How far rounding may upset the balance [J]: that of the accelerations on the way, and that of V, whose springs
    know their lengths to the last digit of the figure."""
    way = sum(window.end * abs(v) for window, (_, v) in zip(march.windows, march.ends, strict=True))
    reach = np.maximum(units, abs(march.q))
    of_V = abs(energies.energy).max() + reach @ march.system.sizes(march.t, march.q, march.v, march.g)
    each = 4 * EPSILON * float(of_V) * len(march.windows) ** 0.5       # of a window, as errors that add up at random
    found: float = float(march.sizes.weight**2 * march.sizes.noise @ way) + each
    return found


def _unbalanced(energies: "Balance") -> Unbalanced:
    if not np.isfinite(energies.error):
        return Unbalanced("the energies of this motion are not defined at an instant at which a function of the time "
                            "in it jumps, or in a position that it reaches", "write what drives it without jumps, as "
                            "1 - cos(w*t), and look for roots and logarithms of what becomes negative")
    return Unbalanced(f"the energies of this motion balance to {energies.error:.2g} of the largest of them alone: it "
                        "is not known to the digits that are stated",
                        "follow it for a shorter time, or let what acts change less abruptly")


def _marched(march: March, stops: "Breaks", events: list[Any],
             others: "Sequence[RefinedWindows | SeriesWindows]") -> None:
    """March to the end, by `others` where these pay; the events on the way go to `events`."""
    until, at_once = march.until, 0
    if march.t == until:
        return
    _strike(march, stops, events)
    march.begin(stops.after(march.t, until))
    which: tuple[int, ...]
    while march.t < until:
        limit, instant, which = stops.after(march.t, until), None, ()
        paying = next((windows for windows in others if windows.pay(march, limit)), None)
        if paying is not None:
            paying.follow(march, limit)
        else:
            window = march.advance(limit)
            instant, which = _event(march, window, limit)
            march.finish(window, instant)
        if instant is None:
            at_once = 0
            if limit - march.t <= 1e-15 * limit:
                march.reach(limit)
                if limit < until:
                    _strike(march, stops, events)
                    march.begin(stops.after(limit, until))
            continue
        at_once = at_once + 1 if instant <= 1e-14 * march.t else 0
        if at_once > MOST_AT_ONCE:
            raise PhysicsError(f"at t = {march.t:.9g} s forces that bend or jump switch without end",
                               "mind what acts when they change their sense")
        before = march.g, march.slides
        march.begin(limit, which)
        events += _named(march, before)


def _event(march: March, window: "Window", limit: float) -> tuple[float | None, tuple[int, ...]]:
    if not march.switching.count:
        return None, ()
    breaks = limit - (window.start + window.length) <= 1e-15 * limit
    slack = 1e-12 * march.switching.sizes(window.start, window.q, window.v, window.g)
    return first_event(march.switching, window, slack, breaks)


def _strike(march: March, stops: "Breaks", events: list[Event]) -> None:
    """The impulses that act now."""
    change = blow(march, stops)
    if change is not None:
        march.strike(change)
        events.append(Event(march.t, "impulse", ""))


def _named(march: March, before: tuple[tuple[float, ...], tuple[int, ...]]) -> list[Event]:
    """The Events that have just happened: what has changed."""
    g, slides = before
    found = []
    for k in range(march.switching.count):
        was, now = k in slides, k in march.slides
        if was != now:
            found.append(Event(march.t, "sticks" if now else "slips", march.switching.names[k]))
        elif not now and g[k] != march.g[k]:
            found.append(Event(march.t, "switches", march.switching.names[k]))
    return found
