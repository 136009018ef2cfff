"""Numbers with units in a scene keep them in its worked solution, in every notation, and cancel as numbers do."""

import re
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem
from support.worked_lines import InOtherUnits

from vibcli.notation.latex import latex
from vibcli.notation.mathml import mathml
from vibcli.notation.plain import plain
from vibcli.notation.scene_language import language
from vibcli.notation.typst import typst
from vibcli.report.formats.formula import formula
from vibcli.report.formats.text import section_lines
from vibcli.report.measured import with_units
from vibcli.report.sections.steps import section_of
from vibcli.report.steps.worked import worked

LEVER = """
parameters: {k: 1.2 kN/m, a: 0.5 m, M: 3 kg}
points: {O: [0, 0], A: {body: arm, at: [a + 0.3 m - 0.3 m, 0]}, B: {body: arm, at: [a + 20 cm + 0.1 m, 0]},
         C: [a, -0.4 m], D: [a + 0.3 m, 0.2 m]}
bodies:
  arm: {shape: rod, from: O, to: [a + 0.3 m, 0], mass: 0.6 m*M/a, pin: {at: O, by: phi}}
springs: {s: {k: k, between: [C, A]}}
dampers: {d: {c: 240 N*s/m, between: [D, B]}}
"""


@pytest.fixture(scope="module")
def scene():
    return problem(LEVER)


def test_lines_have_the_units_of_the_numbers_in_the_file(scene):
    lines = worked(scene)
    told = {one.settles: formula(one.parts, plain).replace("\u00a0", " ") for one in lines}
    assert "c" not in scene.spec.parameters and "(120 N·s/m)·" in told["Phi"]
    assert not InOtherUnits(scene, lines).wrong
    text = "\n".join(section_lines(section_of(lines)))
    assert "SI units" not in text and not re.search(r"\d·\(1 m\)|= \S+ = \S+ (kg|N/m)$", text)


def test_equal_numbers_cancel_and_others_add_up(scene):
    table, nodes = (found := with_units(scene).scene).table, found.parameters.nodes
    m = nodes["1 m"]
    assert (3 * m / 10 - 3 * m / 10) is table.zero
    assert plain(nodes["a"] + m / 5 + m / 10) == "a + 0.3\u00a0m"


@pytest.mark.parametrize(("of", "text"), [
    (lambda s: s["1 m"] * 3 / 100 * s["k"], "(0.03\u00a0m)·k"),
    (lambda s: s["k"] / (s["1 m"] * 3 / 10), "k/(0.3\u00a0m)"),
    (lambda s: s["1 m"] * 2 / 3, "0.666667\u00a0m"), (lambda s: -s["1 kg"] * s["1 m"] / s["1 s"]**2, "−1\u00a0N"),
    (lambda s: s["a"].table.sqrt(s["a"]**2 + (s["1 m"] * 3 / 10)**2), "√(a² + 0.09\u00a0m²)"),
    (lambda s: s["1 m"]**2 * 4 / 5 + s["a"] * s["1 m"] * 2 / 5, "(0.4\u00a0m)·a + 0.8\u00a0m²"),
    (lambda s: 150 / s["1 s"] * s["M"], "(150\u00a01/s)·M")])
def test_a_number_is_written_with_what_multiplies_it(scene, of, text):
    assert plain(of(with_units(scene).scene.parameters.nodes)) == text


def test_it_stands_so_in_all_notations(scene):
    nodes = with_units(scene).scene.parameters.nodes
    node = nodes["1 m"] * 3 / 100 * nodes["k"]
    assert latex(node) == r"\left(0.03 \text{ m}\right) \, k"
    assert typst(node).startswith('(0.03" m")')
    assert "<mn>0.03</mn><mtext>" in mathml(node) and "m</mtext>" in mathml(node)
    assert language(node) == "3*k/100"      # for programs
    assert plain.with_values({"k": "1200"})(node) == "0.03·1200"


@pytest.mark.sweep
def test_balances_in_numbers_have_units():
    """Of moments forces have arms in metres, of forces they have none."""
    found = kept_problem_of(Path("problems/1_statics_and_energy/jib_crane_with_winch.yaml"))
    told = {one.settles: formula(one.parts, plain).replace("\u00a0", " ") for one in worked(found)}
    assert told["balance[phi]"].endswith("−(4.74342 m)·S_tie − (1.71758 m)·S_rope_1 + (6 m)·S_rope_2 + 12360.6 N·m = 0")
    assert told["balance[mast.reaction.y]"] == "mast.reaction.y = S_rope_2 + 4120.2 N"
    assert told["balance[jib.reaction.x]"] == "jib.reaction.x = 0.948683·S_tie + 0.979117·S_rope_1"


def test_numbers_of_the_file_have_their_units_beside_members():
    """In what holds them, in the frequency equation, and in what two modes are orthogonal by."""
    lines = [formula(line.parts, plain).replace("\u00a0", " ") for line in worked(problem("""
        parameters: {L: 2 m, EA: 3 MN, u0: 1 mm}
        bars: {b: {length: L, EA: EA, mass_per_length: 2 kg/m, left: clamped, attached: [{mass: 5 kg, at: L}]}}
        initial: {b.u: u0*x/L}
        answers: {b.u(L)(0.01 s): 0 m}
    """))]
    for told in ("at x = L:  EA·∂u/∂x = −(5 kg)·∂²u/∂t²", "so the frequency equation:  βL·tan βL = L/(2.5 m)",
                 "two modes are orthogonal:  ∫(2 kg/m)·X_i·X_j·dx + (5 kg)·X_i(L)·X_j(L) = 0, ω_i ≠ ω_j"):
        assert told in lines
