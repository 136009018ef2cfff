"""The impulses of exact sums: each with what stands beside it at its instant."""

from bisect import bisect_left
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.analyses.excitation.piecewise_linear import Instant
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.excitation.assembly import WaveGroup
    from vibcli.analyses.excitation.exponential_polynomials import ExactWave

ALIKE = Fraction(1, 10**9)


def blows_of(groups: "Sequence[WaveGroup]", cuts: Sequence[Fraction], last: Fraction,
             numbers: type[Any]) -> dict[Any, Any]:
    """{number of a segment: {channel: size}} of the impulses from the first cut on, before `last`."""
    found = {}
    for group in groups:
        for gate in group.gates:
            others = [other for other in group.gates if other is not gate]
            for instant, size in gate.impulses(cuts[0], last):
                i = nearest(cuts, instant)
                if last - instant > numbers.same * last and abs(cuts[i] - instant) <= 2 * numbers.same * instant:
                    amount = size * _beside(group, others, instant, _reach(cuts, i, last), numbers)
                    if amount:
                        at = found.setdefault(i, {})
                        at[group.channel] = at.get(group.channel, 0) + _sized(group.wave, instant, amount, numbers)
    return found


def nearest(cuts: Sequence[Fraction], instant: Fraction | int) -> int:
    i = bisect_left(cuts, instant)
    near = [j for j in (i - 1, i) if 0 <= j < len(cuts)]
    return min(near, key=lambda j: abs(cuts[j] - instant))


def _reach(cuts: Sequence[Fraction], i: int, last: Fraction) -> Fraction:
    """Half of the shorter segment beside a cut."""
    after = cuts[i + 1] if i + 1 < len(cuts) else last
    return (min(after - cuts[i], cuts[i] - cuts[i - 1]) if i else after - cuts[i]) / 2


def _beside(group: "WaveGroup", others: list[Any], instant: Fraction, reach: Fraction, numbers: type[Any]) -> Fraction:
    """The polynomial and the other gates at an instant: the same before and after it, or their product with an impulse
    is not defined."""
    before, after = (_product(group, others, Instant(None, instant, numbers.number(middle), middle))
                     for middle in (instant - reach, instant + reach))
    together = any(other.impulses(instant - reach, instant + reach) for other in others)
    if together or abs(before - after) > ALIKE * max(abs(before), abs(after)):
        raise PhysicsError("an impulse acts at the instant at which what multiplies it jumps: their product is not "
                           "defined", "let the impulse stand alone, as in P*impulse(t - t1)")
    return after


def _product(group: "WaveGroup", others: Sequence[Any], at: Instant) -> Fraction:
    total = Fraction(sum(c * at.exact_start**k for k, c in enumerate(group.at(at.middle))))
    for other in others:
        total *= other.line(at)[0]
    return total


def _sized(wave: "ExactWave", instant: Fraction, amount: float | Fraction, numbers: type[Any]) -> float:
    r, w, r0, w0, q = wave
    factor = numbers.turned(r * instant + r0, w * instant + w0, q).real if any(wave) else 1
    found: float = numbers.number(amount) * factor
    return found
