"""Shapes of modes along members: known nodes, orthogonality by quadrature, ends."""

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from tests.support.moved_pieces import moved_pieces
from tests.support.random_members import at_rest, random_members
from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.continuous.shapes import Moved, antinodes, resting_and_turning, shape_along
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece

BEAM = Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)


def modes_of(n, *rows, piece=BEAM):
    pieces = [PlacedPiece("member", float(i), piece, ends, at_rest(piece, ends)) for i, ends in enumerate(rows)]
    return NaturalModes(FactoredSystem(n, pieces=pieces)).numbered(1, 4)


def test_nodes_do_not_hang_on_the_size_of_stiffness_and_inertia():
    """Also where the product of both is beyond floats."""
    moved = moved_pieces(modes_of(2, ({}, {}, {0: 1.0}, {1: 1.0}))[2], "member")
    heavy = [one._replace(kappa=1e170 * one.kappa, piece=one.piece._replace(bending=1e170, inertia=1e170))
             for one in moved]
    assert resting_and_turning(heavy)[0] == pytest.approx(resting_and_turning(moved)[0], rel=1e-14)


def test_nodes_and_antinodes_of_a_cantilever():
    modes = modes_of(2, ({}, {}, {0: 1.0}, {1: 1.0}))
    found = [resting_and_turning(moved_pieces(mode, "member"))[0] for mode in modes]
    assert [len(places) for places in found] == [0, 1, 2, 3]
    with mpmath.workdps(40):
        b = mpmath.findroot(lambda x: 1 + mpmath.cos(x) * mpmath.cosh(x), 4.69)
        ratio = (mpmath.cosh(b) + mpmath.cos(b)) / (mpmath.sinh(b) + mpmath.sin(b))
        shape = lambda x: mpmath.cosh(b*x) - mpmath.cos(b*x) - ratio * (mpmath.sinh(b*x) - mpmath.sin(b*x))  # noqa: E731
        node, top = mpmath.findroot(shape, 0.78), mpmath.findroot(lambda x: mpmath.diff(shape, x), 0.47)
    assert found[1] == pytest.approx([float(node)], rel=4e-15)
    moved = moved_pieces(modes[1], "member")
    assert antinodes(moved, resting_and_turning(moved)[1]) == pytest.approx([float(top), 1.0], rel=4e-15)


@pytest.mark.parametrize("seed", range(0, 40, 3))
def test_antinodes_are_the_tops_of_the_absolute_displacement(seed):
    system = random_members(seed)
    starts = np.cumsum([0.0, *(placed.piece.length for placed in system.pieces)])
    placed = [piece._replace(start=start) for piece, start in zip(system.pieces, starts, strict=False)]
    for mode in NaturalModes(system.with_parts(pieces=placed)).numbered(1, 5):
        pieces = moved_pieces(mode, "member")
        places = np.linspace(0.0, starts[-1], 20001)
        size = np.abs(shape_along(pieces, places)[:, 0])
        if np.ptp(size) > 1e-3 * size.max():
            higher = np.concatenate([[True], size[1:] > size[:-1]]), np.concatenate([size[:-1] >= size[1:], [True]])
            tops = places[higher[0] & higher[1] & (size > 1e-6 * size.max())]
            found = antinodes(pieces, resting_and_turning(pieces)[1])
            assert found == pytest.approx(tops.tolist(), abs=2 * places[1]), mode.index


@pytest.mark.parametrize("order", [2, 4])
def test_a_node_is_found_wherever_it_falls(order):
    """What is odd about the middle is exactly zero there, which may be a place that is looked at."""
    for k in np.linspace(0.1, 3.0, 60):
        slope = k * np.cos(k / 2)
        piece, ends = (Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0), [-1.0, 1.0]) if order == 2 else (
            BEAM, [-np.sin(k / 2), slope, np.sin(k / 2), slope])
        moved = Moved(0.0, piece, -k**order, np.array(ends), False)
        assert resting_and_turning([moved])[0] == pytest.approx([0.5], abs=1e-12)


def test_an_antinode_next_to_an_end_is_told():
    """u = cos βx falls off by (βδ)²/2 alone between 1 − δ, where it turns, and the end, which a weak spring holds."""
    bar = problem("bars: {rod: {length: 1 m, EA: 1 N, mass_per_length: 1 kg/m, right: {k: 1e-4 N/m}}}")
    mode = bar.modal.modes.first(2)[1]
    turns = np.pi / float(mode.omega)
    assert 1 - 2e-5 < turns < 1 - 1e-6
    assert bar.modal.fields(mode).antinode_places("rod") == pytest.approx([0.0, turns], rel=1e-12)


def test_where_a_bar_moves_least_is_no_antinode():
    """On a bed stiffer than the frequency u is a hyperbolic cosine, largest at the ends that springs drive."""
    piece = Moved(0.0, Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 9.0), 5.0, np.array([1.0, 1.0]), False)
    assert resting_and_turning([piece])[1] == pytest.approx([0.5])
    assert antinodes([piece], resting_and_turning([piece])[1]) == [0.0, 1.0]


def test_supports_are_no_nodes_and_modes_at_rest_at_joints_have_a_shape():
    modes = modes_of(3, ({}, {0: 1.0}, {}, {1: 1.0}), ({}, {1: 1.0}, {}, {2: 1.0}))
    assert [resting_and_turning(moved_pieces(mode, "member"))[0] for mode in modes[:2]] == [[], []]
    assert resting_and_turning(moved_pieces(modes[2], "member"))[0] == pytest.approx([0.5, 1.5], abs=1e-12)
    bar = modes_of(0, ({}, {}), piece=Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0))
    assert np.abs(shape_along(moved_pieces(bar[0], "member"), [0.0, 0.25, 1.0])[:, 0]) == pytest.approx(
        [0, 1, 0], abs=1e-14)


@pytest.mark.parametrize("seed", [0, 8, 17])
def test_shapes_are_orthogonal_with_what_is_attached(seed):
    system = random_members(seed)
    modes = NaturalModes(system).numbered(1, 5)
    x, weights = np.polynomial.legendre.leggauss(60)
    inertia = np.zeros((5, 5))
    for mass, row in system.inertias:
        at = np.array([sum(c * mode.shape[i] for i, c in row.items()) for mode in modes])
        inertia += mass * np.outer(at, at)
    starts = np.cumsum([0.0, *(placed.piece.length for placed in system.pieces)])
    placed = [piece._replace(start=start) for piece, start in zip(system.pieces, starts, strict=False)]
    modes = NaturalModes(system.with_parts(pieces=placed)).numbered(1, 5)
    for piece, start in zip(placed, starts, strict=False):
        places = start + piece.piece.length * (x + 1) / 2
        u = np.array([shape_along(moved_pieces(mode, "member"), places)[:, 0] for mode in modes])
        inertia += piece.piece.inertia * piece.piece.length / 2 * (u * weights) @ u.T
    assert inertia == pytest.approx(np.eye(5), abs=1e-9)


@pytest.mark.sweep
@pytest.mark.parametrize("B", [1e-3, 1e-5, 1e-60])
def test_a_string_is_looked_at_by_its_own_half_waves(B):
    """However little it resists bending: pinned its nodes are those of a string; clamped it stays within 1/γ."""
    stiff = BEAM._replace(bending=B, tension=1.0)
    for mode in modes_of(2, ({}, {0: 1.0}, {}, {1: 1.0}), piece=stiff):
        nodes, tops = resting_and_turning(moved_pieces(mode, "member"))
        assert nodes == pytest.approx(np.arange(1, mode.index) / mode.index, abs=1e-12)
        assert tops == pytest.approx((np.arange(mode.index) + 0.5) / mode.index, abs=1e-12)
    if B < 1e-6:
        return
    for mode in modes_of(1, ({}, {}, {}, {0: 1.0}), piece=stiff):
        nodes, tops = resting_and_turning(moved_pieces(mode, "member"))
        with mpmath.workdps(400):
            larger = mpmath.sqrt(1 + 4 * B * mpmath.mpf(mode.omega) ** 2)
            beta, gamma = mpmath.sqrt((larger - 1) / (2 * B)), mpmath.sqrt((larger + 1) / (2 * B))
            C = -(mpmath.sin(beta) - beta / gamma * mpmath.sinh(gamma)) / (mpmath.cos(beta) - mpmath.cosh(gamma))

            def u(x, C=C, b=beta, g=gamma):
                return mpmath.sin(b * x) - b / g * mpmath.sinh(g * x) + C * (mpmath.cos(b * x) - mpmath.cosh(g * x))

            assert len(nodes) == mode.index - 1 and len(tops) == mode.index
            for place in nodes:
                assert place == pytest.approx(float(mpmath.findroot(u, place)), abs=1e-11)
            for place in tops:
                assert place == pytest.approx(float(mpmath.findroot(lambda x: mpmath.diff(u, x), place)), abs=1e-10)
