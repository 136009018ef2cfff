"""Error against time: the largest relative error of any frequency, measured against 60 digits and more.

Six masses in a row whose springs span a stiffness ratio: assembled matrices lose what stiff and soft springs share.
The pendulum of n links has ω² = g/L times the roots of the Laguerre polynomial of degree n.
"""

import json
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.api.source import problem_of, text_source
from vibcli.bench import scenes
from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import mpmath
    import numpy as np

RATIOS = (4, 8, 12, 16)
LINKS = (2, 5, 12, 40, 60)
DIGITS = 60
CHAIN_GATE, PENDULUM_GATE = 1e-14, 1e-13


def rows(runs: Any) -> list[Any]:
    """Errors as rows: ours, with that of the best of the assembled methods as the baseline."""
    found = json.loads(answer("from vibcli.bench.accuracy import main; main()", runs))
    result = []
    for power, ours, scipy, numpy in found["chain"]:
        result.append(Timing(f"error, chain of six, stiffness ratio 1e{power}", ours[0], "", CHAIN_GATE,
                          "scipy.linalg.eigh(K, M)", scipy[0], absolute=True))
        result.append(Timing("  numpy eigh(M^-½ K M^-½)", numpy[0], "", None))
        result.append(Timing("  time", ours[1], "ms", None, "scipy.linalg.eigh(K, M)", scipy[1]))
    for n, ours, numpy in found["pendulum"]:
        result.append(Timing(f"error, pendulum of {n} links", ours[0], "", PENDULUM_GATE, "numpy eigh(L^-1 K L^-T)",
                          numpy[0], absolute=True))
        result.append(Timing("  time", ours[1], "ms", None, "numpy eigh(L^-1 K L^-T)", numpy[1]))
    return result


def main() -> None:
    """Child process: print {family: [[label, [error, ms] of each method]]}."""
    import sys

    runs = int(sys.argv[1])
    print(json.dumps({"chain": [_chain(power, runs) for power in RATIOS],
                      "pendulum": [_pendulum(n, runs) for n in LINKS]}))


def _chain(power: int, runs: int) -> list[Any]:
    import numpy as np
    import scipy.linalg

    stiffnesses = [f"{10 ** (power * place / 5):.17e}" for place in (0, 5, 2, 4, 1, 3)]
    text = scenes.chain(6, stiffnesses, "3 kg")
    exact = _chain_exact(text)
    k = [float(text) for text in stiffnesses]
    K = np.diag(np.add(k, [*k[1:], 0.0])) - np.diag(k[1:], 1) - np.diag(k[1:], -1)
    M = 3.0 * np.eye(6)
    return [power, _ours(text, exact, runs),
            _measured(lambda: scipy.linalg.eigh(K, M), exact, runs),
            _measured(lambda: np.linalg.eigh(K / 3.0), exact, runs)]


def _chain_exact(text: str) -> "list[mpmath.mpf]":
    """The true frequencies of a scene."""
    import mpmath

    from vibcli.evidence.reference.modal import squares

    found = squares(problem_of(text_source(text)).configuration.precise_system, DIGITS)
    with mpmath.workdps(found.working):
        return [mpmath.sqrt(x) for x in found.values]


def _pendulum(n: int, runs: int) -> list[Any]:
    import mpmath
    import numpy as np

    with mpmath.workdps(DIGITS):
        exact = [mpmath.sqrt(mpmath.mpf("9.81") * _laguerre_root(n, start)) for start in
                 np.polynomial.laguerre.laggauss(n)[0].tolist()]
    left = np.arange(n, 0, -1.0)
    M, K = np.minimum.outer(left, left), 9.81 * np.diag(left)

    def assembled() -> "tuple[np.ndarray, np.ndarray]":
        L = np.linalg.cholesky(M)
        A = np.linalg.solve(L, np.linalg.solve(L, K).T)
        return np.linalg.eigh((A + A.T) / 2)

    return [n, _ours(scenes.pendulum(n), exact, runs), _measured(assembled, exact, runs)]


def _laguerre_root(n: int, x: "float | mpmath.mpf") -> "mpmath.mpf":
    """The root of the Laguerre polynomial next to x, by Newton's method on its three-term recurrence."""
    import mpmath

    x = mpmath.mpf(x)
    with mpmath.workdps(DIGITS + n):
        for _ in range(10):
            below, value = mpmath.mpf(1), 1 - x
            for i in range(1, n):
                below, value = value, ((2 * i + 1 - x) * value - i * below) / (i + 1)
            step = value * x / (n * (value - below))
            x -= step
            if abs(step) <= abs(x) * mpmath.mpf(10) ** -DIGITS:
                break
    return x


def _ours(text: str, exact: "Sequence[mpmath.mpf]", runs: int) -> list[float]:
    """[largest relative error, ms from element data to modes]."""
    from vibcli.bench.growth import solve

    spent = []
    for _ in range(min(runs, 5)):
        problem, middle, whole = solve(text)
        spent.append(whole - middle)
    return [_error([mode.omega for mode in problem.modal.modes], exact), 1e3 * median(spent)]


def _measured(solved: "Callable[[], tuple[np.ndarray, np.ndarray]]", exact: "Sequence[mpmath.mpf]",
              runs: int) -> list[float]:
    import numpy as np

    spent = []
    for _ in range(runs):
        start = process_time()
        values, _ = solved()
        spent.append(process_time() - start)
    return [_error(np.sqrt(np.maximum(values, 0.0)).tolist(), exact), 1e3 * median(spent)]


def _error(found: "Sequence[float]", exact: "Sequence[mpmath.mpf]") -> float:
    return max(float(abs(x - wanted) / wanted) for x, wanted in zip(found, exact, strict=True))
