"""Pieces whose tension varies along them: Bessel's functions, limits, and laws of any division."""

import random

import mpmath
import numpy as np
import pytest

from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.held_count import held_count
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.stiffness import dynamic_stiffness, stiffness_and_slope

CHAIN = Piece(2.0, 0.0, 0.0, 0.7 * 9.81, 0.7, 0.0, 0.0)         # hangs, its free end at x = 0


def bessel(order, place, omega):
    return mpmath.besselj(order, 2 * mpmath.mpf(omega) * mpmath.sqrt(mpmath.mpf(place) / mpmath.mpf(9.81)))


def test_a_hanging_chain_has_the_zeros_of_bessel():
    roots = 0.5 * np.array([float(mpmath.besseljzero(0, i)) for i in (1, 2, 5, 30)]) * (9.81 / 2) ** 0.5
    assert held_count(CHAIN, roots * (1 - 1e-13)).tolist() == [0, 1, 4, 29]
    assert held_count(CHAIN, roots * (1 + 1e-13)).tolist() == [1, 2, 5, 30]
    for omega in (1e-3, 2.0, 40.0):
        d = dynamic_stiffness(CHAIN, 1j * omega)
        exact = -0.7 * (9.81 * 2) ** 0.5 * omega * bessel(1, 2, omega) / bessel(0, 2, omega)
        assert d[1, 1].real == pytest.approx(float(exact), rel=1e-13)
        assert not d[0].any() and not d[:, 0].any()
        for x in (0.0, 1e-9, 0.1, 1.5, 2.0):
            u = fields(CHAIN, -0.7 * omega**2, np.array([5.0, 1.0]), x)[0]
            assert u == pytest.approx(float(bessel(0, x, omega) / bessel(0, 2, omega)), abs=1e-13 * (1 + abs(u)))


def graded(seed, count):
    """(piece, κ)"""
    rng = random.Random(seed)
    for i in range(count):
        length, stiff, size = 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-2, 4), 10 ** rng.uniform(-3, 1.7)
        order = 2 + 2 * (i % 2)
        tension = stiff if order == 2 else rng.choice((0, 10 ** rng.uniform(-3, 3), -20)) * stiff / length**2
        gradient = (rng.choice((-0.9, -0.2, 1e-9, 10, 1e4)) * tension if order == 2 else
                    rng.choice((-1, 1)) * 10 ** rng.uniform(-6, 3) * stiff / length**2) / length
        kappa = rng.choice((-1, -1, 1)) * stiff * (size / length) ** order
        yield Piece(length, stiff if order == 4 else 0.0, tension, gradient, 1.0, 0.0, 0.0), kappa


def halves(piece, x):
    return (piece._replace(length=x),
            piece._replace(length=piece.length - x, tension=piece.tension + piece.gradient * x))


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(2))
def test_two_parts_make_the_whole(seed):
    for piece, kappa in graded(seed, 30):
        parts, h = halves(piece, 0.3713 * piece.length), piece.order // 2
        whole, slope = stiffness_and_slope(piece, kappa)
        left, right = (stiffness_and_slope(part, kappa)[0] for part in parts)
        joint = left[h:, h:] + right[:h, :h]
        counts = [held_count(one._replace(foundation=kappa), 0.0) for one in (piece, *parts)]
        assert counts[0] == counts[1] + counts[2] + (np.linalg.eigvalsh(joint) < 0).sum()
        ends = np.random.default_rng(seed).normal(size=2 * h) / np.array([1, piece.length] * 2)[::2 // h]
        inner = np.linalg.solve(joint, -left[h:, :h] @ ends[:h] - right[:h, h:] @ ends[h:])
        own = np.array([1, piece.length] * 2)[:h]
        found = fields(piece, kappa, ends, 0.3713 * piece.length)[:h]
        along = fields(piece, kappa, ends, np.linspace(0, piece.length, 9))[:, :h]
        worn = np.linalg.cond(joint / np.outer(own, own) ** 0) * 1e-13
        assert np.abs((found - inner) * own).max() <= max(1e-11, worn) * np.abs(along * own).max()
        x, weights = np.polynomial.legendre.leggauss(200)
        y = (x + 1) / 2                                             # dense where the tension may be small
        squares = fields(piece, kappa, ends, y**3 * piece.length)[:, 0] ** 2 * 3 * y**2
        assert ends @ slope @ ends == pytest.approx(weights @ squares * piece.length / 2, rel=1e-9)
        assert (whole == whole.T).all()


def test_without_gradient_it_is_the_uniform_piece():
    for piece, kappa in graded(5, 20):
        even = piece._replace(gradient=0.0)
        nearly = stiffness_and_slope(even._replace(gradient=1e-30), kappa)
        for one, other in zip(stiffness_and_slope(even, kappa), nearly, strict=True):
            assert np.allclose(one, other, rtol=0, atol=1e-10 * np.abs(one).max())


def test_many_digits_and_many_pieces():
    with mpmath.workdps(40):
        chain = Piece(*map(mpmath.mpf, CHAIN))._replace(gradient=mpmath.mpf(0.7) * mpmath.mpf(9.81))
        found = dynamic_stiffness(chain, mpmath.mpc(0, 2))[1, 1]
        exact = -mpmath.mpf(0.7) * mpmath.sqrt(mpmath.mpf(9.81) * 2) * 2 * bessel(1, 2, 2) / bessel(0, 2, 2)
        assert abs(found / exact - 1) < 1e-37
        u = fields(chain, mpmath.mpf(0.7) * -4, np.array([0, 1]), mpmath.mpf(1))[0]
        assert isinstance(u, mpmath.mpf)
        assert abs(u - bessel(0, 1, 2) / bessel(0, 2, 2)) < 1e-37
    pieces = [piece for piece, _ in graded(3, 10) if piece.order == 4]
    together = Piece(*(np.array(values) for values in zip(*pieces, strict=True)))
    found, _ = stiffness_and_slope(together, -2.0)
    for one, piece in zip(found, pieces, strict=True):
        assert np.allclose(one, stiffness_and_slope(piece, -2.0)[0], rtol=1e-12)


@pytest.mark.parametrize(("tension", "gradient"), [(4.9, 3.9), (12.7, -3.9), (0.0, 3.9)])
def test_ends_that_do_not_feel_each_other(tension, gradient):
    """u ~ e^(∓∫√(κ/N) dx) (κ N)^(−1/4) (Wentzel, Kramers, Brillouin): N u′/u = √(κ N) ∓ n/4 + O(1/√κ)."""
    length, kappa = 2.0, np.array([1e8, 1e18])
    d, slope = stiffness_and_slope(Piece(length, 0.0, tension, gradient, 0.4, 0.0, 0.0), kappa)
    for end, sign in ((0, 1), (1, -1)):
        here = tension + gradient * length * end
        if here:
            assert d[:, end, end] == pytest.approx(np.sqrt(kappa * here) + sign * gradient / 4, rel=1e-8)
            assert slope[:, end, end] == pytest.approx(np.sqrt(here / kappa) / 2, rel=1e-7)
    assert (abs(d[:, 0, 1]) <= 1e-15 * d[:, 1, 1]).all()


@pytest.mark.parametrize("piece", [CHAIN, Piece(1.0, 2.0, 30.0, 5.0, 1.0, 0.0, 0.0),
                                   Piece(1.0, 2.0, 0.3, 0.0, 1.0, 0.0, 0.0)])
def test_no_array_is_written_out(piece, monkeypatch):
    """A number of mpmath that stands before an array refuses it by a text that shows it: dearer than the product."""
    monkeypatch.setattr(mpmath.mp, "npconvert", lambda value: pytest.fail(f"an array of {np.size(value)} numbers")
                        if np.size(value) > 1 else mpmath.mpf(value.item()), raising=False)
    with mpmath.workdps(40):
        precise = Piece(*map(mpmath.mpf, piece))
        d, _ = stiffness_and_slope(precise, np.array([mpmath.mpf(-k) for k in (1, 7, 40)], object))
    assert d == pytest.approx(stiffness_and_slope(piece, np.array([-1.0, -7.0, -40.0]))[0].astype(object), rel=1e-11)


@pytest.mark.sweep
@pytest.mark.parametrize("piece", [Piece(3.0, 0.0, 58.86, -19.62, 2.0, 0.0, 0.0),
                                   Piece(3.0, 50.0, 100.0, -19.62, 2.0, 0.0, 1.0)])
def test_many_places_of_a_few_shapes_need_no_more_trees_than_one(piece, monkeypatch):
    from vibcli.numerics.pieces import graded as module

    trees, tree = [], module.graded_tree
    monkeypatch.setattr(module, "graded_tree", lambda *args: trees.append(args) or tree(*args))
    random = np.random.default_rng(1)
    kappa, ends = -random.uniform(0, 1e4, 30), random.normal(size=(30, piece.order))
    one = fields(piece, kappa, ends, np.array([[1.1]]))
    alone, places = len(trees), np.linspace(0.0, 3.0, 401)[:, None]
    trees.clear()
    many = fields(piece, kappa, ends, np.vstack([places, [[1.1]]]))
    assert alone == len(trees) and many.shape == (402, 30, piece.order)
    assert many[-1] == pytest.approx(one[0], rel=1e-13)
    assert many[200] == pytest.approx(fields(piece, kappa, ends, np.array([[1.5]]))[0], rel=1e-13)
    monkeypatch.setattr(module, "HELD", 500)        # fewer places at once
    assert fields(piece, kappa, ends, places) == pytest.approx(many[:-1], rel=1e-10, abs=1e-10 * abs(many).max())


@pytest.mark.sweep
@pytest.mark.parametrize("piece", [Piece(1.0, 0.0, 500.0, 49.0, 5.0, 0.0, 0.0),
                                   Piece(1.0, 0.0, 549.0, -49.0, 5.0, 0.0, 0.0),
                                   Piece(1.0, 3.0, 10.0, 5.0, 5.0, 0.0, 0.0)], ids=["hung", "upside down", "beam"])
def test_ends_that_do_not_feel_each_other_at_many_values_at_once(piece):
    """As at one at a time, in any order."""
    kappa = np.geomspace(1e14, 1e2, 25)
    for many, *ones in zip(stiffness_and_slope(piece, kappa), *(
                           stiffness_and_slope(piece, kappa[i:i + 1]) for i in range(25)), strict=True):
        size = np.sqrt(np.abs(np.diagonal(many, axis1=1, axis2=2)))
        assert (np.abs(many - np.concatenate(ones)) <= 1e-13 * size[:, :, None] * size[:, None, :]).all()
