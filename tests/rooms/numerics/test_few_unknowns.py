"""Linear systems of few unknowns against exact arithmetic and least squares."""

import random
from fractions import Fraction

import numpy as np
import pytest

from vibcli.numerics.few_unknowns import FEW, shortest_solution


@pytest.mark.parametrize("n", range(1, FEW + 3))
def test_regular_systems(n):
    """To the rounding that the condition of the system allows: what is left of A x = b is worked out exactly."""
    generator = random.Random(n)
    rows = [[generator.uniform(-1, 1) for _ in range(n)] for _ in range(n)]
    right = [generator.uniform(-1, 1) for _ in range(n)]
    x = shortest_solution(rows, right, 1e-14)
    left = [float(sum(map(lambda a, y: Fraction(a) * Fraction(y), row, x)) - Fraction(b))
            for row, b in zip(rows, right, strict=True)]
    assert max(map(abs, left)) <= 1e-14 * n * max(map(abs, [1.0, *x]))


def test_first_pivot_is_zero():
    assert shortest_solution([[0.0, 2.0], [4.0, 1.0]], [2.0, 9.0], 1e-14) == [2.0, 1.0]


@pytest.mark.parametrize("rows", [[[1.0, 1.0], [1.0, 1.0]], [[0.0, 0.0], [0.0, 3.0]], [[1.0, 0.0], [0.0, 1e-9]]])
def test_singular_systems_have_the_shortest_solution(rows):
    expected = np.linalg.lstsq(rows, [2.0, 2.0], rcond=1e-8)[0]
    assert shortest_solution(rows, [2.0, 2.0], 1e-8) == expected.tolist()
