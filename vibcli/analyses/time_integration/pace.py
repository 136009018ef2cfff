"""The pace of a march through time: where it would not come to the end within its work, it is slow, or stopped."""

import numpy as np

from vibcli.base.work import Spent, Task

STEPS, HOPELESS = 2_000, 10     # after which the pace is looked at; how far beyond the limit is hopeless
LONG = 0.05                 # of the limit: so much work a fast oscillation is not worth that moves next to nothing


class Pace:
    """Of windows up to t = `until`, each a step of the task; slow: are as many to come as are not worth it?"""

    def __init__(self, until: float, task: Task) -> None:
        self.until, self.task, self.tries, self.seen, self.slow = until, task, 0, 0.0, False

    def step(self, t: float, stiff: bool) -> None:
        """Another window from t on; Spent where there will be too many, at the pace of the last ones."""
        self.task.step(t / self.until)
        self.tries += 1
        if self.tries % STEPS == 0:
            before, self.seen = self.seen, t
            needed = STEPS * (self.until - t) / (t - before) if t > before else np.inf
            self.slow = needed > LONG * self.task.limit
            if needed > HOPELESS * self.task.limit and (stiff or self.tries > STEPS):
                raise Spent(self.task)

    def forget(self) -> None:
        """Begin anew: what made it slow may be stepped over."""
        self.slow = False
