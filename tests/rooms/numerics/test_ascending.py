"""Against NumPy's own."""

import numpy as np
import pytest

from vibcli.numerics.ascending import ascending, median


@pytest.mark.parametrize("values", [[], [3.0], [2.0, 1.0, 2.0, -0.0, 0.0], np.arange(12.0).reshape(3, 4) % 5])
def test_each_once(values):
    assert ascending(values).tolist() == np.unique(values).tolist()


@pytest.mark.parametrize("values", [[3.0], [4.0, 1.0], [9.0, 1.0, 2.0], [1.0, 8.0, 2.0, 4.0]])
def test_the_middle(values):
    assert median(np.array(values)) == np.median(values)
