"""Pieces of forcing counted from other times, and the difference of two."""

import cmath
import math
from collections.abc import Sequence

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave


def later(wave: Wave, by: float) -> tuple[Wave, ...]:
    """The waves in τ' = τ − by that make up one in τ: Re(c (τ' + by)ᵏ e^{s(τ' + by)})."""
    c, k = wave.coefficient * _exponential(wave.exponent * by), wave.power
    if not by:
        return (wave,)
    return tuple(Wave(wave.channel, c * math.comb(k, j) * by ** (k - j), j, wave.exponent) for j in range(k + 1))


def _exponential(x: complex) -> complex:
    """e^x of a complex number of Python or of mpmath."""
    if not hasattr(x, "_mpc_"):
        return cmath.exp(x)
    import mpmath

    found: complex = mpmath.exp(x)
    return found


def running(pieces: Sequence[Segment], time: float) -> Segment:
    """The piece that runs at a time, its waves counted from there, without its impulses."""
    piece = max((piece for piece in pieces if piece.start <= time), key=lambda piece: piece.start)
    return Segment(time, tuple(part for wave in piece.waves for part in later(wave, time - piece.start)))


def difference(pieces: Sequence[Segment], others: Sequence[Segment], until: float) -> list[Segment]:
    """pieces − others as pieces that start before `until`."""
    impulses = {}
    for sign, some in ((1, pieces), (-1, others)):
        for piece in some:
            impulses.setdefault(piece.start, []).extend((channel, sign * size) for channel, size in piece.impulses)
    found = []
    for start in sorted(start for start in impulses if start < until):
        less = (wave._replace(coefficient=-wave.coefficient) for wave in running(others, start).waves)
        found.append(Segment(start, (*running(pieces, start).waves, *less), tuple(impulses[start])))
    return found


def turned(forcing: Forcing) -> list[Segment]:
    """The pieces of one period of periodic forcing, counted from t = 0 as if it had always run."""
    first = forcing.since % forcing.period
    pieces = [piece for piece in forcing.pieces if piece.start >= forcing.since]
    moved = [piece._replace(start=(piece.start - forcing.since + first) % forcing.period) for piece in pieces]
    moved.sort(key=lambda piece: piece.start)
    if not moved[0].start:
        return moved
    last = moved[-1]
    waves = (part for wave in last.waves for part in later(wave, forcing.period - last.start))
    return [Segment(0.0, tuple(waves)), *moved]
