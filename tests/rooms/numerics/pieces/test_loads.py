"""Loads spread along pieces, beside closed forms and the equation itself."""

import random

import mpmath
import numpy as np
import pytest
from rooms.numerics.pieces.test_graded import graded
from rooms.numerics.pieces.test_stiffness import pieces

from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.graded import graded_integrals
from vibcli.numerics.pieces.loads import LoadForm, LoadStretch, LoadTerm, end_loads, end_loads_slope, loaded_fields
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

BEAM = Piece(2.0, 3.0, 0.0, 0.0, 1.0, 0.0, 0.0)


def form(*terms, end=np.inf):
    return LoadForm((LoadStretch(0.0, end, 0.0, tuple(LoadTerm(*term) for term in terms)),))


def test_a_beam_at_rest_takes_what_textbooks_say():
    even = form((6.0, 0, 0.0))
    assert end_loads(BEAM, 0.0, even) == pytest.approx([6, 2, 6, -2], rel=1e-14)
    assert end_loads(BEAM, 0.0, form((1.0, 1, 0.0))) == pytest.approx([0.6, 4 / 15, 1.4, -0.4], rel=1e-13)
    for x in (0.0, 0.5, 1.0, 2.0):
        found = loaded_fields(BEAM, 0.0, even, x)
        assert found[0] == pytest.approx(6.0 * x**2 * (2 - x) ** 2 / 72, abs=1e-15)
        assert found[2] == pytest.approx(6.0 * (12 * x**2 - 24 * x + 8) / 72, rel=1e-13)
        assert found[3] == pytest.approx(6.0 * (24 * x - 24) / 72, abs=1e-13)


def test_an_even_load_near_rest_is_as_at_rest():
    """However small κ is: the loads on the ends are those at rest but for O(κ l⁴/B)."""
    kappa = np.array([1e-18, -1e-13, 1e-9, 1e-9j, -1e-9 + 1e-9j])
    bar = BEAM._replace(bending=0.0, tension=3.0)
    for piece, rest in ((BEAM, [6, 2, 6, -2]), (bar, [6, 6])):
        assert np.abs(end_loads(piece, kappa, form((6.0, 0, 0.0))) - rest).max() <= 1e-8
        assert np.abs(end_loads(piece, kappa[:2], form((6.0, 0, 0.0))) - rest).max() <= 1e-12


def test_a_load_in_two_stretches_is_the_sum_of_both():
    whole = form((2.0 - 1j, 2, -0.3 + 2j))
    parts = whole.on(0, 0.7).stretches + tuple(
        one._replace(start=0.7, end=np.inf, origin=0.0) for one in whole.on(0.7, np.inf).stretches)
    assert end_loads(BEAM, 40.0, LoadForm(parts)) == pytest.approx(end_loads(BEAM, 40.0, whole), rel=1e-13)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(2))
def test_particular_solutions_satisfy_ends_and_loads(seed):
    """u = Re e^{λx}: its ends, and the load that it needs, give back its own forces and fields."""
    rng = random.Random(seed)
    for piece, kappa in [*pieces(seed, 12), *graded(seed, 6)]:
        if np.iscomplexobj(kappa):
            continue
        lam = complex(rng.uniform(-2, 2), rng.uniform(-9, 9)) / piece.length
        steady = piece.bending * lam**4 - piece.tension * lam**2 - piece.gradient * lam + kappa
        load = form((complex(steady), 0, lam), (complex(-piece.gradient * lam**2), 1, lam))

        def wave(x, lam=lam):
            return np.exp(lam * x)

        length, last = piece.length, piece.tension + piece.gradient * piece.length
        if piece.order == 4:
            ends = np.array([1, lam, wave(length), lam * wave(length)])
            forces = np.array([piece.bending * lam**3 - piece.tension * lam, -piece.bending * lam**2,
                               (last * lam - piece.bending * lam**3) * wave(length),
                               piece.bending * lam**2 * wave(length)])
        else:
            ends, forces = np.array([1, wave(length)]), np.array([-piece.tension * lam, last * lam * wave(length)])
        ends, forces = ends.real, forces.real
        d, slope = stiffness_and_slope(piece, kappa)
        units = np.array([1, length] * 2)[:: 4 // piece.order]
        put = end_loads(piece, kappa, load)
        near = np.abs(d).max() / np.abs(slope * kappa).max() if kappa else 1.0      # how far, relatively, a pole is
        size = (np.abs(d / units).max(axis=1) * np.abs(ends * units).max() + np.abs(forces) + np.abs(put)).max()
        assert np.abs((d @ ends - put - forces) / units).max() <= 1e-12 * size / min(1, near), (piece, kappa)
        for x in length * np.array([0.0, 0.21, 0.77, 1.0]):
            inner = fields(piece, kappa, ends, x)
            found = inner + loaded_fields(piece, kappa, load, x)
            assert abs(found[0] - wave(x).real) <= 1e-9 * (abs(inner[0]) + np.exp(2)) / min(1, near), (piece, kappa)


def test_by_the_ends_what_gauss_has():
    """Far above the load's own form, where floats take Green's identity, on a part of a piece too."""
    load = LoadForm((LoadStretch(0.3, 1.4, 0.1, (LoadTerm(1.0, 2, 0.0), LoadTerm(2.0 - 1j, 1, -0.5 + 3j))),))
    for piece in (BEAM, Piece(2.0, 0.0, 7.0, 0.0, 1.0, 0.0, 0.0)):
        for kappa in (-2e5, 3e4 - 7e5j):
            y, weights = np.polynomial.legendre.leggauss(200)
            x = 0.85 + 0.55 * y
            f = (x - 0.1) ** 2 + np.real((2 - 1j) * (x - 0.1) * np.exp((3j - 0.5) * (x - 0.1)))
            exact = (fields(piece, kappa, np.eye(piece.order)[:, None], x)[..., 0] * f * weights).sum(axis=-1) * 0.55
            assert np.abs(end_loads(piece, kappa, load) - exact).max() <= 1e-12 * np.abs(exact).max()


@pytest.mark.sweep
def test_the_slope_is_that_of_a_difference():
    load = form((1.0, 1, 0.0), (2.0, 0, 3j))
    with mpmath.workdps(20):
        exact, step = Piece(*map(mpmath.mpf, BEAM)), mpmath.mpf("1e-8")
        ahead, behind = (end_loads(exact, mpmath.mpf(-300) + side * step, load) for side in (1, -1))
        slope = ((ahead - behind) / (2 * step)).astype(float)
    assert np.abs(end_loads_slope(BEAM, -300.0, load) - slope).max() <= 1e-9 * np.abs(slope).max()


@pytest.mark.sweep
def test_many_digits_of_loads():
    with mpmath.workdps(40):
        exact = Piece(*map(mpmath.mpf, BEAM))
        found = end_loads(exact, mpmath.mpf(-50), form((mpmath.mpc(0, -1), 0, mpmath.mpc(0, 1))))
        part = 3 - mpmath.mpf(50)                                   # u = sin x needs the load (B − 50) sin x
        ends = np.array([0, 1, mpmath.sin(2), mpmath.cos(2)], object)
        forces = np.array([-3, 0, 3 * mpmath.cos(2), -3 * mpmath.sin(2)], object)
        d = stiffness_and_slope(exact, mpmath.mpf(-50))[0]
        assert max(abs(d @ ends - part * found - forces)) < 1e-34
        assert np.abs(found.astype(float) - end_loads(BEAM, -50.0, form((-1j, 0, 1j)))).max() < 1e-13


@pytest.mark.sweep
@pytest.mark.parametrize("piece", [Piece(2.0, 3.0, 5.5, -4.0, 1.0, 0.0, 0.0), Piece(2.0, 0.0, 0.0, 3.0, 1.0, 0.0, 0.0),
                                   Piece(2.0, 0.0, 6.0, -2.5, 1.0, 0.0, 0.0)])
def test_integrals_by_moments_are_those_of_the_fields(piece):
    """Where the tension varies along a piece, also where it vanishes at an end, in doubles and in more digits."""
    x, weights = np.polynomial.legendre.leggauss(9)
    for kappa, close in ((np.array([-3e3, -0.2]), 1e-14), (np.array([-40 + 3j]), 1e-14),
                         (np.array([mpmath.mpf(-7)]), 1e-37)):
        with mpmath.workdps(40):
            numbers = arithmetic_of(*piece, kappa)
            one, at = Piece(*numbers.array(piece)), numbers.array(piece.length * (1 + x) / 2)
            along = fields(one, kappa[:, None, None], numbers.array(np.eye(one.order))[:, None, :], at)[..., 0]
            found = graded_integrals(one, kappa, at, numbers.array(weights), numbers)
            assert abs(found - (along * numbers.array(weights)).sum(axis=-1)).max() <= close * abs(along).max()
