"""Faults that are planted: each is found by the counter, the family or the verdict that is there for it."""

import re
from functools import partial
from pathlib import Path

import pytest
from support.counted import counters, differences

from vibcli.check.tolerance import SHORT, digits_written, half_a_unit
from vibcli.check.verdicts import verdicts_of
from vibcli.evidence.stress import point
from vibcli.evidence.stress.read_again import read_again, replaced
from vibcli.evidence.stress.rewritten import with_numbers
from vibcli.language.document.document import read_file

PROBLEMS = Path(__file__).resolve().parents[3] / "problems"
BEAD = str(PROBLEMS / "2_lagrange" / "bead_on_swinging_rod.yaml")
BOOM = str(PROBLEMS / "4_free_damped" / "sagging_boom.yaml")
DOUBLED = """
from vibcli.mechanics.equilibrium.energy_descent import EnergyDescent
once = EnergyDescent.newton
EnergyDescent.newton = lambda *args: (once(*args), once(*args))[1]
"""
TIGHT = ("buckling", "1e-5"), ("damped_chain", "1e6"), ("double_eigenvalue", "1e-8"), ("gyroscopic", "1e1"), (
    "long_times", "1e10"), ("sharp_peak", "1e-11")


@pytest.mark.sweep
def test_a_doubled_loop_is_found_by_a_counter():
    before, now = counters(BOOM), counters(BOOM, DOUBLED)
    found = differences({"one": before}, {"one": now})
    assert any(line.startswith("one: Newton's methods") for line in found)
    assert now["Newton's methods"] > before["Newton's methods"] and now["exit"] == before["exit"] == 0


@pytest.mark.sweep
def test_an_extra_import_is_found_by_a_counter():
    before, now = (counters(BEAD, planted) for planted in ("", "import vibcli.plots.figure"))
    assert differences({"one": before}, {"one": now}) == [f"one: modules {before['modules']} → {now['modules']}"]
    assert now["modules"] > before["modules"]


@pytest.mark.parametrize(("name", "knob"), TIGHT)
def test_a_bound_ten_times_too_small_is_found_by_a_family(name, knob, monkeypatch):
    from rooms.evidence.test_stress import family

    claims = point.claims
    assert point.measured(family(name), knob).verdict in (point.HELD, point.ESCALATED)
    monkeypatch.setattr(point, "claims", lambda *args: [one._replace(bound=one.bound / 10) for one in claims(*args)])
    assert point.measured(family(name), knob).verdict == point.BROKEN


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["5_forced/press_with_two_blows", "8_continuous/mast_on_a_cart",
                                  "9_equivalents_and_corrections/particle_that_sags_between_oblique_duffing_springs"])
def test_an_answer_off_by_a_unit_of_its_last_digit_differs(name):
    file = str(PROBLEMS / f"{name}.yaml")
    node, diagnostics, _ = read_file(file)
    top, remade = read_again(node, file, {}, None)
    tried = 0
    for asked, (_, expected) in top.entries["answers"][1].entries.items():
        if not re.match(r"-?\d*\.?\d+ ", expected.text) or digits_written(expected.text) < SHORT:
            continue
        for sense in (-2, 2):
            off = partial(_off, sense=sense)
            problem = remade(lambda top, off=off, asked=asked: replaced(top, "answers", lambda answers: replaced(
                answers, asked, lambda value: with_numbers(value, off))))
            wrong = [one.answer.asked.text for one in verdicts_of(problem, problem.spec.answers) if one.agrees is False]
            assert wrong == [asked]
            tried += 1
    assert not diagnostics and tried


def _off(number, text, sense):
    places = len(re.search(r"\.?(\d*) ", text).group(1)) if "." in text else 0
    return f"{float(number.value) + sense * half_a_unit(text):.{places}f}"
