"""What of a phase plane is shown: from which place to which, up to which speed."""

import math
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.energy_levels import EnergyLevels
from vibcli.analyses.nonlinear.phase_portrait import base_of, separatrices, through
from vibcli.analyses.nonlinear.turning_points import turning_point
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.nonlinear.energy_levels import Orbit
    from vibcli.analyses.nonlinear.equilibrium_kinds import StateEquilibrium
    from vibcli.analyses.nonlinear.phase_portrait import StatePath
    from vibcli.analyses.nonlinear.state_field import StateField
    from vibcli.analyses.nonlinear.well import Well
    from vibcli.mechanics.equilibrium.all_equilibria import Equilibria

TURN = 1.3              # of π: on both sides of the middle of an angle
MARGIN = 0.3            # of what is to be seen, on both sides
FAR = 4.0               # of what else is to be seen: kinks farther away are left out
WIDE = 4.0              # of the motion, or of where forces bend: how far equilibria are searched without a figure
ABOVE, ABOVE_OWN = 1.5, 1.2     # of the speed on separatrices; of the motion from the start
MOST = 0.85             # of the places on an orbit that goes on beyond what is shown
BENT, LOOKS = 0.5, 60   # of a linear force: by so much the force differs where it counts as nonlinear
LINEAR = 12             # octaves of places at which it is linear: a force that never is has no size of its own
NOTHING = 1e-9


def range_of(search: "Equilibria", well: "Well | None", start: tuple[float, float] | None, unit: float,
             cycles: "Sequence[StatePath]" = ()) -> tuple[float, float]:
    """From which place to which."""
    name, = search.forces.names or [None]
    places = [item.equilibrium.values[name] for item in search.items] if name else []
    bounds = search.bounds.get(name)
    if name and search.forces.periodic[0] and bounds is not None:
        return _turn(0.5 * sum(bounds), start, well)
    marks = [*places, *_turns(well, start), *(q for one in cycles for q in (float(one.q.min()), float(one.q.max())))]
    marks += [2 * places[0] - q for q in marks[1:]] if len(places) == 1 else []
    if well is not None and bounds is not None:
        marks += _ends_of_separatrices(well, bounds, places)
        width = max(marks, default=0.0) - min(marks, default=0.0)
        near = [*marks, 0.5 * sum(bounds)][0]
        marks += [q for q in well.kinks(*bounds) if not width > NOTHING * unit or abs(q - near) <= FAR * width]
    low, high = min(marks, default=0.0), max(marks, default=0.0)
    if high - low <= NOTHING * max(unit, abs(low)):
        reach = _reach(well, low, unit)
        return low - reach, high + reach
    return low - MARGIN * (high - low), high + MARGIN * (high - low)


def bounds_of(well: "Well", middle: float, start: tuple[float, float] | None, unit: float) -> tuple[float, float]:
    """Within which bounds equilibria are searched where no figure says how far."""
    reach = max(_reach(well, middle, unit), *(abs(q - middle) for q in _turns(well, start)), 0.0)
    return middle - WIDE * reach, middle + WIDE * reach


def _turn(middle: float, start: tuple[float, float] | None, well: "Well") -> tuple[float, float]:
    """Of an angle after a turn of which nothing has changed: the turn in which the motion starts, and more."""
    if start is not None:
        middle += math.tau * round((start[0] - middle) / math.tau)
    marks = [middle - TURN * math.pi, middle + TURN * math.pi]
    beyond = [q for q in _turns(well, start) if not marks[0] <= q <= marks[1]]
    return min([*marks, *(q - MARGIN for q in beyond)]), max([*marks, *(q + MARGIN for q in beyond)])


def _turns(well: "Well", start: tuple[float, float] | None) -> list[float]:
    """The start, and where it would turn without dampers."""
    if start is None:
        return []
    found = [start[0]]
    if well is None:
        return found
    kinetic = 0.5 * float(well.inertia(np.array(start[:1]))[0]) * start[1] ** 2
    for side in (-1, 1):
        try:
            found.append(turning_point(well, start[0], kinetic, side).q)
        except PhysicsError:
            continue
    return found


def _ends_of_separatrices(well: "Well", bounds: tuple[float, float], places: "Sequence[float]") -> list[float]:
    """Where levels through tops of V turn, within bounds."""
    low, high = bounds
    if not len(places) > 1:
        return []
    levels = EnergyLevels(well, low, high, places)
    tops = [q for q in places if _is_top(levels, levels.index(q))]
    found = separatrices(levels, tops)
    return [q for one in found for q, ended in zip((float(one.q[0]), float(one.q[-1])), one.ends, strict=True) if ended]


def _is_top(levels: EnergyLevels, i: int) -> bool:
    return 0 < i < levels.stops.size - 1 and not (levels.gains[i] > 0 and levels.gains[i - 1] < 0)


def _reach(well: "Well", place: float, unit: float) -> float:
    """About one place alone: as far as twice where its force differs from a linear one, at most as far as the figure
    is large."""
    if well is None:
        return unit
    steps = unit * 0.5 ** np.arange(LOOKS)[::-1] / 2
    force = well.force(place + steps) - well.force(place - steps)
    stiff = force / steps
    with np.errstate(all="ignore"):
        bent = np.abs(stiff - stiff[LOOKS // 2]) > BENT * abs(stiff[LOOKS // 2])
    far = np.flatnonzero(bent[LOOKS // 2:])
    return float(2 * steps[LOOKS // 2 + far[0]]) if far.size and far[0] >= LINEAR else unit


def speed_of(field: "StateField", levels: EnergyLevels | None, items: "Sequence[StateEquilibrium]",
             start: tuple[float, float] | None, ends: tuple[float, float]) -> float:
    """Up to which speed: that of separatrices at equilibria, of the motion from the start, or what reaches the edge."""
    if levels is None:
        return _speed_of_field(field, items, start, ends)
    own = ABOVE_OWN * max((_speed_on(one, start) for one in (through(levels, start) if start else ())), default=0.0)
    places = [one.q for one in items]
    found = separatrices(levels, [one.q for one in items if one.is_top])
    speeds = [float(np.interp(q, one.q, one.v)) for one in found for q in places if one.q[0] < q < one.q[-1]]
    speeds = speeds if any(speeds) else [_speed_on(one, (0.0, 0.0)) for one in found]
    rests = [levels.index(q) for q in places]
    return max(ABOVE * max(speeds), own) if speeds and max(speeds) > 0 else max(own, _speed_to_the_edge(levels, rests))


def _speed_on(orbit: "Orbit", start: tuple[float, float] | None) -> float:
    """The largest one; of an orbit that does not turn on both sides, as before a pole, that of most of its places."""
    if all(orbit.ends):
        return float(orbit.v.max())
    return max(abs(start[1]), float(np.interp(MOST, (orbit.q - orbit.q[0]) / (orbit.q[-1] - orbit.q[0]),
                                              np.sort(orbit.v))))


def _speed_to_the_edge(levels: EnergyLevels, rests: "Sequence[int]") -> float:
    """With which the lower one of both ends is reached from the lowest equilibrium; of V without a bottom, that of most
    places."""
    heights = levels.heights
    base = base_of(levels, rests)
    gain = min(heights[0], heights[-1]) - heights[base] if rests else 0.0
    gain = gain if gain > 0 else float(np.quantile(heights, MOST) - np.quantile(heights, 1 - MOST))
    m = levels.well.inertia(levels.stops[base:base + 1])[0]
    return float(math.sqrt(2 * gain / m)) or (levels.stops[-1] - levels.stops[0]) / 2


def _speed_of_field(field: "StateField", items: "Sequence[StateEquilibrium]", start: tuple[float, float] | None,
                    ends: tuple[float, float]) -> float:
    """By the fastest of the vibrations about equilibria."""
    rates = [math.sqrt(abs(field.slopes(one.q)[0])) for one in items if one.eigenvalues is not None]
    return max([ABOVE_OWN * abs(start[1]) if start else 0.0, *(rate * (ends[1] - ends[0]) / 2 for rate in rates)]
               ) or (ends[1] - ends[0]) / 2


def heights_of(levels: EnergyLevels, items: "Sequence[StateEquilibrium]") -> list[float]:
    """Energies of equilibria over the lowest one [J]."""
    numbers = [levels.index(one.q) for one in items]
    if not numbers:
        return []
    base = base_of(levels, numbers)
    climbs, slack = levels.climbs(base), levels.slack(base)
    return [0.0 if abs(climbs[k]) <= slack[k] else float(climbs[k]) for k in numbers]
