"""What signals go beyond where they come to, beside a closed form."""

import mpmath
import pytest
from support.references import assert_true
from support.scenes import problem

from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import integrators
from vibcli.evidence.subject import Deadline
from vibcli.quantities import response

PUSHED = """
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: 100 N/m, between: [ground, a]}}
dampers: {d: {c: 12 N*s/m, between: [ground, a]}}
forces: {F: {at: a, force: -7 N*step(t)}}
find: [{response: {until: 2 s}}]
answers: {overshoot(x): 0}
"""


def found():
    one = problem(PUSHED)
    return next(iter(subjects(one, [answer.asked for answer in one.spec.answers])))


@pytest.mark.sweep
def test_an_overshoot_beside_its_closed_form_and_by_integrators():
    """exp(−πζ/√(1 − ζ²)) with ζ = 3/5."""
    each = found()
    assert_true(each, lambda: mpmath.exp(-mpmath.pi * 3 / 4), 30, 1e-12)
    run = next(run for run in integrators.attempts(each) if (run.method, run.setting) == ("DOP853", "1e-09"))
    assert each.error(run.run(Deadline(2)).values, each.true) < 1e-5


@pytest.mark.sweep
def test_one_that_is_off_is_found(monkeypatch):
    limit = response._limit

    def off(*args):
        final, error = limit(*args)
        return final * (1 + 1e-11), error

    monkeypatch.setattr(response, "_limit", off)
    each = found()
    assert each.error(each.ours().values, each.true) > each.ours().bound
