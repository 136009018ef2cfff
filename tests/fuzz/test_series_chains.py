"""Chains of laws in series, against 50 digits: `python -m fuzz.series_chains 1000` takes more of them."""

import random

from fuzz.series_chains import LIMIT, drawn, error


def test_forces_of_random_chains():
    chance = random.Random(1)
    errors = [error(*drawn(chance)) for _ in range(100)]
    assert max(errors) < LIMIT
    assert min(errors) < max(errors)        # they are measured


def test_a_wrong_force_is_seen():
    laws = [[("linear", 2.0)], [("cubic", 5.0)]]
    assert error(laws, 0.5) < LIMIT < error(laws, 0.5, [[("linear", 2.0)], [("cubic", 5.0 * (1 + 1e-14))]])
