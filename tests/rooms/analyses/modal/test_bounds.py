"""Bounds that are told with frequencies, where the data themselves are rounded: irrational geometry against 50 digits.

Directions of inclined springs, arms of cranks and places of equilibrium are no floats; what their rounding does to a
frequency has to be within its bound, and the bound not far beyond what happens.
"""

import random
import statistics

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.numerics import factored_svd
from vibcli.numerics.factored_svd import UNIT, singular_vectors

FAR = 300       # times its error that a bound may be, in the median


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(60):
        yield


def drawn(dice, least=0.2, most=2.0):
    """A decimal, as people write them."""
    return f"{dice.uniform(least, most):.3f}"


def particle(dice):
    """A particle on four inclined springs and two inclined dampers, and what is given."""
    ends = [(drawn(dice, -2, 2), drawn(dice, 0.3, 2)) for _ in range(6)]
    springs = "".join(f"  s{i}: {{k: {drawn(dice, 100, 9e4)} N/m, between: [p, [{x} m, {y} m]]}}\n"
                      for i, (x, y) in enumerate(ends[:4]))
    dampers = "".join(f"  d{i}: {{c: {drawn(dice, 1, 40)} N*s/m, between: [p, [{x} m, {y} m]]}}\n"
                      for i, (x, y) in enumerate(ends[4:]))
    body = f"{{p: {{mass: {drawn(dice)} kg, at: [0, 0], move: [x, y, 0]}}}}"
    return f"bodies: {body}\nsprings:\n{springs}dampers:\n{dampers}"


def pendulum(dice):
    """A rod that hangs out of the vertical on an inclined spring; its equilibrium is searched for."""
    return f"""
gravity: 9.81 m/s^2
points: {{A: {{body: rod, at: [{drawn(dice)} m, -{drawn(dice)} m]}}}}
bodies: {{rod: {{shape: rod, mass: {drawn(dice)} kg, from: [0, 0], to: [1.1 m, -1.3 m], pin: {{at: [0, 0], by: phi}}}}}}
springs: {{s: {{k: {drawn(dice, 50, 900)} N/m, between: [A, [{drawn(dice, 2.2, 3)} m, {drawn(dice)} m]]}}}}
dampers: {{d: {{c: {drawn(dice, 1, 9)} N*s/m, between: [A, [{drawn(dice)} m, 2 m]]}}}}
"""


def cranks(dice):
    """Two bell cranks joined by an inclined spring, one on an inclined spring to the ground, with a damper."""
    bodies, points = "", ""
    for name, x, by in (("a", "0", "phi"), ("b", "2.5", "psi")):
        bodies += (f"  {name}: {{mass: {drawn(dice)} kg, inertia: {drawn(dice)} kg*m^2, at: [{x} m, 0], "
                   f"pin: {{at: [{x} m, 0], by: {by}}}}}\n")
        for corner in "PQ":
            points += (f"  {corner}{name}: {{body: {name}, at: [{float(x) + dice.uniform(-0.9, 0.9):.3f} m, "
                       f"{drawn(dice, 0.2, 0.9)} m]}}\n")
    return f"""
points:
{points}bodies:
{bodies}springs:
  s: {{k: {drawn(dice, 100, 9e3)} N/m, between: [Pa, Pb]}}
  w: {{k: {drawn(dice, 100, 9e3)} N/m, between: [Qa, [{drawn(dice)} m, -2 m]]}}
dampers: {{d: {{c: {drawn(dice, 1, 20)} N*s/m, between: [Qb, [1.3 m, -{drawn(dice)} m]]}}}}
"""


def found(scene):
    """[(value, exact, bound)] of every frequency and eigenvalue of a scene that is not zero."""
    sharp, sharp_damped = scene.modal.modes_to(50), scene.modal.damped_to(50)
    pairs = [(mode.omega or mode.growth_rate, exact.omega or exact.growth_rate, mode.error)
             for mode, exact in zip(scene.modal.modes, sharp, strict=True)]
    pairs += [(mode.eigenvalue, exact.eigenvalue, mode.error)
              for mode, exact in zip(scene.modal.damped, sharp_damped, strict=True)]
    return [(value, exact, bound) for value, exact, bound in pairs if exact]


@pytest.mark.sweep
@pytest.mark.parametrize("family", [particle, pendulum, cranks])
def test_no_frequency_of_irrational_geometry_is_beyond_its_bound(family):
    beyond, ratios = [], []
    for seed in range(30):
        scene = problem(family(random.Random(seed)))
        for value, exact, bound in found(scene):
            error = float(abs((mpmath.mpmathify(value) - exact) / exact))
            ratios.append(bound / max(error, 2.0**-56))
            if not error <= bound:
                beyond.append((seed, error, bound))
    assert not beyond
    assert len(ratios) >= 60 and statistics.median(ratios) < FAR


def test_the_fifty_digits_are_those_of_the_geometry():
    """K = Σ k n nᵀ of the particle, written out."""
    scene = problem("""
bodies: {p: {mass: 0.7 kg, at: [0, 0], move: [x, y, 0]}}
springs:
  a: {k: 300 N/m, between: [p, [1 m, 2 m]]}
  b: {k: 500 N/m, between: [p, [-3 m, 1 m]]}
""")
    K = mpmath.matrix(2, 2)
    for k, x, y in ((300, 1, 2), (500, -3, 1)):
        n = mpmath.matrix([x, y]) / mpmath.sqrt(x * x + y * y)
        K += k * n * n.T
    exact = [mpmath.sqrt(square / mpmath.mpf("0.7")) for square in mpmath.eigsy(K, eigvals_only=True)]
    for mode, wanted in zip(scene.modal.modes_to(50), exact, strict=True):
        assert abs(mode.omega / wanted - 1) < mpmath.mpf(10) ** -49


def graded(dice, n, condition):
    """A matrix whose rows differ in size by up to 1e12, and have the condition when made equally long."""
    u, v = (np.linalg.qr(dice.normal(size=(n, n)))[0] for _ in range(2))
    return 10 ** dice.uniform(-6, 6, n)[:, None] * (u * np.geomspace(1, 1 / condition, n)) @ v


@pytest.mark.sweep
@pytest.mark.parametrize("known", [1.0, 1e3])
@pytest.mark.parametrize("condition", [1.0, 1e2, 1e4])
def test_singular_values_of_a_factor_that_is_known_so_well(known, condition, monkeypatch):
    """Each within its bound of the factor before every entry was off by `known` roundings."""
    monkeypatch.setattr(factored_svd, "ENOUGH", 0.0)
    needed = []
    for seed in range(20):
        dice = np.random.default_rng(seed)
        n = int(dice.integers(3, 7))
        x = graded(dice, n, condition)
        off = x * (1 + known * UNIT * dice.choice([-1.0, 1.0], x.shape))
        values, _, bounds = singular_vectors(off, 0, known)
        exact = sorted(mpmath.svd_r(mpmath.matrix(x.tolist()), compute_uv=False), reverse=True)
        for value, wanted, bound in zip(values, exact, bounds, strict=True):
            error = float(abs(value / wanted - 1))
            assert error <= bound
            needed.append(error / UNIT)
    assert max(needed) > 0.3 * known        # so a bound that does not grow with `known` would be exceeded
