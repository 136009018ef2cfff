"""Where each natural frequency lies, certain by counts: z₁ ≤ z < z₂ with J(z₁) < i ≤ J(z₂)."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.counting import count
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import counted

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.continuous.system import ContinuousSystem

LONGEST = 200       # steps down to where nothing grows as fast
LADDER = 4.0        # steps in z up to where enough frequencies lie below,
MANY, NARROW = 256, 1.1     # modes, whose first and last are looked for first: z within which they lie then
RUNGS, FINE = 12, 40        # so many at once where arrays cost no more than numbers; so many between them at least
SLACK = 1e4         # of counts that only have to part frequencies
SWEEPS = 400
SPLITS = 0.5, 0.382, 0.618, 0.45, 0.55      # where brackets are parted in turn, so that an unknown count is left
FLAT = 1e-40        # of what is natural to the system: a z as small is zero


class Bracket(NamedTuple):
    """low, high: z; below: J at low, above: J at high, both certain; pole: lies a frequency of a held piece within?"""

    low: Any
    high: Any
    below: int
    above: int
    pole: bool

    @property
    def single(self) -> bool:
        """Is there one frequency within?"""
        return self.above == self.below + 1


class KnownCounts:
    """What is known of J: z ascending, lower and upper bounds of J, Σ J₀."""

    def __init__(self, system: "ContinuousSystem") -> None:
        self.system, self.scale = system, system.scale
        self.met: set[Any] = set()
        self.z = np.zeros(0, float if system.digits is None else object)
        self.below = self.above = self.held = np.zeros(0, int)
        self._least = self._most = np.zeros(0, int)

    def add(self, z: Any) -> None:
        """Counts at further z."""
        counted(len(z))
        self.met.update(z)
        found = count(self.system, self.system.numbers(z), SLACK)
        self._merge(z, found.below, found.above, found.held.sum(axis=0))

    def known(self, z: Any, J: int) -> None:
        """A J that follows from structure, where z is no pole."""
        self._merge([self.system.number(z)], [J], [J], [J])

    def _merge(self, z: "list[float | mpmath.mpf] | np.ndarray", below: list[int] | np.ndarray,
               above: list[int] | np.ndarray, held: list[int] | np.ndarray) -> None:
        """What lies below all of these stays where it is."""
        z = np.array([*z], self.z.dtype)
        kept = int(self.z.searchsorted(z.min()))
        order = np.argsort(np.append(self.z[kept:], z), kind="stable")
        self.z, self.below, self.above, self.held = (
            np.concatenate([old[:kept], np.append(old[kept:], new)[order]]) for old, new in (
                (self.z, z), (self.below, below), (self.above, above), (self.held, held)))
        least = np.minimum.accumulate(self.above[kept:][::-1])[::-1]
        most = np.maximum.accumulate(self.below[kept:])
        self._least = np.append(np.minimum(self._least[:kept], least[0]), least)            # of `above` from each z on
        self._most = np.append(self._most[:kept], np.maximum(most, self._most[:kept][-1:]) if kept else most)

    def bracket(self, index: int) -> Bracket | None:
        """The narrowest of the frequency of this index; None where J is not known far enough."""
        i, j = int(self._least.searchsorted(index)) - 1, int(self._most.searchsorted(index))
        if i < 0 or j == len(self.z):
            return None
        low, high = self.z.item(i), self.z.item(j)
        return Bracket(low, high, int(self.above[i]), int(self.below[j]), self.held[i] != self.held[j])


class Ground(NamedTuple):
    """growing: how many z are negative; rigid: how many are zero, from structure."""

    growing: int
    rigid: int

    @property
    def resting(self) -> int:
        """How many do not oscillate."""
        return self.growing + self.rigid


def ground(counts: KnownCounts, rigid: int, never_grows: bool) -> Ground | None:
    """The Ground; None where z are so close to zero that this arithmetic does not tell their sign."""
    if never_grows:
        counts.known(0, rigid)
        return Ground(0, rigid)
    system, near = counts.system, counts.scale * LADDER ** -2
    closest = counts.scale * system.closest
    while near > closest:
        found = count(system, system.numbers([-near, near]))
        if found.above[0] + rigid == found.below[1]:
            counts.add([-near, near])
            return Ground(int(found.above[0]), rigid)
        near = near / LADDER ** 4
    return None


def flat(counts: KnownCounts) -> Bracket | None:
    """What lies so close to z = 0 that it is taken for zero; None where not even that is told."""
    system, near = counts.system, counts.scale * counts.system.closest
    found = count(system, system.numbers([-near, near]))
    if (found.below != found.above).any():
        return None
    return Bracket(-near, near, int(found.above[0]), int(found.below[1]), False)


def reached(counts: KnownCounts, first: int, last: int) -> None:
    """Adds counts down to where fewer than `first`, and up to where `last` frequencies lie below."""
    step = top = counts.scale
    while not len(counts.above) or counts.above.min() >= first:
        counts.add([-step])
        step *= LADDER ** 2
        if len(counts.z) > LONGEST:
            raise PhysicsError("what grows has no end: a coordinate without inertia has a negative stiffness",
                               "give what it moves a mass or inertia")
    while not len(counts.below) or counts.below.max() < last:
        steps = RUNGS if _in_arrays(counts.system) else 1
        counts.add([top * LADDER**k for k in range(steps)])
        top *= LADDER**steps
    if last - first > MANY:
        parted(counts, [first, last], lambda bracket: 0 < bracket.high < NARROW * bracket.low)
    if last - first > 4 and counts.below.max() > last // 2:
        ends = int(np.argmax(counts.below >= last)), int(np.sum(counts.above < first)) - 1
        top, low = map(counts.z.item, ends)
        least = float(max(low / top, 0)) ** 0.5 if last - first > MANY else 0.0
        many = max(3 * (last - first), FINE if _in_arrays(counts.system) else 0)
        share = counts.system.numbers(np.linspace(least, 1, many + 1)[1:-1])
        counts.add(top * share * share)


def _in_arrays(system: "ContinuousSystem") -> bool:
    """Are several counts as dear as one: doubles, and nothing that is summed one piece at a time?"""
    return system.digits is None and not any(placed.piece.gradient for placed in system.pieces)


def parted(counts: KnownCounts, indices: Any, finished: Any) -> dict[int, Bracket]:
    """Brackets of the indices, halved until finished(bracket) or nothing more is told apart."""
    found, open_, flat = {}, list(indices), counts.scale * FLAT
    for sweep in range(SWEEPS):
        middles, left = {}, []
        for index in open_:
            bracket = counts.bracket(index)
            if bracket is None:
                continue
            found[index] = bracket
            middle = between(bracket.low, bracket.high, SPLITS[sweep % len(SPLITS)], sweep)
            known = middle in counts.met and middle not in middles
            if finished(bracket) or abs(middle) < flat or known or not bracket.low < middle < bracket.high:
                continue
            left.append(index)
            middles[middle] = None
        if not left:
            break
        open_ = left
        counts.add(list(middles))
    return found


def between(low: Any, high: Any, share: float, sweep: int) -> Any:
    """A z within a bracket: far from zero by ratio where the bracket is wide."""
    if low < 0 < high:
        return (high if (sweep % 2 and high) else low) / 64
    if low * 4 < high and low >= 0:
        return high / 16 if low == 0 else low * (high / low) ** share
    if high * 4 > low and high <= 0:
        return low / 16 if high == 0 else high * (low / high) ** share
    return low + (high - low) * share
