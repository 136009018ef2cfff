"""Pictures, and reports with pictures, as whole processes: against what they cannot do without, and the report alone.

The largest of the frames that move is bounded in bytes, which are counted.
"""

import os
import tempfile
from typing import Any

from vibcli.bench.processes import costs, python, vibcli
from vibcli.bench.rows import Timing
from vibcli.bench.scenes import TWO_DEGREES
from vibcli.bench.startup import NUMBERS, READ, written

MATPLOTLIB = "import click, yaml, matplotlib.figure"
MOVING = 100_000        # bytes


def rows(runs: Any) -> list[Timing]:
    """Processor time of each kind of picture, and the bytes of one that moves."""
    with tempfile.TemporaryDirectory() as folder:
        scene = written(folder, "scene.yaml", TWO_DEGREES)

        def made(name: str, *args: str) -> tuple[list[str], tuple[int]]:
            return vibcli(*args, scene, "-o", os.path.join(folder, name), "--force"), (0,)

        found = costs({
            READ: (python(READ), (0,)), NUMBERS: (python(NUMBERS), (0,)), MATPLOTLIB: (python(MATPLOTLIB), (0,)),
            "svg": made("a.svg", "draw"), "png": made("a.png", "draw"), "moving": made("m.svg", "animate"),
            "page": made("m.html", "animate"), "gif": made("m.gif", "animate"), "report": made("r.html", "solve"),
            "illustrated": made("p.html", "solve", "--pictures")}, runs)
        size = os.path.getsize(os.path.join(folder, "m.svg"))

    def row(case: str, ours: str, baseline: str, budget: float, words: str = "") -> Timing:
        return Timing(case, found[ours].time, "ms", budget, words or baseline, found[baseline].time)

    return [row("vibcli draw, svg", "svg", READ, 2.2), row("vibcli draw, png", "png", MATPLOTLIB, 2.0),
            row("vibcli animate, svg", "moving", NUMBERS, 2.0), row("vibcli animate, html", "page", NUMBERS, 2.0),
            row("vibcli animate, gif", "gif", "moving", 3.0, "the same as svg"),
            row("vibcli solve --pictures, html", "illustrated", "report", 1.8, "without pictures"),
            Timing("  bytes of a mode that moves, svg", size, "", MOVING, absolute=True)]
