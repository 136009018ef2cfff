"""Tops of motions within cells between samples."""

import numpy as np
import pytest

from vibcli.analyses.continuous.modal_search import first_top


@pytest.mark.parametrize("top", [0.4, 0.5, 0.6])
def test_the_highest_sample_is_an_end_of_two_cells_and_the_top_in_either(top):
    def curve(t):
        return 1 - (t - top) ** 2

    cells = np.array([[0.0, 0.25], [0.25, 0.5], [0.5, 0.75], [0.75, 1.0]])
    t, value = first_top(curve, cells, curve(cells).max(axis=1), np.full(4, 0.1))
    assert t == pytest.approx(top, abs=1e-9) and value == 1
