"""Forcing as arrays: for each kind of wave τᵏe^{sτ} the segments it is in, and its coefficients there."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.forcing import Segment
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.recorded_forcing import RecordedForcing, SharedBlow, SharedWave


class Waves(NamedTuple):
    """Re(coefficients · τᵏe^{sτ}) on the segments `at`; coefficients: one row a segment, one column a channel; or,
    where there are `shares` (columns, channels), a column for what many channels have a share in."""

    power: int
    exponent: complex
    at: np.ndarray
    coefficients: np.ndarray
    shares: np.ndarray | None = None

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

    def grown(self, tau: np.ndarray) -> np.ndarray | float:
        """τᵏe^{sτ}."""
        found = tau**self.power if self.power else 1.0
        return found * np.exp(self.exponent * tau) if self.exponent else found

    def pushes(self, n: int) -> bool:
        """Do the first n channels have any?"""
        return bool((self.coefficients if self.shares is None else self.shares)[:, :n].any())

    def through(self, A: np.ndarray, conjugate: bool = False) -> np.ndarray:
        """A f of every row f, or of its conjugate: (segments, len(A)); A may leave out the last channels."""
        rows, A = self._shared(A)
        return _times(rows.conj() if conjugate else rows, A)

    def onto(self, row: np.ndarray) -> np.ndarray:
        """row · f of every row f."""
        found: np.ndarray = self.coefficients @ (row if self.shares is None else self.shares @ row)
        return found

    def size(self, A: np.ndarray, largest: bool = False) -> np.ndarray:
        """What |A f| is added from, |A| |f|, of every row: (len(A), segments); largest: the larger |A f| of f and of
        its conjugate."""
        rows, A = self._shared(A)
        if largest:
            found: np.ndarray = np.abs(A @ rows.T)
            if np.iscomplexobj(rows):
                found = np.maximum(found, np.abs(A @ rows.conj().T))
            return found
        total: np.ndarray = np.abs(A) @ np.abs(rows).T
        return total

    def among(self, segments: np.ndarray | slice) -> "Waves":
        """The same on some of the segments, ascending, which are numbered anew; of what is shared, on each of them."""
        if self.shares is not None:
            kept = self.coefficients[segments]
            return self._replace(at=np.arange(len(kept)), coefficients=kept)
        segments = np.asarray(segments)
        place = np.minimum(np.searchsorted(self.at, segments), len(self.at) - 1)
        held = self.at[place] == segments
        return self._replace(at=np.flatnonzero(held), coefficients=self.coefficients[place[held]])

    def _shared(self, A: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(rows, the matrix that makes A f of them)."""
        n = A.shape[1]
        return (self.coefficients[:, :n], A) if self.shares is None else (self.coefficients, A @ self.shares[:, :n].T)


def _times(force: np.ndarray, W: np.ndarray) -> np.ndarray:
    """W f of every row f, without turning real numbers into complex ones."""
    if np.iscomplexobj(force):
        found: np.ndarray = force @ W.T
        return found
    return np.asarray(force @ W.real.T + 1j * (force @ W.imag.T))


class Timeline:
    """starts: of the segments; lengths: of all, the last infinite; waves: a list of Waves; impulses: one row a
    segment, that act at its start."""

    def __init__(self, starts: np.ndarray, lengths: np.ndarray, impulses: np.ndarray, waves: Sequence[Waves]) -> None:
        self.starts, self.lengths, self.impulses, self.waves = starts, lengths, impulses, waves

    @cached_property
    def steps(self) -> tuple[np.ndarray, np.ndarray]:
        """(the unlike lengths of all segments but the last, which of them each has)."""
        return np.unique(self.lengths[:-1], return_inverse=True)

    def place(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(segment, time from its start) of each time."""
        segment = np.searchsorted(self.starts, times, "right") - 1
        return segment, times - self.starts[segment]

    def among(self, segments: np.ndarray | slice) -> "Timeline":
        """Some of the segments, ascending, numbered anew."""
        return Timeline(self.starts[segments], self.lengths[segments], self.impulses[segments],
                        [waves.among(segments) for waves in self.waves])


def timeline_of(channels: int, pieces: Sequence[Segment]) -> Timeline:
    """The Timeline of segments that are told one by one."""
    starts = np.array([piece.start for piece in pieces] or [0.0])
    impulses, found = np.zeros((len(starts), channels)), {}
    for at, piece in enumerate(pieces):
        for channel, size in piece.impulses:
            impulses[at, channel] += size
        for wave in piece.waves:
            s, c = complex(wave.exponent), complex(wave.coefficient)
            if s.imag < 0:
                s, c = s.conjugate(), c.conjugate()
            found.setdefault((wave.power, s), {}).setdefault(at, {}).setdefault(wave.channel, []).append(c)
    return Timeline(starts, _lengths(starts), impulses,
                    [_waves(channels, *kind, there) for kind, there in found.items()])


def bare_timeline(starts: np.ndarray) -> Timeline:
    """The Timeline of segments on which nothing acts."""
    return Timeline(starts, _lengths(starts), np.zeros((len(starts), 0)), [])


def _lengths(starts: np.ndarray) -> np.ndarray:
    return np.append(np.diff(starts), np.inf)


def _waves(channels: int, power: int, exponent: complex, there: Mapping[int, dict[int, list[complex]]]) -> Waves:
    rows = np.zeros((len(there), channels), complex)
    for row, by_channel in zip(rows, there.values(), strict=True):
        for channel, parts in by_channel.items():
            row[channel] = sum(parts)
    return Waves(power, exponent, np.array(list(there)), rows if exponent.imag else rows.real)


def timeline_of_records(forcing: "RecordedForcing") -> Timeline:
    """The Timeline of a RecordedForcing."""
    count, kinds = len(forcing.starts), {}
    for wave in forcing.waves:
        kinds.setdefault((wave.power, wave.exponent), []).append(wave)
    impulses = np.broadcast_to(0.0, (count, forcing.channels))
    if forcing.blows:
        impulses = np.stack([blow.series for blow in forcing.blows], axis=1) @ _shares(forcing, forcing.blows)
    every = np.arange(count)
    return Timeline(forcing.starts, _lengths(forcing.starts), impulses, [
        Waves(*kind, every, np.stack([one.series for one in same], axis=1), _shares(forcing, same))
        for kind, same in kinds.items()])


def _shares(forcing: "RecordedForcing", parts: "Sequence[SharedBlow | SharedWave]") -> np.ndarray:
    found = np.zeros((len(parts), forcing.channels))
    for row, part in zip(found, parts, strict=True):
        row[list(part.shares)] = list(part.shares.values())
    return found
