"""Points: fixed in the plane, or carried by a body from the place where they are drawn."""

from vibcli.fields import BODY, Element, Field, vector

ELEMENT = Element(
    "point",
    "A named place: `[x, y]` is fixed; `{body: rod, at: [x, y]}` is carried by a body, `at` being where it is drawn "
    "in the fixed frame.",
    {
        "at": Field(vector("m", "a place [x, y]"), "where it is drawn, in the fixed frame", required=True),
        "body": Field(BODY, "the body that carries it"),
    },
    short="at",
    example="hanging_rod",
)


def build(point, scene):
    """(drawn place, present place) of a point."""
    drawn = scene.pair(point["at"])
    if "body" not in point:
        return drawn, drawn
    return drawn, scene.frame(point["body"]).point(*drawn)
