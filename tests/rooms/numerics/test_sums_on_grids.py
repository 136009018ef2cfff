"""Sums of very many exponentials on equidistant places against the same one by one."""

import numpy as np
import pytest

from vibcli.numerics.sums_on_grids import SumsOnGrid


@pytest.mark.parametrize("count", [1, 2, 17, 3000])
@pytest.mark.parametrize("turn", [1e-6, 0.4, 3.0])
def test_each_place_of_a_grid(count, turn):
    """turn: of the fastest from place to place."""
    rng = np.random.default_rng(7)
    omega = np.append((np.arange(300) * np.pi) ** 2, -2.5)
    c = (rng.standard_normal(301) + 1j * rng.standard_normal(301)) / np.arange(1, 302) ** 2
    step = turn / omega.max()
    expected = np.exp(1j * np.outer(step * np.arange(count), omega)) @ c
    assert np.abs(SumsOnGrid(omega, step, count).of(c) - expected.real).max() <= 2e-13 * np.abs(c).sum()
