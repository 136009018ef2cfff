"""True values of forces and places, of rms values, of frequency responses of members: beside closed forms, and beside
what the program answers by other means."""

import math
from itertools import islice, pairwise

import mpmath
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import assembled_modes, finite_elements, held_inputs, integrators
from vibcli.evidence.reference import member_responses
from vibcli.evidence.subject import Deadline
from vibcli.evidence.subjects import steady_states
from vibcli.evidence.subjects.beats import between_modes
from vibcli.evidence.subjects.motions import of_motion
from vibcli.quantities.expression import measure

ONE = """
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m, g: 9.81 m/s^2}
gravity: g
bodies: {a: {mass: m, slide: {by: x, along: [0, -1]}, at: [0, 0]}}
springs: {s: {k: k, between: [[0, 1 m], a]}}
dampers: {d: {c: c, between: [[0, 1 m], a]}}
forces: {F: {at: a, force: [0, %s]}}
motion: small
answers: {%s}
"""
BEAM = """
parameters: {L: 1.2 m, EI: 3 kN*m^2, mu: 2.1 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped}}
points: {tip: {body: arm, at: L}}
%s
forces: {F: {at: tip, force: 1 N}}
answers: {"frf[arm.u(L), F](20 Hz)": 1 mm/N%s}
"""
ABSORBER = """bodies: {a: {mass: 1.5 kg, slide: y}}
springs: {s: {k: 4 kN/m, between: [tip, a]}}
dampers: {d: {c: 12 N*s/m, between: [tip, a]}}"""


def asked(text):
    one = problem(text)
    return one, [answer.asked.tree for answer in one.spec.answers]


def test_the_force_of_a_spring_is_its_weight_and_what_swings():
    """m g + k x from x = 0 at rest where a damper and a step of the load act."""
    one, (tree,) = asked(ONE % ("(3 N)*step(t - 0.2 s)", "s.force(1 s): 1 N"))
    true = of_motion(one, tree).true
    with mpmath.workdps(60):
        m, k, c, F, T = mpmath.mpf(2), 800, 8, -3, mpmath.mpf("0.8")
        decay, turn = c / (2 * m), mpmath.sqrt(k / m - (c / (2 * m)) ** 2)
        swing = mpmath.cos(turn * T) + decay / turn * mpmath.sin(turn * T)
        x = F / mpmath.mpf(k) * (1 - mpmath.exp(-decay * T) * swing)
        assert abs(true.values[0] - (m * mpmath.mpf("9.81") + k * x)) < mpmath.mpf(10) ** -38
    assert measure(one, tree)[0] == pytest.approx(float(true.values[0]), rel=1e-13)


@pytest.mark.sweep
def test_an_acceleration_and_a_sum_of_forces():
    one, trees = asked(ONE % ("(3 N)*sin((17 rad/s)*t)", "\"x''(1 s)\": 1 m/s^2, \"max(s.force - 2*d.force)\": 1 N"))
    for tree in trees:
        true = of_motion(one, tree).true
        assert true.digits == 40 and measure(one, tree)[0] == pytest.approx(float(true.values[0]), rel=1e-12)


def test_beats_by_the_frequencies_that_others_find():
    """2π/(√102 − 10) of two pendulums with a soft spring between them."""
    one, (tree,) = asked("""
        bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
        springs: {s: {k: 100 N/m, between: [ground, a]}, t: {k: 100 N/m, between: [ground, b]},
          u: {k: 1 N/m, between: [a, b]}}
        initial: {x: 1 cm}
        answers: {beat_period(x): 1 s}""")
    found = between_modes(one, tree)
    with mpmath.workdps(found.true.working):
        assert abs(found.true.values[0] * (mpmath.sqrt(102) - 10) / (2 * mpmath.pi) - 1) < mpmath.mpf(10) ** -44
    methods = list(assembled_modes.attempts(found))
    assert "scipy eigh" in {run.method for run in methods}
    for answer in (found.ours(), *(run.run(Deadline(1)) for run in methods)):
        assert found.error(answer.values, found.true) <= (answer.bound or 1e-13)


@pytest.mark.sweep
def test_what_a_load_enters_itself_is_compared_where_all_is_linear():
    one, (tree,) = asked(ONE % ("(3 N)*sin((17 rad/s)*t)", "F.power(1 s): 1 W"))
    assert measure(one, tree)[0] == pytest.approx(float(of_motion(one, tree).true.values[0]), rel=1e-13)
    bent = ONE.replace("[[0, 1 m], a]}}\ndampers", "[[1 m, 1 m], a]}}\ndampers")
    one, (tree,) = asked(bent % ("(3 N)*sin((17 rad/s)*t)", "F.power(1 s): 1 W"))
    with pytest.raises(PhysicsError, match="quadratic in the motion"):
        of_motion(one, tree)


@pytest.mark.sweep
def test_at_the_start_there_is_nothing_to_integrate():
    one, (tree,) = asked(ONE % ("(3 N)*cos((17 rad/s)*t)", "x''(0 s): 1 m/s^2"))
    subject = of_motion(one, tree)
    (run,) = integrators.attempts(subject)
    assert not list(held_inputs.attempts(subject))
    assert run.method == "numpy solve" and run.run(Deadline(1)).values == pytest.approx([-1.5], rel=1e-15)


def test_an_rms_value_is_that_of_what_swings_about_where_it_rests():
    one, (tree,) = asked(ONE % ("(3 N)*sin((17 rad/s)*t) + 5 N", "rms(x): 1 cm"))
    found = steady_states.over_a_period(one, tree).true
    with mpmath.workdps(60):
        H = 3 / abs(mpmath.mpc(800 - 2 * 17**2, 8 * 17))
        rest = (mpmath.mpf("19.62") - 5) / 800
        assert abs(found.values[0] ** 2 - (H**2 / 2 + rest**2)) < mpmath.mpf(10) ** -45
    assert measure(one, tree)[0] == pytest.approx(float(found.values[0]), rel=1e-13)


FREE = """
parameters: {m: 2 kg, k: 800 N/m}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {s: {k: k, between: [a, b]}}
forces: {F: {at: a, force: %s}, G: {at: b, force: %s}}
answers: {'%s(x)': 1 cm}
"""


def test_what_is_free_to_move_swings_about_no_place_of_its_own():
    for head in ("amplitude", "rms"):
        one, _ = asked(FREE % ("(3 N)*sin((17 rad/s)*t)", "0 N", head))
        subject, = subjects(one, [answer.asked for answer in one.spec.answers], False)
        true = subject.true
        with mpmath.workdps(60):
            H = 3 * (800 - 2 * mpmath.mpf(17) ** 2) / (17**2 * (4 * mpmath.mpf(17) ** 2 - 3200))
            H = abs(H) / (1 if head == "amplitude" else mpmath.sqrt(2))
            assert abs(true.values[0] / H - 1) < mpmath.mpf(10) ** -38
    one, (tree,) = asked(FREE % ("(3 N)*sin((17 rad/s)*t) + 1 N", "-1 N", "rms"))
    with pytest.raises(PhysicsError, match="degenerate"):
        steady_states.over_a_period(one, tree)


@pytest.mark.sweep
def test_what_is_read_of_a_steady_state():
    """x = X cos(Ωt + φ) about x₀: powers, products and forces over a period, and the lag of what a shaker drives."""
    one, trees = asked(ONE % ("(3 N)*sin((17 rad/s)*t)", "mean(x^2*x'^2): 1 m^4/s^2, mean(s.force*x'): 0, "
                              "rms(d.power): 1 W, phase(s.force): 1"))
    with mpmath.workdps(60):
        W, rest = mpmath.mpf(17), mpmath.mpf("19.62") / 800
        H = 3 / mpmath.mpc(800 - 2 * 17**2, 8 * 17)
        X = abs(H)
        exact = [X**4 * W**2 / 8 + rest**2 * X**2 * W**2 / 2, 0, 4 * W**2 * X**2 * mpmath.sqrt(1.5),
                 mpmath.pi + mpmath.arg(H)]
        for tree, true in zip(trees, exact, strict=True):
            subject, = subjects(one, [answer.asked for answer in one.spec.answers if answer.asked.tree is tree])
            off = abs(abs(subject.true.values[0]) - abs(true))
            assert off < mpmath.mpf(10) ** -40 and subject.error(subject.ours().values, subject.true) < 1e-14
            for attempt in (next(integrators.attempts(subject)), next(held_inputs.attempts(subject))
                            ) if subject.asked == "mean(s.force*x')" else ():
                assert subject.error(attempt.run(Deadline(math.inf)).values, subject.true) < 1e-2


def test_a_beam_alone_has_the_receptance_of_its_closed_form():
    """At its tip (sin βL cosh βL − cos βL sinh βL)/(EI β³ (1 + cos βL cosh βL)), Bishop & Johnson (1960), ch. 7."""
    one = problem(BEAM % ("", ""))
    true = member_responses.value(one, "arm.u(L)", "F", lambda: 40 * mpmath.pi)
    with mpmath.workdps(60):
        L, EI, Omega = mpmath.mpf("1.2"), 3000, 40 * mpmath.pi
        b = (mpmath.mpf("2.1") * Omega**2 / EI) ** mpmath.mpf("0.25")
        sine, cosine, sinh, cosh = (f(b * L) for f in (mpmath.sin, mpmath.cos, mpmath.sinh, mpmath.cosh))
        assert abs(true.values[0] / ((sine * cosh - cosine * sinh) / (EI * b**3 * (1 + cosine * cosh))) - 1) < 1e-44


@pytest.mark.sweep
def test_with_an_absorber_ours_is_within_its_bound_and_elements_come_near():
    one = problem(BEAM % (ABSORBER, ", \"frf[y', F](7 Hz)\": 1 m/N/s"))
    for subject in subjects(one, [answer.asked for answer in one.spec.answers]):
        ours = subject.ours()
        assert subject.kind == "member response" and subject.true.digits >= 47
        assert subject.error(ours.values, subject.true) <= ours.bound < 1e-10
        errors = [subject.error(attempt.run(Deadline(60)).values, subject.true)
                  for attempt in finite_elements.attempts(subject)]
        assert min(errors) < 1e-6 < errors[0]


@pytest.mark.parametrize(("signal", "falls"), [("arm.u(0.3 m)", 8), ("arm.u'(0.5 m)", 8), ("arm.moment(0.6 m)", 3)])
def test_elements_come_near_of_what_is_within_members_under_loads_along_them(signal, falls):
    """Displacements by the fourth power of their length, moments by its square."""
    wind = "forces: {wind: {body: arm, per_length: (2 N/m^2)*x*cos((130 rad/s)*t)}}\n"
    one = problem(BEAM.partition("points")[0] + wind + f"answers: {{\"amplitude({signal})\": 0}}")
    subject, = subjects(one, [answer.asked for answer in one.spec.answers])
    errors = [subject.error(attempt.run(Deadline(60)).values, subject.true)
              for attempt in islice(finite_elements.attempts(subject), 1, 5)]
    assert all(fine < coarse / falls for coarse, fine in pairwise(errors)) and errors[-1] < 1e-2 / falls


def test_members_that_lose_energy_in_their_material_are_left_out():
    one = problem("damping: {modal: 1 %}\n" + BEAM % ("", ""))
    with pytest.raises(PhysicsError, match="lose energy"):
        member_responses.value(one, "arm.u(L)", "F", lambda: 40 * mpmath.pi)


@pytest.mark.sweep
def test_the_period_of_a_motion_is_none_of_a_mode():
    one = problem("parameters: {m: 2 kg, k: 100 N/m}\nbodies: {b: {mass: m, slide: x}}\n"
                  "springs: {s: {law: 'k*d + (10 N/m^3)*d^3', between: [ground, b]}}\nmotion: full\n"
                  "initial: {x: 0.1 m}\nanswers: {period(x): 1 s, 'period[1]': 1 s}\n")
    swing, modes = subjects(one, [answer.asked for answer in one.spec.answers])
    assert (swing.asked, swing.kind) == ("period(x)", "full motion") and modes.kind == "modes"


@pytest.mark.sweep
@pytest.mark.parametrize(("when", "push"), [("t - 0.2 s", 1), ("2*t - 0.4 s", 0.5), ("t", 1)])
def test_an_impulse_gives_a_velocity_and_no_other_method_is_asked(when, push):
    """x = J/(m ω_d) e^{−δ(t − t₀)} sin ω_d (t − t₀) about where it rests; down is positive, up is the impulse."""
    one, trees = asked(ONE % (f"(3 N*s)*impulse({when})", "x(1 s): 1 cm, \"x'(1 s)\": 1 cm/s, min(x): 1 cm"))
    found = [of_motion(one, tree) for tree in trees]
    with mpmath.workdps(60):
        m, k, c, tau = mpmath.mpf(2), 800, 8, 1 if when == "t" else mpmath.mpf("0.8")
        decay, turn, rest = c / (2 * m), mpmath.sqrt(k / m - (c / (2 * m)) ** 2), m * mpmath.mpf("9.81") / k
        size = -3 * push / (m * turn) * mpmath.exp(-decay * tau)
        x = rest + size * mpmath.sin(turn * tau)
        rate = size * (turn * mpmath.cos(turn * tau) - decay * mpmath.sin(turn * tau))
        top = mpmath.atan(turn / decay) / turn
        low = rest - 3 * push / (m * turn) * mpmath.exp(-decay * top) * mpmath.sin(turn * top)
        for subject, wanted in zip(found, (x, rate, low), strict=True):
            assert abs(subject.true.values[0] - wanted) < mpmath.mpf(10) ** -36 and subject.data is None
            ours = subject.ours()
            assert subject.error(ours.values, subject.true) <= ours.bound < 1e-12


def test_a_factor_of_an_impulse_counts_at_its_instant():
    one, (tree,) = asked(ONE % ("(3 N*s)*impulse(t - 0.2 s)*cos((4 rad/s)*t)", "x(1 s): 1 cm"))
    true = of_motion(one, tree).true
    assert measure(one, tree)[0] == pytest.approx(float(true.values[0]), rel=1e-12)
