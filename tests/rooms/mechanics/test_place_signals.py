"""Signals of places on members without inertia: by the elementary formulas of beams, bars and shafts."""

import math

import pytest
from support.scenes import problem

from vibcli.api.values import quantity_value
from vibcli.base.errors import PhysicsError, SpecError

L, EI, F, M = 2.0, 1000.0, 30.0, 2.0
BEAM = """
parameters: {L: 2 m, EI: 1000 N*m^2, F: 30 N, m: 2 kg}
beams: {wing: {length: L, EI: EI, left: clamped, attached: [{at: L, mass: m}]}}
points: {tip: {body: wing, at: L}}
forces: {pull: {at: tip, force: F*step(t)}}
motion: small
"""
STEPPED = """
parameters: {a: 0.5 m, b: 1.5 m, E: 200 GPa, d: 20 mm, F: 30 N}
bars: {rod: {E: E, left: clamped, segments: [{length: a, section: {circle: d}}, {length: b, section: {circle: d/2}}]}}
points: {tip: {body: rod, at: a + b}}
forces: {pull: {at: tip, force: F}}
"""


def value(scene, text):
    return quantity_value(scene, text).value


@pytest.mark.parametrize(("place", "x"), [("0 m", 0.0), ("L/3", L / 3), ("0.7 m", 0.7), ("L", L)])
def test_a_cantilever_under_a_force_at_its_tip(place, x):
    scene = problem(BEAM.replace("*step(t)", ""))
    expected = {"u": F * x**2 * (3 * L - x) / (6 * EI), "slope": F * x * (2 * L - x) / (2 * EI), "moment": F * (L - x),
                "shear": -F}
    for part, number in expected.items():
        assert value(scene, f"equilibrium[wing.{part}({place})]") == pytest.approx(number, rel=1e-13, abs=1e-13)


def test_along_a_motion_it_deflects_as_at_rest():
    """A mass at the tip of a light beam under a step: u = u₀ (1 − cos ωt), ω² = 3EI/(mL³)."""
    scene, w = problem(BEAM), math.sqrt(3 * EI / (M * L**3))
    still, part = F * L**3 / (3 * EI), 5 / 16
    for t in (0.1, 0.37):
        moved = still * (1 - math.cos(w * t))
        assert value(scene, f"wing.u(L)({t} s)") == pytest.approx(moved, rel=1e-11)
        assert value(scene, f"wing.u(L/2)({t} s)") == pytest.approx(part * moved, rel=1e-11)
        assert value(scene, f"wing.u'(L/2)({t} s)") == pytest.approx(part * still * w * math.sin(w * t), rel=1e-11)
        assert value(scene, f"wing.moment(0 m)({t} s)") == pytest.approx(3 * EI / L**2 * moved, rel=1e-11)
    assert value(scene, "mode[1][wing.u(L/2)]") == pytest.approx(part, rel=1e-12)
    assert value(scene, "abs(frf[wing.u(L/2), pull](0 rad/s))") == pytest.approx(part * L**3 / (3 * EI), rel=1e-12)


def test_at_a_step_of_section_the_right_side_counts():
    scene, areas = problem(STEPPED), [math.pi * d**2 / 4 for d in (0.02, 0.01)]
    assert value(scene, "equilibrium[rod.force(a)]") == pytest.approx(F, rel=1e-12)
    for place, area in (("0 m", areas[0]), ("a/2", areas[0]), ("a", areas[1]), ("a + b", areas[1])):
        assert value(scene, f"equilibrium[rod.stress({place})]") == pytest.approx(F / area, rel=1e-12)


@pytest.mark.parametrize(("asked", "words", "hint"), [
    ("wing.u", "needs a place on the beam", "write wing.u(L)"),
    ("wing.bend(L)", "a beam has no 'bend'", "wing"),
    ("wing.slop(L)", "a beam has no 'slop'", "did you mean 'wing.slope(L)'?"),
    ("wing.stress(L)", "has no cross-section", "ask for wing.moment(L)"),
    ("wing.u(F)", "expected a place", "lengths from its left end"),
    ("wing.u(l)", "'l' is no parameter", "L"),
])
def test_wrong_signals_are_told(asked, words, hint):
    scene = problem(BEAM)
    for text in (f"max({asked})", f"mode[1][{asked}]"):
        with pytest.raises(SpecError) as refusal:
            quantity_value(scene, text)
        told = refusal.value.diagnostics[0]
        assert words in told.message and hint in (told.hint or "")


def test_a_place_beyond_the_end_is_refused():
    with pytest.raises(PhysicsError, match=r"is 2\.5 m along 'wing', which is 2 m long"):
        value(problem(BEAM), "mode[1][wing.u(L + 0.5 m)]")


def field_of(k, N, B, x, load):
    """[u, u′, u″, u‴] at x of a beam clamped at 0, k u − N u″ + B u⁗ = 0, B u″ = 0 and N u′ − B u‴ = load at L: by
    exponentials in mpmath."""
    import mpmath as mp

    roots = mp.polyroots([B, 0, -N, 0, k], maxsteps=200, extraprec=200)
    row = lambda y, n: [r**n * mp.exp(r * y) for r in roots]                                                # noqa: E731
    end = [N * a - B * b for a, b in zip(row(L, 1), row(L, 3), strict=True)]
    c = mp.lu_solve(mp.matrix([row(0, 0), row(0, 1), row(L, 2), end]), mp.matrix([0, 0, 0, load]))
    return [float(mp.re(sum(ci * ri for ci, ri in zip(c, row(x, n), strict=True)))) for n in range(4)]


@pytest.mark.parametrize(("k", "N"), [(400, 0.001), (5e4, 0.001), (400, 900), (400, -300), (0.001, 700), (0.001, -200)])
def test_a_light_beam_on_a_foundation_under_tension(k, N):
    given = (f", foundation: {k} N/m^2" if k > 0.01 else "") + (f", preload: {N} N" if abs(N) > 0.01 else "")
    scene = problem(BEAM.replace("EI: EI,", "EI: EI" + given + ",").replace("*step(t)", ""))
    for x in (0.3, 1.1, 2.0):
        u, slope, bend, third = field_of(k if k > 0.01 else 1e-12, N if abs(N) > 0.01 else 1e-12, EI, x, F)
        for part, number in (("u", u), ("slope", slope), ("moment", EI * bend), ("shear", EI * third)):
            assert value(scene, f"equilibrium[wing.{part}({x} m)]") == pytest.approx(number, rel=1e-7, abs=1e-7)


def test_a_light_string_and_bar_on_a_foundation():
    scene = problem("""
        strings: {cord: {length: 2 m, preload: 50 N, foundation: 200 N/m^2, left: pinned}}
        points: {tip: {body: cord, at: 2 m}}
        forces: {pull: {at: tip, force: 10 N}}
    """)
    for x in (0.0, 0.5, 2.0):
        u = 10 / (50 * 2 * math.cosh(4)) * math.sinh(2 * x)
        slope = 10 / (50 * math.cosh(4)) * math.cosh(2 * x)
        assert value(scene, f"equilibrium[cord.u({x} m)]") == pytest.approx(u, rel=1e-12, abs=1e-15)
        assert value(scene, f"equilibrium[cord.slope({x} m)]") == pytest.approx(slope, rel=1e-12)
    assert value(scene, "equilibrium[cord.force(1 m)]") == 50
