"""Many motions of a family at once are those that are found one by one, and need no more work each than arrays."""

import mpmath
import numpy as np
import pytest
from support.motions import DUFFING, PENDULUM, problem

from vibcli.analyses.nonlinear import motions_by_amplitude as module
from vibcli.api.values import given_expression

STOP = DUFFING.replace("b: 500 N/m^3", "b: 500 N/m, gap: 3 cm").replace("b*d^3", "b*ramp(d - gap)")
HANGING = DUFFING.replace("slide: x", "slide: {along: [0, 1], by: x}, at: [0, 0]").replace(
    "[ground,", "[[0, 1 m],") + "gravity: 9.81 m/s^2\n"
JUMP = DUFFING.replace("b: 500 N/m^3", "F: 3 N").replace("b*d^3", "F*sign(d)")
SCENES = [(DUFFING, "x", 0.3), (DUFFING.replace("500", "-300"), "x", 0.25), (PENDULUM, "phi", 2.9),
          (PENDULUM, "bob.y", 0.7), (PENDULUM, "bob.x", 0.75), (STOP, "x", 0.3), (STOP, "s.force", 20.0),
          (HANGING, "x", 0.4), (JUMP, "x", 0.2)]


def tree(signal):
    return given_expression(signal, "it").tree


@pytest.mark.parametrize(("scene", "signal", "most"), SCENES)
def test_one_by_one(scene, signal, most):
    motions = problem(scene).free_motions
    amplitudes = [most * k / 12 for k in range(1, 13)]
    for point in motions.curve(1, tree(signal), amplitudes).points[::3]:
        alone, = motions.curve(1, tree(signal), [point.amplitude]).points
        assert point.amplitude == alone.amplitude
        assert abs(point.omega / alone.omega - 1) <= point.error + alone.error
        assert point.error <= 5e-13
        assert point.energy == pytest.approx(alone.energy, rel=1e-12)


def test_against_elliptic_integrals():
    amplitudes = [0.3 * k / 40 for k in range(1, 41)]
    for point in problem(DUFFING).free_motions.curve(1, tree("x"), amplitudes).points:
        with mpmath.workdps(30):
            cubic = 500 * mpmath.mpf(point.amplitude) ** 2
            exact = mpmath.pi * mpmath.sqrt((80 + cubic) / 2) / (2 * mpmath.ellipk(cubic / (2 * (80 + cubic))))
            assert abs(point.omega / exact - 1) <= point.error <= 1e-13


@pytest.mark.parametrize(("scene", "signal", "most"), SCENES)
def test_only_the_largest_is_looked_for_alone(scene, signal, most, monkeypatch):
    asked = []
    family = module.FamilyOfMotions.motion
    monkeypatch.setattr(module.FamilyOfMotions, "motion",
                        lambda self, signal, amplitude: asked.append(amplitude) or family(self, signal, amplitude))
    problem(scene).free_motions.curve(1, tree(signal), list(np.linspace(0.02, 1, 50) * most))
    assert asked == [most]


@pytest.mark.sweep
@pytest.mark.parametrize("amplitude", ["3", "3.1415", "3.1415926", "3.1415926535"])
def test_next_to_the_top(amplitude):
    """ω = π √(g/L)/(2 K(m)), m = sin² ½A; the bound counts how well a float knows the amplitude."""
    point, = problem(PENDULUM).free_motions.curve(1, tree("phi"), [float(amplitude)]).points
    with mpmath.workdps(40):
        rate = mpmath.sqrt(mpmath.mpf(9.81) / mpmath.mpf(0.8))
        exact = [rate * mpmath.pi / 2 / mpmath.ellipk(mpmath.sin(mpmath.mpf(a) / 2) ** 2)
                 for a in (amplitude, float(amplitude))]
        assert abs(point.omega / exact[0] - 1) <= point.error
        assert abs(point.omega / exact[1] - 1) <= 1e-14
