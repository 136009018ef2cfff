"""What bodies without a shape are drawn as: frames about what is in them, storeys, tubes of liquid, cams; `looks`."""

from pathlib import Path
from textwrap import dedent

import pytest
from support.overlaps import crossed
from support.scenes import kept_drawing_of, problem

from vibcli.api.load import loads
from vibcli.base.errors import SpecError
from vibcli.drawing.canvas.primitives import Circle, Hatch, LetterRuns, Polygon, Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import compose, lumped, plane

EXAMPLES = Path(__file__).parents[3] / "vibcli/examples"
BOX = """
    parameters: {{m: 3 kg, k: 900 N/m}}
    points:
      P: {{body: box, at: [-0.4 m, 0.5 m]}}
      Q: {{body: box, at: [0.4 m, 0.5 m]}}
      R: {{body: box, at: [0, -0.5 m]}}
    bodies:
      box: {{mass: m, at: [0, -0.5 m], slide: {{along: [0, 1], by: y}}{looks}}}
      tub: {{mass: m, at: [{x}, 0], slide: {{along: [0, 1], by: z}}}}
    springs:
      left: {{k: k, between: [P, tub]}}
      right: {{k: k, between: [Q, tub]}}
      foot: {{k: k, between: [[0, -1 m], R]}}
"""
STOREYS = """
    parameters: {{m: 3 Mg, k: 2 MN/m, c: 9 kN*s/m, Y: 3 mm, W: 9 rad/s}}
    bodies:{base}
      lower: {{mass: m, slide: x1, looks: frame}}
      upper: {{mass: m, slide: x2{looks}}}
    springs:
      s1: {{k: k, between: [{ground}, lower]}}
      s2: {{k: k, between: [lower, upper]}}
    dampers: {{d: {{c: c, between: [{ends}]}}}}
"""
TUBE = """
    parameters: {m: 2 kg, K: 40 N/m, P: 3 N}
    bodies: {column: {mass: m, slide: x, looks: tube}}
    energies: {V: K*x^2/2}
    forces: {push: {at: column, force: P}}
"""
CAM = """
    parameters: {m: 2 kg, k: 4 kN/m, h: 3 mm, W: 20 rad/s}
    bodies:
      foot: {at: [0, 0], slide: {along: [0, 1], by: h*sin(W*t)}, looks: cam}
      valve: {mass: m, at: [0, 0.3 m], slide: {along: [0, 1], by: y}}
    springs: {rod: {k: k, between: [foot, valve]}}
"""


def stage_of(text, **fields):
    return compose.Scenery(problem(text.format(**fields) if fields else text).scene)


def storeys(**changed):
    fields = {"base": "", "looks": ", looks: frame", "ground": "ground", "ends": "ground, lower"} | changed
    text = STOREYS.format(**fields)
    return text if fields["base"] else text.replace(", Y: 3 mm, W: 9 rad/s", "")


@pytest.mark.parametrize("x, kind", [("0", "frame"), ("0.9 m", "block")])
def test_a_frame_stands_about_what_is_in_it(x, kind):
    look = stage_of(BOX, x=x, looks="").looks["box"]
    assert look.kind == kind


def test_all_that_a_frame_carries_is_on_it():
    stage = stage_of(BOX, x="0", looks="")
    outline = stage.looks["box"].pieces[0].points
    for place in stage.ties.carried["box"]:
        assert min(plane.distance(place, plane.nearest_on(place, a, b))
                   for a, b in zip(outline, (*outline[1:], outline[0]), strict=True)) < 1e-6


@pytest.mark.parametrize("word", ["bar", "slab", "frame"])
def test_a_body_looks_as_it_says(word):
    stage = stage_of(BOX, x="0.9 m", looks=f", looks: {word}")
    look = stage.looks["box"]
    left, bottom, right, top = plane.bounds(look.pieces[0].points)
    assert look.kind == word
    for x, y in stage.ties.carried["box"]:
        assert left <= x <= right and bottom <= y <= top


def test_looks_change_no_result():
    plain, named = (loads(dedent(BOX.format(x="0", looks=looks))) for looks in ("", ", looks: slab"))
    for answer in ("omega[1]", "omega[2]", "equation[y]", "T", "V"):
        assert str(plain[answer].value) == str(named[answer].value)


@pytest.mark.parametrize("changed, kind", [
    ({}, "frame"), ({"ends": "lower, upper"}, "frame"), ({"looks": ""}, "row"), ({"ends": "ground, upper"}, "row"),
    ({"base": "\n      base: {slide: Y*sin(W*t)}", "ground": "base", "ends": "lower, upper"}, "frame")])
def test_storeys_stand_on_columns(changed, kind):
    """Where each is joined to the next alone; otherwise the bodies stand in a row."""
    text = storeys(**changed)
    (layout,) = stage_of(text.replace("{{", "{")).rows
    assert layout.kind == kind
    assert draw(problem(text))


def test_the_lower_storey_stands_below_and_columns_follow_the_girders():
    (layout,) = stage_of(storeys()).rows
    assert layout.y < layout.places["lower"].middle[1] < layout.places["upper"].middle[1]
    for shift in (0.0, 12.0):
        found, where = lumped.draw(layout, {"upper": shift})
        girders = [part for part in found if isinstance(part, Polygon) and part.fill == "body"]
        columns = [part.points for part in found if type(part).__name__ == "Polyline" and len(part.points) > 5
                   and part.width > 2]
        assert len(columns) == 4 and set(where) == {"s1", "s2", "d"}
        heads = [points[-1][0] for points in columns if points[-1][1] > layout.places["upper"].middle[1] - 20]
        assert sum(heads) / 2 == pytest.approx(layout.places["upper"].middle[0] + shift)
        assert len(girders) == 2


def test_shaken_ground_moves_below_the_storeys():
    text = storeys(base="\n      base: {slide: Y*sin(W*t)}", ground="base", ends="lower, upper")
    (layout,) = stage_of(text).rows
    assert layout.places["base"].middle[1] < layout.places["lower"].middle[1]
    found = lumped.draw(layout, {})[0]
    assert [part.role for part in found if isinstance(part, Hatch)] == ["driven"]


def test_shaken_ground_in_a_row_is_no_cart():
    text = storeys(base="\n      base: {slide: Y*sin(W*t)}", ground="base", ends="lower, upper", looks="")
    (layout,) = stage_of(text).rows
    wheels = [part for part in lumped.draw(layout, {})[0] if isinstance(part, Circle)]
    assert layout.kind == "row" and len(wheels) == 4


def test_liquid_rises_in_one_leg_as_it_falls_in_the_other():
    (layout,) = stage_of(TUBE).rows
    still, moved = (lumped.draw(layout, {"column": shift})[0][0].points for shift in (0.0, 10.0))
    assert layout.kind == "tube" and draw(problem(TUBE))
    assert max(x[1] for x in moved) == pytest.approx(max(x[1] for x in still) + 10.0)
    assert moved[0][1] == pytest.approx(still[0][1] - 10.0)
    assert plane.area(moved) == pytest.approx(plane.area(still))


def test_a_cam_lies_under_what_it_lifts_and_runs_about_a_bearing():
    stage = stage_of(CAM)
    look, foot = stage.looks["foot"], stage.sketch.centre("foot")
    assert look.kind == "cam" and plane.corners(look.pieces[0].points)[1][1] == pytest.approx(foot[1], abs=1e-3)
    assert draw(problem(CAM))


ECCENTRIC = """
    parameters: {e: 30 mm, h: 40 mm, rho: 'sqrt(e^2 + h^2)'}
    coordinates: [phi, y]
    bodies:
      cam: {mass: 2 kg, inertia: 0.01 kg*m^2, at: [e, 0], pin: {at: [0, 0], by: phi}, looks: cam}
      follower: {mass: 1 kg, at: [0, h], slide: {along: [0, 1], by: y}}
    springs: {s: {k: 900 N/m, between: [follower, [0, 2*h]]}, t: {torsion: 9 N*m, between: [ground, cam]}}
    constraints: {contact: '(e*cos(phi))^2 + (h + y - e*sin(phi))^2 = rho^2'}
"""


def test_an_eccentric_cam_touches_its_roller_wherever_it_is():
    stage = stage_of(ECCENTRIC)
    discs = {name: look.outlines[0].points for name, look in stage.looks.items()}
    radii = {name: plane.distance(*plane.corners(points)) / 8**0.5 for name, points in discs.items()}
    for turn in (0.0, 0.3, -0.4):
        sketch = stage.at({"phi": turn})
        centres = {name: sketch.frames[name].point(plane.middle(*plane.corners(points)))
                   for name, points in discs.items()}
        apart = plane.distance(centres["cam"], centres["follower"])
        assert apart == pytest.approx(radii["cam"] + radii["follower"], rel=1e-3)
        assert plane.distance(centres["cam"], (0.0, 0.0)) == pytest.approx(0.03 * sketch.scale)
    assert crossed(draw(problem(ECCENTRIC))) == []


def test_a_cam_on_which_nothing_rolls_is_a_disc_about_its_pin():
    look = stage_of("""
        bodies: {cam: {mass: 2 kg, inertia: 1 kg*m^2, at: [1 m, 0], pin: {at: [0, 0], by: phi}, looks: cam}}
        springs: {t: {torsion: 9 N*m, between: [ground, cam]}}
    """).looks["cam"]
    assert plane.inside((0.0, 0.0), look.outlines[0].points)


@pytest.mark.parametrize("body, message, hint", [
    ("{mass: 2 kg, slide: x, looks: plate}", "bar, slab, frame, tube or cam", ""),
    ("{mass: 2 kg, slide: x, looks: slab}", "cannot look like a slab", "at: [x, y]"),
    ("{inertia: 2 kg*m^2, turn: x, looks: frame}", "cannot look like a frame", "leave `looks` out"),
    ("{mass: 2 kg, at: [0, 0], slide: x, looks: tube}", "no column of liquid", "no place"),
    ("{mass: 2 kg, slide: x, looks: cam}", "neither lifted by a cam nor one", "slide: {along"),
    ("{mass: 2 kg, shape: disc, radius: 1 m, at: [0, 0], slide: x, looks: slab}", "'looks'", "")])
def test_looks_that_do_not_fit(body, message, hint):
    with pytest.raises(SpecError) as caught:
        problem(f"bodies:\n  a: {body}\n")
    (found,) = caught.value.diagnostics
    assert message in found.message and hint in (found.hint or "")
    assert found.where[1] == 2 and found.where[2] in (body.index("looks") + 6, body.index("looks") + 13)


INCLINE = """
    parameters: {{m: 2 kg, k: 90 N/m, r: 0.1 m}}
    surfaces: {{plane: {{line: [[0, 0], [1.6 m, 1.2 m]]}}}}
    bodies:
      block: {{mass: m, at: [0.8 m, 0.6 m], slide: {{by: x, surface: plane}}}}
      {other}
    springs: {{s: {{k: k, between: [[1.6 m, 1.2 m], block]}}}}
"""


@pytest.mark.parametrize("other", ["", "disc: {shape: disc, mass: m, radius: r, at: [0.34 m, 0.38 m],"
                                       " roll: {surface: plane, travel: s}}"])
def test_a_block_rests_on_its_surface(other):
    """The surface is drawn under the block, unless something rolls on it, which touches the line itself."""
    text = INCLINE.format(other=other)
    stage = compose.Scenery(problem(text if other else text.replace(", r: 0.1 m", "")).scene)
    corners = stage.looks["block"].core
    ground = [part for part in compose.primitives(stage, stage.sketch)[0] if isinstance(part, Hatch)
              and abs(part.points[0][0] - part.points[1][0]) > 30]
    (a, b) = ground[0].points
    distances = [plane.across(plane.unit(plane.minus(b, a)), plane.minus(corner, a)) for corner in corners]
    assert sorted(map(abs, distances))[:2] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert min(distances) > -1e-6
    middle = plane.middle(corners[0], corners[2])
    assert (plane.distance(middle, stage.sketch.centre("block")) < 1e-6) == (not other)


def test_parts_keep_their_masses():
    found = draw(problem("""
        parameters: {M: 3 kg, n: 1 kg, g: 9.81 m/s^2}
        gravity: g
        bodies:
          p:
            parts: [{shape: rod, mass: n, from: [0, 0], to: [0, -1 m]},
                    {shape: disc, mass: M, radius: 0.2 m, at: [0, -1 m]}]
            pin: {at: [0, 0], by: phi}
    """))
    names = ["".join(run.text for run in part.runs) for part in found if isinstance(part, LetterRuns)]
    assert {"M", "n"} <= set(names) and "p" not in names


def test_a_cart_has_room_for_what_rolls_on_it():
    drawn = kept_drawing_of(EXAMPLES / "roller_on_a_cart.yaml")
    deck, roller = sorted((part.points for part in drawn if isinstance(part, Polygon) and part.fill == "body"), key=len)
    deck, roller = plane.bounds(deck), plane.bounds(roller)
    assert deck[0] < roller[0] < roller[2] < deck[2] and roller[1] == pytest.approx(deck[3], abs=0.1)


def test_the_name_of_a_block_stands_beside_the_unbalance_in_it():
    drawn = kept_drawing_of(EXAMPLES / "unbalanced_motor.yaml")
    block = next(part for part in drawn if isinstance(part, Polygon) and part.fill == "body")
    arm = next(part.points for part in drawn if isinstance(part, Polyline) and part.role == "load")
    name = next(part.box for part in drawn if isinstance(part, LetterRuns) and part.runs[0].text == "M")
    assert plane.bounds(block.points)[0] < name[0] and name[2] < min(x for x, _ in arm) - 2.0


def test_a_coordinate_is_named_once_where_it_is_the_motion_of_a_body_in_a_row():
    words = [part for part in kept_drawing_of(EXAMPLES / "belt_drive.yaml") if isinstance(part, LetterRuns)]
    names = ["".join(run.text for run in word.runs) for word in words if word.role == "coordinate"]
    assert sorted(names) == ["φ", "χ", "ψ"]
