"""The exact period of a pendulum, 4 K(sin²(a/2)) √(L/g), in coordinates that make its inertia and its force uneven."""

import mpmath
import pytest
from motions import problem

from vibcli.analyses.trajectory.period import exact_period

PENDULUM = """
coordinates: [u]
parameters: {L: 0.8 m, g: 9.81 m/s^2, m: 2 kg}
gravity: g
bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: %s}}}
"""
ANGLES = {
    "u": (lambda u: u, lambda a: a),
    "sinh(6*u)/6": (lambda u: mpmath.sinh(6 * u) / 6, lambda a: mpmath.asinh(6 * a) / 6),
    "sinh(12*u)/12": (lambda u: mpmath.sinh(12 * u) / 12, lambda a: mpmath.asinh(12 * a) / 12),
    "2*atan(3*u)": (lambda u: 2 * mpmath.atan(3 * u), lambda a: mpmath.tan(a / 2) / 3),
    "3.2*tanh(2*u)": (lambda u: mpmath.mpf("3.2") * mpmath.tanh(2 * u), lambda a: mpmath.atanh(a / 3.2) / 2),
}
FROM_REST = [1e-6, 0.3, 1.0, 2.0, 2.5, 3.0, 3.1]


@pytest.mark.parametrize("angle", ANGLES)
def test_the_period_is_the_complete_elliptic_integral_in_any_coordinate(angle):
    scene, (forward, back) = problem(PENDULUM % angle), ANGLES[angle]
    omega = mpmath.sqrt(mpmath.mpf("9.81") / mpmath.mpf("0.8"))
    for amplitude in FROM_REST:
        u = float(back(mpmath.mpf(amplitude)))
        exact = float(4 * mpmath.ellipk(mpmath.sin(forward(mpmath.mpf(u)) / 2) ** 2) / omega)
        assert exact_period(scene.scene, scene.floats, u, 0.0) == pytest.approx(exact, rel=1e-13), amplitude


@pytest.mark.parametrize("amplitude", [3.13, 3.14])
def test_a_pendulum_let_go_just_below_the_top_comes_back(amplitude):
    scene = problem(PENDULUM % "u")
    omega = mpmath.sqrt(mpmath.mpf("9.81") / mpmath.mpf("0.8"))
    exact = float(4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2) / omega)
    assert exact_period(scene.scene, scene.floats, amplitude, 0.0) == pytest.approx(exact, rel=1e-10)
