"""Quantities over a parameter: run time of a sweep against the scene with each value by itself, and how far these are
apart; against NumPy's `eigh` of matrices that are assembled by hand, which neither bounds nor tells anything. A scene
with another value against the same derivation at that value, without a scene of its own, by turns."""

import json
from statistics import median, quantiles
from time import process_time
from typing import Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing
from vibcli.bench.scenes import ONE_DEGREE, TWO_DEGREES, TWO_DRIVEN

POINTS, ALONE = 1000, 20
GATE, ERROR = 0.2, 1e-12        # of the same by single scenes; relative
VARIANTS = {"one degree": ONE_DEGREE, "two degrees": TWO_DEGREES, "two degrees, driven": TWO_DRIVEN}
TURNS = 800
VARIANT = 1.1                   # of a shared derivation


def rows(runs: Any) -> list[Timing]:
    """Milliseconds of a sweep, those of single scenes as the baseline, and the largest relative difference."""
    ours, alone, anew, plain, error, variants = json.loads(answer("from vibcli.bench.sweeps import main; main()", runs))
    case = f"two frequencies of two degrees at {POINTS} values of a parameter"
    return [Timing(case, ours, "ms", GATE, f"{POINTS} times with_values", alone),
            Timing("  one with_values", alone / POINTS, "ms", None, "its text read anew", anew / POINTS),
            Timing("  against matrices by hand", ours, "ms", None, "numpy eigh, one loop", plain),
            Timing(f"  relative difference from {ALONE} single scenes", error, "", ERROR, absolute=True),
            *(Timing(f"frequencies of {name} with another value", variant, "ms", VARIANT, "a shared derivation", shared)
              for name, (variant, shared) in variants.items())]


def main() -> None:
    """Child process: print [ms of a sweep, of as many single scenes, of as many that are read anew, of eigh in a loop,
    relative difference, {scene: (ms of a variant, of a shared derivation)}]."""
    import sys

    import numpy as np

    from vibcli import loads

    scene, values = loads(TWO_DEGREES), np.linspace(100, 500, POINTS)
    scene.sweep("omega[1]", "omega[2]", k=values[:20])
    ours, plain = [], []
    for _ in range(int(sys.argv[1])):
        start = process_time()
        found = scene.sweep("omega[1]", "omega[2]", k=values)
        ours.append(process_time() - start)
        start = process_time()
        for k in values:
            M = np.array([[8.0, 1.5], [1.5, 1.125]])
            lower = np.linalg.inv(np.linalg.cholesky(M))
            np.linalg.eigh(lower @ np.diag([k, 14.715]) @ lower.T)
        plain.append(process_time() - start)
    start, apart = process_time(), 0.0
    for i in range(0, POINTS, POINTS // ALONE):
        alone = scene.with_values(k=float(values[i])).omega
        apart = max(apart, *(abs(found.values[f"omega[{k}]"][i] / alone[k - 1] - 1) for k in (1, 2)))
    single = (process_time() - start) * POINTS / ALONE
    start = process_time()
    for i in range(ALONE):
        _ = loads(TWO_DEGREES.replace("k: 240 N/m", f"k: {240 + i} N/m")).omega
    anew = (process_time() - start) * POINTS / ALONE
    print(json.dumps([1e3 * median(ours), 1e3 * single, 1e3 * anew, 1e3 * median(plain), float(apart),
                      {name: _variant(scene) for name, scene in VARIANTS.items()}]))


def _variant(text: str) -> list[float]:
    """Milliseconds of a scene with another value of k and its frequencies, and of these by the expressions of the scene
    itself; of each what a tenth of all turns stays below."""
    from fractions import Fraction

    from vibcli import loads
    from vibcli.api.model import Model
    from vibcli.api.source import problem_of, text_source

    scene, source = loads(text), text_source(text)
    problem = problem_of(source)
    times: list[list[float]] = [[], []]
    for turn in range(TURNS):
        k = 100 + Fraction(turn, 8)
        start = process_time()
        _ = scene.with_values(k=float(k)).omega
        middle = process_time()
        _ = Model(source, problem.sharing({"k": k})).omega
        times[0].append(1e3 * (middle - start))
        times[1].append(1e3 * (process_time() - middle))
    return [quantiles(found, n=10)[0] for found in times]
