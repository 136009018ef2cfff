"""Ritz, Rayleigh and Dunkerley in the worked solution, followed by plain arithmetic."""

import math
import re
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

FRAME = Path("vibcli/examples/shear_frame_by_ritz.yaml")
DISCS, = Path("problems").glob("*/three_discs_on_fixed_shaft.yaml")


def lines_of(scene):
    return {line.settles: line for line in worked(scene)}


def numbers(line):
    """Those behind the equal signs of a line."""
    text = formula(line.parts, plain).replace("−", "-")
    return [float(x) for x in re.findall(r" = (-?[\d.]+(?:e-?\d+)?)", text)]


def test_roots_of_the_reduced_matrices_are_those_told():
    """det(K̂ − ω²M̂) = 0 of the numbers printed; M̂ and K̂ of (1, 2, 3) and (1, 4, 9) by hand for m = 2 t, k = 3 kN/mm."""
    lines = lines_of(kept_problem_of(FRAME))
    m11, m12, m22, k11, k12, k22 = numbers(lines["reduced matrices"])
    assert (m11, m12, m22) == (2000 * 14, 2000 * 36, 2000 * 98)
    assert (k11, k12, k22) == (3e6 * 3, 3e6 * 9, 3e6 * 35)
    a, b, c = m11 * m22 - m12**2, m11 * k22 + m22 * k11 - 2 * m12 * k12, k11 * k22 - k12**2
    for mode, sign in ((1, -1), (2, 1)):
        square = (b + sign * math.sqrt(b * b - 4 * a * c)) / (2 * a)
        assert lines[f"ritz[{mode}]"].value == pytest.approx(math.sqrt(square), rel=1e-12)


def test_rayleigh_and_dunkerley_by_hand():
    """√(uᵀKu/uᵀMu) and Σ 1/ω_j² of the numbers printed; shapes have no letter of the scene."""
    scene = kept_problem_of(DISCS)
    lines = lines_of(scene)
    above, below = numbers(lines["deflection"])
    assert lines["rayleigh"].value == pytest.approx(math.sqrt(above / below), rel=1e-5)
    each = [numbers(lines[f"omega_alone[{name}]"])[0] for name in ("one", "two", "three")]
    by_letters = "ω_two = √(k₁·k₂/(J₂·(k₁ + k₂))) = 94.2809 rad/s"
    assert formula(lines["omega_alone[two]"].parts, plain).replace("\u00a0", " ").strip() == by_letters
    assert lines["dunkerley"].value == pytest.approx(sum(x**-2 for x in each)**-0.5, rel=1e-5)
    exact = scene.modal.modes[0].omega
    assert lines["dunkerley"].value < exact < lines["rayleigh"].value


def test_what_is_not_asked_is_not_told():
    lines = lines_of(problem("""
parameters: {m: 2 kg, k: 30 N/m}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {p: {k: k, between: [ground, a]}, q: {k: k, between: [a, b]}}
"""))
    assert not {"rayleigh", "dunkerley", "ritz[1]", "reduced matrices"} & set(lines)
