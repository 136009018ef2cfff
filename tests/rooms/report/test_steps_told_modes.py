"""Frequencies of members that are asked have lines in worked solutions, whatever their number."""

import pytest
from support.scenes import problem

from tests.conftest import PROBLEMS
from vibcli.api.source import file_source, problem_of
from vibcli.base.errors import PhysicsError
from vibcli.report.steps.told_modes import FIRST, HEADS, HIGHEST, asked_modes
from vibcli.report.steps.worked import worked

MEMBERS = [path for path in PROBLEMS if path.parent.name.startswith("8_")]
STRING = ("strings: {cord: {length: 1 m, preload: 50 N, mass_per_length: 2 g/m, left: clamped, right: clamped}}\n"
          "answers: {'frequency[%d]': 79 Hz}\n")


@pytest.mark.parametrize("path", MEMBERS, ids=lambda path: path.stem)
def test_frequencies_that_are_asked_have_lines(path):
    given = problem_of(file_source(path))
    asked = {int(tree.indices[0]) for one in given.spec.answers for tree in [one.asked.tree]
             if getattr(tree, "head", "") in HEADS and str(tree.indices[0]).isdigit()}
    try:
        settled = {line.settles for line in worked(given)}
    except PhysicsError:
        pytest.skip("its steps are not told")
    if "omega[1]" not in settled and "omega[2]" not in settled and "omega[3]" not in settled:
        pytest.skip("its frequencies are told otherwise")
    free = {mode.index for mode in given.modal.modes.first(max({1, *asked})) if not mode.omega}
    assert {f"omega[{number}]" for number in asked - free} <= settled


def test_the_first_modes_and_those_that_are_asked_are_told_up_to_a_bound():
    assert asked_modes(problem(STRING % 7)) == {7} and asked_modes(problem(STRING % (HIGHEST + 1))) == set()
    settled = [line.settles for line in worked(problem(STRING % 7)) if line.settles.startswith("omega[")]
    assert settled == [*(f"omega[{number}]" for number in range(1, FIRST + 1)), "omega[7]"]
