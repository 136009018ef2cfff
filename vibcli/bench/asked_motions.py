"""Motions in time of which an accuracy is asked: true error beside time, with the estimate and without, against LSODA
on equations that are written by hand.

The double pendulum is that of `trajectories`. Of ten links of unit masses and lengths, absolute angles from 0.5 to
0.25 rad at rest, the state at 20 s is that of the finest steps of either, which share the digits that are compared.
"""

import json
from typing import TYPE_CHECKING, Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing
from vibcli.bench.trajectories import AT_100, DOUBLE, measured, problem_of_text, rates_of_double

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    import numpy as np

ASKED = ((None, 1e-12), (1e-6, 1e-10), (1e-4, 1e-8))     # and the tolerance of LSODA whose error is next to it
STEPS = ((1e-12, 1e-12), (1e-10, 1e-10), (1e-8, 1e-8))
ALIKE = {1e-4: (1e-13, 1.2), 1e-8: (1e-12, 1.0)}     # the last ones: of LSODA with an error above theirs; the gate
LINKS, UNTIL = 10, 20.0


def rows(runs: Any) -> list[Timing]:
    """Errors and times as rows; a row asks of the error of the motion that it is what was asked at most, the last of
    each motion of its time beside LSODA where that has no more digits."""
    found, result = json.loads(answer("from vibcli.bench.asked_motions import main; main()", runs)), []
    for case, gate, ours, lsoda, alike, budget in found:
        result.append(Timing(case, ours[0], "", gate, "scipy odeint: error", lsoda[0], absolute=True))
        result.append(Timing("  time", ours[1], "ms", None, "scipy odeint", lsoda[1]))
        if alike:
            result.append(Timing("  beside as many digits: error", ours[0], "", None, "scipy odeint: error", alike[0]))
            result.append(Timing("  time", ours[1], "ms", budget, "scipy odeint", alike[1]))
    return result


def main() -> None:
    """Child process: print [[case, what is asked, [error, ms], [error, ms] of LSODA, the same of LSODA with an error
    above ours or None, the gate of our time beside that]]."""
    import sys

    runs = min(int(sys.argv[1]), 5)
    print(json.dumps([*_double(runs), *_links(runs)]))


def _double(runs: int) -> "Iterator[list[Any]]":
    """With the estimate that is printed."""
    import numpy as np
    from scipy.integrate import odeint

    from vibcli.analyses.time_integration.known_motion import known_motion

    scene = problem_of_text(DOUBLE).configuration

    def ours(asked: float | None) -> "np.ndarray":
        q, v, _ = known_motion(scene, 100.0, {"p": 0.3, "r": 0.5}, asked).at([100.0])
        return np.concatenate([q[:, 0], v[:, 0]])

    def theirs(tolerance: float) -> "np.ndarray":
        y: np.ndarray = odeint(lambda y, t: rates_of_double(y), [0.3, 0.5, 0.0, 0.0], [0.0, 100.0], rtol=tolerance,
                               atol=tolerance, mxstep=10**6)[-1]
        return y

    for asked, tolerance in ASKED:
        yield [f"double pendulum, 100 s, {asked or 1e-9:g} asked, with its estimate", asked or 1e-9,
               *_beside(ours, theirs, asked, tolerance, AT_100, runs)]


def _beside(ours: "Callable[[float | None], np.ndarray]", theirs: "Callable[[float], np.ndarray]", asked: float | None,
            tolerance: float, exact: "Sequence[float] | np.ndarray", runs: int) -> list[Any]:
    """([error, ms], of LSODA, of LSODA with an error above ours, the gate)."""
    finer, gate = ALIKE.get(asked, (None, None))
    return [measured(lambda: ours(asked), exact, runs), measured(lambda: theirs(tolerance), exact, runs),
            finer and measured(lambda: theirs(finer), exact, runs), gate]


def _links(runs: int) -> "Iterator[list[Any]]":
    """Without the estimate."""
    import numpy as np
    from scipy.integrate import odeint

    from vibcli.analyses.time_integration.integrate import simulate

    scene, place = problem_of_text(links(LINKS)).configuration, np.linspace(0.5, 0.25, LINKS)
    start = {f"p{i + 1}": float(angle) for i, angle in enumerate(place)}

    def ours(rtol: float) -> "np.ndarray":
        q, v, _ = simulate(scene, UNTIL, rtol, start).at([UNTIL])
        return np.concatenate([q[:, 0], v[:, 0]])

    def theirs(tolerance: float) -> "np.ndarray":
        y: np.ndarray = odeint(_rates_of_links(LINKS), [*place, *np.zeros(LINKS)], [0.0, UNTIL], rtol=tolerance,
                               atol=tolerance, mxstep=10**6)[-1]
        return y

    exact = ours(1e-13)
    for rtol, tolerance in STEPS:
        yield [f"ten links, 20 s, steps of {rtol:g}", 1e3 * rtol, *_beside(ours, theirs, rtol, tolerance, exact, runs)]


def links(count: int) -> str:
    """A chain of so many unit masses, each on a massless unit rod that hangs on the one before."""
    points = [f"  P{i}: {{body: b{i}, at: [0, -{i}*L]}}" for i in range(1, count)]
    bodies = [f"  b{i}: {{mass: m, at: [0, -{i}*L], pin: {{at: {f'P{i - 1}' if i > 1 else '[0, 0]'}, by: p{i}}}}}"
              for i in range(1, count + 1)]
    return "\n".join(["parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}", "gravity: g", "points:", *points, "bodies:",
                      *bodies, ""])


def _rates_of_links(count: int) -> "Callable[[np.ndarray, float], np.ndarray]":
    """Σⱼ Wᵢⱼ (cos(φᵢ − φⱼ) φ̈ⱼ + sin(φᵢ − φⱼ) φ̇ⱼ²) + g Wᵢᵢ sin φᵢ = 0, Wᵢⱼ = count + 1 − max(i, j)."""
    import numpy as np

    order = np.arange(count)
    W = count - np.maximum.outer(order, order) * 1.0

    def rates(y: "np.ndarray", t: float) -> "np.ndarray":
        q, v = y[:count], y[count:]
        apart = q[:, None] - q
        a = np.linalg.solve(W * np.cos(apart), -(W * np.sin(apart)) @ (v * v) - 9.81 * np.diag(W) * np.sin(q))
        return np.concatenate([v, a])

    return rates
