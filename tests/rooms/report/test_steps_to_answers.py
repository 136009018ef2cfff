"""The last lines of worked solutions: what answers ask of a motion; the motion at resonance, held against the equation;
contact forces at rest; places in closed loops, which count from rest as the coordinates do."""

import math
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem, value

from vibcli.notation.plain import plain
from vibcli.report.document import Report
from vibcli.report.formats import text
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

PROBLEMS = Path(__file__).parents[3] / "problems"


def told(name):
    return [formula(line.parts, plain).replace("\u00a0", " ") for line in worked(kept_problem_of(PROBLEMS / name))]


@pytest.mark.parametrize(("load", "late", "x0", "v0", "mean"), [
    ("sin", 0, 0.0, 0.0, 0), ("cos", 0, 0.0, 0.0, 0), ("sin", 0, 0.02, 0.3, 0), ("sin", 0.7, 0.02, 0.3, 2)])
def test_the_motion_at_resonance_fulfils_its_equation_and_its_start(load, late, x0, v0, mean):
    start = f"initial: {{x: {x0} m, x': {v0} m/s}}" if x0 else ""
    found = problem(f"""
        parameters: {{m: 2 kg, k: 800 N/m, F: 5 N, w: sqrt(k/m), t1: 0.3 s}}
        bodies: {{b: {{mass: m, slide: x}}}}
        springs: {{s: {{k: k, between: [ground, b]}}}}
        forces: {{f: {{at: b, force: F*({mean} + {load}(w*t + {late}))}}}}
        answers: {{x(t1): 0 m}}
        {start}
    """)
    node = {line.settles: line for line in worked(found)}["motion from the start"].node

    def x(t):
        return evaluate([node], Floats, {**found.numeric.floats, found.scene.time.name: t})[0]

    h = 1e-4
    assert x(0.0) == pytest.approx(x0, abs=1e-15) and (x(h) - x(-h)) / (2 * h) == pytest.approx(v0, abs=1e-6)
    for t in (0.3, 1.7):
        bent = (x(t + h) - 2 * x(t) + x(t - h)) / h**2
        assert 2 * bent + 800 * x(t) == pytest.approx(5 * (mean + getattr(math, load)(20 * t + late)), abs=2e-3)


def test_what_swings_beside_the_natural_frequency_is_at_no_resonance():
    found = problem("""
        parameters: {m: 2 kg, k: 800 N/m, F: 5 N, w: 20.0000005 rad/s, t1: 100 s}
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        forces: {f: {at: b, force: F*sin(w*t)}}
        answers: {x(t1): 0 m}
    """)
    assert {"steady state", "motion from the start"} <= {line.settles for line in worked(found)}


def test_what_answers_ask_of_a_motion_is_told_side_by_side():
    last = [text for text in told("4_free_damped/cage_loses_half_its_load.yaml") if "max(y)" in text or "decr" in text]
    assert last == ["max(y):  R·A·exp(−π·δ/ω_d) = 0.0339466 m", "decrement(y):  2·π·δ/ω_d = 0.285376"]


@pytest.mark.sweep
def test_a_contact_force_that_is_asked_at_rest_is_told_there():
    told_ = told("4_free_damped/roller_with_a_dashpot_at_its_top.yaml")
    assert "by the balance at rest  roller.normal = m·g·cos α = 55.3103 N" in told_


def test_a_load_that_changes_with_the_time_is_no_part_of_a_contact_force_at_rest():
    """As in the number that the engine has."""
    found = problem("""
        parameters: {m: 8 kg, r: 0.2 m, k: 900 N/m, F: 30 N, G: 12 N, W: 7 rad/s, g: 9.81 m/s^2}
        gravity: g
        surfaces: {floor: {line: [[-1 m, 0], [1 m, 0]]}}
        bodies: {roller: {shape: disc, mass: m, radius: r, at: [0, r], roll: {surface: floor, travel: x}}}
        springs: {s: {k: k, between: [roller, [-1 m, r]]}}
        forces: {f: {at: roller, force: [0, -F*cos(W*t) - G]}}
        answers: {"equilibrium[roller.normal]": m*g + G}
    """)
    line, = (one for one in worked(found) if one.settles == "roller.normal")
    assert plain(line.node) == "m·g + G" and line.value == pytest.approx(value(found, "equilibrium[roller.normal]"))


@pytest.mark.sweep
def test_places_in_closed_loops_count_from_rest():
    lines = told("4_free_damped/cam_and_follower_at_rest.yaml")
    assert any("C = (0, y + h + y₀)" in one for one in lines) and any("Δ_press = −y = −b₁·φ" in one for one in lines)


def test_the_integral_of_energy_has_no_constant_that_V_lacks_and_known_signs_are_put_in():
    """A weight that is drawn 1 m below the height that its potential counts from."""
    lines = told("9_equivalents_and_corrections/weight_that_jerks_a_slack_rope.yaml")
    assert any(one.endswith("integrated:  m·ẏ²/2 + k·max(y − s₀, 0)²/2 − m·g·y = E") for one in lines)
    assert any(one.startswith("ω² = k/m,") for one in lines)


def test_a_zero_in_letters_is_told_as_the_number_alone():
    found = problem("""
        parameters: {m: 2 kg, k: 800 N/m, F: 5 N, w: 10 rad/s}
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        dampers: {d: {c: 10 N*s/m, between: [ground, b]}}
        forces: {f: {at: b, force: F*sin(w*t)}}
        answers: {mean(x): 0 m}
    """)
    last = {line.settles: line for line in worked(found)}["mean(x)"]
    assert formula(last.parts, plain).replace("\u00a0", " ") == "mean(x) = 0 m"


def test_a_root_mean_square_is_told_by_the_amplitude():
    found = problem("""
        parameters: {m: 2 kg, k: 800 N/m, c: 10 N*s/m, F: 5 N, w: 10 rad/s}
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        dampers: {d: {c: c, between: [ground, b]}}
        forces: {f: {at: b, force: F*sin(w*t)}}
        answers: {rms(x): 0 m}
    """)
    last = {line.settles: line for line in worked(found)}["rms(x)"]
    assert "√2·X/2 = " in formula(last.parts, plain)
    assert last.value == pytest.approx(5 / math.sqrt(2 * (600**2 + 100**2)))


@pytest.mark.parametrize(("spring", "unit", "wanted"), [
    ("{k: 2 kN/m, between: [ground_end, slider], preload: static}", "N", 0.5 * 3 * 9.81 / math.tan(0.6)),
    ("{torsion: 90 N*m/rad, between: [ground, one], preload: static}", "N·m", 3 * 9.81 * 0.5 * math.cos(0.6))])
def test_a_tension_that_balances_open_loops_is_told_with_its_number(spring, unit, wanted):
    """Two light rods of the length 0.5 m, joined under 3 kg: a static preload is a symbol where loops are open."""
    found = problem(f"""
        parameters: {{L: 0.5 m, M: 3 kg, a: 0.6 rad, g: 9.81 m/s^2}}
        gravity: g
        points:
          ground_end: [-1 m, 0]
          B: {{body: one, at: [L*cos(a), L*sin(a)]}}
          E: {{body: two, at: [L*cos(a), L*sin(a)]}}
        bodies:
          one: {{mass: M, at: [L*cos(a), L*sin(a)], pin: {{at: [0, 0], by: q}}}}
          slider: {{mass: 1 kg, at: [2*L*cos(a), 0], slide: x}}
          two: {{mass: 0, at: [L*cos(a), L*sin(a)], pin: {{at: [2*L*cos(a), 0], carrier: slider, by: r}}}}
        constraints: {{j: {{join: [B, E]}}}}
        springs: {{s: {spring}}}
        find: [equations]
    """)
    line, = (one for one in worked(found) if "tension of s as drawn" in formula(one.parts, plain))
    assert line.unit == unit and abs(line.value) == pytest.approx(wanted, rel=1e-12)


SPRUNG_BLOCK = """
    parameters: {m: 8 kg, R: 20 cm, c: 12 cm, b: 40 cm, k: 6 kN/m, g: 9.81 m/s^2}
    gravity: g
    points: {P: {body: drum, at: [0, -c]}}
    bodies:
      drum: {shape: disc, mass: m, radius: R, at: [0, 0], pin: phi}
      load: {mass: m, at: [R, -2*R], slide: {along: [0, 1], by: y}}
      block: {mass: m, at: [-b, -c], slide: x}
    springs: {s: {LAW, between: [[-2*b, -c], block], preload: static}}
    constraints: {hoist: {rope: [{right_of: drum}, load]}, rod: {link: [block, P]}}
    find: [energies, equations]
    """


def test_the_symbol_of_a_static_preload_is_told_wherever_it_is_printed():
    found = problem(SPRUNG_BLOCK.replace("LAW", "k: k"))
    report = Report(found)
    for name in ("energies", "equations"):
        report.add(name)
    printed = text.render([report.document()], None)
    told = "with s.preload = −m·R·g/c, the force of s at rest as drawn"
    assert [part.count(told) for part in printed.split("Equations of motion")] == [1, 1]
    assert "s.preload" not in printed.partition("Kinetic energy")[2].partition("Potential")[0]


def test_a_law_whose_stretch_holds_a_static_preload_is_told_after_it():
    lines = worked(problem(SPRUNG_BLOCK.replace("LAW", "law: k*d")))
    settled = [line.settles for line in lines]
    line = lines[settled.index("s.preload")]
    assert line.value == pytest.approx(-8 * 0.2 * 9.81 / 0.12) and line.unit == "N"
    assert settled.index("s.preload") < min(i for i, one in enumerate(lines) if "s.preload" in formula(
        one.parts, plain) and one is not line)
