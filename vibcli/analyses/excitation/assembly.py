"""Exact sums of functions of time as the segments of a Forcing, every coefficient rounded once."""

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.excitation.exponential_polynomials import added, convolved, shifted
from vibcli.analyses.excitation.forcing import Forcing, Irregular, Segment, Wave, task_of
from vibcli.analyses.excitation.impulses import blows_of, nearest
from vibcli.analyses.excitation.piecewise_linear import Instant
from vibcli.analyses.excitation.rounding import Floating
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.excitation.exponential_polynomials import Exact, ExactWave, Sum
    from vibcli.analyses.excitation.piecewise_linear import Blow, Periodic
    from vibcli.analyses.excitation.tabulated import TabulatedFunction
    from vibcli.base.work import Task, Work

    Gate = Periodic | Blow | TabulatedFunction

NEAR = 1e-6
LENGTHY, MOST_SAMPLES = 5000, 4_000_000      # samples that are held as arrays
SHORTER = "let it change less often, or for a shorter time"
BEFORE = Fraction(-1)       # the instant from which a term counts that always does


class WaveGroup:
    """The terms of one channel with the same wave and gates: `ps[i]`, the polynomial from `instants[i]` on."""

    __slots__ = ("channel", "end", "exponent", "gates", "instants", "places", "ps", "wave")

    def __init__(self, channel: int, gates: "Sequence[Gate]", wave: "ExactWave",
                 terms: "Sequence[tuple[Fraction | None, tuple[Exact, ...]]]", numbers: type[Any]) -> None:
        self.channel, self.gates, self.wave = channel, gates, wave
        self.exponent = numbers.complex(numbers.number(wave[0]), numbers.number(wave[1]))
        self.end = min((gate.end for gate in gates if gate.end is not None), default=None)
        self.instants, self.ps, total = [], [], {}
        for T, p in sorted((BEFORE if T is None else T, p) for T, p in terms):
            total = added((total, 1), ({None: p}, 1))
            self.instants.append(T)
            self.ps.append(total.get(None, ()))
        self.places = [numbers.number(instant) for instant in self.instants]

    def at(self, middle: float) -> "tuple[Exact, ...]":
        """The polynomial at an instant, a number."""
        i = bisect_right(self.places, middle) - 1
        return self.ps[i] if i >= 0 else ()

    def spans(self) -> Iterator[tuple[Fraction, Fraction | None]]:
        """(low, high) of each span in which it acts, high None where it does not end."""
        for T, p, following in zip(self.instants, self.ps, [*self.instants[1:], None], strict=True):
            low = max(T, Fraction(0))
            ends = [x for x in (following, self.end) if x is not None]
            high = min(ends, default=None)
            if p and (high is None or high >= low):
                yield low, high


def assembled(sums: "Mapping[int, Sum]", channels: int, numbers: type[Any], work: "Work | None" = None) -> Forcing:
    """The Forcing of {channel: Sum}; work: what counts its segments."""
    terms = {}
    for channel, total in sums.items():
        for (T, gates, wave), p in total.items():
            terms.setdefault((channel, gates, wave), []).append((T, p))
    groups = [WaveGroup(*key, found, numbers) for key, found in terms.items()]
    try:
        return _forcing(groups, channels, numbers, work)
    except OverflowError:
        raise PhysicsError("what drives this scene grows or changes beyond what can be computed",
                           "look for growing exponentials, and for waves that are very fast") from None


def _forcing(groups: Sequence[WaveGroup], channels: int, numbers: type[Any], work: "Work | None") -> Forcing:
    """The Forcing of groups, or what is asked as one is."""
    spans = [(group, *span) for group in groups for span in group.spans()]
    count = _count((gate, low, high) for group, low, high in spans if high is not None for gate in group.gates)
    if numbers is Floating and _lengthy(groups):
        from vibcli.analyses.excitation.records_as_arrays import held, recorded_forcing

        if held(groups):
            with task_of(work, count, SHORTER, MOST_SAMPLES):
                return cast("Forcing", recorded_forcing(groups, channels))
    with task_of(work, count, SHORTER) as task:
        cuts, lasting = _cuts(spans)
        if not any(group.gates for group, _ in lasting):
            return Forcing(channels, _pieces(groups, cuts, None, 0, numbers, task))
    from vibcli.analyses.excitation.periods import common_period, shortest

    try:
        period = common_period([group for group, _ in lasting], numbers)
    except PhysicsError as refusal:
        longest = max(gate.period for group, _ in lasting for gate in group.gates)
        later = partial(_up_to, groups, cuts, lasting, longest, numbers)
        return cast("Forcing", Irregular(channels, later, numbers.number(longest), refusal))
    settled = max(cuts)
    last = settled + 2 * period
    count += _count((gate, low, last) for group, low in lasting for gate in group.gates)
    with task_of(work, count, SHORTER) as task:
        breaks = _repeated(lasting, last)
        since = min(instant for instant in breaks if instant >= settled)
        cuts.update(instant for instant in breaks if instant < since + period)
        pieces = _pieces(groups, cuts, since + period, since, numbers, task)
    start = min((piece.start for piece in pieces), key=lambda start: abs(start - numbers.number(since)))
    return Forcing(channels, *shortest(pieces, numbers.number(period), start, numbers.same), start)


def _count(spans: Iterable[tuple[Any, Fraction | int, Fraction]]) -> Fraction | int:
    """The breaks of functions in spans (function, low, high), of those that are one once."""
    found: Fraction | int = sum(gate.count(low, high) for gate, low, high in set(spans))
    return found


def _lengthy(groups: Sequence[WaveGroup]) -> bool:
    """Do they hold so many samples of records that these are not looked at one by one?"""
    gates = {gate for group in groups for gate in group.gates}
    if not gates:
        return False
    from vibcli.analyses.excitation.tabulated import TabulatedFunction

    return sum(len(gate) for gate in gates if isinstance(gate, TabulatedFunction)) >= LENGTHY


def _up_to(groups: Sequence[WaveGroup], cuts: set[Fraction], lasting: Sequence[tuple[WaveGroup, Fraction]],
           longest: Fraction, numbers: type[Any], until: float, work: "Work | None") -> list[Segment]:
    """The segments up to a time, and further by the longest period of what repeats."""
    last = numbers.exact(until) + longest
    count = len(cuts) + _count((gate, 0, last) for group, _ in lasting for gate in group.gates)
    with task_of(work, count) as task:
        cuts = {cut for cut in cuts if cut < last} | _repeated(lasting, last)
        return _pieces(groups, cuts, last, 0, numbers, task)


def _pieces(groups: Sequence[WaveGroup], cuts: set[Fraction], last: Fraction | None, since: Fraction | int,
            numbers: type[Any], task: "Task | None" = None) -> list[Segment]:
    """The Segments between the instants at which anything changes, up to `last` (None: for ever); one starts at
    `since`."""
    cuts = _apart(cuts, numbers.same)
    if last is not None:
        cuts = [cut for cut in cuts if last - cut > numbers.same * last]
    last = cuts[-1] + 1 if last is None else last
    places = [_place(low, high, numbers) for low, high in zip(cuts, [*cuts[1:], last], strict=True)]
    blows, first = blows_of(groups, cuts, last, numbers), nearest(cuts, since)
    pieces = []
    for i, at in enumerate(places):
        if task is not None:
            task.step(i / len(places), 0.5)
        waves = _waves(groups, at, numbers)
        level = not any(wave.power or wave.exponent for wave in waves)
        if i in (0, first) or blows.get(i) or pieces[-1].waves != waves or not level:
            pieces.append(Segment(at.start, waves, tuple(blows.get(i, {}).items())))
    return pieces


def _place(low: Fraction, high: Fraction, numbers: type[Any]) -> Instant:
    start, middle = numbers.number(low), (low + high) / 2
    return Instant(start, numbers.exact(start), numbers.number(middle), middle)


def _cuts(spans: Sequence[tuple[WaveGroup, Fraction, Fraction | None]]) -> tuple[set[Fraction],
                                                                                list[tuple[WaveGroup, Fraction]]]:
    """(instants at which anything changes, apart from what repeats for ever; [(group, its start)] of what lasts)."""
    cuts, lasting = {Fraction(0)}, []
    for group, low, high in spans:
        cuts.add(low)
        if high is None:
            lasting.append((group, low))
            continue
        cuts.add(high)
        for gate in group.gates:
            cuts.update(gate.breaks(low, high))
    return cuts, lasting


def _repeated(lasting: Sequence[tuple[WaveGroup, Fraction]], until: Fraction) -> set[Fraction]:
    """The breaks of what lasts, up to an instant."""
    return {instant for group, low in lasting for gate in group.gates for instant in gate.breaks(low, until)}


def _apart(cuts: set[Fraction], same: Fraction) -> list[Fraction]:
    """Sorted instants, those that differ by rounding alone taken as one."""
    found, size = [], -1.0
    for close, cut in sorted((float(cut), cut) for cut in cuts):
        if close - size > NEAR * close or not found or cut - found[-1] > same * cut:
            found.append(cut)
            size = close
    return found


def _waves(groups: Sequence[WaveGroup], at: Instant, numbers: type[Any]) -> tuple[Wave, ...]:
    """The waves of a segment: each polynomial counted from its start, times its lines and its wave there."""
    found = {}
    for group in groups:
        p = group.at(at.middle)
        if not p:
            continue
        p = tuple(map(numbers.number, shifted(p, at.exact_start)))
        for gate in group.gates:
            p = convolved(p, tuple(map(numbers.number, gate.line(at))))
        r, w, r0, w0, q = group.wave
        factor = numbers.turned(r * at.exact_start + r0, w * at.exact_start + w0, q) if any(group.wave) else 1
        factor = factor if w or factor == 1 else factor.real
        for k, c in enumerate(p):
            if c:
                size = numbers.complex(c * factor)
                key = group.channel, k, group.exponent
                found[key] = found[key] + size if key in found else size
    return tuple([Wave(channel, c, k, s) for (channel, k, s), c in found.items() if c])
