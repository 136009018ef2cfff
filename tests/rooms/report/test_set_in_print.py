"""What stands in reports as it is set in print: symbols within questions, words that hold, formulas that are read."""

from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

import vibcli
from vibcli.api.reports import STEPS, illustrated, report, solution
from vibcli.base.units import ENERGY, FORCE
from vibcli.quantities.dimensions import text_of
from vibcli.report.blocks import Name, maths
from vibcli.report.formats import html, latex, text
from vibcli.report.sections.requested_signals import symbol
from vibcli.symbolic.syntax import NameRef

ROOT = Path(__file__).parents[3]
ASKED = """
question: "Of k2 x^2/pi and 2*a sin(Omega1 t) let phi1' be {a}, k2.force or k3 (R/n^2)."
parameters: {a: 3 N*s/m, k2: 4 N/m, Omega1: 5 rad/s, m: 2 kg}
bodies: {b: {mass: m, slide: x}, d: {inertia: 1 kg*m^2, turn: phi1}}
springs: {s: {k: k2, between: [ground, b]}, t: {torsion: 1 N*m, between: [ground, d]}}
forces: {f: {at: b, force: a*(1 m)*Omega1*sin(Omega1*t)}}
"""
HELD = """
parameters: {F: 8 N}
bodies: {b: {mass: 1 kg, at: [0, 0], slide: x}}
constraints: {wall: {equation: x = 0}}
forces: {f: {at: b, force: [F, 0]}}
find: [equilibrium, reactions]
"""
FREE = "bodies: {a: {mass: 2 kg, slide: x}, b: {mass: 3 kg, slide: y}, c: {mass: 1 kg, slide: z}}\n"
NESTED = """
parameters: {m: 2 kg, %s}
bodies: {b: {mass: m, slide: x}}
springs: {%s}
"""


def told(scene, sections=None):
    found = problem(scene)
    return report(found, sections or solution(found)).document()


def test_questions_have_symbols():
    """Of names that the scene has, not within names of others; powers and products, roots too."""
    found = told(ASKED)
    assert found.question[:2] == ("Of ", maths(Name("k2")))
    assert text.render([found]).split("\n")[3] == \
        "Of k₂ x²/π and 2·a sin(Ω₁ t) let φ̇₁ be 3 N·s/m, k2.force or k3 (R/n²)."
    assert "3\N{NO-BREAK SPACE}N·s/m, k2.force" in html.render([found])


def test_a_name_in_quotation_marks_is_no_rate():
    scene = ASKED.replace("Of k2 x^2/pi", "Of 'phi1' and phi1's k2 x^2/(3 k2)")
    assert text.render([told(scene)]).split("\n")[3].startswith("Of 'φ₁' and φ₁'s k₂ x²/(3 k₂) and 2·a")


def test_loads_alone_drive_nothing():
    assert "(of weights, springs and steady loads)" in text.render([told(ASKED)])


def test_where_all_is_held_the_forces_are_its_equilibrium():
    found = problem(HELD)
    made = report(found, solution(found))
    assert made.refusal is None and "b.reaction.x  −8 N" in text.render([made.document()])


def test_nothing_is_called_back_without_stiffness():
    shown = text.render([told(FREE, STEPS)])
    assert "nothing is stiff:  det(ω²·M) = 0  for  ω = 0 alone" in shown and "K" not in shown


@pytest.mark.parametrize("count", [3, 40])
def test_a_frequency_that_is_too_long_to_read_is_told_by_its_number(count):
    names = [f"kay{i}" for i in range(count)]
    scene = NESTED % (", ".join(f"{name}: {i + 3} N/m, arm{i}: {i + 2}" for i, name in enumerate(names)), ", ".join(
        f"s{i}: {{k: {name}*arm{i}^2/(1 + arm{i}), between: [ground, b]}}"
        for i, name in enumerate(names)))
    assert ("\n  ω = √" in text.render([told(scene)])) is (count == 3)


def test_signs_of_numbers_among_words_are_those_of_print():
    braked = told("""
        question: "What dies out as exp(-5 t)?"
        bodies: {b: {mass: 2 kg, slide: x}}
        springs: {s: {k: 8 N/m, between: [ground, b]}}
        dampers: {d: {c: 10 N*s/m, between: [ground, b]}}
    """)
    assert "exp(−5 t)" in text.render([braked]) and "over-damped, λ = −1 1/s" in text.render([braked])
    falling = told("gravity: 9.81 m/s^2\nfind: [accelerations]\n"
                   "bodies: {rod: {shape: rod, mass: 2 kg, from: [0, 0], to: [1 m, 0], pin: {at: [0, 0], by: phi}}}\n")
    assert "φ̈ = −14.715 rad/s²" in text.render([falling])


@pytest.mark.parametrize(("asked", "label"), [
    ("L*phi1'", "L·φ̇₁"), ("2*x1 - y'", "2·x₁ − ẏ"), ("rope.force[1]", "rope.force[1]"), ("rod.u(L/2)", "rod.u(L/2)"),
    ("s1.force + d.force", "s1.force + d.force"), ("phi''", "φ̈"), ("max(x1)", "max(x₁)")])
def test_signals_that_are_asked_are_labelled_as_in_print(asked, label):
    assert symbol(asked) == label


def test_conditions_are_told_apart():
    shown = text.render([told("""
        bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}, c: {mass: 1 kg, slide: z}}
        constraints: {one: {equation: y = 2*x}, two: {equation: z = 3*x}}
    """)])
    assert "3 coordinates less 2 independent conditions: z = 3·x, y = 2·x" in shown


def test_what_is_prescribed_is_told_with_pictures_too():
    found = kept_problem_of(ROOT / "problems/2_lagrange/pump_turned_by_a_motor.yaml")
    made = report(found, illustrated(solution(found)), pictures=True)
    assert made.refusal is None and made.sections[0].title == "Figure"


ENERGETIC = """
parameters: {m: 2 kg, k: 200 N/m, kt: 3 N*m/rad, b: 0.2 m}
bodies: {b: {mass: m, slide: x}, wheel: {inertia: m*b^2, turn: phi}}
springs: {s: {k: k, between: [ground, b]}, t: {torsion: kt, between: [ground, wheel]}}
initial: {x: 10 cm, phi: 0.2 rad}
find: [{response: {of: [s.energy, t.energy, t.force], until: 2 s}}]
"""


@pytest.mark.sweep
def test_energies_are_in_joules_and_moments_in_newton_metres(tmp_path):
    heads = text.render([told(ENERGETIC)])
    assert all(head in heads for head in ("s.energy [J]", "t.energy [J]", "t.force [N·m]"))
    path = tmp_path / "scene.yaml"
    path.write_text(ENERGETIC)
    found = vibcli.load(path)
    assert [found[asked].unit for asked in ("max(s.energy)", "t.energy(0.1 s)", "max(t.force)")] == ["J", "J", "N·m"]
    T = NameRef(0, 1, "T", 0)
    assert text_of(ENERGY, T) == "J" and text_of(ENERGY, T, {"T"}) == "N·m" and text_of(FORCE, T) == "N"


def test_a_double_eigenvalue_stands_once():
    damped = "dampers: {d: {c: 80 N*s/m, between: [ground, b]}}\n"
    one = NESTED.replace("%s}\nbodies", "k: 800 N/m}\nbodies") % "s: {k: k, between: [ground, b]}"
    assert text.render([told(one + damped)]).count("critically damped") == 1


@pytest.mark.parametrize(("name", "sections"), [
    ("2_lagrange/pump_turned_by_a_motor", None), ("1_statics_and_energy/drum_with_rope_and_weight", STEPS)])
def test_no_row_of_text_ends_with_an_equality_or_begins_with_its_zero(name, sections):
    """Of formulas that are broken: the sign stands before what follows, and a short letter with it."""
    found = kept_problem_of(ROOT / f"problems/{name}.yaml")
    rows = text.render([report(found, sections or solution(found)).document()]).split("\n")
    assert any(row.strip().startswith("= ") for row in rows)
    assert not [row for row in rows if row.endswith((" =", ",  T")) or row.strip() == "0"]


def test_a_value_in_a_question_is_not_parted_from_its_unit():
    """A no-break space in each format; in text the line ends before the number."""
    found = problem("""
        question: >-
          A block of mass {M} hangs on a spring of stiffness {k} by a damper of {c} and turns {U} of unbalance.
        parameters: {M: 3 kg, k: 900 N/m, c: 4 N*s/m, U: 0.25 kg*m}
        bodies: {block: {mass: M, slide: x}}
        springs: {s: {k: k + 0*U/(1 kg*m)*k, between: [ground, block]}}
        dampers: {d: {c: c, between: [ground, block]}}
    """)
    document = report(found, ()).document()
    assert [part for part in document.question if "\N{NO-BREAK SPACE}" in str(part)] == [
        one.replace(" ", "\N{NO-BREAK SPACE}") for one in ("3 kg", "900 N/m", "4 N·s/m", "0.25 kg·m")]
    lines = text.render([document]).splitlines()
    assert any(line.startswith("0.25 kg·m of") for line in lines) and "\N{NO-BREAK SPACE}" not in "".join(lines)
    assert "900~N/m" in latex.render([document], Path()) and "900\N{NO-BREAK SPACE}N/m" in html.render([document])


def test_names_in_what_the_file_says_of_coordinates_are_symbols():
    shown = text.render([told("""
        parameters: {m1: {about: mass of the one that phi1 turns}, k2: , r: }
        coordinates: {phi1: turn of m1 against k2}
        bodies: {b: {inertia: m1*r^2, turn: phi1}}
        springs: {s: {torsion: k2*r^2, between: [ground, b]}}
    """)])
    assert "turn of m₁ against k₂" in shown and "mass of the one that φ₁ turns" in shown
