"""Numbers put into what lines tell by letters, and forms that stand before they are simplified."""

import math
import re

import numpy as np
import pytest
from support.scenes import problem

import vibcli
from vibcli.notation.latex import latex
from vibcli.notation.plain import plain
from vibcli.report.blocks import Quotient
from vibcli.report.formats.formula import formula
from vibcli.report.steps.sides import by_sides
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

FUNCTIONS = {name: getattr(math, name) for name in ("exp", "sin", "cos", "sqrt")}


def oscillator(c="8 N*s/m", start="x: 0.03 m, x': -2 m/s", k="800 N/m"):
    return "\n".join([
        f"parameters: {{m: 2 kg, k: {k}{f', c: {c}' if c else ''}}}",
        "bodies: {b: {mass: m, slide: x}}", "springs: {s: {k: k, between: [ground, b]}}",
        *(["dampers: {d: {c: c, between: [ground, b]}}"] if c else []), f"initial: {{{start}}}", ""])


def told(line):
    return formula(line.parts, plain).replace("\u00a0", " ")


def lines_of(text):
    return {line.settles: line for line in worked(problem(text))}


def as_python(text):
    return re.sub(r"√(\d+)", r"sqrt(\1)", text.replace("·", "*").replace("−", "-").replace("√(", "sqrt(").replace(
        "sin t", "sin(t)").replace("cos t", "cos(t)").replace("²", "**2"))


@pytest.mark.parametrize("start", ["x: 0.03 m, x': -2 m/s", "x': 4 m/s", "x: -5 cm"])
@pytest.mark.parametrize(("c", "k"), [("", "800 N/m"), ("", "2 N/m"), ("8 N*s/m", "800 N/m"), ("4 N*s/m", "50 N/m"),
                                      ("80 N*s/m", "800 N/m"), ("4 N*s/m", "2 N/m"), ("120 N*s/m", "800 N/m")])
def test_a_free_motion_ends_in_numbers(tmp_path, c, k, start):
    """What is printed, read as arithmetic, is the motion of the engine; no factor one, no term of zero."""
    text = oscillator(c, start, k)
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    line = told(lines_of(text)["motion of x"])
    printed = re.fullmatch(r"so  x = (.*)   \(in m\)", line)[1]
    assert not re.search(r"(?<![\d.])[01]·", printed)
    found = vibcli.load(path)
    for t in (0.0, 0.02, 0.11, 0.37):
        assert eval(as_python(printed), {**FUNCTIONS, "t": t}) == pytest.approx(
            found[f"x({t} s)"].value, rel=1e-4, abs=1e-7)


@pytest.mark.parametrize("text", [oscillator().replace("c: 8 N*s/m", "c: "), oscillator(start="x: 0 m")])
def test_no_numbers_are_put_in_where_there_are_none(text):
    assert "motion of x" not in lines_of(text)


@pytest.mark.parametrize("c", [0.4, 8.0, 60.0, 79.0, 79.99])
def test_the_damped_frequency_by_numbers_that_give_it(c):
    """√(ω² − δ²) of the numbers printed is ω_d to five digits, also near critical damping."""
    line = lines_of(oscillator(f"{c} N*s/m"))["omega_d[1]"]
    *_, put_in, value = told(line).removesuffix(" rad/s").split(" = ")
    assert line.value == pytest.approx(math.sqrt(400 - (c / 4)**2), rel=1e-9)
    assert float(value) == pytest.approx(line.value, rel=1e-5)
    assert eval(as_python(put_in), FUNCTIONS) == pytest.approx(line.value, rel=1e-5)
    assert ("4·m·k" in told(line)) == (c >= 79)


def test_a_quotient_stands_before_it_is_simplified():
    scene = problem(oscillator())
    m, k = (scene.scene.parameters.nodes[name] for name in "mk")
    for above, below, text, typeset in (
            (m * k, m / 3, "m·k/(m/3)", r"\frac{m \, k}{\frac{m}{3}}"), (m + k, m, "(m + k)/m", r"\frac{m + k}{m}"),
            (k / 2, m + k, "(k/2)/(m + k)", r"\frac{\frac{k}{2}}{m + k}")):
        assert formula([Quotient(above, below)], plain) == text
        assert formula([Quotient(above, below)], latex) == typeset
    rolling = "\n".join([
        "parameters: {m: 2 kg, k: 600 N/m, r: 0.1 m}", "surfaces: {floor: {line: [[-1 m, 0 m], [1 m, 0 m]]}}",
        "bodies: {disc: {shape: disc, mass: m, radius: r, at: [0 m, r], roll: {surface: floor, travel: x}}}",
        "springs: {s: {k: k, between: [[-1 m, r], disc]}}"])
    assert told(lines_of(rolling)["omega[1]"]).startswith("ω² = k/(3·m/2) = 2·k/(3·m),  ω = ")
    assert told(lines_of(oscillator())["omega[1]"]).startswith("ω² = k/m,  ω = ")


def beam(fixed, tip="[L, 0]"):
    return "\n".join([
        "parameters: {m: 3 kg, L: 0.8 m, h: 0.3 m, k: 1.2 kN/m}", f"points: {{B: {{body: rod, at: {tip}}}}}",
        f"bodies: {{rod: {{shape: rod, mass: m, from: [0, 0], to: {tip}, pin: {{at: [0, 0], by: phi}}}}}}",
        f"springs: {{s: {{k: k, between: [{fixed}, B]}}}}"])


@pytest.mark.parametrize(("text", "sides"), [(beam("[L, -h]"), True), (beam("[2*L, h]"), True),
                                             (beam("[0, -(L + h)]", "[0, -L]"), False)])
def test_a_stretch_by_the_sides_of_a_triangle(text, sides):
    """√((L sin φ + h)² + (L cos φ − L)²) − h is the stretch at any angle; the law of cosines stays where it is
    shorter."""
    scene = problem(text)
    about, (spring,) = AboutRest(scene, scene.scene.drawn_position, {}), scene.scene.springs
    plainly = about.shifted(spring.s)
    found = by_sides(about, spring.s, plainly)
    assert (")²" in formula([found], plain)) == sides
    values = {**scene.numeric.floats, "phi": 0.7}
    assert evaluate([found], Floats, values)[0] == pytest.approx(evaluate([plainly], Floats, values)[0], rel=1e-13)


CHAIN = "\n".join([
    "parameters: {m: 2 kg, k: 300 N/m}", "bodies: {a: {mass: m, slide: x}, b: {mass: 2*m, slide: y}%s}",
    "springs: {r: {k: 3*k, between: [ground, a]}, s: {k: k, between: [a, b]}%s}"])


@pytest.mark.parametrize("more", [("", ""), (", c: {mass: 3*m, slide: z}", ", t: {k: 2*k, between: [b, c]}"),
                                  (", c: {mass: 3*m, slide: z}", ", t: {k: 2*k, between: [b, c]}, "
                                   "u: {k: 5*k, between: [a, c]}")])
def test_the_determinant_is_written_out_by_its_entries(more):
    """By them, by its powers and by numpy it is one number at any ω."""
    scene = problem(CHAIN % more)
    lines = {line.settles: line for line in worked(scene)}
    parts = lines["det(K - omega^2*M)"].parts
    written, powers = (part for part in parts if hasattr(part, "op") and part.op in ("sum", "product")
                       and len(part.parts) > 1)
    n, (of_M, _, _, of_K) = len(scene.scene.q), scene.configuration.linear_system.matrices()
    M, K = (np.array([[of.get((i, j), 0.0) for j in range(n)] for i in range(n)]) for of in (of_M, of_K))
    coefficients = {name: line.value for name, line in lines.items() if name[0] == "a"}
    for omega in (3.0, 11.0, 40.0):
        known, sign = {**scene.numeric.floats, "omega": omega, **coefficients}, -1 if n == 3 else 1
        expected = np.linalg.det(K - omega**2 * M)
        assert evaluate([written], Floats, known)[0] == pytest.approx(expected, rel=1e-9)
        assert sign * evaluate([powers], Floats, known)[0] == pytest.approx(expected, rel=1e-6)
    assert ("−(a₃" in told(lines["det(K - omega^2*M)"])) == (n == 3)
