"""M, C, K and Q at states of motions against hand-written energies, differentiated by mpmath at their places."""

import math
from pathlib import Path
from textwrap import dedent

import mpmath
import pytest
from support.scenes import problem, problem_of, value

from vibcli import loads
from vibcli.base.errors import PhysicsError
from vibcli.check.instances import Instances
from vibcli.quantities.expression import measure
from vibcli.quantities.quantity import declared
from vibcli.symbolic.parser import parse

PROBLEMS = Path(__file__).parents[3] / "problems"
RESTING = ("3_free_undamped/four_bar_with_springs", "3_free_undamped/paddle_on_turning_hub",
           "4_free_damped/galloping_sign_arm", "4_free_damped/bell_crank_dashpot",
           "6_two_degrees/column_under_follower_force", "6_two_degrees/centrifugal_pendulum_absorber",
           "6_two_degrees/particle_on_turning_disc", "6_two_degrees/two_beads_on_whirling_rod",
           "6_two_degrees/wing_section_in_wind", "6_two_degrees/two_link_arm_under_load",
           "6_two_degrees/matrices_outright", "6_more_degrees/bead_in_swinging_tube")
NUMBERS = {"m": 2.0, "M": 3.0, "L": 0.7, "k": 40.0, "c": 1.5, "g": 9.81, "F": 6.0, "w": 5.0, "h": 0.9}
CART = dedent("""
    parameters: {m: 2 kg, M: 3 kg, L: 0.7 m, k: 40 N/m, c: 1.5 N*s/m, g: 9.81 m/s^2, F: 6 N, w: 5 rad/s, h: 0.9 m}
    gravity: g
    points: {E: [-2*h, -h]}
    bodies:
      cart: {mass: M, at: [0, 0], slide: x}
      bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
    springs: {s: {k: k, between: [E, bob]}}
    dampers: {d: {c: c, between: [[-h, 0], cart]}}
    forces: {f: {at: bob, force: ["F*cos(w*t)", 0]}}
    motion: KIND
    initial: {x: 0.3 m, "x'": 1 m/s, phi: 0.8 rad, "phi'": -2 rad/s}
    find: [{response: {until: 1 s}}]
""")


def by_hand(x, phi, t):
    """{quantity: value}, V = ½ k (l − l₀)² − m g L cos φ of a bob on a cart, F cos wt along x of the bob."""
    m, M, L, k, c, g, F, w, h = map(mpmath.mpf, NUMBERS.values())

    def V(x, phi):
        X, Y = x + L * mpmath.sin(phi), -L * mpmath.cos(phi)
        stretch = mpmath.hypot(X + 2 * h, Y + h) - mpmath.hypot(2 * h, h - L)
        return k * stretch**2 / 2 + m * g * Y

    load = F * mpmath.cos(w * t)

    def work(x, phi):
        return V(x, phi) - load * (x + L * mpmath.sin(phi))

    here = (x, phi)
    found = {"Q[x]": -mpmath.diff(work, here, (1, 0)), "Q[phi]": -mpmath.diff(work, here, (0, 1)),
             "K[x,x]": mpmath.diff(work, here, (2, 0)), "K[x,phi]": mpmath.diff(work, here, (1, 1)),
             "K[phi,x]": mpmath.diff(work, here, (1, 1)), "K[phi,phi]": mpmath.diff(work, here, (0, 2)),
             "M[x,x]": M + m, "M[x,phi]": m * L * mpmath.cos(phi), "M[phi,phi]": m * L**2,
             "C[x,x]": c, "C[x,phi]": 0, "C[phi,phi]": 0}
    return {text: float(number) for text, number in found.items()}


@pytest.mark.parametrize("kind", ["full", "small"])
@pytest.mark.parametrize("time", [0.0, 0.37])
def test_they_are_those_of_the_place_and_instant(kind, time):
    scene = problem(CART.replace("KIND", kind))
    x, phi = (value(scene, f"{name}({time} s)") for name in ("x", "phi"))
    with mpmath.workdps(30):
        wanted = by_hand(mpmath.mpf(x), mpmath.mpf(phi), mpmath.mpf(time))
    for text, number in wanted.items():
        assert value(scene, f"{text}({time} s)") == pytest.approx(number, rel=1e-9, abs=1e-9), text


@pytest.mark.parametrize("name", RESTING)
def test_where_a_scene_stays_they_are_those_of_its_small_motions(name):
    """Turning frames, follower forces and loads that follow speeds included; Q vanishes there."""
    scene = next(iter(Instances(problem_of(PROBLEMS / f"{name}.yaml"))))
    names = scene.scene.coordinates
    for i in names:
        tree = parse(f"Q[{i}](0 s)")
        assert abs(measure(scene, tree)[0]) <= 1e-9 * declared(tree).size(scene, tree)
        for which in "MCK":
            for j in names:
                tree = parse(f"{which}[{i},{j}](0 s)")
                size = declared(tree).size(scene, tree)
                assert value(scene, f"{which}[{i},{j}]") == pytest.approx(measure(scene, tree)[0], rel=1e-9,
                                                                          abs=1e-9 * size), (which, i, j)


def test_no_motion_is_followed_to_its_start():
    """A load that would take the whole patience to follow is no hindrance at t = 0."""
    scene = problem(CART.replace("KIND", "full").replace("F*cos(w*t)", "F*cos(1e9*w*t)"))
    assert value(scene, "K[phi,phi](0 s)") == pytest.approx(by_hand(0.3, 0.8, 0)["K[phi,phi]"], rel=1e-9)
    assert not scene.response.integrated


@pytest.mark.sweep
def test_about_each_equilibrium():
    """K about all rests of a pendulum held by a soft torsion spring: kt + m g L cos φ."""
    scene = problem("""
        parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, kt: 2 N*m}
        gravity: g
        points: {O: [0, 0]}
        bodies: {b: {mass: m, at: [0, -L], pin: {at: O, by: phi}}}
        springs: {s: {torsion: kt, between: [ground, b]}}
        find: [{equilibria: all, within: {phi: [-7, 7]}}]
    """)
    count = value(scene, "equilibria")
    assert count > 2
    for i in range(1, count + 1):
        phi = value(scene, f"equilibrium[phi][{i}]")
        assert value(scene, f"K[phi,phi][{i}]") == pytest.approx(2 + 9.81 * float(mpmath.cos(phi)), rel=1e-9)
        assert value(scene, f"M[1,1][{i}]") == pytest.approx(0.5)
    with pytest.raises(PhysicsError, match="there is no equilibrium"):
        value(scene, f"K[phi,phi][{count + 1}]")


def test_at_the_start_in_letters():
    """A bob on a sprung cart let go aside, by the expressions of Lagrange's equations written by hand."""
    model = loads(dedent("""
        parameters: {m: {unit: kg}, M: {unit: kg}, L: {unit: m}, k: {unit: N/m}, g: {unit: m/s^2}, a: {unit: rad}}
        gravity: g
        bodies:
          cart: {mass: M, at: [0, 0], slide: x}
          bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
        springs: {s: {k: k, between: [[-1 m, 0], cart]}}
        motion: full
        initial: {phi: a, x: L, "phi'": 2 rad/s}
    """))
    for text, wanted in {"K[phi,phi](0 s)": "m*L*g*cos(a)", "Q[phi](0 s)": "-m*L*g*sin(a)", "Q[x](0 s)": "-k*L",
                         "M[x,phi](0 s)": "m*L*cos(a)", "C[x,phi](0 s)": "0", "M[x,x](0 s)": "m + M"}.items():
        found = {name: number for name, number in NUMBERS.items() if name in "mMLkg"} | {"a": 0.8}
        functions = {"cos": math.cos, "sin": math.sin}
        one, other = (eval(part.replace("^", "**"), functions, found)       # of this file's own texts
                      for part in (str(model[text].expression), wanted))
        assert one == pytest.approx(other, rel=1e-12), text
    with pytest.raises(PhysicsError, match="found in numbers"):
        model["K[phi,phi](1 s)"]
