"""Extremes and passages through zero of signals of which no bounds are known: by samples that resolve them.

Stretches within which the signal strays from a straight line by more than a small part of its range are divided, at
places that no period is in step with, until none does.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.isolating_intervals import refused
from vibcli.numerics.bracketing import GOLDEN, maxima_between, zeros_between

if TYPE_CHECKING:
    from vibcli.base.work import Task, Work

SAMPLES, LIMIT = 4001, 3_000_000
STRAIGHT = 2e-3                         # of the range, what a stretch may stray by
ROUNDING = 1e-14                        # of the range


class SampledSearch:
    """times and values from `start` to `end`, `measure` giving the values at an array of times."""

    def __init__(self, measure: Any, start: float, end: float, work: "Work | None") -> None:
        self.measure = measure
        with work.task(f"the sampling of this signal until t = {end:.6g} s", LIMIT, refused) as task:
            self._sample(np.linspace(start, end, SAMPLES), task)
        self.range = np.ptp(self.values)

    def _sample(self, times: np.ndarray, task: "Task") -> None:
        values, rough = self.measure(times), np.ones(len(times) - 1, bool)
        while rough.any():
            at, step = times[:-1][rough], np.diff(times)[rough]
            task.step(steps=2 * len(at))
            inner = np.sort(np.concatenate([at + GOLDEN * step, at + (1 - GOLDEN) * step]))
            found = self.measure(inner)
            low, high = values[:-1][rough], values[1:][rough]
            near, far = found[::2], found[1::2]
            span = max(values.max(), found.max()) - min(values.min(), found.min())
            stray = np.maximum(np.abs(near - low - GOLDEN * (high - low)),
                               np.abs(far - high - GOLDEN * (low - high)))
            bent = (stray > STRAIGHT * span) & (step > 64 * 2.0**-52 * times[-1])
            place = np.flatnonzero(rough) + 1
            marks = np.zeros(len(times), bool)
            marks[place[bent]] = True
            order = np.argsort(np.concatenate([times, inner]), kind="stable")
            fresh = np.concatenate([marks, np.repeat(bent, 2)])[order]
            times, values = (np.concatenate([one, other])[order] for one, other in ((times, inner), (values, found)))
            rough = fresh[1:]       # a stretch that ends at a fresh place
        self.times, self.values = times, values

    def extreme(self, sense: Any) -> tuple[float, float]:
        """(instant, value) of the largest (sense 1) or smallest (−1) value, the earliest of equals."""
        values, times = sense * self.values, self.times
        near = np.flatnonzero(values >= values.max() - 2 * STRAIGHT * self.range)
        near = near[(values[near] >= values[np.maximum(near - 1, 0)])
                    & (values[near] >= values[np.minimum(near + 1, len(times) - 1)])]
        found = maxima_between(lambda t: sense * self.measure(t), *self._beside(near))
        candidates = np.concatenate([times[near], found])
        tops = sense * self.measure(candidates)
        alike = np.flatnonzero(tops >= tops.max() - ROUNDING * self.range)
        best = alike[np.argmin(candidates[alike])]
        return float(candidates[best]), float(sense * tops[best])

    def _beside(self, near: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The samples before and after those at these places."""
        return self.times[np.maximum(near - 1, 0)], self.times[np.minimum(near + 1, len(self.times) - 1)]

    def zeros(self) -> list[float]:
        """Instants at which the signal passes or touches zero."""
        values, times, nothing = self.values, self.times, ROUNDING * np.abs(self.values).max()
        if not nothing:
            return []
        above = values > 0
        at = np.flatnonzero(above[:-1] != above[1:])
        passages = zeros_between(self.measure, times[at], times[at + 1]) if len(at) else times[at]
        size = np.abs(values)
        near = np.flatnonzero((size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:])
                              & (size[1:-1] <= 2 * STRAIGHT * self.range)) + 1
        near = near[(above[near - 1] == above[near]) & (above[near] == above[near + 1])]
        touches = maxima_between(lambda t: -np.abs(self.measure(t)), *self._beside(near))
        touches = touches[np.abs(self.measure(touches)) <= nothing] if len(near) else touches
        first = times[:1][size[:1] <= nothing]
        found, apart = np.sort(np.concatenate([first, passages, touches])), 1e-12 * times[-1]
        return found[np.append(True, np.diff(found) > apart)].tolist() if len(found) else []
