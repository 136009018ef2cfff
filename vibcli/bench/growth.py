"""Time against the number of coordinates, from the text of a scene to its frequencies, imports excluded.

The baseline is the linear algebra alone: NumPy's `eigh` of a dense symmetric matrix of that size. Times are medians;
the exponent p of t ~ nᵖ is that of the fastest runs at the two largest sizes.
"""

import json
from math import log
from statistics import median
from time import process_time
from typing import Any

from vibcli.bench import scenes
from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

FAMILIES = {"pendulum": ("pendulum of {} links", {12: 300.0, 50: 800.0, 100: 500.0}),
            "chain": ("chain of {} masses", {250: None, 500: None, 1000: 8.0})}
CUBIC = 3.0     # of dense linear algebra
LONGEST = 6.0   # seconds of runs for one size


def rows(runs: Any) -> list[Any]:
    """The rows of all families."""
    found = []
    for family, (words, budgets) in FAMILIES.items():
        times = json.loads(answer("from vibcli.bench.growth import main; main()", family, runs))
        for n, budget in budgets.items():
            (whole, _, algebra), _ = times[str(n)]
            found.append(Timing(words.format(n), whole, "ms", budget, f"numpy eigh, n = {n}", algebra))
        before, last = list(budgets)[-2:]
        for part, name in ((1, "text to element data"), (0, "text to frequencies")):
            exponents = [log(times[str(last)][1][i] / times[str(before)][1][i], last / before) for i in (part, 2)]
            found.append(Timing(f"  exponent, {name}", exponents[0], "", CUBIC, f"numpy eigh, n = {before}, {last}",
                             exponents[1], absolute=True))
    return found


def main() -> None:
    """Child process: print {n: (medians, minima)}, each [ms whole, ms to the element data, ms of eigh]."""
    import sys

    family, runs = sys.argv[1], int(sys.argv[2])
    solve(getattr(scenes, family)(3))
    solve(getattr(scenes, family)(45))
    times = {n: _times(family, n, runs) for n in FAMILIES[family][1]}
    print(json.dumps(times))


def solve(text: str) -> tuple[Any, float, float]:
    """The solved Problem of a scene's text, and the seconds to its element data and to its modes."""
    from vibcli.api.source import problem_of, text_source

    start = process_time()
    problem = problem_of(text_source(text))
    _ = problem.configuration.linear_system
    middle = process_time() - start
    _ = problem.modal.modes
    return problem, middle, process_time() - start


def _times(family: str, n: int, runs: int) -> list[list[float]]:
    import numpy as np

    text, found = getattr(scenes, family)(n), []
    matrix = np.random.default_rng(n).standard_normal((n, n))
    begin = process_time()
    while len(found) < runs and (len(found) < 3 or process_time() - begin < LONGEST):
        _, middle, whole = solve(text)
        start = process_time()
        np.linalg.eigh(matrix + matrix.T)
        found.append((whole, middle, process_time() - start))
    return [[1e3 * middle(column) for column in zip(*found, strict=True)] for middle in (median, min)]
