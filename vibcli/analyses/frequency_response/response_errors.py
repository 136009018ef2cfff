"""First-order bounds of the errors of what is read off the graph of H(iΩ), from that of H at each frequency.

Where log|H| turns, as −(Ω − Ω₀)²/(2γ²), its slope is off by as much
as H is over γ, and Ω₀ by that times γ².
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.frequency_response.evaluate import sampled, sloped
from vibcli.analyses.frequency_response.extremes import steepness
from vibcli.analyses.frequency_response.value_errors import GIVEN

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction

NEAR, FALL, MOST = 1e-3, 0.05, 300.0    # first distance, relative, and fall of log|H| by which a top is measured
TRIES, ASIDE = 30, 1e-5
FINEST = 2.0**-46       # of Ω: places nearer to one another are told apart no more


class ResponseErrors:
    """Of what is read off the graph of one FrequencyResponseFunction."""

    def __init__(self, system: "FrequencyResponseFunction") -> None:
        self.system = system

    def relative(self, Omega: np.ndarray) -> np.ndarray:
        """|δH|/|H| at frequencies, infinite where H is zero."""
        size = np.abs(sampled(self.system, Omega)[0])
        with np.errstate(all="ignore"):
            return np.where(size > 0, self.system.errors(Omega) / size, math.inf)

    def of_tops(self, Omega: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(|δΩ|, relative |δH|) of maxima or minima of |H|."""
        if not len(Omega):
            return Omega, Omega
        off = self.relative(Omega)
        place, height = np.empty(len(Omega)), np.where(np.isfinite(off), off, 1.0)
        lost = off >= 1         # H may be zero there
        place[lost] = self.of_zeros(Omega[lost])
        if not lost.all():
            place[~lost], height[~lost] = self._of_turns(Omega[~lost], off[~lost])
        return place, height

    def _of_turns(self, Omega: np.ndarray, off: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        blind = self._blind(Omega)
        width = self._width(Omega, 2 * blind)
        return 2 * off * width + blind + GIVEN * Omega, off + (blind / width)**2

    def of_zeros(self, Omega: np.ndarray) -> np.ndarray:
        """|δΩ| of zeros of H."""
        if not len(Omega):
            return Omega
        steep = np.abs(sloped(self.system, Omega)[1])
        flat = steep == 0       # a mode that takes no part has the same frequency
        if flat.any():
            steep[flat] = np.abs(sloped(self.system, Omega[flat] * (1 + ASIDE))[1])
        found: np.ndarray = _over(self.system.errors(Omega), steep, Omega)
        return found

    def of_levels(self, Omega: np.ndarray, off: np.ndarray) -> np.ndarray:
        """|δΩ| of places where |H| has a height that is off by so much, relative."""
        found: np.ndarray = _over(self.relative(Omega) + off, self.steepness(Omega), Omega)
        return found

    def steepness(self, Omega: np.ndarray) -> np.ndarray:
        """|d log|H|/dΩ|."""
        found: np.ndarray = np.abs(steepness(self.system, Omega))
        return found

    def of_crossing(self, other: "ResponseErrors", Omega: np.ndarray) -> np.ndarray:
        """|δΩ| of places where |H| is that of another ResponseErrors' system."""
        here, there = (steepness(one.system, Omega) for one in (self, other))
        found: np.ndarray = _over(self.relative(Omega) + other.relative(Omega), np.abs(here - there), Omega)
        return found

    def _blind(self, Omega: np.ndarray) -> np.ndarray:
        """How far about each top D is singular but for rounding, so that no slope is seen."""
        step, found, dark = 2 * GIVEN * Omega, np.zeros(len(Omega)), np.arange(len(Omega))
        for k in range(TRIES):
            seen = (self._beside(steepness, Omega[dark], step[dark]) != 0).all(axis=0)
            found[dark[seen]] = step[dark[seen]] if k else 0.0
            dark = dark[~seen]
            if not len(dark):
                break
            step[dark] *= 4
        found[dark] = step[dark]
        return found

    def _width(self, Omega: np.ndarray, least: np.ndarray) -> np.ndarray:
        """γ of |H| = top/√(1 + (Ω − Ω₀)²/γ²), by how it falls beside each top, no nearer than `least`."""
        least = np.maximum(least, FINEST * Omega)
        step, height = np.maximum(NEAR * Omega, least), np.abs(sampled(self.system, Omega)[0])
        fall, steep = np.zeros(len(Omega)), np.arange(len(Omega))
        for _ in range(TRIES):
            beside = self._beside(lambda system, at: np.abs(sampled(system, at)[0]), Omega[steep], step[steep])
            fall[steep] = np.abs(np.log(height[steep]) - np.log(np.maximum(beside, 1e-300)).mean(axis=0))
            steep = steep[(fall[steep] > FALL) & (step[steep] >= 4 * least[steep])]
            if not len(steep):
                break
            step[steep] /= 4
        with np.errstate(all="ignore"):
            return np.where(fall > 0, step / np.sqrt(np.expm1(2 * np.minimum(fall, MOST))), Omega)

    def _beside(self, find: Callable[..., np.ndarray], Omega: np.ndarray, step: np.ndarray) -> np.ndarray:
        """What is found a step below and above each frequency: (2, N)."""
        return find(self.system, np.concatenate([Omega - step, Omega + step])).reshape(2, -1)


def _over(off: np.ndarray, steep: np.ndarray, Omega: np.ndarray) -> np.ndarray:
    """|δΩ| of what is off by so much where it is so steep; all of Ω where it is level."""
    with np.errstate(all="ignore"):
        return np.where(steep != 0, off / steep + GIVEN * Omega, Omega)
