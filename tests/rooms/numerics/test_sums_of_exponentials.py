"""Sums of exponentials at instants of which some are equidistant against the same one by one."""

import numpy as np
import pytest

from vibcli.numerics.sums_of_exponentials import AT_ONCE, sum_of_exponentials

RNG = np.random.default_rng(3)
GRID = np.linspace(0.0, 1.0, 1500)
INSTANTS = {
    "none": GRID[:0], "one": GRID[7:8], "few": GRID[:40], "even": GRID, "off zero": GRID[700:765],
    "apart": np.sort(RNG.random(200)), "by ratio": np.geomspace(1e-7, 1.0, 150),
    "runs": np.concatenate([GRID[:100], np.sort(RNG.uniform(0.1, 0.2, 20)), np.linspace(0.2, 0.3, 70), GRID[900:]])}


@pytest.mark.parametrize("t", INSTANTS.values(), ids=INSTANTS)
def test_each_instant(t):
    n = np.arange(1, 200)
    rates = -0.01 * n**2 + 9.87j * n**2
    c = (RNG.standard_normal(199) + 1j * RNG.standard_normal(199)) / n**2
    expected = np.real(np.exp(np.outer(t, rates)) @ c)
    off = np.abs(sum_of_exponentials(c, rates, t) - expected)
    assert (off <= 2.0**-52 * np.abs(c) @ (8 + 2 * np.abs(rates))).all()


def test_no_more_than_so_many_at_once(monkeypatch):
    """Sums in blocks of rates."""
    n = np.arange(1.0, 50.0)
    whole = sum_of_exponentials(1 / n**2, 1j * n, GRID)
    monkeypatch.setattr("vibcli.numerics.sums_of_exponentials.AT_ONCE", 400)
    assert AT_ONCE > 400
    np.testing.assert_allclose(sum_of_exponentials(1 / n**2, 1j * n, GRID), whole, atol=1e-14)
