"""What the impulses of an instant do to the velocities.

An impulse f(t) δ(t − a) counts with f(a), the limit of f from above where f jumps there: that is extrapolated from two
instants shortly after a. Where f vanishes at a, as of a motion step(t − a) (1 − cos Ω(t − a)) that begins smoothly,
nothing strikes: the effect then grows from one instant to the other as time does, or faster, or is rounding.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.forcing_breaks import Breaks
    from vibcli.analyses.time_integration.time_stepping import March
    from vibcli.symbolic.node import Node

SOON = 1e-10            # of the time up to the next break
SAME = 0.1              # of what strikes: how much of it may change from one instant to the other


def blow(march: "March", stops: "Breaks") -> np.ndarray | None:
    """Δq̇ by the impulses that act now; None where none strikes."""
    blows = stops.blows.get(march.t)
    if not blows:
        return None
    step, found = SOON * (stops.after(march.t, march.until) - march.t), []
    for t in (march.t + step, march.t + 2 * step):
        g, _ = march.switching.settled(t, march.q, march.v, march.g)
        found.append(march.system.struck(t, march.q, march.v, g, blows) - march.v)
    first, second = found
    if not np.abs(second - first).max(initial=0.0) < SAME * np.abs(first).max(initial=0.0):
        return None
    result: np.ndarray | None = None if _rounding(march, march.t + step, blows) else 2 * first - second
    return result


def _rounding(march: "March", t: float, blows: "dict[Node, float]") -> bool:
    """May all of it vanish, by interval arithmetic?"""
    from vibcli.symbolic.interval_arithmetic import Intervals, exact

    system, scene = march.system, march.system.scene
    if system.m:            # what is driven at another speed strikes by its constraint
        return False
    state = {**dict(zip(scene.coordinates, march.q.tolist(), strict=True)), scene.time.name: t,
             **{name + "'": speed for name, speed in zip(scene.coordinates, march.v.tolist(), strict=True)}}
    values = {name: exact(value) for name, value in (*system.floats.items(), *state.items())}
    try:
        slopes = evaluate(system.slopes_by(blows), Intervals, values)
    except KeyError:            # of a function without bounds
        return False
    effects = [slope * exact(size) for size, slope in zip(np.repeat(list(blows.values()), system.n), slopes,
                                                          strict=True)]
    return all(sum(effects[i::system.n], exact(0.0)).holds_zero() for i in range(system.n))
