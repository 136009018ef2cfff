"""Windows made of explicit steps in plain floats (numerics/dormand_prince.py), of few coordinates that move smoothly.

A window is the polynomial through q̈ at Gauss's points, found where the steps are then, which takes the state at its
start to that at its end. It holds as many steps as it resolves: where these are very few or very many, stability keeps
them short, the forces are stiff, and collocation goes on.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import Window, ended
from vibcli.analyses.time_integration.smooth_pieces import bent, may_hide
from vibcli.mechanics.float_equations import FloatEquations, float_equations
from vibcli.numerics.dormand_prince import END, STAGE_MATRIX, STAGES, stepper, weights
from vibcli.symbolic.numeric_code import rooted

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.time_stepping import March
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.mechanics.switching import Switching

COORDINATES, WORK = 12, 3000        # operations in plain floats for q̈: beyond these windows by collocation cost less
LONG = 150.0            # radians of the fastest oscillation that are worth steps of their own
FEW = 8                 # steps in a window, to begin with
LEAST, MOST = 3, 64     # of them: where fewer or more fit, stability keeps them short, and forces are stiff
RESOLVED, LAST = 0.5, 3     # of the coefficients of a window, below which the next one is longer; those that are small
SHORTEST = 1e-13        # of the time gone: a step
SAFE, SLOWER, FASTER = 0.9, 0.3, 5.0        # of the step that the error allows; of the step before
ROUGH = 10.0            # by which q̈ between the ends of steps is rougher than that of collocation
SPENT = 1000            # steps tried for one window


def explicit(system: "NumericEquations", switching: "Switching", driven: Any) -> FloatEquations | None:
    """The equations of a system in plain floats; None where collocation is better: of many coordinates and long
    expressions, where loops are closed, where something bends, jumps, is the root of what vanishes, or is a pulse that
    may be stepped over."""
    scene, nodes = system.scene, system.parts.nodes()
    if system.m or system.n > COORDINATES or switching.count or len(driven) or rooted(nodes) or bent(nodes) or (
            may_hide(scene, nodes)):
        return None
    found = float_equations(system)
    return found if found is not None and found.work <= WORK else None


class ExplicitWindows:
    """Of a motion whose steps are errors of `tolerance`, relative to its size, so that `rtol` is left of each."""

    def __init__(self, equations: FloatEquations, n: int, tolerance: float, rtol: float):
        self.force, self.tolerance, self.rtol = equations.accelerations, tolerance, rtol
        self.most, self.given_up, self.h = FEW, False, 0.0
        self.step, self.dense = stepper(n)

    def pay(self, march: "March", limit: float) -> bool:
        """Is what is left up to an instant long enough for them?"""
        return not self.given_up and limit - march.t > LONG * march.sizes.radian

    def follow(self, march: "March", limit: float) -> None:
        """Go on to an instant, or to where forces have no value or are stiff: there they are given up."""
        self.h = self.h or self.tolerance**0.125 * float(march.sizes.radian)
        while not self.given_up and limit - march.t > 1e-15 * limit:
            lengths, states, stages = self._steps(march, limit)
            if not len(lengths):
                self.given_up = True
                return
            self._keep(march, lengths, states, stages)
            self.given_up = march.slow or not LEAST <= self.most <= MOST

    def _steps(self, march, limit):
        """(lengths, states (q, q̇) at the start of each and at the end, stages of q̈) of the next steps, of shapes
        (steps), (steps + 1, 2n) and (steps, stages, n), as many as are numbers."""
        t, limit = float(march.t), float(limit)       # NumPy's numbers would slow all others
        q, v, h, tries = tuple(march.q.tolist()), tuple(march.v.tolist()), self.h, 0
        lengths, states, stages = [], [(*q, *v)], []
        try:
            a = self.force(t, *q, *v)
            sizes = self._weights(march, a)
            while len(lengths) < self.most and limit - t > 1e-15 * limit and tries < SPENT:
                tries, h = tries + 1, min(h, limit - t)
                error, q1, v1, found = self.step(self.force, t, h, q, v, a, sizes)
                if error <= 1:
                    stages.append((*found, *self.dense(self.force, t, h, q, v, found)))
                    lengths.append(h)
                    states.append((*q1, *v1))
                    t, q, v, a = t + h, q1, v1, found[END]
                grown = min(SAFE * error ** -0.125, FASTER) if error else FASTER
                h *= max(grown, SLOWER) if grown == grown else SLOWER
                if not h > SHORTEST * t:
                    break
        except (ArithmeticError, ValueError, TypeError):    # overflow, 1/0; a logarithm, a root of what is negative
            pass
        self.h, count = h, len(stages)
        stages = np.array(stages[:count]).reshape(count, STAGES, len(q))
        fine = int(np.cumprod(np.isfinite(stages).all(axis=(1, 2))).sum())
        return np.array(lengths)[:fine], np.array(states)[:fine + 1], stages[:fine]

    def _weights(self, march, a):
        """1/(the error that is allowed of a step) of each place and velocity."""
        radian = march.sizes.radian
        places = self.tolerance * march.sizes.scale(radian, march.v, np.array(a))
        return (*(1.0 / places).tolist(), *(radian / places).tolist())

    def _keep(self, march, lengths, states, stages):
        """Move on by a window of as many of the steps as it resolves."""
        count = len(lengths)
        while True:
            window = self._window(march, lengths[:count], states[:count + 1], stages[:count])
            scale = march.sizes.scale(window.length, window.v, window.values[:, 0])[:, None]
            sizes = march.coefficients(window.length, window.values) / march.allowed(window.length, scale)
            sizes = sizes.max(axis=0) * (march.rtol / (ROUGH * self.rtol))
            if count == 1 or sizes[-LAST:].max() <= 1:
                break
            count = self.most = max(3 * count // 4, 1)
        used = np.flatnonzero(sizes > 1)
        if count == self.most and (used[-1] + 1 if len(used) else 1) < RESOLVED * len(sizes):
            self.most += self.most // 2 + 1
        n = len(march.q)
        march.take(window, states[count, :n], states[count, n:], explicit=True)

    def _window(self, march, lengths, states, stages):
        rule, n, ends = march.rule, len(march.q), np.cumsum(lengths)
        H, starts = ends[-1], ends - lengths
        tau = H * rule.c
        number = np.searchsorted(ends[:-1], tau, side="right")
        parts = weights((tau - starts[number]) / lengths[number]) * lengths[number, None]
        speeds = states[:-1, None, n:] + lengths[:, None, None] * (STAGE_MATRIX @ stages)
        Q, V = (states[number, first:first + n].T + np.einsum("tsn,ts->nt", slopes[number], parts)
                for first, slopes in ((0, speeds), (n, stages)))
        A = march.accelerations(march.t + tau, Q, V)
        return ended(Window(rule, march.t, H, march.q, march.v, A, march.g, ()), states[-1, :n], states[-1, n:])
