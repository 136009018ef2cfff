"""Approximations of frequencies of members, against closed forms: Rayleigh 1877, Dunkerley 1894."""

from math import pi, sqrt

import numpy as np
import pytest
from support.scenes import problem

import vibcli
from vibcli.analyses.continuous.finite_elements import finite_elements
from vibcli.analyses.continuous.member_estimates import beside_elements
from vibcli.base.errors import PhysicsError

BEAM = ("parameters: {L: 0.6 m, EI: 56 N*m^2, mu: 0.27 kg/m}\n"
        "beams:\n  arm: {length: L, EI: EI, mass_per_length: mu, %s}\n")
BAR = "parameters: {L: 2 m, EA: 800 N, mu: 3 kg/m}\nbars:\n  rod: {length: L, EA: EA, mass_per_length: mu, %s}\n"
EVEN_BEAM = "beams: {b: {length: 2 m, EI: 300 N*m^2, mass_per_length: 2 kg/m, left: clamped%s}}"
EVEN_BAR = "bars: {b: {length: 2 m, EA: 40 kN, mass_per_length: 2 kg/m, left: clamped%s}}"
EVEN_STRING = "strings: {b: {length: 2 m, preload: 300 N, mass_per_length: 2 kg/m, left: pinned, right: pinned%s}}"


def bound(text, name):
    """(value, relative error) of `rayleigh` or `dunkerley`."""
    found = vibcli.loads(text)[name]
    return found.value, found.error / found.value


def estimates(text):
    return problem(text).modal.result("estimates")


@pytest.mark.sweep
def test_a_cantilever():
    """Static deflection of a cantilever under its weight: ω² = 162/13 EI/(μL⁴); Σ 1/ω_n² = μL⁴/(12 EI)."""
    found = estimates(BEAM % "left: clamped")
    unit = sqrt(56 / 0.27) / 0.6**2
    assert found.rayleigh == pytest.approx(sqrt(162 / 13) * unit, rel=1e-13)
    assert found.dunkerley == pytest.approx(sqrt(12) * unit, rel=1e-13)
    tip = found.members.lumped["arm.u(L)"]
    assert tip.of_members == pytest.approx(33 / 140, rel=1e-12)
    assert tip.stiffness == pytest.approx(3 * 56 / 0.6**3, rel=1e-12)
    assert found.dunkerley < found.omega < found.rayleigh


def test_a_bar_held_at_both_ends():
    """No coordinate at all: ω² ≤ 10 EA/(μL²), Σ 1/ω_n² = μL²/(6 EA)."""
    found = estimates(BAR % "left: clamped, right: clamped")
    unit = sqrt(800 / 3) / 2
    assert found.rayleigh == pytest.approx(sqrt(10) * unit, rel=1e-4)
    assert found.dunkerley == pytest.approx(sqrt(6) * unit, rel=1e-12)
    assert found.members.lumped == {}


def test_a_bar_counts_a_third_at_its_end():
    found = estimates(BAR % "left: clamped, attached: [{at: L, mass: 5 kg}]")
    assert found.members.lumped["rod.u(L)"].mass == pytest.approx(5 + 2, rel=1e-12)
    assert found.dunkerley == pytest.approx(sqrt(1 / (3 * 4 / 2 / 800 + 5 * 2 / 800)), rel=1e-12)


@pytest.mark.sweep
@pytest.mark.parametrize("text, order", [(BEAM % "left: clamped", 4), (BAR % "left: clamped", 2)])
def test_elements_converge_from_above(text, order):
    """Errors of cubic elements fall with h⁴, of linear ones with h²."""
    found = estimates(text)
    errors = [omegas[0] / found.omega - 1 for _, omegas in found.members.elements]
    assert all(error > 0 for error in errors)
    assert errors[-2] / errors[-1] == pytest.approx(2**order, rel=0.15)


def test_what_holds_nothing_is_refused():
    with pytest.raises(PhysicsError, match="rigid"):
        estimates(BAR % "right: free")


@pytest.mark.sweep
def test_a_hanging_chain_has_a_free_end():
    """A straight line hung at its top: ω² = 3g/(2L); Σ 1/ω_n² = L/g, as the zeros of J₀ have Σ 1/j² = 1/4."""
    found = estimates("parameters: {L: 1.2 m, mu: 0.4 kg/m, g: 9.81 m/s^2}\ngravity: g\n"
                      "strings:\n  chain: {from: [0, 0], to: [0, -L], mass_per_length: mu, left: pinned}\n")
    assert found.members.elements[0][1][0] == pytest.approx(sqrt(1.5 * 9.81 / 1.2), rel=1e-12)
    assert found.dunkerley == pytest.approx(sqrt(9.81 / 1.2), rel=2e-3)
    assert found.dunkerley < found.omega < found.rayleigh


@pytest.mark.sweep
def test_what_does_not_turn_and_what_two_shapes_do_not_share_is_zero():
    """By half sines of a hinged beam: 5 w L⁴/384 + F L³/48 over w L³/24 + F L²/16, F = wL/2; K = π⁴n⁴EI/(2L³)."""
    found = problem("""\
        parameters: {L: 2 m, EI: 100 N*m^2, mu: 1 kg/m}
        beams:
          w: {length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned, attached: [{at: L/2, mass: mu*L/2}]}
        find: [{ritz: {shapes: [{w.u: sin(pi*x/L)}, {w.u: sin(3*pi*x/L)}]}}]
        """).modal
    shape = found.result("estimates").deflection
    assert shape["w.slope(L/2)"] == 0
    assert shape["w.u(L/2)"] / shape["w.slope(0 m)"] == pytest.approx((5 / 192 + 1 / 48) / (1 / 24 + 1 / 32), rel=1e-5)
    K = found.result("ritz").K
    assert K[0][1] == K[1][0] == 0
    assert [K[0][0], K[1][1]] == pytest.approx([pi**4 * 100 / 16, 81 * pi**4 * 100 / 16], rel=1e-15)


@pytest.mark.sweep
@pytest.mark.parametrize(("scene", "rayleigh", "dunkerley"), [
    (EVEN_BEAM % "", 300 / 32 * 162 / 13, 12 * 300 / 32), (EVEN_BAR % "", 40e3 / 8 * 2.5, 2 * 40e3 / 8),
    (EVEN_STRING % "", 300 / 8 * 10, 6 * 300 / 8)])
def test_both_bounds_are_exact_to_rounding(scene, rayleigh, dunkerley):
    """∫u dx/∫u² dx of the static deflections under even loads, and ∫G(x, x) dx, by hand: ω² L⁴μ/EI = 162/13 and 12 …"""
    for name, square in (("rayleigh", rayleigh), ("dunkerley", dunkerley)):
        found, error = bound(scene, name)
        assert abs(found / sqrt(square) - 1) <= 1e-14 and error <= 1e-13


@pytest.mark.sweep
@pytest.mark.parametrize("short", [1e-2, 1e-4, 1e-6, 1e-8])
def test_places_close_to_one_another_leave_their_bound_or_nothing(short):
    """A node near the end changes neither bound; where pieces are too short beside others neither is told."""
    scene = EVEN_BEAM % f", attached: [{{at: 2*(1 - {short!r})*1 m, mass: 1e-15 kg}}]"
    for name, square in (("rayleigh", 300 / 32 * 162 / 13), ("dunkerley", 12 * 300 / 32)):
        try:
            found, error = bound(scene, name)
        except PhysicsError as refused:
            assert short < 1e-3 and "lose their digits" in refused.message
        else:
            assert abs(found / sqrt(square) - 1) <= error < 1e-3


@pytest.mark.sweep
def test_bounds_beside_a_tension_and_a_foundation():
    """Dunkerley's as Σ 1/ω² of 150 modes and of what follows them as (n − a)⁴."""
    scene = EVEN_BEAM % (", right: {k: 900 N/m}, preload: 300 N, foundation: 500 N/m^2, "
                         "attached: [{at: 0.8 m, mass: 1.5 kg}]")
    assert bound(scene, "dunkerley")[0] == pytest.approx(27.873055892, rel=1e-9)
    assert bound(scene, "rayleigh")[0] == pytest.approx(31.5112260852724, rel=1e-12)     # by finite elements


@pytest.mark.sweep
def test_what_follows_one_coordinate_does_so_with_its_bed_and_its_tension():
    """Against static condensation of 64 finite elements."""
    found = problem(BEAM % "left: clamped, foundation: 30 kN/m^2, preload: 200 N")
    K, M = finite_elements(found.configuration.linear_system, 64)
    shape = np.linalg.solve(K, np.eye(len(K))[0])
    tip = found.modal.result("estimates").members.lumped["arm.u(L)"]
    assert tip.mass == pytest.approx(shape @ M @ shape / shape[0] ** 2, rel=1e-7)


def test_elements_of_what_is_free_leave_rigid_motions_out():
    """One linear element of a free bar: 12 EA/(μL²)."""
    found, exact = beside_elements(problem(BAR % "left: free").modal, 1)
    assert exact[0] == pytest.approx(pi * sqrt(800 / 3) / 2, rel=1e-14)
    assert found[0] == (1, [pytest.approx(sqrt(12 * 800 / 3) / 2, rel=1e-12)])
    assert 0 < found[-1][1][0] / exact[0] - 1 < 0.01
