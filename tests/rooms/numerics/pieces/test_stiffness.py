"""d(s) of uniform pieces beside the exponential of the system, over decades of all parameters."""

import random

import mpmath
import numpy as np
import pytest
from rooms.numerics.pieces.reference import stiffness

from vibcli.numerics.pieces.held_count import held_count
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.stiffness import dynamic_stiffness, stiffness_and_slope

EPS = 2.0**-52


def pieces(seed, count):
    """(piece, κ): bars, beams, drawn and pressed, near double roots too."""
    rng = random.Random(seed)
    for _ in range(count):
        length, stiff = 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-2, 4)
        kind, size = rng.choice(("bar", "beam", "drawn", "pressed", "double")), 10 ** rng.uniform(-6, 1.6)
        order = 2 if kind == "bar" else 4
        kappa = rng.choice((-1, -1, 1)) * stiff * (size / length) ** order
        if rng.random() < 0.3:
            kappa *= complex(1, rng.choice((1e-8, 0.1, 1, -10)))
        unit = stiff / length**2
        tension = {"bar": stiff, "beam": 0.0, "drawn": 10 ** rng.uniform(-6, 3) * unit,
                   "pressed": -(10 ** rng.uniform(-6, 2.5)) * unit,
                   "double": rng.choice((-2, 2)) * (abs(kappa) * stiff) ** 0.5 * (1 + rng.choice((0, 1e-15, -1e-7)))}
        yield Piece(length, 0.0 if kind == "bar" else stiff, tension[kind], 0.0, 1.0, 0.0, 0.0), kappa


def differences(piece, found, expected):
    """The largest difference over the largest entry, both in units of the length."""
    units = np.array([1, piece.length, 1, piece.length] if piece.order == 4 else [1, 1])
    scale = np.outer(units, units)
    expected = np.array(expected, object)
    most = max(abs(value) for value in (expected / scale).flat)
    return float(max(abs(value) for value in ((found - expected) / scale).flat) / most)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(3))
@mpmath.workdps(60)
def test_stiffness_to_the_last_digits(seed):
    for piece, kappa in pieces(seed, 20):
        found, slope = stiffness_and_slope(piece, kappa)
        kappa = mpmath.mpmathify(kappa)
        part = mpmath.mpf(2) ** -70         # what it changes, in κ and in N, is what the rounding of these must change
        expected, nearby = stiffness(piece, kappa), stiffness(piece, kappa * (1 + part))
        drawn = stiffness(piece._replace(tension=piece.tension * (1 + part)), kappa)
        turned, pulled = (differences(piece, np.array(one, object), expected) / part for one in (nearby, drawn))
        assert differences(piece, found, expected) <= 4 * EPS * (1 + turned + pulled), (piece, kappa)
        change = [[(a - b) / kappa / part for a, b in zip(one, other, strict=True)]
                  for one, other in zip(nearby, expected, strict=True)]
        if 1e-3 < turned < 100:
            assert differences(piece, slope, change) <= 1e-12, (piece, kappa)


def test_arrays_are_pieces_one_at_a_time():
    pairs = [(piece, kappa) for piece, kappa in pieces(7, 60) if piece.order == 4]
    together = Piece(*(np.array(values) for values in zip(*(piece for piece, _ in pairs), strict=True)))
    found, _ = stiffness_and_slope(together, np.array([kappa for _, kappa in pairs]))
    for (piece, kappa), one in zip(pairs, found, strict=True):
        assert differences(piece, stiffness_and_slope(piece, kappa)[0], one) <= 1e-13


def test_static_stiffness_and_many_digits():
    beam = Piece(2.0, 3.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    assert dynamic_stiffness(beam, 0.0).tolist() == [[4.5, 4.5, -4.5, 4.5], [4.5, 6, -4.5, 3], [-4.5, -4.5, 4.5, -4.5],
                                                     [4.5, 3, -4.5, 6]]
    with mpmath.workdps(60):
        exact = Piece(*map(mpmath.mpf, beam))
        assert differences(beam, dynamic_stiffness(exact, mpmath.mpc(0, 7)), stiffness(beam, -49)) < 1e-49


def test_stiff_ends_of_long_pieces_do_not_overflow():
    beam = Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    assert np.isfinite(dynamic_stiffness(beam, 1j * np.geomspace(1e-12, 1e8, 50))).all()
    assert dynamic_stiffness(beam, 1e8)[0, 0].real == pytest.approx(2**0.5 * 1e12, rel=1e-14)


def test_held_count_of_clamped_beams_is_that_of_their_closed_form():
    roots = np.array([4.730040744862704, 7.853204624095838, 10.995607838001671, 14.13716549125746, 17.27875965739948,
                      *((np.arange(6, 1200) + 0.5) * np.pi)])
    beam = Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    assert held_count(beam, (roots * (1 - 1e-9)) ** 2).tolist() == list(range(len(roots)))
    assert held_count(beam, (roots * (1 + 1e-9)) ** 2).tolist() == list(range(1, len(roots) + 1))


@pytest.mark.sweep
def test_pressed_on_a_foundation_the_count_is_that_of_halves():
    rng = random.Random(2)
    for _ in range(200):
        beam = Piece(1.0, 1.0, -(10 ** rng.uniform(0, 4)), 0.0, 1.0, 0.0, rng.choice((0, 10 ** rng.uniform(0, 6))))
        omega = 10 ** rng.uniform(-1, 4)
        half = beam._replace(length=0.5)
        middle = stiffness_and_slope(half, beam.undamped_reaction(omega))[0]
        assert held_count(beam, omega) == 2 * held_count(half, omega) + (middle[0, 0] < 0) + (middle[1, 1] < 0)


@pytest.mark.sweep
def test_nothing_is_lost_from_tiny_to_huge_pieces():
    """Doubles beside sixty digits of the formulas, which the tests above hold to the exponential where it can go."""
    rng, n = np.random.default_rng(4), 40
    size, sign, waves = 10 ** rng.uniform(-6, 4, n), rng.choice([-1, 1], n), rng.choice([-1, 0, 1], n)
    kappa = sign * size**4
    double = rng.choice([-2, 2], n) * np.sqrt(abs(kappa)) * (1 + rng.choice([0, 1e-14, -1e-9, 1e-3], n))
    tension = np.where(rng.random(n) < 0.3, double, waves * 10 ** rng.uniform(-8, 7, n))
    found, _ = stiffness_and_slope(Piece(1.0, 1.0, tension, 0.0, 1.0, 0.0, 0.0), kappa)
    with mpmath.workdps(60):
        tension, kappa = (np.array([mpmath.mpf(float(x)) for x in values], object) for values in (tension, kappa))
        piece, part = Piece(mpmath.mpf(1), mpmath.mpf(1), tension, 0, 1, 0, 0), mpmath.mpf(10) ** -30
        exact, _ = stiffness_and_slope(piece, kappa)
        nearby = [piece._replace(tension=tension * (1 + part)), piece._replace(length=1 + part)]
        turned = sum(abs(stiffness_and_slope(one, kappa)[0] - exact) for one in nearby).max(axis=(1, 2)) / part
        assert (abs(found - exact).max(axis=(1, 2)) <= 4 * EPS * (abs(exact).max(axis=(1, 2)) + turned)).all()


def test_no_frequency_at_all_gives_an_empty_array():
    beam = Piece(1.0, 2.0, 0.3, 0.0, 1.0, 0.0, 0.0)
    for kappa in (np.zeros(0), np.zeros(0, complex)):
        assert [part.shape for part in stiffness_and_slope(beam, kappa)] == [(0, 4, 4)] * 2
