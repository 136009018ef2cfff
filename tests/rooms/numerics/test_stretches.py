"""Extremes of curves along a line, where these have corners too."""

import numpy as np
import pytest

from vibcli.numerics.stretches import CurveStretch


@pytest.mark.parametrize("corner", [0.1234567, 0.5, 0.87654321])
def test_a_corner_is_found_as_near_as_a_zero_of_the_curve_is_told(corner):
    stretch = CurveStretch(0.0, 1.0, lambda x: np.abs(3308.0 * (np.asarray(x) - corner)))
    place, = stretch.extremes()
    assert abs(place - corner) < 1e-7
    assert stretch.values(np.array([place]))[0] < 1e-7 * stretch.values(np.array([0.0, 1.0])).max()
