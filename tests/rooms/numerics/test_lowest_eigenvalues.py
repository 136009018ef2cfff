"""The lowest eigenvalues of sparse matrices against closed forms and against enclosures in fixed point."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import scipy.sparse as sparse

from vibcli.numerics import double_double as dd
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.double_double import DoubleDouble
from vibcli.numerics.inertia import Pencil
from vibcli.numerics.lowest_eigenvalues import Unsettled, lowest
from vibcli.numerics.sparse_form import SparseForm
from vibcli.numerics.symmetric_eigenvalues import spectrum

GROUND = -1


def springs(n, pairs, k=1.0):
    """Σ k (xᵢ − xⱼ)² of pairs (i, j), j = −1 the ground."""
    rows = np.repeat(np.arange(len(pairs)), 2)
    columns, slopes = np.array(pairs).ravel(), np.tile([1.0, -1.0], len(pairs))
    kept = columns >= 0
    matrix = sparse.csr_matrix((slopes[kept], (rows[kept], columns[kept])), (len(pairs), n))
    return SparseForm(np.ones(len(pairs)) * k, matrix)


def masses(m):
    return SparseForm(np.asarray(m, float), sparse.identity(len(m), format="csr"))


def chain(n):
    return [(i, i - 1) for i in range(n)]


def found(K, M, count, zeros=0):
    slices = lowest(Pencil(K, M), count, zeros)
    return [np.concatenate([getattr(one, part) for one in slices]) for part in ("values", "errors")]


def check(K, M, exact, count, zeros=0, bound=2e-13):
    """At least `count` eigenvalues, each within its bound of the exact one, elastic ones known to `bound`."""
    values, errors = found(K, M, count, zeros)
    exact = np.array([float(x) for x in exact[:len(values)]])
    assert len(values) >= count
    assert (abs(values - exact) <= errors + 2.0**-52 * exact).all()
    assert (errors[zeros:] <= bound * exact[zeros:]).all()
    assert (abs(values - exact)[zeros:] <= 1e-13 * exact[zeros:]).all()


def sines(n, parts, of):
    """4 sin² of so many multiples of π/of, at 40 digits, by size."""
    with mpmath.workdps(40):
        return sorted(4 * mpmath.sin(mpmath.pi * part / of) ** 2 for part in parts(n))


def enclosed(K, M):
    """All eigenvalues in fixed point of the numbers taken as exact, M diagonal."""
    bits = 400
    def dense(form):
        total = np.zeros((form.n, form.n), object)
        rows = form.rows.toarray()
        for w, row in zip(form.weights, rows, strict=True):
            at = np.flatnonzero(row)
            for i in at:
                for j in at:
                    total[i, j] += Fraction(w) * Fraction(row[i]) * Fraction(row[j])
        if form.entries is not None:
            for (i, j), x in form.entries.todok().items():
                total[i, j] += Fraction(x)
        return total

    k, m = dense(K), dense(M).diagonal()
    whole = np.vectorize(lambda x: int(x * 2**bits), otypes=[object])
    with mpmath.workprec(bits):
        roots = [int(mpmath.floor(mpmath.sqrt(mpmath.mpf(x.numerator) / x.denominator) * 2**bits)) for x in m]
    a = ((whole(k) << bits) // np.array(roots, object)[:, None] << bits) // np.array(roots, object)
    answer = spectrum(a, bits, 80)
    return np.sort(fx.floats(answer.values, bits))


@pytest.mark.parametrize("n", [300, 20_000])
def test_a_chain_that_is_held(n):
    exact = sines(n, lambda n: range(1, 60, 2), 2 * (2 * n + 1))
    check(springs(n, chain(n)), masses(np.ones(n)), exact, 20)


@pytest.mark.parametrize("n", [300, 20_000])
def test_a_chain_that_is_free(n):
    exact = sines(n, lambda n: range(40), 2 * n)
    K = springs(n, chain(n)[1:])
    check(K, masses(np.ones(n)), exact, 20, zeros=1)


@pytest.mark.sweep
def test_a_grid_has_its_double_eigenvalues():
    n, side = 1600, 40
    ties = [(i, i - 1 if i % side else GROUND) for i in range(n)] + [(i, GROUND) for i in range(side - 1, n, side)]
    ties += [(i, i - side if i >= side else GROUND) for i in range(n)] + [(i, GROUND) for i in range(n - side, n)]
    line = sines(side, lambda n: range(1, n + 1), 2 * (side + 1))
    exact = sorted(a + b for a in line for b in line)
    assert exact[1] == exact[2]
    check(springs(n, ties), masses(np.ones(n)), exact, 40)


@pytest.mark.sweep
def test_a_ring_has_pairs():
    n = 3000
    exact = sorted([*sines(n, lambda n: range(30), n), *sines(n, lambda n: range(1, 30), n)])
    check(springs(n, [(i, (i + 1) % n) for i in range(n)]), masses(np.ones(n)), exact, 21, zeros=1)


@pytest.mark.sweep
def test_forty_that_coincide_are_all_counted():
    exact = np.repeat(np.arange(1, 76) ** 2.0, 40)
    check(springs(3000, [(i, GROUND) for i in range(3000)], exact), masses(np.ones(3000)), exact, 50, bound=4e-13)


def test_all_alike_are_refused():
    with pytest.raises(Unsettled):
        found(springs(3000, [(i, GROUND) for i in range(3000)]), masses(np.ones(3000)), 5)


@pytest.mark.sweep
@pytest.mark.parametrize("stiff", [3, 6, 9])
def test_stiff_and_soft_springs(stiff):
    n, random = 60, np.random.default_rng(stiff)
    K, M = springs(n, chain(n), 10 ** random.uniform(0, stiff, n)), masses(10 ** random.uniform(-1, 1, n))
    check(K, M, enclosed(K, M), 8)


@pytest.mark.sweep
def test_negative_springs_and_entries():
    n, random = 60, np.random.default_rng(5)
    k = np.where(np.arange(n) % 20 == 7, -0.3, 1.0)
    entries = sparse.diags([random.uniform(-0.1, 0.1, n)], [0], format="csr")
    base = springs(n, chain(n), k)
    K, M = SparseForm(base.weights, base.rows, entries), masses(random.uniform(1, 2, n))
    values, errors = found(K, M, 8)
    exact = enclosed(K, M)[:len(values)]
    assert exact[0] < 0 < exact[7]
    assert (abs(values - exact) <= errors).all()
    assert errors.max() < 1e-12


@pytest.mark.sweep
def test_a_mass_matrix_that_is_not_diagonal():
    n = 400
    shifted = sparse.diags([np.ones(n), 0.5 * np.ones(n - 1)], [0, 1], format="csr")
    M = SparseForm(np.ones(2 * n), sparse.vstack([sparse.identity(n), shifted]).tocsr())
    K = springs(n, chain(n))
    with mpmath.workdps(40):
        values, errors = found(K, M, 6)
        bands = [[form.assembled().diagonal(k) for k in (0, 1)] for form in (K, M)]
        for value, error in zip(values, errors, strict=True):      # the count of negative pivots on both sides
            below, above = (_negative(*(k - mpmath.mpf(value + side * (error + 1e-15 * value)) * m
                                        for k, m in zip(*bands, strict=True))) for side in (-1, 1))
            assert above - below == 1
    assert (errors <= 2e-13 * values).all()


def _negative(diagonal, beside):
    """Negative pivots of a symmetric tridiagonal matrix of mpmath numbers."""
    pivot, count = diagonal[0], int(diagonal[0] < 0)
    for own, off in zip(diagonal[1:], beside, strict=True):
        pivot = own - off**2 / pivot
        count += pivot < 0
    return count


def test_counts_of_a_shift_between_close_eigenvalues():
    n = 500
    pencil = Pencil(springs(n, chain(n)), masses(np.ones(n)))
    exact = [float(x) for x in sines(n, lambda n: range(1, 2 * n, 2), 2 * (2 * n + 1))]
    for i in (1, 7, 250, 499):
        factors = pencil.factors((exact[i - 1] + exact[i]) / 2)
        assert factors.below == i
        assert factors.margin < exact[i] - exact[i - 1]


def test_twice_the_digits():
    random = np.random.default_rng(2)
    matrix = sparse.random(40, 30, 0.2, format="csr", random_state=3)
    x = DoubleDouble(random.standard_normal((30, 3)), 2.0**-60 * random.standard_normal((30, 3)))
    y = dd.times(matrix, x)
    for i in range(40):
        row = matrix[[i]].tocoo()
        for j in range(3):
            terms = [Fraction(v) * (Fraction(x.hi[k, j]) + Fraction(x.lo[k, j]))
                     for k, v in zip(row.col, row.data, strict=True)]
            off = Fraction(y.hi[i, j]) + Fraction(y.lo[i, j]) - sum(terms)
            assert abs(off) <= dd.UNIT * 4 * sum(map(abs, terms))
