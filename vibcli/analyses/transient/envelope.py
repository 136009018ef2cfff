"""The envelopes of vibrations: A e^{−δt} of one; of two, A₁e^{−δ₁t} cos(ω₁t − φ₁) + A₂e^{−δ₂t} cos(ω₂t − φ₂), what the
magnitude of their sum never exceeds, the length of the sum of the two arrows that turn with ω₁ and ω₂:

    E² = A₁²e^{−2δ₁t} + A₂²e^{−2δ₂t} + 2A₁A₂e^{−(δ₁+δ₂)t} cos(Δω t − Δφ) = (a − b)² + 4ab cos²((Δω t − Δφ)/2)

with a, b the lengths of the arrows. E² is a sum of exponentials: its extremes are found as those of any output.
"""

from fractions import Fraction
from math import inf, pi, tau
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.extremes import extreme
from vibcli.analyses.transient.forcing_arrays import bare_timeline
from vibcli.analyses.transient.isolating_intervals import EPSILON
from vibcli.analyses.transient.jets import Jet, Jets
from vibcli.base.errors import PhysicsError
from vibcli.symbolic.interval_arithmetic import Interval, exact
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.analyses.transient.textbook_form import Part
    from vibcli.base.work import Work

EQUAL = 1e-12       # relative distance of amplitudes that are one
UNDYING = 1e-13     # decay, relative to the angular frequency, that counts as none


class Decay:
    """A e^{rate t}, also as a part of a Composition."""

    starts, period, recorded = np.zeros(1), None, False

    def __init__(self, amplitude: float, rate: float) -> None:
        self.amplitude, self.rate, self.nodes = amplitude, rate, [(complex(rate),)]

    def values(self, times: np.ndarray) -> np.ndarray:
        return self.amplitude * np.exp(self.rate * times)

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        return self.values(tau)

    def jet(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> Jet:
        ends = [self.values(tau) for tau in (early, late)]
        value = Interval(np.minimum(*ends), np.maximum(*ends)) * Interval(1 - 8 * EPSILON, 1 + 8 * EPSILON)
        return Jet(value, exact(self.rate) * value, exact(self.rate**2) * value)

    size = jet

    def extreme(self, start: float, end: float, sense: int, work: "Work") -> tuple[float, float]:
        """(t, value) of the largest (sense 1) or smallest (−1) value: at an end."""
        times = np.array([start, end])
        found = self.values(times)
        best = int(np.argmax(sense * found))
        return float(times[best]), float(found[best])

    def zeros(self, start: float, end: float, most: float = inf) -> list[float]:
        """None: it dies out, or is 0 for good."""
        return []

    def final(self) -> float:
        if self.rate > 0:
            raise growing()
        return 0.0 if self.rate else self.amplitude


def growing() -> PhysicsError:
    return PhysicsError("the motion grows without end: it comes to no rest", "ask for a value at a time")


class Beats:
    """Of two Parts, each A e^{rate t} cos(ω t − φ) from t = 0 on, also as a part of a Composition. `terms`, `timeline`:
    what E² is the sum of, as Pieces has them."""

    starts, recorded, timeline = np.zeros(1), False, bare_timeline(np.zeros(1))

    def __init__(self, one: "Part", two: "Part") -> None:
        self.one, self.two = one, two
        self.apart, self.lag = two.omega - one.omega, two.phase - one.phase
        turning = 2 * one.amplitude * two.amplitude * np.exp(-1j * self.lag)
        self.waves = [(complex(part.amplitude**2), complex(2 * part.rate)) for part in (one, two)]
        self.waves.append((complex(turning), complex(one.rate + two.rate, self.apart)))
        self.nodes: list[tuple[complex, ...]] = [(node,) for _, node in self.waves]

    @property
    def period(self) -> float | None:
        """After which E repeats itself; None where a vibration dies out."""
        return None if self.one.rate or self.two.rate else tau / abs(self.apart)

    def values(self, times: np.ndarray) -> np.ndarray:
        found: np.ndarray = np.sqrt(self.square(times))
        return found

    def square(self, times: np.ndarray) -> np.ndarray:
        """E² at the times."""
        a, b = (abs(part.amplitude) * np.exp(part.rate * times) for part in (self.one, self.two))
        found: np.ndarray = (a - b) ** 2 + 4 * a * b * np.cos((self.apart * times - self.lag) / 2) ** 2
        return found

    def terms(self, output: None, order: int) -> "SquareRate":
        return SquareRate(self, order)

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        return self.values(tau)

    def jet(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> Jet:
        a, b = (Decay(abs(part.amplitude), part.rate).jet(segment, early, late) for part in (self.one, self.two))
        speed = exact(self.apart / 2)
        cosine = Jets.functions["cos"](Jet(speed * Interval(early, late) + exact(-self.lag / 2), speed))
        apart, square = a + Jets.number(-1) * b, Fraction(2)
        return Jets.power(Jets.power(apart, square) + Jets.number(4) * a * b * Jets.power(cosine, square), HALF)

    size = jet

    def extreme(self, start: float, end: float, sense: int, work: "Work") -> tuple[float, float]:
        """(t, E) where it is largest (sense 1) or smallest (−1)."""
        end = min(end, start + (self.period or end))
        t, square = extreme(self, None, start, end, "max" if sense > 0 else "min", work)
        return t, max(square, 0.0) ** 0.5

    def zeros(self, start: float, end: float, most: float = inf) -> list[float]:
        """The first instants of E = 0, so many at most: where arrows that are equally long are opposed."""
        ratio, rate = float(np.log(abs(self.two.amplitude / self.one.amplitude))), self.one.rate - self.two.rate
        if abs(rate) > UNDYING * self.one.omega:
            t = ratio / rate
            opposed = abs(np.cos((self.apart * t - self.lag) / 2)) <= EQUAL * (1 + abs(self.apart * t))
            return [t] if opposed and start <= t <= end else []
        if abs(ratio) > EQUAL:
            return []
        speed, turn = abs(self.apart), pi + (self.lag if self.apart > 0 else -self.lag)
        first, last = np.ceil((speed * start - turn) / tau), np.floor((speed * end - turn) / tau)
        return [(turn + tau * n) / speed for n in range(int(first), int(min(last + 1, first + most)))]

    def final(self) -> float:
        lasting = [part for part in (self.one, self.two) if not part.rate]
        if max(self.one.rate, self.two.rate) > 0:
            raise growing()
        if len(lasting) == 2:
            raise PhysicsError("the motion keeps beating: its envelope has no limit",
                               "ask for max(x), min(x) or a value at a time")
        return abs(lasting[0].amplitude) if lasting else 0.0


class SquareRate:
    """The order-th derivative of E² of Beats."""

    def __init__(self, beats: Beats, order: int) -> None:
        self.beats, self.order = beats, order
        self.exponents = np.array([node for _, node in beats.waves])
        self.sizes = np.array([c for c, _ in beats.waves]) * self.exponents**order

    def nodes(self) -> list[tuple[complex, ...]]:
        return self.beats.nodes

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        if not self.order:
            return self.beats.square(tau)
        return np.real(np.exp(np.multiply.outer(tau, self.exponents)) @ self.sizes)

    def bound(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> np.ndarray:
        ends = (np.multiply.outer(tau, self.exponents.real) for tau in (early, late))
        found: np.ndarray = np.exp(np.maximum(*ends)) @ np.abs(self.sizes)
        return found
