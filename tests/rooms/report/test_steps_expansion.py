"""Expansions line by line: what textbooks print, each line held against its function, nothing said twice."""

import math
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps import expansion
from vibcli.report.steps.worked import worked
from vibcli.results.expansions import expansions
from vibcli.symbolic.evaluation import Floats, evaluate

ROOT = Path(__file__).parents[3]
EXAMPLE = ROOT / "vibcli" / "examples" / "expanded_about_rest.yaml"
CART = """
    parameters: {M: 3 kg, m: 1 kg, L: 0.5 m, k: 90 N/m, g: 9.81 m/s^2}
    gravity: g
    bodies:
      cart: {mass: M, at: [0, 0], slide: x}
      bob: {mass: m, at: [0, -L], pin: {at: cart, by: phi}}
    springs: {s: {k: k, stretch: x}}
    %s
"""

def lines_of(scene):
    return {line.settles: line for line in worked(scene)}


def shown(line):
    return " ".join(formula(line.parts, plain).split())


def test_a_slider_on_a_spring_square_to_its_guide():
    """Kovačić & Radomirović 2018, 9.4: Δ = x²/2L − x⁴/8L³, V = N x²/2L + (k L − N) x⁴/8L³."""
    lines = lines_of(kept_problem_of(EXAMPLE))
    assert shown(lines["Delta_s to order 4"]).endswith("Δ_s = x²/(2·L) − x⁴/(8·L³)")
    assert "V_s = N·x²/(2·L) + (k·L − N)·x⁴/(8·L³), all of it by its geometry" in shown(lines["V_s to order 4"])
    assert shown(lines["expanded equation of x"]).endswith("m·ẍ + (k·L + N)·x/L + (k·L − N)·x³/(2·L³) = 0")
    for repeated in ("Delta_along to order 3", "V_along to order 4", "T to order 4"):
        assert repeated not in lines
    whole = lines["V to order 4"]
    assert set(whole.uses) == {lines["V_along"].number, lines["V_s to order 4"].number}


def test_of_two_degrees_energies_and_equations_are_those_of_the_engine():
    scene = problem(CART % "find: [{expansion: 6}]")
    lines = lines_of(scene)
    values = {**scene.numeric.floats, "x": 0.07, "phi": 0.05, "x'": 0.3, "phi'": -0.2, "x''": 0.0, "phi''": 0.0}
    assert shown(lines["T to order 6"]).startswith("to order 6: T = m·L·ẋ·φ̇ + (M + m)·ẋ²/2")
    for letter, exact in (("T", lambda M, m, L, k, g: M * 0.045 + m / 2 * (
            0.09 - 2 * L * 0.06 * math.cos(0.05) + L**2 * 0.04)),
            ("V", lambda M, m, L, k, g: k * 0.07**2 / 2 + m * g * L * (1 - math.cos(0.05)))):
        found, = evaluate([lines[f"{letter} to order 6"].node], Floats, values)
        assert found == pytest.approx(exact(*(values[name] for name in "MmLkg")), rel=1e-9)
    assert shown(lines["expanded equation of phi"]).endswith("m·L·g·φ⁵/120 = 0")


def test_a_place_that_a_search_found_is_told_in_numbers():
    found, = (ROOT / "problems").glob("*/scale_pan_on_a_hardening_spring.yaml")
    lines = lines_of(kept_problem_of(found))
    assert shown(lines["V to order 4"]).endswith("V = 319.346·x² + 2375.89·x³ + 12500·x⁴")
    assert lines["V to order 4"].node is None and "Delta_s to order 4" not in lines


def test_loads_and_what_is_left_out_are_told():
    loaded = CART.rstrip(" ") % "find: [expansion]" + (
        "    forces: {F: {coordinate: x, value: 5 N}}\n    dampers: {d: {c: 2 N*s/m, stretch: x}}\n")
    lines = lines_of(problem(loaded))
    assert "work of the steady loads" in shown(lines["work to order 4"])
    assert shown(lines["expanded equation of x"]).endswith("(without dampers)")


def test_nothing_is_told_unless_it_is_asked():
    assert not any("order" in settles for settles in lines_of(problem(CART % "")))


def test_a_wrong_term_leaves_a_remainder():
    scene = kept_problem_of(EXAMPLE)
    one = expansions(scene, 4)[0]
    assert expansion._remains_small(scene, one, 4)
    powers = next(powers for powers in one.energies["V"] if sum(powers) == 4)
    wrong = {key: c * 1001 / 1000 if key == powers else c for key, c in one.energies["V"].items()}
    assert not expansion._remains_small(scene, one._replace(energies=one.energies | {"V": wrong}), 4)
