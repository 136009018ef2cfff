"""Surfaces that bodies roll on: lines and circles, fixed or carried by a body."""

from vibcli.fields import BODY, Choice, Element, Field, Many, Quantity, vector


def _settle(record, reader):
    if "circle" in record and "radius" not in record:
        reader.report(record.where, "a circle needs 'radius'", "radius: the radius of the circle")


ELEMENT = Element(
    "surface",
    "What a body rolls on: a straight line through two places, or a circle with the body inside or outside of it.",
    {
        "line": Field(Many(vector("m", "a place [x, y]"), 2, 2, "two places [[x, y], [x, y]]"),
                      "two places on the line; travel is positive from the first to the second"),
        "circle": Field(vector("m", "a place [x, y]"), "the centre of a circle"),
        "radius": Field(Quantity("m"), "the radius of the circle"),
        "side": Field(Choice("inside", "outside"), "on which side of the circle the body is (default: outside)"),
        "body": Field(BODY, "the body that carries the surface; fixed without it"),
    },
    exclusive=(("line", "circle"), ("line", "radius"), ("line", "side")),
    needs=(("line", "circle"),),
    settle=_settle,
    example="rolling_in_a_track",
)
