"""The bounds of functions of signals: through loops that close, and as the errors of the parts say."""

import math

import numpy as np
import pytest
from support.scenes import problem

from vibcli.results.composed_errors import propagated
from vibcli.symbolic.parser import parse

SLIDER_CRANK = """
    coordinates: {phi: crank, psi: rod, x: slider}
    points: {B: {body: rod, at: [0.4 m, 0]}}
    bodies:
      crank: {shape: rod, mass: 2 kg, from: [0, 0], to: [0, 0.3 m], pin: {at: [0, 0], by: phi}}
      rod: {shape: rod, mass: 3 kg, from: [0, 0.3 m], to: [0.4 m, 0], pin: {at: [0, 0.3 m], carrier: crank, by: psi}}
      slider: {mass: 1.5 kg, at: [0.4 m, 0], slide: x}
    springs: {buffer: {k: 400 N/m, between: [slider, [0.9 m, 0]], preload: static}}
    constraints: {pin: {join: [B, slider]}}
    initial: {phi: 0.1}
    motion: small
    """


def test_energies_through_loops_that_close_have_bounds():
    signal = problem(SLIDER_CRANK).response.signal(parse("T"))
    assert signal.closing is not None
    value = float(signal.values(np.array([0.3]))[0])
    assert 0 < signal.error(0.3) <= 1e-11 * value


@pytest.mark.parametrize(("function", "values", "slopes"), [
    (lambda s: s["x"] * s["y"], {"x": 3.0, "y": -2.0}, {"x": 2.0, "y": 3.0}),
    (lambda s: math.sin(s["x"]) + s["y"] ** 2, {"x": 1.0, "y": 0.5}, {"x": math.cos(1.0), "y": 1.0})])
def test_errors_of_parts_add_up(function, values, slopes):
    errors = {"x": 1e-9, "y": 4e-9}
    first_order = sum(slopes[name] * off for name, off in errors.items())
    assert first_order <= propagated(function, values, errors) <= 1.01 * first_order


def test_the_error_of_a_square_at_zero_is_the_square_of_that_of_its_part():
    assert 1e-12 <= propagated(lambda s: s["x"] ** 2, {"x": 0.0}, {"x": 1e-6}) <= 1e-8
