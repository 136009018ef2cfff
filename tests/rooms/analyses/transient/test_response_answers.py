"""Extremes, zeros, steady states, limits and formulas of linear responses."""

import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from support.responses import FREE, STEP, case, chain, one, q, rates, systems, v
from support.scenes import problem_of

from vibcli import loads
from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.transient import free_vibration
from vibcli.analyses.transient.free_vibration import energy_shares
from vibcli.analyses.transient.high_precision import precise_value
from vibcli.analyses.transient.linear_response import linear_motion
from vibcli.analyses.transient.textbook_form import Part, formula, regime
from vibcli.base.errors import PhysicsError
from vibcli.report.sections.formulas import sum_of
from vibcli.symbolic.syntax import NameRef

COSINE = (Segment(0.0, (Wave(0, 1.0, 0, 2j),)),)


def close(x, y, tolerance=1e-13):
    return abs(x - y) <= tolerance * max(1.0, abs(y))


# extremes and zeros

def test_extremes_of_a_free_vibration():
    motion = one(1.0, 0.1, 9.0, FREE, 1.0)
    wd = math.sqrt(9 - 0.0025)
    assert motion.extreme(q(0), 0.0, 10.0, "max") == (0.0, 1.0)
    t, x = motion.extreme(q(0), 0.0, 10.0, "min")
    assert close(t, math.pi / wd) and close(x, -math.exp(-0.05 * math.pi / wd))


@pytest.mark.sweep
def test_the_earliest_of_equal_peaks_and_none_missed_among_thousands():
    motion = one(1.0, 0.0, 9.0, FREE, 0.0, 3.0)
    assert close(motion.extreme(q(0), 0.0, 1e4)[0], math.pi / 6)
    t, x = motion.extreme(q(0), 0.7, 1e4, "min")
    assert close(t, math.pi / 2) and close(x, -1.0)


@pytest.mark.parametrize("path", [
    "vibcli/examples/free_vibration.yaml", "problems/4_free_damped/roller_let_go_overdamped.yaml",
    "problems/6_two_degrees/pull_back_test_of_a_frame.yaml"])
def test_a_motion_that_is_let_go_is_largest_at_the_start(path):
    """At an instant that is exact, not at the zero of its slope, which is the same but for rounding."""
    problem = problem_of(Path(__file__).parents[4] / path)
    signals = [problem.response.signal(NameRef(0, 0, name, 0)) for name in problem.scene.coordinates]
    starts = [signal.values(np.zeros(1))[0] for signal in signals]
    largest = [signal.extreme(0.0, problem.response.until, 1) for signal in signals]
    assert any(start == most for start, (_, most) in zip(starts, largest, strict=True))
    assert all(t == 0.0 for start, (t, most) in zip(starts, largest, strict=True) if start == most)


def test_extremes_at_breaks_and_jumps():
    pieces = (Segment(0.0, (Wave(0, 1.0, 0, 0j),)), Segment(math.pi))
    motion = one(1.0, 0.0, 1.0, pieces)
    assert close(motion.extreme(q(0), 0.0, 20.0)[1], 2.0)
    assert motion.extreme(LinearOutput(a={0: 1.0}), 0.0, 2.0) == (0.0, 1.0)
    t, a = motion.extreme(LinearOutput(a={0: 1.0}), 0.0, 4.0, "min")
    assert close(t, math.pi) and close(a, -2.0)           # at once after the load is gone
    kink = one(1.0, 0.0, 0.0, (Segment(0.0), Segment(1.0, (), ((0, -2.0),))), 0.0, 1.0)
    assert kink.extreme(q(0), 0.0, 3.0) == (1.0, 1.0)


@pytest.mark.sweep
def test_extremes_and_zeros_against_a_fine_grid():
    rng = np.random.default_rng(6)
    swept = 0
    for _, M, C, K in systems(rng)[:8]:
        motion, times, _ = case(M, C, K, rng)
        end = times[3]
        t, near = np.linspace(0, end, 10_001), end / 40_000
        for output in (q(0), v(1), LinearOutput(a={0: 1.0}, q={1: 2.0})):
            y = motion.values(output, t)
            for sense, grid in (("max", y.max()), ("min", y.min())):
                at, found = motion.extreme(output, 0.0, end, sense)
                sign = 1 if sense == "max" else -1
                assert sign * (found - grid) >= -1e-13 * np.abs(y).max()
                assert abs(found - grid) <= 1e-4 * np.abs(y).max()
                assert close(motion.values(output, [at])[0], found, 1e-12) or at in motion.pieces(end).timeline.starts
            changes = np.flatnonzero(np.diff(np.sign(y)))
            zeros = motion.zeros(output, 0.0, end)
            assert len(zeros) == len(changes)
            before, after = (np.sign(motion.values(output, zeros + way * near)) for way in (-1, 1))
            assert (before == np.sign(y[changes])).all() and (after == np.sign(y[changes + 1])).all()
            swept += 1
    assert swept == 24


@pytest.mark.parametrize("pace", [0.02, 0.3, 5.0])
def test_zeros_where_jumps_pass_zero(pace):
    """The acceleration under a load of steps, short and long beside the period."""
    rng = np.random.default_rng(11)
    instants = np.append(0.0, np.cumsum(rng.uniform(0.5, 1.5, 25))) * pace
    loads = [(Wave(0, rng.uniform(-3, 3), 0, 0j),) for _ in instants]
    motion = one(1.0, 0.2, 4.0, [Segment(*pair) for pair in zip(instants, loads, strict=True)], 0.1)
    t = np.append(np.linspace(0, instants[-1], 20001), np.concatenate([instants - 1e-9, instants + 1e-9])[1:])
    t = np.sort(t[(t >= 0) & (t <= instants[-1])])
    y, found = motion.values(LinearOutput(a={0: 1.0}), t), motion.zeros(LinearOutput(a={0: 1.0}), 0.0, instants[-1])
    changes = np.flatnonzero(np.diff(np.sign(y)))
    assert len(found) == len(changes) and np.abs(found - t[changes]).max() <= instants[-1] / 20000


@pytest.mark.sweep
def test_zeros_passed_touched_and_levels():
    zeros = one(1.0, 0.0, 9.0, FREE, 0.0, 3.0).zeros(q(0), 0.0, 100.0)
    assert len(zeros) == 96 and np.abs(zeros - np.arange(96) * math.pi / 3).max() < 1e-13
    step = one(1.0, 0.0, 1.0, STEP)
    assert np.abs(step.zeros(q(0), 0.0, 20.0) - np.arange(4) * 2 * math.pi).max() < 1e-7
    assert np.abs(step.zeros(q(0)._replace(constant=-1.0), 0.0, 7.0) - [math.pi / 2, 3 * math.pi / 2]).max() < 1e-14
    late = one(1.0, 0.0, 1.0, (Segment(0.0), Segment(1.0, (Wave(0, 1.0, 0, 0j),))))
    assert len(late.zeros(q(0), 0.0, 0.9)) == 0
    damped = one(1.0, 0.2, 1.0, FREE, 1.0)
    late = damped.zeros(q(0), 300.0, 320.0)               # where x has fallen to 1e-13
    assert np.abs(np.diff(late) - math.pi / math.sqrt(1 - 0.01)).max() < 1e-12


# steady states

def test_steady_state_of_harmonic_loads():
    rng = np.random.default_rng(3)
    _, M, C, K = systems(rng)[0]
    n = len(M)
    waves = (Wave(0, 1 - 0.3j, 0, 1.7j), Wave(n, 0.4, 0, 1.7j), Wave(1, 0.5, 0, 0j), Wave(0, 1.0, 1, -0.5 + 0j))
    forcing = Forcing(n + 1, [Segment(0.0, (Wave(1, 2.0, 0, -0.1 + 0j),)), Segment(1.3, waves)])
    motion = linear_motion(M, C, K, forcing, np.ones(n), np.zeros(n))
    output = LinearOutput(0.3, q={0: 1.0}, v={1: 0.2}, a={0: 0.1}, channels={n: 1.0})
    steady, t = motion.steady, np.linspace(0, 30, 50)
    assert not steady.lasting
    y = steady.values(output, t)
    phasors = steady.phasors(output)
    assert [Omega for Omega, _ in phasors] == [0.0, 1.7]
    assert np.abs(sum((X * np.exp(1j * Omega * t)).real for Omega, X in phasors) - y).max() < 1e-14
    assert np.abs(motion.transient.values(output, t) + y - motion.values(output, t)).max() < 1e-13
    far = 40 / -rates(M, C, K).real.max()
    assert abs(motion.values(output, [far])[0] - steady.values(output, [far])[0]) < 1e-12
    grid = steady.values(output, np.arange(1000) * 2 * math.pi / 1.7 / 1000)
    assert close(steady.mean(output), grid.mean()) and close(steady.rms(output), math.sqrt((grid**2).mean()))


@pytest.mark.parametrize("speed", [0.7, 9.0, 60.0])
def test_rms_where_waves_turn_often_within_a_piece(speed):
    pieces = [Segment(0.0, (Wave(0, 1.0, 0, 1j * speed),)), Segment(7.0, (Wave(0, 0.5, 0, 0j),))]
    one_degree = (np.array([[entry]]) for entry in (1.0, 0.4, 1.2 * speed * speed))
    steady = linear_motion(*one_degree, Forcing(1, pieces, 10.0, 0.0), np.zeros(1), np.zeros(1)).steady
    x, w = np.polynomial.legendre.leggauss(20)
    edges = np.concatenate([np.linspace(0, 7, 201), np.linspace(7, 10, 101)[1:]])
    wide = np.diff(edges)[:, None]
    at, weight = edges[:-1, None] + wide * (x + 1) / 2, wide * w / 20
    for output in (q(0), v(0), LinearOutput(0.3, q={0: 2.0}, v={0: 0.1})):
        exact = math.sqrt(weight.ravel() @ steady.values(output, at.ravel()) ** 2)
        assert close(steady.rms(output), exact, 1e-12 * (1 + exact))


@pytest.mark.sweep
@pytest.mark.parametrize("damped", [True, False])
@pytest.mark.parametrize("since", [0.0, 0.5])
def test_steady_state_of_periodic_loads(damped, since):
    rng = np.random.default_rng(3)
    _, M, C, K = systems(rng)[0]
    n, C = len(M), C * damped
    pieces = [Segment(since, (Wave(0, 1.0, 0, 0j),)),
              Segment(since + 0.8, (Wave(0, -1.0, 0, 0j), Wave(1, 0.4, 1, 0.2j)), ((1, 0.1),))]
    forcing = Forcing(n, [Segment(0.0), *pieces] if since else pieces, 2.0, since)
    motion = linear_motion(M, C, K, forcing, np.ones(n), np.zeros(n))
    output, steady, t = LinearOutput(0.3, q={0: 1.0, 1: 0.5}, v={1: 0.2}), motion.steady, np.linspace(0, 9, 40)
    assert steady.lasting is not damped and steady.period == 2.0
    assert np.abs(steady.values(output, t) - steady.values(output, t + 6.0)).max() < 1e-12
    total = motion.transient.values(output, t) + steady.values(output, t)
    assert np.abs(total - motion.values(output, t)).max() < 1e-12
    if damped:
        far = 40 / -rates(M, C, K).real.max()
        assert abs(motion.values(output, [far])[0] - steady.values(output, [far])[0]) < 1e-10
    x, w = np.polynomial.legendre.leggauss(40)
    edges = np.array([0.0, 0.8, 2.0]) + since
    at = np.concatenate([a + (x + 1) / 2 * (b - a) for a, b in pairwise(edges)])
    weight = np.concatenate([w / 2 * (b - a) for a, b in pairwise(edges)]) / 2.0
    y = steady.values(output, at)
    assert close(steady.mean(output), weight @ y, 1e-12) and close(steady.rms(output), math.sqrt(weight @ y**2), 1e-12)
    for k in (1, 2, 5):
        assert abs(steady.harmonic(output, k) - 2 * weight @ (y * np.exp(-1j * math.pi * k * at))) < 1e-12


REFUSED = {
    "resonance": (0.0, 9.0, (Segment(0.0, (Wave(0, 1.0, 0, 3j),)),), "Ω = 3 rad/s is, to 12 digits, a natural"),
    "drift": (0.5, 0.0, STEP, "nothing holds"), "unstable": (-0.5, 4.0, COSINE, "the free motion grows"),
    "growing wave": (0.5, 4.0, (Segment(0.0, (Wave(0, 1.0, 1, 3j),)),), "the load grows"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_no_steady_state(name):
    c, k, pieces, message = REFUSED[name]
    with pytest.raises(PhysicsError, match=message) as refusal:
        one(1.0, c, k, pieces).steady.mean(q(0))
    assert refusal.value.hint


@pytest.mark.parametrize("damped", [True, False])
@pytest.mark.parametrize("since", [0.0, 1.5])
def test_what_follows_powers_of_the_time(damped, since):
    """Σ Qₖ tᵏ + Re Q e^{iΩt} obeys the equations of motion; the transient is the rest, and free of loads."""
    _, M, C, K = systems(np.random.default_rng(8))[0]
    n, C = len(M), C * damped
    waves = (Wave(0, 0.7, 3, 0j), Wave(1, -0.4, 1, 0j), Wave(0, 0.3, 0, 0j), Wave(1, 0.5 - 0.2j, 0, 1.3j))
    motion = linear_motion(M, C, K, Forcing(n, [Segment(0.0), Segment(since, waves)] if since else [
        Segment(0.0, waves)]), np.ones(n), np.zeros(n))
    steady, t = motion.steady, np.linspace(0, 4, 9)
    x, v1, v2 = (np.array([steady.values(q(i), t, order) for i in range(n)]) for order in range(3))
    tau, load = t - since, np.zeros((n, len(t)))
    load[0] = 0.7 * tau**3 + 0.3
    load[1] = -0.4 * tau + np.real((0.5 - 0.2j) * np.exp(1.3j * tau))
    size = np.abs(K).max() * (1 + np.abs(x).max())
    assert np.abs(M @ v2 + C @ v1 + K @ x - load).max() < 1e-12 * size
    found = np.array([steady.polynomial(q(i)) for i in range(n)])
    held = np.array([[X for _, X in steady.oscillating(q(i))] for i in range(n)])
    assert np.abs(found @ t ** np.arange(4)[:, None] + np.real(held @ np.exp(1.3j * t)[None]) - x).max() < 1e-12 * size
    total = motion.transient.values(q(0), t) + steady.values(q(0), t)
    assert np.abs(total - motion.values(q(0), t)).max() < 1e-12 * size
    if damped:
        far = 40 / -rates(M, C, K).real.max()
        assert abs(motion.transient.values(q(0), [far])[0]) < 1e-12 * size


def test_steady_part_without_damping():
    steady = one(1.0, 0.0, 9.0, COSINE).steady
    assert steady.lasting
    (Omega, X), = steady.phasors(q(0))
    assert Omega == 2.0 and close(X, 0.2)


def test_periodic_load_on_a_free_mass_needs_no_mean():
    pieces = (Segment(0.0, (Wave(0, 1.0, 0, 0j),)), Segment(1.0, (Wave(0, -1.0, 0, 0j),)))
    free_mass = linear_motion([[1.0]], [[0.0]], [[0.0]], Forcing(1, pieces, 2.0), [0.0], [0.0])
    assert close(free_mass.steady.values(v(0), [0.0])[0], -0.5) and free_mass.steady.lasting
    pieces = (Segment(0.0, (Wave(0, 1.0, 0, 0j),)), Segment(1.0))
    driven = linear_motion([[1.0]], [[0.0]], [[0.0]], Forcing(1, pieces, 2.0), [0.0], [0.0]).steady
    assert close(driven.mean(LinearOutput(a={0: 1.0})), 0.5)
    for seen in (q(0), v(0)):
        with pytest.raises(PhysicsError, match="nothing holds"):
            driven.mean(seen)


# limits

def test_final_values():
    assert close(one(1.0, 0.5, 4.0, STEP, 1.0).final(q(0)), 0.25)
    assert close(one(1.0, 0.5, 0.0, FREE, 1.0, 1.0).final(q(0)), 3.0)          # slides to rest
    assert close(one(1.0, 0.5, 0.0, STEP).final(v(0)), 2.0)
    assert close(one(1.0, 4.0, 4.0, STEP).final(q(0)), 0.25)                   # critical
    for motion, message in ((one(1.0, 0.0, 4.0, FREE, 1.0), "keeps vibrating"), (one(1.0, 0.5, 4.0, COSINE),
                            "loads oscillate"), (one(1.0, 0.0, 0.0, FREE, 0.0, 1.0), "drifts"),
                            (one(1.0, -0.5, 4.0, FREE, 1.0), "grows")):
        with pytest.raises(PhysicsError, match=message):
            motion.final(q(0))


# formulas

@pytest.mark.parametrize(("c", "k", "name"), [(0.0, 9.0, "undamped"), (0.5, 9.0, "under-damped"),
                                              (6.0, 9.0, "critically damped"), (10.0, 9.0, "over-damped"),
                                              (0.0, 0.0, "rigid"), (1.0, 0.0, "drag"), (-0.1, 9.0, "unstable")])
@pytest.mark.parametrize("pieces", [FREE, STEP, COSINE, (Segment(0.0, (Wave(0, -1j, 0, 3j), Wave(0, 1.0, 1, 0j))),)],
                         ids=["free", "step", "cosine", "resonance"])
def test_the_formula_is_the_motion(c, k, name, pieces):
    motion, t = one(1.0, c, k, pieces, 1.0, 2.0), np.linspace(0, 5, 60)
    assert regime(motion.M, motion.C, motion.K) == name
    parts = formula(motion, q(0))
    y = motion.values(q(0), t)
    assert np.abs(sum(part.at(t) for part in parts) - y).max() <= 1e-13 * np.abs(y).max()
    assert any(part.forced for part in parts) is (pieces is not FREE)


@pytest.mark.parametrize("until", [1.0, 100.0, 1e4, 1e6])
@pytest.mark.parametrize("off", [0.0, 1e-9, 1e-8, 1e-7, 1e-5, -1e-15, -1e-9, -1e-7, -1e-5])
def test_the_formula_is_the_motion_as_long_as_it_is_looked_at(until, off):
    """Next to a resonance, and next to critical damping: exponents are one only where nobody sees them part."""
    beside = (Segment(0.0, (Wave(0, 1.0, 0, 20j * (1 + off)),)),)
    for motion, end in ((one(1.0, 0.0, 400.0, beside), until),
                        (one(1.0, 40.0 * (1 + off), 400.0, FREE, 1.0), until / 1e5)):
        t = np.linspace(0, end, 2001)
        parts, y = formula(motion, q(0), until=end), motion.values(q(0), t)
        assert np.abs(sum(part.at(t) for part in parts) - y).max() <= 1e-6 * np.abs(y).max()


def test_printed_frequencies_are_told_apart_and_nothing_that_cancels_is_printed():
    motion = one(1.0, 0.0, 400.0, (Segment(0.0, (Wave(0, 1.0, 0, 20.0000002j),)),))
    late, early = (sum_of(formula(motion, q(0), until=until), "t") for until in (1e6, 1.0))
    assert late == "125000·cos(20·t) − 125000·cos(20.0000002·t)"
    assert early == "0.025·t·sin(20·t)"


@pytest.mark.parametrize("off", [0.0, 1e-15, -1e-15, 1e-13, -1e-13])
def test_critical_damping_is_one_exponential_however_it_is_rounded(off):
    """Of one degree, and of a mode among others."""
    c, until = 40.0 * (1 + off), 2.0
    one_mass = one(1.0, c, 400.0, FREE, 0.1, 0.3)
    beside = linear_motion(np.diag([1.0, 2.0]), np.diag([c, 0.0]), np.diag([400.0, 50.0]), Forcing(2, FREE),
                           [0.1, 1.0], [0.3, 0.0])
    for motion in (one_mass, beside):
        parts = formula(motion, q(0), until=until)
        assert sum_of(parts, "t") == "(0.1 + 2.3·t)·e^(−20·t)"
        assert not any(part.forced for part in parts)


def test_waves_are_sines_where_their_phase_is_a_right_angle():
    phases = {0.0: "2·cos(3·t)", math.pi / 2: "2·sin(3·t)", -math.pi / 2: "−2·sin(3·t)", math.pi: "−2·cos(3·t)",
              -math.pi: "−2·cos(3·t)", 1.0: "2·cos(3·t − 1)", -1.5708: "2·cos(3·t + 1.5708)"}
    for phase, text in phases.items():
        assert sum_of([Part(2.0, 0, 0.0, 3.0, phase, False)], "t") == text
    assert sum_of([Part(-2.0, 0, -1.0, 3.0, -math.pi / 2, False)], "t") == "2·e^(−t)·sin(3·t)"
    assert sum_of([Part(2.0, 0, 0.0, 1.0, 0.5, False), Part(1.0, 0, 1.0, 0.0, 0.0, False)], "t") == (
        "2·cos(t − 0.5) + e^(t)")


@pytest.mark.parametrize("coupling", [1e-9, 1e-7, 1e-5, 1e-2, 1.0])
def test_what_a_weak_coupling_feeds_is_no_zero(coupling):
    """Two equal oscillators, the second at rest: it moves by half the difference of the modes, however slowly."""
    K, t = np.array([[400 + coupling, -coupling], [-coupling, 400 + coupling]]), np.linspace(0, 20, 2001)
    motion = linear_motion(np.eye(2), np.zeros((2, 2)), K, Forcing(2, FREE), [1.0, 0.0], [0.0, 0.0])
    y = motion.values(q(1), t)
    parts = formula(motion, q(1), until=20.0)
    assert np.abs(sum(part.at(t) for part in parts) - y).max() <= 1e-6 * np.abs(y).max() + 1e-14


def test_amplitude_and_phase_of_the_textbook():
    part, = formula(one(1.0, 1.2, 9.0, FREE, 1.0, 2.0), q(0))
    wd = 3 * math.sqrt(1 - 0.04)
    assert close(part.rate, -0.6) and close(part.omega, wd)
    assert close(part.amplitude, math.hypot(1.0, 2.6 / wd)) and close(part.phase, math.atan2(2.6 / wd, 1.0))


def test_energies_of_modes():
    from vibcli.analyses.modal.undamped import undamped
    from vibcli.mechanics.factored_system import FactoredSystem

    elements = FactoredSystem(2, inertias=[(1.0, {0: 1.0}), (1.0, {1: 1.0})],
                                  springs=[(1.0, {0: 1.0}), (1.0, {0: -1.0, 1: 1.0}), (1.0, {1: 1.0})])
    motion = linear_motion(np.eye(2), np.zeros((2, 2)), [[2, -1], [-1, 2]], Forcing(2, FREE), [1.0, 0.0], [0.0, 0.0],
                           undamped(elements))
    assert np.allclose(energy_shares(motion.M, undamped(elements), motion.q0, motion.v0), [0.25, 0.75])


# numbers of free vibrations

def test_numbers_of_free_vibrations():
    motion = one(1.0, 0.5, 9.0, FREE, 1.0)
    part, = formula(motion, q(0))
    delta, period = free_vibration.decrement(part.rate, part.omega), 2 * math.pi / part.omega
    first, second = motion.values(q(0), [0.3, 0.3 + period])
    assert close(math.log(first / second), delta) and close(delta / math.hypot(2 * math.pi, delta), 0.5 / 6)
    assert close(free_vibration.cycles_to(0.1, delta), free_vibration.time_to(0.1, part.rate) / period)


def test_beats_are_named_where_one_hears_them():
    def motion(coupling, damping=0.0):
        return linear_motion(np.eye(2), damping * np.eye(2), [[10, -coupling], [-coupling, 10]], Forcing(2, FREE),
                             [1.0, 0.0], [0.0, 0.0])

    period = 2 * math.pi / (math.sqrt(10.5) - math.sqrt(9.5))
    assert close(free_vibration.beat_period(motion(0.5), q(0)), period, 1e-12)
    assert free_vibration.beat_period(motion(6.0), q(0)) is None                       # too far apart
    assert free_vibration.beat_period(motion(0.5, 1.0), q(0)) is None                  # dies out first
    assert free_vibration.beat_period(one(1.0, 0.0, 9.0, FREE, 1.0), q(0)) is None


# many digits

def test_many_digits():
    import mpmath

    with mpmath.workdps(60):
        t = mpmath.mpf("0.4")
        found = precise_value([[1]], [[0]], [[9]], Forcing(1, FREE), [1], [0], q(0), t, 50)
        assert abs(found - mpmath.cos(3 * t)) < mpmath.mpf(10) ** -49
        critical = precise_value([[1]], [[6]], [[9]], Forcing(1, STEP), [0], [0], q(0), t, 50, 1)
        assert abs(critical - t * mpmath.exp(-3 * t)) < mpmath.mpf(10) ** -49


@pytest.mark.sweep
def test_a_long_chain():
    n = 24
    K = chain(np.linspace(1, 3, n))
    C = 0.01 * K
    C[0, 0] += 0.1
    motion = linear_motion(np.eye(n), C, K, Forcing(n, COSINE), np.zeros(n), np.ones(n))
    M, C, K = (matrix.tolist() for matrix in (motion.M, C, K))
    exact = precise_value(M, C, K, motion.forcing, motion.q0, motion.v0, q(7), 9.0, 16)
    assert abs(motion.values(q(7), [9.0])[0] - exact) <= 1e-13


def test_zeros_are_counted_down_to_the_least_floats():
    """Far below the square root of the smallest, where products of two values vanish."""
    p = loads("""
        bodies: {b: {mass: 1 kg, slide: x}}
        springs: {s: {k: 100 N/m, between: [ground, b]}}
        dampers: {d: {c: 10 N*s/m, between: [ground, b]}}
        initial: {x: 1 m}
        find: [{response: {until: 200 s}}]
        """)
    rate = math.sqrt(75)
    for number in (100, 300, 370):
        assert p[f"zero[{number}](x)"].value == pytest.approx((math.atan2(-rate, 5) + number * math.pi) / rate)
    with pytest.raises(PhysicsError, match="371 times until t = 200 s, as far as floating-point numbers tell"):
        p["zero[390](x)"]
