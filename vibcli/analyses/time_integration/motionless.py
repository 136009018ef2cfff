"""A motion that starts at rest in its equilibrium, or where friction holds it, and rests there until something acts.

That is a solution of the equations, stable or not, and nothing is integrated: the rounding of the forces, which an
integration follows, would move it. From the first instant at which what holds the time acts on it is integrated.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.time_integration.driven_places import driven_places
from vibcli.analyses.time_integration.impulses import blow
from vibcli.symbolic.compiled_arrays import Compiled

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.forcing_breaks import Breaks
    from vibcli.analyses.time_integration.time_stepping import March
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.symbolic.node import Node

BALANCED, ROUNDED = 1e-9, 8     # of the forces that are in equilibrium; of their rounding, beside what holds the time


def starts_at_rest(initial: Mapping[str, float] | None) -> bool:
    """Does a motion with these values of `initial` start in its equilibrium?"""
    return all(name.endswith("'") and not value for name, value in (initial or {}).items())


def stay(march: "March", stops: "Breaks", in_equilibrium: bool) -> None:
    """Let the march stay where it is as long as nothing acts: in its equilibrium, or where friction holds it."""
    if not in_equilibrium and not march.switching.count and len(march.q):
        return
    moving = _of_time(march.system)
    while march.t < march.until and blow(march, stops) is None:
        limit = stops.after(march.t, march.until)
        march.begin(limit)
        held = in_equilibrium or len(march.slides) == len(march.q)
        if not held or not _silent(march, limit, moving, in_equilibrium):
            break
        march.rest(limit)


def _of_time(system: "NumericEquations") -> "list[Node]":
    """What holds the time: in the equations, in the places of bodies and points, and in loads on what is driven."""
    scene = system.scene
    loads = [node for term in scene.forces for node in term.nodes]
    nodes = dict.fromkeys([*system.parts.nodes(), *system.parts.gaps, *driven_places(scene), *loads,
                           *scene.energies.values()])
    return [node for node in nodes if node.mask & scene.time.mask]


def _silent(march: "March", limit: float, moving: "list[Node]", in_equilibrium: bool) -> bool:
    """Is nothing of what holds the time felt until then, and are the forces in equilibrium? Of smooth forces without
    the time the search for it tells, of others without the time nearly."""
    times = march.t + (limit - march.t) * march.rule.c
    q, v = (np.repeat(x[:, None], len(times), 1) for x in (march.q, march.v))
    a = march.accelerations(times, q, v)
    bound = ROUNDED * march.sizes.noise
    if moving:
        values = Compiled(march.system.scene, march.system.floats, None, moving)(times, q, v)
        if any(np.ptp(value) for value in values):
            return False
    elif in_equilibrium and march.switching.count:
        size = march.system.sizes(times[0], march.q, march.v, march.g)
        bound = np.maximum(bound, BALANCED * size / march.sizes.weight**2)
    elif in_equilibrium:
        bound = np.full(len(march.q), np.inf)
    return bool((np.abs(a) <= bound[:, None]).all() and np.isfinite(a).all())
