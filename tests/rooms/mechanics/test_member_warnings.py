"""Thick beams and large turns in equilibrium are told, in numbers by hand: w = PL³/3EI, w′ = PL²/2EI."""

from pathlib import Path

import pytest
from support.scenes import problem, problem_of

from vibcli.base.errors import PhysicsError
from vibcli.check.verdicts import check
from vibcli.mechanics.member_warnings import member_warnings

TRIALS = Path(__file__).parents[2] / "trials"


def told(beam, parameters=""):
    scene = problem(f"gravity: 9.81 m/s^2\nparameters: {{M: 2 kg{parameters}}}\nbeams: {{arm: {{{beam}}}}}\n")
    return member_warnings(scene.configuration)


@pytest.mark.parametrize(("length", "thick"), [(1.4, True), (1.6, False)])
def test_a_beam_shorter_than_ten_times_its_height_is_thick(length, thick):
    found = told(f"length: {length} m, E: 11 GPa, section: {{rectangle: [0.3 m, 0.15 m]}}, left: clamped, "
                 "attached: [{at: 0.5 m, mass: M}]")
    assert [sentence.startswith("'arm' is thick") for sentence in found] == [True] * thick


@pytest.mark.parametrize(("place", "told_of"), [
    ("0.5 m", " between 0 m and 0.5 m"), ("1.4 m", " between 0 m and 1.4 m"), ("1.5 m", "")])
def test_a_short_span_of_a_long_beam_is_told(place, told_of):
    """h = 0.15 m: L/h is below 10 where supports are less than 1.5 m apart; what hangs over is 2 m and more."""
    found = told(f"length: 4 m, E: 11 GPa, rho: 600 kg/m^3, section: {{rectangle: [0.3 m, 0.15 m]}}, left: pinned, "
                 f"attached: [{{at: {place}, support: pinned}}, {{at: 1 m, mass: M}}]")
    assert [sentence.split(":")[0] for sentence in found] == [f"'arm' is thick{told_of}"] * bool(told_of)


@pytest.mark.parametrize(("slope", "large"), [(0.11, True), (0.09, False)])
def test_a_turn_of_more_than_a_tenth_is_told(slope, large):
    EI = 2 * 9.81 * 1.5**2 / (2 * slope)
    found = told(f"from: [0, 0], to: [1.5 m, 0], EI: {EI} N*m^2, left: clamped, attached: [{{at: 1.5 m, mass: M}}]")
    assert [sentence.split(" turns by ")[1][:4] for sentence in found] == ["0.11"] * large


def test_a_beam_beside_the_point_that_it_carries_is_told():
    """A girder without size between two columns carries their heads as if by arms."""
    frame = problem("bodies: {floor: {mass: 2 kg, at: [1 m, 3 m], move: [x, 0, 0]}}\nbeams:\n" + "".join(
        f"  {name}: {{from: [{x} m, 0], to: [{x} m, 3 m], EI: 9 kN*m^2, left: clamped, right: {{clamped: floor}}}}\n"
        for name, x in (("left", 0), ("middle", 1))))
    assert member_warnings(frame.configuration) == [
        "the right end of 'left' is held to 'floor' 1 m from where that is drawn, as by a rigid arm without mass"]


@pytest.mark.sweep
def test_a_tension_that_statics_leaves_open_is_told_with_where_it_is_from():
    """The columns carry half the load besides; that of the girder by finite elements."""
    assert member_warnings(problem_of(TRIALS / "loaded_frames.yaml").configuration) == [
        f"'{name}': tension {tension} N: statics alone leaves it open; from the equilibrium"
        for name, tension in (("left", -5424), ("right", -5424), ("girder", -545.659))]


@pytest.mark.sweep
def test_a_tension_between_ends_at_rest_is_told_where_its_weight_varies_it():
    """Its mean is the preload, whether it stretches or keeps its length."""
    text = ("gravity: 9.81 m/s^2\nbeams: {w: {from: [0 m, 0 m], to: [WAY], EI: 2 kN*m^2, mass_per_length: 40 kg/m, "
            "left: clamped, right: clamped, attached: [{at: 1 m, mass: 2 kg}]MORE}}")
    for way, more, said in (("0 m, 3 m", "", ["-601.68 N at its left end, 595.14 N at its right one"]),
                            ("0 m, -3 m", ", preload: 50 N", ["651.68 N at its left end, -545.14 N at its right one"]),
                            ("3 m, 0 m", ", preload: 50 N", [])):
        told = member_warnings(problem(text.replace("WAY", way).replace("MORE", more)).configuration)
        assert told == [f"'w': tension {one}: statics alone leaves it open, `preload` tells its mean"
                        for one in said]
    text = text.replace("WAY", "0 m, 3 m").replace(", attached: [{at: 1 m, mass: 2 kg}]MORE", ", EA: 1 MN")
    assert member_warnings(problem(text).configuration) == [
        "'w': tension -588.6 to 588.6 N: statics alone leaves it open; from the equilibrium"]


@pytest.mark.sweep
@pytest.mark.parametrize("ends", ["from: [0, 0], to: [0, L], left: clamped, right: {clamped: head}",
                                  "from: [0, L], to: [0, 0], left: {clamped: head}, right: clamped"])
def test_the_tension_of_a_heavy_mast_under_a_head_is_found(ends):
    """By Ritz's method with 14 powers in mpmath: ∫ EI u″² + N u′² dx, N = −(m + μ(L − x))g from the clamp to the head;
    the masses as ∫ μ u² dx + m u² + J u′²."""
    mast = problem(f"""
        gravity: 9.81 m/s^2
        parameters: {{L: 2 m}}
        bodies: {{head: {{mass: 3 kg, inertia: 0.1 kg*m^2, at: [0, L], move: [X, Y, psi]}}}}
        beams: {{mast: {{{ends}, EI: 500 N*m^2, mass_per_length: 1 kg/m}}}}
        """)
    assert member_warnings(mast.configuration) == []
    assert mast.modal.modes[0].omega == pytest.approx(6.86289503406, rel=1e-11)


@pytest.mark.parametrize(("string", "turn"), [
    ("from: [0, 0], to: [20 m, 0], left: pinned, right: pinned, preload: 1 kN", "0.147"),      # w L/2N at its ends
    ("from: [0, 0], to: [1 m, -2 m], left: pinned", "0.5"),                                     # hangs straight down
    ("from: [0, 0], to: [0, -2 m], left: pinned", None)])
def test_a_string_that_sags_between_its_ends_is_told(string, turn):
    scene = problem(f"gravity: 9.81 m/s^2\nstrings: {{line: {{{string}, mass_per_length: 1.5 kg/m}}}}\n")
    found = member_warnings(scene.configuration)
    assert [sentence.split(" turns by ")[1].split()[0] for sentence in found] == ([turn] if turn else [])


def test_a_bar_that_comes_to_hang_turns_by_a_right_angle():
    """A mass of 1 kg at the end of a hinged bar that is drawn level: π/2, not the displacement over the length."""
    text = """
        gravity: 9.81 m/s^2
        bars: {b: {from: [0, 0], to: [1 m, 0], EA: 10 kN, left: pinned, right: {pinned: p}}}
        bodies: {p: {mass: 1 kg, at: [1 m, 0], move: [x, y]}}
        """
    assert member_warnings(problem(text).configuration) == [
        "'b' turns by 1.57 rad in equilibrium, more than 0.1 rad: members are linear about their drawn line"]


@pytest.mark.parametrize(("member", "told_of"), [
    ("strings: {cord: {length: 1 m, preload: 100 N, left: clamped, right: clamped", "'cord' has no mass of its own"),
    ("shafts: {line: {length: 1 m, GIo: 3 N*m^2, left: clamped, right: clamped", "'line' has no inertia of its own")])
def test_a_member_without_mass_is_told_what_would_move_it(member, told_of):
    with pytest.raises(PhysicsError, match="it has no coordinates") as refused:
        assert problem(f"{member}}}}}\n").system.time_dependent_linearisation
    assert told_of in refused.value.hint
    attached = refused.value.hint.partition("as in ")[2]
    assert problem(f"{member}, {attached}}}}}\n").modal.modes[0].omega > 0


def test_it_has_the_reactions_of_a_body_that_reaches_there():
    """A load of 3 N at 0.6 m turns the slider 5 cm beside the beam by 3·0.65 N·m, and its slope is that of a clamp."""
    found = problem("""
        parameters: {L: 0.6 m, F: 3 N, EI: 20 N*m^2}
        bodies: {base: {mass: 2 kg, at: [-0.05 m, 0], slide: {along: [0, 1], by: y}}}
        springs: {s: {k: 400 N/m, between: [[-0.05 m, -0.3 m], base]}}
        beams: {wing: {from: [0, 0], to: [L, 0], EI: EI, mass_per_length: 0.3 kg/m, left: {clamped: base}}}
        points: {tip: {body: wing, at: L}}
        forces: {f: {at: tip, force: [0, F]}}
        answers: {"equilibrium[base.reaction.moment]": -1.95 N*m, "equilibrium[wing.slope(L)]": F*L^2/(2*EI)}
    """)
    assert [verdict.agrees for verdict in check(found)] == [True, True]
