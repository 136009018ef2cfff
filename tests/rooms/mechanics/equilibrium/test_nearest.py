"""`equilibrium:` names a place: the equilibrium nearest to it is meant, stable or not, in scaled coordinates.

The zeros are known beforehand: those of polynomials with chosen roots, and of two functions that hang together.
"""

import json
import random
from fractions import Fraction
from math import hypot, pi

import pytest
from support.scenes import problem, value

from vibcli.base.errors import NoEquilibrium
from vibcli.cli.program import run
from vibcli.mechanics.equilibrium.all_equilibria import find_equilibria
from vibcli.mechanics.symbolic_equilibrium_linear import equilibrium_in_letters
from vibcli.symbolic.evaluation import Floats, evaluate


def scene(V, start, parameters=""):
    names = list(start)
    T = " + ".join(f"{name}'^2" for name in names)
    begin = ", ".join(f"{name}: {x!r}" for name, x in start.items())
    return problem(f"parameters: {{J: 1 kg*m^2, E: 1 J{parameters}}}\ncoordinates: [{', '.join(names)}]\n"
                   f"equilibrium: {{{begin}}}\nenergies: {{T: J/2*({T}), V: E*({V})}}\n")


def integral(roots, variable):
    """∫ Π (u − r) du as text."""
    slopes = [1]
    for root in roots:
        slopes = [a - root * b for a, b in zip([*slopes, 0], [0, *slopes], strict=True)]
    top = len(roots)
    return " + ".join(f"({c})*({variable})^{top + 1 - i}/{top + 1 - i}" for i, c in enumerate(slopes))


@pytest.mark.sweep
def test_of_one_coordinate():
    draw = random.Random("nearest")
    for _ in range(20):
        roots = sorted(draw.sample(range(-20, 21), draw.randint(1, 5)))
        start = draw.uniform(-22, 22)
        if len(roots) > 1 and len({abs(start - root) for root in roots}) < len(roots):
            continue
        found = scene(integral([root / 8 for root in roots], "x"), {"x": start / 8})
        best = min(roots, key=lambda root: abs(root - start))
        assert value(found, "equilibrium[x]") == pytest.approx(best / 8, abs=1e-11), (roots, start)
        rising = (len(roots) - 1 - roots.index(best)) % 2 == 0
        assert value(found, "stable") is rising
        assert found.configuration.equilibrium.from_start["x"] == pytest.approx((best - start) / 8, abs=1e-11)


@pytest.mark.sweep
def test_of_two_coordinates():
    """V = P(x) + Q(x + y): x is a root of P′ and x + y one of Q′."""
    draw = random.Random("two")
    for _ in range(8):
        one, two = ([root / 4 for root in draw.sample(range(-6, 7), 3)] for _ in "xy")
        zeros = [(x, u - x) for x in one for u in two]
        start = draw.uniform(-1.5, 1.5), draw.uniform(-1.5, 1.5)
        found = scene(f"{integral(one, 'x')} + {integral(two, 'x + y')}", dict(zip("xy", start, strict=True)))
        place = value(found, "equilibrium[x]"), value(found, "equilibrium[y]")
        best = min(zeros, key=lambda zero: hypot(zero[0] - start[0], zero[1] - start[1]))
        assert place == pytest.approx(best, abs=1e-9), (one, two, start)


PENDULUM = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, kt: 6 N*m}
gravity: g
bodies:
  b: {mass: m, at: [0, L], pin: {at: [0, 0], by: f}}
  c: {mass: m, slide: x}
springs: {s: {torsion: kt, between: [ground, b]}}
equilibrium: {f: START, x: 0.3 m}
"""


@pytest.mark.parametrize("start, at, stable", [(0.2, 0.0, False), (-1.5, -1.6319443, True), (0.9, 1.6319443, True),
                                               (1e-9, 0.0, False), (pi, 1.6319443, True)])
def test_stable_or_not_and_what_is_free_stays(start, at, stable):
    """kt f = m g L sin f at 0 and ±1.69; the other body can stand anywhere."""
    found = problem(PENDULUM.replace("START", repr(start)))
    assert value(found, "equilibrium[f]") == pytest.approx(at, abs=1e-6)
    assert value(found, "equilibrium[x]") == pytest.approx(0.3, abs=1e-12)
    assert value(found, "stable") is stable


@pytest.mark.sweep
def test_of_a_line_of_equilibria_the_nearest_place():
    """V = (x² + y² − 1)²: the circle, met along the radius of the start."""
    found = scene("(x^2 + y^2 - 1)^2", {"x": 0.9, "y": 1.2})
    assert (value(found, "equilibrium[x]"), value(found, "equilibrium[y]")) == pytest.approx((0.6, 0.8), abs=1e-6)


def test_the_report_says_how_far(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 1 kg, a: 1 N, b: 1 N/m, c: 1 N/m^3}\ncoordinates: [x]\nequilibrium: {x: 0.25 m}\n"
                    "energies: {T: m*x'^2/2, V: a*x - 2*b*x^2 + c*x^4}\n")
    assert run(["solve", str(path)]) == 0
    out = capsys.readouterr().out
    assert "the nearest found to the start x = 0.25 m, from there Δx = 0.0195944 m" in out and "unstable" in out
    assert run(["frequencies", str(path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["equilibrium"]
    assert found["from_start"] == {"x": pytest.approx(0.0195944364, abs=1e-9)}

LETTERS = {
    "rail": ("parameters: {m: {unit: kg}, k: {unit: N/m}, l0: {unit: m}, h: {unit: m}}\n"
             "bodies: {b: {mass: m, at: [0, 0], slide: x}}\n"
             "springs: {s: {k: k, between: [[0, h], b], free_length: l0}}",
             ["x: sqrt(l0^2 - h^2)", "x: 0", "x: -sqrt(l0^2 - h^2)"], {"m": 2, "k": 50, "l0": 0.5, "h": 0.3}),
    "hoop": ("parameters: {R: {unit: m}, w: {unit: rad/s}, g: {unit: m/s^2}, m: {unit: kg}}\ncoordinates: [q]\n"
             "energies: {T: m*R^2/2*(q'^2 + w^2*sin(q)^2), V: -m*g*R*cos(q)}",
             ["q: pi", "q: acos(g/(R*w^2))", "q: -pi"], {"R": 0.5, "w": 6, "g": 9.81, "m": 2}),
    "double": ("parameters: {m: {unit: kg}, l: {unit: m}, g: {unit: m/s^2}}\ngravity: g\nbodies:\n"
               "  a: {mass: m, at: [0, -l], pin: {at: [0, 0], by: p}}\n"
               "  b: {mass: m, at: [0, -2*l], pin: {at: a, by: s}}",
               ["p: pi, s: pi", "p: pi, s: 0", "p: 0, s: pi", "p: 0, s: 0", "s: pi"], {"m": 2, "l": 0.5, "g": 9.81}),
    "free": ("parameters: {m: {unit: kg}, k: {unit: N/m}, d: {unit: m}}\nbodies: {a: {mass: m, slide: x}, "
             "b: {mass: m, slide: y}}\nsprings: {s: {k: k, between: [ground, a]}}",
             ["x: 0, y: d", "x: d"], {"m": 2, "k": 50, "d": 0.3}),
}


@pytest.mark.parametrize("name, start", [(name, start) for name, (_, starts, _) in LETTERS.items() for start in starts])
def test_letters_mean_the_same_as_numbers(name, start):
    text, _, values = LETTERS[name]
    found = problem(f"{text}\nequilibrium: {{{start}}}\n")
    numbers = found.with_values({key: Fraction(str(x)) for key, x in values.items()})
    place = equilibrium_in_letters(found.symbolic)
    for q, node in place.items():
        place = numbers.configuration.equilibrium.values[q]
        assert evaluate([node], Floats, numbers.numeric.floats)[0] == pytest.approx(place, abs=1e-12)
    matrices = numbers.configuration.linear_system.matrices()
    for letters, exact in zip(found.symbolic.matrices, matrices, strict=True):
        for pair in {*letters, *exact}:
            entry = evaluate([letters[pair]], Floats, numbers.numeric.floats)[0] if pair in letters else 0.0
            assert entry == pytest.approx(exact.get(pair, 0.0), rel=1e-11, abs=1e-11)


@pytest.mark.parametrize(("kind", "told"), [("text", "Δφ₁ = "), ("html", "<mi>Δ</mi><msub><mi>φ</mi>"),
                                            ("latex", r"\Delta \varphi_{1} = "),
                                            ("markdown", r"\Delta \varphi _ {1} =")])
def test_the_way_from_the_start_is_written_in_letters(kind, told, tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 1 kg, a: 1 J, b: 4 J}\ncoordinates: [phi1]\nequilibrium: {phi1: 0.25}\n"
                    "energies: {T: m*(1 m)^2*phi1'^2/2, V: a*phi1 + b*phi1^2}\n")
    assert run(["solve", str(path), "--format", kind]) == 0
    out = capsys.readouterr().out
    assert told in out and "Δphi" not in out


TURNED = """
    parameters: {m: 0.5 kg, k: 80 N/m, a: 0.3 m, Omega: 20 rad/s}
    bodies:
      rod: {at: [0, 0], pin: {at: [0, 0], by: Omega*t}}
      bead: {mass: m, at: [a, 0], slide: {along: [1, 0], by: u, carrier: rod}}
    springs: {s: {k: k, between: [[0, 0], bead]}}
"""
TIPPED = """
    bodies: {block: {mass: 2 kg, slide: x}}
    energies: {V: 3 N*x - 30 N/m*x^2}
"""


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "name", "at"), [(TURNED, "u", 0.5 * 400 * 0.3 / (80 - 0.5 * 400)),
                                                  (TIPPED, "x", 0.05)])
def test_where_linear_forces_balance_they_may_lead_away(text, name, at):
    """The one equilibrium of a stiffness below zero: found where it is asked for, and told where it is not reached."""
    with pytest.raises(NoEquilibrium, match="forces lead away from the only one") as refused:
        _ = problem(text).configuration.equilibrium
    assert f"it is {name} = {at:g}: " in refused.value.hint
    near = problem(text + f"    equilibrium: {{{name}: {at - 0.03} m}}\n").configuration
    assert near.equilibrium.values == pytest.approx({name: at}, rel=1e-15)
    assert near.equilibrium.from_start == pytest.approx({name: 0.03}, rel=1e-12)
    (only,) = find_equilibria(problem(text).configuration).items
    assert only.equilibrium.values == pytest.approx({name: at}, rel=1e-15)


@pytest.mark.sweep
def test_where_no_linear_forces_balance_nothing_is_listed():
    scene = problem("bodies: {block: {mass: 2 kg, slide: x}}\nenergies: {V: 3 N*x}\n")
    with pytest.raises(NoEquilibrium, match="nothing holds 'x'"):
        _ = scene.configuration.equilibrium
    assert find_equilibria(scene.configuration).items == []
