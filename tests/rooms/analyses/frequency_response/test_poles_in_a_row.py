"""Poles of masses in a row, all together: against Newton's method in 40 digits from each, and the eigenvalues of a
matrix."""

import mpmath
import numpy as np
import pytest

from vibcli.analyses.frequency_response.poles_and_zeros import _roots, pace
from vibcli.analyses.frequency_response.poles_in_a_row import poles_in_a_row
from vibcli.analyses.frequency_response.transfer_function import TransferFunction


def row(n, damping, coupled=None):
    """n masses on springs and dampers in no proportion, from the ground on."""
    dice = np.random.default_rng(n)
    k, c, m = dice.uniform(100, 2000, n), damping * dice.uniform(0, 5, n), dice.uniform(0.5, 3, n)
    K, C = (np.diag(part + np.append(part[1:], 0.0)) - np.diag(part[1:], 1) - np.diag(part[1:], -1) for part in (k, c))
    if coupled is not None:
        C[coupled] += damping
    b = np.zeros((3, n))
    b[0, 0] = 1.0
    return TransferFunction(np.diag(m), C, K, b, b)


def step_of_newton(system, s):
    """p/p′ of p = det D in 40 digits, by the three-term recurrence of determinants and its derivative."""
    K, C, M = (part.tolist() for part in (system.K, system.C, system.M))

    def entry(i, j):
        k, c, m = (mpmath.mpf(part[i][j]) for part in (K, C, M))
        return k + s * (c + s * m), c + 2 * s * m

    before, here = (mpmath.mpf(1), mpmath.mpf(0)), entry(0, 0)
    for i in range(1, system.n):
        D, above, below = entry(i, i), entry(i - 1, i), entry(i, i - 1)
        q = above[0] * below[0], above[0] * below[1] + above[1] * below[0]
        following = D[0] * here[0] - q[0] * before[0], (
            D[1] * here[0] + D[0] * here[1] - q[1] * before[0] - q[0] * before[1])
        before, here = here, following
    return here[0] / here[1]


@pytest.mark.parametrize(("n", "damping"), [(12, 0.01), (12, 2.0), (40, 0.5), (90, 0.1), (90, 1.0)])
def test_each_is_a_zero_of_the_determinant_and_none_is_missing(n, damping):
    system = row(n, damping)
    found = poles_in_a_row(system)
    assert len(found) == n and (np.diff(found.imag) > 0).all()
    eigenvalues = _roots([system.K, system.C, system.M], pace(system))
    assert np.abs(found - eigenvalues[np.argsort(eigenvalues.imag)]) == pytest.approx(0, abs=1e-9 * np.abs(found).max())
    with mpmath.workdps(40):
        off = [abs(step_of_newton(system, mpmath.mpc(complex(s)))) / abs(s) for s in found]
    assert max(off) <= 2e-15 * n


@pytest.mark.parametrize("system", [row(12, 60.0), row(12, 0.5, (0, 5)), row(3, 400.0)],
                         ids=["beyond critical damping", "in no row", "all beyond it"])
def test_what_is_left_to_eigenvalues(system):
    assert poles_in_a_row(system) is None
    assert len(system.poles()) == len([s for s in np.linalg.eigvals(np.block([
        [np.zeros_like(system.K), np.eye(system.n)],
        [-np.linalg.solve(system.M, system.K), -np.linalg.solve(system.M, system.C)]])) if s.imag >= 0])
