"""Where an output is largest, and where it is zero: nothing is missed between the points looked at.

Between two points a distance h apart a function strays from the straight line by no more than B h²/8, B a bound of its
second derivative there, which sums of exponentials give. Stretches that can hold nothing are left out, the others
divided.
"""

import numpy as np

EPSILON = 2.0**-52
FIRST, PARTS, LEVELS = 256, 4, 24
MOST = 400_000
FINE = 1e-6


class Cells:
    """Stretches early <= τ <= late of segments, with the output at both ends."""

    def __init__(self, segment, early, late):
        self.segment, self.early, self.late = segment, early, late

    def __len__(self):
        return len(self.early)

    def where(self, mask):
        """Those where the mask holds."""
        return Cells(self.segment[mask], self.early[mask], self.late[mask])

    @staticmethod
    def together(parts):
        """All of several."""
        return Cells(*(np.concatenate([getattr(part, name) for part in parts])
                       for name in ("segment", "early", "late")))

    def divided(self, parts):
        """Each in equal parts."""
        edges = self.early[:, None] + (self.late - self.early)[:, None] * (np.arange(parts + 1) / parts)
        edges[:, -1] = self.late
        return Cells(np.repeat(self.segment, parts), edges[:, :-1].ravel(), edges[:, 1:].ravel())


def stretches(timeline, start, end):
    """The Cells of the segments between two times, one each."""
    first, last = timeline.place(np.array([start, end]))[0]
    segment = np.arange(first, last + 1)
    starts = timeline.starts[segment]
    early = np.maximum(start - starts, 0.0)
    late = np.minimum(timeline.lengths[segment], end - starts)
    return Cells(segment, early, late)


def extreme(pieces, output, start, end, sense):
    """(t, value) of the largest or smallest value of the output, also where it jumps or has a kink."""
    sign = -1.0 if sense == "min" else 1.0
    timeline = pieces.timeline
    y, slope, curvature = (pieces.terms(output, order) for order in range(3))
    cells = stretches(timeline, start, end)
    cells = cells.divided(max(8, FIRST // len(cells)))
    times, values, best, scale = [], [], -np.inf, 0.0
    for _ in range(LEVELS):
        ends = [sign * y.at(cells.segment, tau) for tau in (cells.early, cells.late)]
        for found, tau in zip(ends, (cells.early, cells.late), strict=True):
            times.append(timeline.starts[cells.segment] + tau)
            values.append(found)
            best, scale = max(best, found.max()), max(scale, np.abs(found).max())
        width = cells.late - cells.early
        room = curvature.bound(cells.segment, cells.early, cells.late) * width**2 / 8
        cells, room = _kept(cells, room, np.maximum(*ends) + room >= best - 4 * EPSILON * scale)
        if len(cells) > MOST or not (room > FINE * scale).any():
            break
        cells = cells.divided(PARTS)
    rises, falls = (sign * slope.at(cells.segment, tau) for tau in (cells.early, cells.late))
    peaks = cells.where((rises >= 0) & (falls <= 0))
    tau = root(slope, curvature, peaks)
    times.append(timeline.starts[peaks.segment] + tau)
    values.append(sign * y.at(peaks.segment, tau))
    times, values = np.concatenate(times), np.concatenate(values)
    best = values.max()
    near = values >= best - 4 * EPSILON * scale
    at = np.flatnonzero(near)[np.argmin(times[near])]
    return float(times[at]), float(sign * values[at])


def _kept(cells, room, mask):
    return cells.where(mask), room[mask]


def zeros(pieces, output, start, end):
    """All times where the output passes or touches zero, ascending; where it rests at zero, none."""
    timeline = pieces.timeline
    y, slope, curvature = (pieces.terms(output, order) for order in range(3))
    cells = stretches(timeline, start, end)
    cells = cells.where(y.bound(cells.segment, cells.early, cells.late) > 0)
    found, closest = _jumps(timeline, y, cells), []
    cells = cells.divided(max(8, FIRST // max(1, len(cells))))
    for _ in range(LEVELS):
        left, right = (y.at(cells.segment, tau) for tau in (cells.early, cells.late))
        width = cells.late - cells.early
        bend = curvature.bound(cells.segment, cells.early, cells.late)
        rounding = 4 * EPSILON * y.bound(cells.segment, cells.early, cells.late)
        rise = width * np.maximum(*(np.abs(slope.at(cells.segment, tau)) for tau in (cells.early, cells.late)))
        steep = (rise > bend * width**2) & (rise > 4 * rounding)
        through = (left * right < 0) | (left == 0) | (right == 0)
        single = cells.where(steep & through)
        found.append(timeline.starts[single.segment] + root(y, slope, single))
        room = bend * width**2 / 8 + rounding
        unsure = ~steep & (through | (np.minimum(np.abs(left), np.abs(right)) <= room))
        close = room <= 2 * rounding
        closest.append(cells.where(unsure & close))
        cells = cells.where(unsure & ~close)
        if not len(cells) or len(cells) > MOST:
            break
        cells = cells.divided(PARTS)
    closest = Cells.together([*closest, cells])
    if len(closest):
        found.append(_touching(timeline, y, slope, curvature, closest))
    return _distinct(np.concatenate(found), EPSILON * 4 * max(abs(start), abs(end)))


def _jumps(timeline, y, cells):
    """Times where one segment leaves the output on one side of zero and the next finds it on the other."""
    follow = np.flatnonzero(cells.segment[1:] == cells.segment[:-1] + 1)
    before = y.at(cells.segment[follow], cells.late[follow])
    after = y.at(cells.segment[follow + 1], cells.early[follow + 1])
    return [timeline.starts[cells.segment[follow + 1][before * after < 0]]]


def _touching(timeline, y, slope, curvature, cells):
    """Times where the output turns but rounding away from zero, one in each run of undecided cells."""
    order = np.lexsort((cells.early, cells.segment))
    segment, early, late = (part[order] for part in (cells.segment, cells.early, cells.late))
    first = np.append(True, (segment[1:] > segment[:-1]) | (early[1:] > late[:-1]))
    runs = Cells(segment[first], early[first], late[np.append(first[1:], True)])
    tau = root(slope, curvature, runs)
    rounding = 16 * EPSILON * y.bound(runs.segment, runs.early, runs.late)
    return (timeline.starts[runs.segment] + tau)[np.abs(y.at(runs.segment, tau)) <= rounding]


def _distinct(times, apart):
    """Times in ascending order, those nearer than `apart` but once."""
    times = np.sort(times)
    return times[np.append(True, np.diff(times) > apart)] if len(times) else times


def root(function, derivative, cells):
    """The zero of the function in each cell, by Newton's method held within the bracket; where it does not change sign,
    the end where it is least."""
    low, high = cells.early.copy(), cells.late.copy()
    left, right = function.at(cells.segment, low), function.at(cells.segment, high)
    rising = right > left
    tau = np.where(np.abs(left) <= np.abs(right), low, high)
    moving = left * right < 0
    with np.errstate(all="ignore"):
        tau = np.where(moving, low - left * (high - low) / (right - left), tau)
    for _ in range(60):
        if not moving.any():
            break
        at = cells.segment[moving]
        value, here = function.at(at, tau[moving]), tau[moving]
        up = (value > 0) == rising[moving]
        high[moving], low[moving] = np.where(up, here, high[moving]), np.where(up, low[moving], here)
        with np.errstate(all="ignore"):
            step = here - value / derivative.at(at, here)
        middle = (low[moving] + high[moving]) / 2
        step = np.where((step > low[moving]) & (step < high[moving]), step, middle)
        done = (value == 0) | (np.abs(step - here) <= EPSILON * np.abs(here)) | (high[moving] - low[moving] <=
                                                                                EPSILON * np.abs(here))
        tau[moving] = np.where(value == 0, here, step)
        moving[np.flatnonzero(moving)[done]] = False
    return tau
