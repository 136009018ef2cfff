"""Letters and units of worked solutions: no letter stands for two things, and numbers of matrices have units."""

import math
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

from vibcli.notation.plain import plain
from vibcli.quantities.letters import expression_in_letters
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked


def lines(text):
    return [formula(line.parts, plain) for line in worked(problem(text)) if line.parts]


def test_letters_that_are_printed_alike_are_one():
    """a_1 is a₁, K11 an entry of K."""
    told = lines("""
        parameters: {a_1: 2 kg, p_2: 1 kg, omega_1: 300 N/m, K11: 50 N/m}
        bodies: {one: {mass: a_1, slide: x}, two: {mass: p_2, slide: y}}
        springs: {s: {k: omega_1, between: [ground, one]}, t: {k: K11, between: [one, two]}}
        """)
    assert any(line.startswith("stiffness matrix:  S = [") for line in told)
    assert any(line.startswith("a₁′ = ") for line in told) and any(line.startswith("ω₁′ = ") for line in told)
    assert "x = p₁ + p₂′" in told[-1]


ROD = """
parameters: {{m: 3 kg, L: 0.8 m, k: 9 N/m}}
points: {{C: {{body: rod, at: [{at}, 0]}}, O: {{body: rod, at: [{at}, 0]}}}}
bodies: {{rod: {{shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {{at: [0, 0], by: phi}}}}}}
springs: {{s: {{k: k, between: [[L, -L], C]}}, t: {{k: k, between: [[L, L], O]}}}}
"""


def test_axis_and_centre_are_no_points_that_lie_elsewhere():
    assert any("fixed A, G at" in line for line in lines(ROD.format(at="L")))
    assert any("fixed A, C at" in line for line in lines(ROD.format(at="L/2")))


def test_a_start_with_a_speed_in_letters():
    """Of a mode that moves freely there is no sine."""
    told = lines("""
        parameters: {m: , n: , k: , v: {unit: m/s}}
        bodies: {a: {mass: m, slide: x}, b: {mass: n, slide: y}}
        springs: {s: {k: k, between: [a, b]}}
        initial: {x': v}
        """)
    assert told[-1] == "so  y = m·v·t/(m + n) − m·v·sin(ω₂·t)/(ω₂·(m + n))"
    told = lines("""
        parameters: {m: , k: , v: {unit: m/s}}
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
        springs: {r: {k: k, between: [ground, a]}, s: {k: k, between: [a, b]}, t: {k: k, between: [b, ground]}}
        initial: {x': v}
        """)
    assert told[-1] == "so  y = v·sin(ω₁·t)/(2·ω₁) − v·sin(ω₂·t)/(2·ω₂)"


def test_coefficients_and_entries_have_units():
    told = lines("""
        parameters: {m: 4 kg, J: 1 kg*m^2, k: 400 N/m, c: 9 N*s/m, L: 0.3 m, F: 3 N, w: 7 rad/s}
        bodies: {bar: {mass: m, inertia: J, at: [0, 0], move: [0, y, phi]}, b: {mass: 2 kg, slide: z}}
        points: {P: {body: bar, at: [L, 0]}, Q: {body: bar, at: [-L, 0]}}
        springs: {s: {k: k, between: [[L, -L], P]}, t: {k: k, between: [[-L, -L], Q]},
                  u: {k: k, between: [ground, b]}}
        dampers: {d: {c: c, between: [[L, -L], P]}}
        forces: {f: {at: P, force: [0, F*sin(w*t)]}}
        """)
    for unit in ("\u00a0kg·m², 0; 0, 0, 2\u00a0kg]", "a₃ = (2\u00a0kg)·m·J = 8 kg³·m²", " kg³·m²/s⁶",
                 "c₆ = (2\u00a0kg)·m·J = 8 kg³·m²", " kg³·m²/s⁵"):
        assert any(unit in line for line in told), unit
    assert any("Z₂₂ = " in line and line.endswith("·i N·m") for line in told)
    assert any(line.startswith("F₂ = L·F = 0.9 N·m") for line in told)


def test_shapes_of_coordinates_that_follow_others_are_in_letters():
    """Of gears, at rest as drawn, and turned by a moment."""
    scene = """
        parameters: {{J: , r: , R: , kt: , M: {{unit: N*m}}}}
        bodies: {{one: {{inertia: J, at: [0, 0], pin: {{by: phi}}}},
                  two: {{inertia: J, at: [r + R, 0], pin: {{by: psi}}}}}}
        springs: {{s: {{torsion: kt, between: [ground, one]}}}}
        constraints: {{teeth: {{gear: [one, two], radii: [r, R]}}}}
        forces: {{f: {{body: one, moment: {moment}}}}}
        answers: {{"mode[1][psi]": -r/R}}
        """
    for moment in ("0*M", "M"):
        found = problem(scene.format(moment=moment))
        assert formula([expression_in_letters(found, found.spec.answers[0].asked)], plain) == "−r/R"


def test_expressions_that_answers_of_a_scene_in_letters_ask_are_told():
    """With a number where the letters that are left have some: Thomson's trailer, whose mass cancels."""
    told = lines("""
        parameters: {m: , d: 100 mm, w: 16 m, g: 9.81 m/s^2}
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: m*g/d, between: [ground, b]}}
        answers: {"omega[1]*w/(2*pi)": 25.22 m/s, "omega[1]^2*m": m^2*g/(d*m)}
        """)
    assert told[-2].startswith("ω₁·w/(2·π):  ") and told[-2].endswith(" = 25.2217 m/s")
    assert told[-1] == "ω₁²·m:  m·g/d"


@pytest.mark.sweep
def test_a_number_beside_a_letter_keeps_its_unit_in_a_quotient():
    found = kept_problem_of(Path("problems/5_forced/shelter_under_a_blast.yaml"))
    square, = [line for line in worked(found) if line.settles == "omega[1]"]
    assert "(L² + 3.24\u00a0m²)" in formula(square.parts, plain).partition(",  ω")[0]


STEP = """
parameters: {{m: {values[0]}, k: {values[1]}, c: {values[2]}, F0: {values[3]}}}
bodies: {{block: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, block]}}}}
dampers: {{d: {{c: c, between: [ground, block]}}}}
forces: {{load: {{at: block, force: {load}}}}}
{start}
answers: {{max(x): 0 m, overshoot(x): 0, argmax(x): 0 s}}
"""
LETTERS, NUMBERS = ("", "", "", ""), ("2 kg", "200 N/m", "8 N*s/m", "10 N")
PEAK = 0.05 * (1 + math.exp(-math.pi * 2 / math.sqrt(96)))       # m: F₀/k (1 + e^{−πδ/ω_d})


@pytest.mark.parametrize(("load", "start", "rest", "amplitude"), [
    ("F0", "initial: {x: 0}", "F₀/k", " − A·"), ("F0*step(t)", "", "F₀/k", " + F₀·")])
def test_how_far_a_step_brings_it_is_told_in_letters(load, start, rest, amplitude):
    """And in numbers: where it turns back, the largest deflection, the overshoot, the instant."""
    told = lines(STEP.format(values=LETTERS, load=load, start=start))
    turns = next(i for i, line in enumerate(told) if line.endswith("zero first at  t = π/ω_d"))
    peak, over, at = (line.replace("\u00a0", " ") for line in told[turns + 1:turns + 4])
    assert peak.startswith(f"max(x):  {rest}{amplitude}exp(−π·δ/ω_d)")
    assert (over, at) == ("overshoot(x):  exp(−π·δ/ω_d)", "argmax(x):  π/ω_d")
    assert any("(under-damped, δ < ω)" in line for line in told)
    of = {line.settles: line for line in worked(problem(STEP.format(values=NUMBERS, load=load, start=start)))}
    assert of["max(x)"].value == pytest.approx(PEAK, rel=1e-12) and of["max(x)"].unit == "m"
    assert of["argmax(x)"].value == pytest.approx(math.pi / math.sqrt(96), rel=1e-9)


def test_where_it_turns_back_from_a_start_with_a_speed():
    """By the tangent of ω_d t, also where the peak is not the first root of that."""
    of = {line.settles: line for line in worked(problem(STEP.format(
        values=NUMBERS, load="0*F0", start="initial: {x: -1 cm, x': 0.3 m/s}")))}
    at, rate = of["t1"].value, math.sqrt(96)
    B = (0.3 - 0.01 * 2) / rate
    assert math.tan(rate * at) == pytest.approx((rate * B + 2 * 0.01) / (2 * B - rate * 0.01), rel=1e-6)
    wave = math.exp(-2 * at) * (B * math.sin(rate * at) - 0.01 * math.cos(rate * at))
    assert of["max(x)"].value == pytest.approx(wave, rel=1e-9) and wave > 0.01


def test_two_places_where_it_turns_back_have_two_letters():
    scene = STEP.format(values=NUMBERS, load="0*F0", start="initial: {x: 1 cm, x': -0.3 m/s}")
    told = {line.settles: line for line in worked(problem(scene.replace("overshoot(x): 0, argmax(x)", "argmin(x)")
                                                          .replace("max(x): 0 m", "max(x): 1 m, min(x): 1 m")))}
    assert 0 < told["t1"].value < told["t2"].value
    assert told["argmin(x)"].value == pytest.approx(told["t1"].value, rel=1e-12)
    assert "t₂" in formula(told["max(x)"].parts, plain) and "t₁" in formula(told["min(x)"].parts, plain)


def test_bodies_on_different_axes_have_each_its_letter():
    told = lines("""
        parameters: {m: 3 kg, L: 0.8 m, k: 9 N/m}
        points: {B: {body: rod, at: [L, 0]}, D: {body: bar, at: [3*L, L]}}
        bodies:
          rod: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}
          bar: {shape: rod, mass: m, from: [2*L, L], to: [3*L, L], pin: {at: [2*L, L], by: psi}}
          arm: {shape: rod, mass: m, from: [2*L, L], to: [2*L, 2*L], pin: {at: [2*L, L], by: chi}}
        springs: {s: {k: k, between: [B, D]}, t: {k: k, between: [B, [L, -L]]}}
        """)
    assert any("fixed O₁" in line and "J_O₁ = J_C + m·O₁C²" in line for line in told)
    assert any("bar turns about the fixed O₂" in line and "J_bar = J_C + m·O₂C²" in line for line in told)
    assert any("arm turns about the fixed O₂" in line and "J_arm = " in line for line in told)


TAUT = """
parameters: {{l: {}, k: {}, N: {}, m: 2 kg}}
bodies: {{b: {{mass: m, at: [0, 0], slide: {{along: [1, 0], by: x}}}}}}
springs: {{s: {{k: k, between: [[0, l], b], preload: N}}, t: {{k: k, between: [[0, -l], b], preload: N}}}}
answers: {{"stiffness_correction[s, x]": 0 N/m, "stiffness_correction[s, x^3]": 0 N/m^3}}
"""


@pytest.mark.parametrize("values", [("", "", ""), ("0.4 m", "900 N/m", "30 N")])
def test_what_the_geometry_of_a_spring_adds_is_told_in_letters(values):
    """N/l, and (k − N/l)/(2l²)."""
    told = " ".join(lines(TAUT.format(*values))).replace("\u00a0", " ")
    assert "stiffness_correction[s, x]:  N/l" in told and "stiffness_correction[s, x³]:  (l·k − N)/(2·l³)" in told
    assert ("= 75 N/m" in told and "= 2578.1" in told) == bool(values[0])


def test_the_greatest_stiffness_that_answers_ask_is_told_by_its_entries():
    told = lines("""
        parameters: {k1: 300 N/m, k2: 200 N/m, m: 2 kg}
        bodies: {b: {mass: m, at: [0, 0], move: [x, y]}}
        springs: {s: {k: k1, between: [[-1 m, 0], b]}, t: {k: k2, between: [[1 m, 1 m], b]}}
        answers: {"stiffness[b].max": 0 N/m}
        """)
    assert any(line.startswith("stiffness[b].xx:  k_xx = k₁ + k₂/2 = 400") for line in told)
    assert told[-1].startswith("stiffness[b].max:  k_xx/2 + k_yy/2 + √(((k_xx − k_yy)/2)² + k_xy²) = 430.278")
