"""How large a scene is drawn: all its places on one sheet, no spring too short to be seen."""

from math import hypot
from typing import TYPE_CHECKING, Any

from vibcli.base.units import LENGTH
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.ties import Ties

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch

WIDE, HIGH, SHORT, GROWTH, ALONE = 300.0, 210.0, 46.0, 1.8, 90.0


def scale_of(sketch: Any) -> float:
    """How much smaller than a FINE sketch the drawing is to be."""
    found = _key_points(sketch)
    ties = Ties(sketch)
    for pair in ties.ends:
        found += [end.drawn for end in pair]
    for record in (sketch.spec.get("constraints") or {}).values():
        found += [sketch.attachment(stop).drawn for stop in record.get("rope", ()) if not hasattr(stop, "values")]
    for at, radius in ties.pegs:
        found += plane.circle(at.drawn, radius) if radius else [at.drawn]
    for name, radii in ties.radii.items():
        if name in sketch.frames:
            found += plane.circle(sketch.rim(name).drawn, max(radii))
    for name, record in (sketch.spec.get("surfaces") or {}).items():
        if "circle" in record:
            from vibcli.drawing.symbols import tracks

            places = [place for place, room in tracks.contacts(name, sketch) if room is not None]
            found += tracks.visible(record, places, sketch)
    left, bottom, right, top = plane.bounds(found) if found else (0.0, 0.0, 0.0, 0.0)
    size = sketch.numbers["size"] = hypot(right - left, top - bottom)
    if size < 100.0:
        size = sketch.numbers["size"] = 0.0
        size = _curve(sketch)
        result: float = ALONE / (size * sketch.scale) if size else 1.0 / sketch.scale
        return result
    much = sum(len(sketch.spec.get(section) or ()) for section in ("bodies", "points", "forces"))
    much += len(sketch.spec.connections)
    share = min(1.5, max(0.62, 0.5 + 0.12 * much))
    wide, high = share * WIDE, min(share, 1.15) * HIGH
    scale = min(wide / max(right - left, 1e-9 * size), high / max(top - bottom, 1e-9 * size))
    short = min((d for one, two in ties.ends if (d := plane.distance(one.drawn, two.drawn)) > 1e-9 * size),
                default=size) * scale
    return scale * min(GROWTH, max(1.0, SHORT / short))


def _curve(sketch: "Sketch") -> float | None:
    """A length in metres for a scene at one place: half the width of a curve, else the largest length among the
    parameters, else half the width of the path of a particle; None where there is none."""
    from vibcli.drawing.symbols import path, tracks

    halves = [tracks.half_width(record, sketch) for record in (sketch.spec.get("surfaces") or {}).values()
              if "curve" in record]
    sizes = halves or _given_lengths(sketch) or [path.half_width(sketch)]
    return sizes[0]


def _key_points(sketch: "Sketch") -> list[tuple[float, float]]:
    """All places of a scene as drawn, in the unit of the sketch."""
    found = []
    for body in sketch.scene.bodies.values():
        if body.name in sketch.frames:
            for part in body.record.get("parts", (body.record,)):
                if part.get("shape", "particle") == "particle":
                    found.append(sketch.centre(body.name) if part is body.record else sketch.pair(part["at"]))
                else:
                    from vibcli.drawing.symbols.shape import outline

                    found += outline(part, sketch).points
            if (pivot := sketch.pivot(body.name)) is not None:
                found.append(pivot.drawn)
    found += [sketch.pair(record["at"]) for record in (sketch.spec.get("points") or {}).values()]
    found += [sketch.pair(member.record[key]) for member in sketch.scene.members.values()
              if member is not None and member.line is not None for key in ("from", "to")]
    return found


def _given_lengths(sketch: "Sketch") -> list[float]:
    """The largest length among the parameters, in a list; empty where there is none."""
    dimensions = sketch.spec.dimensions
    found = [abs(sketch.values[name]) for name in sketch.spec.parameters
             if name in sketch.values and dimensions.of(name) == LENGTH]
    return [max(found)] if any(found) else []
