"""Long smooth motions of few coordinates are guessed by explicit steps in plain floats and refined in many windows at
once; what these cannot follow goes by collocation from window to window."""

import math

import mpmath
import numpy as np
import pytest
from support.motions import DOUBLE, FOUR_BAR, PENDULUM, problem

from vibcli.analyses.time_integration import refined_windows
from vibcli.analyses.time_integration.integrate import simulate
from vibcli.analyses.time_integration.known_motion import known_motion
from vibcli.analyses.time_integration.prepared_motion import PreparedMotion
from vibcli.analyses.time_integration.refined_windows import RefinedWindows, refinable
from vibcli.analyses.time_integration.refinement import ManyWindows, grids
from vibcli.base.errors import PhysicsError
from vibcli.bench.asked_motions import links
from vibcli.bench.trajectories import AT_100
from vibcli.mechanics.numeric_equations import NumericEquations

SPRUNG = """
parameters: {m: 2 kg, M: 3 kg, k: 80 N/m, L: 0.7 m}
gravity: 9.81 m/s^2
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, between: [[-1 m, 0], cart]}}
dampers: {d: {c: 0.3 N*s/m, between: [[-1 m, 0], cart]}}
forces: {f: {at: cart, force: [3 N*sin(2 rad/s*t), 0 N]}}
"""
BLOCK = """
parameters: {m: 1 kg, k: 9 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
"""
UNSUITED = {
    "loops": FOUR_BAR, "friction": BLOCK + "dampers: {f: {friction: 0.1 N, between: [ground, b]}}\n",
    "a pulse": BLOCK + "forces: {f: {at: b, force: 1 N*exp(-((t - 5 s)/(0.1 s))^2)}}\n",
    "a step": BLOCK + "forces: {f: {at: b, force: 1 N*step(t - 5 s)}}\n",
    "what bends": BLOCK.replace("k: k,", "law: k*d*abs(d)/(1 m),")}


def prepared(text, until=100.0, **initial):
    return PreparedMotion(problem(text).configuration, until, initial)


def suited(motion):
    return refinable(motion.system, motion.switching, motion.driven)


@pytest.fixture
def followed(monkeypatch):
    """How often motions went so, however short they are."""
    counts, follow = [0], RefinedWindows.follow

    def counting(self, march, limit):
        counts[0] += 1
        follow(self, march, limit)

    monkeypatch.setattr(refined_windows, "LONG", 1.0)
    monkeypatch.setattr(RefinedWindows, "follow", counting)
    return counts


@pytest.mark.parametrize("text", [PENDULUM, DOUBLE, SPRUNG], ids=["pendulum", "double pendulum", "driven"])
def test_accelerations_in_floats_are_those_of_arrays(text):
    motion, random = prepared(text), np.random.default_rng(3)
    found, system = suited(motion), motion.system
    for _ in range(20):
        t, q, v = random.uniform(0, 9), random.uniform(-3, 3, system.n), random.uniform(-3, 3, system.n)
        expected = system.accelerations(np.array([t]), q[:, None], v[:, None])[:, 0]
        assert np.allclose(found.accelerations(t, *q.tolist(), *v.tolist()), expected, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("text", [PENDULUM, DOUBLE, SPRUNG, links(5), BLOCK], ids=["1", "2", "driven", "5", "still"])
def test_slopes_of_accelerations_are_their_differences(text):
    system, random = prepared(text).system, np.random.default_rng(8)
    t, (q, v) = random.uniform(0, 9, 6), random.uniform(-1, 1, (2, system.n, 6))
    found = system.by_state(t, q, v, np.full(2 * system.n, 1e-6))
    for i, row in enumerate(found):
        step = 1e-5 * np.eye(2 * system.n)[i][:, None]
        ahead, back = (system.accelerations(t, q + sign * step[:system.n], v + sign * step[system.n:])
                       for sign in (1, -1))
        assert np.abs(row - (ahead - back) / 2e-5).max() < 1e-3 * max(np.abs(found).max(), 1.0)


@pytest.mark.parametrize("text", UNSUITED.values(), ids=list(UNSUITED))
def test_what_bends_is_tied_or_may_be_stepped_over_goes_by_collocation(text):
    assert suited(prepared(text)) is None


def test_a_pendulum_follows_elliptic_functions(followed):
    omega, k = math.sqrt(9.81 / 0.8), mpmath.sin(mpmath.mpf(1) / 2)
    for rtol, error in ((1e-8, 1e-5), (1e-10, 1e-7)):
        found = simulate(problem(PENDULUM).configuration, 20.0, rtol, {"phi": 1.0})
        times = np.linspace(0, 20, 41)
        exact = [float(2 * mpmath.asin(k * mpmath.ellipfun("cd", omega * t, m=k * k))) for t in times]
        q, _, a = found.at(times)
        assert np.abs(q[0] - exact).max() < error
        assert np.abs(a[0] + 9.81 / 0.8 * np.sin(q[0])).max() < 100 * error
    assert followed[0] == 2


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "initial"), [(DOUBLE, {"p": 0.9, "r": -0.4}), (SPRUNG, {"x": 0.2, "phi": 1.0})])
@pytest.mark.parametrize("asked", [1e-4, 1e-6, 3e-7])
def test_what_is_asked_holds_at_any_instant_and_the_estimate_holds(followed, text, initial, asked):
    one = problem(text)
    found = known_motion(one.configuration, 25.0, initial, asked)
    truth = simulate(one.configuration, 25.0, 1e-13, initial)
    assert followed[0] >= 2 and found.end == 25.0
    times = np.linspace(0, 25, 300)
    for i, (mine, true) in enumerate(zip(found.at(times)[0], truth.at(times)[0], strict=True)):
        off = np.abs(mine - true)
        assert off.max() <= asked * np.abs(true).max()
        for t, error in zip(times[5::20], off[5::20], strict=True):
            stated = 4 * found.shared.of_signal(lambda one, instants, i=i: one.at(instants)[0][i], t)
            assert error <= stated + 1e-12


def test_windows_follow_one_another_without_a_gap(followed):
    found = simulate(problem(DOUBLE).configuration, 30.0, 1e-9, {"p": 1.2, "r": 0.3})
    assert followed[0] == 1 and len(found.windows) > 10
    for one, other in zip(found.windows, found.windows[1:], strict=False):
        q, v, _ = one.state(one.end)
        assert np.abs(q - other.q).max() < 1e-13 and np.abs(v - other.v).max() < 1e-12
        assert abs(one.start + one.end - other.start) < 1e-13


def test_what_turns_out_stiff_goes_on_by_collocation(followed):
    """A damper that holds a spring back: the fast decay keeps explicit steps short for ever."""
    text = BLOCK + "dampers: {d: {c: 3e3 N*s/m, between: [ground, b]}}\n"
    one = problem(text)
    found = simulate(one.configuration, 40.0, 1e-9, {"x": 1.0})
    assert followed[0] and len(found.windows) < 300
    slow = (3e3 - math.sqrt(9e6 - 36)) / 2
    fast = (3e3 + math.sqrt(9e6 - 36)) / 2
    exact = (fast * math.exp(-slow * 40) - slow * math.exp(-fast * 40)) / (fast - slow)
    assert abs(found.at([40.0])[0][0, 0] - exact) < 1e-7


@pytest.mark.parametrize("V", ["log(1 - x/(1 m))", "(1 - x/(1 m))^(5/3)", "sqrt(1 - x/(1 m))"])
def test_where_forces_end_the_refusal_is_that_of_collocation(followed, V):
    text = f"parameters: {{m: 1 kg}}\nbodies: {{b: {{mass: m, at: [0, 0], slide: x}}}}\nenergies: {{V: 1 J*{V}}}\n"
    with pytest.raises(PhysicsError, match=r"cannot be followed beyond|are not defined"):
        simulate(problem(text).configuration, 40.0, 1e-9, {"x": 0.1, "x'": 2.0})


def test_many_windows_are_found_by_few_evaluations_of_all_their_points(monkeypatch):
    """Of 100 s of a double pendulum: windows by collocation took 1,950 evaluations, one after the other."""
    calls, steps, accelerations, init = [], [], NumericEquations.accelerations, RefinedWindows.__init__

    def counting(self, t, *rest):
        calls.append(len(t))
        return accelerations(self, t, *rest)

    def made(self, *args):
        init(self, *args)
        step = self.step
        self.step = lambda *args: steps.append(1) or step(*args)

    monkeypatch.setattr(NumericEquations, "accelerations", counting)
    monkeypatch.setattr(RefinedWindows, "__init__", made)
    found = simulate(problem(DOUBLE).configuration, 100.0, initial={"p": 0.3, "r": 0.5})
    assert len(calls) < 80 and sum(calls) < 60_000 and len(steps) < 500 and len(found.windows) < 130
    q, v, _ = found.at([100.0])
    assert np.abs(np.concatenate([q[:, 0], v[:, 0]]) - AT_100).max() < 1e-13


def test_the_points_of_every_window_obey_the_equations(followed):
    found = simulate(problem(SPRUNG).configuration, 60.0, initial={"x": 0.3, "phi": 2.0})
    assert followed[0] == 1 and len(found.windows) > 20
    for window in found.windows:
        q, v, a = window.states(window.rule.c * window.end)
        forces = found.system.accelerations(window.start + window.end * window.rule.c, q, v)
        assert np.abs(a - forces).max() < 1e-10 and np.abs(a - window.values).max() < 1e-10


@pytest.mark.sweep
def test_where_neighbours_part_a_stretch_is_found_up_to_where_it_can(followed):
    """A double pendulum that tumbles: its steps are known well to a few seconds ahead, not to the end of a stretch."""
    one = problem(DOUBLE)
    found = simulate(one.configuration, 20.0, initial={"p": 2.5, "r": 2.5})
    other = simulate(one.configuration, 20.0, 1e-10, {"p": 2.5, "r": 2.5})
    assert followed[0] == 2 and found.balance.error < 1e-12
    times = np.linspace(0.0, 6.0, 200)
    assert np.abs(found.at(times)[0] - other.at(times)[0]).max() < 1e-8


@np.errstate(all="ignore")
def test_a_stretch_finds_all_windows_from_a_rough_guess_or_the_first_where_forces_end():
    """Of x'' = -sin x, from a guess whose error grows with the time."""
    edges, omega = np.linspace(0.0, 20.0, 15), 0.937

    def guess(t):
        return [row[:, None, :] for row in (np.cos(omega * t), -omega * np.sin(omega * t))]

    start = np.array([1.0, 0.0])

    def slopes(t, Q, V, steps):
        return np.array([-np.cos(Q), np.zeros(Q.shape)])

    stretch = ManyWindows(lambda t, Q, V: -np.sin(Q), slopes, grids(24, 12), edges, start)
    found, A, states = stretch.refined(guess, np.array([1e-14]), np.array([1e-6, 1e-6]))
    assert found == 14
    exact = float(2 * mpmath.asin(mpmath.sin(0.5) * mpmath.ellipfun("cd", 20, k=mpmath.sin(0.5))))
    assert abs(states.ends[-1, 0] - exact) < 1e-12
    assert np.abs(A + np.sin(states.Q)).max() < 1e-12 and np.abs(states.gaps).max() < 1e-14
    ending = ManyWindows(lambda t, Q, V: np.where(t < 10.0, -np.sin(Q), np.nan), slopes, grids(24, 12), edges, start)
    assert ending.refined(guess, np.array([1e-14]), np.array([1e-6, 1e-6]))[0] == 7
