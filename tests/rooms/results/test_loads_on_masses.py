"""What loads on masses do to members: their series converge faster by what the inertia takes, so that shears and
accelerations have bounds."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq
from support.scenes import problem

from vibcli.analyses.continuous.uncounted_modes import inverse_where_massive
from vibcli.language.signals_of_places import with_places
from vibcli.results.modal_response import ModalResponse
from vibcli.symbolic.parser import parse

TIMES = np.array([0.0, 0.013, 0.37, 1.9])


def by_few(scene):
    response = ModalResponse(scene)
    response.most = 64
    response.alone = response.motion(64)
    return response


def read(response, name):
    return response.signal(with_places(parse(name), response.problem.spec.members)).reads


def weights_of_shear(count):
    """(ω, φ(1) φ‴(0)/∫ of φ²) of a cantilever of length, EI and μ 1 with a mass of 1 at its end."""
    def equation(b):
        return 2 * np.exp(-b) / (1 + np.exp(-2 * b)) + np.cos(b) + b * (np.cos(b) * np.tanh(b) - np.sin(b))

    edges = np.arange(0, count + 1) * np.pi + np.pi / 4
    b = np.array([brentq(equation, max(low - np.pi / 4 * (low < 1), 1e-3), high, xtol=1e-14)
                  for low, high in pairwise(edges)])
    places, parts = np.polynomial.legendre.leggauss(4 * count)
    x, e = (1 + places)[:, None] / 2, np.exp(-b)
    whole = 1 - e * e + 2 * np.sin(b) * e
    ratio = (1 + e * e + 2 * np.cos(b) * e) / whole

    def shape(x):
        return (np.sin(b) - np.cos(b) - e) / whole * np.exp(b * x - b) + (1 + ratio) / 2 * np.exp(-b * x) - np.cos(
            b * x) + ratio * np.sin(b * x)

    size = parts @ shape(x) ** 2 / 2 + shape(1.0) ** 2
    return b**2, shape(1.0) * -2 * ratio * b**3 / size


@pytest.mark.sweep
@pytest.mark.parametrize("load", ["force: 1 N}}\n    initial: {released: push}", "force: 1 N*step(t)}}"])
def test_shears_far_from_a_mass_that_is_pushed_or_let_go(load):
    scene = problem(f"""\
    beams:
      arm: {{length: 1 m, EI: 1 N*m^2, mass_per_length: 1 kg/m, left: clamped, attached: [{{at: 1 m, mass: 1 kg}}]}}
    points: {{tip: {{body: arm, at: 1 m}}}}
    forces: {{push: {{at: tip, {load}
    """)
    omega, weights = weights_of_shear(400)
    response = by_few(scene)
    reads, swinging = read(response, "arm.shear(0 m)"), (weights / omega**2) @ np.cos(np.outer(omega, TIMES))
    expected = swinging if "released" in load else weights @ omega**-2.0 - swinging
    for count in (32, 64):
        off = np.abs(response.motion(count).values(reads, TIMES) - expected)
        bound = response.motion(count).errors(reads, TIMES)
        assert (off <= bound + 2e-4).all()
        assert (off > 1e-4).any()
        assert bound.max() < 0.2


def test_the_acceleration_of_a_mass_that_is_let_go():
    scene = problem("""\
    bars: {rod: {length: 1 m, EA: 1 N, mass_per_length: 1 kg/m, left: clamped, attached: [{at: 1 m, mass: 1 kg}]}}
    points: {tip: {body: rod, at: 1 m}}
    forces: {pull: {at: tip, force: 1 N}}
    initial: {released: pull}
    """)
    response, at = by_few(scene), np.array([0.3, 1.0, 1.7])
    for name, expected in (("rod.u''(1 m)", -np.exp(-at)), ("rod.force(1 m)", np.exp(-at))):
        reads = read(response, name)
        for count in (32, 64):
            off = np.abs(response.motion(count).values(reads, at) - expected)
            assert (off <= response.motion(count).errors(reads, at) + 1e-13).all()
            assert response.motion(count).errors(reads, at).max() < 0.05


def test_coordinates_that_have_mass_together():
    M = np.array([[2.0, 0, 1, 0], [0, 0, 0, 0], [1.0, 0, 3, 0], [0, 0, 0, 4.0]])
    found = inverse_where_massive(M)
    keep = np.ix_([0, 2, 3], [0, 2, 3])
    np.testing.assert_allclose(found[keep], np.linalg.inv(M[keep]), rtol=1e-14)
    assert not found[1].any()
    assert not inverse_where_massive(np.ones((2, 2))).any()
