"""Motions and frequency responses of the reference beside closed forms."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.base.errors import PhysicsError
from vibcli.evidence.asked import NotCompared, subjects
from vibcli.evidence.methods import dense_grids, integrators
from vibcli.evidence.plain_equations import plain_equations
from vibcli.evidence.reference import frequency_response, harmonics, motion, steady_state
from vibcli.evidence.reference.taylor_steps import TakesMinutes
from vibcli.evidence.subject import Deadline

OSCILLATOR = """
bodies: {{b: {{mass: 1 kg, slide: x}}}}
springs: {{s: {{k: 25 N/m, between: [ground, b]}}}}
dampers: {{d: {{c: 2 N*s/m, between: [ground, b]}}}}
{more}
"""
PENDULUM = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}
gravity: g
bodies: {a: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}}
initial: {p: 1}
motion: full
"""


def oscillator(more):
    return problem_of(text_source(OSCILLATOR.format(more=more)))


def close(found, exact, digits=38):
    return abs(found - exact) <= mpmath.mpf(10) ** -digits * abs(exact)


@pytest.mark.sweep
def test_a_free_motion_and_where_it_turns():
    problem = oscillator("initial: {x: 25 cm, x': 1 m/s}")
    moving = motion.small(problem)
    node = moving.coordinate("x")
    found = motion.at_instant(moving, node, Fraction(7, 10), problem.work)
    top = motion.extremes(moving, node, Fraction(3), 1, False, problem.work)
    when = motion.extremes(moving, node, Fraction(3), 1, True, problem.work)
    with mpmath.workdps(60):
        w = mpmath.sqrt(24)

        def x(t):
            return mpmath.exp(-t) * (mpmath.cos(w * t) / 4 + mpmath.mpf(5) / 4 * mpmath.sin(w * t) / w)

        at = mpmath.findroot(lambda t: mpmath.diff(x, t), 0.15)
        assert close(found.values[0], x(mpmath.mpf(7) / 10))
        assert close(when.values[0], at, 25) and close(top.values[0], x(at))


def test_a_motion_from_where_a_force_lets_go():
    """F/k at t = 0, and the pendulum that a moment M holds at sin φ = M/(m g L)."""
    problem = oscillator("forces: {f: {at: b, force: 5 N}}\ninitial: {released: f}")
    moving = motion.small(problem)
    found = motion.at_instant(moving, moving.coordinate("x"), Fraction(1, 3), problem.work)
    with mpmath.workdps(60):
        w = mpmath.sqrt(24)
        t = 1 / mpmath.mpf(3)
        assert close(found.values[0], mpmath.exp(-t) * (mpmath.cos(w * t) + mpmath.sin(w * t) / w) / 5)
    swinging = problem_of(text_source(PENDULUM.replace("initial: {p: 1}\nmotion: full", "forces: {f: {body: a, moment: "
                                                       "3 N*m}}\ninitial: {released: f}")))
    moving = motion.small(swinging)
    with mpmath.workdps(60):
        start = mpmath.ldexp(moving.start(300)[0], -300)
        assert close(start, mpmath.asin(3 / mpmath.mpf("9.81")), 55)


@pytest.mark.sweep
def test_the_zeros_of_a_free_motion():
    """x = e^{−t} (cos √24 t + sin √24 t/√24)/4, whose rate begins at zero."""
    problem = oscillator("initial: {x: 25 cm}")
    moving = motion.small(problem)
    place, rate = (moving.coordinate("x", primes) for primes in (0, 1))
    with mpmath.workdps(60):
        w = mpmath.sqrt(24)
        for number in (1, 2):
            found = motion.zeros(moving, place, Fraction(2), number, problem.work).values[0]
            assert close(found, (number * mpmath.pi - mpmath.atan(w)) / w, 25)
            found = motion.zeros(moving, rate, Fraction(2), number, problem.work).values[0]
            assert close(found, (number - 1) * mpmath.pi / w, 25)
    plain = plain_equations(moving, place, 2.0, "zero 2")
    w, t = 24**0.5, plain.times
    states = np.exp(-t) * np.array([np.cos(w * t) + np.sin(w * t) / w, -25 * np.sin(w * t) / w])
    assert plain.read(states.T, t) == pytest.approx((2 * np.pi - np.arctan(w)) / w, rel=1e-9)
    with pytest.raises(PhysicsError, match="finds 3 zeros"):
        motion.zeros(moving, place, Fraction(2), 4, problem.work)


@pytest.mark.sweep
def test_the_period_of_a_wide_swing():
    """4 K(sin ½) √(L/g), the elliptic integral; by Taylor's series, as an integrator has it, and ours."""
    problem = problem_of(text_source(PENDULUM + "answers: {period(p): 2 s, period(2*p): 2 s}\n"))
    asked, double = (answer.asked for answer in problem.spec.answers)
    subject, = subjects(problem, [asked])
    with mpmath.workdps(50):
        exact = 4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(1) / 2) ** 2) / mpmath.sqrt(mpmath.mpf("9.81"))
        assert close(subject.true.values[0], exact, 28)
    assert subject.error(subject.ours().values, subject.true) < 1e-14
    dop853 = next(run for run in integrators.attempts(subject) if (run.method, run.setting) == ("DOP853", "1e-08"))
    assert subject.error(dop853.run(Deadline(math.inf)).values, subject.true) < 1e-6
    assert isinstance(next(subjects(problem, [double])), NotCompared)


@pytest.mark.sweep
def test_expanded_equations_are_themselves_followed():
    """p̈ = −(g/L)(p − p³/6) from p = 1: p̈ starts at −5/6 g/L, T = 4 ∫ dp/√(2 (V(1) − V(p)))."""
    text = PENDULUM.replace("motion: full", "motion: {order: 3}\nfind: [{response: {until: 1 s}}]")
    problem = problem_of(text_source(text + "answers: {period(p): 2 s, p''(0 s): 1 rad/s^2}\n"))
    period, start = subjects(problem, [answer.asked for answer in problem.spec.answers])
    with mpmath.workdps(40):
        g = mpmath.mpf("9.81")

        def slowness(s):        # p = 1 − s², near the turn 2 (V(1) − V(p)) = s² g (5/3 + s²/2 − …)
            p = 1 - s * s
            return 2 / mpmath.sqrt(g * (1 + p) * (1 - (1 + p * p) / 12))

        assert close(start.true.values[0], -5 * g / 6, 28)
        assert close(period.true.values[0], 4 * mpmath.quad(slowness, [0, 1]), 28)
    resting_elsewhere = text.replace("initial:", "forces: {f: {body: a, moment: 3 N*m}}\ninitial:")
    problem = problem_of(text_source(resting_elsewhere + "answers: {period(p): 2 s}\n"))
    assert "about a place that is known" in next(subjects(problem, [problem.spec.answers[0].asked])).why


def test_where_a_signal_may_touch_zero_there_is_no_reference():
    """1 − cos t comes back to zero after 2π."""
    problem = problem_of(text_source("bodies: {b: {mass: 1 kg, slide: x}}\nforces: {F: {at: b, force: 1 N*step(t)}}\n"
                                     "springs: {s: {k: 1 N/m, between: [ground, b]}}\n"))
    moving = motion.small(problem)
    with pytest.raises(PhysicsError, match="may touch zero"):
        motion.zeros(moving, moving.coordinate("x"), Fraction(8), 2, problem.work)


def test_a_load_that_begins_and_ends():
    problem = oscillator("forces: {F: {at: b, force: 5 N*(step(t - 0.3 s) - step(t - 0.7 s))}}")
    moving = motion.small(problem)
    found = motion.at_instant(moving, moving.coordinate("x"), Fraction(3, 2), problem.work)
    with mpmath.workdps(60):
        w = mpmath.sqrt(24)

        def step(t):
            return (1 - mpmath.exp(-t) * (mpmath.cos(w * t) + mpmath.sin(w * t) / w)) / 5

        assert close(found.values[0], step(mpmath.mpf(12) / 10) - step(mpmath.mpf(8) / 10))


@pytest.mark.sweep
def test_a_pendulum_by_elliptic_functions():
    problem = problem_of(text_source(PENDULUM))
    swinging = motion.full(problem)
    found = motion.at_instant(swinging, swinging.coordinate("p"), Fraction(7, 3), problem.work)
    with mpmath.workdps(50):
        w, k = mpmath.sqrt(mpmath.mpf("9.81")), mpmath.sin(mpmath.mpf(1) / 2)
        assert close(found.values[0], 2 * mpmath.asin(k * mpmath.ellipfun("cd", w * mpmath.mpf(7) / 3, m=k * k)), 30)


@pytest.mark.sweep
def test_a_friction_that_turns_about_where_a_step_before_shows_nothing_of_it():
    """v̇ = −a tanh(v/u): sinh(v/u) falls as exp(−a t/u)."""
    problem = problem_of(text_source("""
bodies: {b: {mass: 1 kg, slide: x}}
dampers: {d: {law: (1 N)*tanh(v/(0.1 mm/s)), between: [ground, b]}}
initial: {x': 0.3 m/s}
motion: full
"""))
    sliding = motion.full(problem)
    found = motion.at_instant(sliding, sliding.scene.v[0], Fraction(3, 10), problem.work)
    with mpmath.workdps(50):
        exact = mpmath.asinh(mpmath.sinh(3000) * mpmath.exp(-3000)) / 10000
        assert close(found.values[0], exact, 25)
        later = motion.at_instant(sliding, sliding.coordinate("x"), Fraction(1, 2), problem.work).values[0]
        assert close(problem.until(0.5).response.value_to(problem.scene.q[0], Fraction(1, 2), 20), later, 18)


def test_what_takes_minutes_tells_how_far_it_came():
    problem = problem_of(text_source(PENDULUM))
    swinging = motion.full(problem)
    with pytest.raises(TakesMinutes) as refusal:
        swinging.steps(Fraction(1000), 30, problem.work, 1e6)
    assert 0 < refusal.value.reached < 1000


def test_a_frequency_response_its_peak_and_its_steady_state():
    problem = oscillator("forces: {F: {at: b, force: 5 N*cos(4 rad/s*t)}}")
    with mpmath.workdps(60):
        there = frequency_response.value(problem, "x", "F", lambda: mpmath.mpf(4)).values[0]
        assert close(there, 1 / mpmath.mpc(9, 8), 45)
        assert close(frequency_response.peak(problem, "x", "F", 1, True).values[0], mpmath.sqrt(23), 45)
        assert close(frequency_response.peak(problem, "x", "F", 1, False).values[0], 1 / (2 * mpmath.sqrt(24)), 45)
        moving = motion.small(problem)
        steady = steady_state.of_wave(steady_state.driven(moving), moving.coordinate("x", 1), "amplitude").values[0]
        assert close(steady, 20 / mpmath.sqrt(145), 45)
        squares = 23 - 4 * mpmath.sqrt(6), 23 + 4 * mpmath.sqrt(6)      # of Ω at which |H|² is half that of the peak
        for number, square in enumerate(squares, 1):
            assert close(frequency_response.half_power(problem, "x", "F", number).values[0], mpmath.sqrt(square), 45)
    with pytest.raises(PhysicsError, match="finds 1 peak"):
        frequency_response.peak(problem, "x", "F", 2, True)


@pytest.mark.sweep
def test_antiresonances_of_what_nothing_damps_and_grids_that_see_them():
    """Of the first of two: Ω² = k/m of the second; the damped one beside it is where d|H|²/dΩ = 0."""
    text = ("bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 2 kg, slide: y}}\n"
            "springs: {s: {k: 30 N/m, between: [ground, a]}, u: {k: 18 N/m, between: [a, b]}}\n"
            "forces: {F: {at: a, force: 1 N*sin(5 rad/s*t)}}\nanswers: {'antiresonance[1](frf[x, F])': 3 rad/s}\n%s")
    plain, damped = (problem_of(text_source(text % more)) for more in (
        "", "dampers: {d: {c: 0.1 N*s/m, between: [a, b]}}"))
    assert close(frequency_response.antiresonance(plain, "x", "F", 3.0).values[0], 3, 45)
    for problem in (plain, damped):
        subject, = subjects(problem, [answer.asked for answer in problem.spec.answers])
        assert subject.error(subject.ours().values, subject.true) < 1e-13
        errors = [subject.error(run.run(Deadline(math.inf)).values, subject.true)
                  for run in list(dense_grids.attempts(subject))[:2]]
        assert 1e-2 > errors[0] > 3 * errors[1]
    with pytest.raises(PhysicsError, match="no minimum near 4"):
        frequency_response.antiresonance(plain, "x", "F", 4.0)


@pytest.mark.parametrize("force", ["5 N*cos(4 rad/s*t) + 1 N*cos(5 rad/s*t)", "5 N*cos(4 rad/s*t)^2",
                                   "5 N*square(4 rad/s*t)", "5 N"])
def test_loads_of_several_frequencies_have_no_reference(force):
    problem = oscillator(f"forces: {{F: {{at: b, force: {force}}}}}")
    with pytest.raises(PhysicsError, match="a reference of steady states"):
        moving = motion.small(problem)
        steady_state.of_wave(steady_state.driven(moving), moving.coordinate("x"), "amplitude")


@pytest.mark.sweep
def test_harmonics_under_a_square_wave():
    """4F/(nπ)/|k − m(nΩ)² + inΩc| of odd ones; of |sin Ωt| the fundamental is another."""
    problem = oscillator("forces: {F: {at: b, force: 5 N*square(4 rad/s*t)}}\n"
                         "answers: {'harmonic[3](x)': 1 m}")
    third, = subjects(problem, [answer.asked for answer in problem.spec.answers])
    with mpmath.workdps(60):
        assert close(third.true.values[0], 20 / (3 * mpmath.pi) / abs(mpmath.mpc(25 - 144, 24)), 45)
    assert third.error(third.ours().values, third.true) < 1e-14
    moving = motion.small(oscillator("forces: {F: {at: b, force: 5 N*abs(sin(4 rad/s*t))}}"))
    with pytest.raises(PhysicsError, match="repeat itself within the period"):
        harmonics.harmonic(harmonics.repeated(moving), moving.coordinate("x"), 1)
