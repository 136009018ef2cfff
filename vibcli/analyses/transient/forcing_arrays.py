"""Forcing as arrays: for each kind of wave τᵏe^{sτ} the segments it is in, and its coefficients there."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Segment


class Waves(NamedTuple):
    """Re(coefficients · τᵏe^{sτ}) on the segments `at`; coefficients: one row a segment, one column a channel."""

    power: int
    exponent: complex
    at: np.ndarray
    coefficients: np.ndarray

    def derivative(self, order: int) -> dict[int, complex]:
        """The order-th derivative as {power: factor}: the same waves with other powers."""
        terms = {self.power: 1.0}
        for _ in range(order):
            found = {}
            for power, factor in terms.items():
                found[power] = found.get(power, 0.0) + factor * self.exponent
                if power:
                    found[power - 1] = found.get(power - 1, 0.0) + factor * power
            terms = found
        return {power: factor for power, factor in terms.items() if factor}


class Timeline:
    """starts: of the segments; lengths: of all, the last infinite; waves: a list of Waves; impulses: one row a
    segment, that act at its start."""

    __slots__ = ("impulses", "lengths", "starts", "waves")

    def __init__(self, channels: int, pieces: "Sequence[Segment]"):
        self.starts = np.array([piece.start for piece in pieces] or [0.0])
        self.lengths = np.append(np.diff(self.starts), np.inf)
        self.impulses = np.zeros((len(self.starts), channels))
        found = {}
        for at, piece in enumerate(pieces):
            for channel, size in piece.impulses:
                self.impulses[at, channel] += size
            for wave in piece.waves:
                s, c = complex(wave.exponent), complex(wave.coefficient)
                if s.imag < 0:
                    s, c = s.conjugate(), c.conjugate()
                found.setdefault((wave.power, s), {}).setdefault(at, {}).setdefault(wave.channel, []).append(c)
        self.waves = [_waves(channels, *kind, there) for kind, there in found.items()]

    def place(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(segment, time from its start) of each time."""
        segment = np.searchsorted(self.starts, times, "right") - 1
        return segment, times - self.starts[segment]


def _waves(channels, power, exponent, there):
    rows = np.zeros((len(there), channels), complex)
    for row, by_channel in zip(rows, there.values(), strict=True):
        for channel, parts in by_channel.items():
            row[channel] = sum(parts)
    return Waves(power, exponent, np.array(list(there)), rows if exponent.imag else rows.real)
