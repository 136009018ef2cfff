"""Fields between the ends of uniform pieces beside the state carried along them."""

import random

import mpmath
import numpy as np
import pytest
from rooms.numerics.pieces import reference
from rooms.numerics.pieces.test_stiffness import EPS, pieces

from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.piece import Piece


def far(found, expected):
    """The largest difference of each derivative over its largest value along the piece."""
    expected = np.array(expected, object)
    return np.array(abs(found - expected).max(axis=0) / abs(expected).max(axis=0), float)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(3))
@mpmath.workdps(60)
def test_fields_to_the_last_digits(seed):
    rng, part = random.Random(seed), mpmath.mpf(2) ** -70
    for piece, kappa in pieces(seed, 6):
        ends = [rng.gauss(0, 1) / (piece.length if i % 2 and piece.order == 4 else 1) for i in range(piece.order)]
        places = piece.length * np.array([0, 1e-9, 0.37, 0.5, 1 - 1e-8, 1])
        kappa = complex(kappa) if isinstance(kappa, complex) else kappa
        expected = reference.fields(piece, kappa, ends, places)
        nearby = np.array(reference.fields(piece, mpmath.mpmathify(kappa) * (1 + part), ends, places), object)
        drawn = piece._replace(tension=piece.tension * (1 + part))
        drawn = np.array(reference.fields(drawn, kappa, ends, places), object)
        turned = (far(nearby, expected) + far(drawn, expected)) / float(part)
        assert (far(fields(piece, kappa, ends, places), expected) <= 100 * EPS * (1 + turned)).all(), (piece, kappa)


def test_fields_of_high_modes_stay_bounded_and_fit_their_ends():
    beam = Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    ends = np.array([1.0, 0.0, 0.0, 0.0])
    for kappa in (-1e6, -1e12, 1e6, 1e15, -1e15 + 1e13j):
        found = fields(beam, kappa, ends, np.linspace(0, 1, 500))
        assert np.isfinite(found).all()
        assert np.abs(found[[0, -1], 0] - [1, 0]).max() < 1e-12
