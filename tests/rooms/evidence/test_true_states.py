"""Matrices and forces at an instant of a motion beside closed forms."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.evidence.asked import NotCompared, subjects
from vibcli.mechanics import state_functions

SWINGING = """
gravity: 10 m/s^2
bodies:
  cart: {mass: 3 kg, at: [0, 0], slide: x}
  bob: {mass: 2 kg, at: [0, -0.5 m], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: 80 N/m, stretch: x}}
dampers: {d: {c: 3 N*s/m, between: [[-1 m, 0], cart]}}
initial: {phi: 1, phi': 2 rad/s}
motion: full
answers: {"M[x,phi](0 s)": 0, "Q[phi](0 s)": 0, "K[phi,phi](0 s)": 0, "K[x,x](0.05 s)": 0, "C[x,x](0 s)": 0}
"""


def found():
    one = problem(SWINGING)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


@pytest.mark.sweep
def test_a_pendulum_on_a_cart():
    *one, damping = found()
    assert isinstance(damping, NotCompared) and "no reference is found of C" in damping.why
    with mpmath.workdps(40):
        for each, x in zip(one, [mpmath.cos(1), -10 * mpmath.sin(1), 10 * mpmath.cos(1), 80], strict=True):
            answer = each.ours()
            assert abs(each.true.values[0] - x) < 1e-28, each.asked
            assert each.error(answer.values, each.true) <= answer.bound < 1e-11


@pytest.mark.sweep
def test_a_force_that_is_off_is_found(monkeypatch):
    force = state_functions.force
    monkeypatch.setattr(state_functions, "force", lambda scene, i: force(scene, i) * (1 + 2.0**-36))
    off = {each.asked for each in found()[1:4] for answer in (each.ours(),)
           if each.error(answer.values, each.true) > answer.bound}
    assert off == {"Q[phi](0 s)", "K[phi,phi](0 s)", "K[x,x](0.05 s)"}
