"""Frequency responses of long chains of masses, springs and dampers, whose far ends hardly feel each other."""

import numpy as np
import pytest

from vibcli.analyses.frequency_response.extremes import extremes
from vibcli.analyses.frequency_response.peaks import peaks
from vibcli.analyses.frequency_response.transfer_function import TransferFunction


def chain(n, c, output=0, driven=-1):
    """Unit masses, springs of 100 and dampers c one after another from the ground on, driven at the end."""
    row = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    row[-1, -1] = 1.0
    b, seen = np.zeros((3, n)), np.zeros((3, n))
    b[0, driven] = seen[0, output] = 1.0
    return TransferFunction(np.eye(n), c * row, 100 * row, b, seen)


def frequencies(n):
    """ω = 2√(k/m) sin((2j − 1)π/(4n + 2))."""
    return 20 * np.sin((2 * np.arange(1, n + 1) - 1) * np.pi / (4 * n + 2))


@pytest.mark.parametrize("c", [1e-3, 1e-9])
def test_every_peak_of_a_chain_with_weak_dampers(c):
    """However fast the springs would creep against the dampers alone, peaks are where the masses are."""
    assert [one.Omega for one in peaks(chain(40, c))] == pytest.approx(frequencies(40), rel=1e-4)


def test_what_the_input_does_not_reach_has_no_peaks():
    apart = chain(6, 0.1)
    for matrix in (apart.K, apart.C):
        matrix[2, 3] = matrix[3, 2] = 0.0
    assert extremes(apart) == []


def test_zeros_of_a_long_chain_are_sought_amid_its_frequencies():
    """Far above them H is no float any more, and the eigenvalue problem for zeros none."""
    assert len(peaks(chain(200, 0.0632, output=63))) > 90
