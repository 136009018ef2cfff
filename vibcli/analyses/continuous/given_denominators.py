"""ω² + c s + s² = ω² p(1/ω), p(r) = (1 + β s) + 2 ζ s r + (α s + s²) r², of modes that `damping:` damps beyond some."""

from functools import lru_cache
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.member_damping import MemberDamping

KEPT = 64           # values of κ at as many s together
SURE = 1 - 1e-9     # of a least value, as rounding leaves it


class GivenDenominators(NamedTuple):
    """2 ζ, α, β, and the ω that none of the modes is below."""

    double: float
    alpha: float
    beta: float
    omega: float

    def inverse(self, s: np.ndarray) -> np.ndarray:
        """κ, the largest 1/|p| of all modes; inf where one of them answers to s without bound."""
        return _largest(self, np.asarray(s, complex).tobytes())

    def _least(self, s: np.ndarray) -> np.ndarray:
        p = self._powers(s)
        square = np.real([sum(p[i] * p[k - i].conj() for i in range(max(k - 2, 0), min(k, 2) + 1)) for k in range(5)])
        least = np.full(len(s), np.inf)
        for k in range(len(s)):
            x = np.roots((square[:, k] * np.arange(5))[:0:-1])
            r = np.clip([0.0, 1.0, *x.real], 0.0, 1.0)
            least[k] = np.abs(p[0, k] + r * (p[1, k] + r * p[2, k])).min()
        return least

    def _powers(self, s: np.ndarray) -> np.ndarray:
        """Of ω r, (3, n)."""
        return np.array([1 + self.beta * s, self.double * s / self.omega, s * (self.alpha + s) / self.omega**2])

    def at(self, omega: np.ndarray, s: np.ndarray) -> np.ndarray:
        """ω² p at (n, modes)."""
        s = s[:, None]
        return cast("np.ndarray", omega**2 * (1 + self.beta * s) + self.double * s * omega + s * (self.alpha + s))

    def from_rest(self, s: np.ndarray, first: np.ndarray, second: np.ndarray) -> np.ndarray:
        """Bounds of Σ |a b| |1/p − 1/(1 + β s)|/ω² from √Σ a²/ω²ᵖ and the same of b, p = 1, 2."""
        one, two = self.double * np.abs(s), np.abs(s * (self.alpha + s))
        between = min(first[0] * second[1], first[1] * second[0])
        felt = one * between + two * first[1] * second[1]
        return cast("np.ndarray", self.inverse(s) / np.abs(1 + self.beta * s) * felt)

    def energies(self, s: np.ndarray, sizes: np.ndarray) -> np.ndarray:
        """Bounds of the energy norms of (a/ω² (1/p − 1), s a/(ω² p))."""
        low, high = sizes
        apart = self.beta * np.abs(s) * low + self.double * np.abs(s) * high
        apart = apart + np.abs(s * (self.alpha + s)) * high / self.omega
        return cast("np.ndarray", self.inverse(s) * (apart + np.abs(s) * high))


@lru_cache(KEPT)
def _largest(beyond: GivenDenominators, points: bytes) -> np.ndarray:
    with np.errstate(divide="ignore"):
        return 1 / (SURE * beyond._least(np.frombuffer(points, complex)))


def denominators(damping: "MemberDamping", count: int, omega: float) -> GivenDenominators | None:
    """Those beyond the first modes, none of which is below ω; None where they have none of this form."""
    if damping.ratios:
        return GivenDenominators(2 * float(damping.ratios[-1]), 0.0, 0.0, omega) if len(
            damping.ratios) <= count + 1 else None
    series = (*map(float, damping.series), 0.0, 0.0)
    return GivenDenominators(0.0, *series[:2], omega) if not any(series[2:]) else None
