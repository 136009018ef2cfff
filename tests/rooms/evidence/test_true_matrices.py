"""Entries of matrices to many digits beside closed forms, and by numbers alone."""

import mpmath
import pytest
from support.references import CLOSED_LOOP
from support.scenes import problem

from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import differences, ours
from vibcli.evidence.subject import Deadline

CART = """
parameters: {M: 3 kg, m: 2 kg, L: 0.5 m, k: 80 N/m, c: 3 N*s/m, g: 10 m/s^2}
gravity: g
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, between: [[-1 m, 0], cart]}}
dampers: {d: {c: c, between: [[-1 m, 0], bob]}}
forces: {F: {at: cart, force: [(5 N)*sin(3*t/(1 s)), 0]}}
answers: {"M[x,x]": 0, "M[x,phi]": 0, "M[phi,phi]": 0, "K[x,x]": 0, "K[x,phi]": 0, "K[phi,phi]": 0, "C[x,phi]": 0}
"""
TURNING = """
parameters: {m: 2 kg, k: 500 N/m, W: 9 rad/s}
bodies:
  shaft: {at: [0, 0], pin: {by: W*t}}
  disc: {mass: m, at: [0, 0], move: {by: [u, v, 0], carrier: shaft}}
springs: {first: {k: k, stretch: u}, second: {k: 2*k, stretch: v}}
answers: {"G[u,v]": 0, "K[u,u]": 0, "C[u,v]": 0}
"""
LOOP = CLOSED_LOOP + """answers: {"M[phi,phi]": 0, "K[phi,phi]": 0}
"""


def found(text):
    one = problem(text)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


def swinging():
    """Of (x, φ): c acts along the line from the wall to the bob, at (1, −½)/√(5/4) m."""
    square = 1 / mpmath.mpf("1.25")
    return [5, 1, mpmath.mpf("0.5"), 80, 0, 10, 3 * square * mpmath.mpf("0.5")]


def closed():
    """With both rods at β to the level, the block at 2 L cos β: M of T, K of V = m g L sin β + ½ k (s − 2 L cos β)²."""
    m, k, g, L, s = 2, 800, mpmath.mpf("9.81"), mpmath.mpf("0.3") * mpmath.sqrt(2), mpmath.mpf("0.6")

    def V(b):
        return m * g * L * mpmath.sin(b) + k * (s - 2 * L * mpmath.cos(b)) ** 2 / 2

    b = mpmath.findroot(lambda b: mpmath.diff(V, b), mpmath.pi / 4)
    up, across = mpmath.cos(b) ** 2, mpmath.sin(b) ** 2
    return [m * L**2 * (mpmath.mpf(5) / 12 + 25 * across / 4 + up / 4), -m * g * L * mpmath.sin(b)
            - 2 * k * L * mpmath.cos(b) * (2 * L * mpmath.cos(b) - s) + 4 * k * L**2 * across]


@pytest.mark.parametrize(("text", "exact"), [(CART, swinging), (TURNING, lambda: [-36, 500 - 162, 0]), (LOOP, closed)])
def test_entries_beside_closed_forms(text, exact):
    with mpmath.workdps(50):
        for each, x in zip(found(text), exact(), strict=True):
            (own,) = ours.attempts(each)
            answer = own.run(Deadline(1))
            assert abs(each.true.values[0] - x) < 1e-28, each.asked
            assert each.error(answer.values, each.true) <= answer.bound < 1e-12
            assert each.kind == "matrix entry"


@pytest.mark.sweep
def test_entries_by_numbers_alone():
    one = found(CART)
    for each in one:
        runs = list(differences.attempts(each))
        errors = [each.error(run.run(Deadline(1)).values, each.true) for run in runs]
        assert min(errors) < (1e-14 if each.asked.startswith("M") else 1e-8)
    assert not list(differences.attempts(found(LOOP)[0]))
