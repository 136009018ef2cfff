"""The motion of a scene from its start up to an instant."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.time_integration.agreement import Shared
from vibcli.analyses.time_integration.constraint_drift import drift
from vibcli.analyses.time_integration.deviations import deviations
from vibcli.analyses.time_integration.driven_places import driven_places
from vibcli.analyses.time_integration.energy_balance import balance
from vibcli.analyses.time_integration.error_scales import EPSILON
from vibcli.analyses.time_integration.events import first_event
from vibcli.analyses.time_integration.forcing_breaks import breaks
from vibcli.analyses.time_integration.impulses import blow
from vibcli.analyses.time_integration.initial_state import start, vectors
from vibcli.analyses.time_integration.motionless import starts_at_rest, stay
from vibcli.analyses.time_integration.slack_ropes import slack
from vibcli.analyses.time_integration.time_stepping import FIRST, SECOND, March
from vibcli.analyses.time_integration.trajectory import Event, Trajectory
from vibcli.base.errors import PhysicsError
from vibcli.base.work import Spent
from vibcli.mechanics.numeric_equations import NumericEquations
from vibcli.mechanics.switching import Switching
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.scene.scene import Scene

ACCURACY, BALANCED = 1e-12, 1e-8      # of a step relative to the motion; of the energies
LONGEST = 1e12
MOST_STEPS = 100_000
MOST_AT_ONCE = 20       # events at one instant


def known_motion(configuration: "Configuration", until: float,
                 initial: Mapping[str, float] | None = None) -> Trajectory:
    """The Trajectory that `simulate` gives, as far as a second solution shares it."""
    found = simulate(configuration, until, initial=initial)
    if not found.end > 0:
        raise found.unknown(0.0)
    second = simulate(configuration, found.end, initial=initial, second=True)
    units = units_of(configuration.numeric, found.names)
    found.share(Shared(found, second, units, deviations(found, initial, units)))
    return found


@np.errstate(all="ignore")      # what is not finite is refused with its instant
def simulate(configuration: "Configuration", until: float, rtol: float = ACCURACY,
             initial: Mapping[str, float] | None = None, second: bool = False) -> Trajectory:
    """The Trajectory of a system up to t = `until` [s].

    rtol: the error of each step relative to the motion. initial: {x: m or rad, x': m/s or rad/s}; what is not given
    starts at rest in equilibrium. Where its work comes to its limit the motion is that which was found until then.
    second: by rules of another order, from a start that differs in its last digit, its energies left alone.
    """
    if not 0 < until < LONGEST:
        raise PhysicsError(f"a motion cannot end at t = {until:.6g} s", "ask for an instant after its start, t = 0")
    places, speeds = start(configuration, initial)
    numeric, drawn = configuration.numeric, configuration.scene
    scene = equations_of(numeric)
    system = NumericEquations(scene, numeric.floats, drawn.freedom.redundant)
    owners, bounds = scene.law_switches()
    stops = breaks(scene, [*system.parts.nodes(), *driven_places(scene)], numeric.floats, until, numeric.work)
    q, v = (x * (1 + EPSILON * second) for x in vectors(scene, places, speeds))
    with numeric.work.task("the integration" + " once more" * second, MOST_STEPS * (1 + second)) as task:
        march = March(system, Switching(system, bounds, owners), q, v, rtol, until, task, SECOND if second else FIRST)
        events = []
        if not v.any():
            stay(march, stops, starts_at_rest(initial) and not configuration.falls)
        rests = march.t
        try:
            _marched(march, stops, events)
        except Spent as spent:
            if spent.task is not task or not march.windows:
                raise
    if second:
        return Trajectory(march, march.t, events, rests, stops)
    energies = balance(system, march.switching, march.windows, march.ends, march.struck, stops.times)
    if not energies.error <= BALANCED:
        rounding, gap = _rounding(numeric, march, energies), energies.gap
        if not gap <= rounding:
            raise _unbalanced(energies)
        largest = abs(energies.energy).max()
        energies = energies._replace(error=gap / largest if gap <= BALANCED * largest else EPSILON * gap / rounding)
    found = Trajectory(march, until, events, rests, stops, energies, drift(system, march.windows))
    if any(tie.form == "rope" for tie in drawn.constraints):
        loose = system if system.m else NumericEquations(_loose(numeric), numeric.floats, drawn.freedom.redundant)
        gone = slack(numeric, loose, found)
        if gone is not None:
            found.cut(*gone)
    if march.t < until and not found.reason:
        found.stop(march.t, *march.endless())
    return found


def _rounding(numeric, march, energies):
    """How far rounding may upset the balance [J]: that of the accelerations on the way, and that of V, whose springs
    know their lengths to the last digit of the figure."""
    way = sum(window.end * abs(v) for window, (_, v) in zip(march.windows, march.ends, strict=True))
    reach = np.maximum(units_of(numeric, march.system.scene.coordinates), abs(march.q))
    of_V = abs(energies.energy).max() + reach @ march.system.sizes(march.t, march.q, march.v, march.g)
    each = 4 * EPSILON * float(of_V) * len(march.windows) ** 0.5       # of a window, as errors that add up at random
    return float(march.sizes.weight**2 * march.sizes.noise @ way) + each


def units_of(numeric: "NumericSystem", names: Sequence[str]) -> np.ndarray:
    """The size of the figure along each coordinate."""
    return np.array(list(map(numeric.size_along, names)))


def _unbalanced(energies):
    if not np.isfinite(energies.error):
        return PhysicsError("the energies of this motion are not defined at an instant at which a function of the time "
                            "in it jumps, or in a position that it reaches", "write what drives it without jumps, as "
                            "1 - cos(w*t), and look for roots and logarithms of what becomes negative")
    return PhysicsError(f"the energies of this motion balance to {energies.error:.2g} of the largest of them alone: it "
                        "is not known to the digits that are stated",
                        "follow it for a shorter time, or let what acts change less abruptly")


def equations_of(numeric: "NumericSystem") -> "Scene":
    """The scene whose equations are integrated: that with all its coordinates where loops are closed."""
    return numeric.scene if numeric.scene.loops is None else _loose(numeric)


def _loose(numeric):
    """The scene with all its coordinates, its static preloads in numbers."""
    loose = numeric.scene.with_multipliers() if numeric.scene.loops is None else numeric.system.scene_with_multipliers
    if not loose.static_preloads:
        return loose
    number, floats, preloads = loose.table.number, numeric.floats, numeric.system.preloads
    return loose.with_preloads({node: number(Fraction(evaluate([preloads[record.name]], Floats, floats)[0]))
                                for node, record in loose.static_preloads})


def _marched(march, stops, events):
    """March to the end; the events on the way go to `events`."""
    until, at_once = march.until, 0
    if march.t == until:
        return
    _strike(march, stops, events)
    march.begin(stops.after(march.t, until))
    while march.t < until:
        limit = stops.after(march.t, until)
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


def _event(march, window, limit):
    if not march.switching.count:
        return None, ()
    breaks = limit - (window.start + window.length) <= 1e-15 * limit
    slack = 1e-12 * march.switching.sizes(window.start, window.q, window.v, window.g)
    return first_event(march.switching, window, slack, breaks)


def _strike(march, stops, events):
    """The impulses that act now."""
    change = blow(march, stops)
    if change is not None:
        march.strike(change)
        events.append(Event(march.t, "impulse", ""))


def _named(march, before):
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
