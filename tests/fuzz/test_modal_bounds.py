"""Bounds of motions of beams by few modes, of a sample of the cases that modal_bounds surveys."""

import numpy as np
import pytest
from fuzz.modal_bounds import case

SEEDS = 0, 3, 8, 13, 21, 37, 90, 99


@pytest.mark.parametrize("seed", SEEDS)
def test_bounds_of_few_modes_hold(seed):
    kind, error, bound, size = case(seed)
    assert error <= bound + 1e-12 * size, kind
    assert not np.isfinite(bound) or bound <= 1e4 * max(error, 1e-6 * size), kind
