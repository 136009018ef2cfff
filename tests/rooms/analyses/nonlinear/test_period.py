"""Exact periods: of a pendulum, 4 K(sin²(a/2)) √(L/g), in coordinates that make its inertia and its force uneven, of
wells with tops, and of laws with kinks, jumps and broken powers."""

import math
from fractions import Fraction

import mpmath
import pytest
from support.motions import problem

from vibcli import loads
from vibcli.analyses.nonlinear.period import exact_period
from vibcli.analyses.nonlinear.period_in_floats import period_between
from vibcli.analyses.nonlinear.turning_points import turning_point
from vibcli.analyses.nonlinear.well import Well
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


@pytest.mark.parametrize("amplitude", [1e-6, 0.1, 1.0, 2.5, 3.0, 3.1, 3.14, 3.1415926])
def test_in_floats_the_error_is_known(amplitude):
    scene = problem(PENDULUM % "u")
    well = Well(scene.scene, scene.numeric.floats)
    found, error = period_between(well, *(turning_point(well, amplitude, 0.0, side) for side in (-1, 1)))
    with mpmath.workdps(40):
        exact = 4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2) / mpmath.sqrt(mpmath.mpf("12.2625"))
        assert abs(found - exact) <= error <= max(1e-14, 3e-15 / (math.pi - amplitude) ** 2) * exact


@pytest.mark.parametrize("amplitude", [3.13, 3.14])
def test_a_pendulum_let_go_just_below_the_top_comes_back(amplitude):
    scene = problem(PENDULUM % "u")
    omega = mpmath.sqrt(mpmath.mpf("9.81") / mpmath.mpf("0.8"))
    exact = float(4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2) / omega)
    assert exact_period(scene.scene, scene.numeric.floats, amplitude, 0.0)[0] == pytest.approx(exact, rel=1e-10)


BLOCK = """
bodies: {block: {mass: 1.3 kg, slide: x}}
springs:
"""
TWO = """  a: {k: 70 N/m, acts: tension, between: [ground, block]}
  b: {k: 20 N/m, acts: compression, between: [ground, block]}
"""
PLAY = "  a: {k: 70 N/m, gap: 1 mm, between: [ground, block]}\n"
MOST = 1e-14


def _period(scene, start, v=0.0):
    found, error = exact_period(scene.scene, scene.numeric.floats, start, v)
    assert error <= MOST
    return found


@pytest.mark.parametrize("start", [1e-3, 1.0, -2.5])
def test_two_springs_of_which_each_acts_on_one_side(start):
    exact = math.pi * (math.sqrt(1.3 / 20) + math.sqrt(1.3 / 70))
    assert _period(problem(BLOCK + TWO), start) == pytest.approx(exact, rel=1e-15)


@pytest.mark.parametrize("start", [0.001000001, 0.0010001, 0.002, 1.0])
def test_play(start):
    """A half wave at each end, and the way through the play at the speed of its end."""
    with mpmath.workdps(30):
        omega = mpmath.sqrt(mpmath.mpf(70) / mpmath.mpf("1.3"))
        exact = 2 * mpmath.pi / omega + 4 * mpmath.mpf("0.001") / ((mpmath.mpf(start) - mpmath.mpf("0.001")) * omega)
        found = _period(problem(BLOCK + PLAY), start)
        # the gap of 0.001 m is a float here: its rounding over what is left of the way
        assert abs(found / exact - 1) <= 1e-15 + 1e-18 / (start - 0.001)


def test_a_force_that_jumps():
    scene = problem(BLOCK.replace(" kg", "") + "  a: {law: 7*sign(d), between: [ground, block]}\n")
    assert _period(scene, 0.3) == pytest.approx(4 * math.sqrt(2 * 1.3 * 0.3 / 7), rel=1e-15)
    assert _period(scene, 0.0, 0.4) == pytest.approx(4 * 1.3 * 0.4 / 7, rel=1e-15)


@pytest.mark.parametrize("power", ["1/3", "1/2", "3/2", "2", "5"])
@pytest.mark.parametrize("start", [1e-4, 20.0])
def test_pure_powers(power, start):
    """T = 4 √(π m (n + 1)/(2 a)) A^{(1 − n)/2} Γ(1/(n + 1))/((n + 1) Γ(1/(n + 1) + ½))."""
    scene = problem(f"""
parameters: {{m: 1.3, a: 7}}
bodies: {{block: {{mass: m, slide: x}}}}
springs: {{s: {{law: a*sign(d)*abs(d)^({power}), between: [ground, block]}}}}
""")
    with mpmath.workdps(30):
        n = mpmath.mpf(Fraction(power).numerator) / Fraction(power).denominator
        p = 1 / (n + 1)
        exact = 4 * mpmath.sqrt(mpmath.pi * mpmath.mpf("1.3") / (2 * 7 * p)) * mpmath.mpf(start) ** (
            (1 - n) / 2) * p * mpmath.gamma(p) / mpmath.gamma(p + 0.5)
        assert abs(_period(scene, start) / exact - 1) <= 1e-15


def test_a_body_that_falls_on_a_spring():
    """Free flight above y = 0, and the part of a harmonic motion about −mg/k below."""
    scene = problem("""
coordinates: [y]
parameters: {m: 1.3 kg, k: 900 N/m, g: 9.81 m/s^2}
gravity: g
bodies: {block: {mass: m, at: [0, 0], move: [0, y, 0]}}
springs: {stop: {k: k, acts: compression, stretch: y}}
""")
    with mpmath.workdps(30):
        m, k, g, h = map(mpmath.mpf, ("1.3", "900", "9.81", "0.4"))
        omega, v = mpmath.sqrt(k / m), mpmath.sqrt(2 * g * h)
        exact = 2 * v / g + 2 / omega * (mpmath.pi - mpmath.atan(v * omega / g))
        assert abs(_period(scene, 0.4) / exact - 1) <= 1e-15


def test_a_steady_force_has_a_potential():
    scene = problem("""
parameters: {m: 1.3 kg, k: 70 N/m, b: 3 N/m^3, F: 30 N}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: k*d + b*d^3, between: [ground, block]}}
forces: {pull: {at: block, force: F}}
""")
    with mpmath.workdps(30):
        def V(x):
            return 35 * x**2 + mpmath.mpf("0.75") * x**4 - 30 * x

        other = mpmath.findroot(lambda x: (V(x) - V(2)) / (x - 2), -1)
        p = mpmath.mpf("0.75") * (2 + other)            # E − V = (2 − x)(x − other)(¾ x² + p x + r)
        r = 35 + p * (2 + other) - mpmath.mpf("1.5") * other
        places = ((2 + other) / 2, (2 - other) / 2)

        def left(x):
            return mpmath.mpf("0.75") * x**2 + p * x + r

        exact = 2 * mpmath.quad(lambda u: mpmath.sqrt(mpmath.mpf("0.65") / left(places[0] + places[1] * mpmath.sin(u))),
                                [-mpmath.pi / 2, 0, mpmath.pi / 2])
        assert abs(_period(scene, 2.0) / exact - 1) <= 1e-14


@pytest.mark.parametrize("limit", ["1e20 m", "1e55 m"])
def test_a_limit_that_is_never_reached_takes_no_digits(limit):
    found = loads("""
        parameters: {k: 520 N/m, y: LIMIT}
        bodies: {block: {mass: 1.4 kg, slide: x}}
        springs: {s: {law: "k*max(-y, min(d, y))", between: [ground, block]}}
        motion: full
        initial: {x: 3 cm}
        """.replace("LIMIT", limit))
    omega = math.sqrt(520 / 1.4)
    for quantity, exact in (("period(x)", 2 * math.pi / omega), ("backbone[1](x)(15 mm)", omega)):
        assert found[quantity].value == pytest.approx(exact, rel=1e-12) and 0 < found[quantity].error < 1e-11
