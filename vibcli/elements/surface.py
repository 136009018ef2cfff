"""Surfaces that bodies roll or slide on: lines, circles and curves, fixed or carried by a body."""

from typing import TYPE_CHECKING

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, Choice, Many, NewName, Quantity
from vibcli.language.named_place import DRAWN

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record


def _settle(record: "Record", reader: "Reader") -> None:
    if "circle" in record and "radius" not in record:
        reader.report(record.where, "a circle needs 'radius'", "radius: the radius of the circle")
    if "curve" in record and "in" not in record:
        reader.report(record.where, "a curve needs 'in': the name of its abscissa", "as in {curve: x^2/(2*p), in: x}")
    elif "curve" in record:
        reader.name_within(record["curve"], record["in"], "m")


ELEMENT = Element(
    "surface",
    "What a body rolls or slides on: a straight line through two places, a circle with the body inside or outside of "
    "it, or (for sliding) a smooth curve y = f(x).",
    {
        "line": Field(Many(DRAWN, 2, 2, "two places [[x, y], [x, y]]"),
                      "two places on the line; travel is positive from the first to the second"),
        "circle": Field(DRAWN, "the centre of a circle"),
        "radius": Field(Quantity("m"), "the radius of the circle"),
        "side": Field(Choice("inside", "outside"), "on which side of the circle the body is (default: outside)"),
        "curve": Field(Quantity("m"), "the height of a curve as a function of the abscissa named by `in`"),
        "in": Field(NewName(), "the name of the abscissa of a curve, as in {curve: x^2/(2*p), in: x}"),
        "body": Field(BODY, "the body that carries the surface; fixed without it"),
    },
    exclusive=(("line", "circle", "curve"), ("line", "radius"), ("line", "side"), ("curve", "radius"),
               ("curve", "side"), ("line", "in"), ("circle", "in")),
    needs=(("line", "circle", "curve"),),
    settle=_settle,
    example="rolling_in_a_track",
)
