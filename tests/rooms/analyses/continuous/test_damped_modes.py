"""Complex frequencies of members: closed forms, roots by mpmath, perturbation, finite elements; none missed."""

import cmath
import math
import random

import mpmath
import numpy as np
import pytest

from tests.support.random_members import at_rest, random_members
from tests.support.scenes import problem
from vibcli.analyses.continuous import damped_roots
from vibcli.analyses.continuous.argument_count import zeros_within
from vibcli.analyses.continuous.damped_source import DampedModes
from vibcli.analyses.continuous.dynamic_matrix import dynamic_matrix
from vibcli.analyses.continuous.finite_elements import element_matrices, rows_as_array
from vibcli.analyses.continuous.matched_damper import dies_after, left_over
from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.continuous.trial_eigenvalues import trial_eigenvalues
from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece


def member(piece, *rows):
    return PlacedPiece("member", 0.0, piece, rows, at_rest(piece, rows))


def bar(r, left=None):
    """A bar of EA = μ = L = 1 with a damper r at its right end."""
    rows = ({} if left is None else left, {0: 1.0})
    return FactoredSystem(max(1, len(rows[0]) + 1), dampers=[(r, {0: 1.0})],
                          pieces=[member(Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0), *rows)])


def source(system):
    natural = NaturalModes(system)
    return DampedModes(system, lambda: Modes((), natural))


def exact(r, count):
    real = -math.log((1 + r) / abs(1 - r)) / 2
    shift = 0.5 if r < 1 else 0.0
    found = [complex(real, (n + shift) * math.pi) for n in range(count + 1)]
    return sorted(found, key=abs)[:count]


@pytest.mark.parametrize("r", [1e-3, 0.3, 0.5, 0.9, 0.99, 0.9999, 1.0001, 1.01, 1.5, 4.0, 100.0])
def test_a_bar_with_an_end_damper(r):
    found = source(bar(r)).numbered(1, 12)
    near = max(1e-13, 2e-15 / abs(1 - r))       # as r is given
    for mode, value in zip(found, exact(r, 12), strict=True):
        assert abs(mode.eigenvalue - value) <= near * abs(value)
        assert abs(mode.eigenvalue - value) <= 2 * mode.error * abs(value)


@pytest.mark.sweep
@pytest.mark.parametrize("r", [0.2, 0.999, 1.001, 30.0])
def test_zeros_within_a_circle(r):
    matrix = dynamic_matrix(bar(r))
    for radius in (1.1, 5.3, 30.0, 61.7):
        known = [value for value in exact(r, 60) if abs(value) < radius]
        assert zeros_within(matrix, radius) == sum(2 if value.imag else 1 for value in known)


@pytest.mark.parametrize("count", [1000, 16_384, 60_000])
def test_zeros_are_counted_between_high_modes(count):
    """A damped cantilever has βL near (n − ½)π: within (nπ)² are n pairs, where poles of D are as dense."""
    beam = member(Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0), {}, {}, {0: 1.0}, {1: 1.0})
    matrix = dynamic_matrix(FactoredSystem(2, dampers=[(0.5, {0: 1.0})], pieces=[beam]))
    assert zeros_within(matrix, (count * math.pi) ** 2) == 2 * count


def test_a_matched_damper_lets_nothing_come_back():
    assert dies_after(bar(1.0)) == 2.0
    assert dies_after(bar(1.0 + 1e-12)) is None and dies_after(bar(0.5)) is None
    assert zeros_within(dynamic_matrix(bar(1.0)), 2.0) == 0


@pytest.mark.parametrize("divided", ["", "points: {p: {body: b, at: 0.5 m}}\nforces: {F: {at: p, force: 1 N}}\n"])
def test_a_damper_that_answers_without_bound_leaves_no_mode(divided):
    scene = problem("bars: {b: {length: 2 m, EA: 400 N, mass_per_length: 4 kg/m, left: clamped, "
                    "right: {c: -40 N*s/m}}}\n" + divided)
    with pytest.raises(PhysicsError, match="answers a wave that arrives without bound"):
        scene.modal.damped.first(1)


@pytest.mark.parametrize("r", [1 - 1e-5, 1 + 1e-6, 1 - 1e-9, 1 + 1e-12, 1 - 1e-12])
def test_a_damper_that_is_nearly_matched(r):
    """To rounding of the numbers as given; the bound holds for these rounded too."""
    with mpmath.workdps(40):
        exactly = mpmath.mpf(r)
        real = -mpmath.log((1 + exactly) / abs(1 - exactly)) / 2
    found = source(bar(r)).numbered(1, 8)
    shift = 0.5 if r < 1 else 0.0
    for n, mode in enumerate(found):
        value = mpmath.mpc(real, (n + shift) * mpmath.pi)
        assert abs(mode.eigenvalue - value) <= 1e-15 * abs(value)
        assert 1e-16 / abs(1 - r) / abs(value) <= mode.error <= 4e-16 / abs(1 - r) / abs(value) + 1e-14


@pytest.mark.sweep
def test_a_damper_inside_matched_to_both_sides():
    """2 = e^{-2as} + e^{-2(1-a)s}: at a = 1/2 s = 2πin; at 0.3 the roots of z³ + z⁷ = 2, z = e^{−0.2s}."""
    def inside(a):
        return FactoredSystem(1, dampers=[(2.0, {0: 1.0})], pieces=[
            member(Piece(a, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0), {}, {0: 1.0}),
            member(Piece(1 - a, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0), {0: 1.0}, {})])
    for n, mode in enumerate(source(inside(0.5)).numbered(1, 8), 1):
        assert mode.eigenvalue.real == 0 and mode.eigenvalue.imag == pytest.approx(2 * math.pi * n, rel=1e-14)
    roots = [-cmath.log(z) for z in np.roots([1, 0, 0, 0, 1, 0, 0, -2])]
    values = sorted((5 * (one + 2j * math.pi * k) for one in roots for k in range(3)), key=abs)
    values = [value for value in values if value.imag > 1e-9]
    for value, mode in zip(values, source(inside(0.3)).numbered(1, 12), strict=False):
        assert mode.eigenvalue == pytest.approx(value, rel=1e-12)
    with pytest.raises(PhysicsError, match="not certain"):
        source(inside(0.5)).numbered(990, 995)


@pytest.mark.sweep
def test_a_free_bar_before_a_matched_damper_rests():
    system = bar(1.0, {1: 1.0})
    assert dies_after(system) == 2.0 and [mode.omega for mode in left_over(system)] == [0.0]
    assert [zeros_within(dynamic_matrix(system), radius) for radius in (0.5, 3.0, 100.0)] == [1, 1, 1]
    assert zeros_within(dynamic_matrix(system), 600.0) is None        # beyond what floats hold
    assert dies_after(bar(1.1, {1: 1.0})) is None
    scene = problem("bars: {rod: {length: 1 m, EA: 1 N, mass_per_length: 1 kg/m, right: {c: 1 N*s/m}}}")
    assert [mode.omega for mode in scene.modal.damped] == [0.0]


def test_a_free_bar_rests_once():
    found = source(bar(0.5, {1: 1.0})).numbered(1, 4)
    real = -math.log(1.5 / 0.5) / 2        # D ~ tanh s + r: λ = −artanh r + i n π
    assert found[0].omega == 0
    for mode, n in zip(found[1:], range(3), strict=True):
        assert mode.eigenvalue == pytest.approx(complex(real, n * math.pi), rel=1e-13)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(0, 60, 7))
def test_random_members_agree_with_finite_elements(seed):
    draw, system = random.Random(seed), random_members(seed)
    if not system.n:
        return
    dampers = [(10 ** draw.uniform(-2, 1), {draw.randrange(system.n): 1.0}) for _ in range(2)]
    pieces = [one._replace(piece=one.piece._replace(drag=draw.choice((0.0, 0.3, 3.0)))) for one in system.pieces]
    system = system.with_parts(dampers=dampers, pieces=pieces)
    found = source(system)
    modes = found.numbered(1, 6)
    reach = abs(modes[-1].eigenvalue) * (1 - 1e-6)
    other = [value for value in by_finite_elements(system) if value.imag >= 0 and 1e-4 * reach < abs(value) < reach]
    mine = [mode.eigenvalue for mode in modes[:-1] if mode.eigenvalue]
    for value in mine:
        assert min(abs(value - one) for one in other) <= 3e-2 * abs(value)
    assert abs(len(other) - len(mine)) <= 1        # where the last lies next to the circle


def by_finite_elements(system, parts=24):
    n, done = system.n, []
    for placed in system.pieces:
        half, left = placed.piece.order // 2, placed.rows[:placed.piece.order // 2]
        for i in range(parts):
            right = placed.rows[half:]
            if i < parts - 1:
                right = tuple({n + way: 1.0} for way in range(half))
                n += half
            size = placed.piece.length / parts
            done.append((placed.piece._replace(length=size), (*left, *right)))
            left = right
    M, C, _, K = (np.pad(part, (0, n - system.n)) for part in system.with_parts(pieces=()).arrays())
    for piece, rows in done:
        S, (k, m) = rows_as_array(rows, n), element_matrices(piece)
        K, M, C = K + S.T @ k @ S, M + S.T @ m @ S, C + S.T @ m @ S * piece.drag / piece.inertia
    inverse = np.linalg.inv(M)
    return np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ K, -inverse @ C]]))


def test_a_cantilever_with_mass_and_damper_by_mpmath():
    """EI = μ = L = 1: F = (2 + 2 cos b cosh b)/… with s² = −b⁴, the tip force (m s² + c s) u."""
    m, c = 0.7, 0.9
    system = FactoredSystem(2, [(m, {0: 1.0})], dampers=[(c, {0: 1.0})], pieces=[
        member(Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0), {}, {}, {0: 1.0}, {1: 1.0})])
    modes = source(system).numbered(1, 5)

    def equation(s):
        b = mpmath.sqrt(mpmath.sqrt(-s * s))
        cos, sin, cosh, sinh = mpmath.cos(b), mpmath.sin(b), mpmath.cosh(b), mpmath.sinh(b)
        return b**3 * (1 + cos * cosh) + (m * s * s + c * s) * (sin * cosh - cos * sinh) * 1

    with mpmath.workdps(30):
        for mode in modes:
            value = mpmath.findroot(equation, mpmath.mpc(mode.eigenvalue))
            assert abs(value - mode.eigenvalue) <= 1e-13 * abs(value)


@pytest.mark.sweep
def test_light_damping_is_that_of_perturbation():
    """λ = iω − xᵀCx/2, xᵀ ∂D/∂s² x = 1."""
    c = 1e-6
    plain = random_members(8)
    row = {0: 1.0}
    undamped = NaturalModes(plain).numbered(1, 5)
    damped = source(plain.with_parts(dampers=[(c, row)])).numbered(1, 5)
    for one, other in zip(undamped, damped, strict=True):
        assert other.eigenvalue == pytest.approx(complex(-c * one.shape[0] ** 2 / 2, one.omega), abs=1e-10 * one.omega)


@pytest.mark.sweep
def test_a_damper_that_drives_makes_modes_grow_without_end_and_some_are_shown():
    """Of a cantilever with −c at its end: EI β³ (1 + cos βL cosh βL) = c s (sin βL cosh βL − cos βL sinh βL)."""
    scene = problem("beams: {a: {length: 1 m, EI: 900 N*m^2, mass_per_length: 2 kg/m, left: clamped, attached: "
                    "[{at: 1 m, c: -3 N*s/m}]}}")
    shown = scene.modal.damped.shown()
    assert len(shown) == 25 and all(mode.growth_rate for mode in shown)

    def equation(s):
        b = mpmath.sqrt(mpmath.sqrt(-2 * s ** 2 / 900))
        return 900 * b ** 3 * (1 + mpmath.cos(b) * mpmath.cosh(b)) - 3 * s * (
            mpmath.sin(b) * mpmath.cosh(b) - mpmath.cos(b) * mpmath.sinh(b))

    for mode in (shown[0], shown[4]):
        root = mpmath.findroot(equation, mode.eigenvalue, verify=False)
        assert complex(root) == pytest.approx(mode.eigenvalue, rel=1e-12)
        assert root.real > 2.99
    assert scene.modal.stability.kind == "unstable"


@pytest.mark.sweep
def test_equal_members_side_by_side_have_each_root_twice():
    piece = Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0)
    system = FactoredSystem(2, dampers=[(0.4, {0: 1.0}), (0.4, {1: 1.0})],
                            pieces=[member(piece, {}, {0: 1.0}), member(piece, {}, {1: 1.0})])
    found = source(system).numbered(1, 6)
    for i in range(0, 6, 2):
        value = exact(0.4, 3)[i // 2]
        assert cmath.isclose(found[i].eigenvalue, value, rel_tol=1e-13)
        assert cmath.isclose(found[i + 1].eigenvalue, value, rel_tol=1e-13)
        assert abs(np.linalg.det(np.array([found[i].shape, found[i + 1].shape]))) > 0.1


def test_a_piece_held_at_both_ends_swings_by_itself():
    system = FactoredSystem(0, pieces=[member(Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.2, 0.0), {}, {})])
    found = source(system).numbered(1, 3)
    for n, mode in enumerate(found, 1):
        assert mode.eigenvalue == pytest.approx(complex(-0.1, math.sqrt((n * math.pi) ** 2 - 0.01)), rel=1e-13)


@pytest.mark.sweep
def test_damping_below_rounding_is_not_lost_and_what_rests_is_not_damped():
    piece = Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0)
    halves = FactoredSystem(1, dampers=[(1e-18, {0: 1.0})], pieces=[member(piece, {}, {0: 1.0}),
                                                                   member(piece, {0: 1.0}, {})])
    found = source(halves).numbered(1, 4)       # λ = iω − c/(4 · L/2) where the middle moves, L = 2
    assert [mode.decay for mode in found] == pytest.approx([5e-19, 0.0, 5e-19, 0.0], rel=1e-9, abs=0.0)


def test_drag_below_rounding_is_not_lost():
    """Drag that is the same everywhere gives all modes the decay c/(2μ)."""
    beam = Piece(1.3, 2.0, 0.0, 0.0, 0.7, 1e-18, 0.0)
    found = source(FactoredSystem(2, pieces=[member(beam, {}, {}, {0: 1.0}, {1: 1.0})])).numbered(1, 4)
    assert [mode.decay for mode in found] == pytest.approx([1e-18 / 1.4] * 4, rel=1e-6, abs=0.0)


def test_gyroscopic_terms_and_a_damper_beside_a_bar():
    """(EA β cot βL + k + c s + s²)(k + s²) + (mΩs)² = 0, s = iβ√(EA/μ), by mpmath."""
    damped = problem("""
    parameters: {m: 2 kg, Om: 2 rad/s, k: 100 N/m}
    coordinates: {x: m, y: m}
    bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
    energies: {T: "m*Om*(x*y' - y*x')/2"}
    springs: {s: {k: k, between: [a, ground]}, t: {k: k, between: [b, ground]}}
    dampers: {d: {c: 0.5 N*s/m, between: [a, ground]}}
    bars: {r: {length: 1 m, EA: 10 N, mass_per_length: 1 kg/m, left: clamped, right: {clamped: a}}}
""").modal.damped.first(3)
    assert [mode.eigenvalue for mode in damped] == pytest.approx([
        -0.0820408410146647 + 7.47298755764236j, -2.93316539434232e-5 + 9.97095433360192j,
        -0.124744261031225 + 12.9664673858409j], rel=1e-13)


@pytest.mark.sweep
def test_loads_that_turn_velocities_couple_and_damp_nothing():
    """A disc at the end of a stretching cantilever under (−b ẏ, b ẋ): det [D(iω) + iω b J] = 0 of its x and y."""
    scene = problem("""
        parameters: {L: 1 m, EI: 80 N*m^2, mu: 0.9 kg/m, m: 0.3 kg, b: 20 kg/s}
        bodies: {d: {mass: m, at: [L, 0], move: [x, y, psi], inertia: 0.01 kg*m^2}}
        beams: {a: {from: [0, 0], to: [L, 0], left: clamped, right: {clamped: d}, EA: 1 MN, EI: EI,
                    mass_per_length: mu}}
        forces: {gx: {coordinate: x, value: "-b*y'"}, gy: {coordinate: y, value: "b*x'"}}
    """)
    found = scene.modal.damped.shown()
    assert all(mode.eigenvalue.real == 0 for mode in found)

    def determinant(w):
        k, b = w * mpmath.sqrt(0.9e-6), mpmath.sqrt(w) * mpmath.mpf("0.9") ** 0.25 / mpmath.mpf(80) ** 0.25
        c, s, ch, sh = mpmath.cos(b), mpmath.sin(b), mpmath.cosh(b), mpmath.sinh(b)
        d = 80 / (1 - c * ch)
        kyy, kyp, kpp = d * b**3 * (s * ch + c * sh), -d * b**2 * s * sh, d * b * (s * ch - c * sh)
        bent = kyy - 0.3 * w**2 - kyp**2 / (kpp - 0.01 * w**2)
        return (1e6 * k / mpmath.tan(k) - 0.3 * w**2) * bent - (20 * w) ** 2

    for mode in found[:5]:
        assert float(mpmath.findroot(determinant, mode.omega_d)) == pytest.approx(mode.omega_d, rel=1e-11)


@pytest.mark.sweep
def test_rounding_in_a_mode_all_of_whose_nodes_rest_is_no_damping():
    found = problem("""
        beams: {w: {length: 1 m, EI: 100 N*m^2, mass_per_length: 1 kg/m, left: clamped, attached: [
          {at: 1 m, k: 40 N/m}, {at: 0.5 m, c: 3 N*s/m}, {at: 0.9 m, torsion: 4 N*m/rad}]}}
        bars: {b: {length: 1 m, EA: 100 N, mass_per_length: 1 kg/m, left: clamped, right: clamped, attached: [
          {at: 0.5 m, k: 50 N/m}]}}
        """).modal.damped
    assert [mode.zeta == 0 for mode in found.first(3)] == [True, False, True]


def test_a_chain_beside_a_damped_string_is_not_looked_for_from_afar():
    """ω = ½ jₙ √(g/L), jₙ the zeros of Bessel's J₀: estimates that are spectral need few functions."""
    chain = Piece(1.2, 0.0, 4.8, -4.0, 0.4, 0.0, 0.0)
    string = Piece(1.2, 0.0, 300.0, 0.0, 0.4, 0.3, 0.0)
    system = FactoredSystem(0, pieces=[member(chain, {}, {}), member(string, {}, {})])
    found = trial_eigenvalues(dynamic_matrix(system), [12, 4], 20.0)
    expected = [0.5 * float(mpmath.besseljzero(0, n)) * (10 / 1.2)**0.5 for n in (1, 2, 3)]
    assert sorted(found.imag)[:3] == pytest.approx(expected, rel=1e-9)


def test_where_a_rate_has_no_inverse_no_root_is_told(monkeypatch):
    """As near a damper that drives a bar as strongly as its waves can bear."""
    nothing = np.zeros((2, 2), complex)
    monkeypatch.setattr(damped_roots, "_scaled", lambda found, s: (nothing, nothing, np.ones(2)))
    monkeypatch.setattr(damped_roots.Whole, "at", lambda self, s: None)
    assert damped_roots.roots_at(damped_roots.Whole(None), 1j) == []


CRITICAL = """
bars: {rod: {length: 1 m, EA: 1 N, mass_per_length: 1 kg/m, left: clamped, right: {pinned: b}}}
bodies: {b: {mass: 0.5 kg, slide: x}, d: {mass: 0.2 kg, slide: y}}
springs: {p: {between: [ground, b], k: 0.3 N/m}, q: {between: [ground, d], k: 0.4 N/m}}
dampers: {e: {between: [b, d], c: %r N*s/m}}
"""


@pytest.mark.parametrize("aside", [0.0, 1e-14, 1e-12])
def test_where_damping_is_critical_two_modes_with_one_shape_are_told(aside):
    """As far as they are not told apart twice their middle, with a bound that holds both."""
    def whole(s, c):
        coth, M, m = s * mpmath.coth(s), mpmath.mpf("0.5"), mpmath.mpf("0.2")
        return (coth + M * s**2 + c * s + mpmath.mpf("0.3")) * (m * s**2 + c * s + mpmath.mpf("0.4")) - (c * s)**2

    with mpmath.workdps(40):
        s, c = mpmath.findroot(lambda s, c: (whole(s, c), mpmath.diff(lambda z: whole(z, c), s)), (-1.4, 0.44))
        c = float(c) * (1 + aside)
        away = mpmath.sqrt(-2 * whole(s, c) / mpmath.diff(lambda z: whole(z, c), s, 2))
        roots = [mpmath.findroot(lambda z: whole(z, mpmath.mpf(c)), s + way * away, tol=1e-50) for way in (1, -1)]
        found = [mode for mode in problem(CRITICAL % c).modal.damped.first(4) if 1.39 < mode.omega < 1.4]
        assert len(found) == 2
        for root, mode in zip(sorted(roots, key=abs), found, strict=True):
            assert abs(root - complex(mode.eigenvalue)) <= mode.error * abs(root) <= 1.1e-6 * abs(root)
            assert mode.error < 1e-8 or aside < 1e-12
