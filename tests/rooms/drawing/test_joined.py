"""What moves together is joined in the figure: rods to bodies that expressions place, ropes that motions imply."""

from itertools import pairwise
from pathlib import Path

import pytest
from support.scenes import problem, problem_of

from vibcli.drawing.canvas.primitives import Polyline, extent
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import compose, letters, plane
from vibcli.drawing.layout.drawn_members import along

PROBLEMS = Path(__file__).parents[3] / "problems"
PLATFORM = """
    parameters: {{m: 2 kg, M: 5 kg, L: 1 m, g: 9.81 m/s^2}}
    gravity: g
    bodies:
      left: {{shape: rod, mass: m, from: [-0.5 m, L], to: [-0.5 m, 0], pin: {{at: [-0.5 m, L], by: phi}}}}
      right: {{shape: rod, mass: m, from: [0.5 m, L], to: [0.5 m, 0], pin: {{at: [0.5 m, L], by: phi}}}}
      platform: {{mass: M, at: [0, 0], move: {motion}}}
"""
ROLLER = """
    parameters: {{m: 16 kg, R: 0.2 m, c: 120 N*s/m}}
    surfaces: {{floor: {{line: [[-2 m, 0], [2 m, 0]]}}}}
    bodies:
      roller: {{shape: disc, mass: m, radius: R, at: [0, R], roll: {{surface: floor, travel: x}}}}
      piston: {{{mass}at: [3*R, {height}], slide: {by}}}
    dampers: {{d: {{c: c, between: [piston, [6*R, {height}]]}}}}
"""
DRUM = """
    parameters: {{m: 12 kg, R: 0.2 m, r: 0.12 m, b: 0.08 m, g: 9.81 m/s^2}}
    gravity: g
    surfaces: {{floor: {{line: [[-0.5 m, 0], [1 m, 0]]}}}}
    bodies:
      drum: {{shape: disc, mass: m, radius: R, at: [0, R], roll: {{surface: floor, travel: x}}}}
      pulley: {{shape: disc, mass: m, radius: b, at: [1.5 m, R + r - b], pin: {{by: -{ratio}*x/b}}}}
      weight: {{mass: m, at: [1.5 m + b, -0.4 m], slide: {{along: [0, -1], by: {ratio}*x}}}}
"""
WHEEL = """
    parameters: {{J: 2 kg*m^2, k: 600 N/m, r: 0.3 m}}
    bodies:
      wheel: {{inertia: J, at: [0, 0], pin: phi}}
      end: {{{mass}at: [0, r], slide: -r*phi}}
    springs: {{s: {{k: k, between: [[-1 m, r], end]}}}}
"""


def stage_of(text, **fields):
    return compose.Scenery(problem(text.format(**fields)).scene)


@pytest.mark.parametrize("motion, count", [
    ("[L*sin(phi), -L*cos(phi), 0]", 2), ("[L*phi, 0, 0]", 0), ("[x, y, 0]", 0),
    ("[L*sin(phi), -L*cos(phi), 0.1*phi^2]", 0)])
def test_rods_are_pinned_to_what_stays_on_their_ends(motion, count):
    """Not where the speeds agree in the drawn position alone."""
    stage = stage_of(PLATFORM, motion=motion)
    assert len(stage.ties.hinges) == count
    assert stage.looks["platform"].kind == ("bar" if count else "ball")
    for end in stage.ties.hinges:
        assert any(plane.inside(end.drawn, part.points) for part in stage.looks["platform"].outlines[:1])
        for angle in (-0.6, 0.9):
            moved = stage.at({"phi": angle})
            assert moved.now(end) == pytest.approx(moved.frames["platform"].point(end.drawn))


def test_a_bar_reaches_over_all_that_it_carries():
    stage = stage_of(PLATFORM, motion="[L*sin(phi), -L*cos(phi), 0]")
    left, _, right, _ = plane.bounds(stage.looks["platform"].core)
    assert left < -0.5 * stage.sketch.scale and right > 0.5 * stage.sketch.scale


@pytest.mark.parametrize("height, by, count", [("2*R", "2*x", 1), ("R/2", "x/2", 1), ("2*R", "x", 0), ("3*R", "3*x", 0),
                                               ("2*R", "-2*x", 0)])
def test_a_rope_leaves_a_roller_where_both_are_as_fast(height, by, count):
    """A place at the height h over the floor moves h/R times as fast as the axle; above the roller there is none."""
    stage = stage_of(ROLLER, mass="", height=height, by=by)
    assert [(rope.wheel, rope.weight) for rope in stage.ties.implied] == [("roller", "piston")] * count
    assert len([name for name in stage.ropes if name.startswith("implied")]) == count
    assert stage.looks["piston"].kind == ("joint" if count else "block")


def test_a_piston_with_a_mass_stays_a_block():
    stage = stage_of(ROLLER, mass="mass: m, ", height="2*R", by="2*x")
    assert len(stage.ties.implied) == 1 and stage.looks["piston"].kind == "block"


def test_a_rope_goes_on_over_a_pulley_to_what_turns_it():
    stage = stage_of(DRUM, ratio="(1 + r/R)")
    ropes, scale = stage.ties.implied, stage.sketch.scale
    assert [(rope.wheel, rope.weight) for rope in ropes] == [("pulley", "weight"), ("pulley", "drum")]
    assert ropes[1].over == pytest.approx(0.12 * scale)
    first, second = stage.ropes["implied 1"]
    assert first.at.drawn[1] + first.radius == pytest.approx(second.at.drawn[1] + second.radius)
    assert [part.fill for part in stage.looks["drum"].pieces] == ["body", "inner"]


def test_no_rope_where_the_pulley_turns_at_another_rate():
    stage = stage_of(DRUM, ratio="(1 + r/R)/2")
    ropes = [(rope.wheel, rope.weight) for rope in stage.ties.implied]
    assert ropes == [("pulley", "weight")]


@pytest.mark.parametrize("mass, kind", [("", "joint"), ("mass: 3 kg, ", "block")])
def test_what_is_on_the_rim_itself_hangs_on_no_rope(mass, kind):
    stage = stage_of(WHEEL, mass=mass)
    assert not stage.ropes and stage.looks["end"].kind == kind
    assert draw(problem(WHEEL.format(mass=mass)))
    assert stage.ties.carried["wheel"] == [(0.0, pytest.approx(0.3 * stage.sketch.scale))]


def test_the_mass_centre_of_a_bent_frame_in_letters_is_drawn_among_its_places():
    path = PROBLEMS / "1_statics_and_energy/three_hinged_shed_in_the_wind.yaml"
    stage = letters.pleasing(problem_of(path), compose.Scenery)
    assert letters.crowding(stage) <= letters.ENOUGH < letters.crowding(compose.Scenery(problem_of(path).scene))
    for name in ("left", "right"):
        (left, bottom), (right, top) = plane.corners([stage.sketch.pivot(name).drawn, *stage.ties.carried[name]])
        x, y = stage.sketch.centre(name)
        assert left <= x <= right and bottom <= y <= top


SNATCHED = """
    parameters: {{m: 12 kg, r: 0.2 m, k: 3 kN/m, g: 9.81 m/s^2}}
    gravity: g
    bodies:
      pulley: {{shape: disc, mass: m, radius: r, at: [0, 0], move: [{x}, {y}, {turn}]}}
      strand: {{at: [r, 0], slide: {{along: [0, 1], by: 2*y}}}}
    springs: {{s: {{k: k, between: [strand, [r, 1 m]], preload: static}}}}
"""


@pytest.mark.parametrize("y, x, turn, side", [
    ("y", "0", "y/r", -1), ("y", "0", "-y/r", 1), ("y", "0", "y/(2*r)", 0), ("y", "y", "y/r", 0), ("y", "0", "0", 0)])
def test_a_pulley_hangs_in_a_rope_where_its_rim_stands_still(y, x, turn, side):
    stage = stage_of(SNATCHED, x=x, y=y, turn=turn)
    found = stage.ropes.get("standing pulley")
    assert (found is not None) == bool(side)
    if found:
        assert found[0].at.carrier is None and found[0].at.drawn[1] > stage.sketch.centre("pulley")[1]
        assert found[0].at.drawn[0] == pytest.approx(side * found[1].radius)
        assert [stop.at.carrier for stop in found[1:]] == ["pulley", "strand"][:1 + (side < 0)]


@pytest.mark.sweep
def test_no_bearing_stands_in_the_way_of_a_spring_where_other_letters_avoid_it():
    found = problem_of(PROBLEMS / "3_free_undamped/governor_linkage_at_rest.yaml")
    stage = letters.pleasing(found, compose.Scenery)
    assert letters.crowding(compose.Scenery(found.scene)) >= letters.crowding(stage) + 1
    (_, top), (_, sleeve), (_, foot) = (stage.sketch.pivot("right_arm").drawn, stage.sketch.centre("sleeve"),
                                        stage.bunches[0].one.drawn)
    assert top > sleeve > foot


def test_a_post_grows_from_the_nearest_one_of_its_body():
    stage = compose.Scenery(problem_of(PROBLEMS / "1_statics_and_energy/jib_crane_with_winch.yaml").scene)
    posts = [part.points for part in stage.looks["mast"].pieces if isinstance(part, Polyline)]
    winch = next(points for points in posts if points[-1][0] > 1.0)
    assert plane.distance(winch[0], winch[-1]) == pytest.approx(0.2 * stage.sketch.scale)


@pytest.mark.sweep
def test_members_stand_clear_of_what_hangs_on_those_above():
    for name in ("bars", "beams"):
        stage = compose.Scenery(problem_of(PROBLEMS.parent / f"vibcli/examples/{name}.yaml").scene)
        boxes = [extent(along(strip, stage.sketch)) for strip in stage.strips]
        assert len(boxes) > 2 and all(above[1] - below[3] > 20.0 for above, below in pairwise(boxes))


def test_a_pulley_in_a_rope_that_the_scene_names_hangs_in_no_other():
    found = problem("""
        parameters: {m: 12 kg, r: 0.2 m, g: 9.81 m/s^2}
        gravity: g
        bodies:
          pulley: {shape: disc, mass: m, radius: r, at: [0, 0], move: [0, y, y/r]}
          load: {mass: m, at: [r, 0.6 m], slide: {along: [0, 1], by: z}}
        constraints: {rope: {rope: [[-r, 1 m], {under: pulley}, load]}}
    """)
    assert list(compose.Scenery(found.scene).ropes) == ["rope"]


@pytest.mark.sweep
def test_single_lengths_are_drawn_otherwise_until_pulleys_stand_apart():
    for name in ("1_statics_and_energy/differential_hoist", "6_two_degrees/three_weights_two_pulleys"):
        found = problem_of(PROBLEMS / f"{name}.yaml")
        assert letters.crowding(compose.Scenery(found.scene)) > letters.ENOUGH
        assert letters.crowding(letters.pleasing(found, compose.Scenery)) <= letters.ENOUGH


@pytest.mark.parametrize("slope", ["0.3 m^-1", "40 m^-1", "{unit: m^-1}"])
def test_a_path_without_a_length_is_as_wide_as_high(slope):
    found = problem(f"""
        parameters: {{m: 2 kg, a: {slope}, g: 9.81 m/s^2}}
        gravity: g
        bodies: {{bead: {{mass: m, at: [0, 0], move: [x, a*x^2, 0]}}}}
    """)
    left, bottom, right, top = extent([part for part in draw(found) if getattr(part, "dashed", False)])
    assert 0.2 < (top - bottom) / (right - left) < 1.2


def test_an_arch_is_joined_to_the_pin_beside_it_and_to_none_on_it():
    for pin, count in ("[0, 0]", 1), ("[0, -R]", 0):
        drawn = draw(problem(f"""
            parameters: {{m: 2 kg, R: 0.3 m, a: 50 deg, g: 9.81 m/s^2}}
            gravity: g
            bodies: {{arch: {{shape: arch, mass: m, radius: R, half_angle: a, angle: -pi/2, at: [0, 0],
              pin: {{at: {pin}, by: q}}}}}}
        """))
        lines = [part for part in drawn if isinstance(part, Polyline)]
        arc, = [part.points for part in lines if part.width == 3.0]
        assert [part.points[::2] for part in lines].count((arc[0], arc[-1])) == count
