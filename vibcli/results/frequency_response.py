"""The frequency response of a signal of a scene to an input, and what is read off its graph."""

from functools import cached_property
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.frequency_response.extremes import Extreme
    from vibcli.analyses.frequency_response.fixed_points import FixedPoint
    from vibcli.results.problem import Problem

ERROR = 1e-12
MOST = 10_000      # steps of a million products


class FrequencyResponse:
    """H(iΩ) of `signal` (a name, primes for rates) to a unit of the input `driver`."""

    def __init__(self, problem: "Problem", signal: str, driver: str):
        from vibcli.analyses.frequency_response.transfer_function import transfer

        self.problem, self.signal, self.driver = problem, signal, driver
        self.transfer, self._fixed = transfer(problem.configuration, signal, driver), {}

    def at(self, Omega: float) -> tuple[complex, float]:
        """(complex H, relative error bound)."""
        from vibcli.analyses.frequency_response.evaluate import frf

        return complex(frf(self.transfer, Omega)), ERROR

    @cached_property
    def extremes(self) -> "list[Extreme]":
        from vibcli.analyses.frequency_response.extremes import extremes

        with self.problem.work.task("the search for peaks", MOST):
            return extremes(self.transfer)

    @cached_property
    def marked(self) -> "list[Extreme]":
        """The Extremes that are peaks."""
        from vibcli.analyses.frequency_response.peaks import peaks

        with self.problem.work.task("the search for peaks", MOST):
            return peaks(self.transfer, self.extremes)

    @property
    def peaks(self) -> list[tuple[float, float]]:
        """[(Ω, |H|)], the value infinite without damping."""
        return [(one.Omega, float("inf") if one.value is None else one.value) for one in self.marked]

    @cached_property
    def antiresonances(self) -> list[float]:
        """Ω of the antiresonances."""
        from vibcli.analyses.frequency_response.peaks import antiresonances

        with self.problem.work.task("the search for antiresonances", MOST):
            return [one.Omega for one in antiresonances(self.transfer, self.extremes)]

    def half_power_of(self, number: int) -> tuple[float, float]:
        """(Ω₁, Ω₂) about a peak, counted from 1."""
        from vibcli.analyses.frequency_response.peaks import half_power

        peak = self._peak(number)
        with self.problem.work.task("the search for half-power points", MOST):
            return half_power(self.transfer, peak, self.extremes)

    def quality(self, number: int) -> float:
        """Q of a peak, counted from 1."""
        low, high = self.half_power_of(number)
        return self._peak(number).Omega / (high - low)

    def fixed_points(self, damper: str) -> "list[FixedPoint]":
        """The FixedPoints of the curves for all values of one damper."""
        from vibcli.analyses.frequency_response.fixed_points import fixed_points
        from vibcli.analyses.frequency_response.transfer_function import transfer

        if damper not in self._fixed:
            if self.signal.startswith(f"{damper}."):
                raise PhysicsError(f"'{self.signal}' is not there without the damper", "ask for another signal")
            free = transfer(self.problem.without(damper).configuration, self.signal, self.driver)
            with self.problem.work.task("the search for fixed points", MOST):
                self._fixed[damper] = fixed_points(free, self.transfer)
        return self._fixed[damper]

    def _peak(self, number):
        if number > len(self.marked):
            count = len(self.marked)
            raise PhysicsError(f"this frequency response has {count or 'no'} peak{'s' * (count != 1)}",
                               "ask for one that it has")
        return self.marked[number - 1]

    def places(self, low: float, high: float) -> "np.ndarray":
        """Frequencies of a range, dense where the curve bends."""
        from vibcli.analyses.frequency_response.frequency_grid import adaptive

        with self.problem.work.task("the curve of H", MOST):
            return adaptive(self.transfer, low, high, True, self.extremes)[0]

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
        modes = self.problem.modal.modes or self.problem.modal.damped or ()
        places += [float(mode.omega) for mode in modes if mode.omega] or [1.0]
        return 0.2 * min(places), 5.0 * max(places)
