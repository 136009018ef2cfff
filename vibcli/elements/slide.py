"""Translation along a direction, the orientation kept in the carrier."""

from vibcli.fields import BODY, Element, Field, Motion, vector

ELEMENT = Element(
    "slide",
    "The body translates along a direction and keeps its orientation in its carrier: `slide: x` along +x, or "
    "`slide: {along: [0, 1], by: y}`. Of a body without a place it is the displacement along the one axis.",
    {
        "by": Field(Motion("m"), "the displacement: a coordinate, or an expression of coordinates", required=True),
        "along": Field(vector(None, "a direction [ex, ey]"), "the direction, of any length (default: [1, 0])"),
        "carrier": Field(BODY, "the body relative to which it slides; a carried direction turns with it"),
    },
    short="by",
    example="spring_on_incline",
)


def build(slide, body, scene):
    """The frame of a sliding body: x = x₀ + u·e, turned and displaced with the carrier."""
    x0, y0 = body.drawn
    carrier = scene.carrier(slide)
    ex, ey = scene.direction(slide["along"]) if "along" in slide else (scene.table.one, scene.table.zero)
    u = scene.change(slide["by"])
    x, y = carrier.point(x0 + u * ex, y0 + u * ey)
    return scene.new_frame((x0, y0), (x, y), carrier.angle)


def lump(slide, scene):
    return "slide", scene.change(slide["by"])
