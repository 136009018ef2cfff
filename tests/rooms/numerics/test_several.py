"""Common zeros of two functions: pairs that were planted are found, those beside which another lies too."""

import cmath
import math
import random

import pytest

from vibcli.numerics.newton_systems import common_zeros


def released(k, c, t, m, speed):
    """The motion of a damped block let go at 2 cm, by the roots of m s² + c s + k = 0."""
    root = cmath.sqrt(c * c - 4 * k * m) or 1e-12
    one, other = (-c + root) / (2 * m), (-c - root) / (2 * m)
    a = (speed - other * 0.02) / (one - other)
    return (a * cmath.exp(one * t) + (0.02 - a) * cmath.exp(other * t)).real


def planted(seed):
    """(function of log k and log c, its zero that is known)."""
    draw = random.Random(f"planted {seed}")
    m, w, zeta, speed = 10 ** draw.uniform(-1, 1.7), 10 ** draw.uniform(0.3, 1.9), draw.uniform(0.02, 0.9), draw.choice(
        [0, 0.1, -0.2])
    k, c = m * w * w, 2 * zeta * m * w
    times = [2 * math.pi / w * part for part in (draw.uniform(0.05, 0.45), draw.uniform(0.5, 1.6))]
    known = [released(k, c, t, m, speed) for t in times]
    scales = [10 ** draw.uniform(-1, 1) * x for x in (k, c)]

    def function(u):
        found = [released(scales[0] * math.exp(u[0]), scales[1] * math.exp(u[1]), t, m, speed) for t in times]
        misfits = [(x - y) / (abs(x) + abs(y)) for x, y in zip(found, known, strict=True)]
        return [2 * math.atanh(max(-1 + 1e-15, min(1 - 1e-15, h))) for h in misfits]
    return function, [math.log(k / scales[0]), math.log(c / scales[1])]


@pytest.mark.sweep
@pytest.mark.parametrize("first", [42, 94])
def test_a_planted_pair_is_found(first):
    """A spring and a damper by two places of a motion, of which several pairs give the same."""
    missed = []
    for seed in range(first, first + 10):
        function, known = planted(seed)
        found = common_zeros(function, lambda p: [(2 * x - 1) * math.log(1e3) for x in p], 2)
        if min((math.dist(u, known) for u in found), default=1) > 1e-6:
            missed.append(seed)
    assert not missed
