"""Steady states of several degrees of freedom, read back line by line with complex arithmetic and held against the
engine."""

import cmath
import math
import re
from itertools import pairwise

import numpy as np
import pytest
from support.scenes import problem

import vibcli
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps import steady_states
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

ROW = """
parameters: {m: 2 kg, k: 300 N/m, c: 6 N*s/m, F: 5 N, w: 9 rad/s, u: 14 rad/s}
bodies: {a: {mass: m, slide: x1}, b: {mass: 2*m, slide: x2}, d: {mass: m, slide: x3}}
springs: {p: {k: k, between: [ground, a]}, q: {k: 2*k, between: [a, b]}, r: {k: k, between: [b, d]}}
"""
TWO = re.sub(r", d: .*?}}", "}", ROW).replace(", r: {k: k, between: [b, d]}", "")
DAMPED = "dampers: {e: {c: c, between: [ground, a]}}\n"
GROWING = TWO.replace("F: 5 N, w: 9 rad/s, u: 14 rad/s", "F: 5 N/s")
UNIT = re.compile(r" (m|rad|N|N/m|kg\S*)(?:,|$).*")
SIGNS = {"−": "-", "·": "*", "²": "**2", "₁": "1", "₂": "2", "₃": "3", "\u00a0": " "}


def used(text):
    """The scene without the parameters that it does not use."""
    head, body = text.partition("\nbodies")[::2]
    names = re.findall(r"(\w+): [^,}]*", head.partition("{")[2])
    for name in names:
        if not re.search(rf"(?<![\w.]){name}(?![\w:])", body):
            head = re.sub(rf"(, )?\b{name}: [^,}}]*", "", head)
    return head.replace("{, ", "{") + "\nbodies" + body


def told(lines):
    return [formula(line.parts, plain) for line in lines]


def read(text, known):
    """The complex number of an expression as it is printed."""
    for sign, other in SIGNS.items():
        text = text.replace(sign, other)
    return complex(eval(re.sub(r"\bi\b", "1j", text), {"__builtins__": {}}, known))


def followed(lines, known):
    """{letter: complex number} of Z, F, D and X, each by the letters of the lines before; where a number is printed
    beside, that is held against it."""
    at = next(i for i, line in enumerate(lines) if line.settles == "steady state")
    for line in lines[at + 1:]:
        if line.settles.startswith("phase(") or not line.parts:
            continue
        text = formula(line.parts, plain).partition(",  |")[0].replace("its determinant", "")
        letter, *sides = [side.strip() for side in (text.partition(":  ")[2] or text).split(" = ")]
        sides = [side for side in sides if not re.fullmatch(r"Z₂₁|Z₃₁|Z₃₂", side)]
        name = letter.strip().translate({ord(one): other for one, other in SIGNS.items()}).split()[-1]
        value = read(UNIT.sub("", sides[0]), known)
        for side in sides[1:]:
            assert cmath.isclose(value, read(UNIT.sub("", side), known), rel_tol=2e-5, abs_tol=1e-9), text
        known = {**known, name: value}
    return known


@pytest.mark.sweep
@pytest.mark.parametrize("scene", [TWO, ROW], ids=["two", "three"])
@pytest.mark.parametrize("damped", [True, False], ids=["damped", "undamped"])
@pytest.mark.parametrize("load", ["F*sin(w*t)", "2*F*cos(w*t)", "F*sin(w*t) - 3*F*cos(w*t)"])
def test_the_lines_followed_by_hand_are_the_steady_state(tmp_path, scene, damped, load):
    text = used(scene + DAMPED * damped + f"forces: {{f: {{at: a, force: {load}}}}}\n")
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    p = vibcli.load(path)
    lines = worked(p._problem)
    known = followed(lines, dict(p._problem.numeric.floats))
    wave = "cos" if "cos" in load and "sin" not in load else "sin"
    of = {line.settles: line for line in lines}
    names = p._problem.scene.coordinates
    for k, name in enumerate(names, 1):
        X = known[f"X{k}"]
        assert abs(X) == pytest.approx(p[f"amplitude({name})"].value, rel=1e-9)
        assert of[f"amplitude({name})"].value == pytest.approx(abs(X), rel=1e-9)
        lag = p[f"phase({name})"].value + (math.pi / 2 if wave == "cos" else 0)
        assert cmath.isclose(X / abs(X), cmath.exp(-1j * lag), abs_tol=1e-8)
    if damped and wave == "sin":
        assert all(of[f"phase({name})"].value == pytest.approx(p[f"phase({name})"].value, abs=1e-8) for name in names)


def test_two_frequencies_have_each_their_amplitudes(tmp_path):
    text = used(TWO + DAMPED + "forces: {f: {at: a, force: F*sin(w*t)}, g: {at: b, force: 3*F*cos(u*t)}}\n")
    of = {line.settles: line.value for line in worked(problem(text))}
    for order, Omega, load in ((1, 9, (5, 0)), (2, 14, (0, 15))):
        Z = [[900 - 2 * Omega**2 + 6j * Omega, -600], [-600, 600 - 4 * Omega**2]]
        D = Z[0][0] * Z[1][1] - Z[0][1] * Z[1][0]
        X = [(Z[1][1] * load[0] - Z[0][1] * load[1]) / D, (Z[0][0] * load[1] - Z[1][0] * load[0]) / D]
        for name, value in zip(("x1", "x2"), X, strict=True):
            assert of[f"amplitude {order} of {name}"] == pytest.approx(abs(value), rel=1e-12)


def test_loads_of_one_frequency_out_of_phase_are_one():
    text = used(TWO + DAMPED + "forces: {f: {at: a, force: F*sin(w*t + 0.7)}, g: {at: b, force: 2*F*cos(w*t)}}\n")
    of = {line.settles: line.value for line in worked(problem(text))}
    Z = [[900 - 2 * 81 + 54j, -600], [-600, 600 - 4 * 81]]
    X = np.linalg.solve(Z, [5 * cmath.exp(0.7j), 10j])
    assert [of["amplitude(x1)"], of["amplitude(x2)"]] == pytest.approx(abs(X), rel=1e-12)


CAR = """
parameters: {m: 1200 kg, J: 1800 kg*m^2, k: 30 kN/m, c: 1.5 kN*s/m, Y: 3 cm, W: 16 rad/s}
points:
  rear: {at: [-1 m, 0], moves: [0, Y*sin(W*t - 2)]}
  front: {at: [1.5 m, 0], moves: [0, Y*sin(W*t)]}
  A: {body: car, at: [-1 m, 0.5 m]}
  B: {body: car, at: [1.5 m, 0.5 m]}
bodies: {car: {mass: m, inertia: J, at: [0, 0.5 m], move: [0, y, phi]}}
springs: {s1: {k: k, between: [rear, A]}, s2: {k: k, between: [front, B]}}
dampers: {d1: {c: c, between: [rear, A]}, d2: {c: c, between: [front, B]}}
"""


@pytest.mark.sweep
def test_supports_that_are_not_where_they_are_drawn_at_first_are_told_to_the_first_order():
    """The springs are undeformed where the supports are drawn, not where these are at t = 0."""
    lines = worked(problem(CAR))
    assert max(map(len, told(lines))) < 400
    assert any("from rest" in line for line in told(lines))
    of = {line.settles: line.value for line in lines}
    Z, under = np.diag([1200.0, 1800.0]) * -256, np.zeros(2, complex)
    for x, road in ((-1.0, cmath.exp(-2j)), (1.5, 1.0)):
        row, leg = np.array([1.0, x]), 30000 + 1500 * 16j
        Z, under = Z + leg * np.outer(row, row), under + leg * 0.03 * road * row
    X = np.linalg.solve(Z, under)
    assert [of["amplitude(y)"], of["amplitude(phi)"]] == pytest.approx(abs(X), rel=1e-9)


def test_in_letters_by_cramers_rule():
    head, body = TWO.partition("\nbodies")[::2]
    text = re.sub(r": [\d.]+ [^,}]*", ": ", head) + "\nbodies" + body + "forces: {f: {at: a, force: F*sin(w*t)}}\n"
    lines = told(worked(problem(used(text))))
    assert any("X₁ = Z₂₂·F₁/D = F·(2·k − 2·m·w²)/" in line for line in lines), lines
    assert any("X₂ = −Z₁₂·F₁/D = 2·k·F/" in line for line in lines), lines


def test_more_than_three_are_solved_in_numbers():
    names = "abde"
    bodies = ", ".join(f"{one}: {{mass: m, slide: x{one}}}" for one in names)
    springs = ", ".join(f"s{one}: {{k: k, between: [{one}, {other}]}}" for one, other in pairwise(["ground", *names]))
    text = ("parameters: {m: 1 kg, k: 90 N/m, F: 2 N, w: 5 rad/s}\n" f"bodies: {{{bodies}}}\nsprings: {{{springs}}}\n"
            "forces: {f: {at: e, force: F*sin(w*t)}}\n")
    lines = worked(problem(text))
    of = {line.settles: line.value for line in lines}
    q = [0.0, 1.0]
    for k in range(4):                                  # along the chain: k q₋ − (2k − mw²) q + k q₊ = −F of the last
        right = 180 - 25 if k < 3 else 90 - 25
        q.append((right * q[-1] - 90 * q[-2]) / 90)
    scale = 2 / (90 * q[5])
    for k, one in enumerate(names):
        assert of[f"amplitude(x{one})"] == pytest.approx(abs(scale * q[k + 1]), rel=1e-12)
    assert not any("its determinant" in line for line in told(lines))


def test_what_follows_growing_loads_solves_the_equations():
    """m₁ẍ₁ + 3k x₁ − 2k x₂ = Ft, 2m ẍ₂ − 2k x₁ + 2k x₂ = 0: both follow by Ft/k."""
    lines = told(worked(problem(used(GROWING + "forces: {f: {at: a, force: F*t}}\n"))))
    assert any(line.endswith("x1 = F·t/k".replace("x1", "x₁")) for line in lines), lines[-3:]
    assert any(line.endswith("x2 = F·t/k".replace("x2", "x₂")) for line in lines)


def test_a_coordinate_of_another_number_is_told_with_its_row():
    text = used(TWO.replace("x1", "y").replace("x2", "x1") + "forces: {f: {at: a, force: F*sin(w*t)}}\n")
    lines = told(worked(problem(text)))
    assert any(line.startswith("of the second coordinate, x₁:  X₂ = ") for line in lines), lines[-2:]


def test_amplitudes_that_the_engine_has_not_are_not_told(monkeypatch):
    """A fault in the dynamic stiffness leaves the steady state out."""
    text = used(TWO + DAMPED + "forces: {f: {at: a, force: F*sin(w*t)}}\n")
    assert any(line.settles == "steady state" for line in worked(problem(text)))
    whole = steady_states.SteadyState.entry
    monkeypatch.setattr(steady_states.SteadyState, "entry", lambda self, i, j: (
        whole(self, i, j)[0] * 2, whole(self, i, j)[1]))
    assert not any(line.settles == "steady state" for line in worked(problem(text)))


ROAD = """
points:
  F: {body: car, at: [a, 0]}
  R: {body: car, at: [-b, 0]}
  front: {at: [a, -0.5 m], moves: [0, h*sin(2*pi*v*t/W)]}
  rear: {at: [-b, -0.5 m], moves: [0, h*sin(2*pi*(v*t - a - b)/W)]}
bodies: {car: {mass: m, gyration: i, at: [0, 0], move: [0, y, phi]}}
springs: {s1: {k: k1, between: [front, F]}, s2: {k: k2, between: [rear, R]}}
dampers: {d1: {c: c1, between: [front, F]}, d2: {c: c2, between: [rear, R]}}
"""
AXLES = {"m": (1200, "kg"), "i": (1.2, "m"), "a": (1.2, "m"), "b": (1.4, "m"), "k1": (40e3, "N/m"), "k2": (36e3, "N/m"),
         "c1": (2e3, "kg/s"), "c2": (2e3, "kg/s"), "h": (0.02, "m"), "W": (5, "m"), "v": (20, "m/s")}


@pytest.mark.sweep
def test_axles_that_lag_are_loads_of_one_frequency():
    """Held against the complex equations, put up by hand with a phase of the rear axle."""
    m, i, a, b, k1, k2, c1, c2, h, W, v = (value for value, _ in AXLES.values())
    given = ", ".join(f"{name}: {value:g} {unit}" for name, (value, unit) in AXLES.items())
    lines = worked(problem(f"{ROAD}parameters: {{{given}}}"))
    w = 2 * math.pi * v / W
    front, rear = k1 + 1j * w * c1, k2 + 1j * w * c2
    lag = cmath.exp(-2j * math.pi * (a + b) / W)
    Z = [[front + rear - m * w**2, a * front - b * rear], [a * front - b * rear,
                                                           a**2 * front + b**2 * rear - m * i**2 * w**2]]
    F = h * (front + rear * lag), h * (a * front - b * rear * lag)
    D = Z[0][0] * Z[1][1] - Z[0][1] * Z[1][0]
    X = (F[0] * Z[1][1] - F[1] * Z[0][1]) / D, (F[1] * Z[0][0] - F[0] * Z[1][0]) / D
    values = {line.settles: line.value for line in lines}
    assert values["amplitude(y)"] == pytest.approx(abs(X[0]), rel=1e-9)
    assert values["amplitude(phi)"] == pytest.approx(abs(X[1]), rel=1e-9)
    assert values["phase(y)"] == pytest.approx(-cmath.phase(X[0]), rel=1e-9)


@pytest.mark.sweep
def test_lines_in_letters_say_something_of_each_frequency():
    """Axles that lag are told once, a further frequency by its right sides; no line ends with a colon."""
    letters = ", ".join(f"{name}: {{unit: {unit}}}" for name, (_, unit) in AXLES.items())
    of_two = "{m: {unit: kg}, k: {unit: N/m}, F: {unit: N}, w: {unit: rad/s}, u: {unit: rad/s}}"
    forced = re.sub("parameters: .*", f"parameters: {of_two}", TWO) + (
        "forces: {f: {at: a, force: F*sin(w*t) + F*sin(u*t)}}\n")
    for text, often in ((f"{ROAD}parameters: {{{letters}}}", 0), (forced, 1)):
        found = told(worked(problem(text)))
        assert sum("likewise" in line for line in found) == often
        assert sum("solved as any linear equations" in line for line in found) == often
        assert any("steady state" in line for line in found)
        assert not any(line.rstrip().endswith(":") for line in found)


THREE = """
parameters: {m: %s, k: %s, c: %s, F: %s, w: %s}
bodies: {a: {mass: m, slide: x1}, b: {mass: 2*m, slide: x2}, d: {mass: m, slide: x3}}
springs: {p: {k: k, between: [ground, a]}, q: {k: 2*k, between: [a, b]}, r: {k: k, between: [b, d]}}
dampers: {e: {c: c, between: [ground, a]}}
forces: {f: {at: a, force: F*sin(w*t)}}
answers: {phase(x3): 0, phase(r.force): 0, amplitude(r.force): 0 N, "abs(frf[x2, f](w))": 0 m/N,
          "arg(frf[x3, f](2 Hz))": 0, "re(frf[x2, f](2 Hz))": 0 m/N}
"""


@pytest.mark.parametrize("values", [("2 kg", "300 N/m", "6 N*s/m", "5 N", "9 rad/s"), ("",) * 5])
def test_phases_and_frequency_responses_of_three_degrees_in_letters(values):
    scene = problem(THREE % values)
    lines = worked(scene)
    of = {line.settles: line for line in lines}
    assert all(of[answer.asked.text].node is not None for answer in scene.spec.answers)
    told_of = {asked: formula(line.parts, plain) for asked, line in of.items()}
    assert told_of["phase(r.force)"].startswith("phase(r.force):  the lag of  k·(X₂ − X₃)")
    assert told_of["abs(frf[x2, f](w))"].startswith("|frf[x₂, f](w)|:  |−Z₁₂·Z₃₃/D|")
    assert told_of["arg(frf[x3, f](2 Hz))"].endswith("Z₁₂′·Z₂₃′/D′" if not values[0] else " rad")
    assert sum("Z₁₁′ = " in text for text in told_of.values()) == 1     # of both responses at one frequency
    if values[0]:
        def Z(Omega):
            return np.array([[900 - 2 * Omega**2 + 6j * Omega, -600, 0], [-600, 900 - 4 * Omega**2, -300],
                             [0, -300, 300 - 2 * Omega**2]])

        X, H = np.linalg.solve(Z(9), [5, 0, 0]), np.linalg.solve(Z(4 * math.pi), [1, 0, 0])
        known = {**scene.numeric.floats, **{line.letter: line.value for line in lines if line.letter and line.value}}
        wanted = {"phase(x3)": -cmath.phase(X[2]), "amplitude(r.force)": abs(300 * (X[2] - X[1])),
                  "abs(frf[x2, f](w))": abs(X[1]) / 5, "arg(frf[x3, f](2 Hz))": cmath.phase(H[2]),
                  "re(frf[x2, f](2 Hz))": H[1].real}
        for asked, value in wanted.items():
            assert of[asked].value == pytest.approx(value, rel=1e-9)
            assert evaluate([of[asked].node], Floats, known)[0] == pytest.approx(value, rel=1e-9)
