"""What two solutions of one motion share: how well it is known, and until when.

The second solution is of another order, has other steps, and starts from a state that differs in the last digit. Of a
motion that is not sensitive to these both differ by rounding; where it is chaotic, or leaves an unstable place, their
difference grows as e^(λt), and from some instant on no digit of either is right.
"""

import numpy as np

from vibcli.analyses.trajectory.collocation import rule
from vibcli.analyses.trajectory.result import POINTS
from vibcli.analyses.trajectory.sizes import EPSILON

ROUNDED = 16         # last digits of the figure: of places that differ by less nothing but rounding is known
LOST = 1e-3         # of the motion: where two solutions differ by more, neither is known
NEAR = POINTS       # places before and after an instant, at which two signals are compared
STILL = 1e-3        # of the size of a coordinate: its error is not compared with less, however little it moves


class Shared:
    """Two Trajectories of one motion; error: the largest difference of their states at the places `times` or before,
    relative to how far each coordinate goes and how fast. units: the size of the figure along each coordinate."""

    def __init__(self, one, other, units):
        self.one, self.other = one, other
        end = min(one.end, other.end)
        c = rule(POINTS).c      # not the ends of windows: there forces may jump, in the other solution a little later
        times = np.concatenate([window.start + c * window.end for window in one.windows])
        self.times = times[times <= end]
        both = [trajectory.at(self.times)[:2] for trajectory in (one, other)]
        skipped = [trajectory.fast for trajectory in (one, other) if trajectory.fast is not None]
        fast = [sum((getattr(part, row) for part in skipped), np.zeros(len(one.names))) for row in ("q", "v")]
        places = ROUNDED * EPSILON * np.asarray(units)
        least = [one.sizes.noise[:, None] * self.times**power + rounding[:, None]
                 for power, rounding in ((2, places), (1, places / one.sizes.radian))]
        worst = [_relative(a, b, one.sizes, rounding, less)
                 for a, b, rounding, less in zip(*both, least, fast, strict=True)]
        self.error = np.maximum.accumulate(np.maximum(*worst))

    @property
    def horizon(self):
        """The last place before the two share less than three digits; None where they share all of the motion."""
        lost = int(np.searchsorted(self.error, LOST, side="right"))
        return float(self.times[max(lost - 1, 0)]) if lost < len(self.times) else None

    def of_state(self, t):
        """The error of the states up to an instant, relative to the motion."""
        error = float(self.error[min(np.searchsorted(self.times, t), len(self.error) - 1)])
        return error if self.one.fast is None else max(error, self.one.fast.part)

    def of_signal(self, values, t):
        """How far the two differ in a signal about an instant; values(trajectory, times)."""
        k = int(np.searchsorted(self.times, t))
        times = np.minimum(np.append(self.times[max(k - NEAR, 0):k + NEAR], t), min(self.one.end, self.other.end))
        return float(np.abs(values(self.one, times) - values(self.other, times)).max())


def _relative(a, b, sizes, rounding, fast):
    """The largest |a − b| of each instant relative to how far a row goes; of what rests but for rounding, relative to
    what rounding may make of it: that of its acceleration, and that of the places, to which what is fastest vibrates.
    fast: what is stepped over, which is told apart."""
    size = sizes.lifted(np.maximum(np.ptp(a, axis=1), STILL * np.abs(a).max(axis=1)))[:, None] + rounding / LOST
    gap = np.maximum(np.abs(a - b) - fast[:, None], 0.0)
    return np.divide(gap, size, out=np.zeros_like(a), where=size > 0).max(axis=0)
