"""The period of what repeats for ever: the least common multiple of the periods of its parts, or a part of that."""

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.excitation.assembly import WaveGroup
    from vibcli.analyses.excitation.forcing import Segment

TURNS, ALIKE = 1000, Fraction(1, 10**9)
PARTS = (2, 3, 5, 7)
INSTANTS = "ask for its values at instants, or for max(x) and min(x)"


def common_period(groups: "Sequence[WaveGroup]", numbers: type[Any]) -> Fraction:
    """The period of all that lasts for ever; PhysicsError where there is none."""
    periods = []
    for group in groups:
        r, w, *_ = group.wave
        if r or len(group.ps[-1]) > 1:
            raise PhysicsError("a wave repeats for ever beside a load that grows or decays: the motion never "
                               "repeats itself", INSTANTS)
        periods += [gate.period for gate in group.gates] + ([2 * numbers.pi / w] if w else [])
    above, below = 1, 0
    for period in periods:
        ratio = (period / periods[0]).limit_denominator(TURNS)
        if not ratio or abs(period - ratio * periods[0]) > ALIKE * period:
            break
        above, below = lcm(above, ratio.numerator), gcd(below, ratio.denominator)
        if above > TURNS * below:
            break
    else:
        found: Fraction = periods[0] * Fraction(above, below)
        return found
    raise PhysicsError("the periods of what drives this scene have no common multiple: the motion never repeats itself",
                       INSTANTS)


def shortest(pieces: "Sequence[Segment]", period: "float | mpmath.mpf", since: "float | mpmath.mpf",
             same: Fraction) -> "tuple[Sequence[Segment], float | mpmath.mpf]":
    """(pieces, period) of the shortest period: |sin| repeats after half a turn."""
    for part in PARTS:
        while True:
            repeated = [piece for piece in pieces if piece.start >= since]
            n = len(repeated) // part
            if len(repeated) % part or not all(_alike(one, other, period / part, same * period)
                                               for one, other in zip(repeated, repeated[n:], strict=False)):
                break
            pieces, period = [piece for piece in pieces if piece.start < since] + repeated[:n], period / part
    return pieces, period


def _alike(one: "Segment", other: "Segment", shift: "float | mpmath.mpf", same: "float | mpmath.mpf") -> bool:
    """Is a piece the same as the one before it, later by `shift`?"""
    if abs(other.start - one.start - shift) > float(same) or len(one.impulses) != len(other.impulses):
        return False
    size = max((abs(wave.coefficient) for wave in one.waves), default=0)
    found = {}
    for sign, piece in ((1, one), (-1, other)):
        for channel, c, k, s in piece.waves:
            found[channel, k, s] = found.get((channel, k, s), 0) + sign * c
    blows = dict(one.impulses)
    return all(abs(c) <= float(ALIKE * size) for c in found.values()) and all(
        abs(blows.get(channel, 0) - blow) <= float(ALIKE * abs(blow)) for channel, blow in other.impulses)
