"""Springs with a gap, or that only push or only pull, show it; what runs over bodies leaves their arrows free."""

from itertools import pairwise
from pathlib import Path

import pytest
from support.overlaps import cross, crossed, touching
from support.scenes import kept_drawing_of, problem

from vibcli.drawing.animation import of_positions
from vibcli.drawing.canvas.primitives import ARROW, Circle, Hatch, LetterRuns, Polygon, Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.lettering import words
from vibcli.drawing.layout.space import Space
from vibcli.drawing.symbols.spring import between

ROOT = Path(__file__).parents[3]

SIGNS = {"": (0, 0, 0), ", acts: compression": (2, 0, 0), ", acts: compression, gap: a": (2, 0, 0),
         ", acts: tension": (0, 1, 0), ", acts: tension, gap: a": (0, 1, 0), ", gap: a": (0, 0, 1)}
REST = {"compression": 48.0, "tension": 36.0, None: 34.5}
PLACES = {"row": "slide: x", "plane": "at: [0, -1 m], slide: {along: [0, -1], by: x}"}


def spring(place, more):
    fixed = "ground" if place == "row" else "[0, 0]"
    drawn = draw(problem(f"""
        parameters: {{m: 2 kg, k: 900 N/m, a: {{value: 5 mm, unused: allowed}}}}
        bodies: {{p: {{mass: m, {PLACES[place]}}}}}
        springs: {{s: {{k: k, between: [{fixed}, p]{more}}}}}
        motion: full
    """))
    assert touching(drawn) == []
    return drawn


def along(points):
    """The places of points along a spring that is level or upright, in ascending order."""
    left, bottom, right, top = plane.bounds(points)
    return sorted(point[0 if right - left > top - bottom else 1] for point in points)


def sort_of(drawn):
    """What is drawn of a spring beside its coils: (plates, cords, slots)."""
    lines = [part for part in drawn if isinstance(part, Polyline)]
    return ([part for part in lines if part.role == "spring" and part.width > 1.5],
            [part for part in lines if part.role == "rope"],
            [part for part in drawn if isinstance(part, Polygon) and part.role == "spring"])


@pytest.mark.parametrize("place", PLACES)
def test_a_spring_that_only_pushes_ends_in_a_plate_one_that_only_pulls_in_a_cord_play_is_a_slot(place):
    counts = {more: tuple(map(len, sort_of(spring(place, more)))) for more in SIGNS}
    assert counts == SIGNS


@pytest.mark.parametrize("place", PLACES)
def test_a_gap_is_seen_and_named_as_a_length_is(place):
    for gap in ("", ", gap: a"):
        one, two = sort_of(spring(place, ", acts: compression" + gap))[0]
        assert (plane.distance(one.points[0], two.points[0]) > 8.0) == bool(gap)
        (cord,) = sort_of(spring(place, ", acts: tension" + gap))[1]
        length = sum(plane.distance(p, q) for p, q in pairwise(cord.points))
        assert (length > 1.15 * plane.distance(cord.points[0], cord.points[-1])) == bool(gap)
    for more in (", acts: compression, gap: a", ", acts: tension, gap: a", ", gap: a"):
        words = {part.runs[0].text: part.role for part in spring(place, more) if isinstance(part, LetterRuns)}
        assert words["a"] == "measure" and words["k"] == "ink"
    drawn = spring(place, ", gap: a")
    pin = next(part for part in drawn if isinstance(part, Circle) and part.fill == "ink")
    low, *_, high = along([*(slot := sort_of(drawn)[2][0].points), pin.centre])
    assert pin.centre == pytest.approx(plane.middle(*plane.corners(slot))) and high - low > 12.0


@pytest.mark.parametrize("record", [{"acts": "compression"}, {"acts": "tension"}, {}])
def test_in_motion_a_spring_is_strained_beyond_its_gap_alone(record):
    for moved in range(-16, 17):
        drawn = between({**record, "gap": 1}, (0.0, 0.0), (60.0 + moved, 0.0), 60.0)
        coils = next(part.points for part in drawn if isinstance(part, Polyline) and len(part.points) > 8
                     and part.role == "spring")
        plates, cords, slots = sort_of(drawn)
        strained = coils[-1][0] - coils[0][0] - REST[record.get("acts")]
        if plates:
            assert plates[0].points[0][0] <= plates[1].points[0][0] + 1e-9
            assert (strained < -1e-9) == (moved < -12)
        elif cords:
            assert (strained > 1e-9) == (moved > 8) and coils[-1] == cords[0].points[0]
        else:
            pin = next(part.centre for part in drawn if isinstance(part, Circle))
            assert (abs(strained) > 1e-9) == (abs(moved) > 6) and plane.inside(pin, list(slots[0].points))


def test_frames_of_a_motion_show_a_spring_strained_where_it_is():
    for place in PLACES:
        scene = problem(f"""
            parameters: {{m: 2 kg, k: 900 N/m, a: 30 cm}}
            bodies: {{p: {{mass: m, {PLACES[place]}}}}}
            springs: {{s: {{k: k, acts: tension, gap: a, between: [{"ground" if place == "row" else "[0, 0]"}, p]}}}}
            motion: full
        """)
        frames, *_ = of_positions(scene, [{"x": x} for x in (-0.1, 0.0, 0.29, 0.45)], [0.0, 1.0, 2.0, 3.0])
        coils = [next(along(part.points) for part in frame if isinstance(part, Polyline) and len(part.points) > 8
                      and part.role == "spring") for frame in frames]
        a, b, c, d = (points[-1] - points[0] for points in coils)
        assert a == pytest.approx(b) and b == pytest.approx(c) and d > c + 4.0


def test_the_arrow_of_a_coordinate_stands_beside_what_is_led_over_its_body():
    drawn = draw(problem("""
        parameters: {m: 2 kg, k: 900 N/m}
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}, c: {mass: m, slide: z}}
        springs: {s: {k: k, between: [a, b]}, t: {k: k, between: [b, c]}, u: {k: k, between: [a, c]}}
    """))
    arrows = [part.points for part in drawn if isinstance(part, Polyline) and part.layer == ARROW]
    legs = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "ink" and len(part.points) == 2
            and part.layer != ARROW]
    assert len(legs) == 2 and crossed(drawn) == touching(drawn) == []
    assert not [1 for arrow in arrows for leg in legs if cross(arrow, leg)]


def test_each_of_three_elements_side_by_side_has_its_name_at_it():
    drawn = draw(problem("""
        parameters: {m: 2 kg, k: 900 N/m, c: 3 N*s/m, b: 1 kg}
        bodies: {a: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, a]}}
        dampers: {d: {c: c, between: [ground, a]}}
        inerters: {i: {b: b, between: [ground, a]}}
    """))
    piston = next(part for part in drawn if part.role == "damper" and part.width > 1.5).points
    middle = (piston[0][1] + piston[-1][1]) / 2
    levels = {part.runs[0].text: (part.box[1] + part.box[3]) / 2 for part in drawn if isinstance(part, LetterRuns)}
    assert abs(levels["c"] - middle) < 15.0 < levels["k"] - levels["c"] and touching(drawn) == []


def test_a_radius_meets_no_arrow_of_a_coordinate_where_another_place_is_free():
    drawn = kept_drawing_of(ROOT / "problems/3_free_undamped/half_disc_in_track.yaml")
    arc, = [part.points for part in drawn
            if isinstance(part, Polyline) and part.role == "coordinate" and len(part.points) > 2]
    ray, = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"]
    assert min(plane.distance(p, q) for p in arc for q in (ray[0], ray[-1])) > 6.0


def test_words_keep_clear_of_the_edges_of_thick_lines():
    for thick, far in ((0.8, 0.8), (1.7, 1.7)):
        line = Polyline(((0.0, 0.1), (60.0, 0.1)), "load", thick)
        word = Space([line]).put(words("F0 saw(t)"), [(30.0, 1.2)])
        assert max(word.box[1] - 0.1, 0.1 - word.box[3]) > far


@pytest.mark.parametrize(("path", "noted"), [
    ("9_equivalents_and_corrections/ball_on_a_springboard", []), ("6_two_degrees/wing_section_in_wind", []),
    ("4_free_damped/crate_let_go_on_a_rough_slope", ["f"]), ("6_two_degrees/unround_shaft", ["first", "second"])])
def test_a_spring_that_is_said_to_stretch_as_a_body_moves_stands_on_a_wall_behind_it(path, noted):
    drawn = kept_drawing_of(ROOT / f"problems/{path}.yaml")
    lines = ["".join(run.text for run in part.runs) for part in drawn if isinstance(part, LetterRuns)]
    assert [line.split(":")[0] for line in lines if " on " in line] == noted and touching(drawn) == []
    if not noted:
        coils = next(part.points for part in drawn if isinstance(part, Polyline) and len(part.points) > 8
                     and part.role == "spring")
        wall = max((part for part in drawn if isinstance(part, Hatch)), key=lambda part: -part.points[0][1])
        assert wall.points[0][1] == pytest.approx(coils[0][1]) and coils[-1][1] > coils[0][1] + 20.0


def test_a_spring_that_would_lie_along_a_lever_stands_beside_it():
    drawn = draw(problem("""
        parameters: {L: 30 mm, a: 10 mm, k: 800 N/m, kt: 0.15 N*m}
        points: {tip: {body: lever, at: [0, L]}}
        bodies: {lever: {at: [0, L/2], pin: {at: [0, 0], by: phi}}}
        springs: {s: {k: k, between: [[0, -a], tip]}, t: {torsion: kt, between: [ground, lever]}}
    """))
    lever, = [part.points for part in drawn if isinstance(part, Polyline) and part.width == 2.4]
    coils = max((part.points for part in drawn if part.role == "spring"), key=lambda points: plane.distance(
        points[0], points[-1]))
    assert plane.distance(*lever) == pytest.approx(0.75 * plane.distance(coils[0], coils[-1]))
    assert min(x for x, _ in coils) > lever[0][0] + 10.0 and touching(drawn) == []


def test_the_line_of_a_radius_begins_beside_a_spiral():
    drawn = draw(problem("""
        parameters: {R: 1 m, m: 3 kg, kt: 20 N*m}
        bodies: {d: {shape: disc, radius: R, mass: m, at: [0, 0], pin: {by: phi}}}
        springs: {s: {torsion: kt, between: [ground, d]}}
    """))
    spiral = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "spring"]
    radius, = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"]
    assert spiral and not any(cross(line, radius) for line in spiral)
