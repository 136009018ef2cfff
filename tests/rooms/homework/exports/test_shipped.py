"""The problems that ship with variants, exported: the right answers of each system are those of `grade`, and so are the
mistakes that it names."""

import pytest
from support import course_systems
from support.exported import grades, on_disk, written
from support.shipped_variants import WITH_VARIANTS, kept_variants_of

from vibcli.homework.course import Course, CoursePart, CourseProblem
from vibcli.homework.exports import FORMATS
from vibcli.homework.exports.canvas import in_unit
from vibcli.homework.exports.item import BY_HAND, questions_of
from vibcli.homework.exports.setting import TEX, Remembering, html
from vibcli.homework.handout import Handout
from vibcli.notation.plain import Notation
from vibcli.report.formats.markdown import latex

SOME = 2        # variants: one whose lines are found, one that shares them


def exported(path):
    """(course, Handout) of some variants of a problem."""
    source, _, document, found = kept_variants_of(path)
    one = CourseProblem(path.stem, str(path))
    handout = Handout.of(one, found._replace(accepted=found.accepted[:SOME]), document, "\n".join(source.lines))
    return Course("Week 3", "", "", (CoursePart((one,), 1),)), handout


@pytest.mark.sweep
@pytest.mark.parametrize("path", WITH_VARIANTS, ids=lambda path: path.stem)
def test_a_problem_in_every_format(path, tmp_path):
    course, handout = exported(path)
    questions = sorted((one for number in handout.variants for one in questions_of(course, handout, number)),
                       key=lambda one: one.by_hand)
    keys = {one.item: dict(zip("abcdefgh", handout.data(one.variant - 1)["keys"], strict=False)) for one in questions}
    asked = {one.item for one in questions if not one.by_hand}
    assert len(questions) >= len(handout.variants) > 0 and len({one.item for one in questions}) == len(questions)
    for name in FORMATS:
        files = written(name, questions, course)
        read = getattr(course_systems, name)(files, *((on_disk(files, tmp_path),) * (name == "prairielearn")))
        assert set(read) == asked and not any(item.endswith(BY_HAND) for item in read)
        for one in (one for one in questions if not one.by_hand):
            for key in one.keys:
                scale = in_unit(one, key).value / key.value if name == "canvas" and key.value else 1.0
                assert_marked(read[one.item][key.letter], keys[one.item][key.letter], scale, name)


@pytest.mark.sweep
def test_expressions_that_variants_share_are_written_once(monkeypatch):
    _, handout = exported(next(path for path in WITH_VARIANTS if path.stem == "quarter_car_damped"))
    written, terms = [], Notation.terms
    monkeypatch.setattr(Notation, "terms", lambda self, node: written.append(node) or terms(self, node))
    counts, texts, solutions = [], [], [list(handout.solution(number)) for number in handout.variants]
    for solution in solutions:
        texts.append(html(solution, TEX))
        counts.append(len(written) - sum(counts))
    assert counts[0] >= 50 and max(counts[1:]) <= 0.2 * counts[0], counts
    monkeypatch.setattr("vibcli.homework.exports.setting.REMEMBERING", latex)
    assert not isinstance(latex, Remembering) and texts == [html(solution, TEX) for solution in solutions]


def assert_marked(field, key, scale, name):
    """Key, edges but for what Canvas rounds, and mistakes, of which two may give the same."""
    here = grades(key)
    assert field(repr(key["value"] * scale))[0] == "right"
    for wrong in key["mistakes"]:
        verdict, said = field(repr(wrong["value"] * scale))
        assert verdict == here(repr(wrong["value"]))[0] == "wrong"
        alike = {one["name"] for one in key["mistakes"] if abs(one["value"] - wrong["value"]) <= 1e-12 * abs(
            wrong["value"])}
        assert name == "canvas" or any(said.startswith(one) for one in alike), (said, alike)
