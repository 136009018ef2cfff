"""What each question takes and skips, as it is found by asking."""

import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.bench import scenes
from vibcli.cli.program import run
from vibcli.evidence import skipped
from vibcli.evidence.stages import stage_costs
from vibcli.results.stages import STAGES

ALWAYS = {"read", "spec", "scene", "linearisation", "equilibrium"}
MODAL = {"linear_system", "modes", "damped"}
TAKEN = {       # of a driven damped mass, in numbers
    "solve": ALWAYS | MODAL, "equations": ALWAYS | {"linear_system", "energies", "equations"},
    "solve --insight": ALWAYS | MODAL | {"shares", "sensitivities", "estimates"},
    "solve --steps": ALWAYS | {"linear_system", "modes"},     # what answers ask of the motion ends it
    "frequencies": ALWAYS | MODAL | {"closed_forms"}, "frequencies --digits 30": ALWAYS | MODAL | {"closed_forms"},
    "response": ALWAYS | MODAL, "frf": ALWAYS | {"linear_system"}, "check": set()}


@pytest.fixture(scope="module")
def found():
    return skipped.every_question(skipped.example())


@pytest.mark.sweep
@pytest.mark.parametrize("question", skipped.QUESTIONS)
def test_stages_that_a_question_takes_are_those_that_it_needs(found, question):
    one = found[question]
    assert {stage for stage, taken in one.stages.items() if taken} == TAKEN[question]
    assert set(one.stages) in (set(), {"read", "spec", *STAGES})


@pytest.mark.parametrize("question", skipped.QUESTIONS)
def test_packages_that_a_question_imports(found, question):
    digits = {"mpmath"} if question in ("solve --insight", "frequencies --digits 30") else set()
    assert set(found[question].packages) == ({"numpy"} | digits if question != "equations" else set())
    assert not {"drawing", "plots", "bench", "evidence", "inverse"} & set(found[question].rooms)
    assert ("homework" in found[question].rooms) == (question == "check")      # what its sets of problems are named
    assert ("report" in found[question].rooms) == (question != "check")


def test_both_tables_are_told(found):
    stages, modules = skipped.document(found).sections
    table = stages.blocks[0]
    assert table.head == ("stage", *skipped.QUESTIONS) and table.head[-2:] == ("frf", "check")
    assert [row[-2:] for row in table.rows[:2]] == [("•", "?")] * 2
    assert {row[0]: row[-2] for row in table.rows}["modes"] == ""
    assert modules.blocks[0].rows[-1][0] == "modules of its own"
    assert skipped.data(found)["check"]["stages"] is None


@pytest.mark.sweep
def test_a_question_that_fails_is_told():
    with pytest.raises(RuntimeError, match="leaves with 2"):
        skipped.taken("solve", "no such file.yaml")


@pytest.mark.sweep
def test_a_question_that_a_scene_refuses_is_told_and_a_wrong_answer_is_an_answer(tmp_path):
    path = tmp_path / "wrong.yaml"
    path.write_text("bodies: {a: {mass: 1 kg, slide: x}}\nsprings: {s: {law: (4 N/m^3)*d^3, between: [ground, a]}}\n"
                    "answers: {'K[x,x]': 4 N/m}\n", encoding="utf-8")
    found = {question: skipped.taken(question, str(path)) for question in ("check", "response")}
    assert found["check"].modules > 50 and not found["check"].refused
    said = found["response"].refused
    assert said.startswith("'s' has a nonlinear law") and not found["response"].stages
    assert f"response: {said}" in str(skipped.document(found).sections[0])
    path.write_text("bodies: {a: {mas: 1 kg}}\n", encoding="utf-8")
    assert run(["bench", str(path), "--skipped"]) == 3


def test_what_is_skipped_would_have_a_cost():
    problem = problem_of(text_source(scenes.TWO_DRIVEN))
    found = {one.stage: one for one in stage_costs(problem, {"modes"})}
    assert set(found) == set(STAGES)
    assert {stage for stage, one in found.items() if one.taken} == (ALWAYS | MODAL) - {"read", "spec"}
    assert found["energies"].seconds > 0 and not found["energies"].taken and "no shapes" in found["ritz"].why
    many = {one.stage: one for one in stage_costs(problem_of(text_source(scenes.chain(5))), {"modes"})}
    assert many["closed_forms"].why == many["equilibria"].why == (
        "not measured: of members and of more than 3 coordinates they may take minutes")


@pytest.mark.sweep
@pytest.mark.parametrize("scene", [
    "beams: {b: {length: L, EI: 20 N*m^2, mass_per_length: 1 kg/m, left: clamped}}",
    "beams: {b: {length: L, EI: 20 N*m^2, mass_per_length: 1 kg/m, left: clamped, right: {clamped: a}}}\n"
    "bodies: {a: {mass: 1 kg, slide: y}}"])
def test_stages_of_members_have_a_cost_or_none_that_is_found(scene):
    problem = problem_of(text_source("parameters: {L: 1 m}\n" + scene))
    assert [one.stage for one in stage_costs(problem, {"modes"})] == list(STAGES)


def test_motions_by_their_amplitude_take_no_motion_in_time():
    problem = problem_of(text_source("bodies: {a: {mass: 2 kg, slide: x}}\nsprings: {s: {law: 'd*(8 N/m) + "
                                     "d^3*(5 N/m^3)', between: [ground, a]}}"))
    assert [one.stage for one in stage_costs(problem, {"full motion"})] == list(STAGES)
