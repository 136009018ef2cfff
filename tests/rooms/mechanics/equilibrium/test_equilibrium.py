"""Equilibria (gate A13): flat and singular starts, several, unstable, at every scale; none: refused by name."""

from math import asin, pi, sin, sqrt

import pytest
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError

SCALE = 1e-14


def balanced(scene):
    assert scene.configuration.equilibrium.residual <= SCALE
    return scene.configuration.equilibrium.values


def potential(V, coordinates, start=""):
    """A scene of angles with the potential energy V(x, y) written out, in joules, and unit inertias."""
    T = " + ".join(f"{name}'^2" for name in coordinates)
    begin = f"equilibrium: {{{start}}}\n" if start else ""
    return problem(f"parameters: {{J: 1 kg*m^2, E: 1 J}}\ncoordinates: [{', '.join(coordinates)}]\n{begin}"
                   f"energies:\n  T: J/2*({T})\n  V: E*({V})\n")


@pytest.mark.sweep
@pytest.mark.parametrize("V, start, expected", [
    ("450*y^2 + ((x + 0.001)^2 - 1)^2/4", "", {"x": 0.999, "y": 0.0}),
    ("450*y^2 + (x - 1)^4 + x", "", {"x": 1 - 0.25 ** (1 / 3), "y": 0.0}),
    ("450*y^2 + (x^4/4 - x)*20 + x*y", "", None),
    ("450*(y - x)^2 + 20*x^4/4 - 20*x", "", {"x": 1.0, "y": 1.0}),
    ("exp(x) - 3*x + y^2", "", {"x": 1.0986122886681098, "y": 0.0}),
    ("cosh(x - 8) + 5*cosh(y + 9)", "", {"x": 8.0, "y": -9.0}),
    ("100*(y - x^2)^2 + (1 - x)^2", "x: -1.2, y: 1", {"x": 1.0, "y": 1.0}),
])
def test_flat_and_singular_starts(V, start, expected):
    """K = diag(0, 900) and V″ = 0 with V′ ≠ 0 at the start; Rosenbrock's valley."""
    scene = potential(V, "xy", start)
    found = balanced(scene)
    assert value(scene, "stable")
    for name, exact in (expected or {}).items():
        assert found[name] == pytest.approx(exact, rel=1e-11, abs=1e-11)


def test_singular_stiffness_as_drawn():
    """K = diag(0, 900) as drawn, an equilibrium with a mode of frequency zero; no search is needed."""
    scene = potential("450*y^2", "xy")
    assert balanced(scene) == {"x": 0.0, "y": 0.0}
    assert scene.configuration.equilibrium.drawn
    assert value(scene, "omega[1]") == 0.0
    assert value(scene, "omega[2]") == 30.0


def test_slope_without_curvature_at_the_start():
    """V″ = 0 with V′ ≠ 0: a straight fall that ends in a bowl."""
    scene = potential("x^3/3 - x", "x")
    assert balanced(scene)["x"] == pytest.approx(1.0, rel=1e-14)
    assert value(scene, "omega[1]") == pytest.approx(sqrt(2), rel=1e-13)


@pytest.mark.parametrize("V, names, falls", [
    ("-3*x", "x", "x"), ("y^2 - x", "xy", "x"), ("y^2 - (x + 1/2)^3", "xy", "x"), ("x^2 - exp(y) + y/2", "xy", "y"),
    ("exp(-x) + y^2", "xy", "x")])
def test_without_equilibrium(V, names, falls):
    with pytest.raises(PhysicsError, match=f"'{falls}'"):
        potential(V, names).configuration.equilibrium  # noqa: B018


def test_a_mass_that_nothing_holds():
    scene = problem("parameters: {m: 2 kg, g: 9.81 m/s^2}\ngravity: g\nbodies: {b: {mass: m, at: [0, 0], "
                    "slide: {along: [0, 1], by: fall}}}")
    with pytest.raises(PhysicsError, match="'fall'"):
        scene.configuration.equilibrium  # noqa: B018


PENDULUM = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, kt: KT N*m}
gravity: g
coordinates: {f: START}
bodies: {b: {mass: m, at: AT, pin: {at: [0, 0], by: f}}}
springs: {s: {torsion: kt, between: [ground, b]}}
"""


def pendulum(kt, at="[0, L]", start="angle"):
    return problem(PENDULUM.replace("KT", str(kt)).replace("AT", at).replace("START", start))


@pytest.mark.parametrize("kt, stable", [(20, True), (9, False), (9.8101, True), (9.8099, False)])
def test_the_upright_pendulum_is_kept_where_it_is_drawn(kt, stable):
    scene = pendulum(kt)
    assert balanced(scene) == {"f": 0.0}
    assert value(scene, "stable") is stable
    if not stable:
        assert value(scene, "growth_rate[1]") == pytest.approx(sqrt((9.81 - kt) / 0.5), rel=1e-12)


def test_the_buckled_pendulum_is_found_on_either_side():
    for start in (0.9, -0.9):
        text = PENDULUM.replace("KT", "6").replace("AT", "[0, L]").replace("START", "angle")
        scene = problem(text + f"equilibrium: {{f: {start}}}")
        f = balanced(scene)["f"]
        assert f * start > 0
        assert value(scene, "stable")
        assert 6 * f == pytest.approx(9.81 * sin(f), rel=1e-13)


@pytest.mark.parametrize("unit, factor", [("km", 1e3), ("m", 1.0), ("mm", 1e-3), ("µm", 1e-6)])
def test_every_scale(unit, factor):
    """The same figure in kilometres and in micrometres: the angle is the same to the last digits, lengths scale."""
    text = f"""
parameters: {{m: 3 kg, a: 2 {unit}, b: 1.5 {unit}, w: {30 / factor} N/m, g: 9.81 m/s^2}}
gravity: g
points:
  A: {{body: rod, at: [a, 0]}}
bodies:
  rod: {{shape: rod, mass: m, from: [0, 0], to: [a, 0], pin: {{at: [0, 0], by: f}}}}
  bead: {{mass: m, at: [3*a, 0], move: [x, y, 0]}}
springs:
  s: {{k: w, between: [[0, b], A]}}
  t: {{k: w, between: [[3*a, 2*b], bead]}}
  u: {{k: w, between: [A, bead]}}
"""
    found, reference = balanced(problem(text)), REFERENCE.setdefault("m", balanced(problem(
        text.replace(unit + ",", "m,").replace(f"w: {30 / factor}", "w: 30.0"))))
    assert found["f"] == pytest.approx(reference["f"], rel=1e-12)
    for name in "xy":
        assert found[name] == pytest.approx(reference[name] * factor, rel=1e-11)


REFERENCE = {}


@pytest.mark.parametrize("unit, factor", [("m", 1.0), ("mm", 1e-3), ("µm", 1e-6)])
def test_a_hanging_weight(unit, factor):
    scene = problem(f"parameters: {{m: 2 kg, k: 80 N/{unit}, g: 9.81 m/s^2, h: 1 {unit}}}\ngravity: g\nbodies: {{b: "
                    f"{{mass: m, at: [0, 0],"
                    " slide: {along: [0, -1], by: x}}}\nsprings: {s: {k: k, between: [[0, h], b]}}")
    assert balanced(scene)["x"] == pytest.approx(2 * 9.81 / 80 * factor, rel=1e-14)


def test_linear_scenes_take_one_step():
    scene = problem("parameters: {m: 2 kg, k: 80 N/m, N: 3 N}\nbodies:\n  a: {mass: m, slide: x}\n"
                    "  b: {mass: m, slide: y}\nsprings:\n  s: {k: k, between: [ground, a], preload: N}\n"
                    "  t: {k: k, between: [a, b]}")
    assert balanced(scene) == {"x": pytest.approx(-3 / 80), "y": pytest.approx(-3 / 80)}
    assert scene.configuration.equilibrium.steps <= 2


def test_relative_equilibrium_of_a_governor():
    """A bead on a hoop that spins about its upright axis: cos θ = g/(R Ω²) above the critical speed, 0 below."""
    for speed in (6.0, 4.0):
        scene = problem(f"coordinates: [q]\nequilibrium: {{q: 0.6}}\nenergies:\n  T: 1/2*2*0.5^2*(q'^2 + "
                        f"{speed}^2*sin(q)^2)\n"
                        "  V: -2*9.81*0.5*cos(q)\n")
        cosine = min(9.81 / (0.5 * speed**2), 1.0)
        q = balanced(scene)["q"]
        assert q == pytest.approx(pi / 2 - asin(cosine), rel=1e-12, abs=1e-9)
        assert value(scene, "stable")
        square = speed**2 * (1 - cosine**2) if cosine < 1 else 9.81 / 0.5 - speed**2
        assert value(scene, "omega[1]") == pytest.approx(sqrt(square), rel=1e-9)


@pytest.mark.parametrize("start", [0.2, -0.9, 1e-6, 3.0])
def test_an_equilibrium_where_every_force_vanishes(start):
    """At f = 0 the moments of spring and weight are both zero: nothing is left to compare the residual with there."""
    text = PENDULUM.replace("KT", "20").replace("AT", "[0, L]").replace("START", "angle")
    scene = problem(text + f"equilibrium: {{f: {start}}}")
    assert balanced(scene)["f"] == pytest.approx(0.0, abs=1e-15)
    assert value(scene, "omega[1]") == pytest.approx(sqrt((20 - 9.81) / 0.5), rel=1e-13)
