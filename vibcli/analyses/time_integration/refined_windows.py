"""Windows of few coordinates that move smoothly: a rough guess by explicit steps in plain floats
(numerics/dormand_prince.py), refined in all windows of a stretch at once (refinement.py).

Each window holds as many steps as it resolves: where these are very many, stability keeps them short, the forces are
stiff, and collocation goes on.
"""

from collections.abc import Callable, Sequence
from math import log
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import Window, ended
from vibcli.analyses.time_integration.refinement import ManyWindows, grids
from vibcli.analyses.time_integration.smooth_pieces import bent, may_hide
from vibcli.mechanics.float_equations import FloatEquations, float_equations
from vibcli.numerics.dormand_prince import stepper
from vibcli.numerics.hermite import quintic
from vibcli.symbolic.numeric_code import rooted

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.time_stepping import March
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.mechanics.switching import Switching

COORDINATES, WORK = 12, 3000        # operations in plain floats for q̈: beyond these windows by collocation cost less
LONG = 150.0            # radians of the fastest oscillation that are worth steps of their own
POINTS = (40, 14), (32, 12)     # of windows, and of changes of them: of the first solution and of the second
ROUGH = 1e-4            # error of a step, relative to the motion
FEW, MANY, LEAST = 16, 512, 4   # steps of a stretch, to begin with, and at most; without a window: stop
MORE, AGAIN = 4.0, 1.1  # the next stretch; once part of one was not found
TOGETHER, HELD_BESIDE = 64, 0.72    # windows of a first solution in a stretch, and in a window of the second
HELD, STIFF = 2.5, 64.0     # of them in a window, to begin with; where more fit, forces are stiff
RESOLVED, LAST = 0.95, 3    # of the coefficients of a window, that are to be used; those that must be small
SMALL, SPLIT = 10.0, 1e3    # the last ones: of what need not be resolved; where halves of a window are tried
LONGER, FALL = 1.5, 3.0         # the next windows; of coefficients, from one to the next where they are small
PART = 1e-3             # of the error of a step, that iterations may leave
NEAR = 1e-6             # of the motion: how far neighbours are from it
SHORTEST = 1e-13        # of the time gone: a step
SAFE, SLOWER, FASTER = 0.9, 0.3, 5.0        # of the step that the error allows; of the step before
SPENT = 1000            # steps tried for one stretch


def refinable(system: "NumericEquations", switching: "Switching", driven: Any) -> FloatEquations | None:
    """The equations of a system in plain floats; None where collocation is better: of many coordinates and long
    expressions, where loops are closed, where something bends, jumps, is the root of what vanishes, or is a pulse that
    may be stepped over."""
    scene, nodes = system.scene, system.parts.nodes()
    if system.m or system.n > COORDINATES or switching.count or len(driven) or rooted(nodes) or bent(nodes) or (
            may_hide(scene, nodes)):
        return None
    found = float_equations(system)
    return found if found is not None and found.work <= WORK else None


class RefinedWindows:
    """Of a motion whose windows are resolved to `rtol` of its size; first: the solution beside which a second one is
    found, the guess of it as long as it is near."""

    def __init__(self, equations: FloatEquations, n: int, rtol: float, first: "Trajectory | None" = None) -> None:
        self.force, self.rtol, self.step = equations.accelerations, rtol, stepper(n)
        self.grids = grids(*POINTS[first is not None])
        self.first, self.more, self.given_up, self.h = first, MORE, False, 0.0
        self.steps, self.held = (FEW, HELD) if first is None else (TOGETHER, HELD_BESIDE)

    def pay(self, march: "March", limit: float) -> bool:
        """Is what is left up to an instant long enough for them?"""
        return not self.given_up and limit - march.t > LONG * march.sizes.radian

    def follow(self, march: "March", limit: float) -> None:
        """Go on to an instant, or to where forces have no value or are stiff: there they are given up."""
        self.h = self.h or ROUGH**0.125 * float(march.sizes.radian)
        while not self.given_up and limit - march.t > 1e-15 * limit:
            times, a, guess = self._stepped(march, limit) if self.first is None else self._followed(march, limit)
            self.given_up = len(times) < 2 or not self._keep(march, times, a, guess) or march.pace.slow

    def _followed(self, march: "March",
                  limit: float) -> tuple[np.ndarray, np.ndarray, Callable[[np.ndarray], list[np.ndarray]]]:
        """(instants between the next windows of the first solution, q̈ at their start, a guess of states)."""
        first, t = self.first, float(march.t)
        starts = first.starts[first.number(t) + 1:][:self.steps]
        times = np.array([t, *starts[(starts > t + SHORTEST * limit) & (starts < limit)]])

        def guess(at: np.ndarray) -> "list[np.ndarray]":
            return [row.reshape(-1, *at.shape).swapaxes(0, 1) for row in first.at(at.ravel())[:2]]

        return np.append(times, limit) if len(starts) < self.steps else times, first.at([t])[2][:, 0], guess

    def _stepped(self, march: "March",
                 limit: float) -> tuple[np.ndarray, np.ndarray, Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]]:
        """(instants at the start and at the ends of the next steps, as many as have numbers, q̈ at the first, a guess of
        states)."""
        t, limit = float(march.t), float(limit)       # NumPy's numbers would slow all others
        q, v, h, tries = tuple(march.q.tolist()), tuple(march.v.tolist()), self.h, 0
        times, states, accelerations = [], [], []
        try:
            a = self.force(t, *q, *v)
            weights = self._weights(march, a)
            times, states, accelerations = [t], [(*q, *v)], [a]
            while len(times) <= self.steps and limit - t > 1e-15 * limit and tries < SPENT:
                tries, h = tries + 1, min(h, limit - t)
                error, q1, v1, a1 = self.step(self.force, t, h, q, v, a, weights)
                if error <= 1:
                    t, q, v, a = t + h, q1, v1, a1
                    times.append(t)
                    states.append((*q, *v))
                    accelerations.append(a)
                grown = min(SAFE * error ** -0.125, FASTER) if error else FASTER
                h *= max(grown, SLOWER) if grown == grown else SLOWER
                if not h > SHORTEST * t:
                    break
        except (ArithmeticError, ValueError, TypeError):    # overflow, 1/0; a logarithm, a root of what is negative
            pass
        self.h = h
        values = np.array([[*state, *a] for state, a in zip(states, accelerations, strict=True)])
        fine = int(np.cumprod(np.isfinite(values).all(axis=1)).sum()) if len(values) else 0
        if fine < 2:
            return np.array([]), None, None
        times, values = np.array(times)[:fine], np.split(values[:fine], 3, axis=1)
        return times, values[2][0], quintic(times, *values)

    def _weights(self, march: "March", a: tuple[float, ...]) -> tuple[float, ...]:
        """1/(the error that is allowed of a step) of each place and velocity."""
        radian, places = march.sizes.radian, ROUGH * march.sizes.scale(march.sizes.radian, march.v, np.array(a))
        return (*(1.0 / places).tolist(), *(radian / places).tolist())

    def _keep(self, march: "March", times: np.ndarray, a: np.ndarray, guess: Callable[[np.ndarray], Any]) -> bool:
        """Move on by as many windows as are found and resolved; may there be more?"""
        n, count = len(march.q), len(times) - 1
        edges = np.interp(np.linspace(0, count, max(round(count / self.held), 1) + 1), np.arange(count + 1), times)
        windows, ends = self._windows(march, edges, a, guess)
        whole = len(windows) == len(edges) - 1
        self.more = min(LONGER * self.more, MORE) if whole else AGAIN
        self.steps = min(int(self.more * (self.steps if whole else len(windows) * self.held)) + 1, MANY)
        if not whole and self.first is not None:        # it has left this one
            self.first, self.steps, self.held = None, FEW, HELD
            count = FEW
        if not windows:
            return count > LEAST
        resolved, taken = self._resolved(march, windows)
        march.take(resolved, [*((window.q, window.v) for window in resolved[1:]), (ends[taken, :n], ends[taken, n:])]
                   if taken else [], coarse=True)
        return LEAST / FEW < self.held < STIFF

    def _windows(self, march: "March", edges: np.ndarray, a: np.ndarray,
                 guess: Callable[[np.ndarray], Any]) -> tuple[list[Window], np.ndarray]:
        """(the Windows between instants, as many from the first on as are found, states between them), from q̈ at their
        start and a guess of their states."""
        start = np.concatenate([march.q, march.v])
        system, radian = march.system, march.sizes.radian
        stretch = ManyWindows(system.accelerations, system.by_state, self.grids, edges, start)
        scale = march.sizes.scale(radian, march.v, a)
        try:
            found, A, (ends, Q, *_) = stretch.refined(guess, PART * self.rtol * scale,
                                                      NEAR * np.concatenate([scale, scale / radian]))
        except np.linalg.LinAlgError:
            found = 0
        if not found:
            return [], march.q
        n = len(a)
        march.sizes.meet(A[:found].transpose(1, 0, 2).reshape(n, -1))
        for place in (Q[:found].min(axis=(0, 2)), Q[:found].max(axis=(0, 2))):
            march.sizes.move(place)
        return [Window(self.grids.fine, edges[k], stretch.lengths[k], ends[k, :n], ends[k, n:], A[k], march.g, ())
                for k in range(found)], ends

    def _resolved(self, march: "March", windows: list[Window]) -> tuple[list[Window], int]:
        """(windows whose last coefficients are small, up to the end of how many of those at hand). One that is resolved
        by halves is split, its ends being better than what is between them. The next ones become longer or shorter."""
        sizes, found = self._coefficients(march, windows), []
        used, last = np.flatnonzero((sizes > 1).any(axis=0)).max(initial=0) + 1, sizes[:, -LAST:].max(axis=1)
        used += log(max(last.max(), 1.0)) / log(FALL)
        self.held *= min(RESOLVED * len(sizes[0]) / used, LONGER)
        for k, window in enumerate(windows):
            parts = [window] if last[k] <= SMALL else self._halves(march, window) if last[k] <= SPLIT else []
            if not parts:
                return found, k
            found += parts
        return found, len(windows)

    def _halves(self, march: "March", window: Window) -> list[Window]:
        """The two halves of a window, with q̈ from its states; nothing where these are not resolved."""
        rule, half = self.grids.fine, 0.5 * window.length
        tau = half * np.concatenate([rule.c, 1.0 + rule.c])
        A = march.accelerations(window.start + tau, *window.states(tau)[:2])
        one = Window(rule, window.start, half, window.q, window.v, A[:, :rule.points], march.g, ())
        other = Window(rule, window.start + half, half, *one.state(half)[:2], A[:, rule.points:], march.g, ())
        found = [one, ended(other, *window.state(window.length)[:2])]
        return found if (self._coefficients(march, found)[:, -LAST:] <= SMALL).all() else []

    def _coefficients(self, march: "March", windows: Sequence[Window]) -> np.ndarray:
        """Those of q̈, the largest relative to what need not be resolved, of shape (windows, points)."""
        H = np.array([window.length for window in windows])[:, None, None]
        scale = march.sizes.scale(H.max(), 0.0 * march.v, 0.0 * march.v)[:, None]
        series = np.array([window.series for window in windows])
        return np.asarray((np.abs(series) / march.resolved(H, scale, self.grids.fine, self.rtol)).max(axis=1))
