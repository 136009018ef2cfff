"""Steady loads that turn with a body driven to and fro: equilibrium, K and small response against Lagrange's equation
by hand, J q̈ = Q(q, a) with the driven angle a = A sin Ωt, held at a = 0 in equilibrium."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.symbolic.evaluation import Floats, evaluate

W = 5.0
ARM = """
parameters: {A: 0.1, W: 5 rad/s}
bodies:
  arm: {pin: {at: [0 m, 0 m], by: A*sin(W*t)}, at: [0 m, 0 m]}
"""
BOB = ARM + """
  b: {mass: 2 kg, at: [0.4 m, -0.5 m], pin: {at: [0 m, 0 m], by: phi}}
springs: {t: {torsion: 50 N*m, between: [arm, b]}}
"""
BLOCK = ARM + """
  b: {mass: 2 kg, at: [1 m, 0 m], slide: {along: [0.6, 0.8], by: x}}
springs: {t: {k: 90 N/m, stretch: x}}
"""
NESTED = ARM.replace("A*sin", "0.4*A*sin") + """
  hand: {pin: {at: [0.3 m, 0 m], by: 0.6*A*sin(W*t), carrier: arm, relative: true}, at: [0.3 m, 0 m]}
  b: {mass: 2 kg, at: [0.4 m, -0.5 m], pin: {at: [0 m, 0 m], by: phi}}
springs: {t: {torsion: 50 N*m, between: [ground, b]}}
"""
DISC = ARM + """
  b: {mass: 0 kg, inertia: 0.82 kg*m^2, at: [0 m, 0 m], pin: {at: [0 m, 0 m], by: phi, carrier: arm, relative: true}}
points: {P: {body: b, at: [0.4 m, -0.5 m]}}
springs: {t: {torsion: 50 N*m, between: [arm, b]}}
"""
CRADLE = """
parameters: {A: 0.1, W: 5 rad/s}
bodies:
  arm: {slide: {along: [1, 0], by: (A*sin(W*t))*(1 m)}, at: [0 m, 0 m]}
  b: {mass: 2 kg, at: [0.4 m, -0.5 m], pin: {at: [0 m, 0 m], by: phi}}
springs: {t: {torsion: 50 N*m, between: [ground, b]}}
"""


def loaded(text, force, at="b", carrier="arm"):
    carried = f", carrier: {carrier}" if carrier else ""
    return text + f"forces: {{F: {{at: {at}, force: [{force}]{carried}}}}}\n"


def moment(p, a, fx, fy):
    """x F_y − y F_x of (0.4, −0.5) turned by p under a force turned by a."""
    x, y = 0.4 * mpmath.cos(p) + 0.5 * mpmath.sin(p), 0.4 * mpmath.sin(p) - 0.5 * mpmath.cos(p)
    return (x * (fx * mpmath.sin(a) + fy * mpmath.cos(a))
            - y * (fx * mpmath.cos(a) - fy * mpmath.sin(a)))


J = 2 * 0.41
SCENES = {
    "a bob": (loaded(BOB, "5 N, 0"), J, lambda p, a: moment(p, a, 5, 0) - 50 * (p - a)),
    "two components": (loaded(BOB, "-7 N, 9 N"), J, lambda p, a: moment(p, a, -7, 9) - 50 * (p - a)),
    "a force of the place": (loaded(BOB, "5 N + (20 N)*phi, 2 N"), J,
                             lambda p, a: moment(p, a, 5 + 20 * p, 2) - 50 * (p - a)),
    "a block": (loaded(BLOCK, "30 N, 40 N"), 2, lambda x, a: 30 * (0.6 * mpmath.cos(a) + 0.8 * mpmath.sin(a))
                + 40 * (0.8 * mpmath.cos(a) - 0.6 * mpmath.sin(a)) - 90 * x),
    "an arm on an arm": (loaded(NESTED, "5 N, 8 N", carrier="hand"), J,
                         lambda p, a: moment(p, a, 5, 8) - 50 * p),
    "a fixed force in a turning frame": (loaded(DISC, "5 N, 8 N", "P", None), J,
                                         lambda p, a: moment(p + a, 0, 5, 8) - 50 * p
                                         + J * W * W * a),
    "it turns with what it acts on": (loaded(DISC, "5 N, 8 N", "P"), J,
                                      lambda p, a: moment(p, 0, 5, 8) - 50 * p + J * W * W * a),
    "a carrier that does not turn": (loaded(CRADLE, "5 N, 8 N"), J, lambda p, a: moment(p, 0, 5, 8) - 50 * p),
    "beside what is in time": (loaded(BOB, "5 N + 0 N*cos(3 rad/s*t), 0").replace("forces: {", "forces: {U: {at: b, "
                               "unbalance: 0 kg*m, speed: 7 rad/s}, M: {body: b, moment: 3 N*m}, "), J,
                               lambda p, a: moment(p, a, 5, 0) + 3 - 50 * (p - a)),
}


def full(Q, inertia, start, speed, A, until, steps=400):
    """q(until) of J q̈ = Q(q, A sin Wt) by Runge and Kutta's rule, to some 1e-8 of its way."""
    def rates(t, q, v):
        return v, float(Q(q, A * mpmath.sin(W * t))) / inertia

    h, q, v = until / steps, start, speed
    for n in range(steps):
        t = n * h
        k1 = rates(t, q, v)
        k2 = rates(t + h / 2, q + h / 2 * k1[0], v + h / 2 * k1[1])
        k3 = rates(t + h / 2, q + h / 2 * k2[0], v + h / 2 * k2[1])
        k4 = rates(t + h, q + h * k3[0], v + h * k3[1])
        q += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0])
        v += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])
    return q


@pytest.mark.parametrize("name", SCENES)
def test_lagrange_by_hand(name):
    text, _, Q = SCENES[name]
    found = problem(text)
    q, = found.configuration.equilibrium.values.values()
    wanted = mpmath.findroot(lambda p: Q(p, 0), 0.1)
    K = -mpmath.diff(lambda p: Q(p, 0), wanted)
    assert q == pytest.approx(float(wanted), rel=1e-12)
    _, _, _, ours = found.configuration.linear_system.matrices()
    assert float(ours[0, 0]) == pytest.approx(float(K), rel=1e-12)
    slope = float(mpmath.diff(lambda a: Q(wanted, a), 0))
    for t in (0.0, 0.31, 1.7):
        at = {**found.configuration.at_rest, found.scene.time.name: t}
        driven = evaluate([found.symbolic.excitation.get(0, found.scene.table.zero)], Floats, at)[0]
        assert driven == pytest.approx(0.1 * slope * float(mpmath.sin(W * t)), abs=1e-12)


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["a bob", "a fixed force in a turning frame"])
def test_full_equations_at_small_amplitudes(name):
    """(q(A) − q(−A))/2A of the full equations tends to the small motion X sin Ωt as A → 0."""
    text, inertia, Q = SCENES[name]
    found = problem(text)
    q, = found.configuration.equilibrium.values.values()
    K = float(found.configuration.linear_system.matrices()[3][0, 0])
    at = {**found.configuration.at_rest, found.scene.time.name: mpmath.pi / (2 * W)}
    quarter = evaluate([found.symbolic.excitation[0]], Floats, at)[0]
    X = float(quarter) / 0.1 / (K - inertia * W * W)
    odd = [(full(Q, inertia, q, A * X * W, A, 1.0) - full(Q, inertia, q, -A * X * W, -A, 1.0)) / (2 * A)
           for A in (0.02, 0.01)]
    assert (4 * odd[1] - odd[0]) / 3 == pytest.approx(X * float(mpmath.sin(W)), rel=1e-6)
