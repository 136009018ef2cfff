"""States that loads leave, as sums over answers to unit loads at places s. With R(s) = (s − A)⁻¹ and B of a unit load,
R(s) B = (h, s h), a load f̂(s) leaves

    S(f̂) = Σ residues of f̂(s) R(s) B at its poles,      Π S(f̂) = (1/2πi) ∮ f̂(s) R(s) B ds

about all of these, Π taking off the modes within the circle. (τ − A)⁻¹ S(f̂) = S(f̂/(τ − s)) has the further pole τ
outside, f̂(τ) R(τ) B being taken off, which is a mean over a small circle about it.
"""

from math import factorial

import numpy as np

from vibcli.base.named_tuple import NamedTuple

FIRST, WIDER, MANY = 2.0, 4.0, 17       # τ: the first in radii of the circle, times it from one to the next, how many
AROUND = 4          # places on the upper half of a circle about each τ
SHARES = 1 / 32, 1 / 64         # of τ: their radii on both sides of products


class PlacesOnCircles(NamedTuple):
    """Those on the upper half of a circle about 0, and of circles about each of the τ."""

    circle: np.ndarray
    poles: np.ndarray
    around: np.ndarray

    @property
    def all(self) -> np.ndarray:
        """All of them."""
        return np.concatenate([self.circle, self.around.ravel()])


def places_on(circle: np.ndarray, radius: float = 0.0, share: float = 0.0) -> PlacesOnCircles:
    """Those of a circle, and, where there is a share, about the τ beyond a radius."""
    poles = FIRST * radius * WIDER ** np.arange(MANY if share else 0)
    turn = np.exp(1j * np.pi * (np.arange(AROUND) + 0.5) / AROUND)
    return PlacesOnCircles(circle, poles, poles[:, None] * (1 + share * turn))


class Column(NamedTuple):
    """The answer to a unit load on a slot: ∂ᵏ/∂sᵏ of (h, s h) at s, its `imaginary` part or the real one; of a power −1
    the answer to a blow; smooth: (τ − A)⁻¹ of that, τ that of so many, None of the answer itself."""

    slot: int
    exponent: complex
    power: int
    imaginary: bool = False
    smooth: int | None = None

    @property
    def is_blow(self) -> bool:
        """Does it hold B itself?"""
        return self.power < 0 and self.smooth is None

    def weights(self, places: PlacesOnCircles) -> np.ndarray:
        """Those of (h, s h) at all places on upper halves, their conjugates being those on the lower ones."""
        own = self._symbol(places.circle) * places.circle / (2 * len(places.circle))
        around = np.zeros(places.around.shape, complex)
        if self.smooth is not None:
            tau = places.poles[self.smooth]
            own, around[self.smooth] = own / (tau - places.circle), -self._symbol(tau) / (2 * AROUND)
        return np.concatenate([own, around.ravel()])

    def _symbol(self, s: np.ndarray) -> np.ndarray:
        """f̂(s)."""
        if self.power < 0:
            return -1.0 + 0 * s
        first, second = (factorial(self.power) / (s - e) ** (self.power + 1)
                         for e in (self.exponent, self.exponent.conjugate()))
        return (first - second) / 2j if self.imaginary else (first + second) / 2
