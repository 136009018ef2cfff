"""Springs by their undeformed state: deflections, preloads of laws, slopes that are infinite as drawn."""

import random
from fractions import Fraction
from math import sqrt

import mpmath
import pytest
from scipy.optimize import brentq
from support.scenes import problem, value

from vibcli.api.reports import report, solution
from vibcli.base.errors import PhysicsError

SLIDE = "bodies: {p: {mass: 2 kg, slide: x}}\n"


@pytest.mark.parametrize(("keys", "d"), [
    ("k: 100 N/m, preload: 20 N", 0.2 - 0.1), ("k: 100 N/m, free_length: 0.4 m", 0.6 - 0.1),
    ("k: 100 N/m, free_length: 0 m", 0.9), ("k: 100 N/m", -0.1), ("law: (100 N/m)*d + (5 N/m^3)*d^3", -0.1),
    ("k: 100 N/m, acts: tension, preload: 5 N", 0.05 - 0.1), ("law: (100 N/m)*d, preload: 20 N", 0.2 - 0.1)])
def test_the_deflection_counts_from_the_undeformed_state(keys, d):
    """The block is held 0.1 m nearer to the end of the spring by a stiff one that is drawn too long."""
    scene = problem("bodies: {p: {mass: 2 kg, at: [0 m, 0 m], slide: {along: [1, 0], by: x}}}\n"
                    f"springs: {{s: {{{keys}, between: [p, [1 m, 0 m]]}}, w: {{k: 1e14 N/m, stretch: x - 0.1 m}}}}\n")
    assert value(scene, "equilibrium[s.stretch]") == pytest.approx(-0.1, abs=1e-9)
    assert value(scene, "equilibrium[s.deflection]") == pytest.approx(d, abs=1e-9)


def test_a_deflection_written_out_is_that():
    scene = problem("bodies: {p: {mass: 2 kg, slide: x}}\nsprings: {s: {k: 100 N/m, stretch: x - 0.3 m}}\n"
                    "forces: {F: {coordinate: x, value: 10 N}}\n")
    assert value(scene, "equilibrium[s.deflection]") == pytest.approx(0.1)
    assert value(scene, "equilibrium[s.stretch]") == pytest.approx(0.4)


LAWS = (("(100 N/m)*d + (4000 N/m^3)*d^3", lambda d: 100 * d + 4000 * d**3),
        ("(100 N/m)*d - (100 N/m^3)*d^3", lambda d: 100 * d - 100 * d**3),
        ("(100 N/m)*d + (300 N/m^2)*d*abs(d)", lambda d: 100 * d + 300 * d * abs(d)),
        ("(100 N/m)*d - (40 N/m^2)*d*abs(d)", lambda d: 100 * d - 40 * d * abs(d)),
        ("(70 N/m^(1/3))*sign(d)*abs(d)^(1/3)", lambda d: 70 * mpmath.sign(d) * abs(d)**(1 / mpmath.mpf(3))),
        ("(900 N/m^5)*d^5", lambda d: 900 * d**5))


@pytest.mark.parametrize("text, force", LAWS)
@pytest.mark.parametrize("N", [30.0, -17.0, 0.5])
def test_a_law_has_its_preload_as_drawn(text, force, N):
    """F(d₀) = N by mpmath, the stiffness there by its difference quotient; the other spring balances it."""
    scene = problem(SLIDE + f"springs: {{s: {{law: '{text}', preload: {N} N, between: [ground, p]}},\n"
                    f"  w: {{k: 500 N/m, preload: {-N} N, between: [ground, p]}}}}\n")
    d = value(scene, "equilibrium[s.deflection]")
    with mpmath.workdps(30):
        assert float(force(mpmath.mpf(d))) == pytest.approx(N, rel=1e-13)
        slope = float(mpmath.diff(force, d))
    assert abs(d) < 0.6 and d * N > 0          # on the branch through d = 0
    assert value(scene, "equilibrium[x]") == 0
    assert value(scene, "equilibrium[s.force]") == pytest.approx(N, rel=1e-13)
    assert value(scene, "K[x,x]") == pytest.approx(500 + slope, rel=1e-9)


def test_static_preloads_of_laws_make_the_drawn_position_the_equilibrium():
    rng = random.Random(4)
    k, g, m = rng.uniform(50, 200), rng.uniform(1e3, 9e3), rng.uniform(1, 3)
    scene = problem(f"gravity: 9.81 m/s^2\nbodies: {{p: {{mass: {m} kg, at: [0 m, 0 m], move: [x, y]}}}}\n"
                    "springs:\n" + "".join(
        f"  {name}: {{law: '({k} N/m)*d + ({g} N/m^3)*d^3', preload: static, between: [[{x} m, 1 m], p]}}\n"
        for name, x in (("s", -1), ("r", 1))))
    N = m * 9.81 / sqrt(2)
    d = brentq(lambda d: k * d + g * d**3 - N, 0, 1, xtol=1e-15)
    assert [value(scene, f"equilibrium[{name}]") for name in ("x", "y")] == [0, 0]
    assert value(scene, "equilibrium[r.force]") == pytest.approx(N, rel=1e-12)
    assert value(scene, "equilibrium[r.deflection]") == pytest.approx(d, rel=1e-12)
    assert value(scene, "K[x,x]") == pytest.approx(k + 3 * g * d**2 + N / sqrt(2), rel=1e-12)


def test_static_preloads_of_laws_that_statics_leaves_open_are_refused():
    with pytest.raises(PhysicsError, match="do not fix the preloads"):
        value(problem("gravity: 9.81 m/s^2\nbodies: {p: {mass: 1 kg, at: [0 m, 0 m], slide: {along: [0, 1], by: y}}}\n"
                      "springs:\n" + "".join(
                          f"  {name}: {{law: '(9 N/m)*d + (5 N/m^3)*d^3', preload: static, "
                          f"between: [[0 m, {y} m], p]}}\n"
                          for name, y in (("s", 1), ("r", -1)))), "omega[1]")


@pytest.mark.parametrize(("power", "F"), [("1/2", 30.0), ("1/3", -20.0), ("2/3", 5.0)])
def test_an_equilibrium_beside_an_infinite_slope_is_found(power, F):
    n = float(Fraction(power))
    scene = problem(SLIDE + f"springs: {{s: {{law: '(100 N/m^({power}))*sign(d)*abs(d)^({power})', between: [ground, "
                    f"p]}}}}\nforces: {{F: {{coordinate: x, value: {F} N}}}}\n")
    x = (1 if F > 0 else -1) * (abs(F) / 100) ** (1 / n)
    assert value(scene, "equilibrium[x]") == pytest.approx(x, rel=1e-12)
    assert value(scene, "omega[1]") == pytest.approx(sqrt(100 * n * abs(x) ** (n - 1) / 2), rel=1e-11)


def test_an_equilibrium_at_an_infinite_slope_is_refused():
    with pytest.raises(PhysicsError, match="slope of a force is infinite as drawn"):
        value(problem(SLIDE + "springs: {s: {law: '(9 N/m^(1/2))*sign(d)*abs(d)^(1/2)', between: [ground, p]}}\n"),
              "omega[1]")


def test_a_particle_moves_by_two_displacements():
    text = "bodies: {{p: {{mass: 2 kg, at: [0 m, 0 m], move: {}}}}}\n" \
           "springs: {{s: {{k: 8 N/m, between: [[1 m, 0 m], p]}}, t: {{k: 2 N/m, between: [[1 m, 1 m], p]}}}}\n"
    two, three = (problem(text.format(move)) for move in ("[x, y]", "[x, y, 0]"))
    assert list(two.scene.coordinates) == ["x", "y"]
    assert [value(two, f"omega[{i}]") for i in (1, 2)] == [value(three, f"omega[{i}]") for i in (1, 2)]


JUMP = SLIDE + ("springs: {s: {law: 100 N*sign(d) + (5 N/m)*d, between: [ground, p]}}\n"
                "forces: {F: {coordinate: x, value: LOAD N}}\n")


@pytest.mark.parametrize("F", [30, -99, 0.1])
def test_a_force_that_jumps_holds_what_is_within_it(F):
    with pytest.raises(PhysicsError, match="where a force jumps"):
        value(problem(JUMP.replace("LOAD", str(F))), "equilibrium[x]")


def test_beyond_the_jump_it_rests_where_the_spring_balances():
    assert value(problem(JUMP.replace("LOAD", "130")), "equilibrium[x]") == pytest.approx(6)
    assert value(problem(JUMP.replace("LOAD", "-130")), "equilibrium[x]") == pytest.approx(-6)


def test_a_report_says_where_it_rests():
    scene = problem(JUMP.replace("LOAD", "30") + "find: [equilibrium]\n")
    assert "the scene rests near x = 0" in str(report(scene, solution(scene)).sections)
