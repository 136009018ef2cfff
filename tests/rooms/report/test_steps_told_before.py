"""What answers ask that lines of worked solutions tell by another name."""

import math

import pytest
from support.scenes import problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

TWO = """
parameters: {m: MASS, k: STIFF, h: SOFT, c: DAMP}
bodies: {a: {mass: m, slide: x}, b: {mass: 2*m, slide: y}}
springs: {r: {k: k, between: [ground, a]}, s: {k: h, between: [a, b]}}
dampers: {d: {c: c, between: [ground, a]}}
answers: {"K[x,x]": 1 N/m, "K[x,y]": 1 N/m, "M[y,y]": 1 kg, "C[x,x]": 1 N*s/m, "M[x,y]": 0 kg, "period[1]": 1 s,
          "frequency[2]": 1 Hz}
"""
VALUES = {"MASS": "2 kg", "STIFF": "300 N/m", "SOFT": "200 N/m", "DAMP": "7 N*s/m"}
ONE = """
parameters: {m: 2 kg, k: 800 N/m, c: 100 N*s/m, g: 9.81 m/s^2}
gravity: g
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [[0, 1 m], b], preload: static}}
dampers: {d: {c: c, between: [[0, 1 m], b]}}
answers: {"eigenvalue[1,1]": -1 s^-1, "eigenvalue[1,2]": -1 s^-1, "equilibrium[s.force]": 0 N, "period[1]": 1 s}
"""


def told(text):
    return {line.settles: line for line in worked(problem(text))}


@pytest.mark.parametrize("values", [VALUES, dict.fromkeys(VALUES, "")])
def test_entries_of_matrices(values):
    text = TWO
    for name, value in values.items():
        text = text.replace(name, value)
    of = told(text)
    wanted = {"K[x,x]": ("K", "k + h", 500), "K[x,y]": ("K", "−h", -200), "M[y,y]": ("M", "2·m", 4),
              "C[x,x]": ("C", "c", 7), "M[x,y]": ("M", "0", 0)}
    for asked, (matrix, node, value) in wanted.items():
        line = of[asked]
        assert line.number == of[matrix].number and not line.parts and plain(line.node) == node
        assert line.value == (value if values["MASS"] else None) and line.unit == ("" if line.value is None else {
            "K": "N/m", "M": "kg", "C": "N·s/m"}[matrix])
    if values["MASS"]:
        assert of["period[1]"].value == pytest.approx(2 * math.pi / of["omega[1]"].value, rel=1e-12)
        assert of["frequency[2]"].value == pytest.approx(of["omega[2]"].value / 2 / math.pi, rel=1e-12)
        assert not of["period[1]"].parts and not of["frequency[2]"].parts
    else:       # no line tells T; by hand 2m²ω⁴ − m(2k + 3h)ω² + kh = 0
        assert formula(of["period[1]"].parts, plain) == "period[1]:  4·π·√(m/(2·k + 3·h − √(4·k·(k + h) + 9·h²)))"


def test_roots_and_forces_at_rest():
    """By hand: λ² + 50λ + 400 = 0."""
    of = told(ONE)
    for asked, value in (("eigenvalue[1,1]", -10), ("eigenvalue[1,2]", -40)):
        assert of[asked].value == pytest.approx(value, rel=1e-12) and of[asked].unit == "1/s"
        assert "√(δ² − ω²)" in formula(of[asked].parts, plain)
    assert of["equilibrium[s.force]"].value == pytest.approx(19.62, rel=1e-12)
    assert of["period[1]"].node is not None and of["period[1]"].value == pytest.approx(math.pi / 10, rel=1e-12)
