"""One line of the table: what was measured, against what, and the budget that it has to keep."""

from collections.abc import Iterable, Sequence
from math import log
from statistics import linear_regression
from typing import Any

TIMES = ("ms", "s")


class Timing:
    """`ours` and `against` in `unit`; the budget bounds their ratio, or `ours` alone where `absolute`: bare numbers as
    errors, exponents and counts, never a time. Without `against`, as where a peer is not installed, a ratio is kept."""

    __slots__ = ("absolute", "against", "baseline", "budget", "case", "ours", "unit")

    def __init__(self, case: str | None, ours: float, unit: str, budget: Any, baseline: str = "",
                 against: Any = None, absolute: bool = False):
        if absolute and unit in TIMES and budget is not None:
            raise ValueError(f"{case}: a time is bounded by another of the same run")
        self.case, self.ours, self.unit, self.budget = case, ours, unit, budget
        self.baseline, self.against, self.absolute = baseline, against, absolute

    @property
    def ratio(self) -> Any:
        """None also of bare numbers (errors, exponents), whose quotient says nothing."""
        return None if self.against is None or not self.unit else self.ours / self.against

    @property
    def kept(self) -> bool:
        """Is the budget kept? A row without budget only informs."""
        bounded = self.ours if self.absolute else self.ratio
        return self.budget is None or bounded is None or bounded <= self.budget

    def cells(self) -> tuple[str, ...]:
        """The columns of the printed table."""
        against = "" if self.against is None else f"{_short(self.against)} {self.unit}".rstrip()
        allowed = "" if self.budget is None else (
            f"≤ {_short(self.budget)} {self.unit}".rstrip() if self.absolute else f"≤ {self.budget:g} ×")
        idle = self.budget is None or (not self.absolute and self.ratio is None)
        verdict = "" if idle else "ok" if self.kept else "over"
        return (self.case, f"{_short(self.ours)} {self.unit}".rstrip(), against, self.baseline,
                "" if self.ratio is None else f"{self.ratio:.3g} ×", allowed, verdict)

    def data(self) -> dict[str, Any]:
        return {"case": self.case, "ours": self.ours, "unit": self.unit, "baseline": self.baseline or None,
                "against": self.against, "ratio": self.ratio, "budget": self.budget,
                "bounds": "ours" if self.absolute else "ratio", "kept": self.kept}


class Failure:
    """A part that could not be measured, and why."""

    kept = False

    def __init__(self, part: str, why: str):
        self.part, self.why = part, why

    def cells(self) -> tuple[str, ...]:
        """The columns of the printed table."""
        return (f"{self.part}: {self.why}"[:LONGEST], "", "", "", "", "", "failed")

    def data(self) -> dict[str, Any]:
        return {"case": self.part, "failure": self.why, "kept": False}


def exponent(sizes: Sequence[float], times: Sequence[float]) -> float:
    """p of t ~ nᵖ, by least squares of the logarithms."""
    return linear_regression(list(map(log, sizes)), list(map(log, times))).slope


LONGEST = 120
HEAD = ("case", "ours", "baseline", "", "ratio", "budget", "")


def _short(value: float) -> str:
    return f"{value:.1e}" if 0 < abs(value) < 0.005 else f"{value:.3g}" if abs(value) < 100 else f"{value:.0f}"


def aligned(lines: Iterable[Sequence[str]]) -> str:
    """Lines of cells as text with columns of equal width."""
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
                     for line in lines)
