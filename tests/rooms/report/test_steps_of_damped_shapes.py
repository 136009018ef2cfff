"""Shapes of damped modes as worked solutions tell them, held against the eigenvectors of NumPy."""

import cmath
import re

import numpy as np
import pytest
from support.scenes import problem
from support.worked_lines import Checked

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

SCENE = """
parameters: {m: 2 kg, k: 300 N/m, c: 6 N*s/m}
bodies: {a: {mass: m, slide: x1}, b: {mass: 2*m, slide: x2}, d: {mass: m, slide: x3}}
springs: {p: {k: k, between: [ground, a]}, q: {k: 2*k, between: [a, b]}, r: {k: k, between: [b, d]}}
dampers: {e: {c: c, between: [ground, a]}}
answers: {"abs(mode_d[1,x2])": 1, "re(mode_d[1,x2])": 1, "im(mode_d[2,x2])": 1, "arg(mode_d[2, x2])": 1%s}
"""
THREE = SCENE % ', "abs(mode_d[3,x3])": 1, "arg(mode_d[1,x3])": 1'
TWO = (SCENE % "").replace(", d: {mass: m, slide: x3}", "").replace(", r: {k: k, between: [b, d]}", "")
PARTS = {"abs": abs, "arg": cmath.phase, "re": lambda x: x.real, "im": lambda x: x.imag}


def shapes(n):
    """[(λ, [1, x₂/x₁ …])] of the pairs above the real axis, by |λ|."""
    M = np.diag([2.0, 4, 2][:n])
    K = np.array([[900.0, -600, 0], [-600, 900, -300], [0, -300, 300]])
    K[1, 1] = 900 if n == 3 else 600
    K, C = K[:n, :n], np.diag([6.0, 0, 0][:n])
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    roots, vectors = np.linalg.eig(A)
    found = [(root, vectors[:n, i] / vectors[0, i]) for i, root in enumerate(roots) if root.imag > 0]
    return sorted(found, key=lambda one: abs(one[0]))


@pytest.mark.parametrize(("text", "n"), [(TWO, 2), (THREE, 3)])
def test_shapes_of_damped_modes(text, n):
    scene, wanted = problem(text), shapes(n)
    lines = worked(scene)
    known = {**scene.numeric.floats, **{line.letter: line.value for line in lines if line.letter and line.value}}
    asked = [line for line in lines if "(mode_d[" in line.settles]
    assert len(asked) == len(scene.spec.answers) and not Checked(scene, lines).wrong
    for line in asked:
        part, _, place = line.settles.partition("(mode_d[")
        k, i = int(place[0]), int(place.rstrip("])")[-1]) - 1
        value = PARTS[part](complex(wanted[k - 1][1][i]))
        assert line.value == pytest.approx(value, rel=1e-9)
        assert evaluate([line.node], Floats, known)[0] == pytest.approx(value, rel=1e-9)
    together = [line for line in lines if re.match("u[23]_(re|im)", line.letter)]
    for line in together:
        off = {**known, **{one.letter: one.value * (1 + 0.01 * i) for i, one in enumerate(together, 1)}}
        here, beside = (abs(evaluate([line.vanishes], Floats, values)[0]) for values in (known, off))
        assert here < 1e-9 * beside
    assert len(together) == (12 if n == 3 else 0)


def test_a_shape_by_a_row_and_how_much_it_is_ahead():
    of = {line.settles: formula(line.parts, plain).replace("\u00a0", " ") for line in worked(problem(TWO))}
    root, (_, ratio) = shapes(2)[0]
    assert of["mode_d[1]"].startswith("damped mode 1, of  λ = −") and f"{root.imag:.6g}·i 1/s:  from row " in of[
        "mode_d[1]"]
    assert "x₂/x₁ = " in of["mode_d[1]"] and f",  |x₂/x₁| = {abs(ratio):.6g},  x₂ is  " in of["mode_d[1]"]
    assert of["mode_d[1]"].endswith(" rad ahead" if cmath.phase(ratio) > 0 else " rad behind")


def test_shapes_that_nothing_asks_are_left_out():
    without = TWO[:TWO.index("answers")]
    assert not any(line.settles.startswith("mode_d[") for line in worked(problem(without)))
