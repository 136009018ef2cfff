"""What moves along a straight beam leaves what moves across alone, in bounds too."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.continuous.uncoupled_parts import uncoupled_parts
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.language.signals_of_places import with_places
from vibcli.results.modal_response import ModalResponse
from vibcli.symbolic.parser import parse

SCENE = """\
    beams:
      arm: {from: [0, 0], to: [1 m, 0], EI: 1 N*m^2, EA: 400 N, mass_per_length: 1 kg/m, left: clamped}
    points: {tip: {body: arm, at: 1 m}}
    forces: {push: {at: tip, force: [%s*step(t), 1 N*step(t)]}}
    """


def of_few(load):
    response = ModalResponse(problem(SCENE % load))
    response.most = 64
    response.alone = response.motion(64)
    return response


@pytest.mark.sweep
def test_a_push_along_adds_nothing_to_the_bound_across():
    both, across = of_few("50 N"), of_few("0 N")
    at, found = np.array([0.2, 0.7]), []
    for response in (both, across):
        tip, moment = (response.signal(with_places(parse(name), response.problem.spec.members))
                       for name in ("tip.y", "arm.moment(0 m)"))
        found.append([tip.values(at), tip.modal.errors(tip.reads, at), moment.modal.errors(moment.reads, at)])
    np.testing.assert_allclose(*found, rtol=1e-6)
    along = both.signal(parse("tip.x"))
    c, grid = 20.0, at % 0.2
    expected = 50 / 400 * c * np.where(grid < 0.1, grid, 0.2 - grid)
    assert (np.abs(along.values(at) - expected) <= along.modal.errors(along.reads, at) + 1e-13).all()


class Placed:
    """A piece whose ends have these rows."""

    def __init__(self, *rows):
        self.rows = rows


@pytest.mark.parametrize(("shapes", "expected"), [
    (np.eye(3), [0, 0, 2]), (np.array([[1.0, 0.5, 0], [0, 1, 0], [1, 0, 1]]), [0, 0, 0])])
def test_parts_are_told_apart_unless_modes_mix_them(shapes, expected):
    M, K = np.diag([1.0, 2.0, 3.0]), np.zeros((3, 3))
    found = uncoupled_parts(K, M, [Placed({}, {0: 1.0, 1: 0.5}), Placed({2: 1.0}, {})], shapes)
    assert found.coordinates == expected
    output = LinearOutput(1.0, {0: 2.0, 2: 1.0}, places={FieldPoint(1, 0.3, 0): 4.0})
    split = dict(found.split(output))
    assert sorted(split) == sorted(set(expected))
    assert split[expected[2]].places == output.places
    assert split[0].q[0] == 2.0


def test_members_that_nothing_moves_are_not_told_apart():
    found = uncoupled_parts(np.eye(2), np.eye(2), [Placed({}, {}), Placed({0: 1.0}, {})], np.eye(2))
    assert set(found.coordinates + found.pieces) == {0}
