"""Undamped frequencies and modes against mpmath fed the same element data."""

import math
import os
import random
import statistics
import subprocess
import sys
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from support import families

from vibcli.analyses.modal import method
from vibcli.analyses.modal.rigid_body_modes import rank
from vibcli.analyses.modal.undamped import undamped
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.numerics.factored_svd import jacobi, pivoted_qr
from vibcli.numerics.precision import estimated_steps

EPS = 2.0 ** -52
ULP = 2.0 ** -53


@pytest.fixture(autouse=True)
def sixty_digits():
    with mpmath.workdps(90):
        yield


def rate(mode):
    return mode.omega if mode.omega is not None else mode.growth_rate


def compared(elements, modes):
    """(mode, exact rate, its sign) for every mode; the exact rate of a zero is 0."""
    exact = families.squares(elements)
    assert len(exact) == len(modes)
    top = max(abs(x) for x in exact)
    for mode, x in zip(modes, exact, strict=True):
        zero = abs(x) <= top * mpmath.mpf(10) ** (30 - mpmath.mp.dps)
        yield mode, mpmath.mpf(0) if zero else mpmath.sqrt(abs(x)), 0 if zero else mpmath.sign(x)


def sampled(family, count, largest):
    for seed in range(count):
        rng = random.Random(seed)
        yield family(rng, rng.randrange(3, largest + 1), 10 ** rng.uniform(0, 20))


@pytest.mark.sweep
@pytest.mark.parametrize("family", families.UNDAMPED)
def test_every_frequency_to_the_last_digit_within_its_bound(family):
    ratios, swept = [], 0
    for elements in sampled(family, 24, 7):
        for mode, exact, sign in compared(elements, undamped(elements)):
            assert mode.rigid == (sign == 0)
            assert (mode.omega is None) == (sign < 0)
            assert rate(mode) == 0 or abs(rate(mode) - exact) <= mode.error * exact
            assert mode.error <= 1e-15
            swept += 1
            if sign and rate(mode) != exact:
                ratios.append(mode.error / float(abs(rate(mode) - exact) / exact))
    assert swept >= 60
    assert statistics.median(ratios) <= 5e4


@pytest.mark.sweep
def test_anything_at_all():
    """Indefinite and free systems with every strength from 1e-20 to 1e20."""
    for seed in range(120):
        rng = random.Random(seed)
        elements = families.anything(rng, rng.randrange(1, 6), 1e20)
        with mpmath.workdps(150):
            for mode, exact, sign in compared(elements, undamped(elements)):
                assert mode.rigid == (sign == 0) and (mode.omega is None) == (sign < 0)
                assert sign == 0 or abs(rate(mode) - exact) <= mode.error * exact <= 1e-15 * exact


@pytest.mark.sweep
@pytest.mark.parametrize("family", families.ONE_AXIS)
def test_thirty_coordinates_of_any_stiffness(family):
    rng = random.Random(family.__name__)
    elements = family(rng, 32, 1e20)
    with mpmath.workdps(60):
        for mode, exact, sign in compared(elements, undamped(elements)):
            assert mode.rigid == (sign == 0)
            assert abs(rate(mode) - exact) <= 2 * ULP * exact


@pytest.mark.parametrize("family", families.UNDAMPED)
def test_shapes_are_orthonormal_and_satisfy_the_equations(family):
    for elements in sampled(family, 12, 9):
        modes = undamped(elements)
        phi = np.array([mode.shape for mode in modes]).T
        m, _, k = families.pencil(elements)
        exact = mpmath.matrix(phi.tolist())
        gram = exact.T * m * exact - mpmath.eye(len(modes))
        assert max(abs(x) for x in gram) <= 1e-14 * elements.n
        top = max(float(rate(mode)) ** 2 for mode in modes)
        top += max(abs(k[i, i]) / m[i, i] for i in range(elements.n) if i not in elements.massless)
        for j, mode in enumerate(modes):
            square = mpmath.mpf(rate(mode)) ** 2 * (-1 if mode.omega is None else 1)
            residual = k * exact[:, j] - square * (m * exact[:, j])
            for i in range(elements.n):
                size = m[i, i] * top if i not in elements.massless else k[i, i] * elements.n
                assert abs(residual[i]) <= 1e-14 * size * max(abs(x) for x in exact[:, j])


@pytest.mark.sweep
@pytest.mark.parametrize("family", families.ONE_AXIS)
def test_shapes_of_separated_modes(family):
    for elements in sampled(family, 6, 6):
        m, _, k = families.pencil(elements)
        exact, modes = families.squares(elements), undamped(elements)
        for j, mode in enumerate(modes):
            others = [x for i, x in enumerate(exact) if i != j]
            gap = min(abs(x - exact[j]) / max(abs(x), abs(exact[j])) for x in others)
            if gap > 1e-6 and not mode.rigid:
                true = null_vector(k - exact[j] * m)
                true = true * (1 / mpmath.sqrt((true.T * m * true)[0]))
                sign = mpmath.sign((true.T * m * mpmath.matrix(mode.shape.tolist()))[0])
                off = [abs(sign * true[i] - mode.shape[i]) * mpmath.sqrt(m[i, i]) for i in range(elements.n)]
                assert max(off) <= 1e-12 / gap


def null_vector(a):
    """One step of inverse iteration with a nearly singular matrix."""
    n = a.rows
    start = mpmath.matrix([mpmath.mpf(i + 1) for i in range(n)])
    tiny = max(abs(x) for x in a) * mpmath.mpf(10) ** -75
    x = mpmath.lu_solve(a + tiny * mpmath.eye(n), start)
    x = mpmath.lu_solve(a + tiny * mpmath.eye(n), x / mpmath.norm(x))
    return x / mpmath.norm(x)


def test_repeated_frequencies_have_an_orthonormal_basis():
    elements = families.repeated(random.Random(1), 8, 1e3)
    modes = undamped(elements)
    phi = np.array([mode.shape for mode in modes])
    assert abs(3.0 * phi @ phi.T - np.eye(8)).max() <= 1e-14
    assert modes[1].omega == pytest.approx(modes[2].omega, rel=2 * EPS)


def test_rigid_motions_are_counted_not_measured():
    rng = random.Random(7)
    for _ in range(40):
        parts, inertias, springs = rng.randrange(1, 5), [], []
        for _ in range(parts):
            first, size = len(inertias), rng.randrange(1, 5)
            inertias += [(rng.uniform(0.1, 10), {first + i: 1.0}) for i in range(size)]
            springs += [(10 ** rng.uniform(0, 18), {first + i: 1.0, first + (i + 1) % size: -1.0})
                        for i in range(size) if size > 1]
        modes = undamped(FactoredSystem(len(inertias), inertias, springs))
        assert sum(mode.rigid for mode in modes) == parts
        assert all(mode.omega == 0 for mode in modes if mode.rigid)


def test_rank_of_rational_rows_and_of_rows_with_rounding():
    third = Fraction(1, 3)
    rows = [{0: 1, 1: third}, {1: Fraction(1), 2: -third}, {0: 3, 1: 2, 2: -third}]
    exact = [{i: Fraction(x) for i, x in row.items()} for row in rows]
    assert rank(3, rows, exact) == 2
    angles = [0.3, 1.1, 2.0, 4.0]
    rows = [{0: math.cos(a), 1: math.sin(a), 2: 2 * math.cos(a) - math.sin(a)} for a in angles]
    assert rank(3, rows) == 2
    assert rank(300, [{i: math.sqrt(2), i + 1: math.cos(i)} for i in range(299)]) == 299


def test_cart_with_a_pendulum_on_an_untied_rail_has_one_zero():
    m, g, length = 2.0, 9.81, 0.7
    inertias = [(3.0, {0: 1.0}), (m, {0: 1.0, 1: length})]
    elements = FactoredSystem(2, inertias, K={(1, 1): m * g * length}, K_size={(1, 1): m * g * length})
    modes = undamped(elements)
    assert [mode.rigid for mode in modes] == [True, False]
    exact = mpmath.sqrt(mpmath.mpf(g) / length * (1 + mpmath.mpf(m) / 3))
    assert abs(modes[1].omega - exact) <= modes[1].error * exact <= 1e-15 * exact


def test_negative_springs_make_unstable_modes():
    elements = FactoredSystem(2, [(1.0, {0: 1.0}), (1.0, {1: 1.0})],
                                  [(-3.0, {0: 1.0}), (1.0, {0: 1.0, 1: -1.0}), (1.0, {1: 1.0})])
    first, second = undamped(elements)
    assert first.omega is None and first.growth_rate > 0 and second.growth_rate is None
    assert first.growth_rate ** 2 - second.omega ** 2 == pytest.approx(0, abs=1e-15)


class Cancelling:
    """K = 1e16 + 1 − 1e16 by rounded sums, and what more digits make of it."""

    sums = ((1e16, 1.0, -1e16), (1e16, 3.0, -1e16))

    def floats(self):
        k = {(i, i): sum(terms) for i, terms in enumerate(self.sums)}
        size = {(i, i): sum(map(abs, terms)) for i, terms in enumerate(self.sums)}
        return FactoredSystem(2, self.masses(), K=k, K_size=size)

    def masses(self):
        return [(1.0, {0: 1.0}), (1.0, {1: 1.0})]

    def precise(self, dps):
        with mpmath.workdps(dps):
            k = {(i, i): sum(map(mpmath.mpf, terms)) for i, terms in enumerate(self.sums)}
            size = {(i, i): sum(abs(mpmath.mpf(x)) for x in terms) for i, terms in enumerate(self.sums)}
            inertias = [(mpmath.mpf(w), {i: mpmath.mpf(x) for i, x in row.items()}) for w, row in self.masses()]
            return FactoredSystem(2, inertias, K=k, K_size=size)


def test_rounding_of_preloads_is_bounded_and_escalated():
    case = Cancelling()
    honest = undamped(case.floats())
    assert all(mode.rigid or mode.error > 0.1 for mode in honest)
    modes = undamped(case.floats(), precise=case.precise)
    assert [mode.omega for mode in modes] == [1.0, pytest.approx(math.sqrt(3), rel=EPS)]
    assert max(mode.error for mode in modes) <= 1e-13


class CancellingRow(Cancelling):
    """Forty masses in a row whose K, of both signs, is left of preloads 1e14 times as large."""

    n = 40
    sums = tuple((1e14, 2.5 * math.cos(3.0 * i) + 1.0, -1e14) for i in range(n))

    def entries(self, number):
        k = {(i, i): sum(map(number, terms)) for i, terms in enumerate(self.sums)}
        size = {(i, i): sum(abs(number(x)) for x in terms) for i, terms in enumerate(self.sums)}
        ties = {pair: number(-0.75) for i in range(self.n - 1) for pair in ((i, i + 1), (i + 1, i))}
        return k | ties, size | {pair: -x for pair, x in ties.items()}

    def floats(self):
        k, size = self.entries(float)
        return FactoredSystem(self.n, [(1.0, {i: 1.0}) for i in range(self.n)], K=k, K_size=size)

    def precise(self, dps):
        with mpmath.workdps(dps):
            k, size = self.entries(mpmath.mpf)
            inertias = [(mpmath.mpf(1), {i: mpmath.mpf(1)}) for i in range(self.n)]
            return FactoredSystem(self.n, inertias, K=k, K_size=size)


@pytest.mark.sweep
def test_forty_preloaded_coordinates_have_as_many_unstable_modes_as_k_has_negative_eigenvalues():
    row = CancellingRow()
    honest = undamped(row.floats())
    modes = undamped(row.floats(), precise=row.precise)
    with mpmath.workdps(40):
        K = mpmath.zeros(row.n)
        for (i, j), x in row.entries(mpmath.mpf)[0].items():
            K[i, j] = x
        squares = sorted(mpmath.eigsy(K, eigvals_only=True))
    signs = [(-1) ** (mode.omega is None) for mode in modes]
    assert sum(sign < 0 for sign in signs) == sum(x < 0 for x in squares) > 5
    for found in (honest, modes):
        pairs = zip(found, squares, strict=True)
        assert all(mode.rigid or abs(rate(mode) - mpmath.sqrt(abs(x))) <= mode.error * mpmath.sqrt(abs(x))
                   for mode, x in pairs)
    assert not any(mode.rigid for mode in modes)
    assert max(mode.error for mode in modes) <= 1e-13 < max(mode.error for mode in honest)


def rescaled(elements, a, b, c):
    """Masses in units 2^-a, lengths 2^-b, times 2^-c: odd coordinates are angles, all springs are along lines."""
    def row(entries):
        return {i: x * 2.0 ** (b * (i % 2)) for i, x in entries.items()}

    inertias = [(w * 2.0 ** (a + 2 * b * (min(r) % 2)), dict(r)) for w, r in elements.inertias]
    springs = [(k * 2.0 ** (a - 2 * c), row(r)) for k, r in elements.springs]
    return FactoredSystem(elements.n, inertias, springs)


@pytest.mark.sweep
def test_units_change_no_bit():
    for seed in range(40):
        rng = random.Random(seed)
        elements = families.levers(rng, rng.randrange(2, 9), 1e12)
        a, b, c = (rng.randrange(-40, 41) for _ in range(3))
        for mode, other in zip(undamped(elements), undamped(rescaled(elements, a, b, c)), strict=True):
            assert other.omega * 2.0 ** c == mode.omega
            turned = other.direction * np.array([2.0 ** (b * (i % 2)) for i in range(elements.n)])
            lead = int(np.argmax(abs(mode.direction)))
            assert (turned / turned[lead] == mode.direction / mode.direction[lead]).all()


@pytest.mark.parametrize("family", families.UNDAMPED)
def test_order_of_coordinates_does_not_matter(family):
    for elements in sampled(family, 8, 9):
        rng = random.Random(3)
        place = list(range(elements.n))
        rng.shuffle(place)
        renamed = [[(w, {place[i]: x for i, x in row.items()}) for w, row in terms]
                   for terms in (elements.inertias, elements.springs)]
        k = {(place[i], place[j]): x for (i, j), x in elements.K.items()}
        other = FactoredSystem(elements.n, *renamed, K=k, massless=[place[i] for i in elements.massless])
        for mode, same in zip(undamped(elements), undamped(other), strict=True):
            assert abs(rate(mode) - rate(same)) <= 4 * EPS * rate(mode)


def test_hundred_digits():
    elements = families.chain(random.Random(2), 5, 1e8)
    with mpmath.workdps(250):
        for mode, exact, _ in compared(elements, undamped(elements, digits=100)):
            assert isinstance(mode.omega, mpmath.mpf)
            assert abs(mode.omega - exact) <= mode.error * exact <= mpmath.mpf(10) ** -100 * exact
            assert all(isinstance(x, mpmath.mpf) for x in mode.shape)
    assert 1e-3 < estimated_steps(5, 100) < estimated_steps(40, 100) < estimated_steps(40, 1000)


def refused(*args, **kwargs):
    with pytest.raises(PhysicsError) as caught:
        undamped(FactoredSystem(*args, **kwargs))
    return caught.value


def test_what_has_no_frequencies_is_refused_with_its_cause():
    one, tied = [(1.0, {0: 1.0})], [(1.0, {0: 1.0})]
    assert "coordinate 2" in str(refused(2, one, tied, massless=[1]))
    assert "mechanism" in str(refused(3, one, [*tied, (1.0, {1: 1.0, 2: -1.0})], massless=[1, 2]))
    assert "coordinate 2" in str(refused(2, one, [*tied, (1.0, {1: 1.0})]))
    assert "inertia" in str(refused(2, [(1.0, {0: 1.0, 1: 1.0})], [*tied, (1.0, {1: 1.0})]))
    assert "inertia" in str(refused(1, [], tied, massless=[0]))
    for bad in (math.nan, math.inf):
        assert "not a finite number" in str(refused(1, one, [(bad, {0: 1.0})]))
        assert "not a finite number" in str(refused(1, one, [(1.0, {0: bad})]))
        assert "not finite" in str(refused(1, one, K={(0, 0): bad}))
    assert "range" in str(refused(1, [(5e-324, {0: 1.0})], [(1e308, {0: 1.0})]))
    assert "range" in str(refused(1, [(1e308, {0: 1.0})], [(5e-324, {0: 1.0})]))


@pytest.mark.parametrize("family", families.UNDAMPED)
def test_many_coordinates_stay_within_their_bounds(family, monkeypatch):
    monkeypatch.setattr(method, "CERTIFIABLE_SQUARES", 0)
    rng, ratios = random.Random(5), []
    elements = family(rng, 42, 1e4)
    modes = undamped(elements)
    monkeypatch.setattr(method, "CERTIFIED", 100)
    for mode, exact in zip(modes, undamped(elements), strict=True):
        assert mode.error == 1.0 or mode.rigid == exact.rigid
        if not mode.rigid:
            off = abs(rate(mode) - rate(exact)) / rate(exact)
            assert off <= mode.error + exact.error
            ratios.append(mode.error / max(off, EPS))
    assert statistics.median(ratios) <= 5e4


def test_jacobi_reads_small_singular_values_of_rows_of_any_size():
    rng = np.random.default_rng(4)
    rows = 10.0 ** rng.uniform(-8, 8, 12)[:, None] * rng.normal(size=(12, 9))
    r, order, _ = pivoted_qr(rows)
    u, sigma = jacobi(r.T)
    with mpmath.workdps(60):
        a = mpmath.matrix(rows.tolist())
        exact = sorted((mpmath.sqrt(x) for x in mpmath.eigsy(a.T * a, eigvals_only=True)), reverse=True)
    assert max(abs(s - x) / x for s, x in zip(sigma, exact, strict=True)) <= 3e-14
    assert abs(u.T @ u - np.eye(9)).max() <= 1e-13
    plain = np.linalg.svd(rows, compute_uv=False)
    assert max(abs(s - x) / x for s, x in zip(plain, exact, strict=True)) > 1e-12
    assert sorted(order) == list(range(9))


def test_many_masses_in_a_row():
    n = 300
    springs = [(1.0, {i: 1.0, i - 1: -1.0} if i else {0: 1.0}) for i in range(n)]
    modes = undamped(FactoredSystem(n, [(1.0, {i: 1.0}) for i in range(n)], springs))
    for j in (0, 1, 150, 299):
        exact = 2 * mpmath.sin(mpmath.pi * (2 * j + 1) / (2 * (2 * n + 1)))
        assert abs(modes[j].omega - exact) <= modes[j].error * exact <= 1e-10 * exact


@pytest.mark.sweep
def test_small_systems_import_neither_scipy_nor_mpmath():
    code = ("import sys; from vibcli.analyses.modal.undamped import undamped\n"
            "from vibcli.analyses.modal.damped import damped\n"
            "from vibcli.mechanics.factored_system import FactoredSystem as E\n"
            "rows = [(1.0, {i: 1.0, i - 1: -1.0} if i else {0: 1.0}) for i in range(4)]\n"
            "e = E(4, [(1.0, {i: 1.0}) for i in range(4)], rows, rows[:2])\n"
            "undamped(e); damped(e)\n"
            "assert not {'scipy', 'mpmath', 'sympy', 'dataclasses'} & set(sys.modules), 'too much imported'")
    subprocess.run([sys.executable, "-c", code], check=True, env=os.environ)


@pytest.mark.sweep
def test_large_stiff_systems_keep_their_soft_modes_by_lapack(monkeypatch):
    elements = families.chain(random.Random(8), 44, 1e18)
    exact = undamped_enclosed(elements, monkeypatch)
    monkeypatch.setattr(method, "CERTIFIABLE_SQUARES", 0)
    for mode, other in zip(undamped(elements), exact, strict=True):
        assert abs(mode.omega - other.omega) <= mode.error * other.omega <= 1e-12 * other.omega


def undamped_enclosed(elements, monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr(method, "CERTIFIED", 100)
        return undamped(elements)
