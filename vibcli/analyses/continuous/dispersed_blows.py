"""What bars, shafts and strings that drag and a foundation disperse answer to a blow, or start with a velocity as: with
h(τ), what they do without both, z² = σ²(t² − τ²), and B(z²) = I₁(z)/z as in dispersed_waves.py,

    y(t) = e^{−δt} (h(t) + ∫ σ²τ B h dτ),    y′(t) = −δ y(t) + e^{−δt} (h′(t) + ½σ²t h(t) + ∫ σ⁴t τ I₂(z)/z² h dτ).
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.travelling_waves_station import EPSILON
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.travelling_waves import WaveMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput

ROUNDED = 64.0      # how often a term is rounded
SMALL = 1e-200      # z² of a front


class Told(NamedTuple):
    """h at so many instants: what it is there, times weights of a rule or what it leaps in itself by; |h|, and how far
    it may be off."""

    at: np.ndarray
    given: np.ndarray
    sizes: np.ndarray
    off: np.ndarray


class Dispersal(NamedTuple):
    """δ and σ²."""

    delta: float
    square: float

    def after_blow(self, motion: "WaveMotion", base: int, output: "LinearOutput", told: "list[Told]", t: float,
                   before: bool, order: int) -> np.ndarray:
        """(value, bound of its error) of an output, or of its rate, at t; the base-th rate of a WaveMotion is h, which
        is told up to t."""
        at = np.array([t])
        here, faster = (float(motion.values(output, at, base + k, before)[0]) for k in (0, order))
        lost, lost_faster = (float(motion.errors(output, at, base + k)[0]) for k in (0, order))
        faded, within = np.exp(-self.delta * t), self._tail(told, t, self._of_value)
        found: np.ndarray = within + faded * np.array([here, lost + ROUNDED * EPSILON * abs(here)])
        if not order:
            return found
        turned = self.square * t / 2
        rate = self._tail(told, t, self._of_rate) + faded * np.array([faster + turned * here, lost_faster + abs(
            turned) * lost + ROUNDED * EPSILON * (abs(faster) + abs(turned * here))])
        return cast("np.ndarray", rate + np.array([-self.delta, abs(self.delta)]) * found)

    def _tail(self, told: Sequence[Told], t: float, kernel: Callable[[float, np.ndarray], np.ndarray]) -> np.ndarray:
        """(∫ kernel h dτ, how far it may be off)."""
        total = np.zeros(2)
        for part in told:
            K = kernel(t, part.at)
            rounded = EPSILON * (ROUNDED + 4 * t * (self.delta + abs(self.square) * t))
            total += part.given @ K, (part.off + rounded * part.sizes) @ np.abs(K)
        return total

    def _of_value(self, t: float, tau: np.ndarray) -> np.ndarray:
        """e^{−δt} σ²τ B."""
        return cast("np.ndarray", self.square * tau * _bessel(self, 1, t, tau))

    def _of_rate(self, t: float, tau: np.ndarray) -> np.ndarray:
        """e^{−δt} σ⁴t τ I₂(z)/z²."""
        return cast("np.ndarray", self.square**2 * t * tau * _bessel(self, 2, t, tau))


def _bessel(rates: Dispersal, order: int, t: float, tau: np.ndarray) -> np.ndarray:
    """e^{−δt} Iₙ(z)/zⁿ, of σ² < 0 Jₙ(|z|)/|z|ⁿ."""
    from scipy.special import ive, jv

    z = np.sqrt(np.maximum(abs(rates.square) * (t - tau) * (t + tau), SMALL))
    if rates.square > 0:
        return cast("np.ndarray", np.exp(z - rates.delta * t) * ive(order, z) / z**order)
    return cast("np.ndarray", np.exp(-rates.delta * t) * jv(order, z) / z**order)
