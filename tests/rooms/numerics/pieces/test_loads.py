"""Loads spread along pieces and products of fields, beside closed forms and the equation itself."""

import random

import mpmath
import numpy as np
import pytest
from rooms.numerics.pieces.test_graded import graded
from rooms.numerics.pieces.test_stiffness import pieces

from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.integrals import product_integral
from vibcli.numerics.pieces.loads import end_loads, loaded_fields
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

BEAM = Piece(2.0, 3.0, 0.0, 0.0, 1.0, 0.0, 0.0)


def test_a_beam_at_rest_takes_what_textbooks_say():
    assert end_loads(BEAM, 0.0, lambda x: 0 * x + 6.0, 0.0) == pytest.approx([6, 2, 6, -2], rel=1e-14)
    assert end_loads(BEAM, 0.0, lambda x: x, 0.0) == pytest.approx([0.6, 4 / 15, 1.4, -0.4], rel=1e-13)
    x = np.array([0.0, 0.5, 1.0, 2.0])
    u = 6.0 * x**2 * (2 - x) ** 2 / 72
    found = loaded_fields(BEAM, 0.0, lambda x: 0 * x + 6.0, 0.0, x)
    assert found[:, 0] == pytest.approx(u, abs=1e-15)
    assert found[:, 2] == pytest.approx(6.0 * (12 * x**2 - 24 * x + 8) / 72, rel=1e-13)
    assert found[:, 3] == pytest.approx(6.0 * (24 * x - 24) / 72, abs=1e-13)


@pytest.mark.parametrize("seed", range(2))
def test_particular_solutions_satisfy_ends_and_loads(seed):
    """u = e^{λx}: its ends, and the load q that it needs, give back its own forces and fields."""
    rng = random.Random(seed)
    for piece, kappa in [*pieces(seed, 20), *graded(seed, 10)]:
        lam = complex(rng.uniform(-2, 2), rng.uniform(-9, 9)) / piece.length

        def wave(x, lam=lam):
            return np.exp(lam * x)

        def load(x, piece=piece, kappa=kappa, lam=lam):
            tension = piece.tension + piece.gradient * x
            return (piece.bending * lam**4 - tension * lam**2 - piece.gradient * lam + kappa) * np.exp(lam * x)

        length, last = piece.length, piece.tension + piece.gradient * piece.length
        if piece.order == 4:
            ends = np.array([1, lam, wave(length), lam * wave(length)])
            forces = np.array([piece.bending * lam**3 - piece.tension * lam, -piece.bending * lam**2,
                               (last * lam - piece.bending * lam**3) * wave(length),
                               piece.bending * lam**2 * wave(length)])
        else:
            ends, forces = np.array([1, wave(length)]), np.array([-piece.tension * lam, last * lam * wave(length)])
        d, slope = stiffness_and_slope(piece, kappa)
        units = np.array([1, length] * 2)[:: 4 // piece.order]
        terms = np.abs(d / units).max(axis=1) * np.abs(ends * units).max()
        put = end_loads(piece, kappa, load, abs(lam))
        near = np.abs(d).max() / np.abs(slope * kappa).max()                    # how far, relatively, a pole is
        size = (terms + np.abs(forces) + np.abs(put)).max() / min(1, near)
        assert np.abs((d @ ends - put - forces) / units).max() <= 1e-12 * np.abs(size).max(), (piece, kappa)
        x = length * np.array([0.0, 0.21, 0.77, 1.0])
        found = fields(piece, kappa, ends, x) + loaded_fields(piece, kappa, load, abs(lam), x)
        most = np.abs(fields(piece, kappa, ends, x)[:, 0]).max() + np.exp(2)
        assert np.abs(found[:, 0] - wave(x)).max() <= 1e-9 * most / min(1, near), (piece, kappa)


def test_products_of_fields_by_all_three_ways():
    ends, other = np.array([1.0, 0.2, -0.3, 0.7]), np.array([0.1, 1.0, 0.5, -0.2])
    x, weights = np.polynomial.legendre.leggauss(150)
    for kappa, second in ((-300.0, -300.0), (-300.0, -301.0), (-300.0, -2000.0), (5.0, -5.0)):
        u, v = (fields(BEAM, at, values, 1 + x)[:, 0] for at, values in ((kappa, ends), (second, other)))
        assert product_integral(BEAM, kappa, ends, second, other) == pytest.approx((weights * u * v).sum(), rel=1e-12)


def test_many_digits_of_loads():
    with mpmath.workdps(40):
        exact = Piece(*map(mpmath.mpf, BEAM))
        sine = np.frompyfunc(mpmath.sin, 1, 1)
        found = end_loads(exact, mpmath.mpf(-50), sine, 1.0)
        part = 3 - mpmath.mpf(50)                                   # u = sin x needs the load (B − 50) sin x
        ends = np.array([0, 1, mpmath.sin(2), mpmath.cos(2)], object)
        forces = np.array([-3, 0, 3 * mpmath.cos(2), -3 * mpmath.sin(2)], object)
        d = stiffness_and_slope(exact, mpmath.mpf(-50))[0]
        assert max(abs(d @ ends - part * found - forces)) < 1e-34
        assert np.abs(found.astype(float) - end_loads(BEAM, -50.0, np.sin, 1.0)).max() < 1e-13
