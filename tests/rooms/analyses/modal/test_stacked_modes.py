"""Modes of many systems found by arrays agree with mpmath, and what arrays cannot tell is left unsettled."""

import mpmath
import numpy as np
import pytest

from vibcli.analyses.modal.stacked_damped import StackedDamped
from vibcli.analyses.modal.stacked_modes import StackedModes
from vibcli.mechanics.stacked_matrices import StackedMatrices


def chains(count, n, seed):
    """Masses, springs and dampers in a row, drawn over decades, as StackedMatrices."""
    rng = np.random.default_rng(seed)
    M, K, C, K_size, C_size = (np.zeros((count, n, n)) for _ in range(5))
    M[:, range(n), range(n)] = 10 ** rng.uniform(-1, 1, (count, n))
    for matrix, size, low, high in ((K, K_size, 2, 4), (C, C_size, -2, 0.5)):
        for i in range(n):
            weight = 10 ** rng.uniform(low, high, count)
            row = np.zeros(n)
            row[i] = 1.0
            if i:
                row[i - 1] = -1.0
            matrix += weight[:, None, None] * np.outer(row, row)
            size += weight[:, None, None] * np.abs(np.outer(row, row))
    return balanced(M, K, np.abs(M), K_size, C, C_size)


def balanced(M, K, M_size, K_size, C, C_size):
    """The StackedMatrices of systems at rest."""
    still = np.zeros(M.shape[:2])
    return StackedMatrices(M, K, M_size, K_size, C, C_size, still, still, 0)


def in_digits(matrices, i):
    """(ω ascending, [λ with Im λ > 0] by ascending |λ|) by mpmath."""
    with mpmath.workdps(40):
        n = matrices.M.shape[1]
        M, K, C = (mpmath.matrix(part[i].tolist()) for part in (matrices.M, matrices.K, matrices.C))
        squares = [K[0] / M[0]] if n == 1 else mpmath.eig(M**-1 * K, left=False, right=False)
        A = mpmath.zeros(2 * n)
        A[:n, n:] = mpmath.eye(n)
        A[n:, :n], A[n:, n:] = -(M**-1) * K, -(M**-1) * C
        values = [x for x in mpmath.eig(A, left=False, right=False) if mpmath.im(x) > 0]
        return sorted(mpmath.sqrt(mpmath.re(x)) for x in squares), sorted(values, key=abs)


@pytest.mark.parametrize("n", [1, 2, 4])
def test_they_agree_with_more_digits(n):
    matrices = chains(12, n, seed=n)
    natural = StackedModes(matrices)
    damped = StackedDamped(matrices, natural)
    assert natural.settled.sum() >= 7 and damped.settled.sum() >= 5
    for i in np.flatnonzero(natural.settled):
        omega, values = in_digits(matrices, i)
        for mode, true in zip(natural.modes(i), omega, strict=True):
            assert abs(mode.omega / true - 1) <= max(mode.error, 2e-16) <= 2e-13
        for mode, true in zip(damped.modes(i) if damped.settled[i] else (), values, strict=False):
            assert abs(mode.eigenvalue - true) <= mode.error * abs(true)
            assert abs(mode.decay / -mpmath.re(true) - 1) < 1e-12


def test_shapes_have_unit_modal_mass():
    matrices = chains(5, 3, seed=9)
    natural = StackedModes(matrices)
    for i in np.flatnonzero(natural.settled):
        X = np.array([mode.shape for mode in natural.modes(i)]).T
        assert np.abs(X.T @ matrices.M[i] @ X - np.eye(3)).max() < 1e-13


def test_what_is_not_told_is_left():
    eye, twice = np.eye(2), np.ones((2, 2))
    K = np.array([100 * eye, 100 * eye + 1e-7 * (2 * eye - twice), np.diag([100.0, 0.0]), np.full((2, 2), np.nan)])
    M = np.array([eye] * 4)
    still = np.zeros_like(K)
    matrices = balanced(M, K, M, np.abs(K), still, still)
    assert not StackedModes(matrices).settled.any()


def test_one_free_mode_has_no_frequency_at_all():
    K = np.array([[[k, -k], [-k, k]] for k in (100.0, 3.7)])
    M = np.array([np.diag([0.3, 1.7])] * 2)
    still = np.zeros_like(K)
    matrices = balanced(M, K, M, np.abs(K), still, still)
    assert not StackedModes(matrices).settled.any()
    found = StackedModes(matrices, free=True)
    assert found.settled.all() and found.modes(1)[0].omega == 0.0 and found.modes(1)[0].rigid
    assert found.modes(1)[1].omega == pytest.approx((3.7 * (1 / 0.3 + 1 / 1.7)) ** 0.5, rel=1e-15)
