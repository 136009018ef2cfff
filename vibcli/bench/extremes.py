"""Extremes of full motions: the time of finding one against that of integrating the motion, and its difference from the
largest of 100,001 points of it, which their spacing explains.

A double pendulum that tumbles has one largest value; a pendulum whose turns are all alike has one in every window.
"""

import json
from statistics import median
from time import process_time
from typing import Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing
from vibcli.bench.trajectories import DOUBLE, PENDULUM

END, POINTS = 100.0, 100_001
CASES = {"a double pendulum": (DOUBLE, {"p": 2.0, "r": 2.5}, 0.15), "a pendulum": (PENDULUM, {"p": 1.0}, 0.2)}
ERROR = 1e-5


def rows(runs: Any) -> list[Timing]:
    """An extreme against the integration, and its difference from the largest of many points."""
    result = []
    told = json.loads(answer("from vibcli.bench.extremes import main; main()", min(runs, 5)))
    for (case, (_, _, budget)), (found, integrated, apart) in zip(CASES.items(), told, strict=True):
        result += [Timing(f"extreme of {END:g} s of {case}", found, "ms", budget, "its integration", integrated),
                   Timing(f"  relative difference from the largest of {POINTS} points", apart, "", ERROR,
                          absolute=True)]
    return result


def main() -> None:
    """Child process: print [ms of an extreme, of the integration, relative difference] of each case."""
    import sys

    print(json.dumps([_measured(text, start, int(sys.argv[1])) for text, start, _ in CASES.values()]))


def _measured(text: str, start: dict[str, float], runs: int) -> list[float]:
    import numpy as np

    from vibcli.analyses.time_integration.integrate import simulate
    from vibcli.analyses.time_integration.level_crossings import extreme
    from vibcli.api.source import problem_of, text_source

    scene, spent = problem_of(text_source(text)).configuration, []
    for _ in range(runs + 1):
        begin = process_time()
        motion = simulate(scene, END, initial=start)
        middle = process_time()
        _, top = extreme(motion, lambda at, motion=motion: motion.at(at)[0][-1], 0.0, END, 1)
        spent.append((process_time() - middle, middle - begin))
    largest = motion.at(np.linspace(0.0, END, POINTS))[0][-1].max()
    return [*(1e3 * median(column) for column in zip(*spent[1:], strict=True)), float(abs(top - largest) / largest)]
