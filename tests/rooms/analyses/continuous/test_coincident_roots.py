"""Several λ of several shapes that lie close together: of two critically damped members that are tied weakly."""

import numpy as np
import pytest

from vibcli.analyses.continuous.coincident_roots import _centred, _halved, _roots
from vibcli.analyses.continuous.damped_roots import Whole, approached, roots_at
from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
from vibcli.analyses.continuous.newton_of_members import Divisions
from vibcli.mechanics.factored_system import PlacedPiece
from vibcli.numerics.pieces.piece import Piece

CRITICAL, DOUBLE = 1.6572548969298002, -3.7325751437      # of a cantilever of unit data with a damper at its end


def tied(k):
    """Two of them."""
    beam = Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    pieces = [PlacedPiece(name, 0.0, beam, ({}, {}, {i: 1.0}, {i + 1: 1.0}), []) for name, i in (("a", 0), ("b", 2))]
    K, C, M = np.zeros((3, 4, 4))
    K[np.ix_([0, 2], [0, 2])] = k * np.array([[1.0, -1.0], [-1.0, 1.0]])
    C[[0, 2], [0, 2]] = CRITICAL
    return DynamicMatrix(np.array([K, C, M]), pieces)


@pytest.mark.parametrize("k", [1e-13, 1e-12, 1e-11, 1e-10])
def test_all_are_found_with_both_shapes(k):
    whole = Whole(tied(k))
    found = roots_at(whole, approached(whole, DOUBLE * (1 + 1e-7)))
    assert len(found) == 4
    assert all(abs(root.value - DOUBLE) <= (root.error + 1e-10) * abs(DOUBLE) for root in found)
    one, *_, last = (root.shape[[0, 2]] for root in found)
    assert abs(one @ last.conj()) <= 1e-6 * abs(one @ one.conj())


@pytest.mark.parametrize("k", [0.0, 1e-12, 1e-6, 1e-3])
def test_the_points_of_a_circle_bring_what_all_of_them_do(k):
    """D⁻¹ less what they bring has no pole among them: its mean over a wider circle about them is none."""
    circle = _centred(Divisions(tied(k)), complex(DOUBLE), 0.15)
    assert circle.several == 4 and circle.Y.shape[1] == 2
    error, found = _roots(circle)
    turns = np.exp(2j * np.pi * (np.arange(64) + 0.5) / 64)
    z = found.middle + 1.5 * found.radius * turns
    x, points = found.shapes.shapes[:, :4], found.points
    inverse = np.array([np.linalg.inv(D) for D in np.moveaxis(tied(k).at(z).D, -1, 0)])
    brought = np.einsum("pi,pj,kp->kij", x, x, 1 / (z[:, None] - points)) + np.einsum(
        "pi,pj,kp->kij", x.conj(), x.conj(), 1 / (z[:, None] - points.conj()))
    residues = [np.mean((1.5 * found.radius * turns)[:, None, None] * part, axis=0) for part in (inverse, brought)]
    assert np.abs(residues[1] - residues[0]).max() <= 1e-9 * np.abs(inverse).max() * found.radius
    assert error <= 1e-6


@pytest.mark.parametrize("m", [1, 2, 3, 4])
def test_halves_of_symmetric_matrices(m):
    rng = np.random.default_rng(7)
    A = rng.normal(size=(20, m, m)) + 1j * rng.normal(size=(20, m, m))
    A = A + np.swapaxes(A, 1, 2)
    F, off = _halved(A)
    assert off.max() <= 1e-12
    assert np.abs(F @ np.swapaxes(F, 1, 2) - A).max() <= 1e-12 * np.abs(A).max()
