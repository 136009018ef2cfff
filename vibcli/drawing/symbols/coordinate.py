"""Arrows of the coordinates at what they move, and of what is driven as a function of time."""

from collections.abc import Callable, Iterator, Mapping
from math import hypot, pi
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import captions, lettering, plane
from vibcli.drawing.layout.sketch import Attachment, Sketch
from vibcli.drawing.layout.space import FILLED, TAKEN
from vibcli.drawing.symbols import arrow
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import Primitive, Run
    from vibcli.drawing.layout.space import Space
    from vibcli.drawing.symbols.look import Look
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Record

Place = tuple[float, float]
Path = tuple[list[Place], Callable[[str], list[Any]]]
RoundPath = tuple[list[Place], Callable[[str], list[Any]], list[Place]]       # and the part of it that is within
LENGTH, TICK, WIDE, OVER = 26.0, 5.0, 60.0, 1.5
ROUND, AROUND = (22.0, 32.0, 44.0), (2, 6, 14, 10, 1, 7, 15, 9, 3, 5, 13, 11, 0, 4, 8, 12)
LINES, ARCS = (5.0, 11.0, 18.0, 27.0, 38.0), (0.55, 0.7, 0.85, 0.4, 1.0)
STARTS = (0.2, 0.7, -0.3, 1.2, -0.8), (0.08, 0.58, -0.42, 1.08)     # in units of π; those beside them
LATER, ROUND_LATER, WORDED = 1.5, 1.0, 1.2      # the cost of each place that is tried before, of a word at the start
BEYOND, SMALL = 6.0, 30.0       # points: of an arc about all of a small body
NEAR, LONG = 40.0, 140.0        # points: the radius of an arc near the joint of a long body
THIN, MOST = 4.0, 12.0          # half the thickness of what arcs begin within
INSIDE, LEAVING = 22.0, 0.38    # that of what short arcs may end in; the part of an arc within a thinner one
ROUNDED = "ring", "arch", "sector"
SLANT = 15.0        # points to either side by which a rod leans away from an arrow


class BodyMotion(NamedTuple):
    """One degree of freedom of a body: along a direction, or about a centre (an Attachment) in a sense (1, or −1)."""

    body: str
    field: Any
    direction: tuple[float, float] | None = None
    about: Attachment | None = None
    sense: int = 1


def motions(sketch: Sketch) -> list[BodyMotion]:
    """The Motions of all placed bodies, in the order of the file."""
    found = []
    for name in sketch.spec.get("bodies") or {}:
        if name in sketch.frames:
            found += _of(sketch.scene.bodies[name], sketch)
    return found


def _of(body: "Body", sketch: Sketch) -> list[BodyMotion]:
    record, name = body.record, body.name
    if "slide" in record:
        return [BodyMotion(name, record["slide"]["by"], _along(record["slide"], sketch, name))]
    if "pin" in record:
        return [BodyMotion(name, record["pin"]["by"], about=sketch.pivot(name))]
    if "move" in record:
        x, y, turn = record["move"]["by"]
        return [BodyMotion(name, x, (1.0, 0.0)), BodyMotion(name, y, (0.0, 1.0)),
                BodyMotion(name, turn, about=Attachment(name, sketch.centre(name)))]
    return _rolling(record["roll"], name, sketch) if "roll" in record else []


def _along(slide: "Record", sketch: Sketch, name: str) -> tuple[float, float]:
    if "surface" in slide:
        return _tangent(sketch.scene.surfaces[slide["surface"].text], sketch.centre(name), sketch)
    return plane.unit(sketch.pair(slide["along"])) if "along" in slide else (1.0, 0.0)


def _tangent(surface: "Record", place: tuple[float, float], sketch: Sketch) -> tuple[float, float]:
    """The positive direction on a surface, at a place on it."""
    if "line" in surface:
        a, b = (sketch.pair(place) for place in surface["line"])
        return plane.unit(plane.minus(b, a))
    if "circle" in surface:
        return plane.left(plane.unit(plane.minus(place, sketch.pair(surface["circle"]))))
    return 1.0, 0.0


def _rolling(roll: "Record", name: str, sketch: Sketch) -> list[BodyMotion]:
    surface, found = sketch.scene.surfaces[sketch.scene.bodies[name].touched[0]], []
    if "travel" in roll:
        found.append(BodyMotion(name, roll["travel"], _tangent(surface, sketch.rim(name).drawn, sketch)))
    if "turn" in roll:
        found.append(BodyMotion(name, roll["turn"], about=Attachment(name, sketch.frames[name].drawn)))
    if "swing" in roll:
        carrier = surface["body"].text if "body" in surface else None
        found.append(BodyMotion(name, roll["swing"], about=Attachment(carrier, sketch.pair(surface["circle"]))))
    return found


def wanted(sketch: Sketch) -> "list[tuple[tuple[Run, ...], str, BodyMotion]]":
    """[(runs, role, Motion)]: each coordinate at the first body that it moves, unless that is in a row, which names
    it, and every driven motion."""
    known, found, in_rows = motions(sketch), [], _named_in_rows(sketch)
    for name in sketch.spec.coordinates:
        bare = next((motion for motion in known if (tree := motion.field.tree).kind == "name" and tree.name == name),
                    None) or (None if name in in_rows else _by_rates(name, sketch))
        if bare is not None:
            found.append((lettering.named(name), "coordinate", bare))
    for motion in known:
        node = captions.raw(motion.field, sketch.scene)
        if node.mask and node.mask == sketch.scene.time.mask:
            runs = captions.expression(motion.field, sketch, 18) or lettering.words("driven")
            found.append((runs, "driven", motion))
    return found


def _named_in_rows(sketch: Sketch) -> set[str]:
    """The coordinates that are themselves the motions of bodies in rows."""
    if not sketch.lumped:
        return set()
    from vibcli.drawing.layout.rows import motion

    trees = [motion(sketch.scene.bodies[name]).tree for name in sketch.lumped]
    return {tree.name for tree in trees if tree.kind == "name"}


def _by_rates(name: str, sketch: Sketch) -> BodyMotion:
    """What a coordinate moves most as drawn, where no motion is just that coordinate."""
    scene = sketch.scene
    q = next((q for q in scene.q if q.name == name), None)
    best = None
    for body in scene.bodies.values() if q is not None else ():
        if body.frame is None:
            continue
        nodes = [*body.frame.point(*body.centre), body.frame.angle]
        slopes = [gradient(node).get(q, scene.table.zero) for node in nodes]
        x, y, turn = evaluate(slopes, Floats, sketch.values)
        size = hypot(x, y)
        centre = sketch.pivot(body.name) or Attachment(body.name, sketch.centre(body.name))
        turned = BodyMotion(body.name, None, about=centre, sense=1 if turn > 0 else -1)
        if abs(turn) > 1e-9 and not sketch.spec.dimensions.of(name):
            return turned
        if size > (best[0] if best else 1e-9):
            best = size, BodyMotion(body.name, None, plane.unit((x, y)))
        elif best is None and abs(turn) > 1e-9:
            best = 1e-9, turned
    return best and best[1]


def draw(item: "tuple[tuple[Run, ...], str, BodyMotion]", sketch: Sketch, looks: "Mapping[str, Look]",
         space: "Space") -> tuple[list[Any], list[tuple[float, float]]]:
    """The primitives of an arrow where it fits best, and the places beside which its name may stand."""
    _, role, motion = item
    paths: Any = _straight(motion, sketch, looks) if motion.direction else _round(motion, sketch, looks)
    # an arc may well be within the body that turns
    over, later = (OVER, LATER) if motion.direction else (FILLED, ROUND_LATER)
    best: Any = None
    for rank, (path, make, *own) in enumerate(paths):           # where an arc begins it may cross what turns
        if best is not None and best[0] <= later * rank:
            break
        cost = space.arrow(path, over) + later * rank + sum(
            space.meets(way) + WORDED * (space.path(way) >= TAKEN) for way in own)
        if best is None or cost < best[0]:
            best = cost, path, make
    _, path, make = best
    return make(role), [path[-1], path[len(path) // 2]]


def _straight(motion: BodyMotion, sketch: Sketch, looks: "Mapping[str, Look]") -> Iterator[Path]:
    """Candidates: an arrow beside the body, from a tick level with its middle."""
    e = sketch.frame(_carrier(motion.body, sketch)).turned(motion.direction)
    n, centre = plane.left(e), sketch.frames[motion.body].point(sketch.centre(motion.body))
    points = [sketch.frames[motion.body].point(p) for part in looks[motion.body].outlines or
              looks[motion.body].pieces for p in part.points]
    reach = [plane.dot(plane.minus(p, centre), n) for p in points]
    front = max(plane.dot(plane.minus(p, centre), e) for p in points)
    sides = ((max(reach), 1), (-min(reach), -1))
    if abs(e[1]) > 0.7:
        sides = sides[::-1]
    wide = max(reach) - min(reach) > WIDE
    thin = looks[motion.body].kind in ("rod", "arm", "bob", "bar")
    slanted = thin and min(max(reach) - min(reach), 2 * front) > 2 * SLANT
    for gap in LINES:
        ahead = ticked(plane.plus(centre, e, front + gap), e, n)
        beside = [ticked(plane.plus(centre, n, side * (width + gap)), e, n) for width, side in sides]
        close = [ticked(plane.plus(centre, n, side * (gap + 6)), e, n) for _, side in sides]
        shifted = [ticked(plane.plus(plane.plus(centre, e, front + gap), n, shift), e, n) for shift in (20.0, -20.0)]
        yield from close if slanted else ()
        yield from [ahead, *shifted, *beside] if wide else [*beside, ahead]
        yield from close if thin and not slanted else ()
    yield from _about(centre, max(*map(abs, reach), front), e, n)


def _about(centre: tuple[float, float], far: float, e: tuple[float, float], n: tuple[float, float]) -> Iterator[Path]:
    """Further candidates: arrows about a body, the nearer ones first."""
    for gap in ROUND:
        for k in AROUND:
            yield ticked(plane.plus(plane.polar(centre, far + gap, k * pi / 8), e, -LENGTH / 2), e, n)


def ticked(start: Place, e: Place, n: Place) -> tuple[list[Place], Callable[[str], list[Any]]]:
    """The path of an arrow along e from a tick along n, and what draws it in a role."""
    tip = plane.plus(start, e, LENGTH)
    ends = plane.plus(start, n, -TICK), plane.plus(start, n, TICK)
    path = [*ends, start, tip, plane.plus(tip, n, TICK), plane.plus(tip, n, -TICK), plane.plus(tip, e, 4)]

    def make(role: str) -> "list[Primitive]":
        return [arrow.Polyline(ends, role, 0.9, layer=arrow.ARROW), *arrow.straight(start, tip, role)]
    return path, make


def _carrier(name: str, sketch: Sketch) -> str | None:
    """The body with which the direction of a sliding body turns."""
    record = sketch.scene.bodies[name].record
    for key in ("slide", "move"):
        if key in record and "carrier" in record[key]:
            found: str | None = record[key]["carrier"].text
            return found
    return None


def _round(motion: BodyMotion, sketch: Sketch, looks: "Mapping[str, Look]") -> list[RoundPath]:
    """Candidates: an arc about the joint, from the axis of the body in the positive sense."""
    centre, look = sketch.now(motion.about), looks[motion.body]
    points = [sketch.frames[motion.body].point(p) for part in look.pieces for p in part.points]
    far = max(plane.distance(centre, p) for p in points)
    axis = plane.minus(plane.middle(*plane.corners(points)), centre)
    found, both = [], False
    low, high = plane.corners(points)
    sides = sorted(plane.minus(high, low))
    slender = look.kind in ("rod", "bar") or (look.kind == "rectangle" and 4 * sides[0] < sides[1])
    if slender and plane.distance(axis, (0, 0)) < 0.15 * far:
        axis, both = plane.minus(max(points, key=lambda p: round(plane.distance(centre, p), 3)), centre), True
    if plane.distance(axis, (0, 0)) < 0.15 * far:
        for starts in STARTS:
            for gap in (6.0, 11.0, 17.0, 25.0):
                radius = min(far, 90.0) + gap
                span = min(0.45 * pi, max(28.0 / radius, 0.2))
                found += [_arced(centre, radius, start * pi, start * pi + motion.sense * span) for start in starts]
        return found
    headings = [plane.heading(axis) + turn for turn in ((0.0, pi) if both else (0.0,))]
    size = _size(max(abs(plane.across(plane.unit(axis), plane.minus(p, centre))) for p in points), look, slender)
    for heading in headings:
        radii = [min(max(share * far, min(26.0, 0.8 * far), 13.0), 85.0) + 14 * i * (share * far > 85)
                 for i, share in enumerate(ARCS)] + [NEAR] * (far > LONG)
        for radius in [*radii, *([far + BEYOND] if look.kind in ROUNDED and far < SMALL else [])]:
            span = min(0.5 * pi, max(size / radius, 0.3))
            found.append(_arced(centre, radius, heading, heading + motion.sense * span))
    return found


def _size(half: float, look: "Look", slender: bool) -> float:
    """The length of an arc from the axis of a body half as thick: out of one that is slender, of another within it."""
    if look.kind == "rectangle" and half < INSIDE:
        return max(26.0, half / LEAVING + 0.8 * arrow.HEAD)
    return 26.0 + max(0.0, min(MOST, half) - THIN) if slender else 26.0


def _arced(centre: tuple[float, float], radius: float, start: float, end: float) -> RoundPath:
    parted = start + 0.25 * (end - start)
    beyond = 4.0 / radius if end > start else -4.0 / radius
    path, own = plane.arc(centre, radius, parted, end), plane.arc(centre, radius, start - beyond, parted)
    base = end - (end - start) * min(arrow.HEAD / radius / abs(end - start), 0.6)
    path += [plane.polar(centre, radius + side, base) for side in (arrow.WING, -arrow.WING)]
    path.append(plane.polar(centre, radius, end + beyond))
    return path, lambda role: arrow.round_(centre, radius, start, end, role), own
