"""Estimates of natural frequencies to many digits beside closed forms, and by assembled matrices."""

import mpmath
from support.references import assert_true
from support.scenes import problem

from vibcli.analyses.modal import estimates, ritz
from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import plain_estimates
from vibcli.evidence.subject import Deadline

CHAIN = """
parameters: {m: 2 kg, k: 300 N/m, h: 0.7}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {s: {k: k, between: [ground, a]}, r: {k: k, between: [a, b]}}
find: [{ritz: {shapes: [{x: h, y: 1}]}}]
answers: {rayleigh: 0, dunkerley: 0, "ritz[1]": 0}
"""


def exact():
    """δ ~ (2, 3), K⁻¹ = [[1, 1], [1, 2]]/k, and h² k + (1 − h)² k over (h² + 1) m."""
    square, h = mpmath.mpf(150), mpmath.mpf("0.7")
    return [mpmath.sqrt(square * 5 / 13), mpmath.sqrt(square / 3),
            mpmath.sqrt(square * (h**2 + (1 - h)**2) / (h**2 + 1))]


def found():
    one = problem(CHAIN)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


def test_estimates_beside_closed_forms_and_by_assembled_matrices():
    for i, each in enumerate(found()):
        assert_true(each, lambda i=i: exact()[i], 46, 1e-13)
        plain, = plain_estimates.attempts(each)
        assert each.error(plain.run(Deadline(1)).values, each.true) < 1e-14


def test_estimates_that_are_off_are_found(monkeypatch):
    displacement, trace, shape = estimates._unit_displacement, estimates._trace, ritz._shape
    monkeypatch.setattr(estimates, "_unit_displacement", lambda *args: [x * (1 + i * 1e-9) for i, x in enumerate(
        displacement(*args))])
    monkeypatch.setattr(estimates, "_trace", lambda *args: trace(*args) * (1 + mpmath.mpf("1e-12")))
    monkeypatch.setattr(ritz, "_shape", lambda *args: [x * (1 + i * mpmath.mpf("1e-12")) for i, x in enumerate(
        shape(*args))])
    broken = [each.asked for each in found() for answer in (each.ours(),)
              if not each.error(answer.values, each.true) <= answer.bound]
    assert broken == ["rayleigh", "dunkerley", "ritz[1]"]
