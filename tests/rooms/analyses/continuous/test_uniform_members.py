"""Closed forms of uniform members: against mpmath, and against the count that serves all others."""

import math

import mpmath
import numpy as np
import pytest

from tests.support.moved_pieces import moved_pieces
from tests.support.random_members import at_rest
from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.continuous.shapes import shape_along
from vibcli.analyses.continuous.uniform_members import GUIDED, PINNED, UniformMember
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece

CLAMPED, FREE = (False, False), (True, True)
BEAM = Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
EQUATIONS = {
    (CLAMPED, FREE): lambda x: mpmath.cos(x) + mpmath.sech(x),
    (FREE, FREE): lambda x: mpmath.cos(x) - mpmath.sech(x),
    (CLAMPED, PINNED): lambda x: mpmath.tan(x) - mpmath.tanh(x),
    (GUIDED, FREE): lambda x: mpmath.tan(x) + mpmath.tanh(x)}


def source(piece, ends):
    """What finds the modes of one piece; ends: which of the end values move."""
    n, rows = 0, []
    for moves in (*ends[0], *ends[1]):
        rows.append({n: 1.0} if moves else {})
        n += moves
    placed = PlacedPiece("member", 0.0, piece, tuple(rows), at_rest(piece, rows))
    return NaturalModes(FactoredSystem(n, pieces=[placed]))


@pytest.mark.parametrize("ends", EQUATIONS)
def test_a_thousand_frequencies_of_beams_to_the_last_digits(ends):
    numbers = np.arange(1, 1001)
    member = UniformMember(BEAM, ends)
    phases, found = member.wave_numbers(numbers), member.frequencies(numbers)
    for n in (1, 2, 3, 4, 7, 12, 1000):
        with mpmath.workdps(50):
            exact = mpmath.findroot(EQUATIONS[ends], float(phases[n - 1]))
        assert round((exact - phases[0]) / math.pi) == n - 1
        assert abs(found[n - 1] / (exact * exact) - 1) < 1e-15


@pytest.mark.parametrize("order", [2, 4])
def test_closed_forms_are_what_counting_finds(order):
    kinds = ((False,), (True,)) if order == 2 else (CLAMPED, PINNED, GUIDED, FREE)
    for bed in (0.0, 5.0):
        piece = Piece(1.3, 1.7, 0.0, 0.0, 1.2, 0.0, bed) if order == 4 else Piece(1.3, 0.0, 2.3, 0.0, 1.2, 0.0, bed)
        for first in kinds:
            for last in kinds:
                closed, counted = source(piece, (first, last)), source(piece, (first, last))
                counted.uniform = None
                for one, other in zip(closed.numbered(1, 4), counted.numbered(1, 4), strict=True):
                    assert one.omega == pytest.approx(other.omega, rel=1e-13)
                    if not one.rigid and len(one.shape):
                        assert np.abs(one.shape) == pytest.approx(np.abs(other.shape), rel=1e-9)


def test_shapes_of_high_modes():
    modes = source(BEAM, (CLAMPED, FREE)).numbered(1, 1000)
    assert [abs(mode.shape[0]) for mode in modes] == pytest.approx([2] * 1000, rel=1e-13)
    x = np.array([0.1, 0.37, 0.5, 0.93])
    mode = modes[299]
    with mpmath.workdps(900):
        b = mpmath.findroot(EQUATIONS[CLAMPED, FREE], math.sqrt(mode.omega))
        ratio = (mpmath.cosh(b) + mpmath.cos(b)) / (mpmath.sinh(b) + mpmath.sin(b))
        exact = [float(mpmath.cosh(b * y) - mpmath.cos(b * y) - ratio * (mpmath.sinh(b * y) - mpmath.sin(b * y)))
                 for y in map(mpmath.mpf, x.tolist())]
    found = shape_along(moved_pieces(mode, "member"), x)[:, 0]
    assert np.abs(found) == pytest.approx(np.abs(exact), abs=4e-13)
