"""Sums over the modes that are not counted, beside those of a hanging chain in Bessel functions."""

import math

import mpmath
import numpy as np
import pytest

from tests.support.random_members import at_rest
from vibcli.analyses.continuous.mode_basis import ModeBasis
from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.continuous.uncounted_modes import UncountedModes
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece

COUNTED, LENGTH, MU, G = 8, 1.7, 2.3, 9.81


@pytest.fixture(scope="module")
def uncounted():
    piece = Piece(LENGTH, 0.0, MU * G * LENGTH, -MU * G, MU, 0.0, 0.0)
    system = FactoredSystem(0, pieces=[PlacedPiece("member", 0.0, piece, ({}, {}), at_rest(piece, ({}, {})))])
    basis, none = ModeBasis(NaturalModes(system).numbered(1, COUNTED), system.pieces), np.zeros((0, 0))
    return UncountedModes(basis, none, none, [], [], np.zeros((COUNTED, 0)), np.zeros(COUNTED))


def reach(uncounted, x):
    return uncounted.reach(LinearOutput(0.0, places={FieldPoint(0, x, 0, 0): 1.0}), 1.5, 0)


def exact(x):
    """√Σ φ²/ω³ over n > 8, ω = ½j√(g/L), φ² = J₀(j√(1 − x/L))²/(μL J₁(j)²), of so many as matter."""
    zeros = [mpmath.besseljzero(0, n) for n in range(COUNTED + 1, 200)]
    return math.sqrt(sum(float(mpmath.besselj(0, j * math.sqrt(1 - x / LENGTH))**2 / mpmath.besselj(1, j)**2 / (
        j / 2 * math.sqrt(G / LENGTH))**3) for j in zeros) / (MU * LENGTH))


@pytest.mark.sweep
@pytest.mark.parametrize("x", [0.9, 1.6])
def test_sums_within_a_hanging_chain_are_bounded_closely(uncounted, x):
    assert exact(x) <= reach(uncounted, x) <= 1.2 * exact(x)


@pytest.mark.sweep
@pytest.mark.parametrize("x", [LENGTH, LENGTH * (1 - 1e-9), LENGTH * (1 - 1e-5)])
def test_next_to_an_end_without_tension_no_sum_is_told(uncounted, x):
    assert reach(uncounted, x) == math.inf
