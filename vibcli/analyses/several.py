"""Zeros of several functions of several positive or signed unknowns: damped Newton steps from many starting places.

Positive unknowns are solved for in logarithms, so that products of powers are linear. The starts are those of a
Halton sequence (Halton 1960) over a box; the search ends when further starts find nothing new.
"""

STEPS, STARTS, IDLE, STEP, CLOSE = 40, 48, 16, 1e-7, 1e-6
CONVERGED, LONGEST = 1e-13, 2.3
PRIMES = (2, 3, 5, 7)


def halton(count, dimensions):
    """Points spread evenly over the unit cube, the same at every run; the first is its centre."""
    yield [0.5] * dimensions
    for i in range(1, count):
        yield [_reversed(i, prime) for prime in PRIMES[:dimensions]]


def _reversed(i, base):
    value, digit = 0.0, 1.0 / base
    while i:
        i, rest = divmod(i, base)
        value, digit = value + rest * digit, digit / base
    return value


def common_zeros(function, place, dimensions):
    """[u], the distinct zeros found; `function(u)` gives a list of at least so many values, None where it is not
    defined; `place(p)` is the start at a point p of the unit cube."""
    found, idle = [], 0
    for point in halton(STARTS, dimensions):
        u = newton(function, place(point))
        new = u is not None and all(_distance(u, other) > CLOSE for other in found)
        idle = 0 if new else idle + 1
        found += [u] if new else []
        if idle >= IDLE:
            break
    return found


def _distance(a, b):
    return max(abs(x - y) / max(1.0, abs(x), abs(y)) for x, y in zip(a, b, strict=True))


def newton(function, u):
    """A zero reached from u by Newton steps (Gauss–Newton of more values than unknowns), halved until they lower the
    sum of squares; None where they do not get there."""
    import numpy as np

    value = _values(function, u)
    if value is None:
        return None
    u = np.array(u, float)
    for _ in range(STEPS):
        size = float(np.linalg.norm(value))
        slope = _jacobian(function, u, value)
        if slope is None:
            return None
        step = np.linalg.lstsq(slope, -value, rcond=1e-12)[0]
        longest = float(np.abs(step).max())
        step *= min(1.0, LONGEST / longest) if longest else 1.0
        for _ in range(12):
            trial = _values(function, u + step)
            if trial is not None and np.linalg.norm(trial) < size:
                break
            step = 0.5 * step
        else:
            return list(map(float, u)) if size <= 1e-8 else None
        u, value = u + step, trial
        if np.linalg.norm(value) <= CONVERGED:
            break
    return list(map(float, u)) if np.linalg.norm(value) <= 1e-8 else None


def _values(function, u):
    import numpy as np

    value = function(list(map(float, u)))
    if value is None:
        return None
    value = np.array(value, float)
    return value if np.isfinite(value).all() else None


def _jacobian(function, u, value):
    import numpy as np

    columns = []
    for j in range(len(u)):
        step = STEP * max(1.0, abs(u[j]))
        moved = u.copy()
        moved[j] += step
        other = _values(function, moved)
        if other is None:
            return None
        columns.append((other - value) / step)
    return np.array(columns).T
