"""Stretches of time within the segments of a motion, how they are divided, and the root of a function in each."""

import numpy as np

EPSILON = 2.0**-52
NEWTON = 60
PARTS, LEVELS = 4, 60           # of a division, and divisions
MOST, STEP = 500_000, 1000      # steps of a search, and values of one exponential each that are found in one of them
HAIR = 8                        # roundings of a time within which nothing is told apart
BATCH = 400                     # steps that are done together, so that the memory does not grow with their number


class Cells:
    """Stretches early <= τ <= late of segments."""

    __slots__ = ("early", "late", "segment")

    def __init__(self, segment, early, late):
        self.segment, self.early, self.late = segment, early, late

    def __len__(self):
        return len(self.early)

    @property
    def width(self):
        return self.late - self.early

    def where(self, mask):
        """Those where the mask holds."""
        return Cells(self.segment[mask], self.early[mask], self.late[mask])

    def divided(self, parts):
        """Each in equal parts."""
        edges = self.early[:, None] + self.width[:, None] * (np.arange(parts + 1) / parts)
        edges[:, -1] = self.late
        return Cells(np.repeat(self.segment, parts), edges[:, :-1].ravel(), edges[:, 1:].ravel())

    def doubling(self, first):
        """Each in parts the first of which is `first` long and every next one twice as long."""
        longest = self.width.max(initial=0.0)
        steps = first * 2.0 ** np.arange(max(0, np.ceil(np.log2(longest / first))) if longest > first else 0)
        cuts = np.minimum(np.append(0.0, steps), np.inf)
        early = self.early[:, None] + cuts
        late = np.minimum(np.append(early[:, 1:], np.full((len(self), 1), np.inf), axis=1), self.late[:, None])
        held = early < self.late[:, None]
        held[:, 0] = True
        return Cells(np.repeat(self.segment, len(cuts))[held.ravel()], early[held], late[held])

    @staticmethod
    def together(parts):
        """All of several."""
        return Cells(*(np.concatenate([getattr(part, name) for part in parts])
                       for name in ("segment", "early", "late")))


def stretches(timeline, start, end):
    """The Cells of the segments between two times, one each."""
    first, last = timeline.place(np.array([start, end]))[0]
    segment = np.arange(first, last + 1)
    starts = timeline.starts[segment]
    return Cells(segment, np.maximum(start - starts, 0.0), np.minimum(timeline.lengths[segment], end - starts))


def first_cells(timeline, y, start, end):
    """Cells that grow with time, the first a part of the fastest wave's period."""
    speed, cells = fastest(y), stretches(timeline, start, end)
    return cells.doubling(1 / speed) if speed else cells


def fastest(y):
    """The largest magnitude of an exponent."""
    return max((abs(node) for nodes in y.nodes() for node in nodes), default=0.0)


def instants(timeline, cells, y):
    """Which of the cells are so short that nothing changes within them but by rounding."""
    speed = fastest(y)
    shortest = 1 / speed if speed else 0.0
    return cells.width <= HAIR * EPSILON * np.maximum(timeline.starts[cells.segment] + cells.late, shortest)


def batches(cells, y):
    """[(slice of the cells, Cells of its parts)] of all the cells divided."""
    many = max(1, BATCH * STEP // (PARTS * len(y.nodes()) or 1))
    parts = [slice(i, i + many) for i in range(0, len(cells), many)]
    return [(part, cells.where(part).divided(PARTS)) for part in parts]


def steps(cells, y):
    """The steps that looking at the cells takes."""
    return len(cells) * len(y.nodes()) / STEP


def root(function, derivative, cells):
    """The zero of the function in each cell, by Newton's method held within the bracket; where it does not change sign,
    the end where it is least."""
    low, high = cells.early.copy(), cells.late.copy()
    left, right = function.at(cells.segment, low), function.at(cells.segment, high)
    rising, moving = right > left, left * right < 0
    with np.errstate(all="ignore"):
        tau = np.where(moving, low - left * ((high - low) / (right - left)), np.where(
            np.abs(left) <= np.abs(right), low, high))
    for _ in range(NEWTON):
        if not moving.any():
            break
        at, here = cells.segment[moving], tau[moving]
        value = function.at(at, here)
        up = (value > 0) == rising[moving]
        high[moving], low[moving] = np.where(up, here, high[moving]), np.where(up, low[moving], here)
        with np.errstate(all="ignore"):
            step = here - value / derivative.at(at, here)
        inside = (step >= low[moving]) & (step <= high[moving])
        step = np.where(value == 0, here, np.where(inside, step, (low[moving] + high[moving]) / 2))
        tau[moving] = step
        moving[np.flatnonzero(moving)[np.abs(step - here) <= EPSILON * np.abs(here)]] = False
    return tau
