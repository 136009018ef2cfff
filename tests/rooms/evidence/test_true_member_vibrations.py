"""True motions of beams in time, by the poles of their images: beside closed forms, and within the bounds of what the
program answers."""

from itertools import islice, pairwise

import mpmath
import numpy as np
import pytest
from support.references import assert_true
from support.scenes import problem

from vibcli.evidence.methods.finite_elements import attempts
from vibcli.evidence.reference import (
    member_pole_sums,
    member_poles,
    member_residues,
    member_vibrations,
    rated_members,
)
from vibcli.evidence.reference.member_starts import started_members
from vibcli.evidence.subject import Deadline
from vibcli.evidence.subjects.motions import of_member_motion
from vibcli.evidence.subjects.steady_states import of_wave

BEAM = """
beams: {bridge: {length: 3 m, EI: 40 kN*m^2, mass_per_length: 12 kg/m, left: pinned, right: pinned%s}}
points: {middle: {body: bridge, at: 1.5 m}}
%s
find: [{response: {of: [bridge.u(1.5 m)], until: 200 ms}}]
answers: {"%s": 0}
"""
OMEGA = "(pi/(3 m))^2*sqrt((40 kN*m^2)/(12 kg/m))"
STEP = "forces: {blow: {at: middle, force: 300 N*step(t)}}"
FIELD = "initial: {bridge.u: '(1 mm)*sin(pi*x/(3 m))'}"
DAMPED = ", drag: 60 N*s/m^2"
RATED = "\ndamping: {proportional: [5 s^-1, 0 s]}"


def turned(t, zeta=0):
    """cos ω t of the first mode, as drag damps it."""
    rate = mpmath.mpf(5) / 2 * bool(zeta)
    slow = mpmath.sqrt(omega(1) ** 2 - rate**2)
    return mpmath.exp(-rate * t) * (mpmath.cos(slow * t) + rate / slow * mpmath.sin(slow * t))


@pytest.mark.sweep
@pytest.mark.parametrize(("more", "rest", "quantity", "exact"), [
    ("", FIELD, "bridge.u(1.5 m)(0 s)", lambda: mpmath.mpf("0.001")),
    ("", FIELD, "bridge.u(1.5 m)(70 ms)", lambda: turned(mpmath.mpf("0.07")) / 1000),
    ("", FIELD, "bridge.u(1.5 m)(20 s)", lambda: turned(mpmath.mpf(20)) / 1000),
    ("", FIELD, "bridge.moment(1.5 m)(70 ms)", lambda: -40 * turned(mpmath.mpf("0.07")) * (mpmath.pi / 3) ** 2),
    (DAMPED, FIELD, "bridge.u(0.75 m)(70 ms)", lambda: turned(mpmath.mpf("0.07"), 1) / 1000 / mpmath.sqrt(2)),
    ("", FIELD + RATED, "bridge.u(0.75 m)(70 ms)", lambda: turned(mpmath.mpf("0.07"), 1) / 1000 / mpmath.sqrt(2)),
    ("", FIELD, "min(bridge.u(1.5 m))", lambda: -mpmath.mpf("0.001"))])
def test_beside_closed_forms(monkeypatch, more, rest, quantity, exact):
    monkeypatch.setattr(member_poles, "BLOCK", 4)
    monkeypatch.setattr(member_vibrations, "DIGITS", 44)
    one = problem(BEAM % (more, rest, quantity))
    assert_true(of_member_motion(one, one.spec.answers[0].asked.tree), exact, 20, 1e-9)


@pytest.mark.sweep
def test_after_a_step(monkeypatch):
    """After half a period every mode stands at twice where it rests: so does the beam, 2 F L³/48 EI. Of a few poles as
    many digits are true as are stated."""
    for module, name, value in ((member_poles, "BLOCK", 64), (member_vibrations, "DIGITS", 44),
                                (member_vibrations, "LEAST", 4), (member_pole_sums, "MOST", 1),
                                (member_residues, "MANY", 8)):
        monkeypatch.setattr(module, name, value)
    one = problem(BEAM % ("", STEP, f"bridge.u(1.5 m)(pi/({OMEGA}))"))
    true = of_member_motion(one, one.spec.answers[0].asked.tree).true
    with mpmath.workdps(60):
        exact = 2 * mpmath.mpf(300) * 27 / (48 * 40000)
        assert 4 <= true.digits <= 7 and abs(true.values[0] / exact - 1) <= mpmath.mpf(10) ** -true.digits


@pytest.mark.sweep
@pytest.mark.parametrize(("damping", "zeta"), [
    ("modal: 2 %", lambda n: mpmath.mpf(2) / 100), ("modal: [1 %, 2 %]", lambda n: mpmath.mpf(2 if n > 1 else 1) / 100),
    ("proportional: [3 s^-1, 2e-5 s]", lambda n: 3 / (2 * omega(n)) + mpmath.mpf(10)**-5 * omega(n))])
def test_of_modes_with_ratios(monkeypatch, damping, zeta):
    """Under a force in the middle Σ 2F/(μ l) (1/(ω² + 2iζωΩ − Ω²)) over odd modes."""
    monkeypatch.setattr(rated_members, "REACH", 14)
    monkeypatch.setattr(rated_members, "DIGITS", 44)
    monkeypatch.setattr(member_poles, "BLOCK", 4)
    rest = f"forces: {{blow: {{at: middle, force: 300 N*cos(50 rad/s*t)}}}}\ndamping: {{{damping}}}"
    one = problem(BEAM % ("", rest, "amplitude(bridge.u(1.5 m))"))
    found = of_wave(one, one.spec.answers[0].asked.tree)
    with mpmath.workdps(40):
        terms = [600 / mpmath.mpf(36) / (omega(n)**2 + 100j * zeta(n) * omega(n) - 2500) for n in range(1, 800, 2)]
        assert abs(abs(mpmath.fsum(terms)) / found.true.values[0] - 1) <= mpmath.mpf(10)**-9
    ours = found.ours()
    assert found.error(ours.values, found.true) <= ours.bound <= 1e-9
    plain = [found.error(one.run(Deadline(60)).values, found.true) for one in islice(attempts(found), 4)]
    assert all(fine < coarse / 6 for coarse, fine in pairwise(plain)) and plain[-1] < 1e-4


def omega(n):
    """Of the mode n."""
    return (n * mpmath.pi / 3) ** 2 * mpmath.sqrt(mpmath.mpf(40000) / 12)


@pytest.mark.sweep
def test_on_a_foundation_no_wave_runs_below_the_cut_off():
    """ω² = k/μ, from which on the search for poles begins."""
    search = member_poles.PoleSearch(started_members(
        problem(BEAM % (", foundation: 4.8 kN/m^2", FIELD, "bridge.u(1.5 m)(70 ms)")), "bridge.u(1.5 m)", 1))
    below, above = search.waves(np.array([19.9, 20.1]))
    assert below == 0 < above and search.block(0).p.imag.min() > 20
