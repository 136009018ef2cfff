"""Terms of exact sums that share a wave and what gates them: one polynomial of time from each instant on."""

from bisect import bisect_right
from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.analyses.excitation.exponential_polynomials import added

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.excitation.exponential_polynomials import Exact, ExactWave
    from vibcli.analyses.excitation.piecewise_linear import Blow, Periodic
    from vibcli.analyses.excitation.tabulated import TabulatedFunction

    Gate = Periodic | Blow | TabulatedFunction

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
