"""What all signals in time have: a function of the time, the bounds of its errors, more digits of it."""

from collections.abc import Callable, Sequence
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath
    import numpy as np

    from vibcli.results.escalation import BoundedExtreme


AT_ONCE = "small", "modes", "parts"     # motions whose end costs no more than any instant


def require_finite(values: "np.ndarray", times: "np.ndarray") -> "np.ndarray":
    """The values; PhysicsError where one is no real number."""
    import numpy as np

    bad = ~np.isfinite(values)
    if bad.any():
        instant = np.asarray(times)[bad][0]
        raise PhysicsError(f"this signal has no finite real value at t = {instant:.6g} s",
                           "mind its divisors and what stands under roots and in logarithms")
    return values


class Signal:
    """A function of the time. What a kind of signal does not have is refused by the name of that kind."""

    KIND, period = "a signal", None
    MORE = "ask for an earlier instant"     # of which digits may be known where none is
    LOOKED = 0      # parts of the time of samples, at whose ends it is looked whether they are known
    source: tuple[Any, ...] = ()
    asked: tuple[Any, ...] = ()
    values: Callable[..., "np.ndarray"]
    extreme: Callable[..., tuple[float, float]]
    zeros: "Callable[[float, float], Sequence[float]]"

    def read_at(self, t: float) -> "Signal":
        """The same signal as its value at an instant is best found."""
        return self

    def sampled(self, times: "np.ndarray") -> "np.ndarray":
        """Its values at ascending instants; where it leaps and an instant stands twice, before the leap and after
        it."""
        return self.values(times)

    def values_before(self, times: "np.ndarray") -> "np.ndarray":
        """Its values at instants, at a leap those before it."""
        return self.values(times)

    def fronts(self, end: float) -> "np.ndarray":
        """The instants up to an end at which waves bring fronts, ascending."""
        import numpy as np

        return np.zeros(0)

    def first_zeros(self, end: float, count: int) -> "Sequence[float]":
        """Instants up to an end at which it passes or touches zero, in order, all or at least the first so many."""
        return self.zeros(0.0, end)

    def has_died_out(self, end: float) -> bool:
        """Has it come to rest at zero, or is it smaller than floats tell by then?"""
        import numpy as np

        from vibcli.analyses.transient.zeros import FADED

        return bool(np.abs(self.values(end * np.linspace(0.999, 1.0, 9))).max() <= FADED)

    def require_bounded(self, end: float) -> None:
        """PhysicsError where it is infinite at an instant."""

    def leaps(self, end: float) -> list[tuple[float, float, float]]:
        """(t, value before, value after) of the fronts up to an end at which it leaps, as far as these are looked
        for."""
        return []

    def before(self, t: float) -> float | None:
        """Its value before an instant at which it leaps; None where it does not."""
        return None

    def precise(self, t: "Fraction | int", digits: int) -> "mpmath.mpf":
        """Its value at an instant, correct to so many digits."""
        from vibcli.results.precise_instants import value_to

        return value_to(self, t, digits)

    def precise_extreme(self, start: float, end: float, sense: int, digits: int) -> "tuple[mpmath.mpf, mpmath.mpf]":
        """(instant, value) of the largest (sense 1) or smallest (−1) value, correct to so many digits."""
        from vibcli.results.precise_instants import extreme_to

        return extreme_to(self, start, end, sense, digits)

    @cached_property
    def _extremes(self) -> dict[Any, Any]:
        """{(start, end, sense): BoundedExtreme}"""
        return {}

    def bounded_extreme(self, start: float, end: float, sense: int) -> "BoundedExtreme":
        """The largest (sense 1) or smallest (−1) value between two instants, kept."""
        from vibcli.results.escalation import extreme_of_signal

        asked = start, end, sense
        if asked not in self._extremes:
            self._extremes[asked] = extreme_of_signal(self, *asked)
        found: BoundedExtreme = self._extremes[asked]
        return found

    def error_of_mean(self, start: float, end: float) -> float:
        """How far its mean between two instants may be off."""
        return self.error(end)

    @property
    def coarse(self) -> "Signal":
        """The same, whose extremes are looked at no more closely than values at instants."""
        return self

    def precise_zero(self, near: float, digits: int) -> "mpmath.mpf":
        """The instant of the zero near an instant in floats, correct to so many digits."""
        from vibcli.results.precise_instants import zero_to

        return zero_to(self, near, digits)

    def rivals(self, start: float, end: float, sense: int, margin: float) -> list[float]:
        """The instants at which it comes within a margin of its largest or smallest value; KeyError where these are not
        looked for."""
        raise KeyError(self.KIND)

    def error(self, t: float) -> float:
        """How far its value at an instant may be off; 0 where that is rounding."""
        return 0.0

    def told_zero(self, t: float) -> float:
        """The bound below which a signal is told to be zero up to an instant, whatever its own size: where errors are
        those of rounding alone any is."""
        return inf

    @property
    def whole(self) -> "Signal":
        """The signal that tells how large it becomes."""
        return self

    @property
    def end(self) -> float | None:
        """That of the motion it is read off, where this is followed at once [s]."""
        response = next(iter(self.source or self.asked), None)
        found: float | None = response.until if response is not None and response.KIND in AT_ONCE else None
        return found

    @property
    def is_estimated(self) -> bool:
        """Is that an estimate of what modes left out add, and no bound?"""
        return False

    @property
    def why_estimated(self) -> str:
        """Why it is, in words, where that is known."""
        return ""

    def error_of_extreme(self, start: float, end: float, top: tuple[float, float], sense: int) -> float:
        """How far the largest (sense 1) or smallest (−1) value between two instants may be off, `top` being (t, value)
        of what is found."""
        return self.error(top[0])

    def error_of_time(self, t: float) -> float:
        """How far an instant that was searched may be off at which it is largest or smallest [s]."""
        return 0.0

    def error_of_zero(self, t: float) -> float:
        """How far an instant may be off at which it passes or touches zero [s]."""
        return self.error_of_time(t)

    def error_of_final(self) -> float:
        """How far its limit may be off."""
        return 0.0

    @property
    def steady(self) -> "Signal":
        raise PhysicsError(f"{self.KIND} has no steady part that is found", "ask for max(x), min(x) or values in time")

    @property
    def transient(self) -> "Signal":
        raise PhysicsError(f"{self.KIND} has no transient part that is found",
                           "ask for max(x), min(x) or values in time")

    @property
    def envelope(self) -> "Signal":
        raise PhysicsError(f"{self.KIND} has no envelope that is found", "ask for max(x), min(x) or values in time")


def part_of(source: tuple[Any, ...], part: str) -> tuple[Any, ...]:
    """The source of the steady or transient part of what has a source."""
    return (*source, part) if source else ()
