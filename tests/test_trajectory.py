"""Motion in time of the full equations, against closed forms and independent integrations."""

import math
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from motions import DOUBLE, PENDULUM, pendulum, problem

from vibcli.analyses.trajectory.simulate import simulate
from vibcli.errors import PhysicsError

# tests/motions.double_pendulum, started at (0.3, 0.5, 0, 0)
DOUBLE_AT_10 = [0.06119017075929614, 0.0954503879536078, 0.9151202995981838, 0.8611561862026417]


def pendulum_errors(amplitude, instants):
    """(largest error of the angle relative to the amplitude, error of the energy) over so many periods."""
    with mpmath.workdps(30):
        omega = mpmath.sqrt(mpmath.mpf("9.81") / mpmath.mpf("0.8"))
        period = pendulum(omega, amplitude, 0)[1]
    found = simulate(problem(PENDULUM), float(period) * max(instants), initial={"phi": amplitude})
    times = np.array(instants) * float(period)
    angles = found.at(times)[0][0]
    exact = [float(pendulum(omega, amplitude, mpmath.mpf(t))[0]) for t in times.tolist()]
    return np.abs(angles - exact).max() / amplitude, found.balance.error


@pytest.mark.parametrize("amplitude", [0.05, 1.0, 2.5])
def test_a_pendulum_of_a_thousand_periods(amplitude):
    phase, energy = pendulum_errors(amplitude, [0.123, 77.7, 499.91, 999.63])
    assert phase <= 1e-9 and energy <= 1e-12


def test_a_pendulum_close_to_its_upper_equilibrium():
    phase, energy = pendulum_errors(3.1, [0.3, 2.6, 9.3])
    assert phase <= 1e-10 and energy <= 1e-13


def test_a_double_pendulum():
    found = simulate(problem(DOUBLE), 10.0, initial={"p": 0.3, "r": 0.5})
    q, v, _ = found.at([10.0])
    assert np.abs(np.concatenate([q[:, 0], v[:, 0]]) - DOUBLE_AT_10).max() < 1e-13
    assert found.balance.error < 1e-13


def test_dense_output_obeys_the_equations_between_the_windows():
    found = simulate(problem(DOUBLE), 5.0, initial={"p": 1.3, "r'": 2})
    times = np.linspace(0, 5, 501)
    q, v, a = found.at(times)
    assert np.abs(found.system.accelerations(times, q, v) - a).max() < 1e-10 * np.abs(a).max()
    starts = [window.start for window in found.windows[1:]]
    before, after = found.at(np.array(starts) - 1e-13), found.at(starts)
    assert all(np.abs(x - y).max() < 1e-11 * np.abs(x).max() for x, y in zip(before, after, strict=True))


def test_time_runs_backwards_as_well():
    there = simulate(problem(DOUBLE), 3.0, initial={"p": 0.9, "r": -0.4})
    q, v, _ = there.at([3.0])
    back = simulate(problem(DOUBLE), 3.0, initial={"p": q[0, 0], "r": q[1, 0], "p'": -v[0, 0], "r'": -v[1, 0]})
    assert np.abs(back.at([3.0])[0][:, 0] - [0.9, -0.4]).max() < 1e-12


@pytest.mark.parametrize("size", [1e-9, 1e-3, 1.0, 1e6])
def test_units_of_length_do_not_matter(size):
    scene = ("parameters: {m: 3 kg, k: 48 N/m, x0: %r m}\nbodies: {block: {mass: m, slide: x}}\n"
             "energies: {V: k*x^2/2 + k*x^4/(4*x0^2)}\n")
    found = simulate(problem(scene % size), 20.0, initial={"x": size})
    reference = simulate(problem(scene % 1.0), 20.0, initial={"x": 1.0})
    times = np.linspace(0, 20, 50)
    assert np.abs(found.at(times)[0] / size - reference.at(times)[0]).max() < 1e-11


def test_a_driven_and_damped_oscillator_against_its_closed_form():
    scene = problem("parameters: {m: 2 kg, k: 50 N/m, c: 3 N*s/m, F: 4 N, Omega: 6 rad/s}\n"
                    "bodies: {block: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, block]}}\n"
                    "dampers: {d: {c: c, between: [ground, block]}}\n"
                    "forces: {drive: {at: block, force: F*sin(Omega*t)}}\n")
    found = simulate(scene, 30.0, initial={"x": 0, "x'": 0.7})
    times = np.linspace(0, 30, 200)
    decay, omega = 0.75, math.sqrt(25 - 0.75**2)
    steady = 4 / (50 - 2 * 36 + 3j * 6)
    x0, v0 = -steady.imag, 0.7 - (steady * 6j).imag
    free = np.exp(-decay * times) * (x0 * np.cos(omega * times) + (v0 + decay * x0) / omega * np.sin(omega * times))
    assert np.abs(found.at(times)[0][0] - free - (steady * np.exp(6j * times)).imag).max() < 1e-12
    assert found.balance.error < 1e-12
    assert found.balance.dissipated[-1] > 1 and found.balance.work[-1] > 1


def test_a_stiff_scene_takes_few_windows():
    scene = problem("parameters: {m: 1 kg, k: 1e9 N/m, c: 1e5 N*s/m, k0: 4 N/m}\n"
                    "bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}\n"
                    "springs: {s: {k: k0, between: [ground, a]}, t: {k: k, between: [a, b]}}\n"
                    "dampers: {d: {c: c, between: [a, b]}}\n")
    found = simulate(scene, 30.0, initial={"x": 0.1, "y": 0.1})
    assert len(found.windows) < 600
    times = np.linspace(0, 30, 100)
    assert np.abs(found.at(times)[0][0] - 0.1 * np.cos(math.sqrt(2) * times)).max() < 1e-8


def test_what_grows_without_bound_is_refused():
    scene = problem("parameters: {m: 1 kg, k: 4 N/m^3}\nbodies: {block: {mass: m, slide: x}}\n"
                    "energies: {V: -k*x^4/4}\n")
    with pytest.raises(PhysicsError, match="grows without bound"):
        simulate(scene, 50.0, initial={"x": 1.0})


def test_bad_requests_are_refused():
    with pytest.raises(PhysicsError, match="cannot end"):
        simulate(problem(PENDULUM), -1.0)
    with pytest.raises(PhysicsError, match="no coordinate"):
        simulate(problem(PENDULUM), 1.0, initial={"psi": 1.0})


def test_a_massless_coordinate_is_refused():
    scene = problem("parameters: {k: 4 N/m, m: 1 kg}\nbodies: {a: {mass: m, slide: x}, b: {slide: y}}\n"
                    "springs: {s: {k: k, between: [a, b]}, t: {k: k, between: [ground, a]}}\n")
    with pytest.raises(PhysicsError, match="no inertia moves with 'y'"):
        simulate(scene, 1.0, initial={"x": 0.1, "y": 0})


def test_windows_follow_one_another():
    found = simulate(problem(PENDULUM), 7.0, initial={"phi": 1})
    assert all(a.start + a.end == b.start for a, b in pairwise(found.windows))
    assert found.windows[-1].start + found.windows[-1].end == pytest.approx(7.0, rel=1e-14)
