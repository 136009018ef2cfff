"""Rayleigh's quotients and Ritz estimates of assumed deflections against integrals by hand."""

from math import pi, sqrt

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError

BEAM = "parameters: {{L: 2 m}}\nbeams: {{arm: {{length: L, EI: 48 N*m^2, mass_per_length: 3 kg/m{}}}}}\n{}"
HELD = ", left: clamped"


def quotient(text, deflection, digits=None):
    return problem(text).modal.rayleigh_quotient(deflection, digits)


def test_a_cantilever_by_a_parabola():
    """∫ (x²)″² = 4L, ∫ x⁴ = L⁵/5."""
    assert float(quotient(BEAM.format(HELD, ""), "x^2")) == pytest.approx(sqrt(20 * 48 / 3) / 4, rel=1e-15)


def test_what_is_attached_goes_along():
    """Σ springs and masses at their stations, inertias and torsion springs by the slope 2x."""
    attached = (", attached: [{at: L, mass: 5 kg, inertia: 2 kg*m^2}, {at: 1 m, torsion: 7 N*m}, {at: 1.5 m, k: 9 N/m}]"
                ", foundation: 11 Pa")
    K = 48 * 4 * 2 + 7 * 2**2 + 9 * 1.5**4 + 11 * 2**5 / 5
    M = 3 * 2**5 / 5 + 5 * 2**4 + 2 * 4**2
    assert float(quotient(BEAM.format(HELD + attached, ""), "x^2")) == pytest.approx(sqrt(K / M), rel=1e-15)


def test_tension_stores_by_the_slope():
    """∫ N f′² of a string and a beam."""
    text = "strings: {cord: {length: 2 m, preload: 12 N, mass_per_length: 3 kg/m, left: pinned, right: pinned}}\n"
    assert float(quotient(text, "x*(2 m - x)")) == pytest.approx(sqrt(12 * (8 / 3) / (3 * 16 / 15)), rel=1e-15)
    K = 48 * 4 * 2 - 5 * 4 * 8 / 3
    assert float(quotient(BEAM.format(HELD + ", preload: -5 N", ""), "x^2")) == pytest.approx(
        sqrt(K / (3 * 32 / 5)), rel=1e-15)


def test_a_body_at_the_end_moves_along():
    text = BEAM.format(HELD + ", right: {pinned: load}", "bodies: {load: {mass: 4 kg, slide: z}}\n")
    assert float(quotient(text, "x^2")) == pytest.approx(sqrt(48 * 8 / (3 * 32 / 5 + 4 * 16)), rel=1e-15)


def test_the_shape_itself_gives_the_frequency():
    text = BEAM.format(", left: pinned, right: pinned", "")
    assert float(quotient(text, "sin(3*pi*x/L)", 40)) == pytest.approx((3 * pi / 2) ** 2 * 4, rel=1e-15)


@pytest.mark.parametrize("held, deflection, said", [
    (HELD, "x", "held at 0 m, where this deflection has the slope 1"),
    (HELD, "1", "held at 0 m, where this deflection is 1"),
    (", right: pinned", "x", "held at 2 m, where this deflection is 2"),
    (", left: guided", "x", "the slope 1"),
    (HELD, "x^2*abs(x - 0.7 m)", "not smooth"),
    (HELD, "x^2*log(x/L)", "no real numbers at 0 m"),
    (HELD, "0*x", "nothing moves"),
    (HELD + ", attached: [{at: L, oscillator: {mass: 1 kg, k: 3 N/m}}]", "x^2", "does not follow from the deflection"),
])
def test_what_is_no_bound_is_refused(held, deflection, said):
    with pytest.raises(PhysicsError, match=said):
        quotient(BEAM.format(held, ""), deflection)


def test_a_body_that_does_not_follow_is_refused_by_name():
    text = BEAM.format(HELD, "bodies: {other: {mass: 1 kg, slide: z}}\n"
                       "springs: {s: {k: 3 N/m, between: [ground, other]}}\n")
    with pytest.raises(PhysicsError, match="the motion of z does not follow"):
        quotient(text, "x^2")


def ritz(text, shapes):
    return problem(f"{text}find: [{{ritz: {{shapes: [{shapes}]}}}}]\n").modal.result("ritz").modes


def test_a_cantilever_by_two_powers():
    """(4 - κ/5)(12 - κ/7) = (6 - κ/6)², κ = ω²μL⁴/(EI): 3.5327 and 34.807 (Meirovitch 1967, Rao 2007)."""
    found = [mode.omega / (sqrt(48 / 3) / 4) for mode in ritz(BEAM.format(HELD, ""), "{arm.u: x^2}, {arm.u: x^3}")]
    roots = [612 - sign * sqrt(612**2 - 15120) for sign in (1, -1)]
    assert found == pytest.approx(list(map(sqrt, roots)), rel=1e-14)
    assert found == pytest.approx([3.5327, 34.807], rel=2e-5)


@pytest.mark.sweep
def test_what_is_named_and_what_goes_along():
    """A cart under the clamped end follows, or is named; powers enough come to the exact frequencies."""
    text = BEAM.format(", left: {clamped: cart}", "bodies: {cart: {mass: 2 kg, slide: z}}\n"
                       "springs: {s: {k: 300 N/m, between: [ground, cart]}}\n")
    powers = ", ".join(f"{{arm.u: (x/L)^{n}}}" for n in range(2, 10))
    followed, named = (ritz(text, f"{{{z}arm.u: 1}}, {powers}") for z in ("", "z: 1, "))
    assert [mode.omega for mode in followed] == [mode.omega for mode in named]
    assert all(mode.exact * (1 - 1e-12) <= mode.omega for mode in named)
    assert named[1].omega == pytest.approx(named[1].exact, rel=1e-8)
    for shape, said in (("{z: 2, arm.u: 1}", "held to what moves otherwise at 0 m"),
                        ("{arm.u: 1}, {arm.u: 2}", "combination of those before it"), ("{arm.phi: 1}", "has no 'phi'")):
        with pytest.raises(PhysicsError, match=said):
            ritz(text, shape)
