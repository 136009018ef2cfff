"""Responses in time: run time and error of the closed form, against an integrator of the best kind.

Ten masses in a row, their dampers not proportional to their springs, one of them driven; the error is that of one
coordinate at a few times against an independent method in 25 digits, over the largest value. The integrator gives its
10,000 points by its own interpolation; where its error is larger than ours, it would need longer for ours.
"""

import json
import math
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import numpy as np

DEGREES, POINTS = 10, 10_000
PERIODS = ((20, 1 / 3), (1000, 1 / 50))
ERROR = 1e-12
BOUNDED, DEARER = 10, 1.3       # values with bounds, and how much longer the response may take with them
PIECES = 4000


def rows(runs: Any) -> list[Any]:
    """Run times as rows, the integrator's as the baseline, and errors."""
    found = json.loads(answer("from vibcli.bench.responses import main; main()", runs))
    result = []
    for (periods, budget), (ours, error, theirs, wrong, bounded) in zip(PERIODS, found["driven"], strict=True):
        case = f"response of {DEGREES} degrees, {POINTS} points over {periods} periods"
        result.append(Timing(case, ours, "ms", budget, "solve_ivp DOP853, rtol 1e-10", theirs))
        result.append(Timing(f"  with bounds of {BOUNDED} values, against without", bounded, "ms", DEARER,
                             "the same without", ours))
        result.append(Timing("  error", error, "", ERROR, "solve_ivp DOP853, rtol 1e-10", wrong, absolute=True))
    result.append(Timing(f"record of {PIECES} pieces, {DEGREES} degrees, {POINTS} points", found["record"], "ms", None))
    return result


def main() -> None:
    """Child process: print the medians of milliseconds of processor time, and the errors."""
    import sys

    runs = min(int(sys.argv[1]), 7)
    M, C, K = _system()
    print(json.dumps({"driven": [_driven(M, C, K, periods, runs) for periods, _ in PERIODS],
                      "record": _record(M, C, K, runs)}))


def _system() -> "tuple[np.ndarray, np.ndarray, np.ndarray]":
    import numpy as np

    random = np.random.default_rng(1)
    k, c = random.uniform(100, 2000, DEGREES), random.uniform(0, 0.5, DEGREES)
    return np.diag(random.uniform(1, 3, DEGREES)), in_a_row(c), in_a_row(k)


def in_a_row(weights: "np.ndarray") -> "np.ndarray":
    """The matrix of springs or dampers in a row, the first tied to the ground."""
    import numpy as np

    beside = np.diag(weights[1:], 1)
    return np.diag(weights + np.append(weights[1:], 0.0)) - beside - beside.T


def _driven(M: "np.ndarray", C: "np.ndarray", K: "np.ndarray", periods: int, runs: int) -> list[float]:
    """[ms, error] of ours and of the integrator, over periods of the lowest mode, and ms of ours with bounds."""
    import numpy as np
    from scipy.integrate import solve_ivp

    from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.high_precision import precise_value
    from vibcli.analyses.transient.linear_response import linear_motion

    lowest = np.sqrt(np.linalg.eigvals(np.linalg.solve(M, K)).real.min())
    times = np.linspace(0, math.tau * periods / lowest, POINTS)
    forcing = Forcing(DEGREES, [Segment(0.0, (Wave(DEGREES - 1, 5.0, 0, 7j),))])
    q0, v0, output = np.full(DEGREES, 0.1), np.zeros(DEGREES), LinearOutput(q={3: 1.0})
    inverse = np.linalg.inv(M)
    A, B = -inverse @ np.concatenate([K, C], axis=1), 5.0 * inverse[:, -1]

    def slope(t: float, z: "np.ndarray") -> "np.ndarray":
        return np.concatenate([z[DEGREES:], A @ z + B * np.cos(7 * t)])

    def theirs() -> "np.ndarray":
        found = solve_ivp(slope, (0, times[-1]), np.concatenate([q0, v0]), "DOP853", times, rtol=1e-10, atol=1e-12)
        row: np.ndarray = found.y[3]
        return row

    def ours() -> "np.ndarray":
        return linear_motion(M, C, K, forcing, q0, v0).values(output, times)

    def bounded() -> "tuple[np.ndarray, np.ndarray]":
        motion = linear_motion(M, C, K, forcing, q0, v0)
        return motion.values(output, times), motion.errors(output, times[::POINTS // BOUNDED])

    (times_of_ours, times_with_bounds), (x, _) = _timed([ours, bounded], runs)
    spent = median(times_of_ours)
    longer = spent * median(b / a for a, b in zip(times_of_ours, times_with_bounds, strict=True))
    ((their_time,),), (y,) = _timed([theirs], 1)
    places = [POINTS // 7, POINTS // 2, POINTS - 1]
    lists = [matrix.tolist() for matrix in (M, C, K)]
    exact = [float(precise_value(*lists, forcing, q0, v0, output, times[i], 25)) for i in places]
    errors = [np.abs(z[places] - exact).max() / np.abs(x).max() for z in (x, y)]
    return [spent, errors[0], their_time, errors[1], longer]


def _record(M: "np.ndarray", C: "np.ndarray", K: "np.ndarray", runs: int) -> float:
    """ms of the response to a force given at points, straight between them."""
    import numpy as np

    from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import linear_motion

    random = np.random.default_rng(2)
    at, force = np.linspace(0, 40, PIECES + 1), random.normal(size=PIECES + 1)
    slopes = np.diff(force) / np.diff(at)
    pieces = [Segment(t, (Wave(0, f, 0, 0j), Wave(0, s, 1, 0j)))
              for t, f, s in zip(at.tolist(), force.tolist(), slopes.tolist(), strict=False)]
    forcing, times, rest = Forcing(DEGREES, pieces), np.linspace(0, 40, POINTS), np.zeros(DEGREES)
    def driven() -> "np.ndarray":
        return linear_motion(M, C, K, forcing, rest, rest).values(LinearOutput(q={3: 1.0}), times)

    return median(_timed([driven], runs)[0][0])


def _timed(functions: "Sequence[Callable[[], Any]]", runs: int) -> tuple[list[list[float]], list[Any]]:
    """([ms of each run of each], [their last results]), by turns."""
    spent, results = [[] for _ in functions], [None] * len(functions)
    for _ in range(runs):
        for i, function in enumerate(functions):
            start = process_time()
            results[i] = function()
            spent[i].append(1e3 * (process_time() - start))
    return spent, results
