"""Frequency responses: all that is told of a chain with a hundred peaks, against LU of as many matrices as a curve has
points; and many frequencies at once, against the eigenvalue problem that they cannot do without.

The chain is read before; what is timed is the derivation of its matrices, and the search for peaks, half-power points
and bounds. Its dampers stand in proportion to the springs, so that modes are real, or in none.
"""

import json
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
    from vibcli.analyses.frequency_response.transfer_function import TransferFunction

LINKS, POINTS = 200, 1000
DEGREES = (20, 50, 200)
BUDGETS = {"in proportion": 0.3, "in no proportion": 0.3}
FIRST = {20: None, 50: None, 200: 2.5}      # times eig; of fewer degrees the frequencies themselves take most
ERROR = 1.0         # of what is told of rounding


def rows(runs: Any) -> list[Timing]:
    """Milliseconds of chains and of LU in a loop, of first calls and of `eig`, and errors over their bounds."""
    found = json.loads(answer("from vibcli.bench.frequency_responses import main; main()", min(int(runs), 7)))
    result = [Timing(f"frf of {LINKS} masses, dampers {kind}: {peaks} peaks", ours, "ms", BUDGETS[kind],
                     f"numpy solve, a loop of {POINTS}", loop) for kind, (peaks, ours, loop) in found["chains"].items()]
    for n, (ours, eig, loop, off) in zip(DEGREES, found["full"], strict=True):
        result.append(Timing(f"{POINTS} frequencies, {n} degrees, full damping, first call", ours, "ms", FIRST[n],
                             "numpy eig", eig))
        result.append(Timing("  against LU", ours, "ms", 1.0, "numpy solve, all at once", loop))
        if off is not None:
            result.append(Timing("  error against 40 digits, over its bound", off, "", ERROR, absolute=True))
    return result


def main() -> None:
    """Child process: print what `rows` reads."""
    import sys

    runs = int(sys.argv[1])
    _told(12, "in proportion")
    print(json.dumps({"chains": {kind: _chain(kind, runs) for kind in BUDGETS},
                      "full": [_full(n, runs) for n in DEGREES]}))


def _text(n: int, kind: str) -> str:
    """A chain of equal masses and springs from the ground on, driven at its end."""
    lines = ["bodies:"] + [f"  b{i}: {{mass: 1 kg, slide: x{i}}}" for i in range(1, n + 1)]
    for group, name in (("springs", "k"), ("dampers", "c")):
        lines.append(f"{group}:")
        for i in range(1, n + 1):
            size = "1000 N/m" if name == "k" else f"{0.2 if kind == 'in proportion' else 0.1 * (1 + i % 3)} N*s/m"
            lines.append(f"  {name}{i}: {{{name}: {size}, between: [{f'b{i - 1}' if i > 1 else 'ground'}, b{i}]}}")
    return "\n".join([*lines, "forces:", f"  drive: {{at: b{n}, force: 1 N*sin(3 rad/s*t)}}", ""])


def _told(n: int, kind: str) -> "tuple[int, float, FrequencyResponseFunction]":
    """(peaks, ms, transfer) of all that is told of the first mass."""
    from vibcli.api.source import problem_of, text_source

    problem = problem_of(text_source(_text(n, kind)))
    start = process_time()
    curve = problem.frequency_response("x1", "drive")
    curve.find_errors()
    count = len(curve.peaks), len(curve.dips)
    return count[0], 1e3 * (process_time() - start), curve.transfer


def _chain(kind: str, runs: int) -> list[float]:
    import numpy as np

    from vibcli.analyses.frequency_response.transfer_function import TransferFunction

    found = [_told(LINKS, kind) for _ in range(runs)]
    system, loop = found[0][2], []
    assert isinstance(system, TransferFunction)
    for _ in range(min(runs, 3)):
        start = process_time()
        for Omega in np.linspace(0.1, 70.0, POINTS):
            np.linalg.solve(system.K + 1j * Omega * system.C - Omega**2 * system.M, system.b[0])
        loop.append(1e3 * (process_time() - start))
    return [found[0][0], median(spent for _, spent, _ in found), median(loop)]


def _full(n: int, runs: int) -> list[float | None]:
    """[ms of a first call, of eig, of LU, error over its bound] of a system whose damping couples all modes."""
    import numpy as np

    from vibcli.analyses.frequency_response.direct import direct
    from vibcli.analyses.frequency_response.evaluate import sampled
    from vibcli.analyses.frequency_response.transfer_function import TransferFunction

    random = np.random.default_rng(n)
    A, B = random.normal(size=(2, n, n))
    M, C, K = np.diag(random.uniform(1, 3, n)), 0.01 * B @ B.T, 10 * A @ A.T + 100 * np.eye(n)
    b, c = np.zeros((2, 3, n))
    b[0, 0] = c[0, -1] = 1.0
    state = np.block([[np.zeros((n, n)), np.eye(n)], [-K / np.diag(M)[:, None], -C / np.diag(M)[:, None]]])
    Omega = np.linspace(0.01, 1.2 * np.abs(np.linalg.eigvals(state)).max(), POINTS)
    first, eig, loop = [], [], []
    for _ in range(runs):
        system = TransferFunction(M, C, K, b, c)
        start = process_time()
        values, _ = sampled(system, Omega)
        first.append(1e3 * (process_time() - start))
        start = process_time()
        np.linalg.eig(state)
        eig.append(1e3 * (process_time() - start))
    for _ in range(min(runs, 3)):
        start = process_time()
        direct(system, 1j * Omega)
        loop.append(1e3 * (process_time() - start))
    return [median(first), median(eig), median(loop), _off(system, Omega, values) if n < DEGREES[-1] else None]


def _off(system: "TransferFunction", Omega: "np.ndarray", values: "np.ndarray") -> float:
    """The largest error of some values, over what is told of their rounding."""
    import mpmath
    import numpy as np

    from vibcli.analyses.frequency_response.value_errors import of_values
    from vibcli.analyses.transient.data_errors import of_matrices

    places, worst = np.arange(50, POINTS, 190), 0.0
    told = of_values(system, of_matrices(system.M, system.C, system.K), Omega[places])
    with mpmath.workdps(40):
        parts = [mpmath.matrix(part.tolist()) for part in (system.K, system.C, system.M)]
        for place, bound in zip(places.tolist(), told.tolist(), strict=True):
            s = mpmath.mpc(0, float(Omega[place]))
            found = mpmath.lu_solve(parts[0] + s * parts[1] + s**2 * parts[2], mpmath.matrix(system.b[0].tolist()))
            worst = max(worst, abs(complex(found[system.n - 1]) - complex(values[place])) / bound)
    return worst
