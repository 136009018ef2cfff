"""The phase plane of one degree of freedom, against closed forms of orbits, separatrices and eigenvalues."""

import cmath
import math

import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.nonlinear.integrated_orbits import followed
from vibcli.base.errors import PhysicsError

PENDULUM = """
parameters: {{m: 0.7 kg, L: 0.4 m, g: 9.81 m/s^2}}
gravity: g
bodies: {{P: {{mass: m, at: [0, -L], pin: {{at: [0, 0], by: phi}}}}}}
{more}
"""
SPRING = """
bodies: {{B: {{mass: 2 kg, slide: x}}}}
springs: {{s: {{law: "{law}", between: [ground, B]}}}}
{more}
"""
K, CUBIC, SQUARE = "(50 N/m)", "(400 N/m^3)", "(20 N/m^2)"
OMEGA = math.sqrt(9.81 / 0.4)


def damper(c):
    return f"dampers: {{d: {{c: {c} N*s/m, between: [ground, B]}}}}\n"


def pendulum(c=None, more=""):
    drag = f"energies: {{Phi: ({c} N*m*s)*phi'^2/2}}\n" if c else ""
    return problem(PENDULUM.format(more=drag + more)).phase_plane


def spring(law, more=""):
    law = law.replace("b*", CUBIC + "*").replace("k*", K + "*").replace("a*", SQUARE + "*")
    return problem(SPRING.format(law=law, more=more)).phase_plane


def lines(plane, *roles):
    return [one for one in plane.portrait.branches if one.role in roles]


def kinds(plane):
    return [one.kind for one in plane.equilibria.items]


def test_separatrix_of_a_pendulum():
    plane = pendulum(more="initial: {phi: 2}")
    between, = (one for one in lines(plane, "separatrix") if np.abs(one.q).max() < 3.2)
    assert (between.q.min(), between.q.max()) == pytest.approx((-math.pi, math.pi), rel=1e-15)
    moving = between.v != 0
    exact = np.sign(between.v) * 2 * OMEGA * np.cos(between.q / 2)
    assert (~moving).sum() == 3 and moving.sum() > 200
    assert np.abs(between.v[moving] / exact[moving] - 1).max() < 1e-12


def test_equilibria_of_a_pendulum_stand_a_turn_apart():
    plane = pendulum()
    assert kinds(plane) == ["saddle", "centre", "saddle"]
    assert [one.q for one in plane.equilibria.items] == pytest.approx([-math.pi, 0, math.pi], abs=1e-14)
    assert plane.portrait.energies == pytest.approx([2 * 0.7 * 9.81 * 0.4, 0, 2 * 0.7 * 9.81 * 0.4], rel=1e-14)
    assert plane.equilibria.items[1].eigenvalues == pytest.approx((-1j * OMEGA, 1j * OMEGA), rel=1e-14)
    low, high = plane.frame.q
    assert low < -math.pi and math.pi < high < 2 * math.pi


def test_what_is_shown_is_the_turn_in_which_the_motion_starts():
    low, high = pendulum(more="initial: {phi: 14, phi': 1 rad/s}").frame.q
    assert low < 3 * math.pi < 14 < 5 * math.pi < high < 6 * math.pi


@pytest.mark.sweep
def test_orbits_of_a_double_well_keep_their_energy_and_close():
    plane = spring("-k*d + b*d^3", more="initial: {x: 0.4 m}")
    m, k, b = 2, 50, 400
    assert kinds(plane) == ["centre", "saddle", "centre"]

    def H(q, v):
        return m * v**2 / 2 - k * q**2 / 2 + b * q**4 / 4

    for one in plane.portrait.branches:
        closed = one.q[0] == one.q[-1] and one.v[0] == one.v[-1]
        assert closed or one.role == "orbit"
        energies = H(one.q, one.v)
        assert np.ptp(energies) < 2e-13 * (k * k / (4 * b))
        if one.role == "separatrix":
            assert np.abs(energies).max() < 2e-15 and not one.q.all()
    assert {len(lines(plane, role)) for role in ("separatrix", "own")} == {2, 1}
    assert plane.own.energy == pytest.approx(H(0.4, 0) + k * k / (4 * b), rel=1e-14)


def test_no_two_orbits_cross():
    plane = spring("k*d - b*d^3", more="initial: {x: 0.2 m}")
    levels = sorted(float(np.median(one.v**2 + 25 * one.q**2 - 100 * one.q**4)) for one in plane.portrait.branches)
    for one in plane.portrait.branches:
        mine = one.v**2 + 25 * one.q**2 - 100 * one.q**4
        assert np.ptp(mine) < 1e-12
    gaps = np.diff(sorted({round(level, 9) for level in levels}))
    assert gaps.min() > 1e-3


@pytest.mark.parametrize(("law", "c", "kind"), [
    ("k*d", "3", "stable focus"), ("k*d", "30", "stable node"), ("k*d", "20", "stable degenerate node"),
    ("k*d", "-3", "unstable focus"), ("k*d", "-30", "unstable node"), ("-k*d", "5", "saddle"), ("k*d", "0", "centre")])
def test_kinds_by_eigenvalues(law, c, kind):
    plane = spring(law, damper(c) * (c != "0") + "initial: {x: 0.1 m}")
    one, = plane.equilibria.items
    c, k = float(c), 50 if law == "k*d" else -50
    root = cmath.sqrt(c * c - 8 * k)
    exact = sorted(((-c - root) / 4, (-c + root) / 4), key=lambda x: (x.real, x.imag))
    assert one.kind == kind
    assert one.eigenvalues == pytest.approx(exact, rel=1e-14)


@pytest.mark.parametrize(("law", "more", "kind"), [
    ("b*d^3", "", "centre"), ("-b*d^3", "", "saddle"), ("a*d^2", "", "cusp"), ("b*d^3", damper(3), "stable node"),
    ("-b*d^3", damper(3), "saddle"), ("a*d^2", damper(3), "saddle-node"),
    ("k*d", "dampers: {d: {law: \"(3 N*s^3/m^3)*v^3\", between: [ground, B]}}\n", "stable focus"),
    ("k*abs(d)", "", "cusp"), ("k*d + 0.5*k*abs(d)", damper(3), "stable focus"),
    ("k*d + 0.5*k*abs(d)", damper(30), "stable node"), ("-k*d - 0.5*k*abs(d)", "", "saddle")])
def test_kinds_that_linear_terms_leave_open(law, more, kind):
    plane = spring(law, more + "initial: {x: 0.1 m}")
    assert kinds(plane) == [kind]
    assert plane.equilibria.items[0].degenerate


@pytest.mark.sweep
def test_play_is_a_line_of_rest():
    plane = problem("bodies: {B: {mass: 2 kg, slide: x}}\n"
                    "springs: {s: {k: 50 N/m, gap: 3 mm, between: [ground, B]}}\ninitial: {x': 0.1 m/s}").phase_plane
    one, = plane.equilibria.items
    assert one.kind == "line of rest"
    assert one.span == pytest.approx((-0.003, 0.003), rel=1e-14)
    assert plane.own.turns == pytest.approx((-0.023, 0.023), rel=1e-14)
    assert plane.own.period[0] == pytest.approx(2 * math.pi / 5 + 4 * 0.003 / 0.1, rel=1e-13)


@pytest.mark.sweep
def test_orbits_of_a_damped_mass_are_those_of_two_exponentials():
    plane = spring("k*d", damper(30) + "initial: {x: 0.1 m, x': 2 m/s}")
    slow, fast = (-15 + math.sqrt(125)) / 2, (-15 - math.sqrt(125)) / 2

    def kept(q, v):     # (v − λ₂ x) decays with λ₁, (v − λ₁ x) with λ₂
        return np.log(np.abs(v - fast * q)) * fast - np.log(np.abs(v - slow * q)) * slow

    own, = lines(plane, "own")
    apart = np.abs(own.v - slow * own.q) > 0.05
    assert np.ptp(kept(own.q, own.v)[apart]) < 1e-6 and apart.sum() > 20


@pytest.mark.sweep
def test_manifolds_of_a_linear_saddle_are_straight():
    plane = spring("-k*d", damper(5) + "initial: {x: 0.1 m}")
    low, high = sorted(value.real for value in plane.equilibria.items[0].eigenvalues)
    for role, value in (("into", low), ("out of", high)):
        found = lines(plane, role)
        assert len(found) == 2
        for one in found:
            assert np.abs(one.v - value * one.q).max() < 1e-8 * np.abs(one.v).max()
            assert plane.frame.beyond(np.stack((one.q, one.v)), 0.0).any()
    assert abs(lines(plane, "into")[0].q[-1]) < 1e-6 < abs(lines(plane, "into")[0].q[0])


@pytest.mark.sweep
def test_separatrices_of_a_damped_pendulum_part_what_ends_in_different_places():
    plane = pendulum(c="0.15")
    assert kinds(plane) == ["saddle", "stable focus", "saddle"]
    high = max(lines(plane, "into"), key=lambda one: float(np.interp(0.0, one.q, one.v)) if one.v[-2] > 0 else -1)
    edge = float(np.interp(0.0, high.q, high.v))
    starts = np.array([[0.0, 0.0], [0.999 * edge, 1.001 * edge]])
    short, beyond = followed(plane.field, starts, np.ones(2), plane.frame, [(0.0, 0.0)], np.full(2, 40.0))
    assert short[0].max() < math.pi and np.abs(short[:, -1] / plane.frame.size[:, 0]).max() < 0.02
    assert beyond[0].max() > plane.frame.q[1]


def test_a_frame_that_turns_steadily_has_an_energy_of_its_own():
    plane = problem("bodies:\n  rod: {at: [0 m, 0 m], pin: {at: [0 m, 0 m], by: \"(8 rad/s)*t\"}}\n"
                    "  bead: {mass: 0.5 kg, at: [0.3 m, 0 m], slide: {along: [1, 0], by: u, carrier: rod}}\n"
                    "springs: {s: {k: 80 N/m, between: [[0 m, 0 m], bead]}}\ninitial: {u: 0.25 m}").phase_plane
    assert kinds(plane) == ["centre"]
    assert plane.own.turns == pytest.approx((0.15, 0.25), rel=1e-13)      # about 0.2 m, ω² = 160 − 64
    assert plane.own.period[0] == pytest.approx(2 * math.pi / math.sqrt(96), rel=1e-13)


@pytest.mark.sweep
def test_a_pole_is_no_equilibrium_and_is_not_passed():
    plane = problem("coordinates: {x: m}\ninitial: {x: -1 cm}\nenergies:\n  T: (0.1 kg)*x'^2/2\n"
                    "  V: (40 N/m)*x^2/2 - (4e-4 N*m^2)/(5 cm - x)\n").phase_plane
    assert kinds(plane) == ["centre", "saddle", "centre"]
    for one in plane.equilibria.items:
        assert 40 * one.q * (0.05 - one.q) ** 2 == pytest.approx(4e-4, rel=1e-12)
    for one in plane.portrait.branches:
        assert one.q.max() < 0.05 or one.q.min() > 0.05


@pytest.mark.sweep
def test_a_motion_that_excites_itself_ends_in_a_limit_cycle():
    plane = problem("coordinates: {x: m}\nenergies:\n  T: (1 kg)*x'^2/2\n  V: (100 N/m)*x^2/2\n"
                    "  Phi: (100 N*s/m^3)*((x^2 - 0.04 m^2)*x'^2/2)\n").phase_plane
    cycle, = plane.cycles
    assert kinds(plane) == ["unstable focus"]
    assert cycle.q.max() == pytest.approx(0.4, rel=2e-3)      # of a weak one twice the place where the damping turns
    assert plane.frame.q[1] > 0.5 and plane.frame.v[1] > 5


@pytest.mark.sweep
@pytest.mark.parametrize(("speed", "end"), [(5, 0.0), (-5, 0.0), (13, None)])
def test_where_a_damped_motion_ends_is_told(speed, end):
    own = pendulum(c="0.15", more=f"initial: {{phi: 0, phi': {speed} rad/s}}").own
    assert (own.end and own.end.q) == end


def test_a_start_at_rest_and_one_on_a_separatrix_are_told():
    assert "rests" in pendulum(more="initial: {phi: 0}").own.reason
    plane = spring("-k*d + b*d^3", more="initial: {x: 0.5 m}")
    assert plane.own.reason == "it is on a separatrix and tends to a saddle"


@pytest.mark.sweep
def test_expanded_equations_have_a_plane_of_their_own():
    plane = pendulum(more="motion: {order: 3}\ninitial: {phi: 1}")
    assert kinds(plane) == ["saddle", "centre", "saddle"]
    assert plane.equilibria.items[2].q == pytest.approx(math.sqrt(6), rel=1e-12)


MASS = "bodies: {B: {mass: 2 kg, slide: x}}\nsprings: {s: {k: 50 N/m, between: [ground, B]}}\n"


@pytest.mark.parametrize(("text", "words"), [
    (MASS + "forces: {F: {at: B, force: \"(1 N)*sin((3 rad/s)*t)\"}}", "depends on the time"),
    ("points: {S: {at: [0 m, 0 m], moves: [\"(1 mm)*sin((3 rad/s)*t)\", 0 m]}}\nbodies: {B: {mass: 2 kg, at: "
     "[1 m, 0 m], slide: x}}\nsprings: {s: {k: 50 N/m, between: [S, B]}}", "depends on the time"),
    (MASS.replace("50 N/m", "k") + "parameters: {k: {unit: N/m}}", "needs numbers"),
    (MASS + "damping: {modal: 0.1}", "damping"),
    (MASS.replace("}\ns", ", C: {mass: 1 kg, slide: y}}\ns", 1), "has 2: x, y"),
    ("bodies: {a: {mass: 1 kg, slide: x}}", "rests anywhere along 'x'"),
    ("bars: {r: {length: 2 m, EA: 2 N, mass_per_length: 1 kg/m, left: clamped}}", "members")])
def test_refusals(text, words):
    with pytest.raises(PhysicsError, match=words):
        problem(text).phase_plane.portrait  # noqa: B018
