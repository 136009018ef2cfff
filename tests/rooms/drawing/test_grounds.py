"""The ground as it is: open where springs lead through it, a bowl up to its rim, a wedge on level ground; and a scene
that chooses drawn with what it chooses."""

import math
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

from vibcli.api.pictures import SceneDrawing
from vibcli.drawing.canvas.primitives import SURFACE, Circle, Hatch, Polygon
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.support import ROLLER

SLIDER = """
    parameters: {m: 2 kg, k: 80 N/m, L: 0.3 m}
    bodies: {slider: {mass: m, at: [0, 0], slide: x}}
    springs: {one: {k: k, between: [[0, L], slider]}, two: {k: k, between: [[%s], slider]}}
"""


def of(name):
    found, = Path("problems").glob(f"*/{name}.yaml")
    return kept_problem_of(found)


def level(drawn):
    """The pieces of level ground below what slides: (left end, right end) each."""
    found = [sorted(x for x, _ in part.points) for part in drawn if isinstance(part, Hatch) and len(part.points) == 2
             and part.points[0][1] == part.points[1][1] and -30 < part.points[0][1] < 0]
    return sorted((x[0], x[-1]) for x in found)


def test_ground_is_open_where_a_spring_leads_through_it():
    (first, second) = level(draw(problem(SLIDER % "0, -L")))
    assert first[1] < 0 < second[0]
    (whole,) = level(draw(problem(SLIDER % "L, L")))
    assert whole[0] < 0 < whole[1]


@pytest.mark.sweep
def test_a_bowl_ends_at_the_rim_on_which_a_rod_leans():
    scene = of("rod_over_the_rim_of_a_bowl")
    found = SceneDrawing.of(scene).primitives
    bowl = max((part for part in found if isinstance(part, Hatch)), key=lambda part: len(part.points))
    (left, _), (right, top) = bowl.points[0], bowl.points[-1]
    assert abs(top) < 1e-6 and left < 0 < right
    radius = right
    assert all(math.hypot(x, y) == pytest.approx(radius) for x, y in bowl.points)


@pytest.mark.sweep
def test_what_is_chosen_is_drawn_as_it_is_found():
    """The rod leans by 29.21°, as the answers of the file say."""
    found = SceneDrawing.of(of("rod_over_the_rim_of_a_bowl")).primitives
    rod = max((part for part in found if isinstance(part, Polygon) and part.role != "coordinate"), key=lambda part: max(
        x for x, _ in part.points) - min(x for x, _ in part.points))
    (ax, ay), (bx, by) = min(rod.points), max(rod.points)
    assert math.degrees(math.atan2(by - ay, bx - ax)) == pytest.approx(29.21, abs=2)


def test_a_body_with_a_leaning_face_on_level_ground_is_a_wedge():
    found = draw(of("cylinder_on_a_sprung_wedge"))
    wedge = next(part for part in found if isinstance(part, Polygon) and len(part.points) == 4 and len(
        {round(y, 6) for _, y in part.points}) == 3 and len({round(x, 6) for x, _ in part.points}) == 2)
    low = min(y for _, y in wedge.points)
    assert sum(abs(y - low) < 1e-6 for _, y in wedge.points) == 2


@pytest.mark.parametrize(("slide", "count"), [("slide: x", 2), ("angle: 0.3, slide: x", 0),
                                              ("slide: {along: [0, 1], by: x}", 0)])
def test_a_rectangle_that_slides_on_level_ground_stands_on_rollers(slide, count):
    drawn = draw(problem(f"""
        parameters: {{m: 2 kg, b: 0.4 m, h: 0.2 m, k: 80 N/m}}
        bodies: {{cart: {{shape: rectangle, mass: m, width: b, height: h, at: [0, 0], {slide}}}}}
        springs: {{s: {{k: k, between: [[-b, 0], cart]}}}}
    """))
    foot = min(y for part in drawn if isinstance(part, Polygon) for _, y in part.points)
    wheels = [part for part in drawn if isinstance(part, Circle) and abs(part.centre[1] + part.radius - foot) < 1e-9]
    assert len(wheels) == count and bool(count) == any(
        isinstance(part, Hatch) and abs(part.points[0][1] - foot + 2 * ROLLER) < 1e-9 for part in drawn)


@pytest.mark.parametrize(("name", "count"), [("ladder_held_by_spring", 2), ("bar_on_two_springs", 0)])
def test_ends_of_a_rod_that_expressions_keep_on_a_line_stand_on_guides(name, count):
    drawn = draw(of(name))
    rollers = [part.centre for part in drawn if isinstance(part, Circle) and part.radius == ROLLER]
    floors = [part.points for part in drawn if isinstance(part, Hatch) and part.layer == SURFACE]
    assert len(rollers) == len(floors) == count
    for (a, b), place in zip(floors, rollers, strict=True):     # each touches its ground
        assert abs(plane.distance(plane.nearest_on(place, a, b), place) - ROLLER) < 1e-6
