"""Outlines of the shapes of bodies, as drawn."""

from typing import NamedTuple

from vibcli.drawing.layout import plane

ROD, BALL = 3.2, 5.0     # half the thickness of a rod, the radius of a particle


class Outline(NamedTuple):
    """A closed or open outline; a `cut` is a hole. `band` marks what is only a line: a ring or an arch."""

    points: list
    closed: bool = True
    cut: bool = False
    band: bool = False


def outline(record, sketch):
    """The Outline of one shape: a body or a part of one."""
    shape = record.get("shape", "particle")
    return FORMS[shape](record, sketch)._replace(cut=record.get("cut", False))


def _particle(record, sketch):
    return Outline(plane.circle(sketch.pair(record["at"]), BALL))


def _disc(record, sketch):
    return Outline(plane.circle(sketch.pair(record["at"]), sketch.length(record["radius"])))


def _ring(record, sketch):
    return _disc(record, sketch)._replace(band=True)


def _rod(record, sketch):
    return Outline(plane.capsule(sketch.pair(record["from"]), sketch.pair(record["to"]), ROD))


def _rectangle(record, sketch):
    return Outline(plane.box(sketch.pair(record["at"]), sketch.length(record["width"]),
                             sketch.length(record["height"]), _angle(record, sketch)))


def _ellipse(record, sketch):
    centre, a, b = sketch.pair(record["at"]), sketch.length(record["a"]), sketch.length(record["b"])
    angle, size = _angle(record, sketch), max(a, b)
    return Outline([plane.plus(centre, plane.turned((x * a / size, y * b / size), angle))
                    for x, y in plane.circle((0.0, 0.0), size)])


def _sector(record, sketch):
    arch = _arch(record, sketch)
    return Outline([sketch.pair(record["at"]), *arch.points])


def _arch(record, sketch):
    axis, half = _angle(record, sketch), sketch.number(record["half_angle"])
    return Outline(plane.arc(sketch.pair(record["at"]), sketch.length(record["radius"]), axis - half, axis + half),
                   closed=False, band=True)


def _angle(record, sketch):
    return sketch.number(record["angle"]) if "angle" in record else 0.0


FORMS = {"particle": _particle, "disc": _disc, "ring": _ring, "rod": _rod, "rectangle": _rectangle,
         "ellipse": _ellipse, "sector": _sector, "arch": _arch}
