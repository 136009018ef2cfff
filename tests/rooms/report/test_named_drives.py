"""Displacements in time have symbols of their own where energies are long for them."""

import math
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

from vibcli.api.reports import report, solution
from vibcli.notation.plain import plain
from vibcli.report.formats import text
from vibcli.report.sections.named_drives import named_drives
from vibcli.symbolic.evaluation import Floats, evaluate

BUMP, = Path("problems").glob("*/car_over_a_bump_with_both_axles.yaml")
ONE = """
parameters: {m: 2 kg, k: 800 N/m, H: 0.5 m, Y: 1 cm, w: 3 rad/s}
points: {S: {at: [0, -H], moves: [0, Y*sin(w*t)]}}
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [S, b]}}
"""


@pytest.mark.sweep
def test_a_bump_is_named():
    """No step stands in an energy, nor the square of one anywhere; each symbol is told once."""
    found = kept_problem_of(BUMP)
    drives = named_drives(found)
    assert [plain(node) for _, node in drives.stands] == [
        "h·(step(t) − step(t − t₁))·sin(π·t/t₁)", "h·(step(t − t₂) − step(t − t₁ − t₂))·sin(π·(t − t₂)/t₁)"]
    for key, most in (("V", 600), ("Phi", 1500)):
        written = plain(drives.energy(key))
        assert "step" not in written and "u₁" in written and len(written) < most < len(
            plain(found.symbolic.energies[key])), written
    told = text.render([report(found, solution(found)).document()], None)
    energies = told[told.index("Potential energy"):told.index("Equations of motion")]
    assert energies.count("u₁ = ") == energies.count("u₂ = ") == 1 and "step(t)²" not in told
    assert "ℓ₃" not in told and "characters" not in told


@pytest.mark.sweep
def test_the_equations_of_a_bump_have_its_symbols():
    """Full ones as they come from the energies; small ones k₁u₁ + c₁u̇₁ and so on, with the engine's numbers."""
    found = kept_problem_of(BUMP)
    told = text.render([report(found, solution(found)).document()], None)
    full = told[told.index("Equations of motion"):told.index("Small oscillations")]
    assert "(y + a·sin φ − u₁ + H)" in full and "step" not in full and len(full) < 2500
    small = told[told.index("Small oscillations"):told.index("Matrices")]
    assert "= c₁·u̇₁ + c₂·u̇₂ + k₁·u₁ +\n      k₂·u₂\n" in small and "step" not in small
    assert "72000·y − 5400·φ = 38000·u₁ + 2600·u̇₁ + 34000·u₂ + 2300·u̇₂\n" in small
    assert "131220·φ = 45600·u₁ + 3120·u̇₁ − 51000·u₂ − 3450·u̇₂\n" in small


@pytest.mark.sweep
def test_small_and_full_equations_are_those_of_the_engine_during_the_bump():
    """At instants while each axle is on the bump, with symbols put in by hand."""
    found = kept_problem_of(BUMP)
    drives, floats = named_drives(found), found.numeric.floats
    t1, t2, h = floats["L"] / floats["v"], (floats["a"] + floats["b"]) / floats["v"], floats["h"]
    for t in (0.4 * t1, t2 + 0.7 * t1):
        angle, begins = math.pi / t1, 0.0 if t < t1 else t2
        u, rate = h * math.sin(angle * (t - begins)), h * angle * math.cos(angle * (t - begins))
        known = {"u1": u, "u1'": rate, "u2": 0.0, "u2'": 0.0} if t < t1 else {
            "u1": 0.0, "u1'": 0.0, "u2": u, "u2'": rate}
        state = {"y": 0.02, "phi": -0.03, "y'": 0.4, "phi'": 0.3, "y''": 1.1, "phi''": -0.7, "t": t}
        for i, full in enumerate(found.symbolic.equations.full):
            mine, whole = evaluate([drives.equation(i), full], Floats, {**floats, **known, **state})
            assert mine == pytest.approx(whole, rel=1e-9)
            drive = found.symbolic.equations.drive[i]
            whole, = evaluate([drive], Floats, {**floats, "t": t})
            factors = evaluate([factor for factor, _ in drives.drive(i, drive)], Floats, floats)
            told = [symbol.name for _, symbol in drives.drive(i, drive)]
            assert sum(c * known[name] for c, name in zip(factors, told, strict=True)) == pytest.approx(whole, rel=1e-9)


def test_an_energy_that_is_not_the_same_keeps_its_form(monkeypatch):
    import vibcli.report.steps.agreement as agreement

    found = kept_problem_of(BUMP)
    monkeypatch.setattr(agreement, "agree_in_motion", lambda *_: False)
    assert named_drives(found).energy("V") is found.symbolic.energies["V"]


@pytest.mark.parametrize("scene", [ONE, ONE.replace("moves: [0, Y*sin(w*t)]", "moves: [0, Y*w*t]")])
def test_short_energies_have_no_symbols(scene):
    assert named_drives(problem(scene)) is None


@pytest.mark.sweep
def test_the_symbols_meet_no_name_of_the_scene():
    renamed = BUMP.read_text().replace("k1", "u1")
    assert [plain(symbol) for symbol, _ in named_drives(problem(renamed)).stands] == ["s₁", "s₂"]
    for letter in ("s1", "w1", "xi1"):
        renamed = renamed.replace("parameters:\n", f"parameters:\n  {letter}: {{value: 1, unused: allowed}}\n")
    assert named_drives(problem(renamed)) is None


ROCKER = """
parameters: {m: 2 kg, R: 0.2 m, al: 1 rad, Y: 2 mm, W: 5 rad/s, c: 0.3 N*s/m}
surfaces: {table: {line: [[-1 m, 0], [1 m, 0]], body: plank}}
bodies:
  plank: {mass: 1 kg, at: [0, -0.02 m], slide: Y*sin(W*t)}
  half: {shape: sector, mass: m, radius: R, half_angle: al, angle: -pi/2, at: [0, R],
    roll: {surface: table, turn: phi}}
  bob: {mass: 0.1 kg, at: [0, R + 0.05 m], weld: half}
points: {T: {body: half, at: [0, R + 0.05 m]}}
dampers: {d: {c: c, between: [[-1 m, R + 0.05 m], T]}}
"""


def test_what_rolls_on_a_shaken_plank_feels_the_acceleration_of_its_symbol():
    """ü₁ = −W²Y sin Wt stands in the equation, which has the engine's value at a state of motion."""
    found = problem(ROCKER)
    drives, floats = named_drives(found), found.numeric.floats
    told = drives.equation(0)
    assert "ü₁" in plain(told)
    t = 0.37
    Y, W = floats["Y"], floats["W"]
    state = {**floats, "phi": 0.3, "phi'": -0.7, "phi''": 1.9, "t": t}
    known = {"u1": Y * math.sin(W * t), "u1'": W * Y * math.cos(W * t), "u1''": -W**2 * Y * math.sin(W * t)}
    mine, = evaluate([told], Floats, {**state, **known})
    engine, = evaluate([found.symbolic.equations.full[0]], Floats, state)
    assert mine == pytest.approx(engine, rel=1e-12)
