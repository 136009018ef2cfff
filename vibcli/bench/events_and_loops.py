"""Full motions with events and with a closed loop: error and time, beside `solve_ivp` on equations by hand.

A block on a belt sticks and slips under dry friction: its motion is arcs and lines, so its place at the end is known in
closed form. A slider-crank spins: beside it DOP853 on its three coordinates with multipliers, projected at each step;
its angle at the end is that of the one equation of the crank angle.
"""

import json
from collections.abc import Callable
from math import asin, atan2, cos, pi, sin, sqrt
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing
from vibcli.bench.trajectories import problem_of_text

if TYPE_CHECKING:
    import numpy as np

    from vibcli.results.problem import Problem

BELT = """
parameters: {m: 1 kg, k: 100 N/m, v: 0.1 m/s, R: 2 N, S: 4 N}
coordinates: {x: place of the block}
bodies: {block: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, between: [[-1 m, 0], block]}}
dampers: {rub: {friction: R, breakaway: S, stretch: x - v*t}}
"""
CRANK = """
parameters: {m1: 2 kg, m2: 1 kg, m3: 0.5 kg, g: 9.81 m/s^2}
gravity: g
points: {P: {body: crank, at: [0, 0.3 m]}, Q: {body: rod, at: [0.4 m, 0]}}
bodies:
  crank: {shape: rod, mass: m1, from: [0, 0], to: [0, 0.3 m], pin: {at: [0, 0], by: phi}}
  rod: {shape: rod, mass: m2, from: [0, 0.3 m], to: [0.4 m, 0], pin: {at: P, by: psi}}
  block: {mass: m3, at: [0.4 m, 0], slide: x}
constraints: {c: {join: [Q, block]}}
"""
SLIPPING, SPINNING, SPEED = 63.0, 50.0, 12.0        # s, s, rad/s
GATE = 1.0
LONG = 0.5          # s


def rows(runs: Any) -> list[Timing]:
    """Errors and times as rows, those of the peer as the baseline."""
    found, result = json.loads(answer("from vibcli.bench.events_and_loops import main; main()", runs)), []
    for case, ours, theirs in found:
        result.append(Timing(f"{case}: error", ours[0], "", None, "scipy DOP853: error", theirs[0]))
        result.append(Timing("  time", ours[1], "ms", GATE, "scipy DOP853", theirs[1]))
    return result


def main() -> None:
    """Child process: print [[case, [error, ms], [error, ms] of the peer]]."""
    import sys

    from scipy.integrate import solve_ivp

    from vibcli.analyses.time_integration.integrate import simulate

    runs, belt, crank = int(sys.argv[1]), problem_of_text(BELT), problem_of_text(CRANK)

    def end(problem: "Problem", until: float, start: dict[str, float]) -> float:
        q: float = simulate(problem.configuration, until, initial=start).at([until])[0][0, 0]
        return q

    place, events = stuck_and_slipped(SLIPPING)
    angle = solve_ivp(_of_the_crank, (0, SPINNING), [pi / 2, SPEED], method="DOP853", rtol=1e-13, atol=1e-13).y[0, -1]
    print(json.dumps([
        [f"block on a belt, {events} events", *by_turns(
            [lambda: end(belt, SLIPPING, {"x": 0.0, "x'": 0.1}) - place, lambda: _events(SLIPPING, 1e-12) - place],
            runs)],
        ["slider-crank, 126 turns", *by_turns(
            [lambda: end(crank, SPINNING, {"phi": 0.0, "phi'": SPEED}) - (angle - pi / 2),
             lambda: _projected(SPINNING, 1e-12) - angle], runs)]]))


def by_turns(errors: list[Callable[[], float]], runs: int) -> list[list[float]]:
    """[error, ms] of each, all once a round; the first round does not count but where it takes over half a second, and
    then there are three."""
    found, spent, rounds = [0.0] * len(errors), [[] for _ in errors], runs + 1
    while rounds:
        for i, error in enumerate(errors):
            start = process_time()
            found[i] = abs(float(error()))
            spent[i].append(process_time() - start)
        rounds -= 1
        if rounds == runs:
            if max(spent)[0] > LONG:
                rounds = min(runs, 3) - 1
            else:
                spent = [[] for _ in errors]
    return [[error, 1e3 * median(times)] for error, times in zip(found, spent, strict=True)]


def stuck_and_slipped(until: float) -> tuple[float, int]:
    """(place of the block on the belt, events before), each arc and line in closed form."""
    t, x, events = 0.0, 0.0, 0
    while t + (0.04 - x) / 0.1 < until:     # it sticks up to 4 N, then swings about 2 N up to the speed of the belt
        t, events, turn = t + (0.04 - x) / 0.1, events + 1, 2 * (pi - atan2(0.2, 0.1))
        if t + turn / 10 >= until:
            return 0.02 + 0.02 * cos(10 * (until - t)) + 0.01 * sin(10 * (until - t)), events
        t, x, events = t + turn / 10, 0.02 + 0.02 * cos(turn) + 0.01 * sin(turn), events + 1
    return x + 0.1 * (until - t), events


class _Crossing:
    """An event of `solve_ivp`: a part of the state rises through a level."""

    terminal, direction = True, 1.0

    def __init__(self, part: int, level: float):
        self.part, self.level = part, level

    def __call__(self, t: float, y: "np.ndarray") -> float:
        above: float = y[self.part] - self.level
        return above


def _events(until: float, tolerance: float) -> float:
    """The same by `solve_ivp`, from event to event."""
    from scipy.integrate import solve_ivp

    slips, sticks = _Crossing(0, 0.04), _Crossing(1, 0.1)
    t, x, slipping = 0.0, 0.0, False
    while t < until:
        found = solve_ivp((lambda t, y: (y[1], 2 - 100 * y[0])) if slipping else (lambda t, y: (0.1, 0.0)), (t, until),
                          [x, 0.1], method="DOP853", rtol=tolerance, atol=tolerance,
                          events=sticks if slipping else slips)
        t, x, slipping = found.t[-1], found.y[0, -1], not slipping
    return x


def _of_the_crank(t: float, y: "np.ndarray") -> tuple[float, float]:
    """(φ̇, φ̈) of the crank angle alone."""
    s, c = sin(y[0]), cos(y[0])
    root = sqrt(0.25 - 0.09 * s * s)
    first = -0.3 * s - 0.09 * s * c / root
    second = -0.3 * c - 0.09 * ((c * c - s * s) / root + 0.09 * s * s * c * c / root**3)
    inertia = 0.06 + (0.09 - 0.3 * s * first + first * first) / 3 + 0.5 * first * first
    slope = (-0.3 * c * first - 0.3 * s * second + 2 * first * second) / 3 + first * second
    return y[1], -(0.5 * slope * y[1] ** 2 + 9.81 * 0.45 * c) / inertia


def _projected(until: float, tolerance: float) -> float:
    """The crank angle by DOP853 on three coordinates, put back on the closed loop at each step."""
    from scipy.integrate import DOP853

    class Projected(DOP853):  # type: ignore[misc]       # SciPy has no types
        y: Any
        f: Any

        def step(self) -> None:
            super().step()
            self.y = _closed(self.y[0], self.y[3])
            self.f = _with_multipliers(self.t, self.y)

    solver = Projected(_with_multipliers, 0.0, _closed(pi / 2, SPEED), until, rtol=tolerance, atol=tolerance)
    while solver.status == "running":
        solver.step()
    angle: float = solver.y[0]
    return angle


def _closed(angle: float, speed: float) -> "np.ndarray":
    """Angles of crank and rod and the place of the block, and their rates, of a crank angle and its rate."""
    import numpy as np

    rod = -asin(0.6 * sin(angle))
    turning = -0.6 * cos(angle) * speed / cos(rod)
    return np.array([angle, rod, 0.3 * cos(angle) + 0.5 * cos(rod), speed, turning,
                     -0.3 * sin(angle) * speed - 0.5 * sin(rod) * turning])


def _with_multipliers(t: float, y: "np.ndarray") -> "np.ndarray":
    """(q̇, q̈) of M q̈ + Gᵀλ = h, G q̈ = γ."""
    import numpy as np

    a, b, _, u, w, z = y
    (sa, ca), (sb, cb), c, s = (sin(a), cos(a)), (sin(b), cos(b)), 0.075 * cos(a - b), 0.075 * sin(a - b)
    rows = [[0.15, c, 0, 0.3 * ca, -0.3 * sa], [c, 0.25 / 3, 0, 0.5 * cb, -0.5 * sb], [0, 0, 0.5, 0, -1],
            [0.3 * ca, 0.5 * cb, 0, 0, 0], [-0.3 * sa, -0.5 * sb, -1, 0, 0]]
    right = [-s * w * w - 9.81 * 0.6 * ca, s * u * u - 9.81 * 0.25 * cb, 0,
             0.3 * sa * u * u + 0.5 * sb * w * w, 0.3 * ca * u * u + 0.5 * cb * w * w]
    return np.array([u, w, z, *np.linalg.solve(np.array(rows), right)[:3]])
