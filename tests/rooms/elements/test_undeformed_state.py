"""Springs by their undeformed state: deflections, preloads of laws, slopes that are infinite as drawn."""

import random
from fractions import Fraction
from itertools import pairwise
from math import cos, sin, sqrt

import mpmath
import pytest
from scipy.optimize import brentq
from support.scenes import problem, value

from vibcli.api.reports import report, solution
from vibcli.base.errors import Kinked, PhysicsError

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


@pytest.mark.parametrize(("n", "loaded"), [(2, 1), (3, 1), (4, 2)])
def test_a_row_of_bodies_on_springs_of_infinite_slope_rests_where_one_of_them_is_pulled(n, loaded):
    rng = random.Random(n)
    c, p = ([round(rng.uniform(*ends), 2) for _ in range(n + 1)] for ends in ((20, 90), (0.3, 0.8)))
    names = ["ground", *(f"b{j}" for j in range(n)), "ground"]
    scene = problem("bodies:\n" + "".join(f"  b{j}: {{mass: 1 kg, slide: q{j}}}\n" for j in range(n))
                    + "springs:\n" + "".join(
        f"  s{j}: {{law: '({c[j]} N)*sign(d)*abs(d/(1 m))^{p[j]}', between: [{names[j]}, {names[j + 1]}]}}\n"
        for j in range(n + 1)) + f"forces: {{F: {{at: b{loaded}, force: 7.5 N}}}}\n")
    q = [0, *(value(scene, f"equilibrium[q{j}]") for j in range(n)), 0]
    tensions = [a * (1 if y > x else -1) * abs(y - x) ** e for a, e, (x, y) in zip(c, p, pairwise(q), strict=True)]
    assert [left - right for left, right in pairwise(tensions)] == pytest.approx(
        [7.5 * (j == loaded) for j in range(n)], abs=1e-12)


@pytest.mark.parametrize("n", [0.5, 1.5, 3])
def test_exponents_may_be_letters(n):
    scene = problem(f"parameters: {{n: {n}}}\n" + SLIDE + "springs: {s: {law: '(30 N)*sign(d)*abs(d/(1 m))^n', between:"
                    " [ground, p]}}\nforces: {F: {coordinate: x, value: 5 N}}\n")
    x = 6 ** (-1 / n)
    assert value(scene, "equilibrium[x]") == pytest.approx(x, rel=1e-12)
    assert value(scene, "omega[1]") == pytest.approx(sqrt(30 * n * x ** (n - 1) / 2), rel=1e-11)


def test_an_equilibrium_that_is_reached_at_an_infinite_slope_is_refused():
    with pytest.raises(PhysicsError, match="where the slope of a force is infinite"):
        value(problem("bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}\nsprings:\n"
                      "  s: {k: 100 N/m, between: [ground, a]}\n"
                      "  t: {law: '(30 N)*sign(d)*abs(d/(1 m))^0.5', between: [a, b]}\n"
                      "forces: {f: {at: a, force: 5 N}}\n"), "equilibrium[x]")


def test_an_equilibrium_at_an_infinite_slope_is_refused():
    with pytest.raises(PhysicsError, match="slope of a force is infinite as drawn"):
        value(problem(SLIDE + "springs: {s: {law: '(9 N/m^(1/2))*sign(d)*abs(d)^(1/2)', between: [ground, p]}}\n"),
              "omega[1]")


def test_a_displacement_whose_slope_divides_by_zero_as_drawn_is_refused():
    """V = N √|x| + ½ k |x| is known at x = 0, its slope is none."""
    scene = problem(SLIDE + "springs: {s: {k: 50 N/m, preload: 3 N, stretch: sqrt((1 m)*abs(x))}}\n")
    with pytest.raises(Kinked, match="a force, or the slope of a displacement, divides by zero as drawn"):
        scene.system.drawn_residual  # noqa: B018
    with pytest.raises(Kinked, match="there are no small oscillations about that"):
        value(scene, "omega[1]")


MIRRORED = ("bodies: {{p: {{mass: 2 kg, slide: u}}}}\nsprings: {{s: {{{}, stretch: {}}}}}\n"
            "initial: {{u: 1 cm, u': -1 m/s}}\nmotion: full\n")


@pytest.mark.parametrize("stretch", ["abs(u)", "sqrt(u^2)", "(4*u^2)^0.5/2", "sign(2*u)*u", "sqrt((2*u - u)^2)"])
@pytest.mark.parametrize("of", ["k: 50 N/m", "law: (50 N/m)*d"])
def test_a_stretch_that_is_a_magnitude_has_the_small_oscillations_of_its_square(of, stretch):
    """½ k |u|² = ½ k u²: ω = √(50/2) = 5; the tension k |u| pulls on both sides."""
    scene = problem(MIRRORED.format(of, stretch))
    assert value(scene, "omega[1]") == pytest.approx(5, rel=1e-14)
    u = value(scene, "u(0.2 s)")
    assert u == pytest.approx(0.01 * cos(1) - 0.2 * sin(1), rel=1e-11) and u < 0
    assert value(scene, "s.force(0.2 s)") == pytest.approx(-50 * u, rel=1e-11)


def test_damping_along_a_magnitude_is_that_of_its_square():
    scene = problem("bodies: {p: {mass: 2 kg, slide: u}}\nsprings: {s: {k: 50 N/m, stretch: u}}\n"
                    "dampers: {d: {c: 3 N*s/m, stretch: abs(u)}}\n")
    assert [value(scene, name) for name in ("M[u,u]", "C[u,u]", "omega[1]")] == pytest.approx([2, 3, 5], rel=1e-14)


def test_a_body_whose_place_is_a_magnitude_turns_back_at_a_kink():
    scene = problem("bodies: {p: {mass: 2 kg, at: [0 m, 0 m], move: {by: [abs(u), 0, 0]}}}\ncoordinates: {u: }\n"
                    "springs: {s: {k: 50 N/m, stretch: u}}\n")
    with pytest.raises(Kinked, match="has a kink in the equilibrium"):
        value(scene, "omega[1]")


def test_the_root_of_a_fourth_power_is_a_square():
    scene = problem("coordinates: {x: the displacement}\n"
                    "energies: {T: sqrt((1 kg*x'^2/2)^2), V: sqrt(4*(1 N/m)^2*x^4)/4}\n")
    assert value(scene, "omega[1]") == pytest.approx(1, rel=1e-14)


@pytest.mark.parametrize("stretch", ["abs(u)", "sqrt(u^2)"])
def test_a_preload_on_a_magnitude_is_a_kink(stretch):
    """V = N |u| + ½ k u² rests at u = 0, where its force jumps; it falls back in full motion."""
    scene = problem(MIRRORED.format("k: 50 N/m, preload: 3 N", stretch))
    with pytest.raises(Kinked, match="has a kink in the equilibrium"):
        value(scene, "omega[1]")
    assert value(scene, "equilibrium[u]") == 0
    u, v = value(scene, "u(0.2 s)"), value(scene, "u'(0.2 s)")
    assert u < 0 and v**2 + 3 * abs(u) + 25 * u**2 == pytest.approx(1 + 0.03 + 0.0025, rel=1e-9)


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
    scene = problem(JUMP.replace("LOAD", str(F)))
    assert (value(scene, "equilibrium[x]"), value(scene, "equilibrium[s.force]")) == (0, pytest.approx(F, rel=1e-14))
    with pytest.raises(PhysicsError, match="a force jumps in the equilibrium"):
        value(scene, "omega[1]")


def test_beyond_the_jump_it_rests_where_the_spring_balances():
    assert value(problem(JUMP.replace("LOAD", "130")), "equilibrium[x]") == pytest.approx(6)
    assert value(problem(JUMP.replace("LOAD", "-130")), "equilibrium[x]") == pytest.approx(-6)


def test_a_report_says_where_it_rests():
    scene = problem(JUMP.replace("LOAD", "30") + "find: [equilibrium]\n")
    told = str(report(scene, solution(scene)).sections)
    assert "a force jumps there" in told and "balanced with" in told
