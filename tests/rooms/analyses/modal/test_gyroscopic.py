"""Conservative gyroscopic systems: the real parts are zero exactly where the exact spectrum is imaginary."""

import random

import mpmath
import pytest
from support import families
from support.scenes import problem
from support.spectra import nearest, rate

from vibcli.analyses.modal.modes import natural_modes
from vibcli.mechanics.factored_system import FactoredSystem


@pytest.fixture(autouse=True)
def many_digits():
    with mpmath.workdps(100):
        yield


def spun(rng, n):
    kind = rng.choice((families.gyroscopic, families.held_by_spin, "indefinite", "free"))
    ratio, size = 10 ** rng.uniform(0, 4), 10 ** rng.uniform(-6, 6)
    if kind == "free":
        return families.gyroscopic(rng, n, ratio, size, grounded=False)
    if kind == "indefinite":
        base = families.preloaded(rng, n, ratio)
        return FactoredSystem(n, base.inertias, base.springs, K=base.K,
                                  G=families.gyroscopic(rng, n, ratio, size).G)
    return kind(rng, n, ratio, size)


@pytest.mark.sweep
def test_conservative_gyroscopic_systems_are_settled_as_the_exact_spectrum_is():
    """Re λ exactly zero where it is, growth where there is, nothing lost (n to 12, G from 1e-6 to 1e6)."""
    kinds = []
    for seed in range(40):
        rng = random.Random(seed)
        elements = spun(rng, 12 if not seed else rng.randrange(2, 6))
        exact = families.eigenvalues(elements)
        top, tiny = max(abs(x) for x in exact), mpmath.mpf(10) ** -40
        exact = [x for x in exact if abs(x) > top * tiny / 10 ** 5]
        grows = [x for x in exact if x.real > abs(x) * tiny and x.imag >= -abs(x) * tiny]
        swings = [x for x in exact if abs(x.real) <= abs(x) * tiny and x.imag > 0]
        modes = [mode for mode in natural_modes(elements) if not mode.rigid]
        assert len(modes) == len(grows) + len(swings)
        for mode in modes:
            value = nearest(swings if mode.growth_rate is None else grows, rate(mode))
            parts = [(mode.growth_rate, value.real)] * (mode.growth_rate is not None)
            parts += [(mode.omega, value.imag)] * bool(mode.omega)
            assert all(abs(a - b) <= mode.error * b for a, b in parts) and mode.error <= 2e-16
            kinds.append(mode.kind)
    assert kinds.count("oscillation") >= 60 and {"flutter", "divergence"} <= set(kinds)


def test_many_coordinates_held_by_spin_do_not_seem_to_grow():
    n, rng = 90, random.Random(3)
    base = families.chain(rng, n, 10.0)
    g = {(i - 1, i): rng.random() for i in range(1, n)} | {(0, 1): 60.0}
    g |= {(j, i): -x for (i, j), x in g.items()}
    modes = natural_modes(FactoredSystem(n, base.inertias, base.springs, G=g, K={(0, 0): -40.0, (1, 1): -40.0}))
    assert [mode.kind for mode in modes] == ["oscillation"] * n


TURNTABLE = """
parameters: {m: 2 kg, k: 300 N/m, turning: %s, h: 2*turning*sqrt(k*m)}
coordinates: {x: along the first springs, y: along the second springs}
matrices:
  M: [[m, 0], [0, m]]
  C: [[0, -h], [h, 0]]
  K: [[k, k/7], [k/7, 2*k]]
"""


@pytest.mark.parametrize("turning", [1, 100, 10**8])
def test_digits_are_those_of_the_data_whatever_precision_is_worked_in_outside(turning):
    """m² ω⁴ − (3 k m + h²) ω² + 2 k² − (k/7)² = 0: modes in floats within their bounds, and thirty digits."""
    with mpmath.workdps(15):
        modal = problem(TURNTABLE % turning).modal
        floats, digits = list(modal.modes), list(modal.modes_to(30))
    m, k = 2, mpmath.mpf(300)
    b, c = 3 * k * m + 4 * turning**2 * k * m, 2 * k**2 - (k / 7) ** 2
    high = (b + mpmath.sqrt(b * b - 4 * m * m * c)) / (2 * m * m)
    for near, mode, square in zip(floats, digits, (c / (m * m * high), high), strict=True):
        omega = mpmath.sqrt(square)
        assert abs(near.omega - omega) <= near.error * omega
        assert abs(mode.omega - omega) <= mpmath.mpf(10) ** -30 * omega


def test_loads_that_turn_velocities_alone_have_damped_modes():
    """(k₁ − mω²)(k₂ − mω²) = (bω)²; the natural frequencies are those without what loads make of velocities."""
    scene = problem("""
        parameters: {m: 0.3 kg, k: 900 N/m, l: 300 N/m, b: 20 kg/s}
        bodies: {d: {mass: m, at: [0, 0], move: [x, y]}}
        springs: {a: {k: k, between: [d, [1 m, 0]]}, c: {k: l, between: [d, [0, 1 m]]}}
        forces: {gx: {coordinate: x, value: "-b*y'"}, gy: {coordinate: y, value: "b*x'"}}
    """)
    for mode in scene.modal.damped:
        w = mode.omega_d
        assert not mode.eigenvalue.real
        assert float((900 - 0.3 * w**2) * (300 - 0.3 * w**2)) == pytest.approx(float((20 * w) ** 2), rel=1e-12)
