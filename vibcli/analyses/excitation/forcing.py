"""Forcing as the response methods take it: piecewise sums of polynomials times exponentials.

On each segment a channel is f(τ) = Σ Re(c τᵏ e^{sτ}), τ = t − start: steps, ramps, harmonics, pulses, decaying sines
and all their products. Counting from the start of the segment keeps a 5 ms pulse at t = 50 s exact.
"""

from collections.abc import Callable, Sequence
from math import ceil, inf, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import Work

if TYPE_CHECKING:
    from contextlib import AbstractContextManager
    from fractions import Fraction

    from vibcli.base.work import Task

MOST = 100_000      # segments


class TooOften(PhysicsError):
    """There are more segments than may be followed."""


def task_of(work: Work | None, count: "float | Fraction", ask: str = "ask for an earlier instant",
            most: int | None = None) -> "AbstractContextManager[Task, bool | None]":
    """The task of finding so many segments; TooOften where they are more than the most. ask: what helps then."""
    work, count, most = work or Work(), float(count), MOST if most is None else most
    if count > most * work.patience:
        more = f"; --patience {ceil(2 * count / most)} allows twice as many" if count < inf else ""
        known = f": {count:.6g} stretches of time, and {most * work.patience:.0f} are the most" if count < inf else ""
        raise TooOften(f"what drives this scene jumps or bends too often to be followed for so long{known}", ask + more)
    return work.task("what drives the motion", most)


class Wave(NamedTuple):
    """Re(c τᵏ e^{sτ}) on one channel: c complex, k an integer, s complex [1/s]."""

    channel: int
    coefficient: complex
    power: int
    exponent: complex


class Segment(NamedTuple):
    """Waves from `start` to the start of the next segment; `impulses`: (channel, size) pairs that act at `start`."""

    start: float
    waves: tuple[Wave, ...] = ()
    impulses: tuple[tuple[int, Any], ...] = ()


def oscillates(forcing: "Forcing") -> bool:
    """Do loads that are no repeated pieces oscillate without end?"""
    return any(wave.exponent.imag and not wave.exponent.real and wave.coefficient for wave in forcing.last.waves)


class Forcing:
    """Segments in order of time, the first from 0 on; of periodic forcing those of the first period, repeated from
    `since` + `period` on (None: not periodic). `channels`: how many there are; `listed`: are its segments so many that
    all can be told? `turn`: the longest time after which something of it repeats for ever; None where nothing does;
    `recorded`: is it held as arrays (recorded_forcing.py)?"""

    recorded = False

    __slots__ = ("channels", "listed", "period", "pieces", "since", "turn")

    def __init__(self, channels: int, pieces: Sequence[Segment], period: Any = None, since: float = 0.0) -> None:
        self.channels, self.pieces, self.since = channels, tuple(pieces), since
        self.period, self.turn, self.listed = period, period, period is None

    @property
    def last(self) -> Segment:
        """The last segment of those that are not repeated."""
        return self.pieces[-1]

    @property
    def speeds(self) -> set[float]:
        """The angular frequencies in it, of what repeats that of the longest turn."""
        if self.turn is not None:
            return {tau / self.turn}
        return {abs(wave.exponent.imag) for piece in self.pieces for wave in piece.waves} - {0.0}

    def segments(self, until: float, work: Work | None = None) -> list[Segment]:
        """The segments that start before `until`; work: what counts them."""
        found = [piece for piece in self.pieces if piece.start < until or not piece.start]
        if self.period is None:
            return found
        repeated = [piece for piece in self.pieces if piece.start >= self.since]
        count = max(0.0, until - self.since) * len(repeated) / self.period
        turns, most = 1, MOST * (1 if work is None else work.patience)
        before = self.since + 0.99 * most * self.period / len(repeated)
        with task_of(work, count, f"ask for an instant before t = {float(before):.3g} s") as task:
            while self.since + turns * self.period < until:
                shift = turns * self.period
                task.step(turns * len(repeated) / count, len(repeated) / 2)
                found += [piece._replace(start=piece.start + shift) for piece in repeated
                          if piece.start + shift < until]
                turns += 1
        return found


class Irregular:
    """Forcing that repeats for ever in parts, but has no period as a whole: known as far as it is asked for.

    `build(until, work)`: its segments up to a time at least; `turn`: the longest period of a part; `refusal`: why what
    needs all of it is not found.
    """

    period, listed, recorded = None, False, False

    def __init__(self, channels: int, build: Callable[[float, Work | None], list[Segment]], turn: float,
                 refusal: PhysicsError) -> None:
        self.channels, self.build, self.turn, self.refusal = channels, build, turn, refusal

    @property
    def last(self) -> Segment:
        raise self.refusal

    @property
    def speeds(self) -> set[float]:
        """The angular frequency of the longest turn."""
        return {tau / self.turn}

    def segments(self, until: float, work: Work | None = None) -> list[Segment]:
        """The segments that start before `until`; PhysicsError where that is infinite."""
        if until == inf:
            raise self.refusal
        return [piece for piece in self.build(until, work) if piece.start < until or not piece.start]
