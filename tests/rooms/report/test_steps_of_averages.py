"""Means and root mean squares of steady motions as worked solutions tell them, held against means over a period that
are added up here."""

import numpy as np
import pytest
from support.scenes import problem
from support.worked_lines import Checked

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

ONE = """
parameters: {m: , k: , c: , F: , w: }
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {d: {c: c, between: [ground, b]}}
forces: {f: {at: b, force: F*sin(w*t)}}
answers: {mean(f.power): 0 W, rms(x): 0 m, "mean(x^4)": 0 m^4, "mean(s.force*x')": 0 W, mean(T) - mean(s.energy): 0 J,
          "rms(x'')": 0 m/s^2, "mean(f.force*x)": 0 J}
"""
TWO = """
parameters: {m: 2 kg, n: 1 kg, k: 300 N/m, h: 200 N/m, F: 5 N, c: 7 N*s/m, w: 7 rad/s}
bodies: {a: {mass: m, slide: x}, b: {mass: n, slide: y}}
springs: {r: {k: k, between: [ground, a]}, s: {k: h, between: [a, b]}}
dampers: {d: {c: c, between: [ground, a]}}
forces: {f: {at: a, force: F*WAVE(w*t)}}
answers: {rms(x): 0 m, "rms(y'')": 0 m/s^2, "mean(s.force*y')": 0 W, mean(f.power): 0 W, mean(d.power): 0 W,
          rms(s.force): 0 N, mean(T): 0 J, "mean(x*y)": 0 m^2, "mean(x^2*y^2)": 0 m^4}
"""
VALUES = {"m": "2 kg", "k": "800 N/m", "c": "9 N*s/m", "F": "3 N", "w": "7 rad/s"}


def told(text):
    scene = problem(text)
    lines = worked(scene)
    assert not Checked(scene, lines).wrong
    return {line.settles: line for line in lines}


def shown(line):
    return formula(line.parts, plain).replace("\u00a0", " ")


def test_means_in_letters():
    of = told(ONE)
    wanted = {"mean(f.power)": "c·w²·X²/2", "rms(x)": "√2·X/2", "mean(x^4)": "3·X⁴/8",
              "rms(x'')": "√2·w²·X/2", "mean(f.force*x)": "X²·(k − m·w²)/2",
              "mean(T) - mean(s.energy)": "X²·(m·w² − k)/4"}
    for asked, node in wanted.items():
        assert shown(of[asked]).split(":  ")[1] == node
    assert shown(of["mean(s.force*x')"]) == "mean(s.force·ẋ) = 0"


def test_the_same_in_numbers():
    text = ONE
    for name, value in VALUES.items():
        text = text.replace(f"{name}: ,", f"{name}: {value},").replace(f"{name}: }}", f"{name}: {value}}}")
    of = told(text)
    H = 3 / (800 - 2 * 49 + 63j)
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 720, endpoint=False))
    x, v, f = ((part * turn).imag for part in (H, 7j * H, 3))
    for asked, values in {"mean(f.power)": f * v, "mean(x^4)": x**4, "mean(f.force*x)": f * x}.items():
        assert of[asked].value == pytest.approx(np.mean(values), rel=1e-9) and of[asked].node is not None
    assert of["mean(s.force*x')"].node is not None and shown(of["mean(s.force*x')"]).endswith("= 0 W")


@pytest.mark.sweep
@pytest.mark.parametrize("wave", ["sin", "cos"])
def test_means_of_two_degrees(wave):
    of = told(TWO.replace("WAVE", wave))
    Z = np.array([[500 - 98 + 49j, -200], [-200, 200 - 49]])
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 720, endpoint=False)) * (1 if wave == "sin" else 1j)
    X = np.linalg.solve(Z, [5, 0])
    (x, y), (u, v) = (np.outer(part, turn).imag for part in (X, 7j * X))
    f = (5 * turn).imag
    wanted = {"rms(x)": x**2, "rms(y'')": (49 * y)**2, "mean(f.power)": f * u, "mean(d.power)": 7 * u**2,
              "rms(s.force)": (200 * (y - x))**2, "mean(T)": u**2 + v**2 / 2, "mean(x*y)": x * y,
              "mean(x^2*y^2)": (x * y)**2}
    for asked, values in wanted.items():
        value = np.mean(values) ** (0.5 if asked.startswith("rms") else 1)
        assert of[asked].node is not None and of[asked].value == pytest.approx(value, rel=1e-9)
    assert shown(of["rms(x)"]).startswith("rms(x):  with the real part a and the imaginary part b of each X:  ")
    assert shown(of["mean(s.force*y')"]).endswith("mean(s.force·ẏ) = 0 W")


@pytest.mark.parametrize("values", [True, False])
def test_two_harmonics_and_periods(values):
    text = ONE[:ONE.index("forces")] + """forces: {f: {at: b, force: F*sin(w*t) + F*sin(2*w*t)}}
answers: {rms(x): 0 m, "mean(x'^2)": 0 m^2/s^2, period(x): 0 s}"""
    for name, value in VALUES.items() if values else ():
        text = text.replace(f"{name}: ,", f"{name}: {value},").replace(f"{name}: }}", f"{name}: {value}}}")
    of = told(text)
    assert shown(of["rms(x)"]).startswith("rms(x):  √((X₁² + X₂²)/2)") and of["rms(x)"].node is not None
    assert shown(of["period(x)"]).startswith("period(x):  2·π/w") and of["mean(x'^2)"].node is not None
    if values:
        X = [abs(3 / (800 - 2 * rate**2 + 9j * rate)) for rate in (7, 14)]
        assert of["rms(x)"].value == pytest.approx(np.sqrt((X[0]**2 + X[1]**2) / 2), rel=1e-9)
        assert of["mean(x'^2)"].value == pytest.approx(((7 * X[0])**2 + (14 * X[1])**2) / 2, rel=1e-9)
