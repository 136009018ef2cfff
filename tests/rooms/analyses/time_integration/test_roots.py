"""Full motions under forces that are roots of a deflection or a speed, as of contact: they have no series at its zero,
through which the motion passes."""

from math import gamma, pi, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from support.scenes import problem, value

from vibcli.analyses.time_integration.integrate import simulate


def quarter(m, k, p, A):
    """A quarter of the period of m ẍ + k |x|^p sign x = 0 of the amplitude A: B(1/(p + 1), 1/2)/(p + 1) · √(m (p + 1)/
    (2 k)) · A^((1 − p)/2)."""
    a = 1 / (p + 1)
    return sqrt(m * (p + 1) / (2 * k)) * A**((1 - p) / 2) * a * gamma(a) * sqrt(pi) / gamma(a + 0.5)


@pytest.mark.parametrize(("law", "p"), [
    ("k*sign(d)*abs(d)^(3/2)", 1.5), ("k*d*sqrt(abs(d))", 1.5), ("k*sign(d)*abs(d)^(5/2)", 2.5),
    ("k*sign(d)*sqrt(abs(d))", 0.5), ("k*sign(d)*abs(d)^(1/3)", 1 / 3), ("k*d*abs(d)^0.7", 1.7),
    ("k*(max(d, 0)^1.5 - max(-d, 0)^1.5)", 1.5)])
def test_a_spring_that_is_a_root_swings_with_the_exact_period(law, p):
    scene = problem(f"""
        parameters: {{m: 2, k: 900}}
        bodies: {{b: {{mass: m, slide: x}}}}
        springs: {{s: {{law: "{law}", between: [ground, b]}}}}
        initial: {{x: 0.04}}
        motion: full
        """)
    exact = quarter(2, 900, p, 0.04)
    found = simulate(scene.configuration, 5.5 * exact, initial=scene.initial.given)
    passages = [t for t, *_ in found.events]
    assert passages == pytest.approx([exact, 3 * exact, 5 * exact], rel=1e-11)
    assert found.balance.error < 1e-11


@pytest.mark.sweep
def test_a_ball_bounces_on_its_contact():
    """Hertz's law: against SciPy."""
    scene = problem("""
        parameters: {m: 2, k: 100000, g: 9.81}
        gravity: g
        bodies: {b: {mass: m, at: [0, 0.1], slide: {along: [0, 1], by: y}}}
        springs: {s: {law: "-k*max(-d - 0.1, 0)^1.5", stretch: y}}
        initial: {y: 0}
        motion: full
        find: [{response: {until: 0.5}}]
        """)
    states = solve_ivp(lambda t, y: [y[1], -9.81 + 5e4 * max(-y[0] - 0.1, 0)**1.5], (0, 0.5), [0, 0], rtol=1e-10,
                       atol=1e-13, max_step=1e-3).y[:, -1]
    assert [value(scene, "y(0.5)"), value(scene, "y'(0.5)")] == pytest.approx(states, rel=1e-6)


@pytest.mark.sweep
def test_a_damper_that_is_a_root_of_the_speed():
    scene = problem("""
        parameters: {m: 2, k: 100, c: 2}
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        dampers: {d: {law: "c*sign(v)*sqrt(abs(v))", between: [ground, b]}}
        initial: {x: 0.1}
        motion: full
        find: [{response: {until: 0.7}}]
        """)
    states = solve_ivp(lambda t, y: [y[1], -50 * y[0] - np.sign(y[1]) * np.sqrt(abs(y[1]))], (0, 0.7), [0.1, 0],
                       rtol=1e-10, atol=1e-13, max_step=1e-3).y[:, -1]
    assert [value(scene, "x(0.7)"), value(scene, "x'(0.7)")] == pytest.approx(states, rel=1e-6)
