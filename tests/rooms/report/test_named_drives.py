"""Displacements in time have symbols of their own where energies are long for them."""

from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

from vibcli.api.reports import report, solution
from vibcli.notation.plain import plain
from vibcli.report.formats import text
from vibcli.report.sections.named_drives import named_drives

BUMP, = Path("problems").glob("*/car_over_a_bump_with_both_axles.yaml")
ONE = """
parameters: {m: 2 kg, k: 800 N/m, H: 0.5 m, Y: 1 cm, w: 3 rad/s}
points: {S: {at: [0, -H], moves: [0, Y*sin(w*t)]}}
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [S, b]}}
"""


def test_a_bump_is_named():
    """No step stands in an energy, nor the square of one anywhere; each symbol is told once."""
    found = kept_problem_of(BUMP)
    drives = named_drives(found)
    assert [plain(node) for _, node in drives.stands] == [
        "h·(step(t) − step(t − t₁))·sin(π·t/t₁)", "−h·(step(t − t₂) − step(t − t₁ − t₂))·sin(π·(t₂ − t)/t₁)"]
    for key, most in (("V", 600), ("Phi", 3000)):
        written = plain(drives.energy(key))
        assert "step" not in written and "u₁" in written and len(written) < most < len(
            plain(found.symbolic.energies[key])), written
    told = text.render([report(found, solution(found)).document()], None)
    energies = told[told.index("Potential energy"):told.index("Equations of motion")]
    assert energies.count("u₁ = ") == energies.count("u₂ = ") == 1 and "step(t)²" not in told
    assert "ℓ₃" not in told


def test_an_energy_that_is_not_the_same_keeps_its_form(monkeypatch):
    import vibcli.report.steps.small as small

    found = kept_problem_of(BUMP)
    monkeypatch.setattr(small, "agree_in_motion", lambda *_: False)
    assert named_drives(found).energy("V") is found.symbolic.energies["V"]


@pytest.mark.parametrize("scene", [ONE, ONE.replace("moves: [0, Y*sin(w*t)]", "moves: [0, Y*w*t]")])
def test_short_energies_have_no_symbols(scene):
    assert named_drives(problem(scene)) is None


def test_the_symbols_meet_no_name_of_the_scene():
    renamed = BUMP.read_text().replace("k1", "u1")
    assert [plain(symbol) for symbol, _ in named_drives(problem(renamed)).stands] == ["s₁", "s₂"]
    for letter in ("s1", "w1", "xi1"):
        renamed = renamed.replace("parameters:\n", f"parameters:\n  {letter}: {{value: 1, unused: allowed}}\n")
    assert named_drives(problem(renamed)) is None
