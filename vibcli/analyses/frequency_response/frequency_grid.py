"""Frequencies at which H(iΩ) is drawn: every peak and antiresonance among them, the others where the curve bends.

Between neighbours the curve of log |H| and arg H is straight to TOLERANCE, seen over log Ω or Ω.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.evaluate import sampled
from vibcli.analyses.frequency_response.extremes import Extreme, extremes, places
from vibcli.numerics.ascending import ascending

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction

TOLERANCE, ROUNDS, MOST, EVEN = 0.004, 12, 4000, 61
CLOSEST, NARROW = 1e-5, 1e-13       # nearest place to where H is zero or unbounded, and to each other, relative to Ω
ASIDE = 0.4                         # the part of a gap at which it is divided where its middle is a pole
LEAST = 1e-14                       # of the largest value, where a curve ends


def adaptive(system: "FrequencyResponseFunction", low: float, high: float, log: Any = True,
             known: Sequence[Extreme] | None = None) -> tuple[np.ndarray, np.ndarray]:
    """(Ω ascending, H) between two frequencies; poles and zeros are left out, as are places next to them."""
    known = extremes(system) if known is None else known
    endless = np.array([one.Omega for one in known if not one.value])
    even = np.geomspace(low, high, EVEN) if log else np.linspace(low, high, EVEN)
    near = [*places(system, 0.0, max(high, system.end)), *(one.Omega for one in known)]
    Omega = ascending([*even, *(x for x in near if low < x < high)])
    Omega = _clear(Omega[np.append(True, np.diff(Omega) > NARROW * Omega[1:])], endless)
    values = sampled(system, Omega)[0]
    for _ in range(ROUNDS):
        gaps: Any = np.flatnonzero(_bent(Omega, values, log)) if len(Omega) <= MOST else []
        if not len(gaps):
            break
        middle = _clear(_between(Omega[gaps], Omega[gaps + 1], log, endless), endless)
        order = np.argsort(np.concatenate([Omega, middle]), kind="stable")
        Omega, values = (np.concatenate(pair)[order] for pair in ((Omega, middle),
                                                                   (values, sampled(system, middle)[0])))
    return Omega, values


def _between(low: np.ndarray, high: np.ndarray, log: bool, endless: np.ndarray) -> np.ndarray:
    """The middles of gaps; beside the middle where that is a pole or a zero."""
    middle = np.sqrt(low * high) if log else (low + high) / 2
    aside = low ** (1 - ASIDE) * high ** ASIDE if log else low + ASIDE * (high - low)
    return np.where(_is_clear(middle, endless), middle, aside)


def _clear(Omega: np.ndarray, endless: np.ndarray) -> np.ndarray:
    """Without what is as good as at a pole or a zero."""
    found: np.ndarray = Omega[_is_clear(Omega, endless)]
    return found


def _is_clear(Omega: np.ndarray, endless: np.ndarray) -> np.ndarray:
    if not len(endless):
        return np.ones(len(Omega), bool)
    found: np.ndarray = np.abs(Omega[:, None] - endless).min(axis=1) > CLOSEST * Omega
    return found


def _bent(Omega: np.ndarray, values: np.ndarray, log: bool) -> np.ndarray:
    """Whether the curve of log |H| or arg H bends at either end of each gap that can still be halved."""
    x, size = np.log(Omega) if log else Omega, np.abs(values)
    gaps = np.zeros(len(x) - 1, bool)
    width = np.diff(x)
    for curve in (np.log(np.maximum(size, size.max() * LEAST or 1.0)), np.unwrap(np.angle(values))):
        bend = np.abs(np.diff(np.diff(curve) / width)) * np.minimum(width[1:], width[:-1]) / 4
        gaps[1:] |= bend > TOLERANCE
        gaps[:-1] |= bend > TOLERANCE
    return gaps & (np.diff(Omega) > NARROW * Omega[1:])
