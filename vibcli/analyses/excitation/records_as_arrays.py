"""Exact sums of functions of time that hold long records, as a RecordedForcing.

Beside records (and what they are multiplied by, from instant to instant) they hold lines, and exponentials and sines of
one size. Instants, and the angles of sines, are sums of two doubles where one does not hold them.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.recorded_forcing import RecordedForcing, SharedBlow, SharedWave
from vibcli.analyses.excitation.rounding import Floating
from vibcli.analyses.excitation.tabulated import TabulatedFunction
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.error_free import whole_product, whole_sum

if TYPE_CHECKING:
    from vibcli.analyses.excitation.assembly import Gate, WaveGroup
    from vibcli.analyses.excitation.exponential_polynomials import Exact, ExactWave

SAME = float(Floating.same)


class RecordArrays(NamedTuple):
    """A TabulatedFunction: its instants are places + lates; values at them, and slopes between them."""

    places: np.ndarray
    lates: np.ndarray
    values: np.ndarray
    slopes: np.ndarray

    @classmethod
    def of(cls, gate: TabulatedFunction) -> "RecordArrays":
        times, values = gate.samples.arrays
        slopes = np.diff(values) / np.diff(times) * float(gate.a)
        rows = (*_instants(times, gate.a, gate.b), values, slopes)
        return cls(*(row[::-1] if gate.a < 0 else row for row in rows))


def _instants(times: np.ndarray, a: "Exact", b: "Exact") -> tuple[np.ndarray, np.ndarray]:
    """(time − b)/a, each as a sum of two."""
    if a == 1 and not b:
        return times, np.zeros(1)[np.zeros(len(times), int)]
    (steep, little), (shift, more) = _halves(a), _halves(b)
    place = (times - shift) / steep
    moved, rest = whole_sum(times, -shift)
    product, lost = whole_product(steep, place)
    left, further = whole_sum(moved, -product)
    return whole_sum(place, (left + (rest + further - lost - more - little * place)) / steep)


def _halves(number: "Exact") -> tuple[float, float]:
    """A rational as the sum of two doubles."""
    high = float(number)
    return high, float(number - Fraction(high))


def held(groups: "Sequence[WaveGroup]") -> bool:
    """Are they what is held as arrays?"""
    return all(_held(group) for group in groups)


def _held(group: "WaveGroup") -> bool:
    still, longest = not any(group.wave[:2]), max(map(len, group.ps))
    if not group.gates:
        return longest <= (2 if still else 1)
    gate, = group.gates if len(group.gates) == 1 else (None,)
    return isinstance(gate, TabulatedFunction) and not any(group.wave) and longest <= 1 and (
        gate.order == 0 or len(group.ps) == 1)


def recorded_forcing(groups: "Sequence[WaveGroup]", channels: int) -> RecordedForcing:
    """The RecordedForcing of WaveGroups that are held; OverflowError where they grow beyond floats."""
    arrays: dict[Gate, RecordArrays] = {gate: RecordArrays.of(gate) for group in groups for gate in group.gates
                                        if isinstance(gate, TabulatedFunction)}
    starts = _starts(groups, arrays)
    middles = np.append(starts[:-1] + 0.5 * np.diff(starts), starts[-1] + 0.5)
    waves, blows, shares = [], [], {}
    for group in groups:
        if group.gates and len(group.ps) == 1:
            at = shares.setdefault(group.gates[0], {})
            at[group.channel] = at.get(group.channel, 0.0) + float(group.ps[0][0])
        else:
            waves += _own(group, arrays, starts, middles)
    for gate, factors in shares.items():
        waves += _lines(gate, arrays[gate], (starts, middles), factors)
        blows += _blows(gate, arrays[gate], starts, factors)
    if not all(np.isfinite(part.series).all() for part in (*waves, *blows)):
        raise OverflowError
    return RecordedForcing(channels, starts, waves, blows)


def _starts(groups: "Sequence[WaveGroup]", arrays: "Mapping[Gate, RecordArrays]") -> np.ndarray:
    """The instants at which anything changes, those that differ by rounding alone taken as one."""
    spans = {(group.gates, *span) for group in groups for span in group.spans()}
    found = [np.zeros(1)]
    for gates, first, last in spans:
        low, high = float(first), None if last is None else float(last)
        found.append(np.array([low] if high is None else [low, high]))
        for gate in gates:
            places = arrays[gate].places
            found.append(places[(places >= low) & (places <= high)])
    starts = np.unique(np.concatenate(found))
    near = np.diff(starts) <= SAME * starts[1:]
    return _apart(starts) if near.any() else starts


def _apart(starts: np.ndarray) -> np.ndarray:
    kept = [0.0]
    for start in starts.tolist():
        if start - kept[-1] > SAME * start:
            kept.append(start)
    return np.array(kept)


def _lines(gate: TabulatedFunction, record: RecordArrays, at: tuple[np.ndarray, np.ndarray],
           shares: Mapping[int, float]) -> Iterator[SharedWave]:
    """The values and slopes of a record from the starts of segments on, `at`: (their starts, their middles)."""
    value, slope = _line(gate, record, *at)
    yield SharedWave(0, 0j, value, shares)
    yield SharedWave(1, 0j, slope, shares)


def _line(gate: TabulatedFunction, record: RecordArrays, starts: np.ndarray,
          middles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    i = np.searchsorted(record.places, middles, side="right") - 1
    inside = (i >= 0) & (i < len(record.slopes)) & (gate.order < 2)
    i[~inside] = 0
    slope = np.where(inside, record.slopes[i], 0.0)
    if gate.order:
        return slope / float(gate.a), np.zeros(len(starts))
    late = (starts - record.places[i]) - record.lates[i]
    return np.where(inside, record.values[i] + slope * late, 0.0), slope


def _blows(gate: TabulatedFunction, record: RecordArrays, starts: np.ndarray,
           shares: Mapping[int, float]) -> Iterator[SharedBlow]:
    """The impulses of a rate of a record at the starts nearest to them."""
    if not gate.order:
        return
    if gate.order == 2:
        sizes = np.diff(record.slopes, prepend=0.0, append=0.0) / float(gate.a**2)
    else:
        sizes = np.zeros(len(record.places))
        sizes[[0, -1]] = record.values[[0, -1]] * (1, -1) / float(gate.a)
    after = np.clip(np.searchsorted(starts, record.places), 1, len(starts) - 1) if len(starts) > 1 else 0
    before = np.maximum(after - 1, 0)
    at = np.where(np.abs(starts[before] - record.places) <= np.abs(starts[after] - record.places), before, after)
    meant = (record.places >= 0) & (np.abs(starts[at] - record.places) <= 2 * SAME * record.places)
    yield SharedBlow(np.bincount(at[meant], sizes[meant], len(starts)), shares)


def _own(group: "WaveGroup", arrays: "Mapping[Gate, RecordArrays]", starts: np.ndarray,
         middles: np.ndarray) -> Iterator[SharedWave]:
    """The waves of a group that shares none: its polynomials, counted from the starts, times its record or its wave."""
    which, share = np.searchsorted(group.places, middles, side="right") - 1, {group.channel: 1.0}
    rows = [np.array([_halves(p[k] if k < len(p) else 0) for p in (*group.ps, ())])[which].T for k in range(2)]
    gate = group.gates[0] if group.gates else None
    if isinstance(gate, TabulatedFunction):
        for wave in _lines(gate, arrays[gate], (starts, middles), share):
            yield wave._replace(series=wave.series * rows[0][0])
        return
    (level, little), (slope, more) = rows
    product, lost = whole_product(slope, starts)
    total, rest = whole_sum(level, product)
    factor = _turned(group.wave, starts) if any(group.wave) else 1.0
    yield SharedWave(0, group.exponent, (total + (rest + lost + little + more * starts)) * factor, share)
    yield SharedWave(1, group.exponent, slope * factor, share)


def _turned(wave: "ExactWave", starts: np.ndarray) -> np.ndarray:
    """e^{r t + r₀} i^q e^{i(w t + w₀)} at the starts; of what does not turn, the real part."""
    r, w, r0, w0, q = wave
    (growth, more), (angle, little) = (_along(*line, starts) for line in ((r, r0), (w, w0)))
    with np.errstate(over="ignore", invalid="ignore"):
        found = np.exp(growth + more) * np.exp(1j * angle) * (1 + 1j * little) * (1j if q else 1)
    result: np.ndarray = found if w else found.real
    return result


def _along(slope: "Exact", level: "Exact", t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """slope·t + level as a sum of two."""
    (steep, little), (high, low) = _halves(slope), _halves(level)
    product, lost = whole_product(steep, t)
    total, rest = whole_sum(product, high)
    return total, rest + lost + low + little * t
