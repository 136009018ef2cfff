"""The lowest modes of chains of very many masses, given as mappings: processor time from these to the element data and
to the modes, peak memory and error, against SciPy's `eigsh` at shift 0 of the assembled matrix."""

import json
from math import log, pi, sin, sqrt
from time import process_time
from typing import Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

SIZES, LOWEST = (10_000, 100_000), 10
STIFFNESS = 1000.0
BESIDE_DATA, TENFOLD, ASSEMBLY, ERROR, MEMORY = 1.3, 15.0, 1.1, 1e-13, 2048.0


def rows(runs: int) -> list[Timing]:
    """Of each size the time to the modes beside that to the element data; growth between the two. Each once, however
    many `runs`."""
    found, measured = [], []
    for n in SIZES:
        data, whole, error, memory, peer, off = json.loads(answer("from vibcli.bench.sparse import main; main()", n))
        measured.append((data, whole))
        case = f"chain of {n} masses, {LOWEST} lowest modes"
        found += [Timing(case, whole, "s", BESIDE_DATA, "to element data", data),
                  Timing("  the modes alone", whole - data, "s", None, "scipy eigsh, assembled", peer),
                  Timing("  largest relative error", error, "", ERROR, "scipy eigsh", off, absolute=True),
                  Timing("  peak memory", memory, "MiB", MEMORY, absolute=True)]
    growth = [log(measured[1][part] / measured[0][part], SIZES[1] / SIZES[0]) for part in (0, 1)]
    return [*found, Timing(f"  {SIZES[1]} masses", measured[1][1], "s", TENFOLD, f"{SIZES[0]} masses", measured[0][1]),
            Timing("  exponent, mapping to element data", growth[0], "", ASSEMBLY, absolute=True),
            Timing("  exponent, mapping to modes", growth[1], "", None)]


def chain(n: int) -> dict[str, dict[str, Any]]:
    """n masses in a row, the first tied to the ground, as a mapping."""
    return {"bodies": {f"b{i}": {"mass": "1 kg", "slide": f"x{i}"} for i in range(1, n + 1)},
            "springs": {f"s{i}": {"k": f"{STIFFNESS} N/m", "between": [f"b{i - 1}" if i > 1 else "ground", f"b{i}"]}
                        for i in range(1, n + 1)}}


def main() -> None:
    """Child process: print [s to the element data, s to the modes, error, peak MiB, s of eigsh, its error]."""
    import resource
    import sys

    from vibcli import load
    from vibcli.analyses.modal import lowest_modes  # noqa: F401, imports are not what is measured

    n = int(sys.argv[1])
    load(chain(2100))["omega[1]"]
    scene, exact = chain(n), [2 * sqrt(STIFFNESS) * sin((2 * i + 1) * pi / (2 * (2 * n + 1))) for i in range(LOWEST)]
    start = process_time()
    problem = load(scene)._problem
    _ = problem.configuration.element_data
    data = process_time() - start
    modes = problem.modal.modes.first(LOWEST)
    whole = process_time() - start
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    peer, squares = _peer(n)
    error, off = (max(abs(found / true - 1) for found, true in zip(values, exact, strict=True))
                  for values in ([mode.omega for mode in modes], [sqrt(square) for square in squares]))
    print(json.dumps([data, whole, error, memory, peer, off]))


def _peer(n: int) -> tuple[float, list[float]]:
    """(s, ω² ascending) of eigsh."""
    import numpy as np
    from scipy.sparse import diags
    from scipy.sparse.linalg import eigsh

    diagonal, beside = np.full(n, 2 * STIFFNESS), np.full(n - 1, -STIFFNESS)
    diagonal[-1] = STIFFNESS
    start = process_time()
    values = eigsh(diags([beside, diagonal, beside], [-1, 0, 1], format="csc"), LOWEST, sigma=0.0,
                   return_eigenvectors=False)
    return process_time() - start, sorted(values.tolist())
