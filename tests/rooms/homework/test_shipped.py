"""The problems that ship with variants: some of each solved, held against fresh readings, by all gates."""

from pathlib import Path

import numpy as np
import pytest
from support.students import Students

from vibcli.api.source import file_source, problem_of
from vibcli.homework.bands import half_a_unit
from vibcli.homework.candidates import sampled
from vibcli.homework.course import course_of
from vibcli.homework.document import SceneDocument
from vibcli.homework.marks import is_within
from vibcli.homework.variants import solve_variants
from vibcli.homework.worked_variants import WorkedVariants
from vibcli.inverse import settled
from vibcli.report.blocks import Document
from vibcli.report.document import Report
from vibcli.report.formats.typst import render
from vibcli.report.sections.steps import section_of

PROBLEMS = Path(__file__).parents[3] / "problems"
WITH_VARIANTS = [path for path in sorted(PROBLEMS.glob("*/*.yaml"))
                 if "\nvariants:" in path.read_text(encoding="utf-8")]
SOME, SEVERAL, STUDENTS, WORKED = 12, 4, 500, 3
BY_THEMSELVES = {"cantilever", "cantilever_with_tip_mass", "column_near_buckling", "stepped_bar", "string_with_a_bead",
                 "scissor_lift_on_spring", "platform_on_parallel_rods", "rod_with_inclined_spring",
                 "eccentric_cylinder", "stepped_drum_dashpot"}      # members, closed loops, chosen or in letters


def test_how_many_there_are():
    assert len(WITH_VARIANTS) >= 40
    assert len({path.parent.name[0] for path in WITH_VARIANTS}) == 9


@pytest.mark.parametrize("path", WITH_VARIANTS, ids=lambda path: path.stem)
def test_variants_of_a_problem(path):
    source = file_source(path)
    problem = problem_of(source)
    rules = problem.spec.get("variants")
    assert rules.candidates >= 200 and not set(rules.without) - {"told"}
    problem = problem.with_spec(problem.spec.with_sections(variants=rules._replace(sample=SOME)))
    document = SceneDocument.of(source.node, source.file, None)
    found = solve_variants(problem, document)
    looked_at = sampled(problem.spec.get("variants"))
    assert len(found.accepted) + len(found.rejected) == SOME == len(looked_at)
    assert len(found.accepted) >= 0.8 * SOME and found.reread == len(found.accepted)
    for one in found.accepted:
        for key in one.keys:
            assert 0 < key.band.width <= 0.02 * abs(key.value) and key.error <= 0.1 * key.band.width
    assert_students_pass(problem, found)
    assert_no_mistake_is_marked_right(found)
    assert_worked_alike(path, document, [one.values for one in found.accepted[:WORKED]])


def assert_worked_alike(path, document, variants):
    """Lines by the expressions of another variant are those of the scene read and derived anew, letter by letter."""
    shared = WorkedVariants(document)
    for values in variants:
        fresh = Report(settled(document.with_values(values).problem()))
        fresh.add("steps")
        assert (fresh.refusal is None) and typst_of(section_of(shared.lines(values))) == typst_of(fresh.sections)
    assert shared.alone == (WORKED if path.stem in BY_THEMSELVES else 1)
    assert shared.alone + shared.sharing == WORKED


def typst_of(sections):
    return render([Document("", None, (), tuple(sections))], None)


def assert_students_pass(problem, found):
    """Of those who follow the lines and round some of them, 98 of 100 at least, in each variant."""
    for one in found.accepted[:SEVERAL]:
        students = Students(problem, one, STUDENTS)
        for key, value in zip(found.keys, one.keys, strict=True):
            answers = students.answers(key, value.band.figures)
            if answers is not None:
                off = np.abs(answers[0] * value.value)
                assert np.mean(off <= value.band.width * (1 + 1e-9)) >= 0.98, (key.text, one.values)


def assert_no_mistake_is_marked_right(found):
    """Whatever figures are kept of what a mistake leads to."""
    for one in found.accepted:
        for value in one.keys:
            for wrong in value.wrong:
                answers = [wrong.value, *(float(f"{wrong.value:.{figures}g}") for figures in
                                          range(value.band.figures, 8))]
                assert not any(is_within(answer, value.value, value.band.width) for answer in answers), wrong


def test_students_evaluate_lines_by_their_letters():
    """ω_d = √(ω² − δ²) and ζ = δ/ω of a bell crank; one who rounds nothing answers right."""
    path = next(path for path in WITH_VARIANTS if path.stem == "bell_crank_dashpot")
    source = file_source(path)
    problem = problem_of(source)
    rules = problem.spec.get("variants")
    problem = problem.with_spec(problem.spec.with_sections(variants=rules._replace(sample=2)))
    found = solve_variants(problem, SceneDocument.of(source.node, source.file, None))
    students = Students(problem, found.accepted[0], 50)
    for key in found.keys:
        off, by_letters = students.answers(key, 12)
        assert by_letters >= 1 and np.abs(off).max() < 1e-10
        off, _ = students.answers(key, 2)
        assert np.abs(off).max() > 1e-3


@pytest.mark.parametrize("path", sorted(PROBLEMS.glob("sets/*")), ids=lambda path: path.name)
def test_sets(path):
    found = course_of(str(path))
    assert found.title and len(found.problems) >= 3
    assert {Path(one.path).resolve() for one in found.problems} <= {one.resolve() for one in WITH_VARIANTS}


def test_what_a_search_finds_from_given_values_has_half_a_unit():
    """The angle of rest of a boom, and the mass factor of a cylinder: no line before them is rounded."""
    for stem, number in (("sagging_boom", 0), ("eccentric_cylinder", 1)):
        path = next(path for path in WITH_VARIANTS if path.stem == stem)
        source = file_source(path)
        problem = problem_of(source)
        rules = problem.spec.get("variants")._replace(sample=2)
        problem = problem.with_spec(problem.spec.with_sections(variants=rules))
        for one in solve_variants(problem, SceneDocument.of(source.node, source.file, None)).accepted:
            assert one.keys[number].band.width == half_a_unit(one.keys[number].value, one.keys[number].band.figures)
