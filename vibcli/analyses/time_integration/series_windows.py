"""Windows made of steps by Taylor series that are compiled (mechanics/compiled_series.py), of long smooth motions.

A window is the polynomial through q̈ at Gauss's points, where the series know the state, which takes the state at its
start to that at its end. It holds as many steps as it resolves. Where the forces on the way do not lead to that end, as
where what was too small for the series to be seen grows within a step, the march goes on otherwise from there.
"""

from collections.abc import Sequence
from math import sqrt
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import Window, ended
from vibcli.mechanics.compiled_series import CompiledSeries, is_installed

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.time_stepping import March
    from vibcli.mechanics.numeric_equations import NumericEquations

PAYS = 14_000.0         # radians · √(operations for q̈), beyond which importing the engine and compiling take less
AT_ONCE, FIRST = 2_000, 2   # steps; windows, as long as they grow
FEW, MOST = 12, 64      # steps in a window, to begin with; where more fit, stability keeps them short: forces are stiff
RESOLVED, LAST = 0.6, 3     # of the coefficients of a window, below which the next one is longer; those that are small
WIDE = 8.0              # radians of the fastest oscillation in a window at most: changes of it are to be known as well
IDLE = 0.3              # of the coefficients of one so long, below which nothing of that oscillation is in it
ASTRAY = 1e-10          # of the motion: what the forces on the way may lack of the end of a window
TOLERANCES = 2.0**-52, 1e-18    # of a step: of the first solution, and of the second, by series of higher order


class SeriesWindows:
    """Of a system whose q̈ takes `work` operations; again: for a second solution."""

    def __init__(self, system: "NumericEquations", work: int, again: bool) -> None:
        self.system, self.work, self.tolerance = system, work, TOLERANCES[again]
        self.given_up, self.most = False, FEW

    def pay(self, march: "March", limit: float) -> bool:
        """Is there an engine, and what is left up to an instant long enough for it?"""
        long = (limit - march.t) * sqrt(self.work) > PAYS * march.sizes.radian
        return long and not self.given_up and is_installed()

    def follow(self, march: "March", limit: float) -> None:
        """Go on to an instant, or to where forces have no value or are stiff: there they are given up."""
        try:
            series = CompiledSeries(self.system, march.t, [*march.q, *march.v], self.tolerance)
        except (ImportError, ArithmeticError, ValueError):
            self.given_up = True
            return
        grows = True
        while not self.given_up and limit - march.t > 1e-15 * limit:
            before, (ends, states) = self.most, series.steps(limit, FIRST * self.most if grows else AT_ONCE)
            if len(ends):
                self._keep(march, np.append(march.t, ends), states)
            grows = self.most > before
            self.given_up |= not len(ends) or march.pace.slow or self.most > MOST

    def _keep(self, march: "March", instants: np.ndarray, states: Any) -> None:
        """Move on by windows, each of as many steps as it resolves; instants: their ends."""
        widest = max(int(WIDE * march.sizes.radian * (len(instants) - 1) / (instants[-1] - instants[0])), 1)
        while True:
            cuts = np.unique([*range(0, len(instants), min(self.most, widest)), len(instants) - 1])
            raw, ends = self._windows(march, instants[cuts], states)
            windows = [ended(window, *end) for window, end in zip(raw, ends, strict=True)]
            unresolved = _unresolved(march, windows)
            if self.most == 1 or not (unresolved[-LAST:] > 1).any():
                break
            self.most = max(3 * self.most // 4, 1)
        there = _there(march, raw, windows)
        self.given_up = there < len(windows)
        for window in windows[:there]:
            march.sizes.meet(window.values)
        march.take(windows[:there], ends[:there])
        used = np.flatnonzero(unresolved > 1)
        part = (used[-1] + 1 if len(used) else 1) / len(unresolved)
        if part < (RESOLVED if self.most <= widest else IDLE):
            self.most += self.most // 2 + 1

    def _windows(self, march: "March", instants: np.ndarray,
                 states: Any) -> tuple[list[Window], list[tuple[np.ndarray, np.ndarray]]]:
        """(the Windows between instants, (q, q̇) at their ends)."""
        rule, n, starts, lengths = march.rule, len(march.q), instants[:-1], np.diff(instants)
        times = (starts[:, None] + lengths[:, None] * rule.c).ravel()
        Q, V = states(times).T.reshape(2, n, -1)
        A = march.accelerations(times, Q, V)
        march.sizes.meet(A)
        for q in (Q.min(axis=1), Q.max(axis=1)):
            march.sizes.move(q)
        ends = [(march.q, march.v), *((row[:n], row[n:]) for row in states(instants[1:]))]
        values = A.reshape(n, len(lengths), rule.points)
        windows = [Window(rule, start, length, *before, A, march.g, ()) for start, length, before, A in
                   zip(starts, lengths, ends[:-1], values.transpose(1, 0, 2), strict=True)]
        return windows, ends[1:]


def _there(march: "March", raw: Sequence[Window], windows: Sequence[Window]) -> int:
    """How many of the `raw` windows, from the first on, end where the forces on the way lead, or have no numbers."""
    sizes = march.sizes.scale(max(window.length for window in raw), 0.0 * march.v, 0.0 * march.v)[:, None]
    lacking = [float((np.abs(one.values - window.values) * window.length**2 / sizes).max())
               for one, window in zip(windows, raw, strict=True)]
    return int(np.cumprod(~(np.array(lacking) > ASTRAY)).sum())


def _unresolved(march: "March", windows: Sequence[Window]) -> np.ndarray:
    """The coefficients of each order, relative to what need not be resolved."""
    H = max(window.length for window in windows)
    allowed = march.allowed(H, march.sizes.scale(H, 0.0 * march.v, 0.0 * march.v)[:, None])
    found: np.ndarray = np.max([march.coefficients(window.length, window.values) / allowed for window in windows],
                               axis=(0, 1))
    return found
