"""Undamped free vibration: natural frequencies and mode shapes of M q̈ + K q = 0.

Up to CERTIFIED coordinates the eigenvalues are enclosed rigorously in fixed-point arithmetic (certified.py);
larger systems are solved in floats from the factors √k ∇s and √w ∇s with a bound of their rounding (floating.py).
"""

import math

from vibcli.analyses.rigid import rigid_count
from vibcli.analyses.scaled import mechanism, scaling

CERTIFIED = 40
UNIT = 2.0 ** -53
ESCALATE = 1e-13
DIGITS = 60


class Mode:
    """One mode: q = shape · cos ωt, M-normalised; rigid: omega exactly 0; unstable: omega None, growth_rate > 0.

    error: bound of the relative error of omega or growth_rate. direction: shape but for one factor, its bits
    independent of the units of mass, length and time.
    """

    __slots__ = ("direction", "error", "growth_rate", "index", "omega", "rigid", "shape")

    def __init__(self, index, omega, growth_rate, shape, direction, error, rigid):
        self.index, self.omega, self.growth_rate = index, omega, growth_rate
        self.shape, self.direction, self.error, self.rigid = shape, direction, error, rigid


def undamped(elements, precise=None, digits=None):
    """The modes by ascending ω² (unstable, then rigid, then the others), each with its relative error bound.

    `precise(dps)` evaluates the same elements to dps digits and is called where floats do not decide; without it the
    floats are taken for exact. `digits`: this many correct digits, numbers of mpmath.
    """
    scale = scaling(elements)
    check_ties(elements)
    zeros = None if not factored(elements) else rigid_count(elements.n, *spring_rows(elements))
    if digits is not None:
        from vibcli.analyses.digits import undamped_digits

        return undamped_digits(elements, scale, zeros, precise, digits)
    if elements.n > CERTIFIED:
        from vibcli.analyses.floating import undamped_floats

        return modes(elements, scale, *undamped_floats(elements, scale, zeros))
    from vibcli.analyses.certified import enclosed

    answer = enclosed(elements, scale, zeros, unit=0.0 if precise is None else 4 * UNIT)
    if precise is not None and not answer.settled(ESCALATE):
        answer = enclosed(precise(DIGITS), scale, zeros, unit=10.0 ** -(DIGITS - 2))
    return modes(elements, scale, *answer.in_floats())


def factored(elements):
    """Whether all stiffness is Σ k ∇s ∇sᵀ with k >= 0."""
    return not any(elements.K.values()) and all(k >= 0 for k, _ in elements.springs)


def spring_rows(elements):
    """The rows of springs that have stiffness: as floats, and as Fractions or None."""
    kept = [i for i, (k, _) in enumerate(elements.springs) if k]
    exact = elements.rational_rows
    return [elements.springs[i][1] for i in kept], None if exact is None else [exact[i] for i in kept]


def check_ties(elements):
    """Refuses a coordinate with neither inertia nor stiffness."""
    tied = {i for k, row in elements.springs if k for i, x in row.items() if x}
    tied.update(i for (i, j), x in elements.K.items() if x)
    for i in elements.massless:
        if i not in tied:
            raise mechanism(i)


def modes(elements, scale, values, shapes, errors, zero):
    """Mode objects from scaled values λ̂ = ω̂², shapes q̂ in columns, errors of √|λ̂| and the flags of exact zeros."""
    import numpy as np

    direction = np.ldexp(shapes, np.array(scale.coordinates)[:, None])
    odd, half = scale.mass % 2, scale.mass // 2
    full = np.ldexp(direction / math.sqrt(2.0) if odd else direction, -half)
    order = sorted(range(len(values)), key=lambda i: 0.0 if zero[i] else values[i])
    out = []
    for place, i in enumerate(order, 1):
        value = 0.0 if zero[i] else float(values[i])
        rate = math.ldexp(math.sqrt(abs(value)), scale.time)
        unstable = value < 0
        out.append(Mode(place, None if unstable else rate, rate if unstable else None, full[:, i], direction[:, i],
                        0.0 if zero[i] else float(errors[i]), bool(zero[i])))
    return out
