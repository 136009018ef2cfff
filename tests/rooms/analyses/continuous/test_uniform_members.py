"""Closed forms of uniform members: against mpmath, and against the count that serves all others."""

import itertools
import math

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from tests.support.moved_pieces import moved_pieces
from tests.support.random_members import at_rest
from vibcli.analyses.continuous import mode_source
from vibcli.analyses.continuous.mode_fields import ModeFields
from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.continuous.shapes import shape_along
from vibcli.analyses.continuous.uniform_members import GUIDED, PINNED, UniformMember, uniform_member
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece
from vibcli.quantities.modal import SHAPE
from vibcli.symbolic.evaluation import Floats

CLAMPED, FREE = (False, False), (True, True)
BEAM = Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
EQUATIONS = {
    (CLAMPED, FREE): lambda x: mpmath.cos(x) + mpmath.sech(x),
    (FREE, FREE): lambda x: mpmath.cos(x) - mpmath.sech(x),
    (CLAMPED, PINNED): lambda x: mpmath.tan(x) - mpmath.tanh(x),
    (GUIDED, FREE): lambda x: mpmath.tan(x) + mpmath.tanh(x)}


def source(piece, ends):
    """What finds the modes of one piece; ends: which of the end values move."""
    n, rows = 0, []
    for moves in (*ends[0], *ends[1]):
        rows.append({n: 1.0} if moves else {})
        n += moves
    placed = PlacedPiece("member", 0.0, piece, tuple(rows), at_rest(piece, rows))
    return NaturalModes(FactoredSystem(n, pieces=[placed]))


@pytest.mark.parametrize("ends", EQUATIONS)
def test_a_thousand_frequencies_of_beams_to_the_last_digits(ends):
    numbers = np.arange(1, 1001)
    member = UniformMember(BEAM, ends)
    phases, found = member.wave_numbers(numbers), member.frequencies(numbers)
    for n in (1, 2, 3, 4, 6, 7, 8, 11, 12, 13, 14, 1000):
        with mpmath.workdps(50):
            exact = mpmath.findroot(EQUATIONS[ends], float(phases[n - 1]))
        assert round((exact - phases[0]) / math.pi) == n - 1
        assert abs(found[n - 1] / (exact * exact) - 1) < 1e-15


@pytest.mark.parametrize(("ends", "later"), [
    (((False,), (True,)), 0.5), (((False,), (False,)), 0.0), (((True,), (True,)), 0.0), ((PINNED, PINNED), 0.0),
    ((PINNED, GUIDED), 0.5)])
def test_a_thousand_frequencies_of_bars_and_of_beams_between_sines(ends, later):
    """(n − ½) π √(N/μ)/L and nπ √(N/μ)/L of bars and shafts, (…)² √(B/μ)/L² of beams."""
    beam = len(ends[0]) == 2
    member = UniformMember(Piece(1.3, 1.7 * beam, 2.3 * (not beam), 0.0, 1.2, 0.0, 0.0), ends)
    found = member.frequencies(np.arange(1, 1001))
    with mpmath.workdps(30):
        unit = mpmath.sqrt(mpmath.mpf(1.7 if beam else 2.3) / mpmath.mpf(1.2))
        exact = [unit * ((n - mpmath.mpf(later)) * mpmath.pi / mpmath.mpf(1.3)) ** (1 + beam) for n in range(1, 1001)]
        assert max(abs(one / other - 1) for one, other in zip(found.tolist(), exact, strict=True)) <= 1e-15


def test_masses_that_nothing_moves_leave_the_closed_form():
    shaken = problem("beams: {arm: {length: 1 m, EI: 100 N*m^2, mass_per_length: 2 kg/m, left: {clamped: base}}}\n"
                     "bodies: {base: {mass: 1 kg, slide: 'sin(50 rad/s*t)*1 m'}}\n")
    elements = shaken.configuration.linear_system
    assert elements.inertias and uniform_member(elements) == UniformMember(elements.pieces[0].piece, (CLAMPED, FREE))
    alone = problem("beams: {arm: {length: 1 m, EI: 100 N*m^2, mass_per_length: 2 kg/m, left: clamped}}\n")
    assert [mode.omega for mode in shaken.modal.modes.first(9)] == [mode.omega for mode in alone.modal.modes.first(9)]
    carried = problem("beams: {arm: {length: 1 m, EI: 100 N*m^2, mass_per_length: 2 kg/m, left: clamped, "
                      "attached: [{at: 1 m, mass: 1 kg}]}}\n")
    assert uniform_member(carried.configuration.linear_system) is None


@pytest.mark.sweep
@pytest.mark.parametrize("order", [2, 4])
def test_closed_forms_are_what_counting_finds(order):
    kinds = ((False,), (True,)) if order == 2 else (CLAMPED, PINNED, GUIDED, FREE)
    for bed in (0.0, 5.0):
        piece = Piece(1.3, 1.7, 0.0, 0.0, 1.2, 0.0, bed) if order == 4 else Piece(1.3, 0.0, 2.3, 0.0, 1.2, 0.0, bed)
        for first in kinds:
            for last in kinds:
                closed, counted = source(piece, (first, last)), source(piece, (first, last))
                counted.uniform = None
                for one, other in zip(closed.numbered(1, 4), counted.numbered(1, 4), strict=True):
                    assert one.omega == pytest.approx(other.omega, rel=1e-13)
                    if not one.rigid and len(one.shape):
                        assert np.abs(one.shape) == pytest.approx(np.abs(other.shape), rel=1e-9)


def exact_shape(ends, phase, shares):
    """(u, u′, u″, u‴) by the share of the length at such shares of it, in mpmath: what the ends leave of four waves."""
    at, far = waves(phase, mpmath.mpf(0)), waves(phase, mpmath.mpf(1))
    rows = [row for place, moves in ((at, ends[0]), (far, ends[1])) for row in (
        place[3 if moves[0] else 0], place[2 if moves[1] else 1])]
    # The second wave is not left out in any shape but that of rollers alone, which is all of the first.
    known = 0 if ends[0] in (GUIDED, FREE) else 1
    others = [k for k in range(4) if k != known]
    matrix = mpmath.matrix([[row[k] for k in others] for row in rows])
    found = mpmath.lu_solve(matrix, mpmath.matrix([-row[known] for row in rows]))       # least squares
    parts = dict(zip(others, found, strict=True)) | {known: mpmath.mpf(1)}
    return [[sum(parts[k] * row[k] for k in range(4)) for row in waves(phase, share)] for share in shares]


def waves(phase, share):
    """cos, sin, cosh and sinh of βx and their derivatives, four rows."""
    angle = phase * share
    c, s, C, S = mpmath.cos(angle), mpmath.sin(angle), mpmath.cosh(angle), mpmath.sinh(angle)
    rows = (c, s, C, S), (-s, c, S, C), (-c, -s, C, S), (s, -c, S, C)
    return [[phase**k * value for value in row] for k, row in enumerate(rows)]


EVERY_END = tuple(itertools.product((CLAMPED, PINNED, GUIDED, FREE), repeat=2))


@pytest.mark.parametrize(("number", "pairs"), [(1, EVERY_END), (2, EVERY_END), (1000, ((CLAMPED, FREE),))])
def test_shapes_at_any_place_to_the_last_digits(number, pairs):
    x = np.random.default_rng(number).uniform(0, 1.3, 4)
    piece = Piece(1.3, 1.7, 0.0, 0.0, 1.2, 0.0, 0.0)
    for ends in pairs:
        modes = source(piece, ends)
        rough = float(modes.uniform.wave_numbers(np.array([number]))[0])
        found = shape_along(moved_pieces(modes.numbered(*2 * (modes.uniform.resting + number,))[0], "member"), x)
        with mpmath.workdps(int(60 + 0.9 * rough)):
            phase = mpmath.findroot(condition(ends), rough)
            shares = [mpmath.mpf(place) / mpmath.mpf(1.3) for place in x.tolist()]
            exact = np.array(exact_shape(ends, phase, shares), object)
            top = np.abs(exact[:, 0]).argmax()
            exact = exact * (found[top, 0] / exact[top, 0]) / mpmath.mpf(1.3) ** np.arange(4)
        assert (np.abs(found - exact) <= 1e-15 * np.abs(exact).max(axis=0)).all(), ends


def condition(ends):
    """The frequency equation of a beam with these ends."""
    kinds = set(ends)
    if kinds <= {PINNED, GUIDED}:
        return mpmath.sin if len(kinds) == 1 else mpmath.cos
    if PINNED in kinds or GUIDED in kinds:
        return EQUATIONS[(CLAMPED, PINNED) if PINNED in kinds else (GUIDED, FREE)]
    return EQUATIONS[(FREE, FREE) if len(kinds) == 1 else (CLAMPED, FREE)]


def test_shapes_of_general_members_are_as_near_as_their_frequencies():
    """What ω is off turns a wave by as much of its phase: a part βL eps of the largest value, and no more."""
    piece = Piece(0.65, 1.7, 0.0, 0.0, 1.2, 0.0, 0.0)
    rows = [({}, {}, {0: 1.0}, {1: 1.0}), ({0: 1.0}, {1: 1.0}, {2: 1.0}, {3: 1.0})]
    halves = [PlacedPiece("member", i * 0.65, piece, row, at_rest(piece, row)) for i, row in enumerate(rows)]
    x = np.linspace(0, 1.3, 41)
    for number in (1, 4, 30, 300):
        whole = source(piece._replace(length=1.3), (CLAMPED, FREE)).numbered(number, number)
        parts = NaturalModes(FactoredSystem(4, pieces=halves)).numbered(number, number)
        exact, found = (shape_along(moved_pieces(mode[0], "member"), x)[:, 0] for mode in (whole, parts))
        phase, top = (number - 0.5) * np.pi, np.abs(exact).argmax()
        off = np.abs(found * np.sign(found[top] * exact[top]) - exact).max()
        assert off <= (8e-15 + 4 * phase * 2.0**-52) * np.abs(exact).max()


@pytest.mark.parametrize("more", ["", "points: {mid: {body: a, at: 0.5 m}}\n"])
def test_values_of_high_modes_are_off_by_no_more_than_told(more):
    """At a place that is no double itself, in a mode whose waves are many."""
    scene = problem("beams: {a: {length: 1.2 m, EI: 4 kN*m^2, mass_per_length: 3 kg/m, left: pinned, right: pinned}}\n"
                    + more)
    mode = NaturalModes(scene.configuration.linear_system).numbered(200_000, 200_000)[0]
    fields = ModeFields(mode, scene.scene.resting, Floats, scene.configuration.at_rest)
    exact = 0.75**0.5 * (2 / (3 * 1.2)) ** 0.5
    assert abs(abs(fields.at("a", 0.4)[0]) - exact) <= SHAPE * fields.size("a", 0)


@pytest.mark.sweep
@pytest.mark.parametrize(("kind", "ends", "rigid"), [
    ("beams", "left: clamped", 0), ("beams", "left: pinned", 1), ("bars", "left: clamped", 0)])
def test_places_at_which_nothing_is_attached_leave_the_closed_form(kind, ends, rigid, monkeypatch):
    """A beam or bar with a load on it moves in the modes that counting finds, beyond those that are searched."""
    stiff = "EI: 2 N*m^2" if kind == "beams" else "EA: 2 N"
    elements = problem(f"{kind}: {{a: {{length: 1.3 m, {stiff}, mass_per_length: 2 kg/m, {ends}}}}}\n"
                       "points: {p: {body: a, at: 0.4 m}, q: {body: a, at: 0.9 m}}\n"
                       "forces: {f: {at: p, force: 1 N*step(t)}, g: {at: q, force: 1 N*step(t)}}\n"
                       ).configuration.linear_system
    known = NaturalModes(elements)
    assert known.uniform.cuts == (0.4, 0.9) and known.uniform.resting == rigid
    monkeypatch.setattr(mode_source, "SEARCHED", 4)
    searched = NaturalModes(elements)
    searched.uniform = None
    for mode, other in zip(known.numbered(3, 12), searched.numbered(3, 12), strict=True):
        assert mode.omega == pytest.approx(other.omega, rel=1e-14)
        sign = np.sign(mode.shape @ other.shape) / np.linalg.norm(other.shape) * np.linalg.norm(mode.shape)
        assert mode.shape == pytest.approx(sign * other.shape, abs=1e-10 * np.abs(mode.shape).max())


def test_pieces_that_differ_are_no_uniform_member():
    scene = "segments: [{length: 1 m, EI: 2 N*m^2}, {length: 1 m, EI: 3 N*m^2}], mass_per_length: 2 kg/m, left: clamped"
    assert uniform_member(problem(f"beams: {{a: {{{scene}}}}}\n").configuration.linear_system) is None
