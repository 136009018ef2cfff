"""First-order bounds of the errors of what is read off the graph of H(iΩ), from that of H at each frequency.

Where log|H| turns, as −(Ω − Ω₀)²/(2γ²), its slope is off by as much
as H is over γ, and Ω₀ by that times γ².
"""

import math
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.frequency_response.evaluate import sampled, sloped
from vibcli.analyses.frequency_response.extremes import steepness
from vibcli.analyses.frequency_response.value_errors import GIVEN

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction

NEAR, FALL, MOST = 1e-3, 0.05, 300.0    # first distance, relative, and fall of log|H| by which a top is measured
TRIES = 30
FINEST = 2.0**-46       # of Ω: places nearer to one another are told apart no more


class ResponseErrors:
    """Of what is read off the graph of one FrequencyResponseFunction."""

    def __init__(self, system: "FrequencyResponseFunction"):
        self.system = system

    def relative(self, Omega: float) -> float:
        """|δH|/|H| at a frequency."""
        size = abs(complex(sampled(self.system, Omega)[0]))
        return self.system.error(Omega) / size if size else math.inf

    def of_top(self, Omega: float) -> tuple[float, float]:
        """(|δΩ|, relative |δH|) of a maximum or minimum of |H|."""
        off = self.relative(Omega)
        if off >= 1:        # H may be zero there
            return self.of_zero(Omega), off if math.isfinite(off) else 1.0
        blind = self._blind(Omega)
        width = self._width(Omega, 2 * blind)
        return 2 * off * width + blind + GIVEN * Omega, off + (blind / width)**2

    def of_zero(self, Omega: float) -> float:
        """|δΩ| of a zero of H."""
        steep = abs(complex(sloped(self.system, np.array([Omega]))[1][0]))
        return self.system.error(Omega) / steep + GIVEN * Omega if steep else Omega

    def of_level(self, Omega: float, off: float) -> float:
        """|δΩ| of a place where |H| has a height that is off by so much, relative."""
        steep = self.steepness(Omega)
        return (self.relative(Omega) + off) / steep + GIVEN * Omega if steep else Omega

    def steepness(self, Omega: float) -> float:
        """|d log|H|/dΩ|."""
        return abs(float(steepness(self.system, np.array([Omega]))[0]))

    def of_crossing(self, other: "ResponseErrors", Omega: float) -> float:
        """|δΩ| of a place where |H| is that of another ResponseErrors' system."""
        here, there = (float(steepness(one.system, np.array([Omega]))[0]) for one in (self, other))
        apart = abs(here - there)
        return (self.relative(Omega) + other.relative(Omega)) / apart + GIVEN * Omega if apart else Omega

    def _blind(self, Omega):
        """How far about a top D is singular but for rounding, so that no slope is seen."""
        step = 2 * GIVEN * Omega
        for k in range(TRIES):
            if (steepness(self.system, np.array([Omega - step, Omega + step])) != 0).all():
                return step if k else 0.0
            step *= 4
        return step

    def _width(self, Omega, least):
        """γ of |H| = top/√(1 + (Ω − Ω₀)²/γ²), by how it falls beside the top, no nearer than `least`."""
        least = max(least, FINEST * Omega)
        step, height = max(NEAR * Omega, least), abs(complex(sampled(self.system, Omega)[0]))
        for _ in range(TRIES):
            beside = np.abs(sampled(self.system, np.array([Omega - step, Omega + step]))[0])
            fall = abs(math.log(height) - float(np.mean(np.log(np.maximum(beside, 1e-300)))))
            if fall <= FALL or step < 4 * least:
                break
            step /= 4
        return step / math.sqrt(math.expm1(2 * min(fall, MOST))) if fall else Omega
