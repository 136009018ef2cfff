"""The argument principle on rectangles."""

import numpy as np
import pytest

from vibcli.numerics.contours import along

SIDES = [(1 - 1j, 1 + 7j), (1 + 7j, -1 + 7j), (-1 + 7j, -1 - 1j), (-1 - 1j, 1 - 1j)]


def test_zeros_less_poles():
    """sinh has zeros at 0, iπ, 2iπ within; 1/(s − 3i) has a pole; next to a pole no side is summed."""
    parts = along(lambda s: np.cosh(s) / np.sinh(s) - 1 / (s - 3j), SIDES)
    turns = sum(part.values.sum() for part in parts) / (2j * np.pi)
    assert abs(turns - 2) < 1e-5
    places = sum((part.values * part.s).sum() for part in parts) / (2j * np.pi)
    assert abs(places - (3j * np.pi - 3j)) < 1e-4
    beside, clear, *_ = along(lambda s: 1 / (s - 1 - 0.3j), SIDES)
    assert beside is None and clear is not None


@pytest.mark.parametrize("function", [lambda s: s * np.nan, lambda s: np.sin(1e9 * s.imag)])
def test_sides_on_which_nothing_can_be_told_are_given_up_soon(function):
    calls = []
    assert along(lambda s: calls.append(s.size) or function(s), [(0j, 3j), (0j, 1 + 0j)])[0] is None
    assert sum(calls) < 2000
