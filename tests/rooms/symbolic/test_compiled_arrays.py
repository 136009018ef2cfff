"""Expressions compiled once with named constants give what they give compiled with those of the data at hand."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.mechanics.numeric_equations import NumericEquations

SCENE = """
parameters: {m: 2.1 kg, J: 0.7 kg, L: 0.8 m, k: 40.3 N/m, h: 40.3 N/m, R: 1.7 N, w: 3.1 rad/s, F: 2.3 N, g: 9.81 m/s^2}
gravity: g
bodies:
  cart: {mass: m, at: [0, 0], slide: x}
  bob: {mass: J, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k - h + k, between: [[-1 m, 0], cart]}}
dampers: {rub: {friction: R, stretch: x}}
forces: {f: {at: cart, force: ["F*cos(w*t) + (k - h)*max(x, L/2) - (h - k)*x*sin(phi)", 0 N]}}
"""
OTHER = {"m": 2.3, "J": 0.9, "k": 41.7, "F": -2.9, "R": 1.9, "L": 0.7}


@pytest.mark.parametrize("change", [{}, OTHER, {"k": 40.4}, {"R": 0.0, "F": 0.0}])
def test_named_constants_take_other_values(change):
    numeric = problem(SCENE).configuration.numeric
    scene, floats = numeric.scene, numeric.floats
    base = NumericEquations(scene, floats)
    other = NumericEquations(scene, {**floats, "h": 40.5}, (), lambda value: value, base)
    named = NumericEquations(scene, {**floats, **change}, (), lambda value: value, base)
    fresh = NumericEquations(scene, {**floats, **change})
    rng, g = np.random.default_rng(1), [np.ones(7), -np.ones(7)]
    point = rng.uniform(0, 9, 7), rng.normal(size=(2, 7)), rng.normal(size=(2, 7)), g
    assert list(named.switches) == list(fresh.switches) == list(other.switches) and len(g) == len(fresh.switches)
    assert named.accelerations(*point) == pytest.approx(fresh.accelerations(*point), rel=1e-13)
    assert not np.allclose(named.accelerations(*point), other.accelerations(*point), rtol=1e-6)


def test_all_constants_are_changed_that_are_written():
    numeric = problem(SCENE).configuration.numeric
    base = NumericEquations(numeric.scene, numeric.floats)
    seen = []
    NumericEquations(numeric.scene, numeric.floats, (), lambda value: seen.append(value) or value, base)
    assert {40.3, 1.7, 3.1, 2.3} <= set(map(abs, seen))
