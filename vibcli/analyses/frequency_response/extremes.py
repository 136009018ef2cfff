"""Maxima and minima of |H(iΩ)| over Ω > 0: zeros of d log|H|/dΩ = Re(i H′/H), bracketed near poles and zeros of H.

Each is narrowed down to rounding. A maximum where H has no bound is that of an undamped mode; a minimum where H is
zero, an antiresonance without damping.
"""

import math
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.frequency_response.evaluate import sampled, sloped
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.ascending import ascending
from vibcli.numerics.bracketing import zeros_between

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction

SPREAD = np.array([0.0, 0.03, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 20.0])     # places about a pole, in widths
COARSE, FEW = np.array([0.0, 0.25, 1.0, 5.0]), 40                       # where there are more poles and zeros
ASIDE = 1 + 1e-6    # times a pole: where what is tied to it however weakly is seen
NARROWEST, WIDE = 1e-9, 1e4
ANYWHERE = np.array([0.37, 1.19, 3.1])  # times a typical frequency
BESIDE, ENDLESS = 1e-9, 3e3     # a peak that is so much higher than beside it has a damping ratio below 3e-13: none


class Extreme(NamedTuple):
    """Omega in rad/s; value |H|, None where it has no bound; maximum or minimum."""

    Omega: float
    value: float
    maximum: bool


def extremes(system: "FrequencyResponseFunction", start: float = 0.0, end: float = math.inf) -> list[Extreme]:
    """The Extremes of |H(iΩ)| for Ω > 0 from start to end, ascending; none where the input does not reach the
    output."""
    if not reaches(system, start, end):
        return []
    (low, high), steep = _brackets(system, start, end)
    maximum = steep[0] > 0
    Omega = zeros_between(lambda at: steepness(system, at), low, high, known=steep)
    if system.undamped:
        values, resonant = sampled(system, Omega)
        turning = ~_through(system, low, high) & ~resonant
        found = [*map(_extreme, Omega[turning], np.abs(values[turning]), maximum[turning])]
        for marks, value in zip(system.endless(start, end), (None, 0.0), strict=True):
            found += [_extreme(at, value, value is None) for at in marks]
        return sorted(found, key=lambda one: one.Omega)
    tops, count = Omega[maximum], len(Omega)
    values, resonant = sampled(system, np.concatenate([Omega, tops * (1 + BESIDE), tops * (1 - BESIDE)]))
    beside = np.abs(values[count:]).reshape(2, -1).max(axis=0)
    values, resonant = values[:count], resonant[:count]
    resonant[maximum] |= np.abs(values[maximum]) > ENDLESS * beside
    Omega[resonant] = _nearest(system.poles(start, end).imag, Omega[resonant])
    return [_extreme(at, None if lost else size, top)
            for at, size, lost, top in zip(Omega, np.abs(values), resonant, maximum, strict=True)]


def reaches(system: "FrequencyResponseFunction", start: float = 0.0, end: float = math.inf) -> bool:
    """Does the input reach the output? Far above all poles H may be smaller than any float."""
    if _seen(system, system.pace * ANYWHERE):
        return True
    near = ascending(np.abs(system.poles(start, end)))
    return len(near) > 0 and (_seen(system, near[0] * ANYWHERE) or _seen(system, near[:FEW] * ASIDE))


def _seen(system: "FrequencyResponseFunction", Omega: np.ndarray) -> bool:
    """Is H more than rounding at one of these frequencies?"""
    values, resonant = sampled(system, Omega)
    values, Omega = values[~resonant], Omega[~resonant]
    return bool(values.any() and (abs(values) > system.noise(Omega)).any())


def _extreme(Omega: float, size: float | None, maximum: bool) -> Extreme:
    return Extreme(float(Omega), None if size is None else float(size), bool(maximum))


def _through(system: "FrequencyResponseFunction", low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Whether H passes a pole or a zero between the ends of each interval, without damping."""
    ends = [(sloped(system, edge)[0] / 1j**system.order).real for edge in (low, high)]
    return ends[0] * ends[1] < 0


def _nearest(places: np.ndarray, Omega: np.ndarray) -> np.ndarray:
    """The place next to each Ω: H is unbounded there but for rounding, so that a slope does not tell more."""
    return places[np.abs(Omega[:, None] - places).argmin(axis=1)] if len(Omega) else Omega


def steepness(system: "FrequencyResponseFunction", Omega: np.ndarray) -> np.ndarray:
    """d log|H|/dΩ; NaN where H is zero or unbounded."""
    values, slopes, _ = sloped(system, Omega)
    with np.errstate(all="ignore"):
        return np.where(values == 0, np.nan, (1j * slopes / np.where(values == 0, 1.0, values)).real)


def places(system: "FrequencyResponseFunction", start: float = 0.0, end: float = math.inf) -> np.ndarray:
    """Frequencies from start to end near poles and zeros, and between them, ascending and different."""
    marks = np.concatenate([system.poles(start, end), system.zeros(start, end)])
    marks = marks[(marks.imag > 0) & np.isfinite(marks)]
    middle, width = marks.imag, np.maximum(np.abs(marks.real), NARROWEST * marks.imag)
    spread = SPREAD if len(marks) <= FEW else COARSE
    near = (middle[:, None] + width[:, None] * np.concatenate([spread, -spread])).ravel()
    near = np.concatenate([near, np.abs(marks)])
    between = np.sort(middle)
    near = np.concatenate([near, (between[1:] + between[:-1]) / 2, between * 0.9, between * 1.1])
    typical = system.pace
    low = max(start, min([typical, *middle]) / WIDE)
    high = min(end, max([typical, *middle]) * WIDE)
    near = np.concatenate([near, np.geomspace(low, high, 161)])
    return ascending(near[(near >= low) & (near <= high)])


def _brackets(system: "FrequencyResponseFunction", start: float,
              end: float) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """The ends (low, high) of the intervals in which the slope changes its sign, and the slopes there."""
    Omega = places(system, start, end)
    steep = steepness(system, Omega)
    known = np.flatnonzero(np.isfinite(steep) & (steep != 0))
    turns = np.sign(steep[known[:-1]]) != np.sign(steep[known[1:]])
    ends = known[:-1][turns], known[1:][turns]
    return [Omega[end] for end in ends], [steep[end] for end in ends]
