"""Follower forces, K not symmetric: eigenvalues, bounds and shapes against mpmath."""

import math
import random
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from support import families
from support.spectra import compared, nearest, rate, relative, residual, unit_masses

from vibcli.analyses.modal import method
from vibcli.analyses.modal.damped import damped
from vibcli.analyses.modal.modes import damped_modes, natural_modes
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.report.sections.mode_tables import mode_row

ULP = 2.0 ** -53
NATURAL = (families.follower, families.free_follower, families.massive_follower, families.massless_follower)


@pytest.fixture(autouse=True)
def many_digits():
    with mpmath.workdps(100):
        yield


def sampled(family, count, largest):
    for seed in range(count):
        rng = random.Random(seed)
        elements = family(rng, rng.randrange(2, largest + 1), 10 ** rng.uniform(0, 6), 10 ** rng.uniform(-6, 6))
        if elements.circulatory:
            yield elements


@pytest.mark.sweep
@pytest.mark.parametrize("family", NATURAL)
def test_every_mode_without_dampers_to_the_last_digit(family):
    kinds, swept = set(), 0
    for elements in sampled(family, 45, 6):
        modes = natural_modes(elements)
        for mode, exact in compared(modes, families.circulatory_squares(elements)):
            assert relative(mode, exact) <= mode.error <= 1.2e-16
            kinds.add(mode.kind)
            swept += 1
        assert [mode.index for mode in modes] == list(range(1, len(modes) + 1))
        growing = [mode.growth_rate for mode in modes if mode.growth_rate]
        assert growing == sorted(growing, reverse=True)
    assert kinds == {"oscillation", "flutter", "divergence"} and swept >= 100


@pytest.mark.sweep
def test_up_to_twelve_coordinates():
    for seed in range(3):
        elements = families.follower(random.Random(seed), 12, 1e6, 100.0 ** (seed - 1))
        for mode, exact in compared(natural_modes(elements), families.circulatory_squares(elements)):
            assert relative(mode, exact) <= mode.error <= 1.2e-16


@pytest.mark.sweep
@pytest.mark.parametrize("follow", NATURAL[:3])
def test_damped_pushed_and_spun_under_follower_forces(follow):
    swept = 0
    for seed in range(15):
        rng = random.Random(seed)
        elements = families.driven(rng, rng.randrange(2, 6), 1e3, 10 ** rng.uniform(-8, 4), follow)
        modes, left = damped(elements), families.eigenvalues(elements)
        top = max(abs(x) for x in left)
        pairs = [(mode.eigenvalue, mode) for mode in modes]
        pairs += [(value.conjugate(), mode) for value, mode in pairs if value.imag]
        assert len(pairs) == len(left)
        for value, mode in sorted(pairs, key=lambda pair: -abs(pair[0])):
            exact = nearest(left, value)
            if not value:
                assert abs(exact) <= top * mpmath.mpf(10) ** -40
                continue
            assert abs(value - exact) <= mode.error * abs(exact) and mode.error <= 2e-16
            assert abs(value.real - exact.real) <= 4 * ULP * abs(exact.real) + abs(exact) * mpmath.mpf(10) ** -33
            swept += 1
    assert swept >= 70


@pytest.mark.sweep
def test_massless_nodes_are_dragged_or_follow():
    for seed in range(25):
        rng = random.Random(seed)
        elements = families.driven(rng, rng.randrange(2, 6), 1e3, 10 ** rng.uniform(-4, 4), families.massless_follower)
        m, c, k = families.pencil(elements)
        modes = damped(elements)
        degree = len(modes) + sum(1 for mode in modes if mode.eigenvalue.imag)
        loose = [i for i in elements.massless if not any(c[i, j] or c[j, i] for j in range(elements.n))]
        assert degree <= 2 * elements.n - len(elements.massless) - len(loose)
        for mode in modes:
            value = mpmath.mpmathify(mode.eigenvalue)
            size = mpmath.norm(m) * abs(value) ** 2 + mpmath.norm(c) * abs(value) + mpmath.norm(k)
            assert residual(elements, mode, value) <= 1e-13 * size


@pytest.mark.sweep
@pytest.mark.parametrize("family", NATURAL)
def test_shapes_satisfy_the_equations_and_balance_the_work(family):
    """With xᴴMx = 1: λ² = −xᴴKx, whose imaginary part is the work that the skew part of K does in a cycle."""
    for elements in sampled(family, 20, 6):
        m, _, k = families.pencil(elements)
        skew = (k - k.T) / 2
        for mode in natural_modes(elements):
            x = mpmath.matrix([mpmath.mpmathify(z) for z in mode.shape.tolist()])
            value, size = rate(mode), mpmath.norm(k) * mpmath.norm(x) ** 2
            assert abs((x.H * m * x)[0] - 1) <= 1e-14
            assert mpmath.norm(value * value * (m * x) + k * x) <= 1e-12 * mpmath.norm(k) * mpmath.norm(x)
            assert abs(value ** 2 + (x.H * k * x)[0]) <= 1e-12 * size
            assert abs(2 * value.real * value.imag + (x.H * skew * x)[0].imag) <= 1e-12 * size
            assert mode.kind == "flutter" or not any(z.imag for z in mode.shape.tolist())


@pytest.mark.sweep
def test_sums_of_eigenvalues():
    """Σ λ = −tr M⁻¹C and Σ λ² = tr (M⁻¹C)² − 2 tr M⁻¹K, over both of each conjugate pair."""
    for seed in range(20):
        elements = families.driven(random.Random(seed), 5, 100.0, 1.0)
        m, c, k = families.pencil(elements)
        values = [mpmath.mpmathify(mode.eigenvalue) for mode in damped(elements)]
        values += [value.conjugate() for value in values if value.imag]
        a, b, size = m ** -1 * c, m ** -1 * k, sum(abs(value) ** 2 for value in values)
        trace = [sum(x[i, i] for i in range(5)) for x in (a, a * a - 2 * b)]
        assert abs(sum(values) + trace[0]) <= 1e-14 * mpmath.sqrt(size)
        assert abs(sum(value * value for value in values) - trace[1]) <= 1e-14 * size


def exact_pair(product, number=Fraction):
    """K = [[1, 1/2], [−product·2, 2]]: its eigenvalues meet where the product of the couplings is −1/4."""
    return FactoredSystem(2, [(number(1), {0: number(1)}), (number(1), {1: number(1)})],
                              K={(0, 0): number(1), (1, 1): number(2), (0, 1): number(1) / 2,
                                 (1, 0): -2 * number(product)})


def test_the_edge_of_flutter_is_decided_exactly():
    edge, floats = Fraction(1, 4), exact_pair(0.25, float)
    for step, kinds in ((-Fraction(1, 10 ** 40), ["oscillation"] * 2), (0, ["oscillation"] * 2),
                        (Fraction(1, 10 ** 40), ["flutter"])):
        modes = natural_modes(floats, exact=lambda step=step: exact_pair(edge + step))
        assert [mode.kind for mode in modes] == kinds
        assert all(mode.error <= 1.2e-16 and abs(mode.omega - math.sqrt(1.5)) <= 1e-15 for mode in modes)
    assert modes[0].growth_rate == pytest.approx(1e-20 / math.sqrt(6), rel=1e-15)


@pytest.mark.sweep
def test_what_rounding_leaves_open_next_to_flutter_is_in_the_bound():
    """Sums with rounding: their eigenvalues move by its root, and the bound says so."""
    swept = 0
    for seed in range(60):
        rng = random.Random(seed)
        elements = exact_pair(0.25 + rng.choice((-1, 1)) * 10 ** rng.uniform(-17, -3), float)
        elements.K_size = {at: abs(x) * rng.choice((1.0, 10.0, 1e4)) for at, x in elements.K.items()}
        modes = natural_modes(elements)
        for _ in range(8):
            k = [mpmath.mpf(elements.K[at]) + rng.choice((-1, 0, 1)) * elements.K_size[at] * mpmath.mpf(ULP)
                 for at in ((0, 0), (0, 1), (1, 0), (1, 1))]
            middle, excess = (k[0] + k[3]) / 2, mpmath.sqrt(((k[0] - k[3]) / 2) ** 2 + k[1] * k[2])
            left = [mpmath.sqrt(-middle + sign * excess) for sign in (-1, 1)]
            left = [mpmath.mpc(abs(x.real), abs(x.imag)) for x in left]
            for mode in modes:
                exact = min(left, key=lambda x: abs(x - rate(mode)))
                least = min(abs(part) for part in (rate(mode).real, rate(mode).imag) if part)
                assert abs(exact - rate(mode)) <= mode.error * least * (1 + 1e-9) or mode.error == 1.0
                swept += 1
    assert swept >= 400


def test_many_digits():
    several = families.follower(random.Random(3), 4, 10.0, 1.0)
    for elements in (exact_pair(0.5, float), exact_pair(0.125, float), several):
        with mpmath.workdps(220):
            for mode, exact in compared(natural_modes(elements, digits=60), families.circulatory_squares(elements)):
                assert relative(mode, exact) <= mode.error <= mpmath.mpf(10) ** -60
                assert residual(elements, mode, rate(mode)) <= mpmath.mpf(10) ** -58
    with mpmath.workdps(40):
        double = natural_modes(exact_pair(0.25, float), digits=20)
        assert [mpmath.nstr(mode.omega, 20) for mode in double] == ["1.2247448713915890491"] * 2


@pytest.mark.sweep
def test_rigid_motions_under_follower_forces():
    """A free rod of two masses with a thrust along it: K is nilpotent, and the turn pushes the translation."""
    thrust = natural_modes(FactoredSystem(2, unit_masses(2), K={(0, 1): 1.0}))
    assert [mode.kind for mode in thrust] == ["rigid", "rigid"]
    assert np.allclose(np.abs([mode.shape for mode in thrust]), np.eye(2))
    tied = natural_modes(FactoredSystem(3, unit_masses(3), [(4.0, {2: 1.0})], K={(0, 1): 1.0, (0, 2): 0.5}))
    assert [mode.omega for mode in tied] == [0, 0, 2]
    for seed in range(10):
        elements = families.free_follower(random.Random(seed), 4, 100.0, 1.0)
        rigid, = (mode for mode in natural_modes(elements) if mode.rigid)
        assert np.allclose(rigid.shape, rigid.shape[0], rtol=1e-13)
        pushed = FactoredSystem(4, elements.inertias, elements.springs, [(0.1, {0: 1.0, 1: -1.0})], K=elements.K)
        zero = [mode for mode in damped_modes(pushed, lambda e=elements: natural_modes(e)) if not mode.eigenvalue]
        assert len(zero) == 1 and zero[0].kind == "rigid"


def test_rounded_rows_of_a_free_body_give_an_exact_zero():
    def free(number):
        third = number(1) / 3
        K = {(0, 0): third, (0, 1): -third, (1, 0): -number(1) / 7, (1, 1): number(1) / 7}
        return FactoredSystem(2, [(number(1), {0: number(1)}), (number(1), {1: number(1)})], K=K,
                                  K_size={at: abs(x) for at, x in K.items()})

    def precise(dps):
        with mpmath.workdps(dps):
            return free(mpmath.mpf)

    for modes in (natural_modes(free(float), precise=precise), natural_modes(free(float))):
        assert [mode.kind for mode in modes] == ["rigid", "oscillation"]
        assert modes[1].omega == pytest.approx(math.sqrt(10 / 21), rel=4 * ULP)
    elements = free(float)
    elements.dampers = ((0.1, {0: 1.0, 1: -1.0}),)

    def damped_precise(dps):
        found = precise(dps)
        found.dampers = ((mpmath.mpf("0.1"), {0: mpmath.mpf(1), 1: mpmath.mpf(-1)}),)
        return found

    zero = [mode for mode in damped(elements, precise=damped_precise) if not mode.eigenvalue]
    assert len(zero) == 2


def test_repeated_pairs_give_a_basis():
    pair = {(0, 1): 1.0, (1, 0): 0.5, (2, 3): 1.0, (3, 2): 0.5}
    for sign, kinds in ((1, ["oscillation"] * 4), (-1, ["flutter"] * 2)):
        K = {at: x * (sign if at[0] % 2 else 1) for at, x in pair.items()}
        modes = natural_modes(FactoredSystem(4, unit_masses(4), [(1.0, {i: 1.0}) for i in range(4)], K=K))
        assert [mode.kind for mode in modes] == kinds
        assert np.linalg.matrix_rank(np.array([mode.shape for mode in modes]), tol=0.1) == len(modes)


def test_spun_under_follower_forces_what_decays_is_listed_too():
    """λ and −λ̄ are no pair where there is G and K is not symmetric."""
    elements = FactoredSystem(2, unit_masses(2), K={(0, 0): 4.0, (1, 1): 4.0, (0, 1): 0.5, (1, 0): -0.5},
                                  G={(0, 1): 1.0, (1, 0): -1.0})
    modes = natural_modes(elements)
    exact = [x for x in families.eigenvalues(elements) if x.imag > 0]
    assert [mode.kind for mode in modes] == ["flutter", "oscillation"]
    for mode, value in zip(modes, sorted(exact, key=lambda x: -x.real), strict=True):
        assert relative(mode, value) <= mode.error <= 1.2e-16
    assert "decays as exp(−" in mode_row(modes[1])[-1]


@pytest.mark.sweep
@pytest.mark.parametrize("size", (1e-3, 1.0))
def test_many_coordinates_in_floats_stay_within_their_bounds(size, monkeypatch):
    rng = random.Random(7)
    still = families.follower(rng, 30, 10.0, size)
    driven = FactoredSystem(30, still.inertias, still.springs, [(0.1, {3: 1.0}), (-0.2, {9: 1.0})], K=still.K)
    exact = natural_modes(still), damped(driven)
    monkeypatch.setattr(method, "CERTIFIABLE", 0)
    for modes, better, value in ((natural_modes(still), exact[0], rate),
                                 (damped(driven), exact[1], lambda mode: mode.eigenvalue)):
        assert len(modes) == len(better)
        left = list(better)
        for mode in modes:
            near = left.pop(min(range(len(left)), key=lambda i: abs(value(left[i]) - value(mode))))
            assert near.kind == mode.kind and mode.error <= 1e-9
            assert abs(value(near) - value(mode)) <= mode.error * abs(value(near))


def test_units_change_no_bit():
    for seed in range(15):
        rng = random.Random(seed)
        elements = families.massless_follower(rng, rng.randrange(2, 6), 1e3, 1.0)
        mass, time = rng.randrange(-30, 31), rng.randrange(-30, 31)
        other = FactoredSystem(elements.n, [(w * 2.0 ** mass, row) for w, row in elements.inertias],
                                   [(k * 2.0 ** (mass - 2 * time), row) for k, row in elements.springs],
                                   K={at: x * 2.0 ** (mass - 2 * time) for at, x in elements.K.items()},
                                   massless=elements.massless)
        for mode, same in zip(natural_modes(elements), natural_modes(other), strict=True):
            assert rate(same) * 2 ** time == rate(mode) and same.kind == mode.kind


def test_only_a_matrix_that_rounding_cannot_explain_is_circulatory():
    def elements(x, size=None):
        return FactoredSystem(2, unit_masses(2), K={(0, 1): 1.0, (1, 0): x}, K_size=size)

    last = math.nextafter(1.0, 2)
    assert elements(last).circulatory and not elements(1.0).circulatory
    assert not elements(last, {(0, 1): 1.0, (1, 0): 1.0}).circulatory
    assert elements(1.0 + 1e-14, {(0, 1): 1.0, (1, 0): 1.0}).circulatory
    assert FactoredSystem(2, K={(0, 1): 1e-300}).circulatory
    assert not FactoredSystem(2, K={(0, 0): 1.0}).circulatory and not FactoredSystem(2).circulatory
