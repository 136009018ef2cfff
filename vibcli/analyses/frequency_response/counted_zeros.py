"""Zeros of H beside the axis Ω, as many as the argument principle counts in rectangles between poles:

    Σ zᵏ − Σ pᵏ = ∮ sᵏ H′/H ds/2πi      over zeros z and poles p within (Delves & Lyness 1967),

from which all zeros within follow, to be polished by Newton's method. That no pole is missing the same count of det D
tells: its zeros are those of the scene, its poles the s at which pieces vibrate with their ends held.
"""

from contextlib import suppress
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.member_poles_and_zeros import LOWEST, distinct, followed, taking_part, to_zero
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.ascending import ascending
from vibcli.numerics.contours import SideSamples, along
from vibcli.numerics.pieces.held_count import held_count

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
    from vibcli.analyses.frequency_response.member_response import MemberTransfer

    Field = Callable[[np.ndarray], np.ndarray]

SECTIONS = 0.5, 0.31, 0.72      # of a gap between poles, as tried: nothing may lie next to the sides of rectangles
TOGETHER = 0.02     # of the mean gap: poles that stand in one rectangle
WHOLE = 0.02        # how far a count is from a whole number at most
MOST, DEEPEST = 6, 6    # zeros that are found together, and how often rectangles are cut
SMALL = 1e-3, 1e-5, 1e-7, 1e-9      # of a pole: how near to it H is looked at for the zero next to it
FURTHER = 2.0       # times a frequency: pieces with their ends held that swing so fast may decay beside it
UNDER = 0.5         # of the first pole: from where zeros are counted that are not certain from 0 on
ALIKE = 1e-11       # relative: poles that are one but for rounding


class Rectangle(NamedTuple):
    """|Re s| < width, low < Im s < high."""

    width: float
    low: float
    high: float

    def holds(self, s: np.ndarray) -> np.ndarray:
        found: np.ndarray = (np.abs(s.real) < self.width) & (s.imag > self.low) & (s.imag < self.high)
        return found

    @property
    def sides(self) -> list[tuple[complex, complex]]:
        """From the lower right corner on, to the left about it."""
        a, b, c, d = (complex(x, y) for x, y in ((self.width, self.low), (self.width, self.high),
                                                 (-self.width, self.high), (-self.width, self.low)))
        return [(a, b), (b, c), (c, d), (d, a)]


class CountedRoots:
    """A function whose zeros are counted: slope(s) is f′/f there, steps lead from s to zeros, poles are all it has,
    near `starts` zeros may lie."""

    def __init__(self, slope: "Field", steps: "Sequence[Field]", poles: np.ndarray, starts: np.ndarray) -> None:
        self.slope, self.steps, self.poles, self._starts = slope, steps, poles, starts

    def zeros(self, parts: "Sequence[Rectangle]", around: "Sequence[SideSamples]", depth: int = DEEPEST) -> np.ndarray:
        """Those in Rectangles, whose SideSamples are known, each as often as it is one."""
        poles = [self.poles[part.holds(self.poles)] for part in parts]
        counts = [_turns(samples) + len(own) for samples, own in zip(around, poles, strict=True)]
        roots = [_roots(*one) if 0 < one[-1] <= MOST else one[2][:0]
                 for one in zip(parts, around, poles, counts, strict=True)]
        self._starts = np.concatenate([followed(step, np.concatenate([self._starts, *roots])) for step in self.steps])
        near = distinct(self._starts)
        return np.concatenate([near[:0], *(self._within(*one, near, depth)
                                           for one in zip(parts, counts, poles, roots, strict=True))])

    def _within(self, part: Rectangle, count: int, poles: np.ndarray, roots: np.ndarray, near: np.ndarray,
                depth: int) -> np.ndarray:
        found = near[part.holds(near)]
        if len(found) == count or not count:
            result: np.ndarray = found[:count]
            return result
        if not depth and len(roots):
            one = distinct(followed(lambda s: count * self.steps[0](s), roots.mean(keepdims=True)))
            if len(one) == 1 and part.holds(one).all():
                return np.repeat(one, count)
        for y in _cuts(part, np.concatenate([poles, found, roots])) if depth and count > 0 else ():
            halves = [part._replace(high=y), part._replace(low=y)]
            around = _around(self.slope, halves)
            if None not in around:
                return self.zeros(halves, around, depth - 1)
        raise uncertain(part.low, part.high)


class CountedPoles(NamedTuple):
    """All poles of a scene with 0 < Im s ≤ high that are no further from the axis than `width`, each as often as it is
    one, and such beyond as are known."""

    poles: np.ndarray
    width: float


def counted_poles(response: "MemberTransfer", known: np.ndarray, low: float, high: float) -> CountedPoles:
    """Those of the scene of a response; known: where they may be. PhysicsError where the count does not tell."""
    held = _held(response, high)
    return counted_among(CountedRoots(lambda s: _of_matrix(response, s), [response.to_pole, response.to_pole_within],
                                      held, known), known, low, high)


def counted_among(scene: CountedRoots, known: np.ndarray, low: float, high: float) -> CountedPoles:
    """The zeros of a determinant, the poles of a scene; known: where they may be. PhysicsError where the count does not
    tell."""
    for share in SECTIONS:
        parts = _divided(known, low, high, share, (1 + share) * high / (len(known) + 1))
        around = _around(scene.slope, parts)
        if None not in around:
            found = scene.zeros(parts, around)
            beyond = known[np.abs(known.real) >= parts[0].width]
            found = np.concatenate([found, beyond])
            return CountedPoles(found[np.argsort(found.imag)], parts[0].width)
    raise uncertain(low, high)


def zeros_beside(response: "FrequencyResponseFunction", known: CountedPoles | None,
                 still: "FrequencyResponseFunction", low: float, high: float) -> np.ndarray:
    """The counted zeros; where they are not certain those to which the ones without damping lead, and the ones that are
    counted away from the real axis, near which modes may creep without end."""
    try:
        if known is None:
            raise uncertain(low, high)
        return counted_zeros(response, known, low or LOWEST * response.pace, high)
    except PhysicsError:
        if not still.undamped:
            raise
        response.leave_uncounted("zeros")
        led_to = followed(lambda s: to_zero(response, s), still.zeros(low, high))
        return distinct(np.concatenate([led_to, *_further(response, known, low, high)]))


def _further(response: "FrequencyResponseFunction", known: CountedPoles | None, low: float,
             high: float) -> list[np.ndarray]:
    """The counted zeros from some way below the first pole on, where they are certain."""
    away = UNDER * known.poles.imag.min(initial=np.inf) if known is not None else np.inf
    if low < away < high:
        with suppress(PhysicsError):
            return [counted_zeros(response, known, away, high)]
    return []


def counted_zeros(response: "FrequencyResponseFunction", known: CountedPoles, low: float, high: float) -> np.ndarray:
    """Those with low ≤ Im s ≤ high no further from the axis than poles are counted, which are so some way beyond
    `high`. PhysicsError where the count does not tell that none is missing."""
    seen = _seen(response, known.poles)
    own = CountedRoots(lambda s: _of_response(response, s), [lambda s: to_zero(response, s)], seen,
                       _beside(response, seen))
    for share in SECTIONS:
        parts = _divided(known.poles, low, high, share, known.width * (1 - share / 10))
        around = _around(own.slope, parts)
        if None not in around:
            places = distinct(own.zeros(parts, around))
            return places[(places.imag >= low) & (places.imag <= high)]
    raise uncertain(low, high)


def uncertain(low: float, high: float) -> PhysicsError:
    """Of zeros, or of poles beside them, between these frequencies."""
    return PhysicsError(f"the zeros of this response between {low:.5g} and {high:.5g} rad/s are not certain: they, or "
                        "poles, lie too near one another", "ask for its values at frequencies")


def _seen(response: "FrequencyResponseFunction", poles: np.ndarray) -> np.ndarray:
    """The poles that H has: of several modes at one place one."""
    at = taking_part(response, poles / 1j)
    found: np.ndarray = 1j * at[np.diff(at, prepend=-np.inf).real > ALIKE * np.abs(at)]
    return found


def _divided(poles: np.ndarray, low: float, high: float, share: float,
             width: float) -> list[Rectangle]:
    """The Rectangles of a strip between gaps of the poles, the last beyond `high`."""
    at = ascending(poles.imag[(poles.imag > low) & (poles.imag <= high)])
    mean, above = (high - low) / (len(at) + 1), poles.imag[poles.imag > high]
    top = high + share * 0.1 * min(mean, float(above.min() - high) if len(above) else np.inf)
    gaps = [(a, b) for a, b in pairwise(at) if b - a > TOGETHER * mean]
    edges = [low, *(a + share * (b - a) for a, b in gaps), top]
    return [Rectangle(width, a, b) for a, b in pairwise(edges)]


def _around(slope: "Field", parts: "Sequence[Rectangle]") -> "list[SideSamples | None]":
    """The SideSamples of f′/f around each of some Rectangles, None where something lies next to a side."""
    sides = along(slope, [side for part in parts for side in part.sides])
    found: list[SideSamples | None] = []
    for k in range(len(parts)):
        own = [side for side in sides[4 * k:4 * k + 4] if side is not None]
        whole = len(own) == 4 and abs(_turned(own) - round(_turned(own))) < WHOLE
        found.append(SideSamples(*(np.concatenate(part) for part in zip(*own, strict=True))) if whole else None)
    return found


def _turned(sides: "Sequence[SideSamples]") -> float:
    return float(sum(side.values.sum() for side in sides).imag / (2 * np.pi))


def _turns(samples: SideSamples) -> int:
    return round(_turned([samples]))


def _of_response(response: "FrequencyResponseFunction", s: np.ndarray) -> np.ndarray:
    values, slopes, _ = response.at(s, True)
    with np.errstate(all="ignore"):
        found: np.ndarray = slopes / values
        return found


def _of_matrix(response: "MemberTransfer", s: np.ndarray) -> np.ndarray:
    """Of det D, tr D⁻¹ D′."""
    system = response.system
    free, found = np.ix_(system.free, system.free), system.matrix.at(s, True, loaded=False)
    D, slope = (np.moveaxis(part[free], -1, 0) for part in (found.D, found.slope))
    return np.asarray(np.trace(np.linalg.solve(D, slope), axis1=1, axis2=2))


def _held(response: "MemberTransfer", high: float) -> np.ndarray:
    """The s with 0 < Im s ≤ high, and some beyond, at which a piece vibrates with its ends held:
    μ s² + c s + μ ω² (1 + β s) = 0 of each of its frequencies ω."""
    found = [np.zeros(0, complex)]
    for placed in response.system.matrix.pieces:
        if placed.piece.inertia:
            count = partial(held_count, placed.piece._replace(drag=0.0))
            omega = np.asarray(_turns_of(count, 0.0, FURTHER * high), float)
            decay = (float(placed.piece.drag / placed.piece.inertia) + float(placed.retardation) * omega**2) / 2
            found.append(-decay + 1j * np.sqrt(omega**2 - decay**2 + 0j))
    return np.concatenate(found)


def _turns_of(count: "Callable[[float], Any]", low: float, high: float) -> list[float]:
    """Where a count grows by one, to rounding."""
    found: list[float] = []
    for number in range(int(count(low)), int(count(high))):
        a, b = found[-1] if found else low, high
        while b - a > ALIKE * b:
            middle = (a + b) / 2
            a, b = (a, middle) if count(middle) > number else (middle, b)
        found.append(b)
    return found


def _cuts(part: Rectangle, marks: np.ndarray) -> list[float]:
    """Heights at which a Rectangle is cut, in its largest gap."""
    at = np.array([part.low, *np.sort(marks.imag[part.holds(marks)]), part.high])
    k = int(np.diff(at).argmax())
    return [at[k] + share * (at[k + 1] - at[k]) for share in SECTIONS]


def _roots(part: Rectangle, samples: SideSamples, poles: np.ndarray, count: int) -> np.ndarray:
    """All zeros within from sums of their powers (Newton's identities)."""
    middle, size = 0.5j * (part.low + part.high), part.high - part.low + part.width
    z, p = (samples.s - middle) / size, (poles - middle) / size
    sums = [(samples.values * z**k).sum() / (2j * np.pi) + (p**k).sum() for k in range(1, count + 1)]
    e: list[Any] = [1.0]
    for k in range(1, count + 1):
        e.append(sum((-1)**(i - 1) * e[k - i] * sums[i - 1] for i in range(1, k + 1)) / k)
    return middle + size * np.roots([(-1)**k * x for k, x in enumerate(e)])


def _beside(response: "FrequencyResponseFunction", poles: np.ndarray) -> np.ndarray:
    """Where H ≈ r/(s − p) + h is zero next to each pole, which may hardly be felt."""
    found = []
    for step in SMALL if len(poles) else ():
        away = step * np.abs(poles)
        right, left = (response.at(poles + side * away)[0] for side in (1, -1))
        with np.errstate(all="ignore"):
            found.append(poles - away * (right - left) / (right + left))
    return np.concatenate(found)[np.isfinite(np.concatenate(found))] if found else poles
