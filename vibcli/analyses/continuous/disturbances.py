"""How far loads and the start of a motion set modes in motion that are not counted.

E = √(η² + η̇²/ω²) of a mode that nothing drives never grows. What drives it steadily is, with x = s/ω of the load,

    η = (b/ω²) f/(1 + 2ζ x + x²) = (b/ω²) Σ uₘ f⁽ᵐ⁾/ωᵐ,      |uₘ| ≤ those of 1/(1 − 2ζ x − x²)

so that a bend of the load adds to E at most (|b|/ω²) Σ (uₘ + uₘ₋₁) |Δf⁽ᵐ⁾|/ωᵐ, and an impulse |b| I/ω. Where 2ζ/ω has
no bound, a wave F e^{st} with Re s ≥ 0 that begins or ends adds at most |b F|/(ω² (1 − |x|)), as |1 + 2ζ x + x²| is no
less than |1 + x²|; what begins with η and η̇ there creeps with |η̇| ≤ |η₀| ω/(2 √(ζ² − 1)) + |η̇₀|.
"""

from collections.abc import Callable, Sequence
from math import comb, inf, log, perm, sqrt
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.uncounted_damping import CREEPING, Damping, damping_of
from vibcli.analyses.continuous.uncounted_modes import POWERS, size_of
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.uncounted_modes import UncountedModes
    from vibcli.analyses.excitation.forcing import Segment, Wave
    from vibcli.analyses.excitation.linear_output import LinearOutput

HIGHEST = 6         # power of 1/ω that is told apart
LARGEST = 0.6       # x (2ζ + x) of a load whose series is taken
SMALL = 1e-18       # of the first term: where the series ends
ROUNDING = 1e-12    # of a load: what is no bend
ALMOST = 1e-6       # imaginary part of a root that may be real
GAINED = 0.25, 0.5, 1.0, 2.0    # powers of 1/ω that even damping brings
TENSION, PACE, FALL = "tension", "pace", "fall"       # why nothing bounds it
FIELD, SERIES, BOTH = "field", "series", "both"


class Start(NamedTuple):
    """What a motion begins with: the loads that would hold its displacements, and those that would hold its rates,
    (2, channels); of all else, spread along members, √(Σ b²/ω²ᵖ) of both at each of POWERS, (2, POWERS)."""

    held: np.ndarray
    spread: np.ndarray


class Disturbances:
    """Of UncountedModes, by segments of a load and by the start: `bound` of what an output shows of them; creeping: the
    aₖ of 2ζω = Σ aₖ ω²ᵏ where 2ζ/ω grows without end. ALONE: does nothing else tell it where this does not?"""

    ALONE = True

    def __init__(self, modes: "UncountedModes", start: Start, segments: "Sequence[Segment]",
                 creeping: tuple[complex, ...] = ()) -> None:
        self.modes, self.slow = modes, _creep(creeping, modes.highest, segments)
        self._segments, self._creeping = segments, creeping
        self.damping = Damping(0.0, modes.highest, 1.0, 0.0, inf) if creeping else damping_of(modes.basis.squares,
                                                                                              modes.rates)
        channels = modes.inputs.shape[1]
        self.times = np.array([segment.start for segment in segments])
        orders = (_rows_of_waves if creeping else _orders)(segments, self.damping)
        self.start, self._sizes, self._loads = start, {}, None
        if orders is not None:
            loads = _ends_of_waves if creeping else _bends
            self._loads = loads(segments, channels, orders, start.held, self.damping.unit)

    def sizes(self, part: int) -> np.ndarray:
        """How far what begins with each segment sets one of the UncoupledParts in motion, (segments, powers of 1/ω,
        POWERS)."""
        if part not in self._sizes:
            self._sizes[part] = self._of_part(part)
        return cast("np.ndarray", self._sizes[part])

    def _of_part(self, part: int) -> np.ndarray:
        found = np.zeros((len(self.times), HIGHEST + 1, len(POWERS)))
        if self._loads is None:
            return found + inf
        bends, struck = self._loads
        active = np.flatnonzero((bends.any(axis=(0, 1)) | struck.any(axis=0)) & self.modes.felt_by(part))
        sums = self.modes.load_sums(active.tolist()) if len(active) else {}
        for power, among in sums.items():
            self._add(found, power, among, self.modes.begins[active] < power, bends[..., active], struck[:, active])
        found[0, 2:4] += self.start.spread
        return found

    def _add(self, sizes: np.ndarray, power: float, sums: np.ndarray, finite: np.ndarray, bends: np.ndarray,
             struck: np.ndarray) -> None:
        at, damping = POWERS.index(power), self.damping
        terms = damping.terms(bends.shape[1])
        beyond = (bends[..., ~finite] != 0).any(axis=-1)
        grown = np.where(beyond, inf, size_of(bends, sums))
        for m, term in enumerate(terms):
            h = min(2 + m, HIGHEST) if damping.creeping is None else 2 + (m == 1 and damping.creeping == inf)
            if term:
                sizes[:, h, at] += term * damping.highest ** (h - 2 if damping.creeping is None else 0) * grown[:, m]
        sizes[:, 1, at] += np.where((struck[:, ~finite] != 0).any(axis=-1), inf, size_of(struck, sums))

    def bound(self, output: "LinearOutput", t: float, order: int = 0) -> float:
        """Of what modes that are not counted add to the order-th rate of an output at an instant."""
        return self._total(output, t, order, self.modes.reach)

    def bounds(self, output: "LinearOutput", t: float, order: int = 0) -> bool:
        """Is that bound finite, as what places show tells that has no sum?"""
        return self._total(output, t, order, self.modes.reaches) < inf

    def reason(self, _: "LinearOutput") -> str:
        """Why it is estimated: none, what has no bound is refused."""
        return ""

    def obstacle(self, output: "LinearOutput", t: float) -> str:
        """Why it is not, where it is not: an end without TENSION is read; a load's PACE is too fast; the series after a
        start in a FIELD, or after loads, or BOTH does not converge absolutely; how amplitudes FALL tells too little."""
        if any(x and self.modes.begins_of(place) == inf for place, x in output.places.items()):
            return TENSION
        if self._loads is None:
            return PACE
        if self.damping.creeping is not None:
            return FALL
        rest = [segment._replace(waves=(), impulses=()) for segment in self._segments]
        still = Start(0 * self.start.held, 0 * self.start.spread)
        of_field, of_loads = (Disturbances(self.modes, start, segments, self._creeping).bound(output, t) == inf
                              for start, segments in ((self.start, rest), (still, self._segments)))
        return (BOTH if of_loads else FIELD) if of_field else SERIES

    def _total(self, output: "LinearOutput", t: float, order: int,
               reach: "Callable[[LinearOutput, float, int], float]") -> float:
        return sum(self._of(part, own, t, order, reach) for part, own in self.modes.parts.split(output))

    def _of(self, part: int, output: "LinearOutput", t: float, order: int,
            reach: "Callable[[LinearOutput, float, int], float]") -> float:
        found = inf
        for gained in (0.0, *GAINED) if self.damping.even else (0.0,):
            sizes = self._until(self.sizes(part), t, gained)
            found = min(found, sum(self._of_rate(output, rate, rate + order, sizes, gained, reach)
                                   for rate in range(3)))
        return found

    def _until(self, sizes: np.ndarray, t: float, gained: float) -> np.ndarray:
        """Σ of sizes up to an instant, (powers of 1/ω, POWERS); of q powers more where modes are damped evenly, as
        ω^q e^{−ζωτ} falls from ω = q/(ζτ) on."""
        count, damping = max(1, int(np.searchsorted(self.times, t, side="right"))), self.damping
        if not damping.fading:
            return cast("np.ndarray", sizes[:count].sum(axis=0))
        tau = np.maximum(t - self.times[:count], 0.0)
        if gained:
            with np.errstate(divide="ignore"):
                most = np.maximum(damping.highest, gained / (damping.even * tau))
            left = np.where(tau, most**gained * np.exp(-damping.even * np.minimum(most, 1e300) * tau), inf)
        else:
            left = np.minimum(np.exp(-damping.fading * tau), 1 / damping.grown)
        with np.errstate(invalid="ignore"):
            each = np.where(sizes[:count] == 0, 0.0, damping.grown * left[:, None, None] * sizes[:count])
        return cast("np.ndarray", np.nan_to_num(each, nan=inf, posinf=inf).sum(axis=0))

    def _of_rate(self, output: "LinearOutput", own: int, rate: int, sizes: np.ndarray, gained: float,
                 reach: "Callable[[LinearOutput, float, int], float]") -> float:
        if not self.modes.reads(output, own):
            return 0.0
        found, more = 0.0, rate - 1 if rate > 1 else 0
        if more and self.damping.creeping is not None:
            return inf
        for h in np.flatnonzero(sizes.any(axis=1)).tolist():
            ways = [(1.0, h + gained - rate), *([(self.slow, h)] if h == 2 and rate == 1 and self.slow < inf else [])]
            found += min(_product(factor * float(size), reach(output, left - power, own))
                         for factor, left in ways for power, size in zip(POWERS, sizes[h], strict=True))
        return found * (1 + self.damping.double) ** more


def _product(size: float, reach: float) -> float:
    return size * reach if size and reach else 0.0


def _orders(segments: "Sequence[Segment]", damping: Damping) -> int | None:
    """How many derivatives of loads are taken; None where a load is too fast for them to become small."""
    count = 2
    for segment in segments:
        for wave in segment.waves:
            x = damping.reach(abs(wave.exponent))
            if x > LARGEST:
                return None
            steps = log(SMALL) / log(sqrt(x)) if x > 1e-300 else 0.0
            count = max(count, wave.power + 2 + int(steps))
    return count


def _bends(segments: "Sequence[Segment]", channels: int, orders: int, held: np.ndarray,
           unit: float) -> tuple[np.ndarray, np.ndarray]:
    """Δf⁽ᵐ⁾/unitᵐ at the start of each segment, (segments, orders, channels), and impulses, (segments, channels)."""
    bends = np.zeros((len(segments), orders, channels))
    size = np.zeros(bends.shape)
    bends[0, :2], size[0, :2] = -held / [[1.0], [unit]], np.abs(held) / [[1.0], [unit]]
    for number, segment in enumerate(segments):
        for wave in segment.waves:
            if wave.channel >= channels:
                continue
            turned = wave._replace(coefficient=wave.coefficient / unit**wave.power, exponent=wave.exponent / unit)
            for side in range(min(2, len(segments) - number)):
                tau = segments[number + 1].start - segment.start if side else 0.0
                values, sizes = derivatives(turned, unit * tau, orders)
                bends[number + side, :, wave.channel] += -values if side else values
                size[number + side, :, wave.channel] += sizes
    return np.where(np.abs(bends) <= ROUNDING * size, 0.0, bends), _struck(segments, channels)


def _struck(segments: "Sequence[Segment]", channels: int) -> np.ndarray:
    """Impulses at the start of each segment, (segments, channels)."""
    found = np.zeros((len(segments), channels))
    for number, segment in enumerate(segments):
        for channel, impulse in segment.impulses:
            if channel < channels:
                found[number, channel] += impulse
    return found


def _creep(series: tuple[Any, ...], highest: float, segments: "Sequence[Segment]") -> float:
    """How many times |η₀| the rate of a mode that creeps becomes, inf where that is not known."""
    z = highest**2
    for share in (1.0, 0.5) if series else ():      # do 2ζ/ω and ζ grow from there on?
        roots = np.roots([(k - share) * float(a) for k, a in enumerate(series)][::-1])
        if any(root.real > z and abs(root.imag) <= ALMOST * abs(root) for root in roots):
            return inf
    c = sum(float(a) * z**k for k, a in enumerate(series))
    zeta = c / (2 * highest)
    if zeta <= CREEPING:
        return inf
    fastest = max((abs(complex(wave.exponent)) for segment in segments for wave in segment.waves), default=0.0)
    return z / c / sqrt(1 - zeta**-2) + fastest


def _rows_of_waves(segments: "Sequence[Segment]", damping: Damping) -> int | None:
    """How many rows _ends_of_waves has; None where a load is too fast."""
    waves = [wave for segment in segments for wave in segment.waves]
    if any(wave.power or complex(wave.exponent).real < 0 for wave in waves):
        raise left_to_creep()
    if any(abs(wave.exponent) > LARGEST * damping.highest for wave in waves):
        return None
    return 2 + 4 * max((len(segment.waves) for segment in segments), default=0)


def _ends_of_waves(segments: "Sequence[Segment]", channels: int, count: int, held: np.ndarray,
                   highest: float) -> tuple[np.ndarray, np.ndarray]:
    """What E ω²/|b| grows by where waves begin and end, (segments, count, channels), and impulses: of steady loads
    their jumps, of all else |F|/(1 − x)."""
    found = np.zeros((len(segments), count, channels))
    found[0, :2] = -held
    for number, segment in enumerate(segments):
        for k, wave in enumerate(segment.waves):
            s = complex(wave.exponent)
            for side in range(min(2, len(segments) - number) if wave.channel < channels else 0):
                tau = segments[number + 1].start - segment.start if side else 0.0
                F = complex(wave.coefficient * np.exp(s * tau)) / (1 - abs(s) / highest)
                if not s:
                    found[number + side, 0, wave.channel] += -F.real if side else F.real
                else:
                    found[number + side, 2 + 4 * k + 2 * side:4 + 4 * k + 2 * side, wave.channel] += F.real, F.imag
    return found, _struck(segments, channels)


def left_to_creep() -> PhysicsError:
    """Of a load that grows or dies out, or that nothing holds, beside modes that creep."""
    return PhysicsError("modes creep the more slowly the higher they are: what a load that grows or dies out leaves of "
                        "them, or a steady one of what nothing holds, is not found",
                        "let loads turn, or give ratios at one or two modes")


def derivatives(wave: "Wave", tau: float, orders: int) -> tuple[np.ndarray, np.ndarray]:
    """f, f′, f″ … of a wave at τ, and the sizes that they are rounded from."""
    s, k = complex(wave.exponent), wave.power
    grown = np.exp(s * tau) * wave.coefficient
    factors = [[comb(m, j) * perm(k, j) * tau ** (k - j) for j in range(min(k, m) + 1)] for m in range(orders)]
    if not s:
        found = np.array([row[m] if m <= k else 0.0 for m, row in enumerate(factors)])
        return (grown * found).real, abs(grown) * found
    sums = [sum(x * s ** (m - j) for j, x in enumerate(row)) for m, row in enumerate(factors)]
    sizes = [sum(x * abs(s) ** (m - j) for j, x in enumerate(row)) for m, row in enumerate(factors)]
    return (grown * np.array(sums)).real, abs(grown) * np.array(sizes)
