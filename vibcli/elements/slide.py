"""Translation along a direction or a smooth curve, the orientation kept in the carrier."""

from typing import TYPE_CHECKING

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, MotionField, NameOf, vector
from vibcli.symbolic.derivatives import gradient

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

ELEMENT = Element(
    "slide",
    "The body translates along a direction and keeps its orientation in its carrier: `slide: x` along +x, or "
    "`slide: {along: [0, 1], by: y}`. Of a body without a place it is the displacement along the one axis. With "
    "`surface` it slides along a line, a circle or a curve without friction.",
    {
        "by": Field(MotionField("m"), "the displacement: a coordinate, or an expression of coordinates", required=True),
        "along": Field(vector(None, "a direction [ex, ey]"), "the direction, of any length (default: [1, 0])"),
        "surface": Field(NameOf("the name of a surface", "surfaces"), "the surface that it slides on: `by` is then the "
                         "length of its path on a line (from its first place) or circle (counter-clockwise), and the "
                         "horizontal displacement on a curve"),
        "carrier": Field(BODY, "the body relative to which it slides; a carried direction turns with it. Of a body "
                         "without a place one that slides along the same axis"),
    },
    exclusive=(("along", "surface"), ("carrier", "surface")),
    short="by",
    example="spring_on_incline",
    instead={"body": "did you mean 'carrier'?"},
)


def build(slide: "Record", body: "Body", scene: "Builder") -> "Body":
    """A sliding body with its frame: x = x₀ + u·e, turned and displaced with the carrier."""
    x0, y0 = body.centre
    if "surface" in slide:
        return _on_surface(slide, body, scene)
    carrier = scene.carrier(slide)
    ex, ey = scene.table.one, scene.table.zero
    if "along" in slide:
        ex, ey = scene.unit(*scene.pair(slide["along"]), slide["along"][0].where)
    u = scene.change(slide["by"])
    x, y = carrier.point(x0 + u * ex, y0 + u * ey)
    return body._replace(normal=carrier.turned(-ey, ex), frame=scene.new_frame((x0, y0), (x, y), carrier.angle))


def _on_surface(slide: "Record", body: "Body", scene: "Builder") -> "Body":
    """A particle on a surface with its frame and the normal of the surface."""
    surface, (x0, y0) = scene.surfaces[slide["surface"].text], body.centre
    carrier, u = scene.carrier(surface, "body"), scene.change(slide["by"])
    if "line" in surface:
        (ax, ay), (bx, by) = (scene.pair(place) for place in surface["line"])
        ex, ey = scene.unit(bx - ax, by - ay, surface.where)
        off, x, y = (y0 - ay) * ex - (x0 - ax) * ey, x0 + u * ex, y0 + u * ey
        normal = -ey, ex
    elif "circle" in surface:
        (cx, cy), radius = scene.pair(surface["circle"]), scene.positive(surface["radius"], "the radius of the circle")
        off = scene.distance(x0 - cx, y0 - cy) - radius
        x, y = scene.new_frame((cx, cy), (cx, cy), u / radius).point(x0, y0)
        normal = (x - cx) / radius, (y - cy) / radius
    else:
        off, x = y0 - scene.height_of(surface, x0), x0 + u
        y = scene.height_of(surface, x)
        normal = _upward_normal(y, u)
    scene.require_equal(scene.absolute(off), scene.table.zero, slide.where,
                        f"'{body.name}' is {{}} m off its surface as drawn", "draw it on the surface",
                        size=1e-9 * (abs(scene.number(x0)) + abs(scene.number(y0))))
    normal = carrier.turned(*normal)
    return body._replace(normal=normal, frame=scene.new_frame((x0, y0), carrier.point(x, y), carrier.angle))


def _upward_normal(y: "Node", u: "Node") -> "tuple[Node, Node]":
    """(−y′, 1)/√(1 + y′²) of a curve, y being a function of the displacement u."""
    slope = y.table.zero
    for x, partial in gradient(y).items():
        if x in gradient(u):
            slope = partial / gradient(u)[x]
    length = y.table.sqrt(slope * slope + 1)
    return -slope / length, 1 / length


def lump(slide: "Record", scene: "Builder") -> "tuple[str, Node]":
    return "slide", scene.along_axis(slide, "slide") + scene.change(slide["by"])
