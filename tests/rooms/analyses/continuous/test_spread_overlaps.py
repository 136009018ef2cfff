"""How far a load along a piece goes where it acts, against u = 1/κ + Σ c e^{rx} in mpmath."""

import mpmath
import numpy as np
import pytest

from vibcli.analyses.continuous.spread_overlaps import held_overlap
from vibcli.numerics.pieces.loads import LoadForm, LoadStretch, LoadTerm
from vibcli.numerics.pieces.piece import Piece

LENGTH, CUT, TENSION = 1.3, 0.4, 0.7
KAPPA = np.array([5 + 3j, -2000 + 50j, 3e6 * np.exp(1j), 1e10 * np.exp(2.9j)])


def _closed(piece, kappa):
    """∫ (2 + x) u dx under a unit load."""
    with mpmath.workdps(40):
        L, B, N, kappa = piece.length, mpmath.mpf(piece.bending), mpmath.mpf(piece.tension), mpmath.mpc(kappa)
        roots = mpmath.polyroots([B, 0, -N, 0, kappa] if B else [-N, 0, kappa], maxsteps=200, extraprec=100)
        ends = [(x, order) for x in (0, L) for order in range(len(roots) // 2)]
        scaled = [(r, L if mpmath.re(r) > 0 else 0) for r in roots]
        A = mpmath.matrix([[r**order * mpmath.exp(r * (x - a)) for r, a in scaled] for x, order in ends])
        c = mpmath.lu_solve(A, mpmath.matrix([-1 / kappa if not order else 0 for _, order in ends]))

        def integral(r, a):
            return ((2 + L) * mpmath.exp(r * (L - a)) - 2 * mpmath.exp(-r * a)) / r - (
                mpmath.exp(r * (L - a)) - mpmath.exp(-r * a)) / r**2

        return complex((2 * L + mpmath.mpf(L)**2 / 2) / kappa + sum(
            c[j] * integral(*scaled[j]) for j in range(len(roots))))


@pytest.mark.sweep
@pytest.mark.parametrize("bending", [0.0, 2.0])
def test_what_a_load_bends_is_felt_by_another_as_in_closed_form(bending):
    piece = Piece(LENGTH, bending, TENSION, 0.0, 1.0, 0.0, 0.0)
    ramp = LoadForm((LoadStretch(0.0, LENGTH, 0.0, (LoadTerm(2.0, 0, 0.0), LoadTerm(1.0, 1, 0.0))),))
    one = LoadTerm(1.0, 0, 0.0)
    whole = LoadForm((LoadStretch(0.0, LENGTH, 0.0, (one,)),))
    halves = LoadForm((LoadStretch(0.0, CUT, 0.0, (one,)), LoadStretch(CUT, LENGTH, CUT, (one,))))
    expected = np.array([_closed(piece, kappa) for kappa in KAPPA])
    for first, second in ((ramp, whole), (whole, ramp), (ramp, halves), (halves, ramp)):
        assert np.abs(held_overlap(piece, KAPPA, first, second) / expected - 1).max() < 1e-13


def _hanging(piece, kappa):
    """∫ (2 + x) u dx under a unit load where the tension is N + n x: u = 1/κ + a I₀(z) + b K₀(z), z = 2 √(κ (N + n
    x))/n."""
    def bessel(x):
        z = 2 * mpmath.sqrt(mpmath.mpc(kappa) * (piece.tension + piece.gradient * x)) / piece.gradient
        return mpmath.besseli(0, z), mpmath.besselk(0, z)

    nodes, weights = np.polynomial.legendre.leggauss(40)
    with mpmath.workdps(20):
        a = mpmath.lu_solve(mpmath.matrix([bessel(0), bessel(piece.length)]), mpmath.matrix([-1 / kappa] * 2))
        x = piece.length * (1 + nodes) / 2
        u = np.array([complex(1 / kappa + sum(c * f for c, f in zip(a, bessel(float(one)), strict=True))) for one in x])
    return piece.length / 2 * (weights * (2 + x)) @ u


@pytest.mark.sweep
def test_so_it_is_where_the_tension_varies_along_the_piece():
    piece, kappa = Piece(LENGTH, 0.0, TENSION, 2.5, 1.0, 0.0, 0.0), np.array([30 + 3j, -200 + 50j])
    expected = np.array([_hanging(piece, one) for one in kappa])
    one = LoadTerm(1.0, 0, 0.0)
    ramp = LoadForm((LoadStretch(0.0, LENGTH, 0.0, (LoadTerm(2.0, 0, 0.0), LoadTerm(1.0, 1, 0.0))),))
    whole = LoadForm((LoadStretch(0.0, LENGTH, 0.0, (one,)),))
    halves = LoadForm((LoadStretch(0.0, CUT, 0.0, (one,)), LoadStretch(CUT, LENGTH, CUT, (one,))))
    for first, second in ((ramp, whole), (whole, ramp), (ramp, halves), (halves, ramp)):
        assert np.abs(held_overlap(piece, kappa, first, second) / expected - 1).max() < 1e-11
    beam = piece._replace(bending=2.0)
    assert np.abs(held_overlap(beam, kappa, ramp, halves) / held_overlap(beam, kappa, whole, ramp) - 1).max() < 1e-11
