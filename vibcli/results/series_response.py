"""The motion of the full equations where more digits are asked for: by series, as far as it is looked at."""

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.results.full_response import FullResponse, StatesInTime
from vibcli.results.full_signals import FullSignal

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.series_trajectory import SeriesTrajectory
    from vibcli.results.shared_friction import SharedFriction
    from vibcli.symbolic.node import Node

ALONE = 8               # instants that are looked at one by one
ROUNDING = 2.0**-50
SEARCHED = 1e-12        # of a step: how far an instant that is searched in floats may be off


class SeriesResponse(FullResponse):
    """The motion of the full equations, to the digits of its Problem."""

    KIND, WORDS = "series", "full equations, by series"

    @property
    def known(self):
        return self.until

    def trajectory(self, until: float | None = None) -> "SeriesTrajectory":
        """The motion up to an instant at least, in floats that are correct to rounding."""
        until = self.until if until is None else until
        if self._trajectory is None or self._trajectory.until < until:
            from vibcli.analyses.time_integration.series_trajectory import SeriesTrajectory

            instant = Fraction(until)
            march = self.precise.until(instant).followed(self.problem.digits, instant)
            self._trajectory = SeriesTrajectory(march, self.precise.scene.coordinates, until)
        return self._trajectory

    def reaching(self, t: float) -> "SeriesTrajectory":
        return self.trajectory(max(t, ROUNDING))

    def states(self, known: Any, trajectory: Any):
        return StatesInTime.states(self, known, trajectory)

    def signal_of(self, node: "Node", forces: Mapping[Any, Any], shared: "SharedFriction | None" = None):
        return SeriesSignal(self, node, forces, shared)


class SeriesSignal(FullSignal):
    """A function of a motion that is followed by series."""

    KIND = "a motion that is followed by series"

    def values(self, times: np.ndarray, order: int = 0) -> np.ndarray:
        times = np.asarray(times, dtype=float)
        if order or self.forces or times.size > ALONE:
            return super().values(times, order)
        digits = self.motion.problem.digits
        return np.array([float(self.precise(Fraction(t), digits)) for t in times.ravel().tolist()]).reshape(times.shape)

    def error(self, t: float) -> float:
        if self.forces:
            self.precise(Fraction(t), self.motion.problem.digits)       # refuses them
        return ROUNDING * abs(float(self.values(np.array([t]))[0]))

    def error_of_time(self, t: float) -> float:
        trajectory = self.motion.reaching(t)
        return ROUNDING * t + SEARCHED * max(window.end for window in trajectory.windows)

    def _with_senses(self, node, trajectory, times, values):
        return node
