"""Natural frequencies of members: against known zeros to the last digits, and counted against finite elements."""

import math
import subprocess
import sys

import mpmath
import numpy as np
import pytest

from tests.support.random_members import at_rest, random_members, squares_by_finite_elements
from tests.support.scenes import problem
from vibcli.analyses.continuous import natural_frequencies
from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.continuous.rayleigh_steps import rayleigh_step
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece

EPS = 2.0 ** -52


def placed(piece, *rows):
    return PlacedPiece("member", 0.0, piece, rows, at_rest(piece, rows))


def beam(length=1.0, bending=1.0, inertia=1.0, tension=0.0, foundation=0.0):
    return Piece(length, bending, tension, 0.0, inertia, 0.0, foundation)


def bar(length=1.0, stiffness=1.0, inertia=1.0):
    return Piece(length, 0.0, stiffness, 0.0, inertia, 0.0, 0.0)


def cantilever(tip=0.0, **data):
    masses = [(tip, {0: 1.0})] if tip else []
    return FactoredSystem(2, masses, pieces=[placed(beam(**data), {}, {}, {0: 1.0}, {1: 1.0})])


def test_cantilever_with_half_its_mass_at_the_tip_to_two_roundings():
    exact = [mpmath.findroot(lambda x: 1 + mpmath.cos(x) * mpmath.cosh(x) + x / 2 * (
        mpmath.cos(x) * mpmath.sinh(x) - mpmath.sin(x) * mpmath.cosh(x)), start) for start in (1.42, 4.11, 7.19, 10.3)]
    assert [float(x) for x in exact[:3]] == pytest.approx([1.41996442976815, 4.11113338642443, 7.19033524196079],
                                                          abs=5e-15)
    modes = NaturalModes(cantilever(0.5)).numbered(1, 4)
    for mode, x in zip(modes, exact, strict=True):
        assert abs(math.sqrt(mode.omega) / x - 1) <= 2 * EPS
        assert abs(mode.omega / (x * x) - 1) <= mode.error < 1e-13


@pytest.mark.sweep
def test_floats_do_not_import_what_digits_need():
    program = ("import sys; from tests.support.random_members import random_members; "
               "from vibcli.analyses.continuous.mode_source import NaturalModes; "
               "NaturalModes(random_members(4)).numbered(1, 6); "
               "print({'mpmath', 'scipy', 'sympy'} & set(sys.modules))")
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"


def test_many_digits_agree_with_mpmath():
    with mpmath.workdps(60):
        exact = mpmath.findroot(lambda x: 1 + mpmath.cos(x) * mpmath.cosh(x), 4.69)
        mode = NaturalModes(cantilever(), digits=50).numbered(2, 2)[0]
        assert abs(mode.omega / exact**2 - 1) <= mode.error < 1e-50


def test_modes_that_rest_at_every_joint_are_found():
    rows = ({}, {0: 1.0}, {}, {1: 1.0}), ({}, {1: 1.0}, {}, {2: 1.0})
    modes = NaturalModes(FactoredSystem(3, pieces=[placed(beam(), *row) for row in rows])).numbered(1, 6)
    clamped = [mpmath.findroot(lambda x: mpmath.tan(x) - mpmath.tanh(x), (n + 0.25) * math.pi) for n in (1, 2, 3)]
    exact = sorted([n * math.pi for n in (1, 2, 3)] + clamped)
    assert [math.sqrt(mode.omega) for mode in modes] == pytest.approx([float(x) for x in exact], rel=4 * EPS)


def test_a_bar_without_a_coordinate_and_two_alike_that_do_not_touch():
    one = NaturalModes(FactoredSystem(0, pieces=[placed(bar(), {}, {})])).numbered(1, 5)
    assert [mode.omega for mode in one] == pytest.approx([n * math.pi for n in range(1, 6)], rel=2 * EPS)
    two = NaturalModes(FactoredSystem(2, pieces=[placed(bar(), {}, {i: 1.0}) for i in (0, 1)])).numbered(1, 4)
    exact = [math.pi / 2] * 2 + [3 * math.pi / 2] * 2
    assert [mode.omega for mode in two] == pytest.approx(exact, rel=2 * EPS)
    assert abs(np.array([mode.shape for mode in two[:2]])) == pytest.approx(2**0.5 * np.eye(2), abs=1e-15)


@pytest.mark.parametrize("digits", [None, 40])
def test_modes_that_coincide_are_each_one_of_a_part_that_nothing_ties_to_others(digits):
    """Three equal cantilevers, one of them in two halves, beside a spring without inertia."""
    pieces = [placed(beam(), {}, {}, {i: 1.0}, {i + 1: 1.0}) for i in (0, 2)]
    pieces += [placed(beam(0.5), {}, {}, {4: 1.0}, {5: 1.0}), placed(beam(0.5), {4: 1.0}, {5: 1.0}, {6: 1.0}, {7: 1.0})]
    modes = NaturalModes(FactoredSystem(9, springs=[(1.0, {8: 1.0})], pieces=pieces), digits=digits).numbered(1, 7)
    moved = [np.flatnonzero(abs(mode.shape.astype(float)) > 0).tolist() for mode in modes]
    assert moved == [[0, 1], [2, 3], [4, 5, 6, 7]] * 2 + [[0, 1]]
    assert [float(abs(mode.shape).max()) for mode in modes[1:3]] == pytest.approx([float(max(abs(modes[0].shape)))] * 2)


@pytest.mark.sweep
def test_high_modes_are_found_without_those_below():
    source = NaturalModes(random_members(21))
    modes = source.numbered(100_000, 100_003)
    assert [source.counted_above(mode) for mode in modes] == [100_000, 100_001, 100_002, 100_003]
    assert all(mode.error < 1e-12 for mode in modes)


@pytest.mark.sweep
def test_two_weakly_tied_cantilevers_are_told_apart():
    pieces = [placed(beam(), {}, {}, {2 * i: 1.0}, {2 * i + 1: 1.0}) for i in (0, 1)]
    modes = NaturalModes(FactoredSystem(4, [], [(1.5e-14, {0: 1.0, 2: -1.0})], pieces=pieces)).numbered(1, 4)
    for one, other in (modes[:2], modes[2:]):
        assert other.omega >= one.omega
        assert one.shape[0] * one.shape[2] > 0 > other.shape[0] * other.shape[2]
    gap = 2 * 1.5e-14 * 4 / (2 * modes[0].omega ** 2)
    assert modes[1].omega / modes[0].omega - 1 == pytest.approx(gap, abs=3e-16)


def test_a_free_beam_moves_rigidly_first():
    free = FactoredSystem(4, pieces=[placed(beam(), *({i: 1.0} for i in range(4)))])
    modes = NaturalModes(free).numbered(1, 4)
    assert [mode.rigid for mode in modes] == [True, True, False, False]
    assert modes[0].shape == pytest.approx([1, 0, 1, 0], abs=1e-12)
    assert modes[1].shape == pytest.approx(math.sqrt(12) * np.array([-0.5, 1, 0.5, 1]), rel=1e-9)
    assert math.sqrt(modes[2].omega) == pytest.approx(4.730040744862704, rel=1e-14)


def test_what_grows_is_followed_by_what_is_free():
    rows = [[{i: 1.0} for i in range(2, 6)], [{}, {0: 1.0}, {}, {1: 1.0}]]
    pieces = [placed(beam(), *rows[0]), placed(beam(tension=-15.0), *rows[1])]
    source = NaturalModes(FactoredSystem(6, pieces=pieces))
    assert [mode.kind for mode in source.numbered(1, 4)] == ["divergence", "rigid", "rigid", "oscillation"]
    assert source.counted_above(source.numbered(6, 6)[0]) == 6


def test_a_beam_beyond_its_buckling_load_grows():
    load = 1.5 * math.pi**2
    pinned = FactoredSystem(2, pieces=[placed(beam(tension=-load), {}, {0: 1.0}, {}, {1: 1.0})])
    modes = NaturalModes(pinned).numbered(1, 3)
    squares = [(n * math.pi) ** 4 - load * (n * math.pi) ** 2 for n in (1, 2, 3)]
    assert modes[0].growth_rate == pytest.approx(math.sqrt(-squares[0]), rel=1e-13)
    assert [mode.omega for mode in modes[1:]] == pytest.approx([math.sqrt(x) for x in squares[1:]], rel=1e-13)


@pytest.mark.sweep
def test_a_chain_of_sixty_spans_has_all_its_frequencies(monkeypatch):
    """Polished in one go: where they lie close together a Rayleigh quotient leaves its bracket, which signs of pivots
    narrow."""
    steps = []
    monkeypatch.setattr(natural_frequencies, "rayleigh_step",
                        lambda system, here, x: steps.append(len(here)) or rayleigh_step(system, here, x))
    spans = [placed(beam(), {}, {i: 1.0}, {}, {i + 1: 1.0}) for i in range(60)]
    modes = NaturalModes(FactoredSystem(61, pieces=spans)).numbered(1, 180)
    found = np.array([mode.omega for mode in modes])
    assert (np.diff(found) > 0).all()
    assert np.sqrt(found[[0, 60, 120]]) == pytest.approx([math.pi, 2 * math.pi, 3 * math.pi], rel=1e-14)
    assert all(mode.error < 1e-12 for mode in modes)
    assert set(steps) == {180}


def test_bars_tied_by_gyroscopic_terms_and_free_ones_that_are_refused():
    def coupled(*ends):
        pieces = [placed(bar(), end, {i: 1.0}) for i, end in enumerate(ends)]
        masses = [(1.0, {i: 1.0}) for i in (0, 1)]
        n = 2 + sum(map(len, ends))
        return FactoredSystem(n, masses, G={(0, 1): 0.7, (1, 0): -0.7}, pieces=pieces)

    exact = sorted(mpmath.findroot(lambda w, sign=sign: mpmath.cot(w) - w - 0.7 * sign, near)
                   for sign, near in ((1, 0.6), (-1, 1.1), (1, 3.4), (-1, 3.5), (1, 6.4)))
    found = [mode.omega for mode in NaturalModes(coupled({}, {})).numbered(1, 5)]
    assert found == pytest.approx([float(w) for w in exact], rel=1e-14)
    with mpmath.workdps(40):
        lowest = mpmath.findroot(lambda w: mpmath.cot(w) - w - mpmath.mpf(0.7), 0.6)
        assert abs(NaturalModes(coupled({}, {}), digits=25).numbered(1, 1)[0].omega / lowest - 1) < 1e-25
    with pytest.raises(PhysicsError, match="gyroscopic"):
        NaturalModes(coupled({2: 1.0}, {3: 1.0}))


@pytest.mark.sweep
def test_random_members_have_as_many_frequencies_as_their_finite_elements():
    for seed in range(12):
        system = random_members(seed)
        source = NaturalModes(system)
        modes = source.numbered(1, 6)
        assert modes[-1].rigid or source.counted_above(modes[-1]) == 6
        exact = squares_by_finite_elements(system, 6)
        found = [0.0 if mode.rigid else -mode.growth_rate**2 if mode.growth_rate else mode.omega**2 for mode in modes]
        assert found == pytest.approx(exact, rel=1e-2, abs=1e-7 * exact[-1])
        if seed < 4:
            require_near(modes, NaturalModes(system, digits=30).numbered(1, 6))


def require_near(modes, precise):
    """Rates within 1e-13 of those of many digits, and within what is said of them."""
    with mpmath.workdps(30):
        for one, other in zip(modes, precise, strict=True):
            if not one.rigid:
                value, exact = (mode.omega or mode.growth_rate for mode in (one, other))
                assert abs(value / exact - 1) <= min(1e-13, one.error)


def star(bars):
    """Bars alike, each clamped at one end and joined to the others at the other: all of (n + ½)π once, nπ repeated."""
    return FactoredSystem(1, [], pieces=[placed(bar(), {}, {0: 1.0}) for _ in range(bars)])


@pytest.mark.sweep
def test_a_frequency_found_in_more_digits_is_rounded_once():
    modes = NaturalModes(star(3)).numbered(40, 48)
    with mpmath.workdps(40):
        for mode in modes:
            exact = mpmath.pi * ((mode.index - 1) // 3 + (mpmath.mpf(0.5) if mode.index % 3 == 1 else 1))
            assert abs(mpmath.mpf(mode.omega) / exact - 1) <= mode.error < 1e-14


@pytest.mark.sweep
def test_some_of_many_repeated_frequencies():
    modes = NaturalModes(star(6)).numbered(3, 5)
    assert all(abs(mode.omega / math.pi - 1) <= mode.error < 1e-14 for mode in modes)


@pytest.mark.sweep
def test_a_frequency_that_eight_members_share_takes_no_more_digits_than_one_of_two():
    modes = NaturalModes(star(8))
    found = modes.numbered(1, 9)
    assert all(abs(mode.omega / math.pi - 1) <= mode.error < 1e-14 for mode in found[1:8])
    assert set(modes._known) <= {None, 40}


@pytest.mark.parametrize("tip", [0.5, 1e4])
def test_a_bar_with_an_end_mass_has_ten_thousand_modes(tip):
    modes = NaturalModes(FactoredSystem(1, [(tip, {0: 1.0})], pieces=[placed(bar(), {}, {0: 1.0})]))
    for mode in (*modes.numbered(300, 301), *modes.numbered(9999, 10000)):
        with mpmath.workdps(40):
            exact = mpmath.findroot(lambda x: mpmath.cos(x) - tip * x * mpmath.sin(x), mpmath.mpf(mode.omega))
            assert abs(mpmath.mpf(mode.omega) / exact - 1) <= mode.error < 1e-15
        assert round(mode.omega / math.pi) == mode.index - 1


def test_two_thousand_modes_at_a_time_of_a_beam_that_is_clamped_and_heavy_at_its_tip():
    """cos b cosh b + 1 = ½ b (sin b cosh b − cos b sinh b), at some of them, in floats alone; the k-th lies behind
    (k − 1)π."""
    modes = NaturalModes(FactoredSystem(2, [(0.5, {0: 1.0})], pieces=[placed(beam(), {}, {}, {0: 1.0}, {1: 1.0})]))
    found = modes.numbered(2049, 4000)
    assert set(modes._known) == {None}
    for mode in found[::150]:
        with mpmath.workdps(40):
            def off(b):
                return mpmath.cos(b) + mpmath.sech(b) - b / 2 * (mpmath.sin(b) - mpmath.cos(b) * mpmath.tanh(b))
            b = mpmath.findroot(off, mpmath.sqrt(mode.omega))
            assert abs(mpmath.mpf(mode.omega) / b**2 - 1) <= mode.error < 1e-14
        assert int(b / mpmath.pi) == mode.index - 1
    omega = np.array([mode.omega for mode in found])
    assert np.abs(np.diff(np.sqrt(omega)) / np.pi - 1).max() < 1e-3


@pytest.mark.sweep
@pytest.mark.parametrize("length", ["L", "1.3*L"])
def test_what_moves_freely_beside_what_its_weight_bends_is_left_where_it_is(length):
    """A free beam beside a cantilever that bends under a pendulum: the frequencies of each alone."""
    scene = """
        parameters: {L: 1 m, EI: 80 N*m^2, mu: 0.9 kg/m, m: 0.3 kg, l: 0.4 m}
        gravity: 9.81 m/s^2
        bodies: {c: {mass: m, at: [L, 0], move: [x, y, psi], inertia: 0.01 kg*m^2},
                 bob: {mass: m, at: [L, -l], pin: {at: [L, 0], carrier: c, by: phi}}}
        beams: {a: {from: [0, 0], to: [L, 0], left: clamped, right: {clamped: c}, EI: EI, mass_per_length: mu}FREE}
    """
    free = ", f: {length: LENGTH, EI: EI, mass_per_length: mu}".replace("LENGTH", length)
    both = [mode.omega for mode in problem(scene.replace("FREE", free)).modal.modes.first(8)]
    alone = [mode.omega for mode in problem(scene.replace("FREE", "")).modal.modes.first(6)]
    size = 1.3 if length != "L" else 1.0
    bent = [(x / size) ** 2 * (80 / 0.9) ** 0.5 for x in (4.730040744862704, 7.853204624095838)]
    assert both == pytest.approx(sorted([0, 0, *alone, *bent])[:8], rel=1e-11)


@pytest.mark.filterwarnings("error")
def test_a_beam_of_next_to_no_length_is_refused():
    """Floats hold its frequencies, but not the unit of kinetic energy of its shapes."""
    one = problem("beams: {b: {length: 3e-40 m, EI: 1.75e9 N*m^2, mass_per_length: 1200 kg/m, left: pinned, "
                  "right: pinned}}\npoints: {middle: {body: b, at: 1.5e-40 m}}\n"
                  "forces: {F: {at: middle, force: 1 N}}\n")
    with pytest.raises(PhysicsError, match="so far apart"):
        one.modal.modes.first(2)


@pytest.mark.parametrize("length", [1e-40, 1e-60])
def test_a_beam_whose_shapes_are_no_numbers_is_refused(length):
    one = problem(f"beams: {{arm: {{length: {length} m, EI: 1e60 N*m^2, mass_per_length: 1e60 kg/m, preload: 5 N, "
                  "left: clamped}}\n")
    with pytest.raises(PhysicsError, match="so far apart"):
        one.modal.modes.first(2)



def test_what_has_no_inertia_beside_a_member_is_a_mechanism():
    """A bob that is pinned at its own place."""
    one = problem("parameters: {g: 9.81 m/s^2}\ngravity: g\n"
                  "beams: {arm: {from: [0 m, 0 m], to: [1.2 m, 0 m], EI: 2400 N*m^2, mass_per_length: 3 kg/m, "
                  "left: clamped, right: {clamped: motor}}}\nbodies:\n"
                  "  motor: {mass: 5 kg, at: [1.2 m, 0 m], move: [0, y, psi]}\n"
                  "  bob: {mass: 1 kg, at: [1.2 m, -0.3 m], pin: {carrier: motor, by: phi}}\n")
    with pytest.raises(PhysicsError, match="'phi' has no inertia and no spring ties it"):
        one.modal.modes.first(1)
