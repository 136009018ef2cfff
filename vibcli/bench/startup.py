"""Cold starts: commands as whole processes against the imports that they cannot do without, and the import alone."""

import os
import tempfile
from statistics import median

from vibcli.bench import scenes
from vibcli.bench.members import CANTILEVER
from vibcli.bench.processes import answer, costs, python, vibcli
from vibcli.bench.rows import Timing

READ, NUMBERS, LETTERS = "import click, yaml", "import click, yaml, numpy", "import sympy"
IMPORT = "from time import process_time\nstart = process_time()\nimport %s\nprint(process_time() - start)"


def rows(runs: int) -> list[Timing]:
    """The rows of the start-up budgets."""
    with tempfile.TemporaryDirectory() as folder:
        return _rows(runs, folder)


def _rows(runs: int, folder: str) -> list[Timing]:
    broken, numeric, letters, member, driven = (written(folder, name, text) for name, text in (
        ("broken.yaml", scenes.BROKEN), ("numeric.yaml", scenes.TWO_DEGREES), ("letters.yaml", scenes.TWO_SYMBOLIC),
        ("member.yaml", CANTILEVER % ""), ("driven.yaml", scenes.TWO_DRIVEN)))
    found = costs({
        READ: (python(READ), (0,)), NUMBERS: (python(NUMBERS), (0,)), LETTERS: (python(LETTERS), (0,)),
        "help": (vibcli("--help"), (0,)), "broken": (vibcli("check", broken), (3,)),
        "frequencies": (vibcli("frequencies", numeric), (0,)), "member": (vibcli("frequencies", member), (0,)),
        "check": (vibcli("check", numeric), (0,)),
        "solve": (vibcli("solve", letters), (0,)),
        "frf": (vibcli("frf", driven), (0,)), "response": (vibcli("response", driven), (0,)),
    }, runs)

    def row(case: str, ours: str, baseline: str, budget: float) -> Timing:
        return Timing(case, found[ours].time, "ms", budget, baseline, found[baseline].time)

    return [
        Timing("import vibcli", _imported("vibcli", runs), "ms", 0.1, READ, _imported("click, yaml", runs)),
        row("vibcli --help", "help", READ, 1.5),
        row("vibcli check, a file with a slip", "broken", READ, 1.5),
        row("vibcli frequencies, two degrees", "frequencies", NUMBERS, 1.5),
        Timing("  its peak memory", found["frequencies"].memory, "MiB", 1.4, NUMBERS, found[NUMBERS].memory),
        row("vibcli frequencies, a cantilever", "member", NUMBERS, 1.5),
        row("vibcli check, two degrees", "check", NUMBERS, 1.5),
        row("vibcli frf, two masses", "frf", NUMBERS, 1.6),
        row("vibcli response, two masses", "response", NUMBERS, 1.8),
        row("vibcli solve, two degrees in letters", "solve", LETTERS, 2.5),
    ]


def _imported(names: str, runs: int) -> float:
    """Milliseconds of importing in a fresh process."""
    return 1e3 * median(float(answer(IMPORT % names)) for _ in range(runs))


def written(folder: str, name: str, text: str) -> str:
    """The path of a new file with a text."""
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)
    return path
