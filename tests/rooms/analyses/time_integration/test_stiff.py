"""Stiff full motions: a fast oscillation too small to matter is stepped over, and is part of the stated error."""

import mpmath
import numpy as np
import pytest
from support.motions import problem

from vibcli.analyses.time_integration import collocation_step, error_scales
from vibcli.analyses.time_integration.integrate import simulate
from vibcli.analyses.time_integration.known_motion import known_motion
from vibcli.base.errors import PhysicsError
from vibcli.numerics.collocation_rule import rule
from vibcli.results.full_signals import FullSignal

TWO = """
motion: full
bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
springs: {s: {k: %s N/m, between: [ground, a]}, t: {k: %s N/m, between: [a, b]}}
initial: {x: %s m, y: %s m}
"""


def exact(soft, stiff, start, times):
    """x, y of both masses by the modes, in 40 digits."""
    with mpmath.workdps(40):
        k1, k2 = mpmath.mpf(soft), mpmath.mpf(stiff)
        values, modes = mpmath.eigsy(mpmath.matrix([[k1 + k2, -k2], [-k2, k2]]))
        parts = modes.T * mpmath.matrix(list(map(mpmath.mpf, start)))
        return np.array([[float(sum(modes[i, j] * parts[j] * mpmath.cos(mpmath.sqrt(values[j]) * mpmath.mpf(float(t)))
                                    for j in range(2))) for t in times] for i in range(2)])


@pytest.mark.sweep
@pytest.mark.parametrize(("springs", "start"), [(("1", "1e9"), ("0.1", "0.1")), (("1e9", "1"), ("0", "0.1"))])
def test_two_masses_on_springs_of_one_and_of_a_milliard(springs, start):
    scene = problem(TWO % (*springs, *start))
    found = known_motion(scene.configuration, 60.0, scene.initial.given)
    assert found.end == 60.0 and found.fast.part < 1e-6 and len(found.windows) < 4000
    times = np.linspace(0.3, 60, 23)
    off = np.abs(found.at(times)[0] - exact(*springs, start, times))
    scene.response._trajectory = found
    for i, name in enumerate(("x", "y")):
        signal = FullSignal(scene.response, scene.scene.q[i])
        assert all(off[i, k] <= 3 * signal.error(t) for k, t in enumerate(times)), (
            name, [(t, off[i, k], signal.error(t)) for k, t in enumerate(times)])
    assert off.max() < 1e-7
    assert found.balance.error < 1e-6


@pytest.mark.sweep
def test_a_fast_oscillation_that_matters_is_followed_or_the_motion_stopped():
    scene = problem(TWO % ("1", "1e9", "0.1", "0"))
    found = simulate(scene.configuration, 600.0, initial=scene.initial.given)
    assert found.fast is None
    with pytest.raises(PhysicsError, match="of at most 100000 steps"):
        found.at([600.0])
    times = np.linspace(0, found.end, 7)
    assert np.abs(found.at(times)[0] - exact("1", "1e9", ("0.1", "0"), times)).max() < 1e-7


@pytest.mark.parametrize("points", [24, 18])
@pytest.mark.parametrize("radians", [1.0, 30.0, 1e3, 1e6])
def test_radau_windows_never_let_an_oscillation_grow(points, radians):
    """The matrix that takes (ω q, q̇) over a window of q̈ = −ω² q has no eigenvalue beyond 1."""
    radau = rule(points, True)
    columns = []
    for q, v in ((1.0, 0.0), (0.0, 1.0)):
        A = np.linalg.solve(np.eye(points) + radians**2 * radau.V2.T, -radians**2 * (q + radau.c * v))
        columns.append((q + v + A @ radau.b2, v + A @ radau.w))
    matrix = np.array(columns).T * np.array([[1, radians], [1 / radians, 1]])
    assert np.abs(np.linalg.eigvals(matrix)).max() <= 1 + 1e-9


@pytest.mark.sweep
def test_one_inverse_serves_all_steps_of_a_window(monkeypatch):
    """Newton's method takes another only where it hardly comes nearer."""
    linearised, counts = collocation_step._linearised, []
    monkeypatch.setattr(collocation_step, "_linearised", lambda *args: counts.append(1) or linearised(*args))
    scene = problem(TWO.replace("k: %s N/m, between: [a", 'law: "%s", between: [a') % (
        "1", "(1e7 N/m)*d + (1e12 N/m^3)*d^3", "0.1", "0.11") + "dampers: {d: {c: 1e5 N*s/m, between: [a, b]}}\n")
    found = simulate(scene.configuration, 10.0, initial=scene.initial.given)
    assert len(found.windows) / 3 < len(counts) < 1.3 * len(found.windows)


@pytest.mark.parametrize(("k", "c"), [(-4.0, 0.0), (-4.0, -1.0), (-4.0, -5.0), (-4.0, 5.0), (3.0, 0.2), (0.0, -2.0),
                                      (0.0, 0.0), (-1.0, -2.0)])
def test_the_fastest_rate_of_one_degree_is_that_of_its_matrix(k, c):
    found = error_scales._fastest(np.array([[k]]), np.array([[c]]), np.ones(1))
    assert found == pytest.approx(np.abs(np.linalg.eigvals([[0.0, 1.0], [k, c]])).max(), rel=1e-7)
