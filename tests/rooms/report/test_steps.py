"""The worked solution: its lines as they are printed, each equality in them at values of its letters, and which scenes
have none."""

import json
import math
import re
from functools import cache
from pathlib import Path

import pytest
from support.renderings import FORMATS, faults
from support.scenes import kept_problem_of, problem
from support.worked_lines import Checked, told_later

import vibcli
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.notation.plain import plain
from vibcli.report.blocks import Document, Words
from vibcli.report.formats.formula import formula
from vibcli.report.formats.text import running
from vibcli.report.json_keys import KEYS
from vibcli.report.sections.parameters import tied
from vibcli.report.sections.steps import section_of
from vibcli.report.steps.worked import asks_in_full, worked

PROBLEMS = sorted(Path("problems").glob("[1-79]_*/*.yaml"))
ROD = """
title: A level rod on a spring with a dashpot
parameters: {m: 3 kg, L: 0.8 m, h: 0.3 m, k: 1.2 kN/m, c: 40 N*s/m, g: 9.81 m/s^2}
gravity: g
points: {B: {body: rod, at: [L, 0]}, D: {body: rod, at: [L/2, 0]}}
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}}
springs: {s: {k: k, between: [[L, -h], B], preload: static}}
dampers: {d: {c: c, between: [[L/2, -h], D]}}
"""
PRINTED = """\
   1  φ:  rotation of rod,  counter-clockwise,  zero as drawn
   2  rod turns about the fixed O, C at  (L·cos φ/2, L·sin φ/2):  J_O = J_C + m·OC² = m·L²/12 +
      m·L²/4 = m·L²/3 = 0.64 kg·m²
   3  T = J_O·φ̇²/2 = m·L²·φ̇²/6
   4  stretch of s, from rest, B at  (L·cos φ, L·sin φ):  Δ_s = √((L·cos φ − L)² + (L·sin φ + h)²) −
      h = L·φ + …   (second order, as its force at rest counts: there is no such term)
   5  V_s = k·Δ_s²/2 + N_s·Δ_s = L²·k·φ²/2 + L·N_s·φ,  N_s its force at rest
   6  weight of rod, counted from rest:  V_rod = m·L·g·sin φ/2 = m·L·g·φ/2 + …   (second order, as
      its force at rest counts: there is no such term)
   7  speed across d, D at  (L·cos φ/2, L·sin φ/2):  u̇_d = L·φ̇/2,  Φ = c·u̇_d²/2 = L²·c·φ̇²/8
   8  at rest  ∂V/∂φ = L·N_s + m·L·g/2 = 0,  so N_s = −m·g/2 = −14.715 N,  s being deflected by
      −m·g/(2·k) = −0.0122625 m (shortened)
   9  V = V_s + V_rod = L²·k·φ²/2   (the terms of the first order vanish at rest)
  10  ∂T/∂φ̇ = m·L²·φ̇/3,  d/dt ∂T/∂φ̇ = m·L²·φ̈/3,  ∂T/∂φ = 0
  11  ∂V/∂φ = L²·k·φ,  ∂Φ/∂φ̇ = L²·c·φ̇/4
  12  m·L²·φ̈/3 + L²·c·φ̇/4 + L²·k·φ = 0
  13  ω² = L²·k/(m·L²/3) = 3·k/m,  ω = √(3·1200/3) = 34.641 rad/s,  f = ω/(2·π) = 5.51329 Hz,
      T = 2·π/ω = 0.18138 s
  14  so  φ̈ + 2·δ·φ̇ + ω²·φ = 0  with  δ = 3·c/(8·m) = 3·40/(8·3) = 5 1/s
  15  ζ = δ/ω = √3·c/(8·√(m·k)) = 0.144338 < 1: under-damped
  16  ω_d = √(ω² − δ²) = √(1200 − 25) = 34.2783 rad/s
"""
CART = Path("problems/2_lagrange/pendulum_on_sprung_cart.yaml")
MOST = {1: 25, 2: 60}       # some 25 and 60 lines, beside one for each amplitude that is asked of a signal


def test_the_lines_of_a_damped_rod(tmp_path, capsys):
    path = tmp_path / "rod.yaml"
    path.write_text(ROD)
    assert run(["solve", str(path), "--steps"]) == 0
    assert capsys.readouterr().out.endswith(PRINTED)


@pytest.mark.parametrize("spring, form", [("", "det(λ²·M + λ·C)"), (
    "springs: {s: {k: 4 N/m, between: [ground, a]}}\n", "det(λ²·M + λ·C + K)")])
def test_what_dampers_alone_brake(spring, form, tmp_path, capsys):
    """2 λ² + 6 λ + 3 = 0 beside two motions that stay; the determinant holds no matrix that there is not."""
    path = tmp_path / "braked.yaml"
    path.write_text("bodies: {a: {mass: 2 kg, slide: x}, b: {mass: 1 kg, slide: y}}\n" + spring +
                    "dampers: {d: {c: 3 N*s/m, between: [ground, a]}, e: {c: 1 N*s/m, between: [a, b]}}\n")
    assert run(["solve", str(path), "--steps"]) == 0
    told = capsys.readouterr().out
    assert f" {form} = " in told
    if not spring:
        for root in (-3 - math.sqrt(3), -3 + math.sqrt(3)):
            assert f"λ = −{-root / 2:.6g} 1/s" in told


def test_each_line_is_data(tmp_path, capsys):
    path = tmp_path / "rod.yaml"
    path.write_text(ROD)
    assert run(["solve", str(path), "--steps", "--json"]) == 0
    lines = json.loads(capsys.readouterr().out)["steps"]
    told = {line["settles"]: line for line in lines}
    assert {"steps", *(f"steps[].{key}" for line in lines for key in line)} == {
        key for key in KEYS if key.startswith("steps")}
    assert [line["number"] for line in lines] == [*range(1, 8), *range(7, 9), *range(8, 14), *range(13, 17)]
    assert told["J_O"]["value"] == pytest.approx(0.64) and told["J_O"]["unit"] == "kg·m²"
    assert told["N_s"]["expression"] == "-m*g/2" and told["N_s"]["value"] == pytest.approx(-14.715)
    assert told["zeta[1]"]["uses"] == [13, 14]
    assert all(use < line["number"] for line in lines for use in line["uses"])
    p = vibcli.load(path)
    for quantity in ("omega[1]", "zeta[1]", "omega_d[1]"):
        assert told[quantity]["value"] == pytest.approx(p[quantity].value, rel=1e-13)


@pytest.mark.parametrize("options", [["--insight"], ["--normalise", "largest"], ["--json", "--digits", "20"]])
def test_what_lines_do_not_tell_is_no_option_beside_them(tmp_path, capsys, options):
    path = tmp_path / "rod.yaml"
    path.write_text(ROD)
    assert run(["solve", str(path), "--steps", *options]) == 2
    assert "exclude each other" in capsys.readouterr().err


@cache
def kept_lines(path):
    """The lines of a problem, for all tests of a process."""
    return worked(kept_problem_of(path))


def test_what_is_alike_is_told_once():
    """Two springs of one stretch have one tension; a body at the mass centre of another has its speed; no letter stands
    for a coefficient that no line needs."""
    told = [formula(line.parts, plain).replace("\u00a0", " ") for line in worked(problem("""
parameters: {m: 2 kg, M: 3 kg, k: 4 kN/m, b: 1 m, g: 10 m/s^2}
gravity: g
bodies:
  rod: {shape: rod, mass: M, from: [0, 0], to: [2*b, 0], pin: {at: [0, 0], by: phi}}
  plate: {shape: rod, mass: M, from: [2*b, 0], to: [3*b, b], pin: {at: [2*b, 0], carrier: rod, by: 0}}
  load: {mass: m, at: [5*b/2, b/2], weld: plate}
points: {P: {body: rod, at: [b, 0]}}
springs: {s: {k: k, between: [[b, 2*b], P]}, r: {k: k, between: [[b, 2*b], P]}}
"""))]
    for wanted in ("r, like s:  V_r = V_s", "load is at the mass centre of plate:  v_load = v_plate"):
        assert any(wanted in line for line in told), told
    assert not any("N_r" in line for line in told) and any("N_s" in line for line in told)
    letters = {letter for line in told for letter in re.findall("b[₀-₉]+", line) if f"{letter} = " in line}
    assert letters and all(sum(line.count(letter) for line in told) > 1 for letter in letters), told


def test_a_wrong_line_is_seen():
    checked = Checked(problem(ROD))
    before = checked.count
    line = checked.lines[2]
    head, equal, middle, again, node = line.parts
    checked.each(line._replace(parts=(head, equal, middle, again, node * 2)))
    assert checked.count > before and checked.wrong and checked.wrong[0][0] == 3


@pytest.mark.sweep
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_every_equality_holds(path):
    found = kept_problem_of(path)
    if found.spec.choices:
        pytest.skip("its parameters are chosen")
    try:
        checked = Checked(found, kept_lines(path))
    except PhysicsError as refusal:
        pytest.skip(refusal.message)
    scene = found.scene
    assert not checked.wrong and (scene.pieces or not told_later(found, checked.lines))
    if not scene.pieces:
        signals = {one.number for one in checked.lines if one.settles.startswith("amplitude(")}
        assert checked.lines[-1].number - len(signals) <= MOST.get(len(scene.q), math.inf)
    last = [one.parts[-1] for one in checked.lines if one.parts]
    assert not any(isinstance(part, Words) and part.text.rstrip().endswith(":") for part in last)
    searched = any(one.value is not None and one.node is None for one in checked.lines)
    assert checked.count or searched or scene.laws or found.spec.get("energies") or scene.timed or scene.matrices
    assert not faults(Document(path.stem, None, (), section_of(checked.lines)), FORMATS)


@pytest.mark.parametrize(("more", "words"), [
    ("c: 10 N*s/m", "ζ = δ/ω = 5·c/√(m·k) = 1: critically damped"), ("c: 9 N*s/m", "0.9 < 1: under-damped"),
    ("c: 11 N*s/m", "1.1 > 1: over-damped")])
def test_regimes_of_damping(more, words):
    scene = problem("parameters: {m: 1 kg, k: 2500 N/m, " + more + "}\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}}\ndampers: {d: {c: 10*c, between: [ground, b]}}\n")
    told = [formula(line.parts, plain) for line in worked(scene)]
    assert any(words in line for line in told)
    assert any("ω_d" in line for line in told) is ("under" in words)


def test_constants_of_a_free_motion_are_those_of_the_motion(tmp_path):
    path = tmp_path / "rod.yaml"
    path.write_text(ROD + "initial: {phi: 3 deg, phi': 0.4 rad/s}\n")
    p = vibcli.load(path)
    told = formula({line.settles: line for line in worked(p._problem)}["free motion"].parts, plain)
    A, B = (float(text) for text in re.findall(r"= (-?[\d.]+) rad", told.partition(":  ")[2]))
    delta, omega_d = 5.0, p["omega_d[1]"].value
    for t in (0.01, 0.1):
        motion = math.exp(-delta * t) * (A * math.cos(omega_d * t) + B * math.sin(omega_d * t))
        assert p[f"phi({t} s)"].value == pytest.approx(motion, rel=1e-5)


def test_steady_amplitude_is_that_of_the_motion(tmp_path):
    path = tmp_path / "rod.yaml"
    path.write_text(ROD.replace("m: 3 kg", "m: 3 kg, F: 5 N, Omega: 20 rad/s")
                    + "forces: {drive: {at: B, force: [0, F*sin(Omega*t)]}}\n")
    p = vibcli.load(path)
    lines = {line.settles: line for line in worked(p._problem)}
    assert lines["amplitude(phi)"].value == pytest.approx(p["amplitude(phi)"].value, rel=1e-12)
    assert lines["tan theta"].value == pytest.approx(math.tan(p["phase(phi)"].value), rel=1e-12)


CHAIN = "parameters: {m: 1 kg, k: 9 N/m}\nbodies: {" + ", ".join(
    f"b{i}: {{mass: m, slide: x{i}}}" for i in range(13)) + "}\nsprings: {" + ", ".join(
    f"s{i}: {{k: k, between: [b{i}, ground]}}" for i in range(13)) + "}\n"


@pytest.mark.parametrize(("text", "reason"), [
    (CHAIN, "up to 12 coordinates"),
    ("parameters: {J: 1 kg*m^2, Omega: 9 rad/s}\nbodies: {b: {inertia: J, turn: Omega*t}}\n", "nothing moves freely")])
def test_what_has_no_steps(text, reason):
    with pytest.raises(PhysicsError, match=reason):
        worked(problem(text))


def test_a_bead_in_a_rod_that_turns():
    """K is k − mΩ², its centrifugal part the energy without speeds; one that rocks has no such K."""
    turning = """
parameters: {m: , k: , Omega: , L: }
bodies:
  rod: {at: [0, 0], pin: {at: [0, 0], by: Omega*t}}
  bead: {mass: m, at: [L, 0], slide: {along: [1, 0], by: x, carrier: rod}}
springs: {s: {k: k, between: [[0, 0], bead], preload: static}}
"""
    told = [formula(line.parts, plain) for line in worked(problem(turning))]
    assert any("V0_bead = −m·Ω²·L·x − m·Ω²·x²/2 + …" in line for line in told), told
    assert any("m·ẍ + (k − m·Ω²)·x = 0" in line for line in told), told
    rocks = worked(problem(turning.replace("Omega*t", "0.1*sin(Omega*t)").replace("Omega: ,", "Omega: 9 rad/s,")))
    assert rocks[-1].settles == "motion[x]"


def test_a_shaken_support():
    text = """
parameters: {m: , k: , c: , Y: , Omega: }
points: {S: {at: [0, 1 m], moves: [0, Y*sin(Omega*t)]}}
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [b, S]}}
dampers: {d: {c: c, between: [b, S]}}
"""
    told = [formula(line.parts, plain) for line in worked(problem(text))]
    assert any("Δ = Y·sin(Ω·t) − y" in line for line in told), told
    assert any("∂V/∂y = k·y − k·Y·sin(Ω·t),  ∂Φ/∂ẏ = c·ẏ − c·Y·Ω·cos(Ω·t)" in line for line in told), told
    assert any("m·ÿ + c·ẏ + k·y = k·Y·sin(Ω·t) + c·Y·Ω·cos(Ω·t)" in line for line in told), told


def test_what_is_driven_is_held_against_the_equations(monkeypatch):
    """A stretch without what drives it is not told; nor is a speed without it, in any motion."""
    from vibcli.report.steps.in_motion import InMotion
    from vibcli.report.steps.small import AboutRest

    shaken = """
parameters: {m: , k: , Y: , Omega: }
points: {S: {at: [0, 1 m], moves: [0, Y*sin(Omega*t)]}}
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [b, S]}}
"""
    monkeypatch.setattr(AboutRest, "moves", lambda self, small: self.first(small, self.scene.q))
    told = [formula(line.parts, plain) for line in worked(problem(shaken))]
    assert any("stretch of s:  Δ = Y·sin(Ω·t) − y" in line for line in told), told
    assert not any("Δ = −y" in line for line in told)
    monkeypatch.setattr(InMotion, "rate", lambda self, s: 2 * self.scene.rate(s.s))
    with pytest.raises(PhysicsError, match="not told apart"):
        worked(problem(shaken))


@pytest.mark.sweep
def test_no_small_oscillations_where_the_engine_has_none():
    """Where forces have a kink at rest, or nothing holds the scene; elsewhere its frequencies are those of the
    engine."""
    kinked, compared = set(), 0
    for path in PROBLEMS:
        scene = kept_problem_of(path)
        try:
            found = {line.settles: line.value for line in kept_lines(path)}
        except PhysicsError:
            continue
        refused = scene.scene.q and scene.symbolic.equations.refusal is not None
        if refused and not scene.numeric.has_free_symbols:
            kinked.add(path.stem)
            assert not any(name.startswith(("equation[", "omega[")) for name in found), path.stem
            continue
        told = {name: value for name, value in found.items() if re.fullmatch(r"omega\[\d+\]", name) and value
                and not scene.numeric.has_free_symbols}
        known = {f"omega[{mode.index}]": mode.omega for mode in scene.modal.modes} if told else {}
        compared += len(told)
        assert all(math.isclose(value, float(known[name]), rel_tol=1e-9) for name, value in told.items()), path.stem
    assert {"one_sided_springs", "crate_drawn_until_it_sticks"} <= kinked and compared > 200


FALL_BACK = {"pump_turned_by_a_motor", "bent_lever_in_balance", "double_atwood_from_rest", "matrices_outright",
             "two_wells", "rod_over_the_rim_of_a_bowl"}


@pytest.mark.sweep
def test_which_small_oscillations_are_not_told_apart():
    """All others go element by element, unless more is asked."""
    found = {path.stem for path in PROBLEMS if not asks_in_full(kept_problem_of(path)) and _in_full(path)}
    assert found == FALL_BACK


def _in_full(path):
    try:
        return any(line.settles.startswith("motion[") for line in kept_lines(path))
    except PhysicsError:
        return False


def test_a_force_like_a_spring_goes_by_the_full_equations():
    told = [formula(line.parts, plain) for line in worked(problem("""
parameters: {m: 1 kg, k: 9 N/m}
bodies: {b: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, between: [[-1 m, 0], b]}}
forces: {f: {at: b, force: [-(k*x), 0]}}
"""))]
    assert any("Q = −k·x" in line for line in told) and any("m·ẍ + 2·k·x = 0" in line for line in told)


@pytest.mark.sweep
def test_energies_and_equations_are_told_unexpanded_where_they_are_asked():
    """A rod on a cart: T, Lagrange's derivatives, the equations, then small ones."""
    told = [formula(line.parts, plain) for line in worked(kept_problem_of(CART))]
    told = [line.replace("\u00a0", " ") for line in told]
    for wanted in ("v_rod² = ẋ² + L·cos φ·ẋ·φ̇ + L²·φ̇²/4,  ω_rod = φ̇",
                   "∂T/∂φ = −m·L·sin φ·ẋ·φ̇/2", "φ:  m·L·cos φ·ẍ/2 + m·L²·φ̈/3 + m·L·g·sin φ/2 = 0",
                   "from rest, to the first order:  φ:  m·L·ẍ/2 + m·L²·φ̈/3 + m·L·g·φ/2 = 0"):
        assert any(wanted in line for line in told), (wanted, told)


def test_new_letters_never_meet_those_of_the_scene():
    text = ROD.replace("m: 3 kg", "N_s: 3 kg").replace("mass: m", "mass: N_s").replace("L", "omega")
    told = [formula(line.parts, plain) for line in worked(problem(text))]
    assert any("N_s′ = −N_s·g/2" in line for line in told) and any("ω′ = √" in line for line in told)


@pytest.mark.parametrize("taken", ["T", "V", "Phi", "f", "J_O", "delta", "zeta", "omega_d", "Delta_s"])
def test_no_letter_of_the_steps_is_one_of_the_scene(taken):
    """A mass of that name stays what it is; the letter of the lines has a prime."""
    lines = worked(problem(ROD.replace("m: 3 kg", f"{taken}: 3 kg").replace("mass: m", f"mass: {taken}")))
    assert all(line.settles != taken for line in lines)
    letter = plain.symbol(taken)
    assert not any(formula(line.parts, plain).startswith(f"{letter} = ") for line in lines)
    assert any("′" in formula(line.parts, plain) for line in lines)


def test_names_of_matrices_are_none_of_the_scene():
    told = [formula(line.parts, plain) for line in worked(problem("""
parameters: {M: , K: }
bodies: {a: {mass: M, slide: x}, b: {mass: M, slide: y}}
springs: {l: {k: K, between: [ground, a]}, m: {k: K, between: [a, b]}}
"""))]
    assert any("det(S − ω²·D)" in line for line in told) and any("D = [M, 0; 0, M]" in line for line in told)


def test_places_are_counted_from_rest_where_it_is_not_as_drawn():
    """A mass hung on a spring drawn without tension: y from where it comes to rest, stretch and place counted so."""
    told = [formula(line.parts, plain) for line in worked(problem("""
parameters: {m: 2 kg, k: 400 N/m, l: 1 m, g: 10 m/s^2}
gravity: g
bodies: {b: {mass: m, at: [0, -l], slide: {along: [0, -1], by: y}}}
springs: {s: {k: k, between: [[0, 0], b]}}
"""))]
    assert any("the forces balance at  y = m·g/k = 0.05" in line for line in told), told
    assert any("Δ_s = y" in line and "…" not in line for line in told), told


def test_forces_that_nothing_asks_for_are_not_found(monkeypatch):
    """Of what supports exert nothing is derived where no answer names it."""
    def derived(*_):
        raise AssertionError("nothing asks for a force")

    monkeypatch.setattr("vibcli.report.steps.reactions._forces", derived)
    monkeypatch.setattr("vibcli.report.steps.reactions._along", derived)
    assert worked(problem(ROD + 'answers: {"omega[1]": 1 rad/s}'))
    with pytest.raises(AssertionError, match="nothing asks"):
        worked(problem(ROD + "find: [frequencies, reactions]"))


def test_a_factor_that_a_sheet_asks_for_is_told():
    asked = ROD.rstrip() + """
answers: {"omega[1]": 1 rad/s}
variants: {parameters: {k: [1 kN/m, 1.2 kN/m]}, ask: {"M[phi,phi]": , "K[phi,phi]": , "omega[1]": }}
"""
    told = {line.settles: line for line in worked(problem(asked))}
    assert told["M[phi,phi]"].value == pytest.approx(3 * 0.8**2 / 3) and told["M[phi,phi]"].unit == "kg·m²"
    assert told["K[phi,phi]"].value == pytest.approx(1200 * 0.8**2) and told["K[phi,phi]"].unit == "N·m/rad"
    assert not {"M[phi,phi]", "K[phi,phi]"} & {line.settles for line in worked(problem(ROD))}


@pytest.mark.sweep
def test_lines_hang_on_no_addresses():
    """Nodes are told apart by where they lie in memory: what is read again lies elsewhere, and is written alike."""
    path = "problems/1_statics_and_energy/plate_with_offset_hole.yaml"
    read = [problem(Path(path).read_text(encoding="utf-8")) for _ in range(6)]
    assert len({"\n".join(formula(one.parts, plain) for one in worked(scene)) for scene in read}) == 1


@pytest.mark.parametrize(("more", "words"), [
    ("", "λ = 0 1/s, a double root"), ("g: {c: c, between: [ground, a]}", "λ = 0 1/s")])
def test_a_root_at_zero_is_told_as_often_as_it_is_one(more, words):
    """Two wagons that nothing holds: λ² comes out of the determinant; one λ where a dashpot leads to the ground."""
    found = problem(f"""
parameters: {{m: 2 kg, k: 300 N/m, c: 8 N*s/m}}
bodies: {{a: {{mass: m, slide: x}}, b: {{mass: 2*m, slide: y}}}}
springs: {{s: {{k: k, between: [a, b]}}}}
dampers: {{d: {{c: c, between: [a, b]}}{", " + more if more else ""}}}
""")
    lines = [formula(line.parts, plain) for line in worked(found)]
    assert [line for line in lines if line.startswith("λ = 0")] == [words]


def test_a_plate_with_a_hole_is_told_by_its_parts():
    """J_O of the plate less that of the hole, each with its own J and its parallel axis."""
    found = problem("""
parameters: {rho: , a: , b: , r: , c: , g: }
gravity: g
bodies:
  plate:
    parts:
      - {shape: rectangle, density: rho, width: a, height: b, at: [0, -b/2]}
      - {shape: disc, density: rho, radius: r, at: [0, -c], cut: true}
    pin: {at: [0, 0], by: phi}
""")
    lines = [formula(line.parts, plain) for line in worked(found)]
    told = next(line for line in lines if "J_O = " in line)
    assert "J_O = ρ·a·b·(a² + b²)/12 + ρ·a·b³/4 − π·ρ·r⁴/2 − π·ρ·r²·c² = " in told


def test_what_constraints_leave_is_told_in_its_simplest_form():
    found = kept_problem_of(Path("problems/1_statics_and_energy/differential_hoist.yaml"))
    (told,) = tied(found.scene)
    text = running(told.parts)
    assert "ψ = φ" in text and "y = −(r − R)·φ/2" in text


def test_the_kinetic_energy_of_a_plate_with_a_hole_divides_by_no_mass():
    found = kept_problem_of(Path("problems/1_statics_and_energy/plate_with_offset_hole.yaml"))
    assert plain(found.symbolic.energies["T"]) == "ρ·(a·b·(a² + 4·b²) − 6·π·r²·(r² + 2·c² + 2·d²))·φ̇²/24"
    assert len(plain(found.symbolic.equations.full[0])) < 130
