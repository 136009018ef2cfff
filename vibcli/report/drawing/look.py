"""What a placed body looks like: outlines as drawn, which its frame then carries along."""

from math import pi
from typing import NamedTuple

from vibcli.report.drawing import plane
from vibcli.report.drawing.posts import with_posts
from vibcli.report.drawing.primitives import BEHIND, BODY, JOINT, Circle, Line, Polygon
from vibcli.report.drawing.shape import BALL, ROD, outline
from vibcli.report.drawing.tracks import contacts, curve_points, free_side

BLOCK, FLAT, BAR, HUB, DECK, DEEP, RIM, BEYOND = (36.0, 25.0), (22.0, 13.0), (26.0, 5.0), 11.0, 19.0, 70.0, 8.0, 26.0


class Look(NamedTuple):
    """Primitives of a body as drawn; its `core` is a polygon at whose edge springs end, None where they run to the
    very place; `kind` says what it is drawn as; `angle` is that of a block."""

    pieces: list
    kind: str
    core: list | None = None
    angle: float = 0.0
    width: float = 0.0
    height: float = 0.0

    @property
    def outlines(self):
        return [part for part in self.pieces if not isinstance(part, Line)]

    def size(self):
        """The larger side of its box."""
        left, bottom, right, top = plane.bounds([p for part in self.pieces for p in part.points])
        return max(right - left, top - bottom)

    def area(self):
        return max((plane.area(list(part.points)) for part in self.outlines), default=0.0)


def looks(sketch, ties):
    """{name: Look} of all bodies that have a place."""
    return {name: with_posts(look_of(body, sketch, ties), body, sketch, ties)
            for name, body in sketch.scene.bodies.items() if name in sketch.frames}


def look_of(body, sketch, ties):
    record, name = body.record, body.name
    if "parts" in record or record.get("shape", "particle") != "particle":
        return _shaped(record, sketch, toothed=name in ties.toothed)
    centre = sketch.centre(name)
    surfaces = ties.surfaces.get(name, ())
    if any("line" in surface for surface in surfaces):
        return _platform(body, sketch, next(surface for surface in surfaces if "line" in surface))
    if any("curve" in surface for surface in surfaces):
        return _bowl(next(surface for surface in surfaces if "curve" in surface), sketch)
    if any("circle" in surface for surface in surfaces):
        surface = surfaces[0]
        rim = plane.circle(sketch.pair(surface["circle"]), sketch.length(surface["radius"]))
        return Look([Polygon(tuple(rim), None, width=2.2)], "hoop")
    if name in ties.rims:
        return _rim(centre, max(ties.radii[name]))
    if name in ties.radii:
        return _wheel(centre, _radii(name, centre, ties), name in ties.toothed)
    pivot = sketch.pivot(name)
    if pivot is not None:
        return _pinned(body, centre, pivot.drawn, sketch, ties)
    if "slide" in record and "surface" not in record["slide"]:
        return _block(body, centre, sketch, ties)
    return _loose(body, centre, sketch, ties)


def _shaped(record, sketch, toothed=False):
    parts = [outline(part, sketch) for part in record.get("parts", (record,))]
    pieces = [_piece(part) for part in sorted(parts, key=lambda part: part.cut)]
    if toothed and parts[0].band:
        return _rim(sketch.centre(record.name), sketch.length(record["radius"]))
    if toothed:
        pieces = [piece._replace(points=tuple(teeth(piece.points))) for piece in pieces]
    core = list(pieces[0].points) if record.get("shape") == "rectangle" else None
    return Look(pieces, record.get("shape", "parts"), core)


def _piece(part):
    if not part.closed:
        return Line(tuple(part.points), width=3.0, layer=BODY)
    if part.band:
        return Polygon(tuple(part.points), None, width=2.6)
    return Polygon(tuple(part.points), "paper" if part.cut else "body")


def teeth(points, pitch=7.0, height=1.7):
    """The outline of a gear about its pitch circle."""
    left, bottom, right, top = plane.bounds(points)
    centre, radius = ((left + right) / 2, (bottom + top) / 2), (right - left) / 2
    count = max(8, round(2 * pi * radius / pitch))
    found = []
    for i in range(count):
        for part, side in ((0.0, -1), (0.12, 1), (0.5, 1), (0.62, -1)):
            found.append(plane.polar(centre, radius + side * height, 2 * pi * (i + part) / count))
    return found


def _radii(name, centre, ties):
    """The radii of a wheel, that at which it carries places included."""
    radii = sorted(ties.radii[name], reverse=True)
    far = [plane.distance(centre, place) for place in ties.carried.get(name, ())]
    if far and min(far) > radii[0] and max(far) - min(far) < 1e-6 * max(far):
        return [max(far), *radii]
    return radii


def _rim(centre, radius):
    """A gear with inner teeth."""
    rim = plane.circle(centre, radius + RIM)
    return Look([Polygon(tuple(rim)), Polygon(tuple(teeth(plane.circle(centre, radius))), "paper")], "rim")


def _wheel(centre, radii, toothed):
    rims = [Polygon(tuple(plane.circle(centre, radius)), "body" if i == 0 else "inner") for i, radius in
            enumerate(radii)]
    if toothed:
        rims[0] = rims[0]._replace(points=tuple(teeth(rims[0].points)))
    return Look(rims, "wheel")


def _pinned(body, centre, pivot, sketch, ties):
    """A pendulum, a hub or an arm."""
    carried = [place for place in ties.carried.get(body.name, ()) if plane.distance(place, centre) > 1e-6]
    slots = ties.slots.get(body.name, ())
    if plane.distance(centre, pivot) < 1e-6:
        far = sorted(plane.distance(centre, place) for place in carried)
        if body.name in ties.arms:
            return Look([Polygon(tuple(plane.capsule(centre, place, ROD + 1))) for place in carried] or
                        [_ball(centre, HUB)], "arm")
        if far and not slots and far[-1] - far[0] < 1e-6 * far[-1]:
            return Look([_ball(centre, far[0] + 5)], "wheel")
        radius = HUB if body.inertia is not None or not slots else 3.0
        return Look([*_rail(centre, slots), _ball(centre, radius)], "hub")
    if body.mass is None and body.inertia is None:
        return Look([Line((pivot, centre), width=2.4, layer=BODY), *_rail(centre, slots)], "arm")
    if {"inertia", "gyration"} & set(body.record.values):
        return _blob(pivot, centre)
    ball = _ball(centre, BALL + 1.5)
    return Look([Line((pivot, centre), width=1.6, layer=BEHIND), ball, *_rail(centre, slots)], "bob", ball.points)


def _ball(centre, radius):
    return Polygon(tuple(plane.circle(centre, radius)))


def _blob(pivot, centre):
    """A body of any form about its pin and its mass centre."""
    length = plane.distance(pivot, centre)
    low, high = -10.0, length + min(40.0, max(12.0, 0.35 * length))
    a, b = (high - low) / 2, min(40.0, max(12.0, 0.26 * (high - low)))
    at = plane.along(pivot, centre)
    points = [at((low + high) / 2 + a * x, b * y * (1 + 0.35 * x)) for x, y in
              [plane.polar((0, 0), 1.0, 2 * pi * i / 60) for i in range(60)]]
    return Look([Polygon(tuple(points)), *centre_mark(centre)], "blob")


def centre_mark(centre):
    """The mass centre of a body."""
    return [Circle(centre, 2.0, "ink", layer=JOINT)]


def _rail(origin, slots):
    """The straight rods along which others slide."""
    if not slots:
        return []
    direction = slots[0][1]
    reach = [plane.dot(plane.minus(place, origin), direction) for place, _ in slots]
    low, high = min([0.0, *reach]), max([0.0, *reach])
    if high - low < 1e-6:
        low, high = -2 * BEYOND, 2 * BEYOND
    else:
        low, high = (low - BEYOND if low < 0 else 0.0), (high + BEYOND if high > 0 else 0.0)
    offset = plane.minus(slots[0][0], origin)
    base = plane.plus(origin, plane.minus(offset, plane.times(direction, plane.dot(offset, direction))))
    return [Line((plane.plus(base, direction, low), plane.plus(base, direction, high)), width=2.4, layer=BEHIND)]


def _block(body, centre, sketch, ties):
    """A box along its direction of sliding; small where it has no mass, a ramp where others slide on it at an angle."""
    slide = body.record["slide"]
    direction = sketch.pair(slide["along"]) if "along" in slide else (1.0, 0.0)
    angle = plane.heading(direction)
    angle -= round(angle / (pi / 2)) * (pi / 2)
    slots = [slot for slot in ties.slots.get(body.name, ()) if min(map(abs, slot[1])) > 0.05]
    if slots:
        return _ramp(*slots[0], ties.carried.get(body.name, ()))
    room, massless = ties.nearest(centre, sketch), body.mass is None
    upright = abs(direction[1]) > abs(direction[0])
    if massless and upright:
        return _holder(body, centre, ties)
    width, height = FLAT if massless else (30.0, BLOCK[1]) if upright else BLOCK
    shrink = min(1.0, max(0.5, 1.3 * (room or width) / width))
    width, height = width * shrink, height * shrink
    hook = _hook(body, centre, sketch)
    middle = plane.plus(centre, (0.0, -1.0), hook + height / 2) if hook else centre
    corners = plane.box(middle, width, height, angle)
    beside = [x for x, y in ties.carried.get(body.name, ()) if abs(y - centre[1]) > height / 2]
    if not angle and not upright and beside:
        low, high = min(centre[0] - width / 2, min(beside) - 6), max(centre[0] + width / 2, max(beside) + 6)
        middle, width = ((low + high) / 2, middle[1]), high - low
        corners = plane.box(middle, width, height)
    hanger = [Line((centre, plane.plus(centre, (0.0, -1.0), hook)), width=1.4, layer=JOINT)] if hook else []
    return Look([*hanger, Polygon(tuple(corners))], "block", corners, angle, width, height)


def _holder(body, centre, ties):
    """What has no mass and slides upright: bars at the places that it carries, else a knot where others meet."""
    bars = [plane.box(place, *BAR, plane.heading(plane.minus(centre, place)) + pi / 2)
            for place in ties.carried.get(body.name, ()) if plane.distance(place, centre) > 1e-6]
    if bars and ties.slots.get(body.name):
        return Look([Polygon(tuple(bar), "driven") for bar in bars], "joint")
    return Look([_ball(centre, 2.4)._replace(fill="ink")], "joint")


def _hook(body, centre, sketch):
    """How far below the axle of a wheel a body hangs that is drawn at the very axle; 0 of any other."""
    for name, other in sketch.scene.bodies.items():
        wheel = name in sketch.frames and name != body.name and other.rolling_radius is not None
        if wheel and plane.distance(sketch.centre(name), centre) < 1e-6:
            return sketch.scene.number(other.rolling_radius) * sketch.scale + 14.0
    return 0.0


def _ramp(place, direction, carried):
    """A wedge under a block that slides on it."""
    reach = [plane.dot(plane.minus(point, place), direction) for point in carried]
    low, high = min([*reach, -40.0]), max([*reach, 40.0])
    up = direction if direction[1] > 0 else plane.times(direction, -1)
    if up is not direction:
        low, high = -high, -low
    foot, head = plane.plus(place, up, low), plane.plus(place, up, high)
    drop = plane.times(plane.left(up) if up[0] > 0 else plane.times(plane.left(up), -1), -BLOCK[1] / 2)
    foot, head = plane.plus(foot, drop), plane.plus(head, drop)
    corners = [foot, (head[0], foot[1]), head]
    return Look([Polygon(tuple(corners))], "ramp")


def _platform(body, sketch, surface):
    """A plank under the surface that it carries, away from what is on it; so thick that it holds its centre."""
    a, b = (sketch.pair(place) for place in surface["line"])
    side = free_side(a, b, contacts(surface.name, sketch))
    if side < 0:
        a, b = b, a
    e = plane.unit(plane.minus(b, a))
    down = plane.times(plane.left(e), -1)
    offset = plane.minus(sketch.centre(body.name), a)
    depth, s = plane.dot(offset, down), plane.dot(offset, e)
    thick = max(DECK, depth + 8) if depth < DEEP else DECK
    a, b = plane.plus(a, e, min(0.0, s - DECK)), plane.plus(a, e, max(plane.distance(a, b), s + DECK))
    corners = [a, b, plane.plus(b, down, thick), plane.plus(a, down, thick)]
    return Look([Polygon(tuple(corners))], "platform", corners, plane.heading(e), plane.distance(a, b), thick)


def _bowl(surface, sketch):
    points = curve_points(surface, sketch)
    bottom = min(y for _, y in points) - DECK
    corners = [*points, (points[-1][0], bottom), (points[0][0], bottom)]
    width = points[-1][0] - points[0][0]
    return Look([Polygon(tuple(corners))], "platform", corners, 0.0, width, DECK)


def _loose(body, centre, sketch, ties):
    """A body that moves freely: a bar through the places that it carries, else a ball."""
    carried = [place for place in ties.carried.get(body.name, ()) if plane.distance(place, centre) > 1e-6]
    turns = body.inertia is not None and {"inertia", "gyration"} & set(body.record.values)
    if len(carried) > 1 or (carried and turns):
        ends = sorted([*carried, centre])
        if all(abs(plane.across(plane.minus(p, ends[0]), plane.minus(ends[-1], ends[0]))) < 1e-6 * (
                1 + plane.distance(ends[0], ends[-1])) ** 2 for p in ends):
            e = plane.unit(plane.minus(ends[-1], ends[0]))
            bar = plane.box(plane.middle(ends[0], ends[-1]), plane.distance(ends[0], ends[-1]) + 22, 13,
                            plane.heading(e))
            return Look([Polygon(tuple(bar)), *centre_mark(centre)], "bar", bar)
    ball = _ball(centre, 14.0 if turns else BALL + 2.5)
    return Look([ball], "ball", ball.points)
