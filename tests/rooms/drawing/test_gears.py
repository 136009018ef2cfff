"""Gears and racks of bodies without a place: those that turn against each other in a fixed ratio mesh."""

from math import pi
from pathlib import Path

import pytest
from support.overlaps import cross
from support.scenes import kept_drawing_of, problem

from vibcli.drawing.canvas.primitives import Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import compose, gears, lumped, plane
from vibcli.drawing.layout.lumped_place import LumpedPlace

SHAFTS = """
    parameters: {{J: 2 kg*m^2, kt: 30 N*m, r: 0.1 m, R: 0.25 m}}
    bodies:
      motor: {{inertia: J, turn: p}}
      pinion: {{inertia: J, turn: {pinion}}}
      wheel: {{inertia: J, turn: {wheel}}}
      load: {{inertia: J, turn: u}}
    springs:
      one: {{torsion: kt, between: [motor, pinion]}}
      two: {{torsion: kt, between: [wheel, load]}}
    {more}
"""
RACK = """
    parameters: {{J: 2 kg*m^2, m: 3 kg, k: 90 N/m, r: 0.1 m}}
    bodies:
      rod: {{mass: m, slide: x{looks}}}
      wheel: {{inertia: J, turn: x/r}}
    springs: {{s: {{k: k, between: [ground, rod]}}}}
"""


def scene_of(text, **fields):
    return problem(text.format(**fields)).scene


@pytest.mark.parametrize("pinion, wheel, more, ratio", [
    ("s", "-s*r/R", "", -0.4), ("s", "s*r/R", "", None), ("s", "-(s + u)*r/R", "", None),
    ("s", "w", "constraints: {g: {gear: [pinion, wheel], radii: [r, R]}}", -0.4),
    ("s", "w", "constraints: {g: {belt: [pinion, wheel], radii: [r, R], crossed: true}}", None)])
def test_what_turns_against_each_other_meshes(pinion, wheel, more, ratio):
    scene = scene_of(SHAFTS, pinion=pinion, wheel=wheel, more=more)
    (mesh,) = gears.meshes(scene) or [None]
    assert (mesh is None) == (ratio is None)
    if ratio is not None:
        assert {mesh.gear, mesh.mate} == {"pinion", "wheel"}
        assert mesh.ratio == pytest.approx(ratio if mesh.gear == "pinion" else 1 / ratio)


def test_gears_touch_one_above_the_other_and_their_sizes_are_as_their_radii():
    stage = compose.Scenery(scene_of(SHAFTS, pinion="s", wheel="-s*r/R", more=""))
    upper, lower = stage.rows
    pinion, wheel = upper.places["pinion"], lower.places["wheel"]
    assert pinion.middle[0] == pytest.approx(wheel.middle[0])
    assert pinion.middle[1] - pinion.height == pytest.approx(wheel.middle[1] + wheel.height)
    assert wheel.height / pinion.height == pytest.approx(2.5)
    boxes = [plane.bounds(plane.box(place.middle, 2 * place.half, 2 * place.height))
             for layout in stage.rows for place in layout.places.values()]
    for i, one in enumerate(boxes):
        for two in boxes[i + 1:]:
            wide, high = min(one[2], two[2]) - max(one[0], two[0]), min(one[3], two[3]) - max(one[1], two[1])
            assert min(wide, high) < 1e-6


TRAIN = """
    parameters: {{J: 2 kg*m^2, kt: 30 N*m}}
    bodies:
      one: {{inertia: J, turn: p}}
      two: {{inertia: J, turn: q}}
      three: {{inertia: J, turn: r}}
    springs: {{s: {{torsion: kt, between: [ground, three]}}}}
    constraints:
      first: {{{first}: [one, two], radii: [4 cm, 10 cm]}}
      second: {{{second}: [two, three], radii: [5 cm, 15 cm]{crossed}}}
"""


@pytest.mark.parametrize("first, second, crossed, pairs", [
    ("gear", "gear", "", [{"one", "two"}, {"two", "three"}]), ("belt", "belt", ", crossed: true", []),
    ("gear", "belt", "", [{"one", "two"}]), ("belt", "gear", "", [{"two", "three"}])])
def test_what_a_train_turns_against_each_other_meshes_where_it_gears(first, second, crossed, pairs):
    scene = scene_of(TRAIN, first=first, second=second, crossed=crossed)
    assert [{mesh.gear, mesh.mate} for mesh in gears.meshes(scene)] == pairs


def test_a_gear_between_two_touches_both():
    rows = compose.Scenery(scene_of(TRAIN, first="gear", second="gear", crossed="")).rows
    one, two, three = (places[name] for layout in rows for places in [layout.places] for name in places)
    for upper, lower, ratio in ((one, two, 2.5), (two, three, 3.0)):
        assert upper.middle[1] - upper.height == pytest.approx(lower.middle[1] + lower.height)
        assert lower.height / upper.height == pytest.approx(ratio)
        assert upper.middle[0] == pytest.approx(lower.middle[0])


@pytest.mark.parametrize("ratio", [-0.01, -1.0, -50.0])
def test_the_smaller_of_two_gears_can_be_seen(ratio):
    sizes = gears.radii(gears.Mesh("a", "b", ratio, False))
    assert sum(sizes) == pytest.approx(gears.SUM) and min(sizes) >= 0.2 * gears.SUM - 1e-9


def test_teeth_go_round_with_a_gear():
    place = LumpedPlace((0.0, 0.0), 6.0, 20.0, True, 1)
    levels = [sorted(line.points[0][1] for line in gears.edges(place, angle)) for angle in (0.0, 0.05, 2 * pi)]
    assert all(-20.0 <= level <= 20.0 for level in levels[1]) and levels[0] == pytest.approx(levels[2])
    assert levels[0] != pytest.approx(levels[1])


@pytest.mark.parametrize("looks, gear", [(", looks: bar", 2), ("", 0)])
def test_a_bar_that_a_gear_moves_is_a_rack(looks, gear):
    """A body that just moves as a rim does may as well hang on a rope."""
    stage = compose.Scenery(scene_of(RACK, looks=looks))
    layout = stage.rows[0]
    assert layout.places["rod"].gear == gear
    assert draw(problem(RACK.format(looks=looks)))
    if gear:
        still, moved = (lumped.draw(layout, {"rod": shift})[0] for shift in (0.0, 9.0))
        toothed = [[part.points for part in found if len(getattr(part, "points", ())) > 20] for found in (still, moved)]
        (rod, pinion), (rod_moved, pinion_moved) = toothed
        assert rod_moved[0][0] - rod[0][0] == pytest.approx(9.0)
        middle = plane.middle(*plane.corners(pinion))
        angles = [plane.heading(plane.minus(points[0], middle)) for points in (pinion, pinion_moved)]
        assert angles[1] - angles[0] == pytest.approx(9.0 / gears.PINION, rel=0.05)


HOIST = """
    parameters: {m: 3 kg, J: 1 kg*m^2, r: 0.2 m, k: 9 N*m}
    bodies: {drum: {inertia: J, turn: phi}, load: {mass: m, slide: r*phi%s}}
    springs: {s: {torsion: k, between: [ground, drum]}}
"""


@pytest.mark.parametrize("looks, ropes", [("", 1), (", looks: bar", 0)])
def test_what_a_drum_winds_up_is_tied_to_it_unless_it_is_a_rack(looks, ropes):
    scene = problem(HOIST % looks)
    assert gears.wound(scene.scene) == [("drum", "load")] * ropes
    lines = [part for part in draw(scene) if part.role == "rope"]
    assert len(lines) == ropes and all(part.dashed for part in lines)


@pytest.mark.parametrize("stretch, told", [("x", False), ("-x", False), ("2*x", True)])
def test_a_spring_that_is_stretched_otherwise_than_drawn_is_told_so(stretch, told):
    figure = draw(problem(f"""
        bodies: {{block: {{mass: 2 kg, slide: x}}}}
        springs: {{s: {{k: 30 N/m, stretch: {stretch}}}}}
    """))
    notes = ["".join(run.text for run in part.runs) for part in figure if part.role == "note"]
    assert any(part.role == "spring" for part in figure) and bool(notes) is told
    assert notes in ([], ["s: 30 N/m on 2x"])


def test_the_rope_of_a_drum_crosses_no_shaft():
    drawn = kept_drawing_of(Path(__file__).parents[3] / "vibcli/examples/geared_hoist.yaml")
    rope, = [part.points for part in drawn if part.role == "rope"]
    others = [part.points for part in drawn if isinstance(part, Polyline) and part.role != "rope"]
    away = plane.plus(*rope[:1], plane.minus(rope[1], rope[0]), 0.05), plane.plus(*rope[1:], (0.0, 1.0))
    assert len(others) > 5 and not [stroke for stroke in others if cross(away, stroke)]
