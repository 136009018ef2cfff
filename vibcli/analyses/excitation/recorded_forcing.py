"""What drives a motion where that holds long records: as arrays over its segments, which all forces share that name
them."""

from collections.abc import Iterable, Mapping, Sequence
from math import comb, inf, nextafter
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.forcing import Segment, Wave, task_of
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.error_free import whole_product

if TYPE_CHECKING:
    from vibcli.base.work import Work


class SharedWave(NamedTuple):
    """Re(series τᵏe^{sτ}), one number of the series a segment, times `shares` {channel: factor}."""

    power: int
    exponent: complex
    series: np.ndarray
    shares: Mapping[int, float]

    @property
    def bends(self) -> np.ndarray | bool:
        """Where it is no constant."""
        return self.series != 0 if self.power or self.exponent else False


class SharedBlow(NamedTuple):
    """Impulses at the starts of segments, one number of the series each, times `shares` {channel: factor}."""

    series: np.ndarray
    shares: Mapping[int, float]


class RecordedForcing:
    """A Forcing of so many segments that they are not told one by one: `starts`, ascending from 0, and what acts on
    them."""

    period, turn, since, listed, recorded = None, None, 0.0, True, True

    def __init__(self, channels: int, starts: np.ndarray, waves: Sequence[SharedWave],
                 blows: Sequence[SharedBlow]) -> None:
        self.channels = channels
        new = _new(waves, blows, len(starts))
        self.starts = starts[new]
        self.waves = [wave._replace(series=wave.series[new]) for wave in waves if wave.series.any()]
        self.blows = [blow._replace(series=blow.series[new]) for blow in blows if blow.series.any()]

    @property
    def speeds(self) -> set[float]:
        """The angular frequencies in it."""
        return {abs(wave.exponent.imag) for wave in self.waves} - {0.0}

    @property
    def last(self) -> Segment:
        return self._segment(len(self.starts) - 1)

    @property
    def pieces(self) -> tuple[Segment, ...]:
        return tuple(self.segments(inf))

    def less(self, lasting: Iterable[Wave]) -> "RecordedForcing":
        """This less the waves, counted from t = 0, which are all in its last segment that do not die out."""
        kept = [wave if wave.exponent.real else wave._replace(series=np.append(wave.series[:-1], 0.0))
                for wave in self.waves]
        for channel, c, k, s in lasting:
            angle, lost = whole_product(s.imag, self.starts[:-1])
            factor = -c * np.exp(1j * angle) * (1 + 1j * lost) if s else -np.full(len(angle), complex(c).real)
            kept += [SharedWave(j, s, np.append(comb(k, j) * self.starts[:-1] ** (k - j) * factor, 0.0), {channel: 1.0})
                     for j in range(k + 1)]
        return RecordedForcing(self.channels, self.starts, kept, self.blows)

    def segments(self, until: float, work: "Work | None" = None) -> list[Segment]:
        """The segments that start before `until`, one by one; TooOften where they are too many for that."""
        count = max(1, int(np.searchsorted(self.starts, until)))
        with task_of(work, count):
            return [self._segment(i) for i in range(count)]

    def count(self, until: float) -> int:
        """How many segments start up to an instant."""
        return max(1, int(np.searchsorted(self.starts, nextafter(until, inf))))

    def _segment(self, i: int) -> Segment:
        waves = tuple(Wave(channel, wave.series[i].item() * share, wave.power, wave.exponent)
                      for wave in self.waves if wave.series[i] for channel, share in wave.shares.items())
        blows = tuple((channel, blow.series[i].item() * share)
                      for blow in self.blows if blow.series[i] for channel, share in blow.shares.items())
        return Segment(float(self.starts[i]), waves, blows)


def _new(waves: "Iterable[SharedWave]", blows: "Iterable[SharedBlow]", count: int) -> np.ndarray:
    """Which segments are not as the one before, at rest on their level and without a blow."""
    new = np.zeros(count, bool)
    new[0] = True
    for wave in waves:
        new |= wave.bends
        new[1:] |= wave.series[1:] != wave.series[:-1]
    for blow in blows:
        new |= blow.series != 0
    return new
