"""True motions of bars in time, by the fronts of their waves: beside closed forms, and within the bounds of what the
program answers."""

import mpmath
import pytest
from support.references import assert_true
from support.scenes import problem

from vibcli.evidence.reference import member_fronts
from vibcli.evidence.reference.member_fronts import ArrivedFront, SignalInFronts
from vibcli.evidence.subjects.motions import of_member_motion

BAR = """
bars: {rod: {length: 1 m, EA: 1 MN, mass_per_length: 4 kg/m, left: clamped%s}}
points: {end: {body: rod, at: 1 m}}
%s
find: [{response: {of: [rod.u(1 m)], until: 7 ms}}]
answers: {"%s": 0}
"""
MASS, DAMPER = ", attached: [{at: 1 m, mass: 4 kg}]", ", right: {c: 2 kN*s/m}"
LET_GO = "forces: {pull: {at: end, force: 500 N}}\ninitial: {released: pull}"
PUSHED = "forces: {pull: {at: end, force: (500 N)*sin((300 rad/s)*t)}}"


@pytest.mark.sweep
@pytest.mark.parametrize(("more", "rest", "quantity", "exact"), [
    ("", LET_GO, "rod.force(0 m)(3 ms)", lambda: -500),
    ("", LET_GO, "rod.force(0 m)(1 ms)", lambda: 500),
    ("", LET_GO, "argmax(rod.force(0 m))", lambda: 0),
    ("", LET_GO, "rod.u(1 m)(0 s)", lambda: mpmath.mpf("5e-4")),
    ("", LET_GO, "argmin(rod.u(1 m))", lambda: mpmath.mpf("0.004")),
    (DAMPER, LET_GO, "rod.u(1 m)(5 ms)", lambda: 0),
    (MASS, "initial: {rod.u: '(1 mm)*x/(1 m)'}", "rod.u(1 m)(2 ms)", lambda: (1 - mpmath.exp(-1)) / 1000),
    ("", "initial: {rod.u: '(1 mm)*min(x/(1 m), 1/4)'}", "rod.u(1 m)(1.8 ms)", lambda: mpmath.mpf("1e-4")),
    ("", PUSHED, "rod.u(1 m)(3 ms)", lambda: (1 - mpmath.cos(mpmath.mpf("0.9"))) / 1200)])
def test_between_fronts(monkeypatch, more, rest, quantity, exact):
    for name, value in (("START", 30), ("GROWTH", 2.0), ("DIGITS", 22)):        # 30 and 60 digits instead of 64 and 96
        monkeypatch.setattr(member_fronts, name, value)
    one = problem(BAR % (more, rest, quantity))
    assert_true(of_member_motion(one, one.spec.answers[0].asked.tree), exact, 38, 1e-12)


def test_at_the_start_no_front_has_set_out():
    one = problem(BAR % ("", LET_GO, "rod.u(1 m)(0 s)"))
    found = of_member_motion(one, one.spec.answers[0].asked.tree)
    assert found.error(found.ours().values, found.true) <= 1e-15


@pytest.mark.parametrize("digits", [64, 128, 256])
def test_no_turn_is_looked_for_where_rounding_alone_is_left(digits):
    """A string that a pulse of two passages presses aside, and that rests from then on."""
    with mpmath.workdps(digits):
        unit = mpmath.sqrt(2) / 3
        fronts = [ArrivedFront(delay * unit, [mpmath.mpf(0), (-1)**delay * mpmath.eps, mpmath.mpf(bend)])
                  for delay, bend in ((0, 1), (1, -2), (3, 2), (4, -1))]
        found = SignalInFronts(mpmath.mpf(0), fronts, 44 * unit).extreme(1)
        assert all(abs(x - y) < 1e-40 for x, y in zip(found, (2 * unit, 2 * unit**2), strict=False))


@pytest.mark.sweep
def test_fronts_are_found_once_for_an_extreme_and_its_instant(monkeypatch):
    calls, found = [], member_fronts.in_fronts
    monkeypatch.setattr(member_fronts, "in_fronts", lambda *given: calls.append(given) or found(*given))
    for name, value in (("START", 30), ("DIGITS", 16)):
        monkeypatch.setattr(member_fronts, name, value)
    one = problem(BAR % ("", LET_GO, "rod.u(1 m)(0 s)"))
    extremes = [member_fronts.extremes(one, "rod.u(1 m)", 0.007, -1, instant) for instant in (False, True)]
    assert len(calls) == 2
    assert [float(true.values[0]) for true in extremes] == [pytest.approx(-5e-4), pytest.approx(0.004)]
