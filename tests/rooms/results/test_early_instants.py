"""Values at instants follow waves up to these, where the fronts up to the end of the motion are too many."""

from fractions import Fraction

import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.quantities.expression import measure
from vibcli.results.escalation import extreme_of_signal, value_of_signal
from vibcli.results.modal_response import ModalResponse
from vibcli.symbolic.parser import parse

SCENE = """\
    bars:
      rod:
        mass_per_length: 1 kg/m
        left: clamped
        segments: [{length: 0.4 m, EA: 4 N}, {length: 0.61 m, EA: 1 N}]
        attached: [{at: 0.23 m, mass: 0.3 kg}]
    points: {tip: {body: rod, at: 1.01 m}}
    forces: {push: {at: tip, force: 1 N*step(t)}}
    find: [{response: {until: %s}}]
    """
MOST = 1024


@pytest.fixture(scope="module")
def long_one():
    """By no more modes than are found at once: thousands of them are in test_many_modes."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ModalResponse, "limit", MOST)
        yield problem(SCENE % "3 h")


def measured(scene, text):
    return measure(scene, with_places(parse(text), scene.spec.members))


@pytest.mark.sweep
def test_a_value_before_anything_comes_back(long_one):
    """u = t/√(EA μ) at a free end that is pushed, until the front returns from where the section changes."""
    assert long_one.response.KIND == "modes"
    assert "values at instants by travelling waves" in long_one.response.words
    for text, expected in (("rod.u(1.01 m)(0.9 s)", 0.9), ("abs(rod.u(1.01 m))(0.9 s)", 0.9),
                           ("rod.force(0.9 m)(0.3 s)", 1.0), ("rod.force(0.9 m)(0.1 s)", 0.0)):
        value, error = measured(long_one, text)
        assert value == pytest.approx(expected, abs=1e-13)
        assert error <= 1e-12 or not expected


@pytest.mark.sweep
def test_later_ones_are_those_of_a_motion_that_ends_soon(long_one):
    short = problem(SCENE % "2 s")
    assert short.response.KIND == "waves"
    for t in (1.3, 1.9):
        text = f"rod.u(0.5 m)({t} s)"
        assert measured(long_one, text)[0] == pytest.approx(measured(short, text)[0], rel=1e-13)


@pytest.mark.sweep
def test_what_fronts_hide_goes_by_modes(long_one):
    found = long_one.response.signal(with_places(parse("rod.u(1.01 m)"), long_one.spec.members))
    assert found.read_at(0.5) is not found
    assert type(found.read_at(9e3)) is type(found)
    assert np.isfinite(found.values(np.array([9e3]))).all()


@pytest.mark.sweep
@pytest.mark.parametrize("text", ["rod.u(1.01 m)", "abs(rod.u(1.01 m))"])
def test_extremes_and_values_of_reports_need_no_more_digits(long_one, text):
    found = long_one.response.signal(with_places(parse(text), long_one.spec.members))
    assert extreme_of_signal(found, 0.0, 2.0, 1).error < 0.1
    value, error = value_of_signal(found.read_at(0.25), Fraction(1, 4))
    assert abs(value - 0.25) <= error <= 1e-12
    late = value_of_signal(found.read_at(5e3), Fraction(5000))
    assert late[1] > 1e-6
