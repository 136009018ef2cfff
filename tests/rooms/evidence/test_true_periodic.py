"""True steady states under loads that repeat themselves, beside closed forms between their jumps; numbers read off
samples of others' solutions."""

import re

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.api.values import checked_quantity
from vibcli.base.errors import PhysicsError
from vibcli.cli.sampled import asked
from vibcli.evidence.asked import NotCompared, subjects
from vibcli.evidence.methods import integrators
from vibcli.evidence.plain_equations import _zero, extreme
from vibcli.evidence.reference import periodic, swings
from vibcli.evidence.reference.motion import full
from vibcli.evidence.subject import Deadline
from vibcli.evidence.subjects.motions import period

ONE = """
bodies: {a: {mass: 2 kg, slide: x}}
springs: {s: {k: 800 N/m, between: [ground, a]}}
dampers: {d: {c: 8 N*s/m, between: [ground, a]}}
forces: {F: {at: a, force: %s}}
answers: {"rms(x'')": 1 m/s^2, "steady(x')(0.3 s)": 1 m/s}
"""
SQUARE = "(3 N)*square((5 rad/s)*t)"


def by_halves():
    """(rms of ẍ, ẋ(0.3 s)): x = F/k + e^{−δt}(A cos ωt + B sin ωt) in the first half, from x(T/2) = −x(0), ẋ alike."""
    delta, omega, rest, half = mpmath.mpf(2), mpmath.sqrt(396), mpmath.mpf(3) / 800, mpmath.pi / 5

    def parts(t, order):
        return [mpmath.re(unit * s**order * mpmath.exp(s * t)) for s in [mpmath.mpc(-delta, omega)]
                for unit in (1, mpmath.mpc(0, -1))]

    rows = [[a + b for a, b in zip(parts(half, order), parts(0, order), strict=True)] for order in (0, 1)]
    A, B = mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix([-2 * rest, 0]))

    def along(t, order):
        p, q = parts(t, order)
        return A * p + B * q

    square = mpmath.quad(lambda t: along(t, 2) ** 2, mpmath.linspace(0, half, 5)) / half
    return [mpmath.sqrt(square), along(mpmath.mpf("0.3"), 1)]


@pytest.mark.sweep
def test_under_a_square_wave():
    one = problem(ONE % SQUARE)
    found = list(subjects(one, [answer.asked for answer in one.spec.answers]))
    with mpmath.workdps(60):
        for subject, true in zip(found, by_halves(), strict=True):
            assert abs(subject.true.values[0] - true) < mpmath.mpf(10) ** -38
            ours = subject.ours()
            assert subject.error(ours.values, subject.true) <= ours.bound < 1e-11
    plain = next(run for run in integrators.attempts(found[1]) if (run.method, run.setting) == ("DOP853", "1e-09"))
    assert found[1].error(plain.run(Deadline(60)).values, found[1].true) < 1e-6


@pytest.mark.sweep
@pytest.mark.parametrize("head", ["rms(x'')", "mean(d.power)", "mean(x*F.force)", pytest.param(
    "mean(x'^4)", marks=pytest.mark.sweep)])
def test_means_over_all_times(head):
    """Of 2, 5 and √7 rad/s: Σ|X|²/2; of a fourth power 3/8 Σ|V|⁴ + 3/2 Σ|V|²|W|² of pairs."""
    one = problem(ONE % "(3 N)*sin((5 rad/s)*t) + (2 N)*cos(t*(2 rad/s)) + (1 N)*cos(sqrt(7)*t*(1 rad/s))")
    with mpmath.workdps(60):
        loads = [(mpmath.mpf(5), mpmath.mpc(0, -3)), (mpmath.mpf(2), mpmath.mpf(2)), (mpmath.sqrt(7), mpmath.mpf(1))]
        X = [(Omega, F / mpmath.mpc(800 - 2 * Omega**2, 8 * Omega), F) for Omega, F in loads]
        V = [(abs(Omega * x)) ** 2 for Omega, x, _ in X]
        exact = {"rms(x'')": lambda: mpmath.sqrt(sum(abs(Omega**2 * x) ** 2 for Omega, x, _ in X) / 2),
                 "mean(d.power)": lambda: 8 * sum(V) / 2,
                 "mean(x*F.force)": lambda: sum(mpmath.re(x * mpmath.conj(F)) for _, x, F in X) / 2,
                 "mean(x'^4)": lambda: 3 * sum(v * v for v in V) / 8 + 3 * (
                     V[0] * V[1] + V[0] * V[2] + V[1] * V[2]) / 2}[head]()
        subject, = subjects(one, [checked_quantity(one.spec, asked(head, "--of"))])
        assert abs(subject.true.values[0] - exact) < mpmath.mpf(10) ** -45 * abs(exact)
    ours = subject.ours()
    assert subject.error(ours.values, subject.true) <= ours.bound < 1e-11


@pytest.mark.parametrize(("force", "why"), [
    ("(3 N)*square((5 rad/s)*t) + (1 N)*sin(sqrt(2)*(5 rad/s)*t)", "no common period"),
    ("(3 N)*square((5 rad/s)*t) + (1 N)*sin((5.01 rad/s)*t)", "very many periods|no common period"),
    ("(3 N)*square((5 rad/s)*t) + (1 N)*exp(-t/(1 s))", "a reference of harmonics")])
def test_what_has_no_short_period_is_told(force, why):
    one = problem(ONE % force)
    found = list(subjects(one, [answer.asked for answer in one.spec.answers]))
    assert all(isinstance(subject, NotCompared) and re.search(why, subject.why) for subject in found)


def test_the_rule_is_exact_of_polynomials():
    with mpmath.workdps(50):
        rule = periodic.rule(30, 200)
        for power in (0, 7, 29):
            assert abs(sum(w * x**power for x, w in rule) - mpmath.mpf(1) / (power + 1)) < mpmath.mpf(10) ** -45


@pytest.mark.parametrize("shift", [0.1, 0.0123, 1.0])
def test_what_is_read_off_samples_is_no_coarser_than_these(shift):
    """Of ten waves in 4,000 steps, beside which a parabola is off by 2e-10 and more."""
    times = np.linspace(0, 63, 4001)
    values = np.exp(-0.01 * times) * np.sin(times + shift)
    assert _zero(times, values, 3) == pytest.approx(3 * np.pi - shift, rel=1e-14)
    turn = np.arctan(100) - shift
    assert extreme(times, values, "argmax") == pytest.approx(turn, rel=1e-11)
    assert extreme(times, -values, "min") == pytest.approx(-np.exp(-0.01 * turn) * np.sin(turn + shift), rel=1e-15)


def test_a_jump_of_the_slope_beside_a_zero_is_not_smoothed():
    times = np.linspace(0, 10, 101)
    values = np.where(times < 3.2, times - 2.95, 0.25 + 7 * (times - 3.2))
    assert _zero(times, values, 1) == pytest.approx(2.95, abs=1e-13)


BENT = """
bodies: {a: {mass: 2 kg, slide: x}}
springs: {s: {%s, between: [ground, a]}}
motion: full
initial: {x: %s, x': 40 mm/s}
answers: {period(x): 1 s}
"""


@pytest.mark.parametrize(("law", "start", "exact"), [
    pytest.param("k: 50 N/m, gap: 3 mm", "0 m", lambda: 2 * mpmath.pi / 5 + 3 / mpmath.mpf(10),
                 marks=pytest.mark.sweep),
    ("law: '(2 N)*sign(d)'", "5 mm", lambda: 4 * mpmath.sqrt(mpmath.mpf(116) / 10000))])
def test_periods_where_forces_bend_or_jump(law, start, exact):
    """2π/ω + 4·gap/v with play; 4√(2mA/F) of a constant force."""
    one = problem(BENT % (law, start))
    subject = period(one, one.spec.answers[0].asked.tree)
    with mpmath.workdps(60):
        assert abs(subject.true.values[0] - exact()) < mpmath.mpf(10) ** -30
    ours = subject.ours()
    assert subject.error(ours.values, subject.true) <= ours.bound <= 1e-11


@pytest.mark.sweep
def test_a_motion_that_loses_energy_or_goes_away_has_no_period():
    for law, why in (("k: 50 N/m, gap: 3 mm", "lose energy"), ("k: 50 N/m, acts: tension", "come back")):
        text = BENT % (law, "0 m") + "dampers: {d: {c: 1 N*s/m, between: [ground, a]}}\n" * (why == "lose energy")
        motion = full(problem(text.replace("x': 40", "x': -40")))
        with pytest.raises(PhysicsError, match=why):
            swings.period(motion, 1e-3)
