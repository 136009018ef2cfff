"""Values and extremes of motions that worked solutions tell as the sum of modes, beside what loads keep up: held
against the matrix exponential."""

import numpy as np
import pytest
from scipy.linalg import expm
from support.scenes import problem

from vibcli.notation.as_printed import as_printed
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

SCENE = """
parameters: {{m: 2 kg, n: 1 kg, k: 300 N/m, h: 200 N/m, F: {F} N, w: 7 rad/s, t1: 0.4 s}}
bodies: {{a: {{mass: m, slide: x}}, b: {{mass: n, slide: y}}}}
springs: {{r: {{k: k, between: [ground, a]}}, s: {{k: h, between: [a, b]}}}}
{damper}
forces: {{f: {{at: b, force: F*sin(w*t)}}}}
initial: {{x: 1 cm, y': -0.2 m/s}}
answers: {{x(t1): 0 m, s.force(t1): 0 N, x'(t1): 0 m/s, max(y): 0 m, argmax(y): 0 s}}
"""
DAMPER = "dampers: {{d: {{c: {c} N*s/m, between: [ground, a]}}}}"


def state(t, c, F):
    """[x, y, ẋ, ẏ] of 2 ẍ + c ẋ + 500 x − 200 y = 0, ÿ − 200 x + 200 y = F sin 7t, with the load as an oscillator."""
    A = np.zeros((6, 6))
    A[0, 2] = A[1, 3] = A[4, 5] = 1
    A[2, :3] = [-250, 100, -c / 2]
    A[3, :2], A[3, 4] = [200, -200], F
    A[5, 4] = -49
    return expm(A * t) @ [0.01, 0, 0, -0.2, 0, 7]


@pytest.mark.parametrize(("c", "F"), [(6, 0), (0, 0), (6, 5), (0, 5)])
def test_values_and_extremes_of_sums_of_modes(c, F):
    of = {line.settles: line for line in worked(problem(SCENE.format(F=F, damper=DAMPER.format(c=c) * bool(c))))}
    x, y, speed, _, *_ = state(0.4, c, F)
    wanted = {"x(t1)": x, "s.force(t1)": 200 * (y - x), "x'(t1)": speed}
    for asked, value in wanted.items():
        assert of[asked].node is not None and of[asked].value == pytest.approx(value, rel=1e-9)
    at = of["argmax(y)"].value
    assert of["max(y)"].value == pytest.approx(state(at, c, F)[1], rel=1e-9)
    assert abs(state(at, c, F)[3]) < 1e-6
    told = formula(of["x(t1)"].parts, plain)
    assert not any(letter in told for letter in ("A₁", "B₁", "A1", "B1")) and ("exp(" in told) == bool(c)
    searched = next(line for line in of.values() if line.settles.startswith("turning back at"))
    assert searched.vanishes is not None and "(by a search)" in formula(searched.parts, plain)


def test_an_envelope_of_two_modes_in_numbers():
    """Of equal pendulums: the largest of √(A₁² + A₂² + 2 A₁A₂ cos Δω t)."""
    of = {line.settles: line for line in worked(problem("""
        parameters: {m: 2 kg, k: 300 N/m, h: 20 N/m}
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
        springs: {r: {k: k, between: [ground, a]}, s: {k: h, between: [a, b]}, t: {k: k, between: [b, ground]}}
        initial: {x: 1 cm}
        answers: {envelope(x)(0.5 s): 0 m, max(envelope(y)): 0 m}
        """))}
    slow = np.sqrt(170) - np.sqrt(150)
    assert of["envelope(x)(0.5 s)"].node is not None
    assert of["envelope(x)(0.5 s)"].value == pytest.approx(0.01 * abs(np.cos(slow * 0.25)), rel=1e-9)
    assert of["max(envelope(y))"].node is not None and of["max(envelope(y))"].value == pytest.approx(0.01, rel=1e-9)


@pytest.mark.sweep
@pytest.mark.parametrize(("signal", "zero"), [("exp(x/(1 m))", "0"), ("x*x'", "0 m^2/s"), ("2*x + y", "0 m")])
def test_rates_of_expressions_are_told_as_they_are_written(signal, zero):
    """Those of functions ended as an error of its own."""
    text = SCENE.format(F=5, damper="").replace("max(y): 0 m, argmax(y): 0 s", f"max({signal}): {zero}")
    told = [formula(line.parts, plain) for line in worked(problem(text))]
    assert any(f"the rate of {as_printed(signal)} = 0" in line for line in told)
