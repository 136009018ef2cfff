"""A motion that is smooth between events, by Taylor series in integers: its pieces, and any number of it."""

from bisect import bisect_right

from support.taylor import BITS, NEGLIGIBLE, ONE, SMALL, Tape, at, fixed, real, roots

MOST = 20_000


class Piece:
    """From t on for the time h·end: series of the state and of all signals."""

    __slots__ = ("end", "h", "series", "t")

    def __init__(self, t, h, end, series):
        self.t, self.h, self.end, self.series = t, h, end, series


class Motion:
    """build(mode): that of a Tape; start: state at t = 0; turn(mode, name, y): (mode, state) after the event `name`,
    "time 1.5" being that at 1.5 of `times`; names: of the entries of the state."""

    def __init__(self, build, names, start, until, mode=None, turn=None, times=(), step="0.05"):
        self.build, self.names, self.turn, self.tapes = build, names, turn, {}
        self.until, self.pieces, self._zeros = fixed(until), [], {}
        t, y, h = 0, [fixed(x) for x in start], fixed(step)
        stops = sorted((fixed(time), time) for time in times if fixed(time) < self.until)
        for stop, time in [*stops, (self.until, None)]:
            while t < stop:
                t, y, h, mode = self._step(t, y, h, mode, stop)
            if time is not None:
                mode, y = turn(mode, f"time {time}", y)
        self.starts = [piece.t for piece in self.pieces]

    def _tape(self, mode):
        if mode not in self.tapes:
            self.tapes[mode] = Tape(lambda tape, t, y: self.build(tape, t, y, mode), len(self.names))
        return self.tapes[mode]

    def _step(self, t, y, h, mode, stop):
        assert len(self.pieces) < MOST
        tape = self._tape(mode)
        while True:
            short = min(h, stop - t)
            tape.expand(t, y, short)
            if tape.last() <= SMALL:
                break
            h = short * 3 // 4
        end, name = ONE, None
        for key, one in tape.events.items():
            c = list(one.c)
            while abs(c[0]) < SMALL and len(c) > 3:     # it has just happened; twice 0 where it begins to slip
                c = c[1:]
            found = roots(c, end)
            if found:
                end, name = found[0], key
        rates = {name + "'": rate for name, rate in zip(self.names, tape.rates, strict=True)}
        signals = {**rates, **dict(zip(self.names, tape.y, strict=True)), **tape.signals}
        series = {key: list(one.c) for key, one in signals.items()}
        self.pieces.append(Piece(t, short, end, series))
        y = [at(one.c, end) for one in tape.y]
        if name is not None:
            mode, y = self.turn(mode, name, y)
        h = h * 5 // 4 if tape.last() < NEGLIGIBLE else h
        t = stop if end == ONE and short == stop - t else t + (short * end >> BITS)
        return t, y, h, mode

    def value(self, name, t):
        """At an instant, in mpmath; at an event as it is afterwards."""
        t = fixed(t)
        piece = self.pieces[max(bisect_right(self.starts, t) - 1, 0)]
        return real(at(piece.series[name], ((t - piece.t) << BITS) // piece.h))

    def zeros(self, name):
        """Instants at which it changes its sign."""
        if name not in self._zeros:
            self._zeros[name] = [real(piece.t + (piece.h * x >> BITS)) for piece in self.pieces
                                 for x in roots(piece.series[name], piece.end)]
        return self._zeros[name]
