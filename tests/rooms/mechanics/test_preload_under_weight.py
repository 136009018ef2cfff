"""A member that keeps its length between ends at rest is the limit EA → ∞ of one that stretches: the preload is the
mean of its tension, and half of what hangs on it pulls at either end."""

import pytest
from support.scenes import problem

UNIFORM = "mass_per_length: 0.7 kg/m"
STEPPED = "segments: [{length: 1 m, mass_per_length: 1 kg/m}, {length: 2 m, mass_per_length: 3 kg/m}]"
MASS = UNIFORM + ", attached: [{at: %d m, mass: 2 kg}]"


def beam(given, upwards=True):
    """Five ω of a vertical beam, clamped below and pinned above, drawn upwards or downwards."""
    ends = "from: [0, 0], to: [0, 3 m], left: clamped, right: pinned" if upwards else (
        "from: [0, 3 m], to: [0, 0], left: pinned, right: clamped")
    scene = problem(f"gravity: 9.81 m/s^2\nbeams: {{post: {{{ends}, EI: 20 N*m^2, {given}, preload: 90 N}}}}\n")
    return [mode.omega for mode in scene.modal.modes.first(5)]


@pytest.mark.sweep
@pytest.mark.parametrize("given", [UNIFORM, MASS % 1, STEPPED])
def test_one_that_keeps_its_length_is_the_limit_of_one_that_stretches(given):
    assert beam(given) == pytest.approx(beam(given + ", EA: 2e13 N"), rel=1e-12)


@pytest.mark.sweep
def test_drawn_the_other_way_it_is_the_same():
    assert beam(MASS % 1) == pytest.approx(beam(MASS % 2, upwards=False), rel=1e-14)
