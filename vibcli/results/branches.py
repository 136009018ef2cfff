"""Natural modes followed by their shapes as a parameter goes: where branches cross, and where they veer.

Between two neighbouring values X₁⁻¹X₂ = X₁ᵀ M₁ X₂ tells by its largest entries which shape has become which, the
columns of X being of unit modal mass. Where these entries are no clear choice the values between are looked at. Shapes
that change places within ever smaller steps belong to branches that cross; those that mix, so that each branch takes
the other's shape gradually, veer (Leissa 1974).
"""

from collections.abc import Callable, Sequence
from functools import cache
from math import inf
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

CLEAR = 0.8             # of an overlap that leaves no doubt
NARROW = 1e-13          # of the range: within which branches that change places cross
DEEPEST = 48
WIDER = 3.0             # of the least gap: how far apart on both sides of a veering
EXCHANGED = 0.7         # of the shapes there
GOLDEN, SECTIONS = 0.6180339887498949, 40       # where the gap is least
NEAR = 0.2              # relative gap beyond which nothing veers


class NaturalModesAt(NamedTuple):
    """The natural frequencies at a value, ascending, and the shapes, a column each."""

    value: float
    omega: np.ndarray
    shapes: np.ndarray


class Meeting(NamedTuple):
    """Two branches, counted from 1, that cross or veer at a value; gap: the least relative distance of a veering that
    was seen, zero of a crossing."""

    branches: tuple[int, int]
    value: float
    crosses: bool
    gap: float


class FollowedModes(NamedTuple):
    """branches[k]: the branch of each mode at the k-th value, None where there are no modes; meetings in their
    order."""

    branches: list[list[int] | None]
    meetings: list[Meeting]


def followed(spectra: "Sequence[NaturalModesAt | None]",
             between: "Callable[[float], NaturalModesAt | None]") -> FollowedModes:
    """The branches at ascending values; `between(value)` gives a NaturalModesAt within the range."""
    labels: list[Any] = []
    crossings, last, label = [], None, np.arange(0)
    known = [one for one in spectra if one is not None]
    narrow = NARROW * (known[-1].value - known[0].value) if known else 0.0
    for one in spectra:
        if one is None:
            labels.append(None)
            continue
        if last is None or len(one.omega) != len(last.omega):
            label = np.arange(1, len(one.omega) + 1)
        else:
            places, met = _places(last, one, between, narrow, 0)
            crossings += [Meeting(_pair(label, a, b), value, True, 0.0) for a, b, value in met]
            label = label[places]
        labels.append(label)
        last = one
    meetings = crossings + _veerings(spectra, labels, crossings, between)
    return FollowedModes(labels, sorted(meetings, key=lambda one: one.value))


def _pair(label: np.ndarray, a: int, b: int) -> tuple[int, int]:
    """The branches of two modes, ascending."""
    first, second = sorted((int(label[a]), int(label[b])))
    return first, second


def _places(one: NaturalModesAt, two: NaturalModesAt, between: Callable[..., Any], narrow: float,
            depth: int) -> tuple[np.ndarray, list[tuple[int, int, float]]]:
    """(which mode of the first each mode of the second was, [(mode, mode, value)] that cross in between)."""
    overlap = _overlap(one, two)
    places = overlap.argmax(0)
    clear = sorted(places) == list(range(len(places))) and (overlap.max(0) >= CLEAR).all()
    if clear and (places == np.arange(len(places))).all():
        return places, []
    middle = between(0.5 * (one.value + two.value)) if depth < DEEPEST and two.value - one.value > narrow else None
    if middle is None or len(middle.omega) != len(one.omega):
        if sorted(places) != list(range(len(places))):
            return np.arange(len(places)), []
        return places, [(int(places[k]), k, 0.5 * (one.value + two.value)) for k in range(len(places)) if places[k] < k]
    first, met = _places(one, middle, between, narrow, depth + 1)
    second, more = _places(middle, two, between, narrow, depth + 1)
    return first[second], met + [(int(first[a]), int(first[b]), value) for a, b, value in more]


def _overlap(one: NaturalModesAt, two: NaturalModesAt) -> np.ndarray:
    return np.abs(np.linalg.solve(one.shapes, two.shapes))


def _veerings(spectra: Sequence[NaturalModesAt | None], labels: Sequence[np.ndarray | None],
              crossings: Sequence[Meeting], between: Callable[..., Any]) -> list[Meeting]:
    """Where neighbours are nearest, and each has the other's shape beyond."""
    found = []
    known = [(one, label) for one, label in zip(spectra, labels, strict=True) if one is not None]
    overlap = cache(lambda left, right: _overlap(known[left][0], known[right][0]))
    count = min((len(one.omega) for one, _ in known), default=0)
    for i in range(count - 1):
        gaps = [_gap(one, i) for one, _ in known]
        for k in range(1, len(gaps) - 1):
            if gaps[k] <= min(gaps[k - 1], gaps[k + 1]) and gaps[k] < NEAR:
                ends = _ends(gaps, k)
                left, right = known[ends[0]], known[ends[1]]
                crossed = any(left[0].value <= one.value <= right[0].value for one in crossings)
                if crossed or (left[1] != right[1]).any():
                    continue
                exchanged = overlap(*ends)
                if min(exchanged[i, i + 1], exchanged[i + 1, i]) >= EXCHANGED:
                    value, gap = _nearest(i, known[k - 1][0].value, known[k + 1][0].value, between)
                    found.append(Meeting(_pair(known[k][1], i, i + 1), value, False, gap))
    return found


def _nearest(i: int, low: float, high: float, between: Callable[..., Any]) -> tuple[float, float]:
    """(value, relative gap) where two neighbours are nearest within a range, by its golden section."""
    found = {}

    def gap(value: float) -> float:
        one = between(value)
        found[value] = inf if one is None else _gap(one, i)
        return found[value]

    left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_left, at_right = gap(left), gap(right)
    for _ in range(SECTIONS):
        if at_left <= at_right:
            high, right, at_right = right, left, at_left
            left = high - GOLDEN * (high - low)
            at_left = gap(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + GOLDEN * (high - low)
            at_right = gap(right)
    best = min(found, key=found.__getitem__)
    return best, found[best]


def _gap(one: NaturalModesAt, i: int) -> float:
    """The relative distance of the frequencies of two neighbours."""
    return float(2 * (one.omega[i + 1] - one.omega[i]) / ((one.omega[i + 1] + one.omega[i]) or 1.0))


def _ends(gaps: Sequence[float], k: int) -> tuple[int, int]:
    """The places on both sides where a gap is several times that of the place k, or its range ends."""
    left = next((j for j in range(k, -1, -1) if gaps[j] >= WIDER * gaps[k]), 0)
    right = next((j for j in range(k, len(gaps)) if gaps[j] >= WIDER * gaps[k]), len(gaps) - 1)
    return left, right
