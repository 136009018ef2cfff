"""The energy balance of small oscillations: what T + V gains is the work of the loads less what is dissipated,

    Δ(½ q̇ᵀ M q̇ + ½ qᵀ Kₛ q) = ∫ q̇ᵀ (f − Kₐ q) dt − ∫ q̇ᵀ Cₛ q̇ dt,

Kₛ and Cₛ being the symmetric parts of K and C + G, Kₐ the skew one of K; the skew one of C + G does no work. It is
looked at over spans that each begin with a segment of the loads, those of the first and the last ones: a radian of the
slowest motion, or so many parts of two radians of the fastest, on each of which Gauss's rule is exact but for rounding.
"""

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.transient.exponential_sum import ExponentialSum
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.analyses.transient.linear_response import LinearMotion

POINTS, PARTS, RADIANS = 10, 6, 2.0
FIRST = 1               # segments, beside the last
WITHIN = 0.9            # of a segment: where the next one begins a blow may strike


class StatesOverSpans(NamedTuple):
    """q, q̇ and the forces f at instants: n × m each."""

    q: np.ndarray
    v: np.ndarray
    f: np.ndarray


def energy_balance(motion: "LinearMotion", until: float) -> float | None:
    """What both sides differ by over a span, relative to the largest of their terms, of T and of V; None where what has
    no inertia follows, or loads are records."""
    if motion.system is not None or motion.forcing.recorded or not until > 0:
        return None
    x, weights = _gauss()
    spans = list(_spans(motion, until))
    times = [_instants(start, length, x) for start, length in spans]
    found = _states(motion, np.concatenate(times))
    along = np.tile(weights, PARTS) / (2 * PARTS)
    each = zip(spans, *(np.split(part, len(spans), axis=1) for part in found), strict=True)
    return max(_off(motion, StatesOverSpans(*states), length * along) for (_, length), *states in each)


@cache
def _gauss() -> tuple[np.ndarray, np.ndarray]:
    return np.polynomial.legendre.leggauss(POINTS)


def _spans(motion: "LinearMotion", until: float) -> "Iterator[tuple[float, float]]":
    """(start, length) of each."""
    segments = motion.forcing.segments(until)
    both = list(zip(segments, [*(segment.start for segment in segments[1:]), until], strict=True))
    for segment, end in both[:FIRST] + both[max(FIRST, len(both) - 1):]:
        rates = [abs(x) for x in (*(rate for block in motion.blocks for rate in block.nodes),
                                  *(wave.exponent for wave in segment.waves)) if x]
        lengths = [PARTS * RADIANS / max(rates), 1 / min(rates)] if rates else []
        yield segment.start, min([WITHIN * (end - segment.start), *lengths])


def _instants(start: float, length: float, x: np.ndarray) -> np.ndarray:
    """The ends of a span, and Gauss's points of its parts between them."""
    inner = np.arange(PARTS)[:, None] + (x + 1) / 2
    return start + length * np.array([0.0, *inner.ravel() / PARTS, 1.0])


def _place(entries: dict[int, float]) -> LinearOutput:
    return LinearOutput(q=entries)


def _speed(entries: dict[int, float]) -> LinearOutput:
    return LinearOutput(v=entries)


def _states(motion: "LinearMotion", t: np.ndarray) -> StatesOverSpans:
    n, f, pieces = len(motion.M), np.zeros((len(motion.M), len(t))), motion.pieces(t.max())
    where: Any = pieces.timeline.place(t)
    known: dict[Any, Any] = {}

    def values(output: LinearOutput) -> np.ndarray:
        return ExponentialSum(pieces, output, 0, split=False).at(*where, known)

    q, v = (np.array([values(one({i: 1.0})) for i in range(n)]) for one in (_place, _speed))
    for i in {wave.channel for segment in motion.forcing.segments(t.max()) for wave in segment.waves} & set(range(n)):
        f[i] = values(LinearOutput(channels={i: 1.0}))
    return StatesOverSpans(q, v, f)


def _off(motion: "LinearMotion", states: StatesOverSpans, weights: np.ndarray) -> float:
    """The balance over a span, its ends first and last among the states."""
    K, C = ((part + part.T) / 2 for part in (motion.K, motion.C))
    T, V = (0.5 * np.einsum("im,ij,jm->m", side, matrix, side)
            for side, matrix in ((states.v, motion.M), (states.q, K)))
    work = np.einsum("im,im->m", states.v, states.f - (motion.K - K) @ states.q)
    lost = np.einsum("im,ij,jm->m", states.v, C, states.v)
    worked, dissipated = weights @ work[1:-1], weights @ lost[1:-1]
    size = max(*np.abs(T), *np.abs(V), abs(worked), abs(dissipated))
    gained = (T[-1] - T[0]) + (V[-1] - V[0])
    return float(abs(gained - worked + dissipated) / size) if size else 0.0
