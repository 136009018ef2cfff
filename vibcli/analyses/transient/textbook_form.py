"""The response as textbooks write it: A e^{−δt} cos(ω_d t − φ), (a + b t) e^{−δt}, a e^{λ₁t} + b e^{λ₂t}, and what the
forces add.
"""

import cmath
import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.modal_block import ModalBlock

SAME = 1e-6
APART = 1e-12       # relative distance of exponents that are not one
DEAD = 40.0         # of an exponent: e^{−40} is below rounding
MERGED = 1e-3       # of a radian or of a fall by e: what two exponents may come apart by, and be written as one
LOST = 1e-7         # of what is left: what may be lost where parts of different origin are written as one
NOTHING, ROUNDING = 1e-14, 1e-15


class Part(NamedTuple):
    """amplitude τ^power e^{rate τ} cos(omega τ − phase), τ from the start of its segment; omega 0: no cosine. forced:
    whether a force keeps it up (else it is free motion)."""

    amplitude: float
    power: int
    rate: float
    omega: float
    phase: float
    forced: bool

    def at(self, tau: np.ndarray) -> np.ndarray:
        return (self.amplitude * tau**self.power * np.exp(self.rate * tau)
                * (np.cos(self.omega * tau - self.phase) if self.omega else 1.0))


def regime(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> str:
    """What free motion of one degree of freedom is called: "undamped", "under-damped", "critically damped",
    "over-damped", "relaxation", "rigid", "drag" or "unstable"."""
    from vibcli.analyses.transient.single_degree import poles

    m, c, k = (float(np.ravel(matrix)[0]) for matrix in (M, C, K))
    if not m:
        return "relaxation" if k * c > 0 else "unstable" if k * c < 0 else "drag"
    slow, fast = poles(m, c, k)
    if slow.real > 0 or fast.real > 0:
        return "unstable"
    if not k:
        return "drag" if c else "rigid"
    if not c:
        return "undamped"
    if abs(slow - fast) <= SAME * abs(fast):
        return "critically damped"
    return "under-damped" if slow.imag else "over-damped"


def told_apart(motion: "LinearMotion") -> float:
    """The relative distance within which exponents are one at any time: they are told apart as far as rounding allows
    where every mode has an exponent of its own."""
    return APART if all(len(block.nodes) == 1 for block in motion.blocks) else SAME


def formula(motion: "LinearMotion", output: Any, segment: int = 0, same: float = SAME,
            until: float | None = None) -> list[Part]:
    """The Parts that add up to the output on a segment (−1: the last), free ones first, each kind by ascending
    frequency and decay; `same`: the relative distance within which exponents are one; `until`: up to which instant
    nobody may see that they are two: (e^{λt} − e^{μt})/(λ − μ) is t e^{λt} but for ((λ − μ) t)²/24 of it, while e^{λt}
    itself is e^{μt} but for (λ − μ) t of it."""
    pieces = motion.pieces(0.0 if motion.forcing.period else math.inf)
    terms = pieces.on(output, segment)
    if until is not None:
        every = [node for nodes, _ in terms for node in nodes]
        fastest = max(map(abs, every), default=0.0)
        same = min(same, MERGED / (_seen(every, until) * fastest)) if fastest and until else same
    found = [part for nodes, factor in terms for (node, power), c in fractions(nodes, same).items()
             for part in _straight(*_upper(node, power, factor * c), 0.0 if until is None else same)]
    real, lost = _merged(found, same, until or 0.0)
    if lost > LOST * max((abs(c) * (until or 1.0)**power for (_, power), c in real.items()), default=0.0):
        real, _ = _merged(found, APART, until or 0.0)
    size = max(map(abs, real.values()), default=0.0)
    parts = [_part(node, power, c, power >= _multiplicity(motion.blocks, node, same))
             for (node, power), c in real.items() if abs(c) > NOTHING * size]
    return sorted(parts, key=lambda part: (part.forced, part.omega, -part.rate, part.power))


def _upper(node: complex, power: int, c: complex) -> tuple[complex, int, complex]:
    """The part with the conjugate exponent, of the same real part, where its own lies below the real axis."""
    return (node.conjugate(), power, c.conjugate()) if node.imag < 0 else (node, power, c)


def _seen(nodes: Sequence[complex], until: float | None) -> float | None:
    """Up to which instant a sum of exponentials is more than rounding."""
    slowest = -max(node.real for node in nodes)
    return min(until, DEAD / slowest) if slowest > 0 else until


def _straight(node: complex, power: int, c: complex, same: float) -> list[tuple[complex, int, complex]]:
    """The parts that one is, with a real exponent where nobody sees it turn: Re c e^{iεt} is Re c − ε t Im c."""
    if not 0 < node.imag <= same * abs(node):
        return [(node, power, c)]
    real = complex(node.real)
    return [(real, power, complex(c.real)), (real, power + 1, complex(-c.imag * node.imag))]


def _merged(parts: Sequence[tuple[complex, int, complex]], same: float,
            until: float) -> tuple[dict[tuple[complex, int], complex], float]:
    """({(node, power): c} without what cancels, how much may be lost until an instant) of parts (node, power, c), those
    whose exponents are one added up; the highest powers first, whose exponents are means of two."""
    found, summed, lost = {}, {}, 0.0
    for node, power, c in sorted(parts, key=lambda part: -part[1]):
        key = _known(found, node, power, same)
        gap, above = node - key[0], (key[0], power + 1)
        found[key] = found.get(key, 0j) + c
        summed[key] = summed.get(key, 0.0) + abs(c)
        lost += abs(c) * abs(gap) * until**(power + 1)
        if above in found and not (node.imag or key[0].imag):       # e^{γt} is 1 + γt but for (γt)²/2
            found[above] += c * gap
            lost += abs(c) * abs(gap) * until**(power + 1) * (abs(gap) * until / 2 - 1)
    kept = {(node, power): c for (node, power), c in found.items()
            if abs(c if node.imag else c.real) > ROUNDING * summed[node, power]}
    return kept, lost


def _known(found: Mapping[tuple[complex, int], complex], node: complex, power: int, same: float) -> tuple[complex, int]:
    """The key of an exponential that is there already, or that of a new one; a real one has an exponent that is there
    with another power, so that both are one polynomial in front of it."""
    near = [key for key in found if _same(key[0], node, same)]
    other = near[0][0] if near and not (node.imag or near[0][0].imag) else node
    return next((key for key in near if key[1] == power), (other, power))


def _same(one: complex, two: complex, same: float) -> bool:
    return abs(one - two) <= same * max(abs(one), abs(two))


def _multiplicity(blocks: "Sequence[ModalBlock]", node: complex, same: float) -> int:
    """How often an exponent is an eigenvalue of one block: so many powers of τ are in its free motion."""
    def often(block: "ModalBlock") -> int:
        own = [*block.nodes, *(other.conjugate() for other in block.nodes if block.half)]
        return sum(_same(node, other, same) for other in own)

    return max(map(often, blocks), default=0)


def _part(node: complex, power: int, c: complex, forced: bool) -> Part:
    if node.imag:
        return Part(float(abs(c)), power, node.real, node.imag, -cmath.phase(c) or 0.0, forced)
    return Part(float(c.real), power, node.real, 0.0, 0.0, forced)


def fractions(nodes: Sequence[complex], same: float = SAME) -> dict[tuple[complex, int], complex]:
    """{(λ, k): c} with E[nodes](t) = Σ c tᵏ e^{λt}: the partial fractions of 1/Π(p − λ), nearly equal nodes as one."""
    groups = []
    for node in nodes:
        near = next((group for group in groups if _same(group[0], node, same)), None)
        groups.append([node]) if near is None else near.append(node)
    found = {}
    for group in groups:
        mean = sum(group) / len(group)
        others = [sum(other) / len(other) for other in groups if other is not group for _ in other]
        for k, c in enumerate(expanded(mean, len(group), others)):
            found[mean, k] = c
    return found


def expanded(node: Any, count: int, others: Any) -> list[complex]:
    """[c] of the Σ c tᵏ e^{λt} that a node λ so many times adds beside others: a Taylor series of 1/Π(p − other)."""
    series = np.eye(1, count, dtype=complex)[0]
    for other in others:
        gap = node - other
        series = np.convolve(series, (-1 / gap) ** np.arange(count) / gap)[:count]
    return [complex(c) / math.factorial(k) for k, c in enumerate(series[::-1])]
