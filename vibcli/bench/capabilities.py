"""Capability by capability: run time and true error of what is kept as evidence, beside the plain method that comes
nearest, each against the same values of many digits.

The errors of ours are to stay within the bounds that it states; where nothing plain has an answer the row stands alone.
"""

import json
from typing import TYPE_CHECKING, Any

from vibcli.bench.kept import KEPT
from vibcli.bench.processes import answer
from vibcli.bench.rows import Failure, Timing

if TYPE_CHECKING:
    from vibcli.evidence.timing import Point

WHOLE = 4.0         # s for the runs of one comparison
HELD = 1.0          # error over bound


def rows(runs: Any) -> list[Any]:
    """Of each comparison its time, beside that of the nearest plain method, and its error over its bound."""
    return [row for name in KEPT for row in _rows(name, runs)]


def _rows(name: str, runs: int) -> list[Timing | Failure]:
    found = json.loads(answer("from vibcli.bench.capabilities import main; main()", name, int(runs)))
    title = KEPT[name][0]
    if "why" in found:
        return [Failure(title, found["why"])]
    plain = found["plain"]
    words = "" if plain is None else f"{plain['method']} {plain['with']}, error {plain['error']:.1e}".replace(" ,", ",")
    return [Timing(title, found["ms"], "ms", None, words, plain and plain["ms"]),
            Timing(f"  error {found['error']:.1e}, over its bound", found["error"] / found["bound"], "", HELD,
                   absolute=True)]


def main() -> None:
    """Child process: print ours and the plain method with the least error, the fastest of equal ones."""
    import sys

    from vibcli.api.source import problem_of, text_source
    from vibcli.api.values import quantity_asked
    from vibcli.evidence.compared import evidence

    _, text, quantity = KEPT[sys.argv[1]]
    problem = problem_of(text_source(text))
    found = evidence(problem, [quantity_asked(problem.spec, quantity)], int(sys.argv[2]), WHOLE)
    if not found.compared:
        print(json.dumps({"why": found.left_out[0].why}))
        return
    ours, *others = found.compared[0].points
    plain = [point for point in others if point.error is not None]
    best = min(plain, key=lambda point: (max(point.error, 2.0**-52), point.seconds[1]), default=None)
    print(json.dumps({**_told(ours), "bound": ours.bound, "plain": best and _told(best)}))


def _told(point: "Point") -> dict[str, Any]:
    return {"method": point.method, "with": point.setting, "ms": 1e3 * point.seconds[1], "error": point.error}
