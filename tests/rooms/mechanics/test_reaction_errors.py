"""What forces in constraints and supports at rest are off by: beside weights that they bear, known in fractions."""

from fractions import Fraction
from pathlib import Path

import pytest

from vibcli.api.source import file_source, problem_of
from vibcli.mechanics.signals import force, reaction_error

PROBLEMS = Path(__file__).resolve().parents[3] / "problems"


@pytest.mark.parametrize(("file", "signal", "true"), [
    ("6_two_degrees/load_under_a_movable_pulley", "rope.force.1", "49.05"),
    ("6_two_degrees/load_under_a_movable_pulley", "top.reaction.y", "127.53"),
    ("6_two_degrees/stepped_drum_with_block_and_pulley", "hoist.force.2", "53.955"),
    ("3_free_undamped/drum_on_a_slope_with_a_cord", "cord.force.1", "24.525"),
    ("1_statics_and_energy/step_ladder_with_a_man", "foot.force", "364.19625")])
def test_the_weight_that_it_bears_is_within_its_bound(file, signal, true):
    configuration = problem_of(file_source(PROBLEMS / f"{file}.yaml")).configuration
    found, error = force(configuration, signal), reaction_error(configuration, signal)
    off = abs(Fraction(found) - Fraction(true))
    assert off <= error <= 1e-12 * found and off <= 1e-14 * found
