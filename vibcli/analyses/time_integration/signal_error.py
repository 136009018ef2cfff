"""How far a signal of an integrated motion, and the instants found in it, may be off: an estimate, window by window.

    error ≤ SPREAD √(Σ deviations²) + GAP · (the largest difference of two solutions about it) + rounding

The deviations are those of first order (deviations.py), the signal being looked at along neighbouring motions; the
difference shows what the integration itself left. An instant at which the signal passes a level is off by error/|ṡ|,
that of an extreme by (the error of ṡ)/|s̈|.
"""

from collections.abc import Callable, Sequence
from functools import cached_property, lru_cache
from math import sqrt
from typing import Any

import numpy as np
from numpy.polynomial import legendre

from vibcli.analyses.time_integration.agreement import ALONE, GAP
from vibcli.analyses.time_integration.deviations import SPREAD
from vibcli.analyses.time_integration.error_scales import EPSILON
from vibcli.analyses.time_integration.trajectory import Trajectory
from vibcli.analyses.time_integration.variation import NEAR
from vibcli.base.errors import PhysicsError
from vibcli.numerics.collocation_rule import rule

ROUNDED, PASSED = 8 * EPSILON, 2 * EPSILON  # of a number; of the largest that a polynomial comes to, at its zeros too
POINTS, FINE, FINER = 12, 40, 50    # of a window: where neighbours are looked at, the motion, its error
NEARER = (1.0, 1e-3, 1e-6)      # of NEAR: where neighbours are looked at if the signal has no value there
ROUGH = 12.0                    # of the rate of a polynomial through values that are rounded at random
STILL = 1e-5                    # of a window: an extreme that is as near is that one
NOTHING = 1e-200                # of the motion: deviations that are none
HOPELESS = 1e3                  # of the signal: where nothing is known


class Neighbours(Trajectory):
    """Motions beside a trajectory at the points of one window: its states are those of one neighbour after the other,
    instant by instant, whatever instants are asked for."""

    def __init__(self, trajectory: Trajectory, states: tuple[np.ndarray, ...]) -> None:
        self.__dict__.update(trajectory.__dict__)
        self._states = states

    def at(self, times: Any) -> Any:
        return self._states


class SignalError:
    """Of the signal values(trajectory, times) within window k."""

    def __init__(self, trajectory: Trajectory, values: Callable[[Trajectory, np.ndarray], np.ndarray], k: int) -> None:
        window, self.shared = trajectory.windows[k], trajectory.shared
        self.trajectory, self.values, self.window = trajectory, values, window
        self.length = min(window.end, trajectory.end - window.start) or window.end
        self.size, self.series, self.alone = 0.0, np.zeros(POINTS), ALONE if self.shared.deviations is None else 1.0
        gauss = rule(POINTS)
        self.columns, self.floors = (rows @ gauss.to_series for rows in self._neighbours(k, gauss.c * self.length))

    def _neighbours(self, k: int, tau: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Deviations of the signal at instants of the window, of shape (columns, instants): those of the motion, and
        those of the last digits of each number that it is found from."""
        trajectory, window, deviations = self.trajectory, self.window, self.shared.deviations
        states = [np.asarray(rows) for rows in window.states(tau)]
        here = np.asarray(self.values(trajectory, window.start + tau), dtype=float)
        self.size, self.series = np.abs(here).max(), here @ rule(POINTS).to_series
        closed = deviations.units if deviations is not None and trajectory.drift is not None else None
        rounded = _digits(states, window.start + self.length, trajectory.sizes.noise, closed)
        columns = deviations.along(k, tau) if deviations is not None else None
        self.hopeless = deviations is not None and columns is None
        if columns is None:
            columns = tuple(np.zeros((len(states[0]), len(tau), 0)) for _ in range(3))
        count = columns[0].shape[2]
        both = [np.concatenate(pair, axis=2) for pair in zip(columns, rounded, strict=True)]
        far = _far(both, self._sizes(states))
        found = np.zeros((both[0].shape[2], len(tau)))
        used = np.flatnonzero(np.isfinite(far))
        for nearer in NEARER if len(used) else ():
            try:
                found[used] = self._seen(states, both, nearer * far, used, tau, here)
                break
            except PhysicsError:        # a root or a logarithm that has no value beside the motion
                self.alone = ALONE
        return found[:count], found[count:]

    def _sizes(self, states: Sequence[np.ndarray]) -> list[np.ndarray]:
        """How large places, velocities and accelerations are, of all the motion where that is known."""
        deviations, n = self.shared.deviations, len(states[0])
        here = [np.abs(rows).max(axis=1) for rows in states]
        if deviations is not None:
            here[:2] = deviations.size[:n], deviations.size[n:]
        here[2] = np.maximum(here[2], self.trajectory.sizes.largest)
        return [np.where(size > 0, size, size.max(initial=0.0) or 1.0) for size in here]

    def _seen(self, states: Sequence[np.ndarray], both: Sequence[np.ndarray], far: np.ndarray, used: np.ndarray,
              tau: np.ndarray, here: np.ndarray) -> np.ndarray:
        moved = tuple((row[:, :, None] + columns[:, :, used] * far[used]).transpose(0, 2, 1).reshape(len(row), -1)
                      for row, columns in zip(states, both, strict=True))
        times = np.tile(self.window.start + tau, len(used))
        seen = np.asarray(self.values(Neighbours(self.trajectory, moved), times), dtype=float)
        found: np.ndarray = (seen.reshape(len(used), -1) - here) / far[used, None]
        return found

    def at(self, t: float) -> float:
        """Of the value at an instant."""
        if self.hopeless:
            return HOPELESS * self.size
        P = self._basis(t)[0]
        deviation = sqrt(float(((self.columns @ P) ** 2).sum()))
        rounding = float(np.abs(self.floors @ P).sum()) + ROUNDED * abs(float(self.series @ P))
        found: float = SPREAD * deviation + self.alone * (GAP * self.shared.of_signal(self.values, t) + rounding)
        return found

    def _basis(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """(Legendre polynomials, their rates) at an instant."""
        x = 2 * (t - self.window.start) / self.length - 1
        return legendre.legvander(np.array([x]), POINTS - 1)[0], _slopes(x, POINTS) * 2 / self.length

    def _slope(self, t: float) -> float:
        """Of the rate at an instant."""
        P, slopes = self._basis(t)
        deviation = sqrt(float(((self.columns @ slopes) ** 2).sum()))
        rounding = self._roughness(t) * (float(np.abs(self.floors @ P).sum()) + ROUNDED * self.size)
        return SPREAD * deviation + self.alone * (GAP * self._gap + rounding)

    def _roughness(self, t: float) -> float:
        """Of the rate of a polynomial through FINE values: what it adds for each unit by which these are rounded."""
        x, k = 2 * (t - self.window.start) / self.length - 1, np.arange(FINE)
        found: float = ROUGH * 2 / self.length * sqrt(float((_slopes(x, FINE) ** 2 * (2 * k + 1)).sum()) / FINE)
        return found

    @cached_property
    def _gap(self) -> float:
        """The largest rate of the difference of the two solutions; of more points than the motion has, between which
        its accelerations are off."""
        gauss, shared = rule(FINER), self.shared
        times = np.minimum(self.window.start + gauss.c * self.length, min(shared.one.end, shared.other.end))
        gaps = self.values(shared.one, times) - self.values(shared.other, times)
        rates = legendre.legval(2 * gauss.c - 1, legendre.legder(gaps @ gauss.to_series))
        found: float = shared.share * float(np.abs(rates).max()) * 2 / self.length
        return found

    def of_time(self, t: float) -> float:
        """Of an instant that was searched: of an extreme where the rate vanishes, else of a passage [s]."""
        if self.hopeless:
            return t
        gauss = rule(FINE)
        series = gauss.to_series.T @ self.values(self.trajectory, self.window.start + gauss.c * self.length)
        x = 2 * (t - self.window.start) / self.length - 1
        rates = [float(legendre.legval(x, legendre.legder(series, order))) * (2 / self.length) ** order
                 for order in (1, 2, 3)]
        late = EPSILON * t
        if abs(rates[0]) <= STILL * self.length * abs(rates[1]):
            return late + _root(self._slope(t), rates[1], rates[2])
        return late + _root(self.at(t), rates[0], rates[1])


@lru_cache
def _derived(count: int) -> np.ndarray:
    """Rows of Legendre coefficients of Pₖ′, k below count."""
    return legendre.legder(np.eye(count), axis=1)


def _slopes(x: float, count: int) -> np.ndarray:
    """Pₖ′(x), k below count."""
    found: np.ndarray = _derived(count) @ legendre.legvander(np.array([x]), count - 2)[0]
    return found


def _digits(states: Sequence[np.ndarray], t: float, noise: np.ndarray, closed: np.ndarray | None) -> list[np.ndarray]:
    """Changes of the state by the last digits of each number of it, or of the largest that its polynomial comes to, of
    accelerations by their rounding error, and of the instant, of shapes (n, instants, columns). `closed`: the units of
    coordinates that close loops, which have the rounding of the largest of them, or of the figure; else None."""
    n, count = states[0].shape
    found = [np.zeros((n, count, 3 * n + 1)) for _ in range(3)]
    for order, rows in enumerate(states):
        least = np.zeros(n) if order < 2 else noise
        if closed is not None and order < 2:
            least = ROUNDED * closed * max(1.0 - order, float((np.abs(rows).max(axis=1) / closed).max()))
        for i, row in enumerate(rows):
            found[order][i, :, order * n + i] = np.maximum(ROUNDED * np.abs(row), PASSED * np.abs(row).max()) + least[i]
    for order in (0, 1):
        found[order][:, :, -1] = EPSILON * t * states[order + 1]
    return found


def _far(columns: Sequence[np.ndarray], sizes: Sequence[np.ndarray]) -> np.ndarray:
    """By what each column is multiplied to see its effect: then it is NEAR of the motion; NaN of those that vanish."""
    parts = [np.abs(column).max(axis=1) / size[:, None] for column, size in zip(columns, sizes, strict=True)]
    largest = np.max(np.concatenate(parts), axis=0)
    return np.where(largest > NOTHING, NEAR / np.where(largest > NOTHING, largest, 1.0), np.nan)


def _root(error: float, slope: float, bend: float) -> float:
    """How far a root may be where the function is off by an error: that of |slope| δ − |bend| δ²/2."""
    slope, bend = abs(slope), abs(bend)
    left = sqrt(max(slope * slope - 2 * error * bend, 0.0))
    return 2 * error / (slope + left) if slope else sqrt(2 * error / bend) if bend else np.inf
