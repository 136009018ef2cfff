"""A comparison beside an older one: ratios of run times to those of the other methods, never times.

Of a method whose time is 0, as a coarse clock tells short ones, there is no ratio.

A row is worse where its ratio has grown by more than 30 % and by more than three times the spread of its runs, in two
runs out of two.
"""

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Document, Section, TableBlock, paragraph

GROWN, SPREADS = 1.3, 3.0
LARGEST = 20 * 2**20    # bytes of a comparison


class RatioRow(NamedTuple):
    """The ratio of our time to that of another method, before and now; spread: relative, of the four times."""

    name: str
    before: float
    now: float
    spread: float

    @property
    def worse(self) -> bool:
        """Has it grown beyond doubt?"""
        grown = self.now / self.before
        return grown > GROWN and grown - 1 > SPREADS * self.spread


class Beside(NamedTuple):
    """rows that both have; alone: names of those of which one side has a ratio; remark: where it was measured
    otherwise."""

    rows: list[RatioRow]
    alone: list[str]
    remark: str


def older(path: str) -> dict[str, Any]:
    """A comparison that was written, as data; ValueError where it is none, OSError where it cannot be read."""
    with Path(path).open("rb") as stream:
        text = stream.read(LARGEST + 1)
    if len(text) > LARGEST:
        raise ValueError(f"it is longer than {LARGEST} bytes")
    try:
        found: dict[str, Any] = json.loads(text)
    except (ValueError, RecursionError):
        raise ValueError("it is no JSON") from None
    _rows(found)
    return found


def beside(before: Mapping[str, Any], now: Mapping[str, Any]) -> Beside:
    """Of two comparisons as data."""
    old, new = _rows(before), _rows(now)
    rows = [RatioRow(name, old[name][0], new[name][0], max(old[name][1], new[name][1])) for name in new if name in old]
    other = [f"{what} {before.get(what)}" for what in ("version", "machine") if before.get(what) != now.get(what)]
    return Beside(rows, sorted(old.keys() ^ new.keys()), ", ".join(other))


def _rows(data: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    """{name: (ratio, spread)} of all pairs of our time and another's; ValueError of data that are no comparison."""
    try:
        found = {}
        for one in data["compared"]:
            ours, *others = one["points"]
            (time, spread), *times = map(_time, one["points"])
            for other, (its, its_spread) in zip(others, times, strict=True):
                if ours["error"] is not None and other["error"] is not None and other["runs"] > 1 and time and its:
                    name = f"{one['asked']}: {other['method']} {other['with'] or ''}".strip()
                    found[name] = time / its, max(spread, its_spread)
        return found
    except (KeyError, TypeError, ValueError, ArithmeticError, AttributeError):
        raise ValueError("it holds no comparison: `vibcli bench FILE --json` writes one") from None


def _time(point: Mapping[str, Any]) -> tuple[float, float]:
    """(seconds, their relative spread)."""
    low, high = point["quartiles"]
    if not all(0.0 <= float(time) < math.inf for time in (low, point["seconds"], high)):
        raise ValueError
    return point["seconds"], (high - low) / (point["seconds"] or 1.0)


def worse_in_both(first: Beside, again: Beside) -> list[str]:
    """The names of rows that are worse in two runs."""
    return [row.name for row in again.rows if row.worse and row.name in {one.name for one in first.rows if one.worse}]


def document(found: Beside, worse: list[str]) -> Document:
    """The rows, those that are worse marked, and what is on one side alone."""
    rows = tuple((row.name, f"{row.before:.3g}", f"{row.now:.3g}", f"{row.now / row.before:.2f} ×",
                  f"± {100 * row.spread:.0f} %", "worse" if row.name in worse else "") for row in found.rows)
    blocks: list[Any] = [TableBlock(("our time over that of", "before", "now", "grown", "spread", ""), rows)
                         if rows else paragraph("Nothing is on both sides with a time that was measured.")]
    if found.remark:
        blocks.append(paragraph(f"The older one is of {found.remark}."))
    if found.alone:
        blocks.append(paragraph(f"On one side alone: {', '.join(found.alone)}."))
    return Document("Beside an older comparison", None, (), (Section("Ratios of run times", tuple(blocks)),))
