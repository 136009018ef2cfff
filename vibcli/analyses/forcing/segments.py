"""Forcing as the response methods take it: piecewise sums of polynomials times exponentials.

On each segment a channel is f(τ) = Σ Re(c τᵏ e^{sτ}), τ = t − start: steps, ramps, harmonics, pulses, decaying sines
and all their products. Counting from the start of the segment keeps a 5 ms pulse at t = 50 s exact.
"""

from math import inf
from typing import NamedTuple

from vibcli.errors import PhysicsError

MOST = 100_000      # segments of a periodic forcing


class Wave(NamedTuple):
    """Re(c τᵏ e^{sτ}) on one channel: c complex, k an integer, s complex [1/s]."""

    channel: int
    coefficient: complex
    power: int
    exponent: complex


class Segment(NamedTuple):
    """Waves from `start` to the start of the next segment; `impulses`: (channel, size) pairs that act at `start`."""

    start: float
    waves: tuple = ()
    impulses: tuple = ()


class Forcing:
    """Segments in order of time, the first from 0 on; of periodic forcing those of the first period, repeated from
    `since` + `period` on (None: not periodic). `channels`: how many there are."""

    __slots__ = ("channels", "period", "pieces", "since")

    def __init__(self, channels, pieces, period=None, since=0.0):
        self.channels, self.pieces, self.period, self.since = channels, tuple(pieces), period, since

    @property
    def listed(self):
        """Are its segments so many that all can be told?"""
        return self.period is None

    @property
    def turn(self):
        """The longest time after which something of it repeats for ever; None where nothing does."""
        return self.period

    def segments(self, until):
        """The segments that start before `until`."""
        found = [piece for piece in self.pieces if piece.start < until or not piece.start]
        if self.period is None:
            return found
        if (until - self.since) * len(self.pieces) > MOST * self.period:
            raise PhysicsError("this periodic load repeats itself too often to be followed for so long",
                               f"ask for an instant before t = {MOST * self.period / len(self.pieces):.3g} s")
        repeated = [piece for piece in self.pieces if piece.start >= self.since]
        turns = 1
        while self.since + turns * self.period < until:
            shift = turns * self.period
            found += [piece._replace(start=piece.start + shift) for piece in repeated if piece.start + shift < until]
            turns += 1
        return found


class Irregular:
    """Forcing that repeats for ever in parts, but has no period as a whole: known as far as it is asked for.

    `build(until)`: its segments up to a time at least; `turn`: the longest period of a part; `refusal`: why what needs
    all of it is not found.
    """

    period, listed = None, False

    def __init__(self, channels, build, turn, refusal):
        self.channels, self.build, self.turn, self.refusal = channels, build, turn, refusal

    def segments(self, until):
        """The segments that start before `until`; PhysicsError where that is infinite."""
        if until == inf:
            raise self.refusal
        return [piece for piece in self.build(until) if piece.start < until or not piece.start]
