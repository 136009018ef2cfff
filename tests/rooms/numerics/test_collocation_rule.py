"""The polynomials of collocation at few places are those at many, to the last bit."""

import numpy as np
import pytest

from vibcli.numerics.collocation_rule import FEW, rule


@pytest.mark.parametrize("count", [0, 1, 2, FEW])
def test_at_few_places_the_same_operations_are_done(count):
    one, places = rule(40), np.array([-1.0, 1.0, 0.0, *np.random.default_rng(1).uniform(-1.2, 1.2, 69)])
    every, few = one.basis(places), [one.basis(places[k:k + count]) for k in range(0, len(places), count or 99)]
    assert all(part.flags.c_contiguous and part.shape[0] == 42 for part in few)
    assert np.array_equal(np.concatenate(few, axis=1), every[:, :len(places) if count else 0])
