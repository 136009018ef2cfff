"""The polynomials of collocation at one place are those at many, to the last bit."""

import numpy as np

from vibcli.numerics.collocation_rule import rule


def test_at_one_place_the_same_operations_are_done():
    one, places = rule(40), np.array([-1.0, 1.0, 0.0, *np.random.default_rng(1).uniform(-1.2, 1.2, 60)])
    alone = np.concatenate([one.basis(places[k:k + 1]) for k in range(len(places))], axis=1)
    assert alone.shape == (42, 63) and np.array_equal(alone, one.basis(places))
