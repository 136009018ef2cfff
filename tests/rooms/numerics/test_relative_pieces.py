"""The stiffness of short pieces of beams by relative motions, against 60 digits of that of their ends."""

import random

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.relative import in_relative_motions
from vibcli.numerics.pieces.stiffness import stiffness_and_slope


@pytest.mark.parametrize("seed", range(6))
def test_nothing_is_lost(seed):
    draw = random.Random(seed)
    length, bending = 10 ** draw.uniform(-8, 0), 10 ** draw.uniform(-2, 3)
    kappa = complex(1, draw.uniform(-1, 1)) * 10 ** draw.uniform(-20, 3) * bending / length**4 * draw.choice([-1, 1])
    tension = 10 ** draw.uniform(-10, 1) * bending / length**2 * draw.choice([-1, 1])
    piece = Piece(length, bending, tension, draw.choice([0.0, tension / length / 2]), 2.0, 0.0, 0.0)
    columns = Piece(*(np.array([[x]]) for x in piece))
    at = np.array([[kappa]])
    found = in_relative_motions(columns, at, *stiffness_and_slope(columns, at))
    with mpmath.workdps(60):
        exact = stiffness_and_slope(Piece(*map(mpf, piece)), mpmath.mpc(kappa))
        turned = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [1, mpf(length), 1, 0], [0, 1, 0, 1]], object)
        for got, right in zip(found, exact, strict=True):
            right = turned.T @ right @ turned
            for i, j in np.ndindex(4, 4):
                size = (abs(right[i, i]) * abs(right[j, j])) ** mpf(0.5)
                assert abs(mpmath.mpc(complex(got[0, 0, i, j])) - right[i, j]) <= 2e-13 * size
