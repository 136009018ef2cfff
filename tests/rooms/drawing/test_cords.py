"""Cords that are drawn since the stretch of a spring is that of a cord which a rolling wheel winds up."""

from math import cos, hypot, pi, sin

import pytest
from support.scenes import problem

from vibcli.drawing.canvas.primitives import Circle, Hatch, Polygon
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.compose import Scenery
from vibcli.drawing.layout.notes import of

WHEEL = """title: A wheel
parameters: {{m: 9 kg, R: 0.18 m, r: {{value: 0.06 m, unused: allowed}}, b: {angle}, k: 700 N/m}}
surfaces: {{slope: {{line: [[0, 0], [10*R*cos(b), -10*R*sin(b)]]}}}}
bodies:
  wheel:
    {{shape: disc, mass: m, radius: R, at: [5*R*cos(b) + R*sin(b), -5*R*sin(b) + R*cos(b)],
      roll: {{surface: slope, travel: x}}}}
springs: {{s: {{k: k, stretch: "{stretch}"}}}}
"""
R, r = 0.18, 0.06


def stage(stretch, angle="25 deg"):
    return Scenery(problem(WHEEL.format(stretch=stretch, angle=angle)).scene)


def is_noted(found):
    return any("".join(run.text for run in runs).startswith("s: ") for runs in of(found))


@pytest.mark.parametrize("angle", ["25 deg", "0 deg", "-40 deg"])
@pytest.mark.parametrize("stretch, slope, side, way", [
    ("(1 + r/R)*x", 1 + r / R, 1, -1), ("(1 - r/R)*x", 1 - r / R, -1, -1), ("-(1 + r/R)*x", -1 - r / R, 1, 1),
    ("2*x", 2.0, 1, -1), ("0.0001*x", 1e-4, -1, -1)])
def test_the_cord_leaves_the_wheel_where_it_moves_as_the_stretch_says(stretch, slope, side, way, angle):
    """side: of the centre, away from the plane or towards it; way: of the cord, down the plane or up."""
    found, b = stage(stretch, angle), float(angle.split()[0]) * pi / 180
    cord, = found.ties.cords
    down, away = (cos(b), -sin(b)), (sin(b), cos(b))
    radius = side * cord.radius / found.sketch.scale
    assert -way * slope == pytest.approx(1 + radius / R)       # of the material place from which it leaves
    free = plane.minus(cord.end.drawn, found.sketch.rim("wheel").drawn)
    assert plane.dot(free, away) == pytest.approx(side * cord.radius) and way * plane.dot(free, down) > 0
    x = 0.02
    moved = found.at({"x": x})
    gone = plane.minus(moved.now(cord.end), cord.end.drawn)
    assert plane.dot(gone, down) == pytest.approx(-way * slope * x * found.sketch.scale)
    assert abs(plane.dot(gone, away)) < 1e-9 * found.sketch.scale
    assert cord.radius in found.ties.radii["wheel"] and not is_noted(found)
    assert hypot(*plane.minus(cord.end.drawn, cord.wall.drawn)) > 0 and set(found.ropes) == {"cord of s"}


@pytest.mark.parametrize("stretch", ["x", "2.2*x", "(1 + r/R)*x + x^2/R"])
def test_what_no_cord_of_the_wheel_does_stays_in_words(stretch):
    found = stage(stretch)
    assert found.ties.cords == [] and is_noted(found) and not found.ropes


def test_a_fixed_peg_is_held_beside_its_rope():
    drawn = draw(problem("""
        parameters: {m: 2 kg, M: 3 kg, l: 1 m, g: 9.81 m/s^2}
        gravity: g
        bodies: {crate: {mass: m, at: [0, 0], slide: x}, weight: {mass: M, at: [l, -l], slide: {along: [0, -1], by: x}}}
        constraints: {rope: {rope: [crate, {over: [l, 0]}, weight]}}
    """))
    peg, = [part.centre for part in drawn if isinstance(part, Circle) and part.fill == "ink"]
    holds = [part for part in drawn if isinstance(part, Polygon) and peg in part.points]
    rope = [part.points for part in drawn if part.role == "rope"]
    assert len(holds) == 1 and len(rope) == 2
    assert min(x + y for x, y in holds[0].points) >= sum(peg) - 1e-9
    grounds = [part for part in drawn if isinstance(part, Hatch) and min(x + y for x, y in part.points) > sum(peg)]
    assert len(grounds) == 1
