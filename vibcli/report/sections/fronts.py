"""Where signals of travelling waves leap, and the two values they have there."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from vibcli.notation.numbers import figure, supported
from vibcli.report.blocks import Section, TableBlock, section

if TYPE_CHECKING:
    from vibcli.report.sections.requested_signals import RequestedSignal

SHOWN = 8           # fronts of a signal


def fronts(asked: "Sequence[RequestedSignal]", until: float) -> Iterator[Section]:
    """A table of the first fronts of each signal that leaps."""
    rows: list[tuple[str, ...]] = []
    for one in asked:
        found = one.signal.leaps(until)
        largest = max((abs(value) for _, *both in found for value in both), default=0.0)
        for t, before, after in found[:SHOWN]:
            error = one.signal.error(t)
            rows.append((f"{one.label} [{one.unit}]".replace(" []", ""), figure(t),
                         *(supported(value, error, beside=largest) for value in (before, after))))
        if len(found) > SHOWN:
            rows.append((f"{one.label}: {len(found) - SHOWN} more", "", "", ""))
    if rows:
        yield from section("Fronts", TableBlock(("signal", "at t [s]", "before", "after"), tuple(rows)))
