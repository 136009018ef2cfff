"""Words of figures touch neither one another nor lines, in all but two of a hundred figures at most; arrows cross
neither springs nor dampers nor masses nor dimension lines, nor do these cross springs or dampers; springs lead through
no floor."""

from itertools import pairwise
from pathlib import Path

import pytest
from support import overlaps
from support.overlaps import begun, cross, crossed, grounded, measured, struck, touching
from support.scenes import kept_drawing_of, problem

from vibcli.drawing.canvas.primitives import (
    ARROW,
    JOINT,
    LEADER,
    SURFACE,
    Circle,
    Hatch,
    LetterRuns,
    Polygon,
    Polyline,
    extent,
)
from vibcli.drawing.canvas.svg_canvas import MARGIN
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import lettering, plane
from vibcli.drawing.layout.space import Space
from vibcli.drawing.layout.strips import THICK
from vibcli.drawing.symbols import arrow, support
from vibcli.report.formats.html import READABLE

ROOT = Path(__file__).parents[3]
MOST = 0.02


@pytest.mark.sweep
def test_words_and_arrows_of_problems_and_examples_touch_nothing(monkeypatch):
    monkeypatch.setattr(overlaps, "CLOSE", 2.0)
    paths = sorted([*ROOT.glob("problems/[1-9]*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml")])
    figures = {path.stem: kept_drawing_of(path) for path in paths}
    assert len(figures) > 300
    found = {name: told for name, figure in figures.items() if (told := touching(figure))}
    assert len(found) <= MOST * len(paths), found
    for check in (crossed, measured, struck, grounded, begun):
        assert not {name: told for name, figure in figures.items() for told in [check(figure)] if told}


def test_a_word_that_touches_is_seen():
    word = lettering.text(lettering.named("m"), 10.0, 10.0)
    middle = (word.box[0] + word.box[2]) / 2, (word.box[1] + word.box[3]) / 2
    over, beside = Polyline(((0.0, middle[1]), (50.0, middle[1]))), Polyline(((0.0, 0.0), (50.0, 0.0)))
    assert touching([word, over, beside]) == [("m", "ink")]
    assert touching([word, Polyline(((middle[0], 0.0), (middle[0], 50.0)), "load")]) == [("m", "load")]
    assert touching([word, lettering.text(lettering.named("k"), *middle)]) == [("k", "m")]
    assert touching([word, lettering.text(lettering.named("k"), 100.0, 10.0), beside]) == []
    for gap, told in ((0.5, [("m", "ink")]), (1.5, [])):
        assert touching([word, Polyline(((word.box[2] + gap, 0.0), (word.box[2] + gap, 50.0)))]) == told


def test_an_arrow_that_crosses_is_seen():
    shaft = arrow.straight((0.0, 0.0), (30.0, 0.0), "load")
    spring = Polyline(((19.5, -5.0), (19.5, 5.0)), "spring")
    assert crossed([*shaft, spring]) == [("load", "spring")]
    assert crossed([*shaft, spring._replace(points=((19.5, 1.0), (19.5, 5.0)))]) == []
    assert crossed([*shaft, Circle((20.0, 0.0), 6.0, "body")]) == [("load", "ink")]
    assert crossed([*shaft, Circle((0.0, 0.0), 6.0, "body")]) == []             # from the body on which it acts
    assert crossed([*arrow.round_((0.0, 0.0), 20.0, 0.0, 2.0, "coordinate"), spring]) == []
    assert crossed([*arrow.round_((0.0, 0.0), 20.0, -2.0, 0.5, "coordinate"), spring]) == [("coordinate", "spring")]


def test_a_spring_through_the_floor_and_an_arrow_over_a_dimension_are_seen():
    floor = Hatch(((-20.0, 0.0), (20.0, 0.0)), -1)
    spring = Polyline(((0.0, 20.0), (0.0, 15.0), (3.0, 5.0), (-3.0, -5.0), (0.0, -15.0), (0.0, -20.0)), "spring")
    assert grounded([floor, spring]) == [("spring", "Hatch")]
    assert grounded([floor, spring._replace(points=tuple((x, y + 20.0) for x, y in spring.points))]) == []
    shaft, line = arrow.straight((0.0, 0.0), (30.0, 0.0), "load"), Polyline(((20.0, -9.0), (20.0, 9.0)), "measure")
    assert measured([*shaft, line]) == ["load"]
    assert measured([*shaft, line._replace(points=((0.0, -9.0), (0.0, 9.0)))]) == []


@pytest.mark.parametrize("angle", [20, 50, 90])
def test_rollers_and_floor_of_a_slider_stand_beside_the_springs_that_lead_down(angle):
    drawn = draw(problem(f"""
        parameters: {{m: 2 kg, k: 900 N/m, l: 1 m, a: {angle} deg}}
        bodies: {{p: {{mass: m, at: [0, 0], slide: x}}}}
        springs:
          s: {{k: k, between: [[-l*cos(a), -l*sin(a)], p]}}
          t: {{k: k, between: [[l*cos(a), l*sin(a)], p]}}
    """))
    rollers = [part.centre[0] for part in drawn if isinstance(part, Circle) and part.radius == support.ROLLER]
    box = next(part for part in drawn if isinstance(part, Polygon) and part.fill == "body")
    assert len(rollers) == 2 and plane.bounds(box.points)[0] < min(rollers) < max(rollers) < plane.bounds(box.points)[2]
    assert [part for part in drawn if isinstance(part, Hatch) and part.layer == SURFACE] and grounded(drawn) == []


def test_a_spring_lies_above_the_floor_on_which_a_ladder_slides():
    drawn = draw(problem("""
        parameters: {m: 8 kg, k: 900 N/m, a: 1 m, b: 2 m, g: 9.81 m/s^2}
        gravity: g
        points: {foot: {body: rod, at: [0, 0]}, head: {body: rod, at: [a, b]}}
        surfaces: {floor: {line: [[0, 0], [a, 0]]}, wall: {line: [[a, 0], [a, b]]}}
        bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [a, b], move: [x, y, phi]}}
        springs: {s: {k: k, between: [foot, [a, 0]], preload: static}}
        constraints: {low: {point: foot, surface: floor}, high: {point: head, surface: wall}}
    """))
    assert grounded(drawn) == [] and [1 for part in drawn if isinstance(part, Hatch) and part.layer == SURFACE]


@pytest.mark.sweep
def test_a_bed_is_open_where_springs_lead_through_it():
    drawn = kept_drawing_of(ROOT / "vibcli/examples/beams.yaml")
    small = [part for part in drawn if isinstance(part, Polyline) and part.role == "spring" and part.width < 1.0]
    assert grounded(drawn) == [] and len(small) == 6


def test_the_names_of_a_spring_and_a_damper_at_one_place_stand_on_their_own_sides():
    drawn = draw(problem("""
        parameters: {L: 2 m, EI: 4 kN*m^2, mu: 2 kg/m, k: 900 N/m, c: 3 N*s/m}
        beams: {b: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {k: k, c: c}}}
    """))
    words = {_text(part): part.box for part in drawn if isinstance(part, LetterRuns)}
    for name, role, sense in (("k", "spring", -1), ("c", "damper", 1)):
        middle = [x for part in drawn if part.role == role for x, _ in part.points]
        assert sense * ((words[name][0] + words[name][2]) - (min(middle) + max(middle))) > 0


def test_the_name_of_a_body_stands_in_no_other_on_which_it_does_not_lie():
    drawn = kept_drawing_of(ROOT / "vibcli/examples/roller_between_plates.yaml")
    small, = [part for part in drawn if isinstance(part, LetterRuns) and _text(part) == "m" and part.box[0] > 150.0]
    bodies = [part.points for part in drawn if isinstance(part, Polygon) and part.fill == "body"]
    boxes = [points for points in bodies if len(points) == 4]
    assert boxes and not [box for box in boxes if plane.inside(plane.middle(small.box[:2], small.box[2:]), box)]


def test_dry_friction_is_no_dashpot():
    for kind, count in (("friction: R", 0), ("c: R", 1)):
        drawn = draw(problem(f"""
            parameters: {{m: 2 kg, k: 900 N/m, R: 3 {"N" if "f" in kind else "N*s/m"}}}
            bodies: {{p: {{mass: m, slide: x}}}}
            springs: {{s: {{k: k, between: [ground, p]}}}}
            dampers: {{d: {{{kind}, between: [ground, p]}}}}
        """))
        pistons = [part for part in drawn if part.role == "damper" and isinstance(part, Polyline) and part.width > 1.5]
        assert len(pistons) == count and "R" in [_text(part) for part in drawn if isinstance(part, LetterRuns)]


def _text(word):
    return "".join(run.text for run in word.runs)


def test_words_on_one_line_stand_apart_and_names_of_members_make_room():
    drawn = draw(problem("""
        parameters: {L: 30 m, EI: 80 MN*m^2, mu: 250 kg/m, M: 9000 kg, m: 1400 kg}
        beams: {wing: {length: L, EI: EI, mass_per_length: mu,
          attached: [{at: L/2, mass: M}, {at: L/4, mass: m}, {at: 3*L/4, mass: m}]}}
    """))
    words = [part for part in drawn if isinstance(part, LetterRuns)]
    for i, one in enumerate(words):
        for other in words[:i]:
            if min(one.box[3], other.box[3]) > max(one.box[1], other.box[1]):
                assert max(one.box[0], other.box[0]) - min(one.box[2], other.box[2]) > 5.0


def test_loads_of_bars_lie_beside_these_where_a_damper_follows():
    drawn = draw(problem("""
        parameters: {L: 1 m, EA: 4 kN, mu: 0.6 kg/m, c: 25 N*s/m, F: 60 N}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, right: {c: c}}}
        points: {end: {body: rod, at: L}}
        forces: {pull: {at: end, force: F}}
    """))
    first = min(x for part in drawn if part.role == "damper" for x, _ in part.points)
    load = [x for part in drawn if part.role == "load" and not isinstance(part, LetterRuns) for x, _ in part.points]
    assert max(load) <= first + 1e-9


def test_arcs_of_a_joint_meet_no_arrow():
    drawn = kept_drawing_of(ROOT / "problems/8_continuous/portal_frame.yaml")
    paths = [part.points for part in drawn
             if isinstance(part, Polyline) and part.role == "coordinate" and part.layer == ARROW]
    crossing = [(a, b) for i, a in enumerate(paths) for b in paths[:i] if cross(a, b) and not set(a) & set(b)]
    assert not [pair for pair in crossing if any(len(path) > 2 for path in pair)]


def test_arcs_begin_at_no_spring_that_is_wound_about_a_rod():
    """Nor between two of its coils, where it meets none of their strokes; near the joint there are none."""
    drawn = kept_drawing_of(ROOT / "vibcli/examples/bead_on_a_turning_rod.yaml")
    arcs = [part for part in drawn if isinstance(part, Polyline) and part.role == "driven" and len(part.points) > 2]
    spring, = [part.points for part in drawn if part.role == "spring"]
    assert len(arcs) == 1 and begun(drawn) == []
    middle = plane.middle(spring[6], spring[7])
    assert begun([*drawn, arcs[0]._replace(points=(middle, *arcs[0].points))]) == ["driven"]


def test_a_name_stands_in_the_middle_of_a_body_through_which_a_rod_leads_behind_it():
    drawn = kept_drawing_of(ROOT / "vibcli/examples/bead_on_a_turning_rod.yaml")
    bead, = [part for part in drawn if isinstance(part, Polygon) and part.fill == "body" and len(part.points) == 4]
    name, = [part.box for part in drawn if isinstance(part, LetterRuns) and _text(part) == "m"]
    assert plane.distance(plane.middle(name[:2], name[2:]), plane.middle(*plane.corners(bead.points))) < 1.0
    assert touching(drawn) == []
    before = [part._replace(layer=ARROW) for part in drawn if part.layer < bead.layer]
    assert ("m", "ink") in touching([*drawn, *before])


def test_a_corner_of_a_frame_is_no_thicker_than_its_members():
    drawn = kept_drawing_of(ROOT / "problems/8_continuous/portal_frame.yaml")
    boxes = [plane.bounds(part.points) for part in drawn if isinstance(part, Polygon) and part.fill == "body"]
    assert len(boxes) == 5 and max(min(right - left, top - low) for left, low, right, top in boxes) < 2 * THICK + 1e-6


def test_the_head_of_an_arc_touches_no_tick_of_another_arrow():
    drawn = kept_drawing_of(ROOT / "problems/6_two_degrees/unround_shaft.yaml")
    head, = [part.strokes()[0] for part in drawn if isinstance(part, Polygon) and part.role == "driven"]
    marks = [stroke for part in drawn if part.role == "coordinate" and not isinstance(part, LetterRuns)
             for stroke in part.strokes()]
    assert marks and not [1 for mark in marks if cross(head, mark)]
    assert min(plane.distance(a, b) for a in head for mark in marks for b in mark) > 3.0


def test_leaders_of_two_lengths_lie_on_one_another_and_the_longer_stands_outside():
    drawn = kept_drawing_of(ROOT / "vibcli/examples/boom_on_a_spring.yaml")
    lines = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"
             and part.layer == ARROW and part.width > 0.6]
    assert len(lines) == 2 and measured(drawn) == []


@pytest.mark.parametrize(("turn", "sense"), [("-phi", -1), ("phi/2", 1)])
def test_the_arrow_of_a_coordinate_turns_as_the_body_does_about_its_joint(turn, sense):
    drawn = draw(problem(f"""
        coordinates: [phi]
        parameters: {{m: 2 kg, L: 1 m, k: 9 N*m}}
        bodies: {{rod: {{shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {{at: [0, 0], by: {turn}}}}}}}
        springs: {{s: {{torsion: k, between: [ground, rod]}}}}
    """))
    arc, = [part.points for part in drawn
            if isinstance(part, Polyline) and part.role == "coordinate" and len(part.points) > 2]
    assert abs(arc[0][1]) < 1e-9 < sense * arc[-1][1]


def test_a_rod_that_lies_on_a_pier_has_a_bearing_there():
    drawn = kept_drawing_of(ROOT / "problems/1_statics_and_energy/gerber_bridge_with_crane.yaml")
    rollers = [part.centre[0] for part in drawn if isinstance(part, Circle) and part.radius == 2.0]
    floors = [part for part in drawn if isinstance(part, Hatch) and part.layer == SURFACE]
    assert len(rollers) == 4 and len(floors) == 2


def test_a_load_leaves_what_is_welded_where_it_acts():
    drawn = kept_drawing_of(ROOT / "problems/4_free_damped/galloping_sign_arm.yaml")
    shaft, = [part.points for part in drawn if part.role == "load" and isinstance(part, Polyline)]
    tops = [plane.bounds(part.points)[3] for part in drawn
            if isinstance(part, Polygon) and part.fill == "body" and plane.inside((shaft[0][0], 0), list(part.points))]
    assert abs(shaft[0][1] - max(tops)) < 0.5 and crossed(drawn) == []


def test_the_name_of_a_disc_stands_at_it_beside_a_rod_that_hangs_before_it():
    drawn = kept_drawing_of(ROOT / "problems/6_two_degrees/disc_in_track_with_rod.yaml")
    track, = [part for part in drawn if isinstance(part, Hatch) and part.layer == SURFACE]
    name, = [part for part in drawn if isinstance(part, LetterRuns) and _text(part) == "m1"]
    assert touching(drawn) == [] and name.box[1] > min(y for _, y in track.points)


@pytest.mark.parametrize(("path", "lengths"), [
    ("problems/4_free_damped/lever_on_shaking_floor.yaml", ["L", "b", "d"]),
    ("problems/1_statics_and_energy/planet_gear_with_arm.yaml", ["r"]),
    ("problems/6_two_degrees/epicyclic_gear_with_sprung_ring.yaml", ["R", "rp", "rs"]),
    ("vibcli/examples/beams.yaml", ["3L1/2", "H", "L", "L1", "L1/2"])])
def test_lengths_that_find_no_room_stand_further_off_and_radii_at_another_angle(path, lengths):
    drawn = kept_drawing_of(ROOT / path)
    told = [_text(part) for part in drawn if isinstance(part, LetterRuns) and part.role == "measure"]
    assert sorted(told) == lengths and touching(drawn) == measured(drawn) == crossed(drawn) == []


@pytest.mark.parametrize("path", [
    "6_more_degrees/car_with_seat_by_assumed_shapes", "5_forced/seismograph_with_level_boom",
    "6_two_degrees/disc_on_seesaw", "4_free_damped/sagging_boom", "4_free_damped/seismograph_boom",
    "6_two_degrees/particle_on_turning_disc", "3_free_undamped/inverted_pendulum_between_springs"])
def test_lines_of_lengths_pass_through_no_spring_dashpot_or_bearing(path):
    drawn = kept_drawing_of(ROOT / f"problems/{path}.yaml")
    lines = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"
             and part.layer == ARROW]
    bearings = [part for part in drawn if isinstance(part, Polygon) and part.layer == JOINT - 1]
    assert struck(drawn) == touching(drawn) == []
    assert not [1 for line in lines for bearing in bearings if cross(line, bearing.strokes()[0])]


@pytest.mark.parametrize("share", [1.0, 0.6])
def test_a_length_between_springs_on_both_sides_is_measured_beyond_them(share):
    drawn = draw(problem(f"""
        parameters: {{m: 2 kg, k: 900 N/m, h: 1 m}}
        points: {{top: {{body: rod, at: [0, h]}}}}
        bodies: {{rod: {{shape: rod, mass: m, from: [0, 0], to: [0, {1 / share}*h], pin: phi}}}}
        springs: {{s: {{k: k, between: [[-2*h, h], top]}}, t: {{k: k, between: [[2*h, h], top]}}}}
    """))
    lines = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"
             and part.layer == ARROW]
    walls = [x for part in drawn if isinstance(part, Hatch) for x, _ in part.points]
    assert lines and struck(drawn) == crossed(drawn) == touching(drawn) == []
    assert any(not min(walls) < line[0][0] < max(walls) for line in lines)


def test_a_radius_begins_beside_the_spiral_about_its_centre():
    drawn = kept_drawing_of(ROOT / "vibcli/examples/belt_drive.yaml")
    spiral, = [part.points for part in drawn if part.role == "spring" and len(part.points) > 50]
    radius, = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"]
    assert not cross(radius, spiral)


@pytest.mark.parametrize("wide", [0.15, 0.25, 0.3, 0.5])
def test_the_arc_of_a_plate_leaves_it_at_its_beginning_or_ends_in_it(wide):
    drawn = draw(problem(f"""
        parameters: {{m: 2 kg, L: 1 m, g: 9.81 m/s^2}}
        gravity: g
        bodies: {{plate: {{shape: rectangle, mass: m, width: {wide}*L, height: L, at: [0, -L/2],
          pin: {{at: [0, 0], by: phi}}}}}}
    """))
    assert [part for part in drawn if part.role == "coordinate"] and crossed(drawn) == touching(drawn) == []


def test_no_line_crosses_another_between_two_cells():
    one = Polyline(((0.3, 0.2), (40.1, 39.7)), "spring")
    space = Space([one])
    for shift in (0.0, 0.9, 1.7):
        assert space.meets([(0.0, 40.0 + shift), (40.0 + shift, 0.0)]) > 0.0


def test_lengths_beside_each_other_are_read_at_their_own_lines():
    """What stands upright has its letter on the far side of what it measures; L is not between the lines of a and L."""
    figure = kept_drawing_of(ROOT / "vibcli/examples/hanging_rod.yaml")
    boxes = {"".join(run.text for run in part.runs): part.box for part in figure if isinstance(part, LetterRuns)}
    lines = sorted({round(part.points[0][0], 3) for part in figure if isinstance(part, Polyline) and
                    part.role == "measure" and part.points[0][0] == part.points[-1][0]})
    outer, inner = lines[0], lines[-1]
    assert boxes["L"][2] < outer < boxes["a"][0] and boxes["a"][2] < inner


@pytest.mark.sweep
def test_a_name_stands_in_no_way_of_a_length():
    """The line from the place of what is attached at L₁/2 reaches the beam: the name of the beam is elsewhere."""
    legs = [part for part in kept_drawing_of(ROOT / "vibcli/examples/beams.yaml")
            if isinstance(part, Polyline) and part.role == "measure" and part.layer == LEADER]
    assert len(legs) > 6 and min(plane.distance(*leg.points) for leg in legs) > 8.0


def test_a_wall_of_a_spiral_is_where_no_member_is():
    """It is above the hub, whose arm comes from the left, as is the wall of one without an arm."""
    figure = kept_drawing_of(ROOT / "vibcli/examples/arm_on_a_hub.yaml")
    arm = max((part for part in figure if isinstance(part, Polygon)), key=lambda part: plane.bounds(part.points)[2])
    walls = [part for part in figure if isinstance(part, Hatch) and part.points[0][0] > 0]
    top = max(max(y for _, y in part.points) for part in walls)
    assert top > plane.bounds(arm.points)[3]


def test_an_arc_begins_at_no_tip_of_another_arrow():
    drawn = kept_drawing_of(ROOT / "problems/8_continuous/portal_frame.yaml")
    arrows = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "coordinate"]
    arcs, shafts = ([points for points in arrows if (len(points) > 2) == arc] for arc in (True, False))
    assert (len(arcs), len(shafts)) == (2, 8)
    assert min(plane.distance(arc[0], place) for arc in arcs for shaft in shafts for place in shaft) > 8.0


@pytest.mark.parametrize("path", ["problems/7_forced_two_degrees/car_over_a_bump_with_both_axles.yaml",
                                  "problems/3_free_undamped/eccentric_cylinder.yaml"])
def test_the_arrow_of_gravity_makes_no_wide_figure_wider(path):
    drawn = kept_drawing_of(ROOT / path)
    name, = [part for part in drawn if isinstance(part, LetterRuns) and _text(part).startswith("g")]
    others = extent([part for part in drawn if part is not name])
    assert name.box[2] <= others[2] + 1e-9 < others[0] + 424.0 and touching(drawn) == crossed(drawn) == []


def test_the_name_of_a_damper_stands_beside_it_above_that_of_the_support_that_moves_it():
    drawn = kept_drawing_of(ROOT / "problems/5_forced/trailer_over_a_half_sine_bump.yaml")
    words = {_text(part): part.box for part in drawn if isinstance(part, LetterRuns)}
    heights = [y for part in drawn if part.role == "damper" for _, y in part.points]
    assert min(heights) < words["c"][1] < words["c"][3] < max(heights) and words["wheel"][3] < words["c"][1]


@pytest.mark.sweep
@pytest.mark.parametrize("path", ["1_statics_and_energy/toggle_press", "3_free_undamped/drum_on_a_slope_with_a_cord"])
def test_names_keep_clear_of_pins_and_bearings(path, monkeypatch):
    monkeypatch.setattr(overlaps, "CLOSE", 2.0)
    assert touching(kept_drawing_of(ROOT / f"problems/{path}.yaml")) == []


def test_the_name_of_a_rod_stands_at_no_bead_on_it():
    words = {_text(part): part.box for part in kept_drawing_of(ROOT / "problems/2_lagrange/bead_on_swinging_rod.yaml")
             if isinstance(part, LetterRuns)}
    assert abs(words["M"][1] - words["m"][1]) > 25.0


def test_a_train_of_ten_waggons_is_seen_whole_on_a_narrow_screen_with_all_names_on_one_line():
    """328 pixels are what a telephone of 360 has for it, READABLE ones those of its letters."""
    drawn = kept_drawing_of(ROOT / "vibcli/examples/many_modes.yaml")
    left, _, right, _ = extent(drawn)
    assert (right - left + 2 * MARGIN) * READABLE / lettering.SIZE < 328.0
    names = [part for part in drawn if isinstance(part, LetterRuns) and part.role == "coordinate"]
    assert len(names) == 10 and len({round(name.box[1], 3) for name in names}) == 1 and touching(drawn) == []
    wheels = [part for part in drawn if isinstance(part, Circle)]
    assert all(plane.distance(a.centre, b.centre) > a.radius + b.radius for a, b in pairwise(wheels))
