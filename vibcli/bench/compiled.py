"""A full motion beside one that is compiled: the double pendulum of `trajectories` by heyoka's Taylor series, where
that is installed. The compiling and the motion are told apart."""

import json
from copy import deepcopy
from statistics import median
from time import process_time
from typing import Any

from vibcli.bench.processes import answer, installed
from vibcli.bench.rows import Timing
from vibcli.bench.trajectories import AT_100, DOUBLE

END, START, TOLERANCE = 100.0, (0.3, 0.5, 0.0, 0.0), 1e-15
ERROR = 1e-9


def rows(runs: Any) -> list[Timing]:
    """Time and error of ours, with those of heyoka as the baseline."""
    ours, error = json.loads(answer("from vibcli.bench.compiled import main; main()", min(runs, 5)))
    peer, built, theirs, wrong = "heyoka, not installed", None, None, None
    if installed("heyoka"):
        peer = "heyoka"
        built, theirs, wrong = json.loads(answer("from vibcli.bench.compiled import heyoka; heyoka()", min(runs, 5)))
    return [Timing(f"double pendulum, {END:g} s", ours, "ms", None, peer, theirs),
            Timing("  with compiling", ours, "ms", None, peer, None if built is None else built + theirs),
            Timing("  error", error, "", ERROR, peer, wrong, absolute=True)]


def main() -> None:
    """Child process: print [ms, error] of ours."""
    import sys

    from vibcli.analyses.time_integration.integrate import simulate
    from vibcli.api.source import problem_of, text_source

    scene = problem_of(text_source(DOUBLE)).configuration

    def ours():
        q, v, _ = simulate(scene, END, initial={"p": START[0], "r": START[1]}).at([END])
        return [*q[:, 0], *v[:, 0]]

    ours()
    print(json.dumps(_measured(ours, int(sys.argv[1]))))


def heyoka() -> None:
    """Child process: print [ms of compiling, ms of the motion, error] of heyoka."""
    import sys

    import heyoka as hy

    a, b, u, w = hy.make_vars("a", "b", "u", "w")
    s, c = hy.sin(a - b), hy.cos(a - b)
    h, k = s * w * w + 19.62 * hy.sin(a), 9.81 * hy.sin(b) - s * u * u
    bottom = 2.0 - c * c
    start = process_time()
    motion = hy.taylor_adaptive([(a, u), (b, w), (u, (c * k - h) / bottom), (w, (c * h - 2.0 * k) / bottom)],
                                list(START), tol=TOLERANCE)
    built = process_time() - start

    runs = int(sys.argv[1])
    unmoved = [deepcopy(motion) for _ in range(runs)]

    def theirs():
        one = unmoved.pop()
        one.propagate_until(END)
        return one.state.tolist()

    print(json.dumps([1e3 * built, *_measured(theirs, runs)]))


def _measured(solved, runs):
    """[ms, largest error]."""
    spent = []
    for _ in range(runs):
        start = process_time()
        found = solved()
        spent.append(process_time() - start)
    return [1e3 * median(spent), max(abs(float(x) - y) for x, y in zip(found, AT_100, strict=True))]
