"""Worked solutions of ropes to loads that swing: lengths and turns of their free pieces have letters, coefficients at
rest are short."""

from math import sqrt

import pytest
from support.scenes import kept_problem_of, problem
from support.worked_lines import Checked, InOtherUnits

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

HEAD = "parameters: {{m: 2 kg, M: 6 kg, k: 400 N/m, h: 0.8 m, b: 0.6 m, g: 9.81 m/s^2{}}}\n"
OVER_A_PULLEY = HEAD.format(", r: 0.1 m, J: 0.03 kg*m^2") + """
gravity: g
bodies:
  block: {mass: M, at: [-b, 0], slide: {along: [1, 0], by: x}}
  wheel: {mass: m, inertia: J, at: [0, -r], pin: phi}
  load: {mass: m, at: [r, -h], move: [X, Y, 0]}
springs: {s: {k: k, between: [[-2*b, 0], block], preload: static}}
constraints: {rope: {rope: [block, {over: wheel, radius: r}, load]}}
find: [frequencies]
"""
ROUND_A_LOAD = HEAD.format(", r: 0.1 m") + """
gravity: g
bodies:
  wheel: {shape: disc, mass: m, radius: r, at: [0, 0], move: [x, y, phi]}
  block: {mass: M, at: [b, h], slide: {along: [1, 0], by: u}}
springs: {s: {k: k, between: [block, [3*b, h]], preload: static}}
constraints: {rope: {rope: [[-b, h], {under: wheel}, block]}}
find: [frequencies]
"""
FROM_A_TROLLEY = HEAD.format("") + """
gravity: g
bodies:
  load: {mass: m, at: [b, -h], move: [x, y]}
  trolley: {mass: M, at: [0, 0], slide: {along: [1, 0], by: u}}
springs:
  s: {k: k, between: [trolley, [-b, 0]], preload: static}
  t: {k: k, between: [load, [2*b, 0]], preload: static}
constraints: {rope: {rope: [load, trolley]}}
find: [frequencies]
"""
LINES = 3           # of print


@pytest.mark.parametrize("text", [OVER_A_PULLEY, ROUND_A_LOAD, FROM_A_TROLLEY])
def test_lines_of_a_rope_to_a_swinging_load_are_short_and_true(text):
    found = problem(text)
    lines = worked(found)
    checked = Checked(found, lines)
    assert not checked.wrong and checked.count > 20
    assert not InOtherUnits(found, lines).wrong
    assert max(len(formula(line.parts, plain)) for line in lines) <= LINES * 100


def test_over_a_pulley_the_load_swings_like_a_pendulum_of_the_free_length():
    """ω² = g/(h − r) to the side, k/(m + M + J/r²) along the rope; the spring bears the weight to the last digit."""
    m, M, J, k, r, h, g = 2, 6, 0.03, 400, 0.1, 0.8, 9.81
    lines = {line.settles: line for line in worked(problem(OVER_A_PULLEY))}
    assert lines["omega[1]"].value == pytest.approx(sqrt(g / (h - r)), rel=1e-12)
    assert lines["omega[2]"].value == pytest.approx(sqrt(k / (m + M + J / r ** 2)), rel=1e-12)
    assert plain(lines["N_s"].node) == "m·g" and plain(lines["K[X,X]"].node) == "m·g/(h − r)"
    assert formula(lines["ℓ1"].parts, plain).startswith("length  ℓ₁ = √(X² + 2·r·X + Y²")
    assert formula(lines["phi"].parts, plain).startswith("rotation of wheel  φ = β₁ + β₂ + ")


def test_forces_and_slopes_at_rest_have_the_letter_of_their_element_alone():
    found = worked(kept_problem_of("problems/9_equivalents_and_corrections/hardening_mount_drawn_under_its_load.yaml"))
    lines = {line.settles: formula(line.parts, plain) for line in found}
    assert lines["k_mount"].endswith("the slope of its law:  k_mount = 41273.3 N/m")
    assert lines["N_mount"] == "so N_mount = −392.4 N" and "b1" not in lines
    assert lines["equation[y]"] == "m·ÿ + k_mount·y = 0"


def test_entries_that_cancel_at_a_searched_place_are_left_out():
    """By symmetry; the tensions that cancel are found apart, and have other last digits."""
    found = kept_problem_of("problems/9_equivalents_and_corrections/particle_on_equal_taut_pairs_sags.yaml")
    lines = {line.settles for line in worked(found)}
    assert {"K[x,x]", "K[y,y]"} <= lines and "K[x,y]" not in lines
