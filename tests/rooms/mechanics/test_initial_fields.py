"""Fields that members start with, and what they say of their stations."""

import math

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError, SpecError

SCENE = """
parameters: {{L: 2 m, EA: 1000 N, EI: 10 N*m^2, mu: 0.5 kg/m, a: 1 mm, M: 2 kg}}
bodies: {{block: {{mass: M, slide: z}}}}
bars: {{rod: {{length: L, EA: EA, mass_per_length: mu, left: clamped, right: {{clamped: block}},
             attached: [{{at: L/2, mass: M}}]}}}}
shafts: {{line: {{length: L, GIo: EI, inertia_per_length: 1 kg*m, left: clamped}}}}
beams: {{wing: {{length: L, EI: EI, mass_per_length: mu, left: pinned}}}}
initial: {initial}
"""


def given(initial):
    return problem(SCENE.format(initial=initial)).initial.given


def test_what_is_attached_starts_with_the_field():
    found = given("{rod.u: a*sin(pi*x/(2*L)), rod.u': 0.1 m/s, line.phi': 2 rad/s*x/L}")
    assert found == pytest.approx({"z": 1e-3, "rod.u(L/2)": 1e-3 * math.sqrt(0.5), "z'": 0.1, "rod.u(L/2)'": 0.1,
                                   "line.phi(L)'": 2.0})


def test_slopes_start_with_that_of_the_field():
    found = given("{wing.u: a*x^2/L^2, wing.u': 1 m/s*x/L}")
    assert found == pytest.approx({"wing.slope(0 m)": 0.0, "wing.u(L)": 1e-3, "wing.slope(L)": 1e-3,
                                   "wing.slope(0 m)'": 0.5, "wing.u(L)'": 1.0, "wing.slope(L)'": 0.5})


def test_x_is_the_place_whatever_it_names_elsewhere():
    scene = SCENE.replace("slide: z", "slide: x").replace("a: 1 mm", "a: 1 mm, y: 1 m")
    assert problem(scene.format(initial="{rod.u: a*x/L*(y/L + 1/2)}")).initial.given["x"] == pytest.approx(1e-3)


def test_a_displacement_fits_the_supports():
    with pytest.raises(PhysicsError, match=r"'rod' is held at 0 m, where this field is 0\.001"):
        given("{rod.u: a*(1 + x/L)}")


@pytest.mark.parametrize(("initial", "message"), [
    ("{rod.u: a*x/L, z: 2 mm}", "'z' starts at 0.002, and this field is 0.001 there"),
    ("{wing.u: a*x/L, rod.u: a*x/L}", "'rod.u(L/2)' starts at 0.001, and this field is 0.0005 there"),
])
def test_a_displacement_is_the_same_for_all_that_it_moves(initial, message):
    scene = SCENE.replace("left: pinned", "left: pinned, right: {{pinned: rod, at: L/2}}")
    with pytest.raises(PhysicsError) as refusal:
        assert problem(scene.format(initial=initial)).initial.given
    assert refusal.value.message == message


def test_velocities_may_jump_at_what_is_attached():
    assert given("{rod.u: a*x/L, z: a, z': 2 m/s, rod.u': 0 m/s}")["z'"] == 2.0


def test_a_slope_fits_a_clamped_end():
    scene = SCENE.replace("left: pinned", "left: clamped").format(initial="{wing.u: a*x/L}")
    with pytest.raises(PhysicsError, match=r"'wing' is held at 0 m, where the slope of this field is 0\.0005"):
        assert problem(scene).initial.given


@pytest.mark.parametrize(("initial", "words", "hint"), [
    ("{rod.v: 1 mm}", "a bar starts with a field of 'u'", "write rod.u: …"),
    ("{line.u: 1 mm}", "a shaft starts with a field of 'phi'", "write line.phi: … or line.phi': …"),
    ("{rod.u(L): 1 mm}", "found 'rod.u(L)'", "x being the place"),
    ("{rod.u'': 1 m/s}", "found 'rod.u'''", "x being the place"),
    ("{rod.u: 1 s}", "expected a length (m), found a time (s)", ""),
    ("{rod.u: a*t}", "the time t cannot stand here", ""),
])
def test_wrong_fields_are_told(initial, words, hint):
    with pytest.raises(SpecError) as refusal:
        given(initial)
    told = refusal.value.diagnostics[0]
    assert words in told.message and hint in (told.hint or "")


def test_what_is_left_of_a_field_at_a_support_is_rounding():
    scene = """
        strings: {cord: {length: 2 m, preload: 100 N, mass_per_length: 1 kg/m, left: pinned, right: pinned}}
        initial: {cord.u: 1 mm*sin(pi*x/(2 m))}
    """
    assert problem(scene).initial.given == {}
