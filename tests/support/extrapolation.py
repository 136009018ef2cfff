"""Motions of hand-written equations to many digits: a modified midpoint rule, extrapolated (Bulirsch and Stoer)."""

import mpmath

STAGES = 14


def solved(slope, start, end, digits):
    """[y] at t = end of y′ = slope(t, y), y(0) = start, in mpmath numbers."""
    with mpmath.workdps(digits + 15):
        y, t, end, step = [mpmath.mpf(x) for x in start], mpmath.mpf(0), mpmath.mpf(end), mpmath.mpf(end) / 16
        while t < end:
            step = min(step, end - t)
            found, stages = _stepped(slope, t, y, step, mpmath.mpf(10) ** -(digits + 3))
            if found is None:
                step /= 2
                continue
            t, y = t + step, found
            if stages < STAGES - 3:
                step *= mpmath.mpf(3) / 2
        return y


def _stepped(slope, t, y, step, tolerance):
    """(y after a step, stages), (None, STAGES) where they do not settle."""
    rows = []
    for stage in range(STAGES):
        count = 2 * (stage + 1)
        row = [_midpoint(slope, t, y, step, count)]
        for back, before in enumerate(reversed(range(stage)), 1):
            ratio = mpmath.mpf(count) ** 2 / (2 * (before + 1)) ** 2
            row.append([new + (new - old) / (ratio - 1) for new, old in zip(row[-1], rows[-1][back - 1], strict=True)])
        rows.append(row)
        if stage > 2:
            gap = max(abs(a - b) for a, b in zip(row[-1], row[-2], strict=True))
            if gap <= tolerance * max(map(abs, row[-1])):
                return row[-1], stage
    return None, STAGES


def _midpoint(slope, t, y, step, count):
    h = step / count
    before, here = y, [a + h * b for a, b in zip(y, slope(t, y), strict=True)]
    for k in range(1, count):
        before, here = here, [a + 2 * h * b for a, b in zip(before, slope(t + k * h, here), strict=True)]
    last = slope(t + step, here)
    return [(a + b + h * c) / 2 for a, b, c in zip(before, here, last, strict=True)]
