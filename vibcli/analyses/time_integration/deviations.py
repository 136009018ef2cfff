"""How far a motion that was integrated may be from that of the data as they are written: deviations of first order.

They come from the last digit of each constant (rounded_data), from that of the start, and from the rounding of each
window, of the instants and of the breaks; all grow as changes of the motion do (variation). Deviations of the start and
of the data are followed one by one, the others, which are independent of each other, by their covariance

    P ← Φ P Φᵀ + Σ b bᵀ
"""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.time_integration.collocation_step import along
from vibcli.analyses.time_integration.error_scales import EPSILON
from vibcli.analyses.time_integration.rounded_data import DIRECTIONS, STEP, Varied
from vibcli.analyses.time_integration.variation import NEAR, linearised, slopes
from vibcli.analyses.time_integration.variation_at_events import jump

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.analyses.time_integration.variation import Linear
    from vibcli.symbolic.node import Node

SPREAD = 6.0            # by which the root of the sum of squares is multiplied: of all that is said of an error
HALF = EPSILON / 2      # of a number: what its rounding may be
AT_REST = 16            # last digits by which the place where forces balance may be off
STILL = 1e-3            # of the size of a coordinate: what it moves at least, to see slopes
TINY = 1e-6             # of the figure: motions that are smaller
LOOKS = np.array([0.0, 0.3, 0.7, 1.0])  # of a window: where its size is looked at
AT_END = np.ones(1)
MOST = 24               # coordinates
LARGEST = 1e30          # of the motion: where nothing of it is known any more


def deviations(trajectory: "Trajectory", given: Mapping[str, float] | None, units: np.ndarray) -> "Deviations | None":
    """The Deviations; None of many coordinates, of which they would be long work, and where the linear equations are
    singular."""
    if len(trajectory.names) > MOST:
        return None
    try:
        return Deviations(trajectory, given, units)
    except np.linalg.LinAlgError:
        return None


class Deviations:
    """Of a Trajectory, from a start with the values `given`; units: the size of the figure along each coordinate;
    size: of the motion in (q, q̇). starts: columns of (q, q̇) at the start of each window,
    those of the directions of the data first; covariance: of what is rounded on the way."""

    def __init__(self, trajectory: "Trajectory", given: Mapping[str, float] | None, units: np.ndarray) -> None:
        self.trajectory, self.given, self.units = trajectory, dict(given or {}), units
        self.varied = Varied(trajectory)
        self.size = self._sizes()
        self.steps = NEAR * self.size
        self._follow(self._start())

    def _sizes(self) -> np.ndarray:
        """How large places and velocities are, those that hardly change lifted."""
        trajectory, found = self.trajectory, []
        for rows in along(trajectory.windows, LOOKS)[:2]:
            least = STILL * (np.abs(rows).max(axis=1) + (0.0 if found else STILL * self.units))
            found.append(trajectory.sizes.lifted(np.maximum(np.ptp(rows, axis=1), least)))
        speeds = found[1] if found[1].any() else found[0] / min(trajectory.sizes.radian, 1.0)
        return np.concatenate([found[0], speeds])

    @cached_property
    def linear(self) -> "list[Linear | None]":
        """The Linear of each window after those at rest."""
        windows = self.trajectory.windows
        return [None] * self._resting + linearised(self.varied, windows[self._resting:], self.steps)

    @cached_property
    def _resting(self) -> int:
        """The number of windows at whose end it still rests."""
        return int(np.searchsorted(self.trajectory.starts, self.trajectory.rests))

    def _start(self) -> np.ndarray:
        """Columns of (q, q̇) at t = 0, by the directions, and by the last digit of each number."""
        trajectory, window = self.trajectory, self.trajectory.windows[0]
        n, system = len(window.q), trajectory.system
        free = [i for i, name in enumerate(trajectory.names) if name not in self.given]
        at_rest = len(free) and not window.v.any()
        columns = np.zeros((2 * n, DIRECTIONS + 2 * n))
        if at_rest:
            F = slopes(self.varied, np.zeros(1), window.q[:, None], window.v[:, None], window.g, window.slides,
                       self.steps)[:, :, 0]
            F = np.where(np.isfinite(F), F, 0.0)
            columns[free, :DIRECTIONS] = -np.linalg.lstsq(F[:, free], F[:, 2 * n:], rcond=1e-10)[0]
        columns[:, :DIRECTIONS] *= HALF
        digits = np.full(2 * n, HALF) * np.abs(np.concatenate([window.q, window.v]))
        digits[free] = AT_REST * EPSILON * np.maximum(np.abs(window.q), STILL * self.units)[free]
        columns[range(2 * n), range(DIRECTIONS, DIRECTIONS + 2 * n)] = digits
        return self._closed(columns, window) if system.m else columns

    def _closed(self, columns: np.ndarray, window: "Window") -> np.ndarray:
        """The columns with loops closed."""
        n = len(window.q)
        ends = [self._projected(0, np.zeros(2 * n), window)]
        for r in range(DIRECTIONS):
            ends.append(self._projected(r + 1, columns[:, r] * STEP / HALF, window))
        for column in columns[:, DIRECTIONS:].T:
            far = self.steps @ np.abs(column) / (column @ column) if column.any() else 0.0
            ends.append(self._projected(0, far * column, window))
        found = np.zeros(columns.shape)
        for k, end in enumerate(ends[1:]):
            column = columns[:, k]
            scale = HALF / STEP if k < DIRECTIONS else (
                column @ column / (self.steps @ np.abs(column)) if column.any() else 0.0)
            found[:, k] = (end - ends[0]) * scale
        return found

    def _projected(self, which: int, change: np.ndarray, window: "Window") -> np.ndarray:
        n = len(window.q)
        try:
            both = self.varied.systems[which].projected(0.0, window.q + change[:n], window.v + change[n:], window.g)
        except np.linalg.LinAlgError:
            found: np.ndarray = np.concatenate([window.q, window.v]) + change
            return found
        return np.concatenate(both)

    def _follow(self, columns: np.ndarray) -> None:
        """The columns and the covariance from window to window."""
        trajectory, windows, most = self.trajectory, self.trajectory.windows, LARGEST * self.size.max()
        P = np.zeros((len(columns), len(columns)))
        self.starts, self.covariance, before = [], [], None
        breaks = set(trajectory.breaks.times.tolist())
        with np.errstate(all="ignore"):
            for window, linear, rounded in zip(windows, self.linear, self._rounded(), strict=True):
                if self._may_jump(before, window, breaks):
                    columns, P = self._over(before, window, columns, P)
                self.starts.append(columns)
                self.covariance.append(P)
                if linear is not None:
                    columns = linear.Phi @ columns
                    columns[:, :DIRECTIONS] += HALF * linear.Psi
                    P = linear.Phi @ P @ linear.Phi.T + rounded
                    if not np.abs(columns).max() < most:
                        columns, P = np.full(columns.shape, np.nan), np.full(P.shape, np.nan)
                before = window

    def _may_jump(self, before: "Window | None", window: "Window", breaks: set[float]) -> bool:
        if before is None:
            return bool(self._blows(window))
        return before.g != window.g or before.slides != window.slides or window.start in breaks

    def _blows(self, window: "Window") -> "dict[Node, float] | None":
        return self.trajectory.breaks.blows.get(window.start)

    def _over(self, before: "Window", window: "Window", columns: np.ndarray,
              P: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The same after what happens between two windows."""
        if before is None:
            before = _before(window, self.trajectory)
        found = jump(self.varied, before, window, self.steps, self._blows(window))
        if found is None:
            return columns, P
        columns = found.M @ columns
        columns[:, :DIRECTIONS] += HALF * found.D
        noise = found.later * EPSILON * window.start
        return columns, found.M @ P @ found.M.T + np.outer(noise, noise)

    def _rounded(self) -> np.ndarray:
        """The covariances of what is rounded in each window: the state at its end, the forces before, the instant."""
        windows, noise = self.trajectory.windows, self.trajectory.sizes.noise
        H = np.array([window.end for window in windows])[:, None]
        ends = np.array([window.start for window in windows])[:, None] + H
        q, v, a = (row.T for row in along(windows, AT_END))
        state = np.concatenate([EPSILON * np.abs(q) + H * H * noise, EPSILON * np.abs(v) + H * noise], axis=1)
        late = HALF * ends * np.concatenate([v, a], axis=1)
        found: np.ndarray = state[:, :, None] ** 2 * np.eye(2 * len(noise)) + late[:, :, None] * late[:, None, :]
        return found

    @property
    def sizes(self) -> np.ndarray:
        """How far the motion may be off at the start of each window, relative to its size, that of a motion which is
        nothing but rounding lifted; inf where nothing is known."""
        squares = [(columns**2).sum(axis=1) + np.diag(P)
                   for columns, P in zip(self.starts, self.covariance, strict=True)]
        radian = min(self.trajectory.sizes.radian, 1.0)
        least = TINY * np.concatenate([self.units, self.units / radian])
        found = SPREAD * np.sqrt(np.maximum(squares, 0.0)) / np.maximum(self.size, least)
        result: np.ndarray = np.where(np.isfinite(found), found, np.inf).max(axis=1)
        return result

    def columns(self, k: int) -> np.ndarray:
        """All at the start of a window: by the data, by the start, and by what is rounded, of shape (2n, columns)."""
        values, vectors = np.linalg.eigh(self.covariance[k])
        return np.concatenate([self.starts[k], vectors * np.sqrt(np.maximum(values, 0.0))], axis=1)

    def along(self, k: int, tau: np.ndarray) -> tuple[np.ndarray, ...] | None:
        """(δq, δq̇, δq̈) of all columns at instants after the start of a window, each of shape (n, instants, columns);
        None where they are as large as can be."""
        if not np.isfinite(self.starts[k]).all():
            return None
        columns, linear = self.columns(k), self.linear[k]
        n = len(columns) // 2
        if linear is None:
            still = np.repeat(columns[:, None, :], len(tau), 1)
            return still[:n], still[n:], np.zeros(still[:n].shape)
        return _scaled(linear, tau, columns)


def _scaled(linear: "Linear", tau: np.ndarray, columns: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Those of the directions are HALF of a unit."""
    columns = columns.copy()
    columns[:, :DIRECTIONS] /= HALF
    rows = linear.along(tau, columns)
    for row in rows:
        row[:, :, :DIRECTIONS] *= HALF
    return rows


def _before(window: "Window", trajectory: "Trajectory") -> "Window":
    """A window of no length just before the first: from where blows at t = 0 strike."""
    _, q, v, _ = trajectory.struck[0]
    nothing = np.zeros(window.values.shape)
    return type(window)(window.rule, window.start, 1.0, q, v, nothing, window.g, window.slides, 0.0)
