"""Where forces are odd in the deviations, odd harmonics and a quarter of the period give the same family."""

import pytest
from support.motions import problem

from vibcli.analyses.nonlinear.free_equations import FreeEquations
from vibcli.api.values import given_expression

BLOCKS = """
parameters: {m: 2 kg, k: 80 N/m, b: 500 N/m^3}
bodies: {b1: {mass: m, slide: x}, b2: {mass: 1.3*m, slide: y}}
springs:
  s: {law: k*d + b*d^3, between: [ground, b1]}
  t: {law: k*d + 0.5*b*d^3, between: [b1, b2]}
"""
PENDULUMS = """
parameters: {L: 0.8 m, m: 2 kg}
gravity: 9.81 m/s^2
bodies:
  a: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}
  b: {mass: 0.6*m, at: [0, -1.8*L], pin: {at: [0, -L], by: psi, carrier: a}}
"""
LOPSIDED = BLOCKS.replace("k*d + b*d^3", "k*d + (90 N/m^2)*d^2 + b*d^3")


def curve(text, signal, amplitudes, number=1):
    found = problem(text).free_motions
    return found.several.equations.odd, found.curve(number, given_expression(signal, "it").tree, amplitudes).points


@pytest.mark.parametrize(("text", "signal", "number"), [(BLOCKS, "x", 1), (BLOCKS, "y", 2), (PENDULUMS, "psi", 1)])
def test_the_same_as_with_all_harmonics(text, signal, number, monkeypatch):
    odd, points = curve(text, signal, [0.1, 0.25], number)
    monkeypatch.setattr(FreeEquations, "odd", False)
    _, others = curve(text, signal, [0.1, 0.25], number)
    assert odd
    for one, other in zip(points, others, strict=True):
        assert abs(one.omega / other.omega - 1) <= one.error + other.error <= 1e-11
        assert one.energy == pytest.approx(other.energy, rel=1e-11)


def test_forces_that_are_not_odd_keep_all_harmonics():
    odd, points = curve(LOPSIDED, "x", [0.1])
    assert not odd
    assert points[0].error <= 1e-11
