"""Modes of floats certified by their residuals, against enclosures in integers of the same numbers."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest

from vibcli.analyses.modal.undamped import certain, prepared, undamped
from vibcli.analyses.modal.undamped_large import approximate
from vibcli.analyses.modal.undamped_residuals import bettered
from vibcli.api.source import problem_of, text_source
from vibcli.bench import scenes
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.double_double import DoubleDouble
from vibcli.numerics.split_products import product

UNIT = 2.0**-53


def chain(n, random, spread=0.0, ends=(0,), full=False, entries=0.0):
    """Springs in a row with stiffnesses over so many powers of ten, held at `ends`, with masses of rows of three where
    `full`, and random entries in K."""
    springs = [(10 ** random.uniform(0, spread), {i: 1.0, i - 1: -1.0}) for i in range(1, n)]
    springs += [(1.0, {i: 1.0}) for i in ends]
    inertias = [(random.uniform(1, 2), {i: 1.0}) for i in range(n)]
    if full:
        inertias += [(random.uniform(0, 1), dict(zip(random.choice(n, 3, replace=False).tolist(),
                                                     random.standard_normal(3), strict=True))) for _ in range(n)]
    K = {}
    for _ in range(n if entries else 0):
        i, j = (int(at) for at in random.integers(0, n, 2))
        K[i, j] = K[j, i] = entries * random.standard_normal()
    return FactoredSystem(n, inertias, springs, K=K, K_size={at: abs(x) for at, x in K.items()})


CASES = {
    "entries": {"entries": 0.2, "ends": (0, 20)},
    "unstable": {"entries": 1.0},
    "stiff": {"spread": 6.0, "entries": 1e-3},
    "full": {"full": True, "entries": 0.05},
    "factored": {"spread": 5.0},
    "free": {"spread": 3.0, "ends": ()},
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("n", [45, 70])
def test_both_ways_agree_within_their_bounds(case, n):
    elements = chain(n, np.random.default_rng(n), **CASES[case])
    scale, zeros = prepared(elements)
    start = approximate(elements, scale, zeros)
    found = bettered(elements, scale, zeros, start, 0.0)
    exact = certain(elements, scale, zeros, None)
    order = np.argsort([int(x) for x in exact.values], kind="stable")
    values = np.where(exact.zero, 0.0, fx.floats(exact.values, exact.bits))[order]
    errors = 2.0 ** exact.errors()[order]
    mine = np.argsort(found.values, kind="stable")
    certified = found.errors[mine] < 0.1
    size = abs(values)
    off = abs(np.sqrt(abs(found.values[mine])) - np.sqrt(size))
    assert (off[certified] <= (found.errors[mine] + errors + 2 * UNIT)[certified] * np.sqrt(size)[certified]).all()
    assert certified.all()
    kept = values != 0
    if case == "free":
        assert (found.values[mine][0], found.errors[mine][0]) == (0.0, 0.0)
        kept[0] = False
    assert (found.errors[mine] <= 2 * errors + 4e-15)[kept].all()
    assert found.errors.max() <= start.errors.max()
    shapes = fx.floats(exact.shapes, exact.bits)[:, order]
    for i in range(n):
        one, other = found.shapes[:, mine[i]], shapes[:, i]
        assert min(abs(one - other).max(), abs(one + other).max()) <= 1e-9 * abs(other).max()


@pytest.mark.sweep
def test_repeated_frequencies_keep_a_bound_that_holds():
    n = 60
    elements = FactoredSystem(n, [(1.0, {i: 1.0}) for i in range(n)],
                              [(1.0, {i: 1.0, (i + 1) % n: -1.0}) for i in range(n)], K={(0, 0): 0.0, (1, 1): 1e-9,
                                                                                        (31, 31): 1e-9})
    scale, zeros = prepared(elements)
    found = bettered(elements, scale, zeros, approximate(elements, scale, zeros), 0.0)
    exact = certain(elements, scale, zeros, None)
    values = np.sort(fx.floats(exact.values, exact.bits))
    mine = np.argsort(found.values, kind="stable")
    off = abs(np.sqrt(abs(found.values[mine])) - np.sqrt(abs(values)))
    assert (off <= found.errors[mine] * np.sqrt(abs(values)) * (1 + 1e-9) + 2 * UNIT * np.sqrt(abs(values))).all()


@pytest.mark.sweep
@pytest.mark.parametrize("n", [100, 130])
def test_a_pendulum_of_many_links(n):
    """ω² = (g/L) times the roots of the Laguerre polynomial; no wider bounds on either side of what integers reach."""
    problem = problem_of(text_source(scenes.pendulum(n)))
    modes = problem.modal.modes
    with mpmath.workdps(60):
        roots = _laguerre_roots(n)
        for mode, root in zip(modes, roots, strict=True):
            exact = mpmath.sqrt(mpmath.mpf(981) / 100 * root)
            assert abs(mode.omega - exact) <= mode.error * exact
    assert max(mode.error for mode in modes) < 4e-14
    assert modes[0].error < 2e-15


def _laguerre_roots(n):
    """Roots of L_n by Newton's method from those of the tridiagonal matrix of its recurrence."""
    diagonal, beside = 2.0 * np.arange(n) + 1, np.arange(1.0, n)
    start = np.linalg.eigvalsh(np.diag(diagonal) + np.diag(beside, 1) + np.diag(beside, -1))
    roots = []
    for x in start:
        x = mpmath.mpf(float(x))
        for _ in range(8):
            before, here = mpmath.mpf(1), 1 - x
            for k in range(1, n):
                before, here = here, ((2 * k + 1 - x) * here - k * before) / (k + 1)
            x -= here * x / (n * (here - before))
        roots.append(x)
    return sorted(roots)


def test_no_integers_where_floats_suffice(monkeypatch):
    def refused(*_):
        raise AssertionError("integers")

    monkeypatch.setattr("vibcli.analyses.modal.undamped_certified.enclosed", refused)
    problem = problem_of(text_source(scenes.pendulum(60)))
    assert len(problem.modal.modes) == 60
    with pytest.raises(AssertionError):
        undamped(chain(60, np.random.default_rng(1), spread=14.0, entries=1e-6))


def test_split_products():
    random, n = np.random.default_rng(4), 70
    a = random.standard_normal((4, n)) * 10.0 ** random.uniform(-6, 6, (4, n))
    a = DoubleDouble(a, a * random.uniform(-1, 1, a.shape) * 2.0**-54)
    b = DoubleDouble(random.standard_normal((n, 3)), np.zeros((n, 3)))
    found = product(a, b)
    for i in range(4):
        for j in range(3):
            exact = sum((Fraction(a.hi[i, k]) + Fraction(a.lo[i, k])) * Fraction(b.hi[k, j]) for k in range(n))
            off = abs(Fraction(found.value.hi[i, j]) + Fraction(found.value.lo[i, j]) - exact)
            assert off <= Fraction(found.error[i, j])
            assert found.error[i, j] <= 1e-23 * abs(a.hi[i]).max() * abs(b.hi[:, j]).max()
