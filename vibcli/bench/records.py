"""Measured records: run time of a motion with its extremes and their bounds against SciPy's `lsim`, which gives values
at the samples alone; both exact for the straight lines between them. Reading the file and imports are left out; memory
is that of the whole command.
"""

import json
import os
import tempfile
from math import log
from statistics import median
from time import process_time
from typing import TYPE_CHECKING

from vibcli.bench.processes import answer, costs, vibcli
from vibcli.bench.responses import in_a_row
from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    import numpy as np

    from vibcli.api.model import Model

DEGREES, SAMPLES, GROWTH, EVERY = 10, 100_000, (10_000, 1_000_000), 0.01
GATE, SHARED, LINEAR, SAME, MEMORY = 0.5, 1.5, 1.1, 1e-10, 200.0
ROUNDS, POINTS = 5, 272       # instants, of which the last is the last sample


def rows(runs: int) -> list[Timing]:
    """Processor time against lsim by turns, its growth, how far both are apart, and the memory of a process."""
    with tempfile.TemporaryDirectory() as folder:
        return _rows(runs, folder)


def _rows(runs: int, folder: str) -> list[Timing]:
    found = json.loads(answer("from vibcli.bench.records import main; main()", min(runs, ROUNDS), folder))
    memory = costs({"response": (vibcli("response", os.path.join(folder, f"one_{SAMPLES}.yaml")), (0,))}, 3)
    case = f"record of {SAMPLES} samples, {DEGREES} degrees, extremes with bounds"
    last = found["last"]
    return [Timing(case, found["ours"], "ms", GATE, "scipy.signal.lsim", found["lsim"]),
            Timing(f"  {DEGREES} forces under it", found["shared"], "ms", SHARED, "one force", found["ours"]),
            Timing("  relative difference at samples", found["apart"], "", SAME, absolute=True),
            Timing(f"  exponent, {GROWTH[0]} to {GROWTH[1]} samples", log(last / found["first"], GROWTH[1] / GROWTH[0]),
                   "", LINEAR, absolute=True),
            Timing("  peak memory of vibcli response", memory["response"].memory, "MiB", MEMORY, absolute=True)]


def main() -> None:
    """Child process: print medians of milliseconds, and the relative difference of the motions."""
    import sys

    import numpy as np

    runs, folder = int(sys.argv[1]), sys.argv[2]
    files = {(name, count): _written(folder, name, forces, count) for name, forces, count in (
        ("one", 1, SAMPLES), ("shared", DEGREES, SAMPLES), ("one", 1, GROWTH[0]), ("one", 1, GROWTH[1]))}
    _solved(files["one", GROWTH[0]])
    ours, shared, theirs, ends = [], [], [], {}
    for _ in range(runs):
        spent, scene = _solved(files["one", SAMPLES])
        ours.append(spent)
        shared.append(_solved(files["shared", SAMPLES])[0])
        spent, values = _lsim(SAMPLES)
        theirs.append(spent)
    for count in GROWTH:
        ends[count] = median(_solved(files["one", count])[0] for _ in range(min(runs, 3)))
    motion = scene.response(points=POINTS)
    apart = abs(motion[f"x{DEGREES - 1}"] - values[np.rint(motion.t / EVERY).astype(int)]).max() / abs(values).max()
    print(json.dumps({"ours": median(ours), "shared": median(shared), "lsim": median(theirs), "apart": float(apart),
                      "first": ends[GROWTH[0]], "last": ends[GROWTH[1]]}))


def _solved(file: str) -> "tuple[float, Model]":
    """(ms of the extremes of the motion with their bounds, the scene) of a scene that is read."""
    from vibcli import load

    scene = load(file)
    start = process_time()
    for quantity in (f"max(x{DEGREES - 1})", f"min(x{DEGREES - 1})"):
        assert scene[quantity].error is not None
    return 1e3 * (process_time() - start), scene


def _data(count: int) -> "tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]":
    """(masses, stiffnesses, times, values of the record), as they are written."""
    import numpy as np

    dice = np.random.default_rng(1)
    masses, stiffnesses = dice.uniform(1, 3, DEGREES).round(4), dice.uniform(100, 2000, DEGREES).round(3)
    values = dice.normal(size=count).cumsum()
    values -= np.linspace(values[0], values[-1], count)
    return masses, stiffnesses, EVERY * np.arange(count), values.round(6)


def _written(folder: str, name: str, forces: int, count: int) -> str:
    """The file of a scene: masses in a row, the last `forces` of them driven by one record."""
    masses, stiffnesses, times, values = _data(count)
    record, file = (os.path.join(folder, part) for part in (f"record_{count}.csv", f"{name}_{count}.yaml"))
    with open(record, "w", encoding="utf-8") as stream:
        stream.writelines(f"{t:.2f},{a:.6f}\n" for t, a in zip(times, values, strict=True))
    ends = [("ground" if not i else f"b{i - 1}", f"b{i}") for i in range(DEGREES)]
    lines = [f"records: {{ag: {{file: record_{count}.csv, unit: N}}}}", "bodies:",
             *(f"  b{i}: {{mass: {m} kg, slide: x{i}}}" for i, m in enumerate(masses)), "springs:",
             *(f"  s{i}: {{k: {k} N/m, between: [{', '.join(ends[i])}]}}" for i, k in enumerate(stiffnesses)),
             "dampers:",
             *(f"  d{i}: {{c: {0.002 * k:.6f} N*s/m, between: [{', '.join(ends[i])}]}}"
               for i, k in enumerate(stiffnesses)), "forces:",
             *(f"  f{i}: {{at: b{DEGREES - 1 - i}, force: {i + 1}*ag(t)}}" for i in range(forces)), "motion: small",
             f"find: [{{response: {{of: [x{DEGREES - 1}], until: {times[-1]:.2f} s}}}}]"]
    with open(file, "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")
    return file


def _lsim(count: int) -> "tuple[float, np.ndarray]":
    """(ms, values) of the same motion by lsim."""
    import numpy as np
    from scipy.signal import lsim

    masses, stiffnesses, times, values = _data(count)
    start = process_time()
    K, C = in_a_row(stiffnesses), in_a_row((0.002 * stiffnesses).round(6))
    inverse, none = np.diag(1 / masses), np.zeros((DEGREES, DEGREES))
    A = np.block([[none, np.eye(DEGREES)], [-inverse @ K, -inverse @ C]])
    push, read = np.zeros((2 * DEGREES, 1)), np.zeros((1, 2 * DEGREES))
    push[-1], read[0, DEGREES - 1] = 1 / masses[-1], 1.0
    found = lsim((A, push, read, np.zeros((1, 1))), values, times)[1]
    return 1e3 * (process_time() - start), found
