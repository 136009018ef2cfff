"""The response itself: any linear output and its derivatives at any times, without steps in time."""

import math

import numpy as np

from vibcli.analyses.response import searching
from vibcli.analyses.response.driven import drives, ends, marched
from vibcli.analyses.response.spectrum import spectrum
from vibcli.analyses.response.terms import Terms
from vibcli.analyses.response.timeline import Timeline


def linear_motion(M, C, K, forcing, q0, v0, modes=None):
    """The motion of M q̈ + C q̇ + K q = f(t) from q(0) = q0, q̇(0) = v0.

    M symmetric positive definite; C and K any real matrices; forcing: segments.Forcing whose first n channels are the
    generalised forces. modes: undamped modes (modal.Mode) where they are known better than the assembled matrices tell.
    """
    M, C, K = (np.array(matrix, float, ndmin=2) for matrix in (M, C, K))
    return LinearMotion(M, C, K, spectrum(M, C, K, modes), forcing, q0, v0)


class LinearMotion:
    """q(t) for t >= 0; outputs are output.Output."""

    def __init__(self, M, C, K, blocks, forcing, q0, v0):
        self.M, self.C, self.K, self.blocks, self.forcing = M, C, K, blocks, forcing
        self.q0, self.v0 = np.array(q0, float), np.array(v0, float)
        self._pieces = None

    def values(self, output, times, order=0):
        """The order-th derivative of the output at an array of times; just after what jumps there."""
        times = np.asarray(times, float)
        t = times.ravel()
        pieces = self.pieces(t.max(initial=0.0))
        return pieces.terms(output, order).at(*pieces.timeline.place(t)).reshape(times.shape)

    def extreme(self, output, start, end, sense="max"):
        """(t, value) of the largest ("max") or smallest ("min") value for start <= t <= end, the earliest of equals."""
        return searching.extreme(self.pieces(end), output, start, end, sense)

    def zeros(self, output, start, end):
        """All times from `start` to `end` where the output passes or touches zero, ascending."""
        return searching.zeros(self.pieces(end), output, start, end)

    def crossings(self, output, level, start, end):
        """All times from `start` to `end` where the output passes or touches a level, ascending."""
        return self.zeros(output._replace(constant=output.constant - level), start, end)

    def pieces(self, until):
        """The Pieces of the motion up to a time."""
        if self._pieces is None or until > self._pieces.until:
            if self.forcing.period is None:
                until = math.inf
            elif self._pieces is not None:
                until = max(until, 2 * self._pieces.until)
            self._pieces = Pieces(self, until)
        return self._pieces


class Pieces:
    """The motion up to a time, segment by segment: c of each block at their starts, and what drives it."""

    def __init__(self, motion, until):
        self.motion, self.until = motion, until
        forcing = motion.forcing
        self.timeline = timeline = Timeline(forcing.channels, forcing.segments(math.nextafter(until, math.inf)))
        self.drives, self.states = drives(motion.blocks, timeline, len(motion.M) == 1), []
        jumps = timeline.impulses[:, :len(motion.M)]
        struck = np.flatnonzero(jumps.any(axis=1))
        with np.errstate(over="ignore", invalid="ignore"):
            for block, found in zip(motion.blocks, self.drives, strict=True):
                step, added = ends(block, found, timeline)
                added[struck] += jumps[struck] @ block.W.T
                self.states.append(marched(step, added, block.P @ motion.q0 + block.R @ motion.v0))

    def terms(self, output, order):
        """What the order-th derivative of the output is the sum of."""
        return Terms(self, output, order)
