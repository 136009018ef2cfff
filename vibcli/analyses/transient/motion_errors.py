"""First-order bounds of the error of a linear motion: of its values at any instant.

With ε the error of c, δA that of the equations (block_perturbation.py), δs that of the exponent of a wave,

    ε(t) = |e^{B(t − t₀)}| ε(t₀) + ∫ |e^{B(t − s)}| (|δA| |c| + |W| |δf|) ds + rounding

Each part of c is a divided difference E[…], and the integral one with further nodes: its bound grows with the time
where a wave is near resonance, stays where it is not, and fades with what is damped. From segment to segment of the
loads ε is carried on as c is. Rounding is counted by the sizes of the terms that are added, not by their sum.
"""

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.block_perturbation import BlockPerturbation
from vibcli.analyses.transient.data_errors import DATA
from vibcli.analyses.transient.forced import marched
from vibcli.analyses.transient.largest_differences import largest_differences
from vibcli.analyses.transient.markov_parameters import direct, markov
from vibcli.analyses.transient.textbook_form import APART
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.forcing_arrays import Timeline
    from vibcli.analyses.transient.pieces import Pieces

EPSILON = 2.0**-52
ROUNDINGS = 8       # of a term, in units of EPSILON
FEW = 4             # instants whose factors are kept for a while
BUCKET = 2.0        # lengths of segments within such a ratio are looked at together


class Drawn(NamedTuple):
    """Parts of c that are alike: the exponent of their wave as often as it counts (none: free motion), its power, the
    segments they are in, |amplitude| and the size of what that was added from, (P, segments)."""

    tail: tuple[complex, ...]
    power: int
    at: np.ndarray
    amplitude: np.ndarray
    size: np.ndarray


class MotionErrors:
    """Of the motion up to a time that Pieces hold."""

    def __init__(self, pieces: "Pieces") -> None:
        self.pieces, self.motion, self.timeline = pieces, pieces.motion, pieces.timeline
        self.known: dict[float, np.ndarray] = {}
        self._factors: dict[tuple[Any, ...], np.ndarray] = {}
        self.count = sum(len(block.B) for block in self.motion.blocks)
        if self.count:
            self.system = BlockPerturbation(self.motion.blocks, self.motion.matrices[:3], self.motion.data_errors)
            self._chain()
            with np.errstate(all="ignore"):
                self.starts = self._carried()

    def of(self, output: "LinearOutput", times: np.ndarray, order: int = 0) -> np.ndarray:
        """Bounds of the error of the order-th derivative of an output at instants."""
        times = np.asarray(times, float)
        with np.errstate(all="ignore"):
            found = self._direct(output, times, order)
            if self.count:
                found = found + self._moving(output, times, order)
        if output.constant and not order and self.motion.constants:
            found = found + 4 * DATA * abs(output.constant)
        if not order and self.motion.constants:
            found = found + self.motion.data_errors.of_rest(output)
        return found

    def of_free(self, output: "LinearOutput", j: int) -> float:
        """Of the amplitude of the free vibration of a block that stands alone, at the start of the last segment: of c
        less what the loads keep up."""
        row = np.concatenate([block.rows(output, 0) for block in self.motion.blocks])
        rounded = sum(abs(x) * self.system.power(k)[1][i, j] for k, part in enumerate((output.q, output.v, output.a))
                      for i, x in part.items())
        node, off = self.system.B[j, j], 0.0
        (_, parts), (last,) = self._near(np.array([len(self.timeline.starts) - 1]))
        for part in parts:
            place = np.flatnonzero(part.at == last)
            if len(place) and part.tail:
                gap = abs(part.tail[0] - node)
                moved = (self.system.dA[j, j] + DATA * abs(part.tail[0])) / gap
                off += math.factorial(part.power) * part.size[j, place[0]] / gap ** (part.power + 1) * (
                    2 * ROUNDINGS * EPSILON + (part.power + 1) * moved)
        state = abs(self.pieces.states[next(k for k, at in enumerate(self.system.places) if at.start == j)][-1, 0])
        start = self._started(np.array([len(self.timeline.starts) - 1]))[j, 0]
        return float(abs(row[j]) * (start + off) + self._turned(row, j)
                     + 2 * ROUNDINGS * EPSILON * rounded * state)

    def _turned(self, row: np.ndarray, j: int) -> float:
        """Of the same amplitude, what its shape takes of neighbours and these of it: δA over the distance of the
        eigenvalues; those that are one but for rounding turn within what both span."""
        diagonal = self.system.B.diagonal()
        gaps = np.abs(diagonal - diagonal[j])
        gaps[gaps <= APART * np.abs(diagonal[j])] = np.inf
        c = np.abs(np.concatenate([states[-1] for states in self.pieces.states]))
        dA = self.system.dA
        return float((np.abs(row) * dA[:, j] / gaps).sum() * c[j] + abs(row[j]) * (dA[j] * c / gaps).sum())

    def _moving(self, output: "LinearOutput", times: np.ndarray, order: int) -> np.ndarray:
        """What c brings."""
        errors, sizes, rates = self._at(times)
        row = np.concatenate([block.rows(output, order) for block in self.motion.blocks])
        rounded, jolt = np.zeros(self.count), np.zeros(len(times))
        for lead, coefficients in enumerate((output.q, output.v, output.a)):
            total = order + lead
            for i, x in coefficients.items():
                rounded += abs(x) * self.system.power(total)[1][i]
                for m in range(total - 1):
                    kept, moved = self.system.power(total - 1 - m)[0][i], sizes
                    for _ in range(m):
                        moved = np.abs(self.system.B) @ moved
                    jolt += abs(x) * (np.abs(kept) @ (self.system.dA @ moved))
        late, size = EPSILON / 2 * (times + self.timeline.starts[self.timeline.place(times)[0]]), np.abs(row)
        found: np.ndarray = size @ errors + (2 * ROUNDINGS * EPSILON * rounded) @ sizes + jolt + late * (size @ rates)
        return found

    def _direct(self, output: "LinearOutput", times: np.ndarray, order: int) -> np.ndarray:
        """What the forces bring at once."""
        motion, found = self.motion, np.zeros(len(times))
        if not (output.a or output.channels or (order and output.v) or order > 1 or motion.system is not None):
            return found
        segment, tau = self.timeline.place(times)
        (timeline, _), local = self._near(segment)
        H = [np.abs(part) for part in markov(motion, order + 2)]
        q, v, a = ({i: abs(x) for i, x in row.items()} for row in (output.q, output.v, output.a))
        large = output._replace(q=q, v=v, a=a)
        for i, row in direct(large, order, H, motion.forcing.channels).items():
            for waves in timeline.waves:
                inside = np.isin(local, waves.at)
                if not inside.any():
                    continue
                size = waves.size(row[None])[0, np.searchsorted(waves.at, local[inside])]
                s, here = waves.exponent, tau[inside]
                grown = sum(abs(factor) * here**power for power, factor in waves.derivative(i).items())
                off = 2 * ROUNDINGS * EPSILON + abs(s) * (2 * DATA * here + EPSILON * times[inside])
                found[inside] += size * grown * np.exp(s.real * here) * off
        return found

    def _at(self, times: np.ndarray) -> np.ndarray:
        """(ε, the size of what c is added from, and of its rate) at instants, (P, T) each."""
        missing = [t for t in dict.fromkeys(times.tolist()) if t not in self.known]
        if missing:
            self._factors = {}
            segment, tau = self.timeline.place(np.array(missing))
            found = np.zeros((3, self.count, len(missing)))
            (_, parts), local = self._near(segment)
            for part in parts:
                inside = np.flatnonzero(np.isin(local, part.at))
                if len(inside):
                    here, place = tau[inside], np.searchsorted(part.at, local[inside])
                    found[:, :, inside] += self._brought(part, place, here, here, np.arange(len(inside)))
            found[0] += np.einsum("tij,jt->it", self._exponential((), tau, tau), self._started(segment))
            self.known |= {t: found[:, :, k] for k, t in enumerate(missing)}
        return np.stack([self.known[t] for t in times.tolist()], axis=2)

    @cached_property
    def parts(self) -> list[Drawn]:
        """Those of all segments."""
        return self._parts(self.timeline, self.pieces.states)

    def _near(self, segment: np.ndarray) -> "tuple[tuple[Timeline, list[Drawn]], np.ndarray]":
        """((a timeline with these segments, its parts), their numbers in it)."""
        return (self.timeline, self.parts), segment

    def _started(self, segment: np.ndarray) -> np.ndarray:
        """ε at the starts of segments."""
        return self.starts[:, segment]

    def _parts(self, timeline: "Timeline", states: Sequence[np.ndarray]) -> list[Drawn]:
        return [self._free(states), *self._driven(timeline)] if self.count else []

    def _brought(self, part: Drawn, place: np.ndarray, early: np.ndarray, late: np.ndarray,
                 which: np.ndarray) -> np.ndarray:
        """(ε that a part brings, the sizes of c and of its rate) in intervals of time after the starts of its segments;
        place: of these among those of the part; which: of the intervals each has."""
        factor = math.factorial(part.power)
        gains = self._gains(part.tail, early, late)
        found = np.empty((3, self.count, len(place)))
        for k in range(len(early)):
            mine = which == k
            size = factor * part.size[:, place[mine]]
            found[0][:, mine] = gains[0][k] @ (factor * part.amplitude[:, place[mine]])
            found[1][:, mine] = gains[1][k] @ size
            found[2][:, mine] = gains[2][k] @ size
        found[0] += ROUNDINGS * EPSILON * found[1]
        return found

    def _chain(self) -> None:
        """All ways by which what one block does reaches another through δA, by the number of nodes on them: {m: (nodes
        (N, m), weights, places i·P + j)}."""
        found: dict[int, list[tuple[Any, ...]]] = {}
        ways, dA = self.system.ways, self.system.dA
        for i, k, product, nodes in ways:
            for first, j, other, further in ways:
                weight = product * dA[k, first] * other
                if weight:
                    rows = found.setdefault(len(nodes) + len(further), [])
                    rows.append((nodes + further, weight, i * self.count + j))
        self.chains = [tuple(map(np.array, zip(*rows, strict=True))) for rows in found.values()]
        plain: dict[int, list[tuple[Any, ...]]] = {}
        for i, j, product, nodes in ways:
            plain.setdefault(len(nodes), []).append((nodes, product, i * self.count + j))
        self.plain = [tuple(map(np.array, zip(*rows, strict=True))) for rows in plain.values()]

    def _gains(self, tail: tuple[complex, ...], early: np.ndarray,
               late: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(what δA and δs add to each c for each amplitude; |e^{Bτ}| with the tail; its rate), (U, P, P) on intervals
        of time. The rate of E[nodes, s] is s E[nodes, s] + E[nodes]."""
        plain = self._exponential(tail, early, late)
        perturbed = self._summed(self.chains, tail, early, late)
        rate = np.abs(self.system.B) @ plain
        if tail:
            perturbed *= 2.0        # far from resonance both halves of a pair count
            off = (DATA + 2 * EPSILON) * abs(tail[0]) * len(tail)
            perturbed += off * self._exponential((*tail, tail[0]), early, late)
            rate = np.minimum(rate + np.eye(self.count) * (len(tail) == 1),
                              abs(tail[0]) * plain + self._exponential(tail[1:], early, late))
        return perturbed, plain, rate

    def _exponential(self, tail: tuple[complex, ...], early: np.ndarray, late: np.ndarray) -> np.ndarray:
        """|e^{Bτ}| with a tail on intervals, (U, P, P), of few once for all that is asked about the same instants."""
        if len(early) > FEW:
            return self._summed(self.plain, tail, early, late)
        key = tail, early.tobytes(), late.tobytes()
        if key not in self._factors:
            self._factors[key] = self._summed(self.plain, tail, early, late)
        return self._factors[key]

    def _summed(self, rows: Sequence[tuple[np.ndarray, ...]], tail: tuple[complex, ...],
                early: np.ndarray, late: np.ndarray) -> np.ndarray:
        total = np.zeros((len(early), self.count**2))
        for nodes, weights, places in rows:
            whole = np.concatenate([nodes, np.broadcast_to(np.array(tail, complex), (len(nodes), len(tail)))], axis=1)
            bounds = weights[:, None] * largest_differences(whole, early, late)
            for k in range(len(early)):
                total[k] += np.bincount(places, bounds[:, k], self.count**2)
        return total.reshape(-1, self.count, self.count)

    def _free(self, states: Sequence[np.ndarray]) -> Drawn:
        sizes = np.abs(np.concatenate(states, axis=1)).T
        return Drawn((), 0, np.arange(sizes.shape[1]), sizes, sizes)

    def _driven(self, timeline: "Timeline") -> Iterator[Drawn]:
        """The Drawn of each wave."""
        for waves in timeline.waves:
            if waves.pushes(len(self.motion.M)):
                given, size = waves.size(self.system.W, largest=True), waves.size(self.system.W)
                yield Drawn((waves.exponent,) * (waves.power + 1), waves.power, waves.at, given, size)

    def _carried(self) -> np.ndarray:
        """ε at the start of every segment, (P, segments)."""
        lengths, buckets = buckets_of(self.timeline.lengths[:-1])
        last, first, added = len(self.timeline.starts) - 1, self._first(), self._struck(self.timeline)
        if last:
            for part in self.parts:
                place = np.flatnonzero(part.at < last)
                at = part.at[place]
                added[:, at + 1] += self._brought(part, place, *lengths, buckets[at])[0]
        step = self._summed(self.plain, (), *lengths)[buckets] if last else np.zeros((0, self.count, self.count))
        found = np.empty_like(added)
        for rows in self.system.places:
            found[rows] = marched(step[:, rows, rows], added[rows].T.copy(), first[rows]).T
        return found

    def _first(self) -> np.ndarray:
        """ε at the start."""
        data, motion = self.motion.data_errors, self.motion
        P, R = (np.abs(np.concatenate([getattr(block, kind) for block in motion.blocks])) for kind in "PR")
        found: np.ndarray = P @ (data.q0 + 4 * EPSILON * np.abs(motion.q0))
        found += R @ (data.v0 + 4 * EPSILON * np.abs(motion.v0))
        return found

    def _struck(self, timeline: "Timeline") -> np.ndarray:
        """What blows, and loads that jump or bend at instants that are rounded, add at the starts of segments."""
        late = EPSILON * timeline.starts
        found: np.ndarray = np.abs(self.system.W) @ (4 * EPSILON * np.abs(timeline.impulses[:, :len(self.motion.M)])).T
        for waves in timeline.waves:
            size = waves.size(self.system.W)
            lengths = np.where(np.isfinite(timeline.lengths[waves.at]), timeline.lengths[waves.at], 0.0)
            if not waves.power:
                found[:, waves.at] += 2 * late[waves.at] * size
            after = waves.at + 1
            kept = after < len(late)
            grown = lengths**waves.power * np.exp(np.maximum(waves.exponent.real * lengths, 0.0))
            found[:, after[kept]] += 2 * late[after[kept]] * grown[kept] * size[:, kept]
        return found


def buckets_of(lengths: np.ndarray) -> tuple[list[np.ndarray], np.ndarray]:
    """([shortest, longest of each bucket], the bucket of each length): lengths within a ratio."""
    marks, buckets = np.unique(np.floor(np.log2(lengths) / math.log2(BUCKET)), return_inverse=True)
    ends = [np.array([choose(lengths[buckets == k]) for k in range(len(marks))]) for choose in (np.min, np.max)]
    return ends, buckets
