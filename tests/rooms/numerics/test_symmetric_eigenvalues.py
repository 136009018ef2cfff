"""The enclosed eigenvalue of one row against the way that all matrices go."""

import random

import numpy as np

from vibcli.numerics.symmetric_eigenvalues import spectrum


def test_one_row_is_enclosed_as_all_matrices_are():
    numbers, compared = random.Random("rows"), 0
    for bits, goal in ((220, 60), (230, 60), (700, 200), (3000, 660)) * 6:
        a = np.array([[numbers.choice((-1, 1)) * numbers.getrandbits(numbers.randint(bits // 2, bits + 20))]], object)
        slack = numbers.uniform(0, 12)
        short, long = (spectrum(a, bits, goal, 0, slack, start) for start in (None, np.eye(1)))
        assert (short.values.tolist(), short.shift) == (a[0].tolist(), long.shift)
        assert short.values.tolist() == long.values.tolist() and short.vectors.tolist() == long.vectors.tolist()
        assert short.radius.tolist() == long.radius.tolist()
        compared += 1
    assert compared == 24
