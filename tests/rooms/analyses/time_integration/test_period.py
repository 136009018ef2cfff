"""The exact period of a pendulum, 4 K(sin²(a/2)) √(L/g), in coordinates that make its inertia and its force uneven."""

import mpmath
import numpy as np
import pytest
from support.motions import problem

from vibcli.analyses.time_integration.period import _of_forces, _scale, exact_period
from vibcli.quantities.expression import value_of

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
FROM_REST = [1e-6, 0.1, 0.3, 1.0, 2.0, 2.5, 3.0, 3.1, 3.14, 3.1415, 3.1415926]


@pytest.mark.sweep
@pytest.mark.parametrize("angle", ANGLES)
def test_the_period_is_the_complete_elliptic_integral_in_any_coordinate(angle):
    scene, (forward, back) = problem(PENDULUM % angle), ANGLES[angle]
    omega = mpmath.sqrt(mpmath.mpf("9.81") / mpmath.mpf("0.8"))
    for amplitude in FROM_REST:
        u = float(back(mpmath.mpf(amplitude)))
        with mpmath.workdps(40):
            exact = 4 * mpmath.ellipk(mpmath.sin(forward(mpmath.mpf(u)) / 2) ** 2) / omega
            found, error = exact_period(scene.scene, scene.numeric.floats, u, 0.0)
            assert abs(found / exact - 1) <= error <= 1e-14, amplitude


@pytest.mark.parametrize("amplitude", ["0.1", "1", "3", "3.14", "3.1415", "3.1415926"])
def test_the_start_counts_as_it_is_written(amplitude):
    """Not rounded to a float, which near the top would be felt."""
    with mpmath.workdps(40):
        exact = 4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2) / mpmath.sqrt(mpmath.mpf("12.2625"))
        asked = f"motion: full\ninitial: {{u: {amplitude} rad}}\nanswers: {{period(u): {mpmath.nstr(exact, 13)} s}}\n"
        scene = problem(PENDULUM % "u" + asked)
        found, error = value_of(scene, scene.spec.answers[0].asked)
        assert abs(found / exact - 1) <= error <= 1e-12


WELL = """
coordinates: [x]
parameters: {m: 1 kg, k: 1 N/m, b: 1 N/m^2}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: k*d - b*d^2, between: [ground, block]}}
"""


@pytest.mark.parametrize("start", ["0.1", "0.9", "0.9999", "0.9999999", "-0.3", "-0.4999", "-0.499999999"])
def test_a_well_with_a_top_on_one_side(start):
    """V = x²/2 − x³/3: 2 (E − V) = ⅔ (x − a)(b − x)(c − x), T = 2 √6/√(c − a) K((b − a)/(c − a))."""
    scene = problem(WELL)
    with mpmath.workdps(60):
        x = mpmath.mpf(float(start))
        energy = x**2 / 2 - x**3 / 3
        a, b, c = sorted(mpmath.re(root) for root in mpmath.polyroots([2, -3, 0, 6 * energy], maxsteps=500,
                                                                      extraprec=400))
        exact = 2 * mpmath.sqrt(6 / (c - a)) * mpmath.ellipk((b - a) / (c - a))
        found, error = exact_period(scene.scene, scene.numeric.floats, float(start), 0.0)
        assert abs(found / exact - 1) <= error <= 1e-14


@pytest.mark.sweep
@pytest.mark.parametrize("amplitude", [0.1, 1.0, 3.0, 3.1, 3.14, 3.141])
def test_from_forces_alone_the_error_is_known(amplitude):
    with mpmath.workdps(40):
        exact = 4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2)
        found, error = _of_forces(np.sin, np.ones_like, amplitude, 0.0)
        assert abs(found / exact - 1) <= error <= 1e-8


@pytest.mark.parametrize("amplitude", [3.13, 3.14])
def test_a_pendulum_let_go_just_below_the_top_comes_back(amplitude):
    scene = problem(PENDULUM % "u")
    omega = mpmath.sqrt(mpmath.mpf("9.81") / mpmath.mpf("0.8"))
    exact = float(4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2) / omega)
    assert exact_period(scene.scene, scene.numeric.floats, amplitude, 0.0)[0] == pytest.approx(exact, rel=1e-10)


@pytest.mark.parametrize(("force", "amplitude", "most"), [
    (np.sin, 1.0, 16_000), (lambda x: x + 2 * x**3, 1.0, 16_000), (np.expm1, 1.0, 16_000),
    (lambda x: np.arctan(3 * x), 10.0, 2_000_000), (lambda x: 0.2 * x + np.tanh(10 * x) / 2, 3.0, 1_000_000)])
def test_a_period_from_forces_takes_few_places(force, amplitude, most):
    """A rule of few points is halved often where a law bends, one of many is wasted where it does not."""
    asked = []

    def counted(x):
        asked.append(x.size)
        return force(x)

    _of_forces(counted, np.ones_like, amplitude, 0.0)
    assert sum(asked) <= most


@pytest.mark.parametrize("k", [0.3, 4e5])
@pytest.mark.parametrize("a", [1e-4, 2.0])
def test_ends_are_looked_for_in_steps_of_a_twentieth_of_the_way_of_a_linear_spring(k, a):
    """From rest, and from the middle with the energy of that amplitude."""
    assert _scale(lambda q: k * q, a, 0.0) == pytest.approx(a / 20)
    assert _scale(lambda q: k * q, 0.0, k * a * a / 2) == pytest.approx(a / 20)
