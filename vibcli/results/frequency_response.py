"""The frequency response of a signal of a scene to an input, and what is read off its graph."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import cached_property
from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

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

    def __init__(self, problem: "Problem", signal: str, driver: str) -> None:
        from vibcli.analyses.frequency_response.transfer_function import transfer

        self.problem, self.signal, self.driver = problem, signal, driver
        self.transfer = transfer(problem.configuration, signal, driver, modal=problem.modal)
        self._fixed: dict[str, Any] = {}
        self._listed: dict[float, Listing] = {}
        self._known: dict[tuple[str, int], Any] = {}

    def at(self, Omega: float) -> tuple[complex, float]:
        """(complex H, relative error bound)."""
        import numpy as np

        return self.at_each(np.array([Omega]))[0]

    def at_each(self, Omega: "np.ndarray") -> list[tuple[complex, float]]:
        """The same at frequencies."""
        from vibcli.analyses.frequency_response.evaluate import frf

        found = frf(self.transfer, Omega).tolist()
        errors = self.transfer.errors(Omega).tolist()
        return [(complex(H), error / (abs(H) or 1e-300)) for H, error in zip(found, errors, strict=True)]

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

    def _numbered(self, number: int, kind: str, noun: str) -> "tuple[Extreme, Listing]":
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
        from vibcli.analyses.frequency_response.peaks import held

        return held(self.peak(number), *self._kept("half power", [number], self._half_power)[0])

    def _half_power(self, numbers: Sequence[int]) -> list[tuple[float, float]]:
        from vibcli.analyses.frequency_response.peaks import half_power

        peak, found = self._numbered(numbers[0], "peaks", "peak")
        with self.problem.work.task("the search for half-power points", MOST):
            return [half_power(self.transfer, peak, found.extremes)]

    def find_half_powers(self) -> None:
        """Those about all peaks that are shown, together; where one of them is missing it is said when it is asked."""
        from vibcli.analyses.frequency_response.peaks import half_powers

        found = self.listed(self.transfer.end)
        bounded = {number: peak for number, peak in enumerate(found.peaks, 1)
                   if peak.value is not None and ("half power", number) not in self._known}
        if bounded:
            with suppress(PhysicsError), self.problem.work.task("the search for half-power points", MOST):
                points = half_powers(self.transfer, list(bounded.values()), found.extremes).tolist()
                self._known |= zip([("half power", number) for number in bounded], map(tuple, points), strict=True)

    def find_errors(self) -> None:
        """The errors of all that is read off the peaks that are shown, together."""
        self.find_half_powers()
        self._kept("top", range(1, len(self.marked) + 1), self._errors_of_peaks)
        whole = [number for (what, number), points in self._known.items() if what == "half power" and sum(points) > 0]
        self._kept("levels", whole, self._errors_of_levels)

    def _kept(self, what: str, numbers: range | Sequence[int],
              find: Callable[..., list[tuple[float, float]]]) -> list[tuple[float, float]]:
        """What is found of peaks, of those together of which it is not known."""
        missing = [number for number in numbers if (what, number) not in self._known]
        if missing:
            self._known |= zip([(what, number) for number in missing], find(missing), strict=True)
        return [self._known[what, number] for number in numbers]

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
        found: list[FixedPoint] = self._fixed[damper][1]
        return found

    def error_of_peak(self, number: int) -> tuple[float, float]:
        """(|δΩ|, relative error of |H|) of a peak, counted from 1."""
        return self._kept("top", [number], self._errors_of_peaks)[0]

    def _errors_of_peaks(self, numbers: Sequence[int]) -> list[tuple[float, float]]:
        import numpy as np

        tops = [self.peak(number) for number in numbers]
        bounded = np.array([peak.Omega for peak in tops if peak.value is not None])
        found = zip(*(part.tolist() for part in self.errors.of_tops(bounded)), strict=True)
        return [(self.transfer.error_of_pole(peak.Omega), 0.0) if peak.value is None else next(found) for peak in tops]

    @property
    def dips(self) -> list[tuple[float, float, float, float]]:
        """(Ω, |δΩ|, |H|, its relative error) of the antiresonances that are shown; H is 0 without damping."""
        import numpy as np

        Omega = np.array(self.antiresonances)
        if not len(Omega):
            return []
        values = [(0j, 0.0)] * len(Omega) if self.undamped else self.at_each(Omega)
        return [(at, off, abs(H) if error < 1 else 0.0, error) for at, off, (H, error) in
                zip(Omega.tolist(), self._errors_of_antiresonances(Omega), values, strict=True)]

    def error_of_antiresonance(self, Omega: float) -> float:
        """|δΩ| of an antiresonance."""
        import numpy as np

        return self._errors_of_antiresonances(np.array([Omega]))[0]

    def _errors_of_antiresonances(self, Omega: "np.ndarray") -> list[float]:
        found = self.errors.of_zeros(Omega) if self.undamped else self.errors.of_tops(Omega)[0]
        result: list[float] = found.tolist()
        return result

    def errors_of_half_power(self, number: int) -> tuple[float, float]:
        """(|δΩ₁|, |δΩ₂|) of the half-power points about a peak."""
        return self._kept("levels", [number], self._errors_of_levels)[0]

    def _errors_of_levels(self, numbers: Sequence[int]) -> list[tuple[float, float]]:
        import numpy as np

        places = np.array([self.half_power_of(number) for number in numbers])
        off = np.repeat([self.error_of_peak(number)[1] for number in numbers], 2)
        return list(map(tuple, self.errors.of_levels(places.ravel(), off).reshape(-1, 2).tolist()))

    def error_of_quality(self, number: int) -> float:
        """Relative, of Q of a peak."""
        low, high = self.half_power_of(number)
        return (sum(self.errors_of_half_power(number)) / (high - low)
                + self.error_of_peak(number)[0] / self.peak(number).Omega)

    def error_of_fixed_point(self, damper: str, Omega: float) -> tuple[float, float]:
        """(|δΩ|, relative error of |H|) of a fixed point of the curves for all values of a damper."""
        import numpy as np

        from vibcli.analyses.frequency_response.response_errors import ResponseErrors

        self.fixed_points(damper)
        at = np.array([Omega])
        off = self.errors.of_crossing(ResponseErrors(self._fixed[damper][0]), at)
        return float(off[0]), float((self.errors.relative(at) + off * self.errors.steepness(at))[0])

    def curve(self, low: float, high: float) -> "tuple[np.ndarray, np.ndarray]":
        """(Ω, H) in a range, dense where the curve bends."""
        from vibcli.analyses.frequency_response.frequency_grid import adaptive

        with self.problem.work.task("the curve of H", MOST):
            return adaptive(self.transfer, low, high, True, self.listed(max(high, self.transfer.end)).extremes)

    def values(self, Omega: "np.ndarray") -> "np.ndarray":
        """H at frequencies; NaN where an undamped mode has no bound."""
        import numpy as np

        from vibcli.analyses.frequency_response.evaluate import sampled

        with self.problem.work.task("the curve of H", MOST):
            values, resonant = sampled(self.transfer, Omega)
        return np.where(resonant, np.nan, values)

    def completed(self, known: "tuple[np.ndarray, np.ndarray]", Omega: "np.ndarray") -> "np.ndarray":
        """The same at ascending frequencies, those of a `curve` among them."""
        import numpy as np

        found = np.zeros(len(Omega), complex)
        found[np.searchsorted(Omega, known[0])] = known[1]
        left = found == 0       # as it is at poles, too
        found[left] = self.values(Omega[left])
        return found

    @cached_property
    def span(self) -> tuple[float, float]:
        """The range of Ω in which what matters lies: from a fifth of the lowest frequency to five times the highest."""
        places = [Omega for Omega, _ in self.peaks] + self.antiresonances
        places += self.transfer.natural() or [1.0]
        return 0.2 * min(places), min(5.0 * max(places), self.transfer.end)
