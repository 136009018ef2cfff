"""Motion in time: error against time of the full equations, beside LSODA and DOP853 on hand-written equations.

The double pendulum of unit masses and lengths starts from 0.3 and 0.5 rad at rest; its state at 100 s is known from
Taylor series of 26 digits (tests/support/motions.py). A pendulum of 1000 periods is compared with elliptic functions.
"""

import json
from math import cos, sin
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

AT_100 = (0.15683620292567552, 0.1549800061482823, 0.7581220395333563, 0.9338915929100756)
DOUBLE = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}
gravity: g
points: {P: {body: a, at: [0, -L]}}
bodies:
  a: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}
  b: {mass: m, at: [0, -2*L], pin: {at: P, by: r}}
"""
PENDULUM = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}
gravity: g
bodies: {a: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}}
"""
ACCURACIES, TOLERANCES = (1e-11, 1e-12), (1e-12, 1e-13)
ERROR_GATE, PHASE_GATE, DRIFT_GATE = 1e-9, 1e-8, 1e-12


def rows(runs: Any) -> list[Any]:
    """Errors and times as rows; LSODA at a similar time as the baseline."""
    found = json.loads(answer("from vibcli.bench.trajectories import main; main()", runs))
    result = []
    for (accuracy, ours), (_, lsoda), (_, dop) in zip(*(found[key] for key in ("ours", "odeint", "DOP853")),
                                                      strict=True):
        result.append(Timing(f"error, double pendulum, 100 s, accuracy {accuracy:g}", ours[0], "", ERROR_GATE,
                          "scipy odeint", lsoda[0], absolute=True))
        result.append(Timing("  time", ours[1], "ms", None, "scipy odeint", lsoda[1]))
        result.append(Timing("  DOP853: error", dop[0], "", None))
        result.append(Timing("  DOP853: time", dop[1], "ms", None))
    phase, drift, spent = found["pendulum"]
    return [*result, Timing("phase, pendulum, 1000 periods", phase, "", PHASE_GATE, absolute=True),
            Timing("  drift of its energy", drift, "", DRIFT_GATE, absolute=True), Timing("  time", spent, "ms", None)]


def main() -> None:
    """Child process: print {method: [[tolerance, [error, ms]]], "pendulum": [phase, drift, ms]}."""
    import sys

    import numpy as np
    from scipy.integrate import odeint, solve_ivp

    from vibcli.analyses.time_integration.integrate import simulate

    runs, start = min(int(sys.argv[1]), 5), [0.3, 0.5, 0.0, 0.0]
    scene = problem_of_text(DOUBLE).configuration

    def ours(accuracy: float) -> "np.ndarray":
        q, v, _ = simulate(scene, 100.0, accuracy, {"p": 0.3, "r": 0.5}).at([100.0])
        return np.concatenate([q[:, 0], v[:, 0]])

    methods = {
        "ours": [(accuracy, lambda accuracy=accuracy: ours(accuracy)) for accuracy in ACCURACIES],
        "odeint": [(rtol, lambda rtol=rtol: odeint(lambda y, t: rates_of_double(y), start, [0.0, 100.0],
                                                   rtol=rtol, atol=rtol, mxstep=10**6)[-1]) for rtol in TOLERANCES],
        "DOP853": [(rtol, lambda rtol=rtol: solve_ivp(lambda t, y: rates_of_double(y), (0.0, 100.0), start,
                                                      method="DOP853", rtol=rtol, atol=rtol).y[:, -1])
                   for rtol in TOLERANCES]}
    found = {name: [[tolerance, measured(solved, AT_100, runs)] for tolerance, solved in tried]
             for name, tried in methods.items()}
    print(json.dumps({**found, "pendulum": _thousand()}))


def problem_of_text(text: str) -> "Problem":
    """The Problem of a scene, built."""
    from vibcli.api.source import problem_of, text_source

    problem = problem_of(text_source(text))
    _ = problem.scene, problem.numeric.drawn_floats
    return problem


def rates_of_double(y: Any) -> tuple[float, ...]:
    """(q̇, q̈) of the double pendulum."""
    a, b, u, w = y
    s, c = sin(a - b), cos(a - b)
    h, k = s * w * w + 19.62 * sin(a), 9.81 * sin(b) - s * u * u
    bottom = 2 - c * c
    return u, w, (c * k - h) / bottom, (c * h - 2 * k) / bottom


def measured(solved: Any, exact: Any, runs: int) -> list[float]:
    """[largest error, ms]."""
    spent = []
    for _ in range(runs):
        start = process_time()
        found = solved()
        spent.append(process_time() - start)
    return [max(abs(float(x) - y) for x, y in zip(found, exact, strict=True)), 1e3 * median(spent)]


def _thousand() -> list[float]:
    """[error of the angle relative to the amplitude, drift of the energy, ms] of a pendulum from 1 rad."""
    import mpmath

    from vibcli.analyses.time_integration.integrate import simulate

    with mpmath.workdps(30):
        omega, k = mpmath.sqrt(mpmath.mpf("9.81")), mpmath.sin(mpmath.mpf(1) / 2)
        time = float(4 * mpmath.ellipk(k * k) / omega * mpmath.mpf("999.63"))
        exact = float(2 * mpmath.asin(k * mpmath.ellipfun("cd", omega * time, m=k * k)))
    scene = problem_of_text(PENDULUM).configuration
    start = process_time()
    found = simulate(scene, time, initial={"p": 1.0})
    spent = process_time() - start
    return [abs(float(found.at([time])[0][0, 0]) - exact), found.balance.error, 1e3 * spent]
