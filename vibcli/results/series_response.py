"""The motion of the full equations where more digits are asked for: by series, as far as it is looked at."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.numerics.fixed_point import to_float
from vibcli.results.full_response import FullResponse, StatesInTime
from vibcli.results.full_signals import FullSignal

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.time_integration.series_trajectory import SeriesTrajectory
    from vibcli.analyses.time_integration.signal_series import SignalAlong, SignalSeries
    from vibcli.analyses.time_integration.taylor_march import TaylorMarch
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.analyses.transient.sampled_extremes import SampledSearch
    from vibcli.results.shared_friction import SharedFriction
    from vibcli.symbolic.node import Node

ALONE = 8               # instants that are looked at one by one
ROUNDING = 2.0**-50
SEARCHED = 1e-12        # of the motion: how far an instant that is searched in floats may be off
FLOAT_DIGITS, SAMPLES = 17, 65


class SeriesResponse(FullResponse):
    """The motion of the full equations, to the digits of its Problem."""

    KIND, WORDS = "series", "full equations, by series"

    @property
    def known(self) -> float:
        return self.until

    @property
    def digits(self) -> int:
        """To so many it is followed: those of floats at least, so that values take no march of their own."""
        return max(self.problem.digits, FLOAT_DIGITS)

    def require_series(self) -> None:
        """PhysicsError where the motion has no more digits, for what its equations are made of."""
        self.precise.until(Fraction(0))

    def trajectory(self, until: float | None = None) -> "SeriesTrajectory":
        """The motion up to an instant at least, in floats that are correct to rounding."""
        until = self.until if until is None else until
        if self._trajectory is None or self._trajectory.until < until:
            from vibcli.analyses.time_integration.series_trajectory import SeriesTrajectory

            instant = Fraction(until)
            march = self.precise.until(instant).followed(self.digits, instant)
            self._trajectory = SeriesTrajectory(march, self.precise.scene.coordinates, until)
        found: SeriesTrajectory = self._trajectory
        return found

    def reaching(self, t: float) -> "SeriesTrajectory":
        return self.trajectory(max(t, ROUNDING))

    def states(self, known: Any, trajectory: Any) -> dict[str, float | np.ndarray]:
        return StatesInTime.states(self, known, trajectory)

    def senses(self, states: Any, trajectory: Any) -> None:
        """None: what switches has no series."""

    def signal_of(self, node: "Node", forces: Mapping[Any, Any],
                  shared: "SharedFriction | None" = None) -> "SeriesSignal":
        return SeriesSignal(self, node, forces, shared)


class SeriesSignal(FullSignal):
    """A function of a motion that is followed by series."""

    KIND = "a motion that is followed by series"

    def __init__(self, motion: Any, node: "Node", forces: Mapping[Any, Any] | None = None,
                 shared: "SharedFriction | None" = None) -> None:
        super().__init__(motion, node, forces, shared)
        self._seen: dict[TaylorMarch, SignalAlong] = {}

    def precise(self, t: Fraction, digits: int) -> "mpmath.mpf":
        return super().precise(t, max(digits, self.motion.digits))

    def values(self, times: np.ndarray, order: int = 0) -> np.ndarray:
        times = np.asarray(times, dtype=float)
        if order or self.forces or times.size > ALONE:
            return super().values(times, order)
        found = [float(self.precise(Fraction(t), self.motion.digits)) for t in times.ravel().tolist()]
        return np.array(found).reshape(times.shape)

    @cached_property
    def series(self) -> "SignalSeries | None":
        """Its SignalSeries; None where it bends or jumps."""
        from vibcli.analyses.time_integration.signal_series import SignalSeries

        try:
            return None if self.forces else SignalSeries(self.motion.precise.scene, self.node)
        except KeyError:
            return None

    def extreme(self, start: Any, end: float, sense: int) -> tuple[float, float]:
        if self.series is None:
            return self._sampled(start, end).extreme(sense)
        t, value = self.precise_extreme(start, end, sense, self.motion.digits)
        return float(t), float(value)

    def _sampled(self, start: float, end: float, level: float = 0.0) -> "SampledSearch":
        """The SampledSearch of a signal that bends or jumps, in floats."""
        from vibcli.analyses.transient.sampled_extremes import SampledSearch

        measure = super().values
        return SampledSearch(lambda times: measure(times) - level, start, end, self.motion.problem.work)

    def precise_extreme(self, start: float, end: float, sense: int, digits: int) -> "tuple[mpmath.mpf, mpmath.mpf]":
        def look(along: "SignalAlong", bits: int) -> "tuple[int, int, int]":
            place = along.extreme(_fixed(start, bits), _fixed(end, bits), sense, digits)
            return along.time(place), along.value(place), along.largest(_fixed(start, bits), _fixed(end, bits))

        return self._found(look, digits, Fraction(end))

    def zeros(self, start: float, end: float, level: float = 0.0) -> list[float]:
        if self.series is None:
            return [t for t in self._sampled(start, end, level).zeros() if start <= t <= end]
        march = self.motion.precise.until(Fraction(end)).followed(self.motion.digits, Fraction(end))
        along = self._along_march(march)
        found = along.passages(*(_fixed(x, march.bits) for x in (start, end, level)))
        return [to_float(along.time(place), march.bits) for place in found]

    def precise_zero(self, near: float, digits: int) -> "mpmath.mpf":
        def look(along: "SignalAlong", bits: int) -> "tuple[int, int, int]":
            return along.time(along.zero_near(Fraction(near))), 0, 0

        return self._found(look, digits, Fraction(near))[0]

    def _found(self, look: "Callable[[SignalAlong, int], tuple[int, int, int]]", digits: int,
               until: Fraction) -> "tuple[mpmath.mpf, mpmath.mpf]":
        """An instant and a value that are looked for along a march, correct to so many digits; look(signal, bits): both
        and the size of the signal."""
        import mpmath

        if self.series is None:
            raise PhysicsError("more digits of what bends or jumps are not found", "ask for values at instants")
        seen = {}

        def number(i: int) -> "Callable[[TaylorMarch], mpmath.mpf]":
            def question(march: "TaylorMarch") -> "mpmath.mpf":
                if march not in seen:
                    seen[march] = look(self._along_march(march), march.bits)
                with mpmath.workprec(2 * march.bits):
                    return mpmath.ldexp(seen[march][i], -march.bits)
            return question

        motion = self.motion.precise.until(until)
        return motion.found(number(0), digits, until), motion.found(number(1), digits, until, number(2))

    def _along_march(self, march: "TaylorMarch") -> "SignalAlong":
        if march not in self._seen:
            self._seen[march] = self.series.along(march, self.motion.precise.values(march.bits))
        return self._seen[march]

    def error(self, t: float) -> float:
        if self.forces:
            self.precise(Fraction(t), self.motion.problem.digits)       # refuses them
        if self.series is None:         # the instant, which was searched in floats, may be off too
            return SEARCHED * float(np.abs(super().values(np.linspace(0.0, max(t, self.motion.until), SAMPLES))).max())
        return ROUNDING * abs(float(self.values(np.array([t]))[0]))

    def error_of_time(self, t: float) -> float:
        return ROUNDING * t if self.series is not None else SEARCHED * self.motion.until

    def _with_senses(self, node: "Node", trajectory: "Trajectory", times: np.ndarray,
                     values: Mapping[str, Any]) -> "Node":
        return node


def _fixed(x: float, bits: int) -> int:
    """A float in fixed point, exactly but for its last bits."""
    return (Fraction(x).numerator << bits) // Fraction(x).denominator
