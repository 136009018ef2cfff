"""What a cantilever does that starts with a field, by its modes in mpmath: displacements to 1e-10 of the largest.

    ∫ φ p dx = [p φ‴ − p′ φ″ + p″ φ′ − p‴ φ]/b⁴ + ∫ φ p⁗ dx/b⁴,      ω = b²,      ∫ φ² dx = 1

φ = cosh bx − cos bx − r (sinh bx − sin bx), r = (cosh b + cos b)/(sinh b + sin b), by the small share 1 − r of what
grows.
"""

from functools import cache

import mpmath
import numpy as np
import pytest
from mpmath import cos, cosh, exp, mpf, sin, sinh
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.symbolic.parser import parse

SCENE = """
beams: {arm: {length: 1 m, EI: 1 N*m^2, mass_per_length: 1 kg/m, left: clamped}}
initial: {%s}
"""
TIMES, PLACE, COUNT, DIGITS = (0.0, 0.013, 0.37, 2.5, 40.0), mpf("0.6"), 300, 50
LOADED = "0.01*(6 - 4*x/(1 m) + x^2/(1 m^2))*x^2/(1 m)", [0, 0, "0.06", "-0.04", "0.01"]     # as under an even load
HIGHER = "x^5/(1 m^4)*(1 - x/(1 m))^4", [0, 0, 0, 0, 0, 1, -4, 6, -4, 1]


def waves(b, x):
    """φ and its first three derivatives."""
    growing = (sin(b) - cos(b) - exp(-b)) / (sinh(b) + sin(b))       # 1 − r
    c, s, up, down = cos(b * x), sin(b * x), growing * exp(b * x) / 2, (2 - growing) * exp(-b * x) / 2
    ratio = 1 - growing
    return [up + down - c + ratio * s, b * (up - down + s + ratio * c), b**2 * (up + down + c - ratio * s),
            b**3 * (up - down - s - ratio * c)]


@cache
def modes():
    """(b, φ and its derivatives at both ends, φ at the place) of the first modes."""
    found = []
    for n in range(1, COUNT + 1):
        b = mpmath.findroot(lambda y: cos(y) + 1 / cosh(y), (n - mpf("0.5")) * mpmath.pi if n > 1 else mpf("1.875"))
        found.append((b, [waves(b, mpf(0)), waves(b, mpf(1))], waves(b, PLACE)[0]))
    return found


def derived(p):
    return [k * a for k, a in enumerate(p)][1:]


def over(p, b, ends):
    """∫ φ p dx over the beam, p by its coefficients."""
    if not any(p):
        return mpf(0)
    found = mpf(0)
    for x, sign, phi in zip((mpf(0), mpf(1)), (-1, 1), ends, strict=True):
        one = p
        for k in range(4):
            found += sign * (-1)**k * mpmath.polyval(one[::-1] or [0], x) * phi[3 - k]
            one = derived(one)
    for _ in range(4):
        p = derived(p)
    return (found + over(p, b, ends)) / b**4


def series(p, rate):
    """u at the times."""
    found = [mpf(0)] * len(TIMES)
    with mpmath.workdps(DIGITS):
        for b, ends, place in modes():
            size = over([mpf(a) for a in p], b, ends) * place
            for k, t in enumerate(TIMES):
                found[k] += size * (sin(b * b * mpf(t)) / b**2 if rate else cos(b * b * mpf(t)))
    return np.array([float(value) for value in found])


@pytest.mark.sweep
@pytest.mark.parametrize(("field", "p", "rate"), [(*LOADED, False), (*LOADED, True), (*HIGHER, False), (*HIGHER, True)])
def test_displacements(field, p, rate):
    text = f"arm.u': {field}/(1 s)" if rate else f"arm.u: {field}"
    scene = problem(SCENE % text)
    signal = scene.response.signal(with_places(parse("arm.u(0.6 m)"), scene.spec.members))
    found, expected = signal.values(np.array(TIMES)), series(p, rate)
    most = np.abs(expected).max()
    assert np.abs(found - expected).max() <= 1e-10 * most
    assert (np.abs(found - expected) <= [signal.error(t) + 1e-14 * most for t in TIMES]).all()
