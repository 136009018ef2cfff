"""Lines of worked solutions that would say what an earlier one says."""

from pathlib import Path

import pytest
from support.scenes import kept_problem_of

from vibcli.notation.plain import plain
from vibcli.report.blocks import Name, Words
from vibcli.report.formats.formula import formula
from vibcli.report.steps.repeated_lines import without_repeats
from vibcli.report.steps.step import WorkedSolution
from vibcli.report.steps.worked import worked


def lines_of(name):
    path, = Path("problems").glob(f"*/{name}.yaml")
    return worked(kept_problem_of(path))


def told(name):
    return [formula(line.parts, plain).replace("\u00a0", " ") for line in lines_of(name) if line.parts]


def test_one_that_is_left_out_leaves_what_it_settles_and_its_number():
    sheet = WorkedSolution(())
    first = sheet.write(Name("a"), " = 1", settles="a")
    sheet.write(Words("beside"), settles="b", joined=True)
    sheet.write(Name("c"), " = 2", settles="c", uses=[first])
    again = sheet.write(Name("a"), " = 1", settles="d")
    sheet.write(Words("beside"), settles="b", joined=True)
    sheet.write(Name("e"), " = 3", settles="e", uses=[again, first])
    assert [(line.number, line.settles, line.uses, bool(line.parts)) for line in without_repeats(sheet.steps)] == [
        (1, "a", (), True), (1, "b", (), True), (1, "d", (), False), (2, "c", (1,), True), (3, "e", (1,), True)]


def test_lines_that_differ_in_what_is_joined_to_them_all_stay():
    sheet = WorkedSolution(())
    for value in "12":
        sheet.write(Name("a"), " = 1")
        sheet.write(Name("b"), f" = {value}", joined=True)
    assert len(without_repeats(sheet.steps)) == 4


def test_members_that_are_alike_have_one_equation_and_each_its_ends():
    lines = told("portal_frame")
    assert sum(line.startswith("motion of an element") for line in lines) == 1
    for wanted in ("u(ξ, t):  displacement of right at ξ, counted from its left end,  an element moves as one of left",
                   "of left at ξ = 0:  u = 0, ∂u/∂ξ = 0", "of right at ξ = 0:  u = 0, ∂u/∂ξ = 0"):
        assert wanted in lines, lines


def test_members_that_stretch_have_an_equation_beside_those_that_bend():
    lines = told("portal_frame_that_stretches")
    assert [line for line in lines if line.startswith("motion of an element")] == [
        "motion of an element dξ:  EI·∂⁴u/∂ξ⁴ + μ·∂²u/∂t² = 0", "motion of an element dξ:  EA·∂²w/∂ξ² = μ·∂²w/∂t²"]
    assert sum(line.endswith("moves as one of left.along") for line in lines) == 2


def test_one_member_alone_is_not_named_at_its_ends():
    assert any(line.startswith(("at ξ = 0:", "at x = 0:")) for line in told("cantilever"))


def test_a_stiffness_that_is_asked_at_several_places_of_rest_is_told_of_that_of_the_solution():
    lines = lines_of("snap_through_truss")
    assert sum("factor of the coordinate" in formula(line.parts, plain) for line in lines) == 1
    of = {line.settles: line for line in lines}
    assert of["K[y,y][3]"].value == pytest.approx(281.948, rel=1e-5)
    assert not {"K[y,y][1]", "K[y,y][2]"} & set(of)      # of other places
