"""Approximations of frequencies of members, against closed forms: Rayleigh 1877, Dunkerley 1894."""

from math import pi, sqrt

import pytest
from support.scenes import problem

BEAM = ("parameters: {L: 0.6 m, EI: 56 N*m^2, mu: 0.27 kg/m}\n"
        "beams:\n  arm: {length: L, EI: EI, mass_per_length: mu, %s}\n")
BAR = "parameters: {L: 2 m, EA: 800 N, mu: 3 kg/m}\nbars:\n  rod: {length: L, EA: EA, mass_per_length: mu, %s}\n"


def estimates(text):
    return problem(text).modal.result("estimates")


def test_a_cantilever():
    """Static deflection of a cantilever under its weight: ω² = 162/13 EI/(μL⁴); Σ 1/ω_n² = μL⁴/(12 EI)."""
    found = estimates(BEAM % "left: clamped")
    unit = sqrt(56 / 0.27) / 0.6**2
    assert found.rayleigh == pytest.approx(sqrt(162 / 13) * unit, rel=1e-6)
    assert found.dunkerley == pytest.approx(sqrt(12) * unit, rel=1e-9)
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


@pytest.mark.parametrize("text, order", [(BEAM % "left: clamped", 4), (BAR % "left: clamped", 2)])
def test_elements_converge_from_above(text, order):
    """Errors of cubic elements fall with h⁴, of linear ones with h²."""
    found = estimates(text)
    errors = [omegas[0] / found.omega - 1 for _, omegas in found.members.elements]
    assert all(error > 0 for error in errors)
    assert errors[-2] / errors[-1] == pytest.approx(2**order, rel=0.15)


def test_what_holds_nothing_is_refused():
    from vibcli.base.errors import PhysicsError

    with pytest.raises(PhysicsError, match="rigid"):
        estimates(BAR % "right: free")


def test_a_hanging_chain_has_a_free_end():
    """A straight line hung at its top: ω² = 3g/(2L); Σ 1/ω_n² = L/g, as the zeros of J₀ have Σ 1/j² = 1/4."""
    found = estimates("parameters: {L: 1.2 m, mu: 0.4 kg/m, g: 9.81 m/s^2}\ngravity: g\n"
                      "strings:\n  chain: {from: [0, 0], to: [0, -L], mass_per_length: mu, left: pinned}\n")
    assert found.members.elements[0][1][0] == pytest.approx(sqrt(1.5 * 9.81 / 1.2), rel=1e-12)
    assert found.dunkerley == pytest.approx(sqrt(9.81 / 1.2), rel=2e-3)
    assert found.dunkerley < found.omega < found.rayleigh


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
