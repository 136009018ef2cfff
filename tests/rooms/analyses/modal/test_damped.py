"""Damped eigenvalues and modes against mpmath fed the same element data."""

import math
import random
import statistics
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from support import families
from support.characteristic_roots import roots
from support.spectra import nearest

from vibcli.analyses.modal import method
from vibcli.analyses.modal.damped import damped
from vibcli.analyses.modal.normalisation import normalised
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.numerics.precision import estimated_steps

EPS = 2.0 ** -52


@pytest.fixture(autouse=True)
def seventy_digits():
    with mpmath.workdps(70):
        yield


def free_damped(rng, n, ratio, size):
    return families.damped_chain(rng, n, ratio, size, grounded=False)


def free_gyroscopic(rng, n, ratio, size):
    return families.gyroscopic(rng, n, ratio, size, grounded=False)


FAMILIES = (families.damped_chain, free_damped, families.gyroscopic, free_gyroscopic, families.rotor)


@pytest.mark.sweep
def test_exact_roots_are_those_of_the_qr_algorithm():
    """The reference of these tests; where roots are double it gives none."""
    for family in FAMILIES:
        elements = family(random.Random(4), 3, 1e3, 0.1)
        found = roots(families.pencil(elements)[::-1])
        for exact in sorted(families.by_qr(elements), key=lambda x: -abs(x)):
            root = nearest(found, exact)
            assert abs(root - exact) <= (abs(exact) * mpmath.mpf(10) ** -35 if root else mpmath.mpf(10) ** -30)
        assert not found
    assert roots([mpmath.eye(2)] * 3) is None


def expanded(modes):
    """(eigenvalue, mode), both of each conjugate pair."""
    for mode in modes:
        yield mode.eigenvalue, mode
        if mode.eigenvalue.imag:
            yield mode.eigenvalue.conjugate(), mode


def matched(elements, modes, exact=None):
    """(eigenvalue, exact, mode) one to one, and the exact eigenvalues that are left."""
    left, out = list(exact or families.eigenvalues(elements)), []
    for value, mode in sorted(expanded(modes), key=lambda pair: -abs(pair[0])):
        i = min(range(len(left)), key=lambda i: abs(left[i] - value))
        out.append((value, left.pop(i), mode))
    return out, left


def close(value, exact, mode, top):
    if value == 0:
        return abs(exact) <= top * mpmath.mpf(10) ** -25
    return abs(mpmath.mpc(value) - exact) <= mode.error * abs(exact)


def sampled(family, count, largest):
    for seed in range(count):
        rng = random.Random(seed)
        n, size = rng.randrange(1, largest + 1), 10 ** rng.uniform(-12, 8)
        elements = family(rng, n, 10 ** rng.uniform(0, 6), size)
        if elements.G or elements.dampers:
            yield elements


@pytest.mark.sweep
@pytest.mark.parametrize("family", FAMILIES)
def test_every_eigenvalue_to_the_last_digit_within_its_bound(family):
    ratios, swept = [], 0
    for elements in sampled(family, 30, 5):
        pairs, left = matched(elements, damped(elements))
        top = max(abs(x) for _, x, _ in pairs)
        assert all(abs(x) <= top * mpmath.mpf(10) ** -25 for x in left)
        for value, exact, mode in pairs:
            assert close(value, exact, mode, top)
            assert mode.error <= 1e-15
            noise = abs(exact) * mpmath.mpf(10) ** -33
            assert not value or abs(value.real - exact.real) <= 2 * EPS * abs(exact.real) + noise
            swept += 1
            if value and value != exact:
                ratios.append(mode.error / float(abs(mpmath.mpc(value) - exact) / abs(exact)))
    assert swept >= 100
    assert statistics.median(ratios) <= 1e4


@pytest.mark.sweep
def test_anything_at_all():
    """Indefinite, gyroscopic, free and barely damped systems with every strength from 1e-20 to 1e20."""
    swept = 0
    for seed in range(120):
        rng = random.Random(seed)
        elements = families.anything(rng, rng.randrange(1, 5), 1e20)
        modes = damped(elements)
        if modes is not None:
            with mpmath.workdps(150):
                pairs, left = matched(elements, modes)
                top = max(abs(x) for _, x, _ in pairs)
                assert all(abs(x) <= top * mpmath.mpf(10) ** -40 for x in left)
                assert all(close(value, exact, mode, top) for value, exact, mode in pairs)
                assert max(mode.error for mode in modes) <= 1e-13
            swept += len(pairs)
    assert swept >= 300


@pytest.mark.sweep
@pytest.mark.parametrize("family", FAMILIES)
def test_shapes_satisfy_the_equations(family):
    for elements in sampled(family, 12, 6):
        m, c, k = families.pencil(elements)
        for mode in damped(elements):
            value = mpmath.mpc(mode.eigenvalue)
            x = mpmath.matrix([mpmath.mpmathify(z) for z in mode.shape.tolist()])
            assert abs((x.H * m * x)[0] - 1) <= 1e-13
            residual = value * value * (m * x) + value * (c * x) + k * x
            size = abs(value) ** 2 * mpmath.norm(m) + abs(value) * mpmath.norm(c) + mpmath.norm(k)
            assert mpmath.norm(residual) <= 1e-14 * size * mpmath.norm(x)


@pytest.mark.sweep
@pytest.mark.parametrize("family", (families.gyroscopic, free_gyroscopic))
def test_conservative_gyroscopic_systems_neither_grow_nor_decay(family):
    for elements in sampled(family, 40, 8):
        for mode in damped(elements):
            assert mode.eigenvalue.real == 0 and mode.growth_rate is None
            assert mode.zeta == 0 or mode.eigenvalue == 0


def test_spinning_top_is_held_upright_by_its_spin():
    for spin, stands in ((1.9, False), (2.1, True), (40.0, True)):
        elements = FactoredSystem(2, [(1.0, {0: 1.0}), (1.0, {1: 1.0})], K={(0, 0): -1.0, (1, 1): -1.0},
                                      G={(0, 1): spin, (1, 0): -spin})
        modes = damped(elements)
        assert all((mode.growth_rate is None) == stands for mode in modes if mode.eigenvalue.real >= 0)
        assert all(mode.eigenvalue.real == 0 for mode in modes) == stands


def oscillator(m, c, k):
    return FactoredSystem(1, [(m, {0: 1.0})], [(k, {0: 1.0})], [(c, {0: 1.0})])


def test_one_degree_of_freedom_of_any_damping():
    for zeta in (0.0, 1e-12, 0.3, 1 - EPS / 2, 1.0, 1 + EPS, 2.0, 1e8, 1e150):
        modes = damped(oscillator(1.0, 8.0 * zeta, 16.0)) if zeta else []
        for mode in modes:
            assert mode.zeta == pytest.approx(zeta, rel=EPS)
            assert mode.omega == 4.0 and mode.index == 1
        if zeta >= 1:
            slow, fast = (mode.eigenvalue for mode in modes)
            z = mpmath.mpf(zeta)
            exact = -4 / (z + mpmath.sqrt(z * z - 1))
            assert abs(slow.real - exact) <= EPS * abs(exact)
            assert abs(fast.real - 16 / exact) <= EPS * 16 / abs(exact)
            assert slow.imag == fast.imag == 0


def test_critical_damping_is_decided_exactly():
    assert [mode.note for mode in damped(oscillator(1.0, 4.0, 4.0))] == ["ζ = 1", "ζ = 1"]
    below, = damped(oscillator(1.0, math.nextafter(4.0, 0), 4.0))
    assert below.note == "ζ = 1 within 1 ulp" and below.omega_d > 0
    above = damped(oscillator(1.0, math.nextafter(4.0, 9), 4.0))
    assert [mode.note for mode in above] == ["ζ = 1 within 1 ulp"] * 2
    assert above[0].eigenvalue.real > above[1].eigenvalue.real
    data = oscillator(Fraction(1, 10), Fraction(2, 5), Fraction(2, 5))
    assert {mode.note for mode in damped(oscillator(0.1, 0.4, 0.4), exact=lambda: data)} == {"ζ = 1"}
    assert damped(oscillator(1.0, 4.1, 4.0))[0].note is None


def test_nearly_equal_roots_of_coupled_modes_keep_their_digits():
    def system(c):
        return FactoredSystem(2, [(1.0, {0: 1.0}), (1.0, {1: 1.0})],
                                  [(1.0, {0: 1.0}), (1.0, {0: 1.0, 1: -1.0})], [(c, {1: 1.0})])

    for c in (1.5530260406739624, 1.5530260406739627, 1.5530260406739629, 1.553026040673963):
        pairs, _ = matched(system(c), damped(system(c)))
        assert all(abs(mpmath.mpc(value) - exact) <= mode.error * abs(exact) for value, exact, mode in pairs)
        assert max(mode.error for _, _, mode in pairs) <= 1e-15
        near = sorted(abs(x - y) for _, x, _ in pairs for _, y, _ in pairs if x is not y)[0]
        assert 0 < near < 1e-7


def test_defective_pairs_of_coupled_modes():
    """(λ² + λ + 1)² as the determinant of a system that cannot be decoupled."""
    elements = FactoredSystem(2, [(1.0, {0: 1.0}), (1.0, {1: 1.0})], K={(0, 0): 1.0, (1, 1): 1.0, (0, 1): 0.5,
                                  (1, 0): 0.5}, C={(0, 0): 1.0, (1, 1): 1.0}, G={(0, 1): 0.5, (1, 0): -0.5})
    exact = mpmath.polyroots([1, 2, 3 + 0.25, 2, 0.75], maxsteps=200, extraprec=400)
    for value, x, mode in matched(elements, damped(elements), exact)[0]:
        assert abs(mpmath.mpc(value) - x) <= mode.error * abs(x)


def test_rigid_motions_with_and_without_damping():
    pair = [(1.0, {0: 1.0}), (1.0, {1: 1.0})]
    tie = {0: 1.0, 1: -1.0}
    inner = damped(FactoredSystem(2, pair, [(1.0, tie)], [(1.0, tie)]))
    assert [mode.eigenvalue for mode in inner] == [0, 0, -1 + 1j]
    outer = damped(FactoredSystem(2, pair, [(1.0, tie)], [(1.0, {0: 1.0})]))
    assert outer[0].eigenvalue == 0 and outer[1].eigenvalue.imag == 0 and outer[1].zeta is None
    assert outer[1].decay > 0 and len(outer) == 3
    charged = damped(FactoredSystem(2, pair, G={(0, 1): 2.0, (1, 0): -2.0}))
    assert [mode.eigenvalue for mode in charged] == [0, 0, 2j]
    assert damped(FactoredSystem(1, pair[:1], (), [(3.0, {0: 1.0})]))[1].eigenvalue == -3


def test_overdamped_proportional_modes_share_their_number():
    rows = [{0: 1.0}, {0: 1.0, 1: -1.0}, {1: 1.0}]
    masses = [(1.0, {0: 1.0}), (1.0, {1: 1.0})]
    for beta in (8.0, 1 / 3):
        elements = FactoredSystem(2, masses, [(13.7, row) for row in rows], [(13.7 * beta, row) for row in rows])
        modes = damped(elements)
        pairs = {}
        for mode in modes:
            pairs.setdefault(mode.index, []).append(mode)
        for first, second in (pair for pair in pairs.values() if len(pair) == 2):
            assert first.omega == second.omega == pytest.approx(
                math.sqrt(first.eigenvalue.real * second.eigenvalue.real), rel=1e-14)
            assert first.zeta == pytest.approx(beta * first.omega / 2, rel=1e-14) and first.zeta >= 1
        assert len(modes) == 4 - sum(1 for mode in modes if mode.omega_d)
    uneven = FactoredSystem(2, masses, [(1.0, row) for row in rows], [(30.0, rows[0]), (17.0, rows[1])])
    assert all(mode.zeta is None for mode in damped(uneven) if not mode.omega_d)


@pytest.mark.sweep
def test_massless_nodes_between_springs_and_dampers():
    for seed in range(40):
        rng = random.Random(seed)
        n = rng.randrange(2, 6)
        base = families.damped_chain(rng, n, 10 ** rng.uniform(0, 6), 10 ** rng.uniform(-4, 4), rng.random() < 0.7)
        bare = sorted(rng.sample(range(n), rng.randrange(1, max(2, n // 2 + 1))))
        inertias = [term for i, term in enumerate(base.inertias) if i not in bare]
        elements = FactoredSystem(n, inertias, base.springs, base.dampers, massless=bare)
        exact = roots(families.pencil(elements)[::-1])
        modes = damped(elements)
        assert len(list(expanded(modes))) == len(exact)
        top = max(abs(x) for x in exact)
        assert all(close(*triple, top) for triple in matched(elements, modes, exact)[0])


def test_spring_and_damper_in_series_give_a_third_eigenvalue():
    elements = FactoredSystem(2, [(1.0, {0: 1.0})], [(3.0, {0: 1.0}), (2.0, {0: 1.0, 1: -1.0})],
                                  [(0.5, {1: 1.0})], massless=[1])
    exact = mpmath.polyroots([1, 4, 5, 12])
    pairs, left = matched(elements, damped(elements), exact)
    assert len(pairs) == 3 and not left and all(close(*triple, 4) for triple in pairs)


def rescaled(elements, mass, time):
    inertias = [(w * 2.0 ** mass, row) for w, row in elements.inertias]
    springs = [(k * 2.0 ** (mass - 2 * time), row) for k, row in elements.springs]
    dampers = [(c * 2.0 ** (mass - time), row) for c, row in elements.dampers]
    return FactoredSystem(elements.n, inertias, springs, dampers)


@pytest.mark.sweep
def test_units_change_no_bit_and_the_order_of_coordinates_none_that_counts():
    for seed in range(25):
        rng = random.Random(seed)
        elements = families.damped_chain(rng, rng.randrange(1, 7), 1e4, 10 ** rng.uniform(-2, 2))
        mass, time = rng.randrange(-30, 31), rng.randrange(-30, 31)
        modes = damped(elements)
        for mode, other in zip(modes, damped(rescaled(elements, mass, time)), strict=True):
            assert other.eigenvalue * 2.0 ** time == mode.eigenvalue and other.zeta == mode.zeta
        n = elements.n
        turned = [[(w, {n - 1 - i: x for i, x in row.items()}) for w, row in terms]
                  for terms in (elements.inertias, elements.springs, elements.dampers)]
        for mode, other in zip(modes, damped(FactoredSystem(n, *turned)), strict=True):
            assert abs(other.eigenvalue - mode.eigenvalue) <= 4 * EPS * mode.omega


def test_rounding_of_the_data_is_bounded_and_escalated():
    c = {(0, 0): 1.0, (1, 1): 1.0, (0, 1): 0.1, (1, 0): 0.1}

    def data(dps):
        with mpmath.workdps(dps):
            row = {0: 1 / mpmath.mpf(3), 1: -(1 - mpmath.mpf(10) ** -12) / 3}
            return FactoredSystem(2, [(mpmath.mpf(1), {0: mpmath.mpf(1)}), (mpmath.mpf(1), {1: mpmath.mpf(1)})],
                                      [(mpmath.mpf(10) ** 12, row), (mpmath.mpf(1), {0: mpmath.mpf(1)})],
                                      C={at: mpmath.mpf(x) for at, x in c.items()})

    floats = data(15)
    floats = FactoredSystem(2, [(1.0, {0: 1.0}), (1.0, {1: 1.0})],
                                [(float(k), {i: float(x) for i, x in row.items()}) for k, row in floats.springs], C=c)
    for value, exact, mode in matched(data(90), damped(floats, precise=data))[0]:
        assert close(value, exact, mode, 1) and mode.error <= 1e-13


def test_digits():
    elements = families.damped_chain(random.Random(6), 3, 1e4, 1.0)
    with mpmath.workdps(160):
        modes = damped(elements, digits=60)
        m, c, k = families.pencil(elements)
        for value, exact, mode in matched(elements, modes)[0]:
            assert abs(value - exact) <= mode.error * abs(exact) <= mpmath.mpf(10) ** -60 * abs(exact)
            if value.imag >= 0:
                x = mpmath.matrix(mode.shape.tolist())
                residual = value * value * (m * x) + value * (c * x) + k * x
                assert mpmath.norm(residual) <= mpmath.mpf(10) ** -60 * mpmath.norm(k * x)
        assert all(isinstance(mode.omega, mpmath.mpf) for mode in modes)
    assert estimated_steps(3, 60, damped=True) > estimated_steps(3, 60)


def test_what_neither_damps_nor_turns_has_no_damped_modes():
    assert damped(FactoredSystem(1, [(1.0, {0: 1.0})], [(1.0, {0: 1.0})])) is None
    assert damped(oscillator(1.0, 0.0, 1.0)) is None


def test_what_has_no_eigenvalues_is_refused_with_its_cause():
    one, tie = [(1.0, {0: 1.0})], {1: 1.0, 2: -1.0}
    with pytest.raises(PhysicsError, match="mechanism"):
        damped(FactoredSystem(3, one, one, [(1.0, {0: 1.0}), (1.0, tie)], massless=[1, 2]))
    with pytest.raises(PhysicsError, match="damping is not a finite number"):
        damped(oscillator(1.0, math.nan, 1.0))
    with pytest.raises(PhysicsError, match="range"):
        damped(oscillator(1e-300, 1e200, 1.0))


@pytest.mark.sweep
@pytest.mark.parametrize("family", FAMILIES)
def test_many_coordinates_stay_within_their_bounds(family, monkeypatch):
    elements = family(random.Random(9), 41, 10.0, 1e-2)
    monkeypatch.setattr(method, "CERTIFIABLE", 0)
    modes = damped(elements)
    monkeypatch.setattr(method, "CERTIFIED", 100)
    exact = damped(elements)
    assert len(modes) == len(exact)
    values = np.array([mode.eigenvalue for mode in exact])
    for mode in modes:
        near = exact[int(np.argmin(abs(values - mode.eigenvalue)))]
        assert abs(near.eigenvalue - mode.eigenvalue) <= (mode.error + near.error) * near.omega


@pytest.mark.parametrize("turn", [1, 1j, 0.6 - 0.8j, -0.3 + 2j])
def test_amplitudes_in_one_phase_are_real(turn):
    """Whatever the phase of the eigenvector, but for what is more than rounding."""
    for how in ("first", "largest"):
        found = normalised([turn * part for part in (1.0, -0.3, 1 / 3, 0.7)], how)
        assert all(complex(value).imag == 0.0 for value in found)
        assert [complex(value).real for value in found] == pytest.approx([1.0, -0.3, 1 / 3, 0.7], rel=1e-15)
        assert complex(normalised([turn, turn * (0.3 + 1e-12j)], how)[1]).imag == pytest.approx(1e-12, rel=1e-3)
        assert complex(normalised([turn, turn * 0.3j], how)[1]) == pytest.approx(0.3j, rel=1e-15)
