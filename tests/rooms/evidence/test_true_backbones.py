"""Frequencies of free motions by their amplitude beside elliptic integrals, and followed in time."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import integrators
from vibcli.evidence.subject import Deadline
from vibcli.results import free_motions

DUFFING = """
bodies: {b: {mass: 2 kg, slide: x}}
springs: {s: {law: (50 N/m)*d + (900 N/m^3)*d^3, stretch: x}}
dampers: {d: {c: 3 N*s/m, between: [ground, b]}}
answers: {"backbone[1](x)(20 cm)": 0, "backbone[1](s.force)(10 N)": 0}
"""
PENDULUM = """
gravity: 10 m/s^2
bodies: {bob: {mass: 1 kg, at: [0, -2 m], pin: {at: [0, 0], by: phi}}}
answers: {"backbone[1](phi)(90 deg)": 0, "backbone[1](bob.y)(1 m)": 0}
"""


def found(text):
    one = problem(text)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


def duffing(A):
    """π √(α + β A²)/2 K(m), m = β A²/2(α + β A²)"""
    square = 25 + 450 * A**2
    return mpmath.pi * mpmath.sqrt(square) / (2 * mpmath.ellipk(225 * A**2 / square))


@pytest.mark.sweep
def test_frequencies_beside_elliptic_integrals():
    with mpmath.workdps(50):
        by_force = mpmath.findroot(lambda A: 50 * A + 900 * A**3 - 10, mpmath.mpf("0.15"))
        swing = mpmath.pi * mpmath.sqrt(5) / (2 * mpmath.ellipk(mpmath.mpf(1) / 2))
        exact = [duffing(mpmath.mpf(1) / 5), duffing(by_force), swing, swing]
        for each, x in zip([*found(DUFFING), *found(PENDULUM)], exact, strict=True):
            answer = each.ours()
            assert abs(each.true.values[0] / x - 1) < 1e-29, each.asked
            assert each.error(answer.values, each.true) <= answer.bound < 1e-13
    run = next(run for run in integrators.attempts(each) if (run.method, run.setting) == ("DOP853", "1e-09"))
    assert each.error(run.run(Deadline(2)).values, each.true) < 1e-7


@pytest.mark.sweep
def test_a_period_that_is_off_is_found(monkeypatch):
    periods = free_motions.periods_of
    monkeypatch.setattr(free_motions, "periods_of", lambda *args: [
        (period * (1 + 1e-12), error) for period, error in periods(*args)])
    assert all(each.error(each.ours().values, each.true) > each.ours().bound for each in found(DUFFING))
