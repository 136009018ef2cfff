"""A comparison beside an older one: ratios of run times to those of the other methods, never times.

A row is worse where its ratio has grown by more than 30 % and by more than three times the spread of its runs, in two
runs out of two.
"""

from collections.abc import Mapping
from typing import Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Document, Section, TableBlock, paragraph

GROWN, SPREADS = 1.3, 3.0


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
    """rows that both have; alone: names of those that one side has; remark: where it was measured otherwise."""

    rows: list[RatioRow]
    alone: list[str]
    remark: str


def beside(before: Mapping[str, Any], now: Mapping[str, Any]) -> Beside:
    """Of two comparisons as data; ValueError where one is none."""
    old, new = _rows(before), _rows(now)
    rows = [RatioRow(name, old[name][0], new[name][0], max(old[name][1], new[name][1])) for name in new if name in old]
    other = [f"{what} {before.get(what)}" for what in ("version", "machine") if before.get(what) != now.get(what)]
    return Beside(rows, sorted(old.keys() ^ new.keys()), ", ".join(other))


def _rows(data):
    """{name: (ratio, spread)} of all pairs of our time and another's."""
    try:
        found = {}
        for one in data["compared"]:
            ours, *others = one["points"]
            for other in others:
                if ours["error"] is not None and other["error"] is not None and other["runs"] > 1:
                    name = f"{one['asked']}: {other['method']} {other['with'] or ''}".strip()
                    found[name] = ours["seconds"] / other["seconds"], max(_spread(ours), _spread(other))
        return found
    except (KeyError, TypeError, ValueError, ZeroDivisionError, AttributeError):
        raise ValueError("it holds no comparison: `vibcli bench FILE --json` writes one") from None


def _spread(point):
    low, high = point["quartiles"]
    return (high - low) / point["seconds"]


def worse_in_both(first: Beside, again: Beside) -> list[str]:
    """The names of rows that are worse in two runs."""
    return [row.name for row in again.rows if row.worse and row.name in {one.name for one in first.rows if one.worse}]


def document(found: Beside, worse: list[str]) -> Document:
    """The rows, those that are worse marked, and what is on one side alone."""
    rows = tuple((row.name, f"{row.before:.3g}", f"{row.now:.3g}", f"{row.now / row.before:.2f} ×",
                  f"± {100 * row.spread:.0f} %", "worse" if row.name in worse else "") for row in found.rows)
    blocks: list[Any] = [TableBlock(("our time over that of", "before", "now", "grown", "spread", ""), rows)]
    if found.remark:
        blocks.append(paragraph(f"The older one is of {found.remark}."))
    if found.alone:
        blocks.append(paragraph(f"On one side alone: {', '.join(found.alone)}."))
    return Document("Beside an older comparison", None, (), (Section("Ratios of run times", tuple(blocks)),))
