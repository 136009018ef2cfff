"""Sums over all modes that a MemberDamping damps, from the exact sum without it: no series, no remainder.

With G(σ) = Σ R/(ω² + σ²) at any complex σ, H(s) = Σ R/(ω² + s² + c s) is, for c = Σ aₖ ω²ᵏ by partial fractions in ω²,

    H = Σ G(√−zⱼ)/q′(zⱼ),      q(z) = s² + z + s Σ aₖ zᵏ = 0 at zⱼ,

and for c = 2 ζ ω, whose odd powers of ω are ω = (2/π) ∫ ω²/(ω² + η²) dη over η > 0, with ζ = cos θ, A = −s² e^{2iθ},
B = −s² e^{−2iθ}, P = √A and Q = √B of positive imaginary part,

    H = (e^{iθ} G(P) − e^{−iθ} G(Q))/(2i sin θ) + (P G(P) − Q G(Q))/(2 s sin θ)
        + 2 ζ s (2/π) ∫ η² G(η)/((A − η²)(B − η²)) dη.

The integral is the trapezoidal rule over u = ln η, with what its poles beside the real axis add to it. Where ζ is so
large that P and Q come near each other or the real axis, H is the mean of what it is about ζ (Cauchy): for Re s ≥ 0 it
has no pole there; with its first part E, even in s, H(s) = 2 E(s) − H(−s) gives the rest. Modes with ratios of their
own change by R times what their fractions do.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.analyses.modal.undamped import Mode

STEP, REACH = 0.1, 45.0     # of u, and how far from the middle it goes
HIGHEST, ALIKE = 0.8, 0.05      # ratio up to which P and Q are well apart; distance from 1 below which they are not
AT_ONCE, KEPT = 256, 6      # values of s beside all of η; how many such blocks of weights are kept
SMALL = 1e-14       # of a natural frequency: an s at rest
UNIT, ROUGH, PARTS = 2.0**-52, 4096.0, 16.0     # roundings of means about ζ, of each partial fraction
POLISHED = 3        # steps of Newton's method
LOW, TERMS = 0.1, 8     # of that circle, where the series of so many terms is
CIRCLE, SHARE, CLOSE = 24, 0.25, 1e-6       # points about a pole or ζ, radius over the next pole's distance, closest


class OwnRatio(NamedTuple):
    """A mode whose ratio is not that of the last: ω, ζ, and the distance of the next frequency."""

    omega: float
    zeta: float
    gap: float


class DampedSum:
    """H of a G, which gives arrays (…, N) at complex σ (N,)."""

    def __init__(self, damping: "MemberDamping", modes: "Modes", G: Callable[[np.ndarray], np.ndarray]) -> None:
        self.damping, self.G, self.zeta = damping, G, float(damping.ratios[-1]) if damping.ratios else None
        known = modes.shown()
        self._lowest = min(float(mode.omega) for mode in known if mode.omega)
        self._rigid = any(mode.rigid for mode in known)
        self.pace = float(np.exp(np.mean([np.log(float(mode.omega)) for mode in known if mode.omega])))
        if damping.ratios:
            if known[0].growth_rate is not None:
                raise PhysicsError("responses of members that are unstable are not found with modal damping",
                                   "write `proportional: [alpha, beta]`, or take `damping:` out")
            self.own = _own(damping, modes)
            self._u = _grid(self.pace)
            self._eta = np.exp(self._u)
            self._spread = self._squared()
            self._residues = [self._residue(one) for one in self.own]

    @property
    def rounding(self) -> float:
        """How many roundings of H the sum brings, by and by."""
        if not self.damping.ratios:
            return PARTS * len(self.damping.series)
        last = ROUGH if self.zeta > HIGHEST else np.exp(-2 * np.pi * np.arccos(self.zeta) / STEP) / UNIT
        return 1 + 64 * len(self.damping.ratios) + last

    def at(self, s: np.ndarray) -> np.ndarray:
        """(…, N)."""
        s = np.asarray(s, complex)
        if not self.damping.ratios:
            return cast("np.ndarray", self._by_fractions(s))
        parts = [self._by_ratio(s[k:k + AT_ONCE]) for k in range(0, max(len(s), 1), AT_ONCE)]
        return np.concatenate(parts, axis=-1)

    def beside_rest(self, s: np.ndarray) -> np.ndarray:
        """s, a little beside 0 where it is 0."""
        return np.where(np.abs(s) < SMALL * self.pace, 1j * SMALL * self.pace, s)

    def _by_fractions(self, s: np.ndarray) -> Any:
        series, found = [float(a) for a in self.damping.series], 0.0
        for z, slope in fractions(series, self.beside_rest(s) if len(series) > 2 else s):
            found = found + self.G(np.sqrt(-z)) / slope
        return found

    def _by_ratio(self, s: np.ndarray) -> np.ndarray:
        s = self.beside_rest(s)
        if self.zeta <= HIGHEST:
            found = self._of_one_ratio(s, self.zeta)
        else:
            left = s.real < 0
            found = self._mean(self._of_one_ratio, np.where(left, -s, s), SHARE * self.zeta)
            if left.any():
                apart = abs(1 - self.zeta) > ALIKE
                even = self._even(s, self.zeta) if apart else self._mean(self._even, s, 2 * ALIKE)
                found = np.where(left, 2 * even - found, found)
        for one, residue in zip(self.own, self._residues, strict=True):
            change = _fraction(one.omega, one.zeta, s) - _fraction(one.omega, self.zeta, s)
            found = found + residue[..., None] * change
        return found

    def _mean(self, of: Callable[[np.ndarray, Any], np.ndarray], s: np.ndarray, radius: float) -> Any:
        """Of what stands about ζ."""
        about = self.zeta + radius * np.exp(2j * np.pi * (np.arange(CIRCLE) + 0.5) / CIRCLE)
        return sum(of(s, zeta) for zeta in about) / CIRCLE

    def _even(self, s: np.ndarray, zeta: Any) -> np.ndarray:
        """E at one ζ of all modes."""
        sine, turn, P, Q = _places(s, zeta)
        return (turn * self.G(P) - self.G(Q) / turn) / (2j * sine)

    def _of_one_ratio(self, s: np.ndarray, zeta: float) -> np.ndarray:
        """H at one ζ, of any kind, of all modes."""
        sine, turn, P, Q = _places(s, zeta)
        G_P, G_Q = self.G(P), self.G(Q)
        found = (turn * G_P - G_Q / turn) / (2j * sine) + (P * G_P - Q * G_Q) / (2 * s * sine)
        A, B = P * P, Q * Q
        integral = self._spread @ _weights(self.pace, complex(zeta), s.tobytes())
        for root, value, gap in ((P, G_P, B - A), (Q, G_Q, A - B)) if zeta else ():
            integral = integral - self._beside(root, -value * _right(root) / (np.pi * gap))
        return cast("np.ndarray", found + 2 * zeta * s * integral)

    def _squared(self) -> np.ndarray:
        """η² G(η); where η is far below all frequencies its series in η², from a circle about 0 (Cauchy)."""
        eta, low = self._eta, self._eta < LOW * SHARE * self._lowest
        high = eta[~low]**2 * np.nan_to_num(self.G(eta[~low] + 0j)).real
        circle = SHARE * self._lowest * np.exp(2j * np.pi * (np.arange(CIRCLE) + 0.5) / CIRCLE)
        around, terms = circle**2 * self.G(circle), np.arange(0 if self._rigid else 1, TERMS)
        series = np.stack([(around * circle**(-2.0 * k)).mean(axis=-1).real for k in terms], axis=-1)
        return np.concatenate([series @ eta[low] ** (2.0 * terms[:, None]), high], axis=-1)

    def _beside(self, root: np.ndarray, residue: np.ndarray) -> np.ndarray:
        """What the trapezoidal rule has beyond an integral with a pole of that residue at u = ln(±root)."""
        u = np.log(_right(root))
        x = np.pi * (u - self._u[0]) / STEP
        side = np.sign(u.imag)
        phase = np.exp(2j * side * x)
        return cast("np.ndarray", residue * -2j * np.pi * side * phase / (phase - 1))

    def _residue(self, one: OwnRatio) -> np.ndarray:
        """R of a mode, the mean of G (ω² + σ²) about its pole."""
        turn = SHARE * one.gap * np.exp(2j * np.pi * (np.arange(CIRCLE) + 0.5) / CIRCLE)
        sigma = 1j * one.omega + turn
        return np.real((self.G(sigma) * turn * 2j * one.omega).mean(axis=-1))


def _grid(pace: float) -> np.ndarray:
    """u of the trapezoidal rule."""
    return cast("np.ndarray", np.log(pace) + np.arange(-REACH, REACH, STEP))


@lru_cache(KEPT)
def _weights(pace: float, zeta: complex, points: bytes) -> np.ndarray:
    """Those of η² G(η) at s of these bytes, (η, s): sums of several G are asked for at the same."""
    P, Q = _places(np.frombuffer(points, complex), zeta)[2:]
    eta = np.exp(_grid(pace))[:, None]
    return cast("np.ndarray", (2 / np.pi) * STEP * eta / ((P * P - eta**2) * (Q * Q - eta**2)))


def fractions(series: "Sequence[float]", s: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """(z, q′(z)) of every root of q(z) = s² + z + s Σ aₖ zᵏ, (N,) each."""
    rest = s * s + s * series[0]
    if len(series) <= 2:
        slope = 1 + s * series[1] if len(series) == 2 else np.ones(len(s))
        return [(-rest / slope, slope)]
    powers = [s * a for a in series]
    powers[0], powers[1] = rest, 1 + s * series[1]
    degree = len(series) - 1
    companion = np.zeros((len(s), degree, degree), complex)
    companion[:, range(1, degree), range(degree - 1)] = 1.0
    with np.errstate(all="ignore"):
        companion[:, :, -1] = -np.stack([power / powers[-1] for power in powers[:-1]], axis=-1)
    roots = np.linalg.eigvals(companion)
    q = np.array(powers).T
    for _ in range(POLISHED):
        roots = roots - _value(q, roots) / _slope(q, roots)
    slope = _slope(q, roots)
    return [(roots[:, j], slope[:, j]) for j in range(degree)]


def _value(q: np.ndarray, z: np.ndarray) -> np.ndarray:
    """q(z) of coefficients (N, degree + 1) at z (N, roots)."""
    return cast("np.ndarray", np.einsum("nk,nrk->nr", q, z[:, :, None] ** np.arange(q.shape[1])))


def _slope(q: np.ndarray, z: np.ndarray) -> np.ndarray:
    """q′(z)."""
    return _value(q[:, 1:] * np.arange(1, q.shape[1]), z)


def _own(damping: "MemberDamping", modes: "Modes") -> list[OwnRatio]:
    """The OwnRatios of modes that oscillate."""
    count = len(damping.ratios)
    known: list[Mode] = [mode for mode in modes.first(count + 1) if mode.omega]
    last, found = damping.ratios[-1], []
    for place, mode in enumerate(known):
        if mode.index >= count or damping.ratio(mode.index) == last:
            continue
        beside = [float(other.omega) for other in known[max(place - 1, 0):place + 2] if other is not mode]
        gap = min([float(mode.omega), *(abs(omega - float(mode.omega)) for omega in beside)])
        if gap < CLOSE * float(mode.omega):
            raise PhysicsError(f"the frequency of mode {mode.index} is so close to another one that responses by their "
                               "ratios are not found", "give both, and all that follow, the same ratio")
        found.append(OwnRatio(float(mode.omega), float(damping.ratio(mode.index)), gap))
    return found


def _places(s: np.ndarray, zeta: complex) -> tuple[complex, complex, np.ndarray, np.ndarray]:
    """√(1 − ζ²), e^{iθ}, P, Q."""
    sine = np.sqrt(1 - zeta**2 + 0j)
    turn = zeta + 1j * sine
    return sine, turn, _upper(-1j * s * turn), _upper(1j * s / turn)


def _fraction(omega: float, zeta: float, s: np.ndarray) -> np.ndarray:
    return cast("np.ndarray", 1 / (omega**2 + 2 * zeta * omega * s + s * s))


def _upper(root: np.ndarray) -> np.ndarray:
    return np.where(root.imag < 0, -root, root)


def _right(root: np.ndarray) -> np.ndarray:
    return np.where(root.real < 0, -root, root)
