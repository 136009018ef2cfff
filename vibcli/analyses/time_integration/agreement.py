"""What two solutions of one motion share: how well it is known, and until when.

The second solution is of another order, or has longer steps, and starts from a state that differs in the last digit. Of
a motion that is not sensitive to these both differ by rounding, or by what longer steps leave; where it is chaotic, or
leaves an unstable place, their difference grows as e^(λt), and from some instant on no digit of either is right.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import CLOSE, along
from vibcli.analyses.time_integration.error_scales import EPSILON
from vibcli.analyses.time_integration.trajectory import POINTS, Trajectory
from vibcli.numerics.collocation_rule import rule

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.deviations import Deviations
    from vibcli.analyses.time_integration.error_scales import Sizes

ROUNDED = CLOSE / 2   # last digits of a place: what rounding may leave of an iteration that comes no nearer
LOST = 1e-3         # of the motion: where two solutions differ by more, neither is known
NEAR = 12           # places before and after an instant, at which two signals are compared: a few radians
FEW, FOLDS, PLACES = 3, 8, 100   # windows and e-foldings at least, of which a rate is told; places that it is fitted to
POWER = 6           # of the time: with which nothing grows that is no exponential
EDGE = 1e-6         # of a window
STILL = 1e-3        # of the size of a coordinate: its error is not compared with less, however little it moves
GAP, ALONE = 4.0, 10.0  # what of the difference of two solutions counts; by what it is multiplied without deviations
ALIKE = 3.0         # the same where both are of one rule: errors of a like kind may pass one another
TWICE = 2.0         # how far a coordinate goes is at most so many times its largest value
HELD = TWICE * GAP


class Shared:
    """Two Trajectories of one motion; error: the largest difference of their states at the places `times` or before,
    relative to how far each coordinate goes and how fast; lost: may less than three digits be left of it there, and is
    it more than rounding? still: is all no more? units: the size of the figure along each coordinate; asked: the
    accuracy that is; deviations: those of the first, once they are known; share: by what a difference is multiplied."""

    def __init__(self, one: Trajectory, other: Trajectory, units: np.ndarray, asked: float | None = None) -> None:
        self.one, self.other, self.asked = one, other, asked
        self.deviations: Deviations | None = None
        end = min(one.end, other.end)
        c = rule(POINTS).c      # not the ends of windows: there forces may jump, in the other solution a little later
        times = np.concatenate([window.start + c * window.end for window in one.windows])
        self.times = times[times <= end]
        both = along(one.windows, c)[:2, :, :len(self.times)], other.at(self.times)[:2]
        skipped = [trajectory.fast for trajectory in (one, other) if trajectory.fast is not None]
        fast = [sum((getattr(part, row) for part in skipped), np.zeros(len(one.names))) for row in ("q", "v")]
        rounding = self._rounding(units, both[0][0])
        self.still = bool((np.ptp(both[0][0], axis=1) <= rounding[0].max(axis=1)).all())
        compared = [_compared(*row) for row in zip(*both, [one.sizes] * 2, rounding, fast, strict=True)]
        worst, gone = zip(*compared, strict=True)
        self.share = ALIKE if one.coarse else 1.0
        self.error = self.share * np.maximum.accumulate(np.maximum(*worst))
        self.lost = np.logical_or(*gone)

    def _rounding(self, units: np.ndarray, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """What rounding may make of q and q̇ at the times: that of a place at the end of each window, and that of the
        forces. Springs know their lengths to the last digit of the figure."""
        sizes, reach = self.one.sizes, np.maximum(units, np.abs(q).max(axis=1))
        windows = np.sqrt(np.arange(len(self.times)) // POINTS + 1.0)       # as errors that add up at random
        places = ROUNDED * EPSILON * reach[:, None] * windows
        forces = (sizes.noise + EPSILON * (sizes.slopes @ reach))[:, None]
        return forces * self.times**2 + places, forces * self.times + places / sizes.radian

    def beside(self, deviations: "Deviations | None") -> "Shared":
        """The same with what the data leave."""
        self.deviations = deviations
        return self

    @property
    def largest(self) -> float:
        """The largest error that the integration leaves, by the difference of the two."""
        return 0.0 if self.still else HELD * float(self.error.max(initial=0.0))

    @property
    def horizon(self) -> float | None:
        """The last place at which the motion is known as it is to be; None where all of it is."""
        found = [end for end in (self.lost_from, self.held_to) if end is not None]
        return min(found, default=None)

    @property
    def held_to(self) -> float | None:
        """The last place before the error exceeds the accuracy that is asked; None where it nowhere does."""
        if self.asked is None or self.still:
            return None
        error = (ALONE if self.deviations is None else 1.0) * HELD * self.error
        if self.deviations is not None:
            sizes = np.maximum.accumulate(self.deviations.sizes)
            error = error + TWICE * sizes[np.minimum(np.searchsorted(self.one.starts, self.times), len(sizes) - 1)]
        beyond = error > self.asked
        first = int(np.argmax(beyond))
        return (float(self.times[first - 1]) if first else 0.0) if beyond[first] else None

    @property
    def lost_from(self) -> float | None:
        """The last place before the two share less than three digits, or the deviations leave less; None where they
        nowhere do."""
        first = int(np.argmax(self.lost))
        found = [float(self.times[max(first - 1, 0)])] if self.lost[first] else []
        if self.deviations is not None and (self.deviations.sizes > LOST).any():
            found.append(self._too_large(self.deviations.sizes, self.one.starts))
        return min(found, default=None)

    def _too_large(self, sizes: np.ndarray, starts: np.ndarray) -> float:
        """When the deviations come to LOST, as they grow from one window to the next."""
        k = int(np.argmax(sizes > LOST))
        if not k or not 0 < sizes[k - 1] < sizes[k] < np.inf:
            return float(starts[max(k - 1, 0)])
        return float(np.interp(np.log(LOST), np.log(sizes[k - 1:k + 1]), starts[k - 1:k + 1]))

    @property
    def folding(self) -> float | None:
        """In which time neighbouring motions part e-fold up to the horizon [s]; None where they part no faster than a
        power of the time."""
        if self.deviations is None:
            return None
        sizes, times = self.deviations.sizes, self.one.starts
        seen = (sizes > 0) & (np.maximum.accumulate(sizes) < LOST) & (times > 0)
        if seen.sum() < FEW:
            return None
        even = np.linspace(times[seen][0], times[seen][-1], PLACES)
        logs = np.log(np.interp(even, times[seen], sizes[seen]))
        (rate, _), of_time, *_ = np.polyfit(even, logs, 1, full=True)
        (power, _), of_power, *_ = np.polyfit(np.log(even), logs, 1, full=True)
        truly = rate * (even[-1] - even[0]) > FOLDS and (power > POWER or of_time.sum() < of_power.sum())
        return 1.0 / float(rate) if truly else None

    def of_state(self, t: Any) -> float:
        """The error of the states up to an instant, relative to the motion."""
        error = float(self.error[min(np.searchsorted(self.times, t), len(self.error) - 1)])
        return error if self.one.fast is None else max(error, self.one.fast.part)

    def of_signal(self, values: Callable[..., np.ndarray], t: float) -> float:
        """How far the two differ in a signal about an instant, values(trajectory, times); not at the ends of windows,
        where it may jump, of the other one a little later."""
        k, window = int(np.searchsorted(self.times, t)), self.one.windows[self.one.number(t)]
        inside = window.start + window.end * np.clip((t - window.start) / window.end, EDGE, 1 - EDGE)
        about = np.append(self.times[max(k - NEAR, 0):k + NEAR], inside)
        times = np.minimum(about, min(self.one.end, self.other.end))
        return self.share * float(np.abs(values(self.one, times) - values(self.other, times)).max())


def _compared(a: np.ndarray, b: np.ndarray, sizes: "Sizes", rounding: np.ndarray,
              fast: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(the largest |a − b| of each instant relative to how far a row goes, or to rounding where that is more; is a row
    lost there?). fast: what is stepped over, which is told apart."""
    size = sizes.lifted(np.maximum(np.ptp(a, axis=1), STILL * np.abs(a).max(axis=1)))[:, None]
    gap = np.maximum(np.abs(a - b) - fast[:, None], 0.0)
    known = np.maximum(size, rounding)
    error = np.divide(gap, known, out=np.zeros_like(a), where=known > 0)
    return error.max(axis=0), (gap > LOST * size + rounding).any(axis=0)
