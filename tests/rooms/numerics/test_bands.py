"""Bands of many matrices eliminated at once: against LU of each, and where rows have to change places."""

import numpy as np
import pytest

from vibcli.numerics.bands import solved


def banded(n, width, many, seed):
    """(matrices (many, n, n), the same by rows (n, 2 width + 1, many)), complex and random within a band."""
    rng = np.random.default_rng(seed)
    i, j = np.nonzero(np.abs(np.subtract.outer(np.arange(n), np.arange(n))) <= width)
    full, rows = np.zeros((many, n, n), complex), np.zeros((n, 2 * width + 1, many), complex)
    full[:, i, j] = rng.normal(size=(many, len(i))) + 1j * rng.normal(size=(many, len(i)))
    rows[i, j - i + width] = full[:, i, j].T
    return full, rows, rng.normal(size=(n, 2, many)) + 0j


@pytest.mark.parametrize(("n", "width", "many"), [(1, 0, 3), (5, 0, 4), (7, 1, 5), (30, 3, 6), (4, 6, 3), (120, 2, 40)])
def test_as_lu_of_each_matrix_gives_it(n, width, many):
    full, rows, right = banded(n, width, many, n + width)
    found = solved(rows, right)
    wanted = np.linalg.solve(full, right.transpose(2, 0, 1)).transpose(1, 2, 0)
    size = np.abs(wanted).max(axis=(0, 1)) * np.linalg.cond(full)
    assert (np.abs(found - wanted).max(axis=(0, 1)) <= 10 * 2.0**-52 * size).all()


def test_rows_change_places_where_a_pivot_vanishes():
    """[0 1 0; 1 0 1; 0 1 1], among matrices that need nothing of the kind."""
    matrix = np.array([[0.0, 1, 0], [1, 0, 1], [0, 1, 1]])
    rows = np.zeros((3, 3, 2), complex)
    for k, full in enumerate((matrix, matrix + 5 * np.eye(3))):
        for i, j in zip(*np.nonzero(np.abs(np.subtract.outer(range(3), range(3))) <= 1), strict=True):
            rows[i, j - i + 1, k] = full[i, j]
    found = solved(rows, np.array([1.0, 2.0, 3.0])[:, None, None] * np.ones((1, 1, 2)))
    assert found[:, 0, 0] == pytest.approx([0.0, 1.0, 2.0])
    assert (matrix + 5 * np.eye(3)) @ found[:, 0, 1] == pytest.approx([1.0, 2.0, 3.0])


def test_a_singular_matrix_spoils_no_other():
    full, rows, right = banded(6, 1, 3, 2)
    rows[:, :, 1] = 0.0
    found = solved(rows, right)
    assert not np.isfinite(found[:, :, 1]).any()
    for k in (0, 2):
        assert full[k] @ found[:, :, k] == pytest.approx(right[:, :, k])
