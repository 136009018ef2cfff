"""Folds of equilibria to many digits beside closed forms, and by SciPy's roots."""

import mpmath
import pytest
from support.references import assert_true
from support.scenes import problem

from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import folds
from vibcli.evidence.subject import Deadline
from vibcli.results import limit_loads

ARMATURE = """
parameters: {k: 1200 N/m, gap: 6 mm, C: 8e-6 N*m^2, m: 30 g}
bodies: {armature: {mass: m, slide: x}}
energies: {V: k*x^2/2 - C/(gap - x)}
answers: {"fold[1, C]": 0, "fold[1, C](x)": 0, "fold[1, gap]": 0}
"""
TOGGLE = """
parameters: {L: 0.5 m, alpha: 35 deg, k: 800 N/m, P: 20 N}
points:
  A: {body: first, at: [L*cos(alpha), L*sin(alpha)]}
  B: {body: second, at: [2*L*cos(alpha), 0]}
bodies:
  first: {shape: rod, from: [0, 0], to: [L*cos(alpha), L*sin(alpha)], pin: {at: [0, 0], by: phi}}
  second: {shape: rod, from: [L*cos(alpha), L*sin(alpha)], to: [2*L*cos(alpha), 0],
           pin: {at: A, carrier: first, by: psi}}
  ram: {mass: 1 kg, at: [2*L*cos(alpha), 0], slide: x}
springs: {s: {k: k, between: [[3 m, 0], ram]}}
forces: {push: {at: A, force: [0, -P]}}
constraints: {hinge: {join: [B, ram]}}
answers: {"fold[1, P](x)": 0}
"""


def armature():
    """k x = C/(gap − x)², k = 2 C/(gap − x)³: x = gap/3."""
    k, gap, C = 1200, mpmath.mpf("0.006"), mpmath.mpf("8e-6")
    return [4 * k * gap**3 / 27, gap / 3, mpmath.cbrt(27 * C / (4 * k))]


def toggle():
    """P = 4 k L (cos β − cos α) tan β, which is largest where cos³β = cos α."""
    L, alpha = mpmath.mpf("0.5"), 35 * mpmath.pi / 180
    beta = mpmath.acos(mpmath.cbrt(mpmath.cos(alpha)))
    return [2 * L * (mpmath.cos(beta) - mpmath.cos(alpha))]


def found(text):
    one = problem(text)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "exact"), [(ARMATURE, armature), (TOGGLE, toggle)])
def test_folds_beside_closed_forms_and_by_roots(text, exact):
    for i, each in enumerate(found(text)):
        assert_true(each, lambda i=i: exact()[i], 45, 1e-13)
        runs = [run for run in folds.attempts(each) if run.setting == "1e-12"]
        assert min(each.error(run.run(Deadline(2)).values, each.true) for run in runs) < 1e-9


@pytest.mark.sweep
def test_a_fold_that_is_off_is_found(monkeypatch):
    counted = limit_loads.LimitLoads.limit_point
    monkeypatch.setattr(limit_loads.LimitLoads, "limit_point", lambda self, number: counted(self, number)._replace(
        value=counted(self, number).value * (1 + mpmath.mpf("1e-12"))))
    broken = [each.asked for each in found(ARMATURE) for answer in (each.ours(),)
              if not each.error(answer.values, each.true) <= answer.bound]
    assert broken == ["fold[1, C]", "fold[1, gap]"]
