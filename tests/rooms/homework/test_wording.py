"""Words of sheets: what the figure shows is named as it does, and numbers keep their units."""

import re
from pathlib import Path

import pytest
from support.scenes import kept_problem_of
from support.shipped_variants import WITH_VARIANTS, kept_variants_of

from vibcli.homework.course import CourseProblem
from vibcli.homework.handout import Handout
from vibcli.homework.sheets import key_sheet
from vibcli.homework.wording import name_in_words, quantity_in_words, signal_in_words
from vibcli.notation.as_printed import as_printed
from vibcli.report.blocks import Document
from vibcli.report.document import Report
from vibcli.report.formats import html, typst
from vibcli.report.formats.text import running
from vibcli.symbolic.parser import parse

PROBLEMS = Path(__file__).parents[3] / "problems"


@pytest.mark.parametrize("path, signal, words", [
    ("5_forced/accelerometer_on_a_casing", "s.stretch", "the stretch of the spring k"),
    ("7_forced_two_degrees/inerter_under_a_machine", "i.force", "the force of the inerter b"),
    ("7_forced_two_degrees/inerter_under_a_machine", "ground.force", "the force on the ground"),
    ("5_forced/torsiograph_on_a_shaft", "theta", "θ"), ("5_forced/torsiograph_on_a_shaft", "theta'", "theta'")])
def test_signals_are_named_as_in_the_figure(path, signal, words):
    assert signal_in_words(kept_problem_of(str(PROBLEMS / f"{path}.yaml")).spec, signal) == words


@pytest.mark.parametrize("text, words, alone", [
    ("omega[2]", "natural angular frequency of mode 2", True),
    ("omega[2][1]", "natural angular frequency of mode 2", False),
    ("period_d[1]", "period of damped mode 1", True), ("eigenvalue[1]", "eigenvalue of damped mode 1", True),
    ("mode[2, theta]", "amplitude of θ in mode 2", True), ("theta(2 s)", "value of θ at 2 s", True),
    ("backbone[1](theta)(90 deg)",
     "angular frequency of the free motion of family 1 in which θ has the amplitude 90°", True),
    ("M[theta, theta]", "entry of the mass matrix", False), ("omega[1]/2", "this expression", False)])
def test_what_is_asked_in_words(text, words, alone):
    spec = kept_problem_of(str(PROBLEMS / "5_forced" / "torsiograph_on_a_shaft.yaml")).spec
    assert quantity_in_words(spec, parse(text), text) == (words, alone)


@pytest.mark.sweep
def test_a_key_tells_each_mistake_once_with_what_it_gives_in_each_answer():
    path = next(path for path in WITH_VARIANTS if path.stem == "bell_crank_dashpot")
    source, _, document, found = kept_variants_of(path)
    one = CourseProblem(path.stem, str(path))
    handout = Handout.of(one, found._replace(accepted=found.accepted[:1]), document, "\n".join(source.lines))
    keys, *_, mistakes = (section.blocks[0] for section in key_sheet(handout, 0).sections)
    rows = {row[0]: row[1:-1] for row in mistakes.rows}
    wrong = [{wrong.mistake: key.said(wrong.value) for wrong in key.wrong} for key in handout.variants[0].keys]
    assert [row[0] for row in keys.rows] == ["(a)", "(b)"] and mistakes.head[1:-1] == ("(a)", "(b)")
    assert len(rows) == len(mistakes.rows) == len(wrong[0] | wrong[1]) < len(wrong[0]) + len(wrong[1])
    assert all(rows[name] == tuple(own.get(name, "–") for own in wrong) for name in rows)
    assert mistakes.rows[list(rows).index("lever ratio once (s)")][-1].startswith("spring k: the ratio")


@pytest.mark.parametrize("name, words", [("theta", "θ"), ("spiral", "spring kt"), ("film", "damper ct"),
                                         ("ring", "ring"), ("ground", "ground")])
def test_what_a_mistake_concerns_is_named_as_in_the_figure(name, words):
    spec = kept_problem_of(str(PROBLEMS / "5_forced" / "torsiograph_on_a_shaft.yaml")).spec
    assert name_in_words(spec, name) == words


def test_letters_of_a_question_are_greek_and_its_values_unbroken():
    problem = kept_problem_of(str(PROBLEMS / "5_forced" / "accelerometer_on_a_casing.yaml"))
    found = Report(problem).document().question
    assert "Y sin(Ω t), Y = " in running(found) and "Omega" not in running(found)
    values = [part for part in found if "\N{NO-BREAK SPACE}" in running([part])]
    assert len(values) >= 4 and all(re.fullmatch(r"[\d.]+\N{NO-BREAK SPACE}\S+", value) for value in values)


def test_what_is_unbroken_stays_so_in_print():
    assert typst.escaped("a film 0.05\N{NO-BREAK SPACE}N·s/m *") == "a film 0.05~N·s/m \\*"
    assert "0.05\N{NO-BREAK SPACE}N·s/m" in html.render([Document("a", None, ("0.05\N{NO-BREAK SPACE}N·s/m",), ())])


def test_micro():
    assert as_printed("um") == "µm" and as_printed("3 us") == "3 µs" and as_printed("2*us", ["us"]) == "2·us"
