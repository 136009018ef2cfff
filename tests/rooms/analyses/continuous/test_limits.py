"""Limits that prove members and their joints: rigid, massless, in halves, on a foundation, hanging."""

import math

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from tests.support.random_members import at_rest, random_members
from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.continuous.refinement import divided
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece


def placed(piece, *rows):
    return PlacedPiece("member", 0.0, piece, rows, at_rest(piece, rows))


def frequencies(system, count=5):
    return [mode.omega for mode in NaturalModes(system).numbered(1, count)]


@pytest.mark.parametrize("seed", [4, 10, 21])
def test_halves_that_are_clamped_together_are_the_whole(seed):
    whole = random_members(seed)
    n, pieces = whole.n, []
    for one in whole.pieces:
        half = one.piece.order // 2
        middle = tuple({n + way: 1.0} for way in range(half))
        n += half
        for part, rows in ((0.375, one.rows[:half] + middle), (0.625, middle + one.rows[half:])):
            pieces.append(placed(one.piece._replace(length=one.piece.length * part), *rows))
    assert frequencies(whole.with_parts(n=n, pieces=pieces)) == pytest.approx(frequencies(whole), rel=1e-12)


@pytest.mark.parametrize("ends", [({}, {}, {0: 1.0}, {1: 1.0}), ({0: 1.0}, {1: 1.0}, {2: 1.0}, {3: 1.0})])
def test_a_foundation_moves_every_square_alike(ends):
    n = sum(map(len, ends))
    bare, bedded = (Piece(1.4, 3.0, 0.0, 0.0, 0.7, 0.0, bed) for bed in (0.0, 11.0))
    squares = np.array(frequencies(FactoredSystem(n, pieces=[placed(bare, *ends)]), 6)) ** 2
    mass = [(1e-300, {0: 1.0})]         # so that counting has to find them
    found = np.array(frequencies(FactoredSystem(n, mass, pieces=[placed(bedded, *ends)]), 6)) ** 2
    assert found == pytest.approx(squares + 11.0 / 0.7, rel=1e-12)


@pytest.mark.sweep
def test_a_very_stiff_beam_is_a_rigid_body():
    size, inertia, k = 2.0, 3.0, 5.0
    beam = Piece(size, 1e14, 0.0, 0.0, inertia, 0.0, 0.0)
    rows = tuple({i: 1.0} for i in range(4))
    found = frequencies(FactoredSystem(4, springs=[(k, rows[0]), (k, rows[2])], pieces=[placed(beam, *rows)]), 2)
    assert found == pytest.approx([math.sqrt(2 * k / (inertia * size)), math.sqrt(6 * k / (inertia * size))], rel=1e-12)


def test_a_light_cantilever_is_a_spring():
    beam = Piece(2.0, 7.0, 0.0, 0.0, 1e-14, 0.0, 0.0)
    rows = ({}, {}, {0: 1.0}, {1: 1.0})
    found = frequencies(FactoredSystem(2, [(3.0, {0: 1.0})], pieces=[placed(beam, *rows)]), 1)
    assert found == pytest.approx([math.sqrt(3 * 7.0 / 2.0**3 / 3.0)], rel=1e-12)


@pytest.mark.parametrize("tension", [-3.0, 40.0])
def test_a_member_whose_ends_are_held_has_all_its_modes_at_a_time(tension):
    beam = Piece(1.7, 3.0, tension, 0.0, 2.3, 0.0, 0.0)
    held, joined = (NaturalModes(one).numbered(1, 40) for one in (
        FactoredSystem(0, pieces=[placed(beam, {}, {}, {}, {})]),
        FactoredSystem(2, pieces=[placed(beam._replace(length=0.6), {}, {}, {0: 1.0}, {1: 1.0}),
                                  placed(beam._replace(length=1.1), {0: 1.0}, {1: 1.0}, {}, {})])))
    assert len({id(mode.motion.system) for mode in held}) == 1
    assert max(abs(one.omega / two.omega - 1) / (one.error + two.error)
               for one, two in zip(held, joined, strict=True)) <= 1


@pytest.mark.sweep
def test_many_modes_of_a_chain_without_a_mass_have_the_zeros_of_bessel():
    chain = Piece(3.0, 0.0, 2.0 * 9.81 * 3.0, -2.0 * 9.81, 2.0, 0.0, 0.0)
    found = NaturalModes(FactoredSystem(0, pieces=[placed(chain, {}, {})])).numbered(1, 60)
    assert len({id(mode.motion.system) for mode in found}) == 1
    for mode in found:
        exact = mpmath.besseljzero(0, mode.index) / 2 * mpmath.sqrt(mpmath.mpf(9.81) / 3)
        assert abs(mode.omega / exact - 1) <= mode.error < 1e-14


@pytest.mark.sweep
@pytest.mark.parametrize("mass", [1e-10, 1e-4, 1.0])
def test_high_modes_of_a_chain_with_a_small_mass_keep_their_bounds_wherever_it_is_divided(mass):
    """Whose tension at the mass is but the difference of rounded ones."""
    size, inertia = 4.268775, 3.83788
    whole = Piece(size, 0.0, (inertia * size + mass) * 9.81, -inertia * 9.81, inertia, 0.0, 0.0)

    def modes(part):
        one, two = divided(whole, part)
        return NaturalModes(FactoredSystem(2, [(mass, {1: 1.0})], pieces=[
            placed(one, {}, {0: 1.0}), placed(two, {0: 1.0}, {1: 1.0})])).numbered(40, 48)

    known = modes(0.5)
    for part in (0.390625, 0.359375):
        for one, two in zip(known, modes(part), strict=True):
            assert abs(one.omega / two.omega - 1) <= one.error + two.error < 4e-14


@pytest.mark.sweep
@pytest.mark.parametrize(("size", "inertia", "part"), [(4.268775, 3.83788, 0.4375), (4.793647, 4.75004, 0.390625),
                                                       (4.793647, 4.75004, 0.234375), (4.793647, 4.75004, 0.5)])
def test_high_modes_of_a_chain_keep_their_bounds_wherever_it_is_divided(size, inertia, part):
    weight = inertia * 9.81
    whole = Piece(size, 0.0, weight * size, -weight, inertia, 0.0, 0.0)
    one, two = divided(whole, part)
    chain = FactoredSystem(1, pieces=[placed(one, {}, {0: 1.0}), placed(two, {0: 1.0}, {})])
    for mode in NaturalModes(chain).numbered(55, 72):
        exact = mpmath.besseljzero(0, mode.index) / 2 * mpmath.sqrt(mpmath.mpf(weight) / inertia / size)
        assert abs(mode.omega / exact - 1) <= mode.error < 1e-14


@pytest.mark.sweep
def test_a_hanging_chain_has_the_zeros_of_bessel():
    chain = Piece(1.7, 0.0, 2.3 * 9.81 * 1.7, -2.3 * 9.81, 2.3, 0.0, 0.0)
    found = frequencies(FactoredSystem(1, pieces=[placed(chain, {}, {0: 1.0})]), 6)
    exact = [float(mpmath.besseljzero(0, n)) / 2 * math.sqrt(9.81 / 1.7) for n in range(1, 7)]
    assert found == pytest.approx(exact, rel=1e-12)


@pytest.mark.sweep
def test_a_chain_counted_from_its_free_end_hangs_as_well():
    """Whose tension is 0 at x = 0."""
    chain = Piece(1.7, 0.0, 0.0, 2.3 * 9.81, 2.3, 0.0, 0.0)
    exact = [float(mpmath.besseljzero(0, n)) / 2 * math.sqrt(9.81 / 1.7) for n in range(1, 7)]
    assert frequencies(FactoredSystem(0, pieces=[placed(chain, {}, {})]), 6) == pytest.approx(exact, rel=1e-12)


COLUMN = """
    gravity: 9.81 m/s^2
    parameters: {L: 1.7 m, EI: 3 N*m^2, M: MASS kg}
    beams: {column: {from: [0, 0], to: [0, L], EI: EI, left: clamped, attached: [{at: L, mass: M}]}}
"""


def test_a_mass_on_a_massless_column_comes_to_rest_at_its_buckling_load():
    """M ω² = P/(tan(kL)/k − L), k² = P/EI (Euler): zero at P = Mg = π² EI/(4 L²)."""
    with mpmath.workdps(40):
        L, EI, g = map(mpmath.mpf, ("1.7", "3", "9.81"))
        critical = mpmath.pi**2 * EI / (4 * L**2)
        for share in ("1e-12", "1e-3", "0.5", "0.99", "0.999999", "0.999999999999", "1.000000000001", "1.5"):
            P = critical * mpmath.mpf(share)
            k = mpmath.sqrt(P / EI)
            square = P / (mpmath.tan(k * L) / k - L) * g / P
            scene = problem(COLUMN.replace("MASS", mpmath.nstr(P / g, 35)))
            mode = scene.modal.modes.first(1)[0]
            found = mode.omega**2 if mode.growth_rate is None else -mode.growth_rate**2
            assert abs(found - square) <= 1e-12 * (g / L + abs(square))
            assert abs(mpmath.sqrt(abs(found / square)) - 1) <= mode.error


def test_units_do_not_matter():
    system = random_members(3)

    def changed(piece):
        return piece._replace(piece=piece.piece._replace(inertia=piece.piece.inertia * 4.0))

    slow = system.with_parts(inertias=[(4.0 * m, row) for m, row in system.inertias],
                             pieces=[changed(piece) for piece in system.pieces])
    assert [2.0 * omega for omega in frequencies(slow)] == frequencies(system)
