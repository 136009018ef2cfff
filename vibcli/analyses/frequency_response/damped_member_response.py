"""The frequency response of a scene with members whose modes `damping:` damps, from the exact one without damping.

Supports that are driven by u leave damping by modes alone where they move everything as at rest, H₀(0) u:

    H₀(s) = H₀(0) − s² G(s),      H(s) = H₀(0) − s² Σ ρ/(ω² + s² + c s)      with G = Σ ρ/(ω² + s²);

damping in proportion to inertia and stiffness resists all velocities: H(s) = H₀(√−z), q(z) = 0.
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.damped_sum import HIGHEST, SHARE, DampedSum, fractions
from vibcli.analyses.frequency_response.counted_zeros import CountedPoles, zeros_beside
from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
from vibcli.analyses.frequency_response.member_errors import of_value_at
from vibcli.analyses.frequency_response.member_poles_and_zeros import ABOVE
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.frequency_response.beside_rigid_motions import AtRest
    from vibcli.analyses.frequency_response.member_response import MemberTransfer
    from vibcli.analyses.modal.mode_sequence import Modes

NEAR, STILL = 1e-3, 1e-6    # radius of a difference over the distance of a pole; ratio of what hardly is damped
BEYOND = 2.0        # times a frequency: modes up to there may vibrate as slowly
UNIT = 2.0**-52


class DampedMemberTransfer(FrequencyResponseFunction):
    """still: the MemberTransfer without damping; driven: is its input the displacement of supports? turns: its input
    is (−s²)^turns times that of `still`."""

    __slots__ = ("_modes", "_static", "_sum", "_zeros", "damping", "driven", "still", "turns")

    def __init__(self, still: "MemberTransfer", modes: "Modes", damping: "MemberDamping", driven: bool,
                 turns: int) -> None:
        super().__init__(still.order)
        self.still, self.damping, self.driven, self.turns = still, damping, driven, turns
        self._modes = modes
        self._static: complex = 0.0
        self._sum: DampedSum | None = None
        self._zeros: dict[tuple[float, float], np.ndarray] = {}

    @property
    def undamped(self) -> bool:
        return False

    @property
    def pace(self) -> float:
        return self.still.pace

    @property
    def end(self) -> float:
        return self.still.end

    def natural(self) -> list[float]:
        return self.still.natural()

    def at(self, s: np.ndarray, steep: bool = False) -> "tuple[np.ndarray, np.ndarray | None, np.ndarray]":
        """The slope is that of a difference about s, nearer than any pole."""
        s = np.asarray(s, complex)
        values, resonant, slopes = self._values(s), self._resonant(s), None
        if steep:
            size = np.maximum(np.abs(s), NEAR * self.pace)
            radius = NEAR * np.maximum(self._damped_at(size) / 2, STILL * size)
            turn = np.array([[1], [1j], [-1], [-1j]])
            around = self._values((s + radius * turn).ravel()).reshape(4, -1) / turn
            slopes = around.sum(axis=0) / (4 * radius)
        return values, slopes, resonant

    def _damped_at(self, omega: np.ndarray) -> np.ndarray:
        """c at frequencies."""
        if self.damping.ratios:
            return 2 * min(map(float, self.damping.ratios)) * omega
        return sum((float(a) * omega**(2 * k) for k, a in enumerate(self.damping.series)), np.zeros(omega.shape))

    def _resonant(self, s: np.ndarray) -> np.ndarray:
        """At rest, where what moves freely has no response."""
        found = s == 0
        result: np.ndarray = found & self.still.at(np.zeros(1, complex))[2][0] if found.any() else found
        return result

    def _values(self, s: np.ndarray) -> np.ndarray:
        if not len(s):
            return s
        turned = (-s * s)**self.turns
        if self.driven and self.damping.whole:
            series = [float(a) for a in self.damping.series]
            result: np.ndarray = turned * self.still.at(np.sqrt(-fractions(series, s)[0][0]))[0]
            return result
        if self._sum is None:
            self._static = self._at_rest() if self.driven else 0.0
            self._sum = DampedSum(self.damping, self._modes, self._by_supports if self.driven else self._by_loads)
        found = self._sum.at(s)
        value: np.ndarray = turned * (self._static - s * s * found if self.driven else found)
        return value

    @property
    def drifting(self) -> "AtRest | None":
        """What its output has at s = 0 where a steady input drives what nothing holds, which ratios of modes
        leave as it is; None where that is not found."""
        return self.still.drifting if self.damping.ratios and not self.driven else None

    def _at_rest(self) -> complex:
        values, _, resonant = self.still.at(np.zeros(1, complex))
        if resonant[0]:
            raise PhysicsError("responses of what moves freely beside driven supports are not found with damping by "
                               "modes", "write `proportional: [alpha, beta]`, or hold it")
        return complex(values[0])

    def _by_loads(self, sigma: np.ndarray) -> np.ndarray:
        return self.still.at(sigma)[0]

    def _by_supports(self, sigma: np.ndarray) -> np.ndarray:
        found: np.ndarray = (self._static - self.still.at(sigma)[0]) / sigma**2
        return found

    def poles(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        high = high if math.isfinite(high) else self.end
        modes = [mode for mode in self._modes.up_to(BEYOND * high) if mode.omega] if math.isfinite(high) else []
        half = np.array([float(self.damping.rate(mode)) / 2 for mode in modes])
        omega = np.array([float(mode.omega) for mode in modes])
        root = np.sqrt((omega**2 - half**2 + 0j)[half < omega]).real
        found = -half[half < omega] + 1j * root
        found = found[(root >= low) & (root <= high)]
        result: np.ndarray = found[np.argsort(found.imag)]
        return result

    def zeros(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        high = high if math.isfinite(high) else self.end
        if (low, high) not in self._zeros:
            self._zeros[low, high] = zeros_beside(self, self._told_up_to(high), self.still, low, high)
        return self._zeros[low, high]

    def _told_up_to(self, high: float) -> CountedPoles | None:
        """The CountedPoles, which all modes are."""
        poles = self.poles(0.0, ABOVE * high)
        return CountedPoles(poles, high / (1 + int((poles.imag <= high).sum())))

    def endless(self, low: float = 0.0, high: float = math.inf) -> list[np.ndarray]:
        return self.still.endless(low, high)

    def error(self, Omega: float) -> float:
        """What rounding makes of each part of the sum, and of the integral the trapezoidal rule."""
        s = np.array([1j * Omega])
        size = float(np.abs(self._values(s)[0]))
        if not self.damping.ratios:
            series = [float(a) for a in self.damping.series]
            parts = fractions(series, self._sum.beside_rest(s) if len(series) > 2 else s)
            weights = [1.0 if self.driven and self.damping.whole else 1 / abs(slope[0]) for _, slope in parts]
            places = [np.sqrt(-z[0]) for z, _ in parts]
        else:
            places, weights = self._places(Omega)
            size *= self._sum.rounding
        found = sum(weight * of_value_at(self.still, place) for place, weight in zip(places, weights, strict=True))
        return (found + 8 * UNIT * size) * abs(Omega)**(self.order + 2 * self.turns)

    def _places(self, Omega: float) -> tuple[list[complex], list[float]]:
        """Where the sum without damping is taken, and what by."""
        if self._sum.zeta > HIGHEST:
            return [Omega * self._sum.zeta**k for k in (-1, 0, 1)], [1 / SHARE] * 3
        sine = math.sqrt(1 - self._sum.zeta**2)
        return [Omega * complex(self._sum.zeta, sine), complex(Omega)], [2 / sine, 2 * self._sum.zeta]

    def noise(self, Omega: np.ndarray) -> np.ndarray:
        return self.errors(Omega)

    def error_of_pole(self, Omega: float) -> float:
        return self.still.error_of_pole(Omega)

    @property
    def without_damping(self) -> "MemberTransfer":
        """The same without damping."""
        return self.still

    def with_damper(self, other: Any, c: float) -> "FrequencyResponseFunction":
        raise PhysicsError("what a damper changes of responses beside ratios of modes of members is not found",
                           "take `damping:` out, or ask for the response itself")

    def felt(self, other: Any) -> float:
        return self.with_damper(other, 1.0).pace
