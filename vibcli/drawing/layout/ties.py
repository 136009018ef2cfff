"""What the records of a scene say of a body beside its own: the radii on which ropes, belts and gears run, what it
carries, and the places at which anything is joined."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.drawing.layout import plane

if TYPE_CHECKING:
    from vibcli.drawing.layout.implied import Implied
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Expression, Record, Reference

SIDES = ("over", "under", "left_of", "right_of")


class Ties:
    """`radii`: {body: radii}, `toothed`: bodies in gears, `rims`: those with inner teeth, `arms`: bodies that carry
    gears, `pegs`: [(place, radius)] of pulleys without a body, `carried`: {body: places}, `surfaces`: {body: records},
    `slots`: {body: [(place, direction)]} of what slides along a body, `ends`: [(Attachment, Attachment)] of springs,
    dampers and links, `implied`: ropes that are not named, `fastened`: what is on them, `standing`: those from
    fixed places, `cords`: those that an element without ends stretches, `hinges`: [Attachment] of pins that are
    not named."""

    def __init__(self, sketch: "Sketch") -> None:
        self.radii, self.carried, self.surfaces, self.slots = {}, {}, {}, {}
        self.toothed, self.rims, self.arms, self.pegs, self.ends = set(), set(), set(), [], []
        for record in (sketch.spec.get("points") or {}).values():
            if "body" in record:
                self._carries(record["body"].text, sketch.pair(record["at"]))
        for body in sketch.scene.bodies.values():
            self._body(body, sketch)
        for record in (sketch.spec.get("surfaces") or {}).values():
            if "body" in record:
                self.surfaces.setdefault(record["body"].text, []).append(record)
        for record in sketch.spec.connections:
            self._joined(record.get("between"), sketch)
        for record in (sketch.spec.get("constraints") or {}).values():
            self._constraint(record, sketch)
        self.hinges, self.fastened, self.implied, self.standing, self.cords = [], set(), [], [], []
        self._unnamed({word for body in sketch.scene.bodies.values() for word in body.record}, sketch)
        if any("stretch" in record and "between" not in record for record in sketch.spec.connections):
            from vibcli.drawing.layout.cords import cords

            self.cords = cords(sketch)
        for cord in self.cords:
            self._rim(cord.wheel, cord.radius)
        self.roped = bool(self.implied or self.standing or self.cords) or any(
            "rope" in record for record in (sketch.spec.get("constraints") or {}).values())

    def _unnamed(self, keys: set[str], sketch: "Sketch") -> None:
        """Pins and ropes that the records do not name, which those of bodies with some keys may need."""
        if "move" in keys:
            from vibcli.drawing.layout.joined import hinges

            for name, end in hinges(sketch):
                self._carries(name, end.drawn)
                self.hinges.append(end)
        ropes = []
        if "slide" in keys and len(sketch.frames) > 1:
            from vibcli.drawing.layout import implied

            ropes = implied.ropes(sketch)
        for rope in ropes:
            self._implied(rope, sketch)
        if "move" in keys:
            from vibcli.drawing.layout import standing

            self.standing = standing.ropes(sketch, ropes, self.ends)

    def _body(self, body: "Body", sketch: "Sketch") -> None:
        if body.name not in sketch.frames:
            return
        record = body.record
        if (pivot := sketch.pivot(body.name)) is not None:
            self._carries(pivot.carrier, pivot.drawn)
        if "weld" in record:
            self._carries(record["weld"].text, sketch.centre(body.name))
        slide = record.get("slide")
        if slide is not None and "carrier" in slide:
            direction = plane.unit(sketch.pair(slide["along"])) if "along" in slide else (1.0, 0.0)
            self.slots.setdefault(slide["carrier"].text, []).append((sketch.centre(body.name), direction))
        if "radius" in record.get("roll", ()):
            self._rim(body.name, sketch.length(record["roll"]["radius"]))

    def _implied(self, rope: "Implied", sketch: "Sketch") -> None:
        """A rope; where it has no length its end is fastened to the wheel itself."""
        self.fastened.add(rope.weight)
        ends = sketch.rim(rope.wheel).drawn, sketch.centre(rope.weight)
        if rope.side is None and abs(plane.distance(*ends) - rope.radius) < 1e-6 * plane.distance(*ends):
            self._carries(rope.wheel, ends[1])
            return
        self.implied.append(rope)
        if rope.radius:
            self._rim(rope.wheel, rope.radius)
        if rope.over:
            self._rim(rope.weight, rope.over)

    def _carries(self, carrier: str | None, place: tuple[float, float]) -> None:
        if carrier is not None:
            self.carried.setdefault(carrier, []).append(place)

    def _rim(self, name: str, radius: float) -> None:
        known = self.radii.setdefault(name, [])
        if not any(abs(radius - other) < 1e-6 * radius for other in known):
            known.append(radius)

    def _joined(self, ends: "Sequence[list[Expression] | Reference] | None", sketch: "Sketch") -> None:
        found = [sketch.attachment(end) for end in ends or ()]
        if found and None not in found:
            self.ends.append(tuple(found))

    def _constraint(self, record: "Record", sketch: "Sketch") -> None:
        for kind in ("gear", "belt"):
            if kind in record:
                self._pair(record, kind, sketch)
        for kind in ("link", "join"):
            self._joined(record.get(kind), sketch)
        for stop in record.get("rope", ()):
            if hasattr(stop, "values"):
                self._pulley(stop, sketch)

    def _pair(self, record: "Record", kind: str, sketch: "Sketch") -> None:
        names, scene = [name.text for name in record[kind]], sketch.scene
        for name, radius in zip(names, record.get("radii", ()), strict=False):
            self._rim(name, sketch.length(radius))
        if kind == "gear":
            self.toothed.update(names)
            if record.get("inside"):
                pitch = map(sketch.number, record["radii"]) if "radii" in record else (
                    scene.number(scene.bodies[name].rolling_radius) for name in names)
                self.rims.add(max(zip(pitch, names, strict=True))[1])
            if "carrier" in record:
                self.arms.add(record["carrier"].text)

    def _pulley(self, stop: "Record", sketch: "Sketch") -> None:
        on = stop[next(side for side in SIDES if side in stop)]
        radius = sketch.length(stop["radius"]) if "radius" in stop else None
        name = getattr(on, "text", None)
        if name in sketch.scene.bodies:
            if radius is not None:
                self._rim(name, radius)
        else:
            self.pegs.append((sketch.attachment(on), radius or 0.0))

    def nearest(self, place: tuple[float, float], sketch: "Sketch") -> float:
        """How far the nearest other place is at which something is joined, pinned or centred, if there is any."""
        places = [end.drawn for pair in self.ends for end in pair]
        places += [sketch.centre(name) for name in sketch.scene.bodies if name in sketch.frames]
        places += [point for points in self.carried.values() for point in points]
        least = 1e-6 * (1 + abs(place[0]) + abs(place[1]))
        return min((far for other in places if (far := plane.distance(place, other)) > least), default=None)
