"""Full motions beside one that is compiled: the double pendulum of `trajectories` by heyoka's Taylor series, where
that is installed. The compiling and the motion are told apart. Of a long one, which goes by such series itself where
they are installed, with its estimate, beside LSODA; its end is known from Taylor series of 20 digits."""

import json
from copy import deepcopy
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.bench.processes import answer, installed
from vibcli.bench.rows import Timing
from vibcli.bench.trajectories import AT_100, DOUBLE, problem_of_text, rates_of_double

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    import numpy as np

    from vibcli.mechanics.configuration import Configuration

END, START, TOLERANCE = 100.0, (0.3, 0.5, 0.0, 0.0), 1e-15
ERROR = 1e-9
LONG, AT_LONG, FINEST = 1000.0, (0.181100461947351, 0.206230850872208, -0.555551292073049, -1.11438830079056), 1e-13


def rows(runs: Any) -> list[Timing]:
    """Time and error of ours, with those of heyoka as the baseline."""
    ours, error, long = json.loads(answer("from vibcli.bench.compiled import main; main()", min(runs, 5)))
    peer, built, theirs, wrong = "heyoka, not installed", None, None, None
    if installed("heyoka"):
        peer = "heyoka"
        built, theirs, wrong = json.loads(answer("from vibcli.bench.compiled import heyoka; heyoka()", min(runs, 5)))
    return [Timing(f"double pendulum, {END:g} s", ours, "ms", None, peer, theirs),
            Timing("  with compiling", ours, "ms", None, peer, None if built is None else built + theirs),
            Timing("  error", error, "", ERROR, peer, wrong, absolute=True), *_long_rows(*long)]


def _long_rows(ours: float, error: float, lsoda: float, wrong: float) -> list[Timing]:
    by = "" if installed("heyoka") else ", heyoka not installed"
    return [Timing(f"double pendulum, {LONG:g} s, with its estimate{by}", ours, "ms", None, "scipy odeint", lsoda),
            Timing("  error", error, "", ERROR, "scipy odeint", wrong, absolute=True)]


def main() -> None:
    """Child process: print [ms, error, [ms, error, ms of LSODA, error] of a long motion] of ours."""
    import sys

    from vibcli.analyses.time_integration.integrate import simulate
    scene = problem_of_text(DOUBLE).configuration

    def ours() -> list[float]:
        q, v, _ = simulate(scene, END, initial={"p": START[0], "r": START[1]}).at([END])
        return [*q[:, 0], *v[:, 0]]

    ours()
    runs = int(sys.argv[1])
    print(json.dumps([*_measured(ours, runs), _long(scene, min(runs, 3))]))


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

    def theirs() -> list[float]:
        one = unmoved.pop()
        one.propagate_until(END)
        state: list[float] = one.state.tolist()
        return state

    print(json.dumps([1e3 * built, *_measured(theirs, runs)]))


def _long(scene: "Configuration", runs: int) -> list[float]:
    """With the estimate; importing the engine is in the first run."""
    from scipy.integrate import odeint

    from vibcli.analyses.time_integration.known_motion import known_motion

    def ours() -> list[float]:
        q, v, _ = known_motion(scene, LONG, {"p": START[0], "r": START[1]}).at([LONG])
        return [*q[:, 0], *v[:, 0]]

    def theirs() -> "np.ndarray":
        y: np.ndarray = odeint(lambda y, t: rates_of_double(y), START, [0.0, LONG], rtol=FINEST, atol=FINEST,
                               mxstep=10**6)[-1]
        return y

    return [*_measured(ours, runs, AT_LONG), *_measured(theirs, runs, AT_LONG)]


def _measured(solved: "Callable[[], Iterable[float]]", runs: int, exact: "Sequence[float]" = AT_100) -> list[float]:
    """[ms, largest error]."""
    spent = []
    for _ in range(runs):
        start = process_time()
        found = solved()
        spent.append(process_time() - start)
    return [1e3 * median(spent), max(abs(float(x) - y) for x, y in zip(found, exact, strict=True))]
