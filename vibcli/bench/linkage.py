"""Deriving a closed linkage against its number of bars: lazy tongs of crossed bars, one loop between each two cells.

The time is that of its scene and of the linearised expressions in all positions, from the spec and imports excluded.
Times are medians; the exponent p of t ~ nᵖ is fitted to the fastest runs.
"""

import json
from statistics import median
from time import process_time
from typing import Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing, exponent

BARS, EXPONENT = (4, 10, 20, 40), 2.5


def rows(runs: Any) -> list[Any]:
    """Milliseconds for each number of bars, and the exponent of their growth."""
    times = json.loads(answer("from vibcli.bench.linkage import main; main()", runs))
    found = [Timing(f"deriving a linkage of {bars} bars", median(times[str(bars)]), "ms", None) for bars in BARS]
    grown = exponent(BARS, [min(times[str(bars)]) for bars in BARS])
    return [*found, Timing("  exponent", grown, "", EXPONENT, absolute=True)]


def main() -> None:
    """Child process: print {number of bars: [ms of each run]}."""
    import sys

    _derivation(4)
    print(json.dumps({bars: [1e3 * _derivation(bars) for _ in range(min(int(sys.argv[1]), 5))] for bars in BARS}))


def _derivation(bars: int) -> float:
    """Processor seconds from the spec to the linearised expressions."""
    from vibcli.api.source import problem_of, text_source

    problem = problem_of(text_source(tongs(bars // 2)))
    start = process_time()
    _ = problem.system.linearisation
    return process_time() - start


def tongs(cells: Any) -> str:
    """Lazy tongs: crossed bars a and b pinned at their middles c, their ends joined to those of the next cell; the
    first bar turns about its lower end, and the upper end of the other one runs along a wall."""
    bodies, points, constraints = [], [], ["guide: {point: high0, surface: wall}"]
    for i in range(cells):
        motion = f"move: [x{i}, y{i}, phi{i}]" if i else "pin: {at: [0, 0], by: phi0}"
        rod, pin = "shape: rod, mass: m", f"pin: {{at: c{i}, by: psi{i}}}"
        bodies += [f"a{i}: {{{rod}, from: [{i} m, 0], to: [{i + 1} m, 1 m], {motion}}}",
                   f"b{i}: {{{rod}, from: [{i} m, 1 m], to: [{i + 1} m, 0], {pin}}}"]
        points += [f"c{i}: {{body: a{i}, at: [{i}.5 m, 0.5 m]}}",
                   f"low{i}: {{body: a{i}, at: [{i} m, 0]}}", f"top{i}: {{body: a{i}, at: [{i + 1} m, 1 m]}}",
                   f"high{i}: {{body: b{i}, at: [{i} m, 1 m]}}", f"end{i}: {{body: b{i}, at: [{i + 1} m, 0]}}"]
        if i:
            constraints += [f"upper{i}: {{join: [top{i - 1}, high{i}]}}", f"lower{i}: {{join: [end{i - 1}, low{i}]}}"]
    sections = {"parameters": ["m: 1 kg", "k: 100 N/m", "g: 9.81 m/s^2"], "points": points,
                "surfaces": ["wall: {line: [[0, 0], [0, 1 m]]}"], "bodies": bodies,
                "springs": [f"s: {{k: k, between: [low0, end{cells - 1}]}}"], "constraints": constraints}
    return "gravity: g\n" + "".join("\n  ".join([f"{name}:", *lines]) + "\n" for name, lines in sections.items())
