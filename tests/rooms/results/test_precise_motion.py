"""Values of motions to any number of digits, against closed forms in mpmath and against the floats."""

import mpmath
import pytest
from support.scenes import problem, problem_of, value

from vibcli.symbolic.syntax import NameRef

DIGITS = 50


def precise(found, name, t):
    return found.response.signal(NameRef(0, 0, name, 0)).precise(t, DIGITS)


def under_damped(t):
    """x0 e^{−δt} (cos ω_d t + δ/ω_d sin ω_d t) of vibcli/examples/free_vibration.yaml."""
    delta, omega_d = mpmath.mpf(2), mpmath.sqrt(mpmath.mpf(396))
    return mpmath.mpf("0.02") * mpmath.exp(-delta * t) * (mpmath.cos(omega_d * t)
                                                          + delta / omega_d * mpmath.sin(omega_d * t))


@pytest.mark.parametrize("t", ["0.04", "2.5", "300", "1000"])
def test_free_vibration_even_where_it_has_died_out(t):
    from fractions import Fraction
    from pathlib import Path

    import vibcli

    found = problem_of(Path(vibcli.__file__).parent / "examples" / "free_vibration.yaml")
    with mpmath.workdps(DIGITS + 10):
        exact = under_damped(mpmath.mpf(t))
        got = precise(found, "x", Fraction(t))
        assert abs(got - exact) <= abs(exact) * mpmath.mpf(10) ** (-DIGITS)
    if abs(exact) > 1e-200:
        assert value(found, f"x({t} s)") == pytest.approx(float(exact), rel=1e-12)


def test_resonance_of_two_degrees():
    """Driven at ω₁ of two equal masses: x₁ + x₂ = F/(2ω) t sin ωt, x₁ − x₂ regular."""
    from fractions import Fraction

    found = problem("""
        parameters: {m: 1 kg, k: 4 N/m, kc: 3 N/m, F: 2 N, w: 2 rad/s}
        bodies: {a: {mass: m, slide: x1}, b: {mass: m, slide: x2}}
        springs:
          s1: {k: k, between: [ground, a]}
          s2: {k: k, between: [ground, b]}
          c: {k: kc, between: [a, b]}
        forces: {f: {at: a, force: F*cos(w*t)}}
    """)
    t = Fraction(1234, 10)
    with mpmath.workdps(DIGITS + 10):
        w, time = mpmath.mpf(2), mpmath.mpf(t.numerator) / t.denominator
        total = 2 / (2 * w) * time * mpmath.sin(w * time)
        other = mpmath.sqrt(10)
        apart = 2 / (other**2 - w**2) * (mpmath.cos(w * time) - mpmath.cos(other * time))
        exact = (total + apart) / 2
        got = precise(found, "x1", t)
        assert abs(got - exact) <= abs(exact) * mpmath.mpf(10) ** (-DIGITS)
    assert value(found, "x1(123.4 s)") == pytest.approx(float(exact), rel=1e-12)
