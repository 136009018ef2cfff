"""Recurrences by rows against steps one by one."""

import numpy as np
import pytest

from vibcli.numerics.recurrences import ROW, recurrence, recurrence_of_matrices, row_maxima

LENGTHS = (0, 1, ROW - 1, ROW, ROW + 1, 3 * ROW, 1000)


def drawn(count, *shape, seed=1):
    dice = np.random.default_rng(seed)
    return dice.normal(size=(count, *shape)) + 1j * dice.normal(size=(count, *shape))


@pytest.mark.parametrize("count", LENGTHS)
@pytest.mark.parametrize("alike", [False, True])
def test_numbers(count, alike):
    z = np.exp(-0.01 + 1j * drawn(3, 1 if alike else count).real)
    a, start = drawn(3, count, seed=2), drawn(3, seed=3)
    found, c = recurrence(z, a, start), start
    for k in range(count):
        c = z[:, 0 if alike else k] * c + a[:, k]
        assert np.abs(found[:, k] - c).max() <= 1e-14 * 30
    assert found.shape == a.shape


@pytest.mark.parametrize("count", LENGTHS)
def test_matrices(count):
    z, a, start = np.triu(0.4 * drawn(count, 2, 2)), drawn(count, 2, seed=2), drawn(2, seed=3)
    found, c = recurrence_of_matrices(z, a, start), start
    for k in range(count):
        c = z[k] @ c + a[k]
        assert np.abs(found[k] - c).max() <= 1e-13


@pytest.mark.parametrize("count", LENGTHS[1:])
def test_largest_of_rows(count):
    sizes = np.abs(drawn(2, count + 1))
    found = row_maxima(sizes)
    assert found.shape == (2, -(-count // ROW))
    for row in range(found.shape[1]):
        assert (found[:, row] == sizes[:, row * ROW:min((row + 1) * ROW, count) + 1].max(axis=1)).all()
