"""Words of sheets: what the figure shows is named as it does, and numbers keep their units."""

from pathlib import Path

import pytest
from support.scenes import kept_problem_of

from vibcli.homework.wording import question_in_words, signal_in_words
from vibcli.notation.as_printed import as_printed
from vibcli.report.blocks import Document
from vibcli.report.document import Report
from vibcli.report.formats import html, typst

PROBLEMS = Path(__file__).parents[3] / "problems"


@pytest.mark.parametrize("path, signal, words", [
    ("5_forced/accelerometer_on_a_casing", "s.stretch", "the stretch of the spring k"),
    ("7_forced_two_degrees/inerter_under_a_machine", "i.force", "the force of the inerter b"),
    ("7_forced_two_degrees/inerter_under_a_machine", "ground.force", "the force on the ground"),
    ("5_forced/torsiograph_on_a_shaft", "theta", "θ"), ("5_forced/torsiograph_on_a_shaft", "theta'", "theta'")])
def test_signals_are_named_as_in_the_figure(path, signal, words):
    assert signal_in_words(kept_problem_of(str(PROBLEMS / f"{path}.yaml")).spec, signal) == words


def test_letters_of_a_question_are_greek_and_its_values_unbroken():
    problem = kept_problem_of(str(PROBLEMS / "5_forced" / "accelerometer_on_a_casing.yaml"))
    whole = Report(problem).document().question
    found = question_in_words(problem.spec, whole)
    assert len(found) == len(whole) and "Y sin(Ω t), Y = " in "".join(found) and "Omega" not in "".join(found)
    values = [(one, other) for one, other in zip(whole, found, strict=True) if "\N{NO-BREAK SPACE}" in other]
    assert len(values) >= 4 and all(one == other.replace("\N{NO-BREAK SPACE}", " ") for one, other in values)


def test_what_is_unbroken_stays_so_in_print():
    assert typst.escaped("a film 0.05\N{NO-BREAK SPACE}N·s/m *") == "a film 0.05~N·s/m \\*"
    assert "0.05\N{NO-BREAK SPACE}N·s/m" in html.render([Document("a", None, ("0.05\N{NO-BREAK SPACE}N·s/m",), ())])


def test_micro():
    assert as_printed("um") == "µm" and as_printed("3 us") == "3 µs" and as_printed("2*us", ["us"]) == "2·us"
