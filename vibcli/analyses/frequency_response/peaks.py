"""What is read off the graph of |H(iΩ)|: resonance peaks, antiresonances, half-power points.

A peak is a maximum that a pole makes, an antiresonance a minimum that a zero makes (a zero itself without damping). The
half-power points of a peak are where |H| = peak/√2 on either side of it; Q = Ω_peak/(Ω₂ − Ω₁).
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.evaluate import frf, sampled
from vibcli.analyses.frequency_response.extremes import WIDE, Extreme, extremes
from vibcli.base.errors import PhysicsError
from vibcli.numerics.bracketing import zeros_between

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction


def peaks(system: "FrequencyResponseFunction", known: Sequence[Extreme] | None = None,
          end: float = math.inf) -> list[Extreme]:
    """The Extremes up to a frequency that are peaks, ascending; their value is None where damping does not bound
    them."""
    known = extremes(system, 0.0, end) if known is None else known
    tops = [one for one in known if one.maximum and not (system.undamped and one.value is not None)]
    return _made_by(system.poles(0.0, end), tops, [one.Omega for one in known if not one.maximum]) if tops else []


def antiresonances(system: "FrequencyResponseFunction", known: Sequence[Extreme] | None = None,
                   end: float = math.inf) -> list[Extreme]:
    """The Extremes up to a frequency that are antiresonances, ascending."""
    known = extremes(system, 0.0, end) if known is None else known
    dips = [one for one in known if not one.maximum and not (system.undamped and one.value)]
    return _made_by(system.zeros(0.0, end), dips, [one.Omega for one in known if one.maximum]) if dips else []


def _made_by(marks: np.ndarray, found: Sequence[Extreme], between: Sequence[Any]) -> list[Extreme]:
    """Those in whose interval between others there is a pole or zero that is not real."""
    marks = marks.imag[marks.imag > 0]
    edges = np.array([0.0, *between, np.inf])
    kept = []
    for one in found:
        k = np.searchsorted(edges, one.Omega)
        if ((marks > edges[k - 1]) & (marks < edges[k])).any():
            kept.append(one)
    return kept


def half_power(system: "FrequencyResponseFunction", peak: Extreme,
               known: Sequence[Extreme] | None = None) -> tuple[float, float]:
    """(Ω₁, Ω₂) at which |H| is peak/√2, on either side of a peak."""
    if peak.value is None:
        raise PhysicsError("an undamped peak has no bound, and so no half-power points", "add damping")
    known = extremes(system) if known is None else known
    return held(peak, *half_powers(system, [peak], known)[0].tolist())


def held(peak: Extreme, low: float, high: float) -> tuple[float, float]:
    """The half-power points about a peak; PhysicsError where one of them is missing, NaN."""
    if math.isnan(low) or math.isnan(high):
        side = "below" if math.isnan(low) else "above"
        raise PhysicsError(f"the response does not fall to peak/√2 {side} the peak at {peak.Omega:.6g} rad/s",
                           "its bandwidth is not defined")
    return low, high


def half_powers(system: "FrequencyResponseFunction", tops: Sequence[Extreme], known: Sequence[Extreme]) -> np.ndarray:
    """(Ω₁, Ω₂) about each of several peaks, (N, 2), found together; NaN where |H| does not fall to peak/√2."""
    level = np.repeat([peak.value for peak in tops], 2) / np.sqrt(2)
    inner = np.repeat([peak.Omega for peak in tops], 2)
    dips = np.array([one.Omega for one in known if not one.maximum])
    ends = np.array([end for peak in tops for end in _ends(system, peak, dips)])
    at_ends, resonant = sampled(system, ends)
    falls = ~((np.abs(at_ends) >= level) | resonant)
    found, within = np.full(len(ends), math.nan), np.flatnonzero(falls)
    low, high = (choose(ends, inner)[within] for choose in (np.minimum, np.maximum))
    found[within] = zeros_between(lambda Omega: np.abs(frf(system, Omega)), low, high, level[within])
    return found.reshape(-1, 2)


def _ends(system: "FrequencyResponseFunction", peak: Extreme, dips: np.ndarray) -> tuple[float, float]:
    """The minima on either side of a peak, or what is beyond the last one."""
    below, above = dips[dips < peak.Omega], dips[dips > peak.Omega]
    return below.max(initial=0.0), above.min() if len(above) else _beyond(system, peak.Omega, peak.value / np.sqrt(2))


def _beyond(system: "FrequencyResponseFunction", Omega: float, level: float) -> float:
    """A frequency above Ω at which |H| has fallen below the level; the last one looked at where there is none."""
    last = max(system.pace, Omega) * WIDE
    while Omega < last:
        Omega *= 2
        if abs(sampled(system, Omega)[0]) < level:
            break
    return Omega
