"""A number beside letters has their unit: L + 0.5 m, in every notation that is read."""

from fractions import Fraction

import pytest
from support.scenes import problem

from vibcli.notation.latex import latex
from vibcli.notation.mathml import mathml
from vibcli.notation.plain import plain
from vibcli.notation.scene_language import language
from vibcli.notation.typst import typst

SCENE = """
parameters: {m: 2 kg, M: 3 kg, L: 0.8 m, J: 4 kg*m^2, k: 70 N/m}
bodies: {a: {mass: m + M, slide: x}, b: {inertia: J + m*L^2, turn: phi}}
springs: {s: {k: k, between: [ground, a]}, t: {torsion: k*L^2, between: [ground, b]}}
"""


@pytest.fixture(scope="module")
def scene():
    return problem(SCENE).scene


def letters(scene):
    return {**scene.parameters.nodes, **{q.name: q for q in scene.q}}


@pytest.mark.parametrize(("of", "text"), [
    (lambda s: s["L"] + Fraction(1, 2), "L + 0.5\u00a0m"), (lambda s: 2 * s["L"] + 1, "2·L + 1\u00a0m"),
    (lambda s: s["x"] - Fraction(3, 10), "x − 0.3\u00a0m"), (lambda s: s["L"] / 2 + Fraction(3, 2), "(L + 3\u00a0m)/2"),
    (lambda s: s["m"] * s["L"]**2 + Fraction(1, 2) * s["J"] + 3, "m·L² + J/2 + 3\u00a0kg·m²"),
    (lambda s: s["m"] / s["M"] + Fraction(1, 2), "m/M + 1/2"), (lambda s: s["phi"] + Fraction(1, 2), "φ + 1/2"),
    (lambda s: s["L"]**2 + s["L"] + Fraction(1, 2), "L² + L + 1/2"),
    (lambda s: s["x"].table.call("sin", s["phi"]) * s["L"] + Fraction(1, 3), "L·sin\u00a0φ + 1/3\u00a0m")])
def test_the_unit_is_that_of_the_letters(scene, of, text):
    """None of pure numbers, and where terms of letters have several units: a number that is not seen has one, too."""
    assert plain(of(letters(scene))) == text


def test_it_stands_so_in_all_notations(scene):
    node = letters(scene)["L"] + Fraction(1, 2)
    assert latex(node) == r"L + 0.5 \text{ m}"
    assert typst(node) == 'L + 0.5" m"'
    assert "<mn>0.5</mn>" in mathml(node) and "m</mtext>" in mathml(node)
    assert language(node) == "L + 1/2"      # for programs
    assert plain.with_values({"L": "0.8"})(node) == "0.8 + 0.5"


STIFF = """
parameters: {M: 2 kg, L: {value: 0.8 m, unused: allowed}, J: 4 kg*m^2}
bodies: {a: {mass: M, slide: x}, b: {inertia: J, turn: phi}}
springs: {s: {k: 300 N/m, between: [ground, a]}, t: {torsion: 70 N*m, between: [ground, b]}}
"""


@pytest.mark.parametrize(("more", "of", "text"), [
    ("", lambda s: 300 * s["x"] + 2, "300·x + 2"),      # newtons
    ("", lambda s: (300 * s["x"] + 2) * s["L"] + 5, "L·(300·x + 2) + 5"),
    ("", lambda s: s["L"]**2 + 9, "L² + 9\u00a0m²"),
    ("", lambda s: s["L"] / 2 + Fraction(1, 4), "L/2 + 0.25\u00a0m"),
    ("", lambda s: s["L"] / 5 + Fraction(1, 10), "L/5 + 0.1"),      # as of 2 (L + 0.5 m)·0.1 m
    ("", lambda s: s["L"].table.call("ramp", 300 * s["x"]) + 9, "ramp(300·x) + 9"),
    ("dampers: {d: {c: 1 N*s/m, between: [ground, a]}}\n", lambda s: s["x"] + 2, "x + 2"),
    ("forces: {f: {at: a, force: 300 N/m*(x + 2 m*sin(phi))}}\n", lambda s: s["x"] + 2, "x + 2\u00a0m")])
def test_none_is_told_where_a_factor_may_have_one(more, of, text):
    assert plain(of(letters(problem(STIFF + more).scene))) == text
