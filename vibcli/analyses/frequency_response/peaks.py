"""What is read off the graph of |H(iΩ)|: resonance peaks, antiresonances, half-power points.

A peak is a maximum that a pole makes, an antiresonance a minimum that a zero makes (a zero itself without damping). The
half-power points of a peak are where |H| = peak/√2 on either side of it; Q = Ω_peak/(Ω₂ − Ω₁).
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

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
    return _made_by(system.poles(0.0, end), tops, [one.Omega for one in known if not one.maximum])


def antiresonances(system: "FrequencyResponseFunction", known: Sequence[Extreme] | None = None,
                   end: float = math.inf) -> list[Extreme]:
    """The Extremes up to a frequency that are antiresonances, ascending."""
    known = extremes(system, 0.0, end) if known is None else known
    dips = [one for one in known if not one.maximum and not (system.undamped and one.value)]
    return _made_by(system.zeros(0.0, end), dips, [one.Omega for one in known if one.maximum])


def _made_by(marks, found, between):
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
    level = peak.value / np.sqrt(2)
    left = max((one.Omega for one in known if not one.maximum and one.Omega < peak.Omega), default=0.0)
    right = min((one.Omega for one in known if not one.maximum and one.Omega > peak.Omega), default=None)
    right = _beyond(system, peak.Omega, level) if right is None else right
    ends = np.array([left, right])
    inner = np.array([peak.Omega, peak.Omega])
    at_ends, resonant = sampled(system, ends)
    if (np.abs(at_ends) >= level).any() or resonant.any():
        side = "below" if np.abs(at_ends[0]) >= level or resonant[0] else "above"
        raise PhysicsError(f"the response does not fall to peak/√2 {side} the peak at {peak.Omega:.6g} rad/s",
                           "its bandwidth is not defined")
    low, high = np.minimum(ends, inner), np.maximum(ends, inner)
    found = zeros_between(lambda Omega: np.abs(frf(system, Omega)) - level, low, high)
    return float(found[0]), float(found[1])


def _beyond(system, Omega, level):
    """A frequency above Ω at which |H| has fallen below the level; the last one looked at where there is none."""
    last = max(system.pace, Omega) * WIDE
    while Omega < last:
        Omega *= 2
        if abs(sampled(system, Omega)[0]) < level:
            break
    return Omega
