"""Many files in one process: `vibcli check` of the problems, and of plain numeric scenes.

The baseline of a file is a fresh process that does no more than import what numbers need, as one that checks a file by
itself would have to.
"""

import os
import tempfile
from typing import Any

from vibcli.bench import scenes
from vibcli.bench.processes import costs, python, vibcli
from vibcli.bench.rows import Timing
from vibcli.bench.startup import NUMBERS, written

PROBLEMS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "problems")
FILES = 200
EACH, ALL, TWICE = 0.1, 1.25, 1.25      # of fresh processes; of one process: the processor time that two take


def rows(runs: Any) -> list[Timing]:
    """Milliseconds a file, start-up shared out among them; the problems by one process and by two."""
    with tempfile.TemporaryDirectory() as folder:
        for i in range(FILES):
            written(folder, f"{i:03}.yaml", scenes.TWO_DEGREES)
        found = costs({"check": (vibcli("check", "--quiet", folder), (0,)), NUMBERS: (python(NUMBERS), (0,))}, runs)
    fresh = found[NUMBERS].time
    case = f"vibcli check, {FILES} files of two degrees, each"
    return [Timing(case, found["check"].time / FILES, "ms", EACH, NUMBERS, fresh), *_problems(fresh)]


def _problems(fresh: float) -> list[Timing]:
    """Once each: they take long."""
    if not os.path.isdir(PROBLEMS):
        return []
    count = sum(name.endswith(".yaml") for _, _, names in os.walk(PROBLEMS) for name in names)
    found = costs({jobs: (vibcli("check", "--quiet", "--jobs", jobs, PROBLEMS), (0,)) for jobs in ("1", "2")}, 1,
                  warm=True)
    one, two = found["1"], found["2"]
    return [Timing(f"vibcli check, {count} problems", one.time / 1e3, "s", ALL, f"as many times {NUMBERS}",
                   count * fresh / 1e3),
            Timing("  with --jobs 2, all processes", two.time / 1e3, "s", TWICE, "in one", one.time / 1e3),
            Timing("  with --jobs 2, by the clock", two.elapsed / 1e3, "s", None, "in one", one.elapsed / 1e3)]
