"""Exact sums of functions of time as the segments of a Forcing, every coefficient rounded once."""

from bisect import bisect_right
from fractions import Fraction

from vibcli.analyses.forcing.blows import blows_of, nearest
from vibcli.analyses.forcing.periods import common_period, shortest
from vibcli.analyses.forcing.segments import Forcing, Segment, Wave
from vibcli.analyses.forcing.sums import added, convolved, shifted
from vibcli.errors import PhysicsError

BEFORE = Fraction(-1)       # the instant from which a term counts that always does


class Group:
    """The terms of one channel with the same wave and gates: `ps[i]`, the polynomial from `instants[i]` on."""

    __slots__ = ("channel", "end", "gates", "instants", "ps", "wave")

    def __init__(self, channel, gates, wave, terms):
        self.channel, self.gates, self.wave = channel, gates, wave
        self.end = min((gate.end for gate in gates if gate.end is not None), default=None)
        self.instants, self.ps, total = [], [], {}
        for T, p in sorted((BEFORE if T is None else T, p) for T, p in terms):
            total = added((total, 1), ({None: p}, 1))
            self.instants.append(T)
            self.ps.append(total.get(None, ()))

    def at(self, middle):
        i = bisect_right(self.instants, middle) - 1
        return self.ps[i] if i >= 0 else ()

    def spans(self):
        """(low, high) of each span in which it acts, high None where it does not end."""
        for T, p, following in zip(self.instants, self.ps, [*self.instants[1:], None], strict=True):
            low = max(T, Fraction(0))
            ends = [x for x in (following, self.end) if x is not None]
            high = min(ends, default=None)
            if p and (high is None or high >= low):
                yield low, high


def assembled(sums, channels, numbers):
    """The Forcing of {channel: Sum}."""
    terms = {}
    for channel, total in sums.items():
        for (T, gates, wave), p in total.items():
            terms.setdefault((channel, gates, wave), []).append((T, p))
    groups = [Group(*key, found) for key, found in terms.items()]
    try:
        return _forcing(groups, channels, numbers)
    except OverflowError:
        raise PhysicsError("what drives this scene grows or changes beyond what can be computed",
                           "look for growing exponentials, and for waves that are very fast") from None


def _forcing(groups, channels, numbers):
    cuts, since, period = _cuts(groups, numbers)
    cuts = _apart(cuts, numbers.same)
    if period is not None:
        end = since + period
        cuts = [cut for cut in cuts if end - cut > numbers.same * end]
    starts = [numbers.number(cut) for cut in cuts]
    last = cuts[-1] + 1 if period is None else since + period
    middles = [(low + high) / 2 for low, high in zip(cuts, [*cuts[1:], last], strict=True)]
    blows, first = blows_of(groups, cuts, last, numbers), 0 if since is None else nearest(cuts, since)
    pieces = []
    for i, start in enumerate(starts):
        waves = _waves(groups, numbers.exact(start), middles[i], numbers)
        if i in (0, first) or blows.get(i) or pieces[-1].waves != waves or not all(map(_is_level, waves)):
            pieces.append(Segment(start, waves, tuple(blows.get(i, {}).items())))
    if period is None:
        return Forcing(channels, pieces)
    return Forcing(channels, *shortest(pieces, numbers.number(period), starts[first], numbers.same), starts[first])


def _is_level(wave):
    return not (wave.power or wave.exponent)


def _cuts(groups, numbers):
    """(instants at which anything changes, since, period); the last two None where nothing repeats for ever."""
    cuts, lasting = {Fraction(0)}, []
    for group in groups:
        for low, high in group.spans():
            cuts.add(low)
            if high is None:
                lasting.append((group, low))
                continue
            cuts.add(high)
            for gate in group.gates:
                cuts.update(gate.breaks(low, high))
    if not any(group.gates for group, _ in lasting):
        return cuts, None, None
    period, settled = common_period([group for group, _ in lasting], numbers), max(cuts)
    breaks = {instant for group, low in lasting for gate in group.gates
              for instant in gate.breaks(low, settled + 2 * period)}
    since = min(instant for instant in breaks if instant >= settled)
    cuts.update(instant for instant in breaks if instant < since + period)
    return cuts, since, period


def _apart(cuts, same):
    """Sorted instants, those that differ by rounding alone taken as one."""
    found = []
    for cut in sorted(cuts):
        if not found or cut - found[-1] > same * cut:
            found.append(cut)
    return found


def _waves(groups, start, middle, numbers):
    """The waves of a segment: each polynomial counted from its start, times its lines and its wave there."""
    found = {}
    for group in groups:
        p = group.at(middle)
        if not p:
            continue
        p = shifted(p, start)
        for gate in group.gates:
            p = convolved(p, gate.line(start, middle))
        r, w, r0, w0, q = group.wave
        factor = numbers.turned(r * start + r0, w * start + w0, q) if any(group.wave) else 1
        factor = factor if w or factor == 1 else factor.real
        exponent = numbers.complex(numbers.number(r), numbers.number(w))
        for k, c in enumerate(p):
            if c:
                size = numbers.complex(numbers.number(c) * factor)
                key = group.channel, k, exponent
                found[key] = found[key] + size if key in found else size
    return tuple(Wave(channel, c, k, s) for (channel, k, s), c in found.items() if c)
