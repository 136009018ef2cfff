"""Equilibria at many values of a parameter, found by arrays, are those that more digits find, within their error."""

import mpmath
import numpy as np
import pytest

import vibcli
from vibcli.mechanics.stacked_equilibria import StackedEquilibria

SAGGING = """
parameters: {m: 2 kg, L: 0.6 m, k: 600 N/m, h: 0.3 m, g: 9.81 m/s^2}
gravity: g
points: {end: {body: rod, at: [L, 0]}}
bodies: {rod: {mass: m, shape: rod, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}}
springs: {s: {k: k, between: [[L, h], end], free_length: 0.25 m}}
"""
HANGING = """
parameters: {m: 2 kg, k: 600 N/m, k3: 9 kN/m^3, g: 9.81 m/s^2, a: 0.4 m}
gravity: g
bodies:
  b: {mass: m, at: [0, -a], move: [x, y, 0]}
springs:
  s: {law: k*d + k3*d^3, between: [[0, 0], b]}
  t: {k: 2*k, between: [[-a, -2*a], b], free_length: 0.3 m}
"""


def stacked(text, name, values):
    p = vibcli.loads(text)._problem
    form, names, count = p.system.linearisation, p.scene.coordinates, len(values)
    given = {**p.numeric.floats, p.scene.time.name: 0.0, **{v.name: 0.0 for v in p.scene.v}, name: np.array(values)}
    near = np.repeat([[p.configuration.equilibrium.values[q] for q in names]], count, 0)
    return StackedEquilibria(form, given, names, near, np.array([p.numeric.size_along(q) for q in names]))


@pytest.mark.parametrize(("text", "name", "values"), [
    (SAGGING, "k", (500, 600, 700)), (HANGING, "k", (500, 610, 720)), (HANGING, "k3", (0, 5e3, 2e4))])
def test_they_are_the_places_that_more_digits_find(text, name, values):
    found = stacked(text, name, values)
    assert found.settled.all()
    unit = {"k": "N/m", "k3": "N/m^3"}[name]
    for i, value in enumerate(values):
        p = vibcli.loads(text).with_values(**{name: f"{value} {unit}"})._problem
        _, place = p.configuration.precise_rest(30)
        for x, error, q in zip(found.places[i], found.error[i], p.scene.coordinates, strict=True):
            assert abs(mpmath.mpf(float(x)) - place[q]) <= error <= 1e-13
        matrices = found.matrices()
        K = p.configuration.precise_system(30).stiffness()
        for (j, k), exact in K.items():
            assert abs(matrices.K[i, j, k] - exact) <= 12 * 2.0**-52 * matrices.K_size[i, j, k]


def test_what_has_no_minimum_there_is_not_settled():
    found = stacked(SAGGING.replace("gravity: g", "gravity: [0 m/s^2, g]"), "k", (600.0, np.nan, -6e3))
    assert found.settled.tolist() == [True, False, False]


def test_places_of_two_branches_do_not_follow_one_another():
    """A mass on two springs in a line that it has snapped through: both sides hold it."""
    text = """
parameters: {k: 1 kN/m, a: 0.3 m, m: 1 kg}
bodies: {b: {mass: m, at: [0, 0.1 m], slide: {by: x, along: [0, 1]}}}
springs:
  l: {k: k, between: [[-a, 0], b], free_length: 0.35 m}
  r: {k: k, between: [[a, 0], b], free_length: 0.35 m}
"""
    p = vibcli.loads(text)._problem
    given = {**p.numeric.floats, p.scene.time.name: 0.0, "x'": 0.0, "k": np.array([900.0, 1000, 1100, 1200])}
    before, scale = np.array([-1, 0, 1, 2]), np.array([0.3])
    one_side = StackedEquilibria(p.system.linearisation, given, ["x"], np.full((4, 1), 0.08), scale)
    both = StackedEquilibria(p.system.linearisation, given, ["x"], np.array([[0.08], [0.08], [-0.28], [-0.28]]), scale)
    assert one_side.settled.all() and both.settled.all()
    assert np.ptp(both.places) > 0.3
    assert one_side.follow(before) and not both.follow(before)
