"""Motions of equations expanded to the third order, against elliptic functions and energies."""

import json
import math
from textwrap import dedent

import mpmath
import pytest
import sympy
from support.scenes import problem, problem_of, value

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli.program import run
from vibcli.mechanics.lagrange import equation_of
from vibcli.symbolic.evaluation import Floats, evaluate

BEAD = """
parameters: {{m: 2 kg, k: 300 N/m, g3: 500 N/m^3, l: 0.5 m, N: 20 N, A: 0.2 m}}
bodies: {{p: {{mass: m, at: [0, 0], slide: x}}}}
springs:
  along: {{law: "k*d + g3*d^3", between: [[-l, 0], p]}}
  above: {{k: k, preload: N, between: [[0, l], p]}}
  below: {{k: k, preload: N, between: [[0, -l], p]}}
initial: {{x: A}}
motion: {motion}
"""


def test_bead_between_springs_is_a_duffing_oscillator():
    m, k, g3, length, N, A = 2, 300, 500, 0.5, 20, 0.2
    linear, cubic = k + 2 * N / length, g3 + (k - N / length) / length**2
    omega = mpmath.sqrt((linear + cubic * A**2) / m)
    modulus = cubic * A**2 / (2 * (linear + cubic * A**2))
    scene = problem(BEAD.format(motion="{order: 3}"))
    assert value(scene, "period(x)") == pytest.approx(float(4 * mpmath.ellipk(modulus) / omega), rel=1e-14)
    assert value(scene, "x(1 s)") == pytest.approx(float(A * mpmath.ellipfun("cn", omega, m=modulus)), rel=1e-9)
    full = problem(BEAD.format(motion="full"))
    assert value(full, "period(x)") != pytest.approx(value(scene, "period(x)"), rel=1e-5)
    assert value(full, "period(x)") == pytest.approx(value(scene, "period(x)"), rel=5e-3)


def test_loads_that_follow_the_motion_are_expanded_too():
    text = """
    parameters: {{m: 1 kg, k: 9 N/m, F: 2 N, b: 1 m}}
    bodies: {{p: {{mass: m, at: [0 m, 0 m], slide: x}}}}
    springs: {{s: {{k: k, between: [[-1 m, 0 m], p]}}}}
    forces: {{F: {{at: p, force: ["{F}", 0 N]}}}}
    initial: {{x: 0.4 m}}
    motion: {motion}
    """
    expanded = problem(text.format(F="F*(sin(x/b) - x/b)", motion="{order: 3}"))
    written_out = problem(text.format(F="-F*(x/b)^3/6", motion="full"))
    assert value(expanded, "x(2 s)") == pytest.approx(value(written_out, "x(2 s)"), rel=1e-10)


DRIVEN = """
parameters: {m: 2 kg, k: 300 N/m, l: 0.5 m, N: 20 N, c: 3 N*s/m, F: 5 N, Om: 3 rad/s}
bodies: {p: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, preload: N, between: [[0, l], p]}}
dampers: {d: {c: c, between: [[0, l], p]}}
forces: {F: {at: p, force: ["F*sin(Om*t)", 0 N]}}
motion: {order: 3}
answers:
  motion[x]: "m*x'' + c*x^2*x'/l^2 + N/l*x + (k - N/l)/(2*l^2)*x^3 = F*sin(Om*t)"
"""
HUNG = """
parameters: {m: 2 kg, k: 300 N/m, g3: 4000 N/m^3, g: 9.81 m/s^2, A: 0.12 m}
gravity: g
bodies: {p: {mass: m, at: [0, 0], slide: {along: [0, -1], by: y}}}
springs:
  s: {law: "k*d + g3*d^3", between: [[0, 1 m], p]}
  side: {k: k, between: [[1 m, 0], p]}
initial: {y: A}
motion: {order: 3}
"""
STOP = """
parameters: {m: 2 kg, k: 300 N/m, k2: 100 N/m, g: 9.81 m/s^2, gap: 1 cm}
gravity: g
bodies: {p: {mass: m, at: [0, 0], move: [0, y, 0]}}
springs:
  s: {k: k, between: [[0, 1 m], p]}
  stop: {k: k2, acts: tension, gap: gap, between: [[0, 1 m], p]}
initial: {y: -2 cm}
motion: {order: 3}
"""


def answered(capsys, tmp_path, command, text):
    (tmp_path / "scene.yaml").write_text(text, encoding="utf-8")
    assert run([*command, str(tmp_path / "scene.yaml")]) == 0
    return capsys.readouterr().out


def test_the_report_tells_the_equations_of_the_expansion_with_dampers_and_loads(capsys, tmp_path):
    out = answered(capsys, tmp_path, ["solve"], DRIVEN)
    assert "Equations of motion, to the third order about the equilibrium\n" in out
    assert "x:  m·ẍ + c·x²·ẋ/l² + N·x/l + (k·l − N)·x³/(2·l³) = F·sin(Om·t)" in out
    assert "agrees in 1 file" in answered(capsys, tmp_path, ["check"], DRIVEN)


@pytest.mark.sweep
def test_equations_about_a_deformed_position_count_from_it_and_as_data_from_the_drawn_one(capsys, tmp_path):
    """s: k + 3 g₃ y₀² and 3 g₃ y₀ of the hardening spring; the other one by SymPy."""
    y, m, k, g3, g = sympy.symbols("y"), 2, 300, 4000, sympy.Rational(981, 100)
    V = k * y**2 / 2 + g3 * y**4 / 4 + k * (sympy.sqrt(1 + y**2) - 1)**2 / 2 - m * g * y
    rest = sympy.nsolve(sympy.diff(V, y), 0.06, prec=30)
    slopes = [float(sympy.diff(V, y, n).subs(y, rest) / sympy.factorial(n - 1)) for n in (2, 3, 4)]
    row, = json.loads(answered(capsys, tmp_path, ["equations", "--json"], HUNG))["equations"]
    text, at = row["text"].removesuffix(" = 0").replace("^", "**"), 0.2 - float(rest)
    found = sympy.sympify(text.replace("y''", "a"), locals={"a": 0.0}).subs("y", sympy.Float("0.2", 17))
    assert float(found) == pytest.approx(sum(c * at**n for n, c in enumerate(slopes, 1)), rel=1e-12)
    out = answered(capsys, tmp_path, ["equations"], HUNG)
    assert "about the equilibrium, the coordinates counted from it\n  y:  2·ÿ + " in out


@pytest.mark.sweep
def test_the_period_stands_beside_the_exact_one_as_data(capsys, tmp_path):
    found = json.loads(answered(capsys, tmp_path, ["response", "--json"], HUNG))["response"]["periods"]
    assert found["coordinate"] == "y" and found["reason"] is None
    assert found["expanded"] == pytest.approx(value(problem(HUNG), "period(y)"), rel=1e-14)
    assert found["full"] == pytest.approx(value(problem(HUNG.replace("{order: 3}", "full")), "period(y)"), rel=1e-14)
    assert found["difference"] == found["expanded"] - found["full"] != 0
    assert json.loads(answered(capsys, tmp_path, ["response", "--json"], DRIVEN))["response"]["periods"] is None


def test_a_spring_with_a_gap_is_expanded_on_its_side_of_it():
    """Rest at −20.62 mm, where both springs pull; in letters nothing tells that."""
    scene = problem(STOP)
    assert value(scene, "period(y)") == pytest.approx(2 * math.pi * (2 / 400)**0.5, rel=1e-14)
    letters = problem(STOP.replace("gap: 1 cm", "gap: {unit: m}"))
    assert letters.symbolic.equations.unexpanded is not None


@pytest.mark.sweep
def test_what_changes_with_the_time_stands_in_numbers_about_a_deformed_position(capsys, tmp_path):
    """A spring whose upper end is moved by h sin(Ω t): no more than k h sin(Ω t) on the right side."""
    text = """
    parameters: {m: 2 kg, k: 200 N/m, g: 9.81 m/s^2, h: 3 cm, Om: 20 rad/s}
    gravity: g
    points: {W: {at: [0, 1 m], moves: [0 m, "h*sin(Om*t)"]}}
    bodies: {p: {mass: m, at: [0, 0], move: [0, y, 0]}}
    springs:
      s: {k: k, between: [W, p]}
      side: {k: k, preload: 5 N, between: [[1 m, 0], p]}
    motion: {order: 3}
    """
    out = answered(capsys, tmp_path, ["equations"], dedent(text))
    y = sympy.symbols("y")
    V = 100 * y**2 + 5 * sympy.sqrt(1 + y**2) + 100 * (sympy.sqrt(1 + y**2) - 1)**2 + 2 * sympy.Float("9.81", 30) * y
    rest = sympy.nsolve(sympy.diff(V, y), -0.1, prec=30)
    linear, quadratic, cubic = (sympy.diff(V, y, n).subs(y, rest) / sympy.factorial(n - 1) for n in (2, 3, 4))
    assert f"y:  2·ÿ + {linear:.9f}·y − {-quadratic:.10f}·y² + {cubic:.10f}·y³ = 6·sin(Om·t)" in out


@pytest.mark.sweep
def test_full_equations_and_expanded_ones_differ_by_the_fourth_order(tmp_path):
    """With a shaken support, a load that follows the motion and a record, about a deformed position."""
    (tmp_path / "ag.csv").write_text("t,a\n0,0\n0.5,2\n1,-1\n2,0\n", encoding="utf-8")
    (tmp_path / "scene.yaml").write_text(dedent("""
    parameters: {m: 2 kg, k: 200 N/m, g: 9.81 m/s^2, h: 3 cm, Om: 20 rad/s, F: 4 N, c: 3 N*s/m, b: 1 m}
    records: {ag: ag.csv}
    gravity: g
    points: {W: {at: [0, 1 m], moves: ["h*cos(Om*t)", "h*sin(Om*t)"]}}
    bodies: {p: {mass: m, at: [0, 0], move: [x, y, 0]}}
    springs: {s: {k: k, between: [W, p]}, side: {law: "k*d + 4*k/b*d^2", between: [[1 m, 0.5 m], p]}}
    dampers: {d: {c: c, between: [W, p]}}
    forces: {F: {at: p, force: [F*ag(t), F*sin(x/b)]}}
    motion: {order: 3}
    """), encoding="utf-8")
    scene = problem_of(tmp_path / "scene.yaml")
    expanded, symbols = scene.symbolic.equations.full, scene.scene
    full = [equation_of(symbols, i) for i in range(2)]
    rest, off = scene.configuration.equilibrium.values, []
    for part in (0.02, 0.01, 0.0):
        state = {s.name: part * n for n, s in enumerate((*symbols.q, *symbols.v, *symbols.a), 1)}
        state |= {q.name: rest[q.name] + state[q.name] for q in symbols.q}
        found = evaluate([*full, *expanded], Floats, {**scene.numeric.floats, **state, symbols.time.name: 0.7})
        off.append(max(abs(found[i] - found[i + 2]) for i in range(2)))
    assert off[2] < 1e-12 < 1e-6 < off[0]
    assert 10 < off[0] / off[1] < 24


def test_a_damper_with_a_kink_is_named_where_its_energy_has_no_expansion():
    text = ("parameters: {m: 2 kg, k: 200 N/m, c: 8 kg/m}\nbodies: {p: {mass: m, slide: x}}\nmotion: {order: 3}\n"
            "springs: {s: {k: k, between: [ground, p]}}\ninitial: {x: 20 cm}\n"
            "dampers: {water: {law: c*v*abs(v), between: [ground, p]}}\n")
    with pytest.raises(PhysicsError, match="'water' has a kink of abs in the equilibrium: Φ has no") as refusal:
        value(problem(text), "x(1 s)")
    assert refusal.value.hint == "ask for motion: full"


def test_other_orders_are_refused():
    with pytest.raises(SpecError, match="expanded to the third order alone"):
        problem(BEAD.format(motion="{order: 5}"))


def test_energies_along_the_motion_are_refused():
    with pytest.raises(PhysicsError, match="energies along a motion of the expanded equations are not told"):
        value(problem(BEAD.format(motion="{order: 3}")), "V(1 s)")
