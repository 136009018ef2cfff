"""The frequency response of a signal of a scene to an input, and what is read off its graph."""

from functools import cached_property
from math import isfinite
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.frequency_response.extremes import Extreme
    from vibcli.analyses.frequency_response.fixed_points import FixedPoint
    from vibcli.analyses.frequency_response.response_errors import ResponseErrors
    from vibcli.results.problem import Problem

MOST = 10_000      # steps of a million products
FAR = 2.0**12      # times as far as peaks are shown, where those without end are counted


class Listing(NamedTuple):
    """The Extremes up to a frequency, and which of them are peaks and antiresonances."""

    extremes: "list[Extreme]"
    peaks: "list[Extreme]"
    antiresonances: "list[Extreme]"


class FrequencyResponse:
    """H(iΩ) of `signal` (a name, primes for rates) to a unit of the input `driver`."""

    def __init__(self, problem: "Problem", signal: str, driver: str):
        from vibcli.analyses.frequency_response.transfer_function import transfer

        self.problem, self.signal, self.driver = problem, signal, driver
        self.transfer = transfer(problem.configuration, signal, driver, modal=problem.modal)
        self._fixed: dict[str, Any] = {}
        self._listed: dict[float, Listing] = {}
        self._known: dict[tuple[str, int], Any] = {}

    def at(self, Omega: float) -> tuple[complex, float]:
        """(complex H, relative error bound)."""
        from vibcli.analyses.frequency_response.evaluate import frf

        found = complex(frf(self.transfer, Omega))
        return found, self.transfer.error(Omega) / (abs(found) or 1e-300)

    def by_modes(self, count: int, Omega: float) -> complex:
        """H of so many modes that oscillate."""
        from vibcli.analyses.frequency_response.modal_sum import by_modes

        with self.problem.work.task("the sum of modes", MOST):
            return by_modes(self.transfer, count, Omega)

    @property
    def undamped(self) -> bool:
        return self.transfer.undamped

    @property
    def natural(self) -> list[float]:
        """The natural frequencies that are shown, in rad/s."""
        return self.transfer.natural()

    @cached_property
    def errors(self) -> "ResponseErrors":
        from vibcli.analyses.frequency_response.response_errors import ResponseErrors

        return ResponseErrors(self.transfer)

    def listed(self, end: float) -> "Listing":
        """The Listing up to a frequency, kept."""
        from vibcli.analyses.frequency_response.extremes import extremes
        from vibcli.analyses.frequency_response.peaks import antiresonances, peaks

        if end not in self._listed:
            with self.problem.work.task("the search for peaks", MOST):
                found = extremes(self.transfer, 0.0, end)
                self._listed[end] = Listing(found, peaks(self.transfer, found, end),
                                            antiresonances(self.transfer, found, end))
        return self._listed[end]

    @property
    def marked(self) -> "list[Extreme]":
        """The Extremes that are peaks, of those without end the ones that are shown."""
        return self.listed(self.transfer.end).peaks

    @property
    def peaks(self) -> list[tuple[float, float]]:
        """[(Ω, |H|)], the value infinite without damping."""
        return [(one.Omega, float("inf") if one.value is None else one.value) for one in self.marked]

    @property
    def antiresonances(self) -> list[float]:
        """Ω of the antiresonances, of those without end the ones that are shown."""
        return [one.Omega for one in self.listed(self.transfer.end).antiresonances]

    def peak(self, number: int) -> "Extreme":
        """A peak, counted from 1."""
        return self._numbered(number, "peaks", "peak")[0]

    def antiresonance(self, number: int) -> float:
        """Ω of an antiresonance, counted from 1."""
        return self._numbered(number, "antiresonances", "antiresonance")[0].Omega

    def _numbered(self, number, kind, noun):
        """(the one of this number, the Listing it is in), which reaches as far as it has to."""
        end = self.transfer.end
        found = self.listed(end)
        while number > len(getattr(found, kind)) and end < FAR * self.transfer.end:
            end *= 2
            found = self.listed(end)
        count = len(getattr(found, kind))
        if number > count:
            raise PhysicsError(f"this frequency response has {count or 'no'} {noun}{'s' * (count != 1)}"
                               + f" up to {end:.6g} rad/s" * isfinite(end), "ask for one that it has")
        return getattr(found, kind)[number - 1], found

    def half_power_of(self, number: int) -> tuple[float, float]:
        """(Ω₁, Ω₂) about a peak, counted from 1."""
        return self._once("half power", number, self._half_power)

    def _half_power(self, number):
        from vibcli.analyses.frequency_response.peaks import half_power

        peak, found = self._numbered(number, "peaks", "peak")
        with self.problem.work.task("the search for half-power points", MOST):
            return half_power(self.transfer, peak, found.extremes)

    def _once(self, what, number, find):
        """What is found of a peak, kept."""
        if (what, number) not in self._known:
            self._known[what, number] = find(number)
        return self._known[what, number]

    def quality(self, number: int) -> float:
        """Q of a peak, counted from 1."""
        low, high = self.half_power_of(number)
        return self.peak(number).Omega / (high - low)

    def fixed_points(self, damper: str) -> "list[FixedPoint]":
        """The FixedPoints of the curves for all values of one damper."""
        from vibcli.analyses.frequency_response.fixed_points import fixed_points
        from vibcli.analyses.frequency_response.transfer_function import transfer

        if damper not in self._fixed:
            if self.signal.startswith(f"{damper}."):
                raise PhysicsError(f"'{self.signal}' is not there without the damper", "ask for another signal")
            other = self.problem.without(damper)
            free = transfer(other.configuration, self.signal, self.driver, modal=other.modal)
            with self.problem.work.task("the search for fixed points", MOST):
                self._fixed[damper] = free, fixed_points(free, self.transfer)
        return self._fixed[damper][1]

    def error_of_peak(self, number: int) -> tuple[float, float]:
        """(|δΩ|, relative error of |H|) of a peak, counted from 1."""
        return self._once("top", number, self._error_of_peak)

    def _error_of_peak(self, number):
        peak = self.peak(number)
        if peak.value is None:
            return self.transfer.error_of_pole(peak.Omega), 0.0
        return self.errors.of_top(peak.Omega)

    def error_of_antiresonance(self, Omega: float) -> float:
        """|δΩ| of an antiresonance."""
        return self.errors.of_zero(Omega) if self.undamped else self.errors.of_top(Omega)[0]

    def errors_of_half_power(self, number: int) -> tuple[float, float]:
        """(|δΩ₁|, |δΩ₂|) of the half-power points about a peak."""
        return self._once("levels", number, self._errors_of_half_power)

    def _errors_of_half_power(self, number):
        off = self.error_of_peak(number)[1]
        low, high = (self.errors.of_level(Omega, off) for Omega in self.half_power_of(number))
        return low, high

    def error_of_quality(self, number: int) -> float:
        """Relative, of Q of a peak."""
        low, high = self.half_power_of(number)
        return (sum(self.errors_of_half_power(number)) / (high - low)
                + self.error_of_peak(number)[0] / self.peak(number).Omega)

    def error_of_fixed_point(self, damper: str, Omega: float) -> tuple[float, float]:
        """(|δΩ|, relative error of |H|) of a fixed point of the curves for all values of a damper."""
        from vibcli.analyses.frequency_response.response_errors import ResponseErrors

        self.fixed_points(damper)
        off = self.errors.of_crossing(ResponseErrors(self._fixed[damper][0]), Omega)
        return off, self.errors.relative(Omega) + off * self.errors.steepness(Omega)

    def places(self, low: float, high: float) -> "np.ndarray":
        """Frequencies of a range, dense where the curve bends."""
        from vibcli.analyses.frequency_response.frequency_grid import adaptive

        with self.problem.work.task("the curve of H", MOST):
            return adaptive(self.transfer, low, high, True, self.listed(max(high, self.transfer.end)).extremes)[0]

    def values(self, Omega: "np.ndarray") -> "np.ndarray":
        """H at frequencies; NaN where an undamped mode has no bound."""
        import numpy as np

        from vibcli.analyses.frequency_response.evaluate import sampled

        with self.problem.work.task("the curve of H", MOST):
            values, resonant = sampled(self.transfer, Omega)
        return np.where(resonant, np.nan, values)

    @cached_property
    def span(self) -> tuple[float, float]:
        """The range of Ω in which what matters lies: from a fifth of the lowest frequency to five times the highest."""
        places = [Omega for Omega, _ in self.peaks] + self.antiresonances
        places += self.transfer.natural() or [1.0]
        return 0.2 * min(places), min(5.0 * max(places), self.transfer.end)
