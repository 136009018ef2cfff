"""Held bars whose stiffness resists rates: the s at which they vibrate, one by one."""

import numpy as np
import pytest

from vibcli.analyses.continuous.argument_count import held_within
from vibcli.analyses.continuous.dynamic_matrix import PieceStack
from vibcli.mechanics.factored_system import PlacedPiece
from vibcli.numerics.pieces.piece import Piece


@pytest.mark.parametrize("drag", [0.0, 3.0, 40.0])
def test_counted_one_by_one(drag):
    """μ s² + c s + K (1 + β s) = 0 with K = N (nπ/l)² + k."""
    beta, piece = 0.004, Piece(1.5, 0.0, 400.0, 0.0, 2.0, drag, 30.0)
    K = 400.0 * (np.arange(1, 1000) * np.pi / 1.5)**2 + 30.0
    roots = np.concatenate([np.roots([2.0, drag + beta * one, one]) for one in K])
    stack = PieceStack([PlacedPiece("bar", 0.0, piece, ({}, {}), [], beta)], [0], [({}, {})], False)
    for radius in (5.0, 20.0, 31.0, 60.0, 100.0, 170.0, 240.0):
        assert held_within(stack, radius).sum() == (abs(roots) < radius).sum()
