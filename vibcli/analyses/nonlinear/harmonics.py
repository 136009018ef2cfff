"""Free motions that come to rest at both ends of their way, as sums of cosines: η(θ) = Σ aₖ cos kθ.

Such are the families about an equilibrium wherever a motion runs backwards as well (Kerschen and others 2009): only
half the unknowns of a Fourier series are left, and no phase.
"""

from functools import lru_cache
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.compiled_arrays import Compiled

FINER, NEWTON = 4, 8        # places to a harmonic where the extremes of a signal are looked for
SETTLED = 1e-9              # a step of θ after which an extreme, where the rate vanishes, is known to rounding


class CosineMotion(NamedTuple):
    """a of shape (harmonics + 1, n), and ω over that of the linear mode."""

    a: np.ndarray
    w: float

    @property
    def size(self) -> float:
        return float(np.linalg.norm(self.a))

    def with_harmonics(self, count: int) -> "CosineMotion":
        """With so many harmonics, those that are new being none."""
        a = np.zeros((count + 1, self.a.shape[1]))
        kept = min(count + 1, len(self.a))
        a[:kept] = self.a[:kept]
        return CosineMotion(a, self.w)


class Cosines(NamedTuple):
    """cos kθ and its first two derivatives, of shape (harmonics + 1, places)."""

    value: np.ndarray
    slope: np.ndarray
    bend: np.ndarray


@lru_cache(40)
def cosines(harmonics: int, cells: int, longer: bool = False, odd: bool = False) -> Cosines:
    """At θ = π j/cells, j = 0 … cells; longer: in long doubles; odd: odd harmonics alone, at θ < π/2."""
    k, j = np.arange(harmonics + 1)[:, None], np.arange(cells + 1)
    if odd:
        k, j = k[1::2], j[:len(j) // 2]
    angle = np.longdouble(4) * np.arctan(np.longdouble(1)) * ((k * j) % (2 * cells)) / np.longdouble(cells)
    return _rounded(k, np.cos(angle), np.sin(angle), np.longdouble if longer else float)


def _rounded(k: np.ndarray, cos: np.ndarray, sin: np.ndarray, kind: Any = float) -> Cosines:
    return Cosines(*(np.ascontiguousarray(part, kind) for part in (cos, -k * sin, -k * k * cos)))


class AmplitudeOfSignal:
    """Half the range over a period of a signal, a function of the places alone, and its gradient."""

    def __init__(self, compiled: Compiled, rest: np.ndarray, shapes: np.ndarray) -> None:
        self.compiled, self.rest, self.shapes = compiled, rest, shapes

    def _signal(self, eta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(values, slopes by η of shape (n, places))."""
        q = self.rest[:, None] + self.shapes @ eta
        places = q.shape[1]
        with np.errstate(all="ignore"):
            value, *slopes = self.compiled(np.zeros(places), q, np.zeros(q.shape))
        by_q = np.empty(q.shape)
        for i, slope in enumerate(slopes):
            by_q[i] = slope
        return np.broadcast_to(value, (places,)), self.shapes.T @ by_q

    def by_mode(self, number: int) -> float:
        """|∂s/∂η| at the equilibrium."""
        return abs(float(self._signal(np.zeros((len(self.rest), 1)))[1][number, 0]))

    def of(self, motion: CosineMotion) -> tuple[float, np.ndarray]:
        """(half the range, its derivatives by a)."""
        harmonics = len(motion.a) - 1
        cells = FINER * max(harmonics, 4)
        values, _ = self._signal(motion.a.T @ cosines(harmonics, cells).value)
        ends = [(self._extreme(motion, int(i), cells), sense)
                for i, sense in ((values.argmax(), 1), (values.argmin(), -1))]
        table = _at(harmonics, np.array([theta for theta, _ in ends]))
        found, slopes = self._signal(motion.a.T @ table.value)
        gradient = 0.5 * (np.outer(table.value[:, 0], slopes[:, 0]) - np.outer(table.value[:, 1], slopes[:, 1]))
        return 0.5 * float(found[0] - found[1]), gradient

    def _extreme(self, motion: CosineMotion, i: int, cells: int) -> float:
        """θ of an extreme near place i, by secants of the rate of the signal."""
        if i in (0, cells):
            return np.pi * (i > 0)
        a, b = np.pi * (i - 0.25) / cells, np.pi * (i + 0.25) / cells
        f, g = self._rate(motion, a), self._rate(motion, b)
        for _ in range(NEWTON):
            if f == g or abs(b - a) < SETTLED:
                break
            a, b, f = b, b - g * (b - a) / (g - f), g
            if abs(b - np.pi * i / cells) > np.pi / cells:
                return np.pi * i / cells
            g = self._rate(motion, b)
        return b

    def _rate(self, motion: CosineMotion, theta: float) -> float:
        table = _at(len(motion.a) - 1, np.array([theta]))
        slopes = self._signal(motion.a.T @ table.value)[1]
        return float(slopes[:, 0] @ (motion.a.T @ table.slope[:, 0]))


class AmplitudeOfCombination(AmplitudeOfSignal):
    """That of a signal whose slopes are the same everywhere: it is a sum of cosines itself."""

    def __init__(self, compiled: Compiled, rest: np.ndarray, shapes: np.ndarray) -> None:
        super().__init__(compiled, rest, shapes)
        self.slopes = self._signal(np.zeros((len(rest), 1)))[1][:, 0]

    def by_mode(self, number: int) -> float:
        """|∂s/∂η|."""
        return abs(float(self.slopes[number]))

    def of(self, motion: CosineMotion) -> tuple[float, np.ndarray]:
        """(half the range, its derivatives by a)."""
        s = motion.a @ self.slopes
        cells = FINER * max(len(s) - 1, 4)
        values = s @ cosines(len(s) - 1, cells).value
        most, least = (self._cosines_at(s, int(i), cells) for i in (values.argmax(), values.argmin()))
        apart = 0.5 * (most - least)
        return float(s @ apart), np.outer(apart, self.slopes)

    def _cosines_at(self, s: np.ndarray, i: int, cells: int) -> np.ndarray:
        """cos kθ at an extreme near place i, by Newton's method."""
        if i in (0, cells):
            return cosines(len(s) - 1, cells).value[:, i]
        k, place = np.arange(len(s)), np.pi * i / cells
        theta = place
        for _ in range(NEWTON):
            rate, bend = (k * s) @ np.sin(k * theta), (k * k * s) @ np.cos(k * theta)
            step = -rate / bend if bend else np.inf
            if not abs(theta + step - place) <= np.pi / cells:
                theta = place
                break
            theta += step
            if abs(step) < SETTLED:
                break
        found: np.ndarray = np.cos(k * theta)
        return found


def _at(harmonics: int, theta: np.ndarray) -> Cosines:
    k = np.arange(harmonics + 1)[:, None]
    return _rounded(k, np.cos(k * theta), np.sin(k * theta))
