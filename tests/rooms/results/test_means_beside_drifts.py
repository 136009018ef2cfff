"""Means of what does not see that loads drive a scene off which nothing holds: of two wagons on a spring under
F + F cos(Ωt), by their balance. What drifts takes a force of its own: the inertia of both under F, the damper to the
ground where there is one; the spring carries the rest."""

import numpy as np
import pytest
from support.motions import problem

from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import number_of
from vibcli.symbolic.parser import parse

M1, M2, K, F, W = 1.0, 3.0, 2000.0, 3.0, 70.0
WAGONS = """
parameters: {k: 2 kN/m, m1: 1 kg, m2: 3 kg, F: 3 N, W: 70 rad/s}
bodies: {c1: {mass: m1, slide: x1}, c2: {mass: m2, slide: x2}}
springs: {s: {between: [c1, c2], k: k}}
forces: {f: {at: c1, force: LOAD}}
"""
SEEN = "x1", "x1^2", "s.force*x1", "x1 + x2'*(1 s)"


def scene(load, between=0.0, ground=0.0):
    dampers = "dampers: {d: {between: [c1, c2], c: %r N*s/m}, e: {between: [c2, ground], c: %r N*s/m}}\n"
    text = WAGONS.replace("LOAD", load) + (dampers % (between, ground) if between or ground else "")
    return problem(text if "W*" in load else text.replace(", W: 70 rad/s", ""))


def mean(of, text):
    return number_of(of, parse(f"mean({text})"))


def swing(omega, between, ground):
    """x2 − x1 and its rate under e^{iΩt} on the first."""
    s = 1j * omega
    tie, whole = K + s * between, (M2 * s + ground) * s
    apart = -whole / (M1 * s * s * (tie + whole) + tie * whole)
    return apart, s * apart


COSINE = "F*step(t) + F*cos(W*t)", [(W, F)]
SQUARE = "F*step(t) + F*square(W*t)", [(n * W, 4 * F / (np.pi * n)) for n in range(1, 6000, 2)]


@pytest.mark.parametrize("load, tones, between, ground", [
    (*COSINE, 0.0, 0.0), (*COSINE, 2.0, 900.0), (*SQUARE, 5.0, 0.0), (*SQUARE, 0.0, 5.0)],
    ids=["free", "damped", "free, square", "damped, square"])
def test_what_is_between_two_that_are_driven_off(load, tones, between, ground):
    found = scene(load, between, ground)
    apart = -F / K if ground else -F / K * M2 / (M1 + M2)
    square, of_rate = (abs(np.array([A * np.array(swing(omega, between, ground)) for omega, A in tones]))**2 / 2).sum(0)
    expected = {"x2 - x1": apart, "s.force": K * apart, "(x2 - x1)^2": apart**2 + square, "(x1' - x2')^2": of_rate,
                "s.force*(x2 - x1)": K * (apart**2 + square), "sin((x2 - x1)/(1 m))^2 + cos((x2 - x1)/(1 m))^2": 1.0,
                "x1'" if ground else "x1''": F / ground if ground else F / (M1 + M2)}
    for text, value in expected.items():
        assert mean(found, text) == pytest.approx(value, rel=1e-10 if "'" in text else 1e-11), text
    assert mean(found, "x1' - x2'") == pytest.approx(0.0, abs=1e-13)
    assert number_of(found, parse("rms(x2 - x1)")) == pytest.approx((apart**2 + square)**0.5, rel=1e-10)
    for text in SEEN:
        with pytest.raises(PhysicsError, match=r"nothing holds|does not cancel"):
            mean(found, text)


def test_steady_states_that_do_not_see_the_drift_have_values():
    found = scene("F*step(t) + F*cos(W*t)", 5.0)
    apart, (X, _) = -F / K * M2 / (M1 + M2), swing(W, 5.0, 0.0)
    at = apart + (F * X * np.exp(1j * W * 0.01)).real
    assert number_of(found, parse("steady(x2 - x1)(0.01 s)")) == pytest.approx(at, rel=1e-11)
    assert number_of(found, parse("max(steady(s.force))")) == pytest.approx(K * (apart + F * abs(X)), rel=1e-11)
    assert number_of(found, parse("transient(x2 - x1)(0.01 s)")) == pytest.approx(
        number_of(found, parse("(x2 - x1)(0.01 s)")) - at, rel=1e-9)
    with pytest.raises(PhysicsError, match="nothing holds"):
        number_of(found, parse("steady(x1)(0.01 s)"))


@pytest.mark.parametrize("ground, mean_of", [(0.0, "x2' - x1'"), (5.0, "x2' - x1'")])
def test_what_a_ramp_drives_off_comes_apart_steadily(ground, mean_of):
    found = scene("F*t/(1 s) + F*cos(W*t)", ground=ground)
    assert mean(found, mean_of) == pytest.approx(-F / K if ground else -F / K * M2 / (M1 + M2), rel=1e-11)
    with pytest.raises(PhysicsError, match="this steady state grows without end"):
        mean(found, "x2 - x1")
    with pytest.raises(PhysicsError, match="does not cancel"):
        mean(found, "(x2 - x1)^2")


def test_squares_of_what_vibrates_freely_beside_a_drift():
    found = scene("F*step(t)")
    apart = -F / K * M2 / (M1 + M2)
    assert mean(found, "(x2 - x1)^2") == pytest.approx(1.5 * apart**2, rel=1e-12)
    assert mean(found, "abs(x2 - x1)") == pytest.approx(-apart, rel=1e-12)
    with pytest.raises(PhysicsError, match="does not cancel"):
        mean(found, "x1*x2")
