"""What holds members and what is attached to them: walls, supports, springs, dampers, masses, discs, oscillators."""

from collections.abc import Callable, Iterator, Sequence
from math import pi, sin
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import BODY, JOINT, SURFACE, Circle, Polygon, Polyline, Primitive
from vibcli.drawing.layout import captions, hung, plane
from vibcli.drawing.layout.strips import Strip
from vibcli.drawing.symbols import damper, spring, support
from vibcli.drawing.symbols.joint import Turn
from vibcli.drawing.symbols.member import Bend, place
from vibcli.language.member_signals import oscillator_names
from vibcli.language.signal_names import signal_name

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import DrawnFrame, Sketch
    from vibcli.language.reader import Expression, Record

REACH, BALL, DISC, SIDE, BESIDE = 34.0, 5.2, 21.0, 8.0, 44.0
REST = 11.0         # points of a rail beyond what slides on it
HELD = ("clamped", "pinned", "guided")


def draw(strip: Strip, bend: Bend, sketch: "Sketch") -> tuple[list[Any], list[tuple[Any, Any, list[Any]]]]:
    """(primitives, [(record, key, places for its name)]) of the ends and of all that is attached."""
    found, named = [], []
    for side, x, sense in (("left", 0.0, -1.0), ("right", strip.metres, 1.0)):
        _end(strip.member.record.get(side, "free"), strip, bend, x, sense, sketch, found, named)
    unnamed = iter(oscillators(strip, sketch))
    for record in strip.member.record.get("attached", ()):
        x = sketch.number(record["at"])
        if "support" in record:
            found += _support(record["support"], strip, place(strip, bend, x), x)
        _attached(record, strip, bend, x, 1.0 if x > 0.999 * strip.metres else -1.0 if x < 1e-3 * strip.metres else 0.0,
                  found, named)
        if "oscillator" in record:
            name = next(unnamed)[1]
            aside = (int(signal_name(name).axis or 1) - 1) * (BESIDE if x < 0.5 * strip.metres else -BESIDE)
            _oscillator(record["oscillator"], strip, bend, x, aside, sketch.values[name], found, named)
    for one in hung.on(strip, sketch):
        _oscillator(one.parts, strip, bend, sketch.number(one.at), 0.0, sketch.lumped[one.body], found, named)
    return found, named


def supports(strip: Strip, bend: Bend, sketch: "Sketch") -> list[Any]:
    """What holds a member to the ground alone: walls and bearings at its ends, and along it."""
    found: list[Any] = []
    for side, x, sense in (("left", 0.0, -1.0), ("right", strip.metres, 1.0)):
        end = strip.member.record.get(side, "free")
        if isinstance(end, str) and end != "free":
            found += _held(end, strip, place(strip, bend, x), plane.times(strip.e, sense), strip.at(x))
    for record in strip.member.record.get("attached", ()):
        if "support" in record:
            x = sketch.number(record["at"])
            found += _support(record["support"], strip, place(strip, bend, x), x)
    return found


def _end(end: "Record | str", strip: Strip, bend: Bend, x: float, sense: float, sketch: "Sketch",
         found: "list[Primitive]",
         named: "list[tuple[Record, str, list[tuple[float, float]]]]") -> None:
    here, outward = place(strip, bend, x), plane.times(strip.e, sense)
    if isinstance(end, str):
        if end != "free":
            found += _held(end, strip, here, outward, strip.at(x))
        return
    word = next((word for word in HELD if word in end), None)
    if word is None:
        _attached(end, strip, bend, x, sense, found, named)
    elif strip.placed:
        found += support.hinge(here) if word == "pinned" or strip.member.kind.name == "bar" else []
        found += _rail(sketch.frames[end[word].text], strip.at(x), here, strip) if word == "guided" else []
    elif end[word].text in sketch.scene.bodies and end[word].text not in sketch.numbers.get("standing", ()):
        body = sketch.scene.bodies[end[word].text].record
        key = next((key for key in ("mass", "inertia") if key in body), None)
        found += _mass(strip, bend, x, sense, key or "mass")
        named.append((body, key, [plane.plus(here, outward, 14.0), plane.plus(here, (0.0, -1.0), 14.0)]))


def _rail(frame: "DrawnFrame", drawn: tuple[float, float], here: tuple[float, float], strip: Strip) -> list[Primitive]:
    """What an end slides along on the body that guides it, as far as it has gone."""
    middle = frame.point(drawn)
    n = plane.unit(plane.minus(here, middle), frame.turned(plane.left(strip.e)))
    half = REST + plane.distance(here, middle)
    return [Polyline((plane.plus(middle, n, -half), plane.plus(middle, n, half)), width=2.4, layer=SURFACE)]


def branches(strips: "Sequence[Strip]", sketch: "Sketch",
             on: Callable[[Strip, float], tuple[float, float]]) -> list[Primitive]:
    """Dashed lines from ends of members without a place to the members that hold them; `on` one: displaced."""
    found: list[Primitive] = []
    known = {strip.name: strip for strip in strips}
    for strip in strips:
        for side, x in (("left", 0.0), ("right", strip.metres)):
            for _, name in held(strip.member, side):
                if name in known and not strip.placed:
                    there = on(known[name], sketch.number(strip.member.record[side]["at"]))
                    found.append(Polyline((on(strip, x), there), "measure", 0.8, True, SURFACE))
    return found


def held(one: Any, side: str) -> list[tuple[str, str]]:
    """[(how, the name of the body or member)] of what holds an end of a member, where anything does."""
    end = one.record.get(side, "free")
    return [] if isinstance(end, str) else [(word, end[word].text) for word in HELD if word in end]


def _held(word: str, strip: Strip, here: tuple[float, float], outward: tuple[float, float],
          drawn: tuple[float, float]) -> "list[Primitive]":
    """A wall, a bearing on the ground, or rollers on a wall that stays where it is drawn."""
    if word == "guided":
        side = plane.left(outward)
        rollers = [Circle(plane.plus(plane.plus(here, outward, 3.0), side, t), 3.0, "paper") for t in (-6.0, 6.0)]
        return [*rollers, *support.wall(plane.plus(drawn, outward, 6.0), outward,
                                        14.0 + plane.distance(here, drawn))]
    if word == "pinned" and strip.member.kind.bends:
        return support.bearing(here, _down(strip, outward))
    if word == "pinned" and strip.placed:
        return support.bearing(here, outward)
    return support.wall(here, outward, 14.0)


def _down(strip: Strip, outward: tuple[float, float]) -> tuple[float, float]:
    """Where the ground of a bearing lies: below; at the foot or head of what stands beyond its end."""
    return (0.0, -1.0) if abs(strip.e[0]) > 0.5 else outward


def _support(word: str, strip: Strip, here: tuple[float, float], x: float) -> "list[Primitive]":
    """A roller below, a wall beside a clamp."""
    n = plane.left(strip.e)
    half = strip.half(x)
    foot = plane.plus(here, n, -half)
    if strip.member.kind.bends and word == "pinned":
        return support.rocker(foot, strip.e)
    head = plane.plus(here, n, half)
    return [*support.floor(foot, strip.e, 9.0), *support.floor(head, plane.times(strip.e, -1), 9.0)]


def _attached(record: "Record", strip: Strip, bend: Bend, x: float, sense: float,
              found: "list[Primitive]",
              named: "list[tuple[Record, str, list[tuple[float, float]]]]") -> None:
    here, n = place(strip, bend, x), plane.left(strip.e)
    across, moved = strip.sideways, plane.minus(here, strip.at(x))      # the ground stays where it is drawn
    outward = plane.times(strip.e, sense or 1.0)
    for key in ("mass", "inertia"):
        if key in record and not (key == "inertia" and "mass" in record):
            found += _mass(strip, bend, x, sense, key)
            named.append((record, key, [plane.plus(here, n, 10.0), plane.plus(here, outward, 10.0)]))
    lanes = [key for key in ("k", "c") if key in record]
    for i, key in enumerate(lanes):
        lane = (i - 0.5 * (len(lanes) - 1)) * 15.0
        start = plane.plus(here, strip.e if across else n, lane)
        way = plane.times(n, -1.0) if across else outward
        start = plane.plus(start, way, strip.half(x) if across else 0.0)
        if strip.member.kind.torsional:
            start = plane.plus(here, n, -strip.half(x) - 3.0)
            way = plane.times(n, -1.0)
        end = plane.minus(plane.plus(start, way, REACH), moved)
        symbol = spring if key == "k" else damper
        found += [*symbol.between({}, start, end, REACH), *support.wall(end, way, 9.0)]
        beside = plane.times(strip.e if across else n, 10.0 if lane >= 0 else -10.0)
        named.append((record, key, [plane.plus(plane.middle(start, end), beside)]))
        if len(lanes) > 1:
            found.append(Polyline((here, start)))
    if "torsion" in record:
        parts, (middle, normal) = spring.about({}, Turn(here, plane.heading(outward) + pi, 0.0, None, 0))
        found += parts
        named.append((record, "torsion", [plane.plus(middle, normal, 6.0)]))


def hanging(strip: Strip, sketch: "Sketch") -> list[tuple[float, str]]:
    """[(place, coordinate)] of the oscillators on a member and of the bodies that hang from it."""
    return oscillators(strip, sketch) + [(sketch.number(one.at), one.moves) for one in hung.on(strip, sketch)]


def oscillators(strip: Strip, sketch: "Sketch") -> list[tuple[float, str]]:
    """[(place, coordinate)] of the oscillators on a member."""
    found, unnamed = [], {}
    for record in strip.member.record.get("attached", ()):
        if "oscillator" in record:
            x = sketch.number(record["at"])
            station = min(strip.member.stations, key=lambda one: abs(sketch.scene.number(one.place) - x))
            there = unnamed.setdefault(station.text, oscillator_names(strip.name, station.text))
            found.append((x, next(there)))
    return found


def _oscillator(record: "dict[str, Expression] | Record", strip: Strip, bend: Bend, x: float, aside: float,
                moved: float, found: "list[Primitive]", named: list[Any]) -> None:
    """A block that hangs on springs and dampers, displaced beside the line or along a bar; on a shaft a mark on it
    tells how far it has turned. It hangs `aside` of others at its place."""
    here, n, e = place(strip, bend, x), plane.times(plane.left(strip.e), -1.0), strip.e
    top, deep = plane.plus(here, n, strip.half(x)), strip.half(x) + REACH
    across, along = plane.dot(plane.minus(strip.at(x), here), n), plane.dot(plane.minus(here, strip.at(x)), e)
    foot = (strip.at(x, moved * bend.unit - deep, along) if strip.sideways else
            strip.at(x, across - deep, 0.0 if strip.member.kind.torsional else moved * bend.unit))
    top, foot = plane.plus(top, e, aside), plane.plus(foot, e, aside)
    keys = [key for key in ("k", "torsion", "c") if key in record]
    for i, key in enumerate(keys):
        lane = (i - 0.5 * (len(keys) - 1)) * 15.0
        start, end = plane.plus(top, e, lane), plane.plus(foot, e, lane)
        symbol = damper if key == "c" else spring
        found += symbol.between({}, start, end, REACH)
        named.append((record, key, [plane.plus(plane.middle(start, end), e, 10.0 if lane >= 0 else -10.0)]))
    middle = plane.plus(foot, n, 8.0)
    found.append(Polygon(tuple(plane.box(middle, 32.0, 16.0, plane.heading(e))), layer=BODY))
    if strip.member.kind.torsional:
        found += _mark(middle, e, 16.0, 8.0, moved * bend.unit, bend.seen)
    named.append((record, "mass" if "mass" in record else "inertia", [middle]))


def _mass(strip: Strip, bend: Bend, x: float, sense: float, key: str) -> list[Primitive]:
    """A ball on what moves across, a block at or about a bar, a disc from the side on a shaft."""
    here, angle = place(strip, bend, x), plane.heading(strip.e)
    if strip.member.kind.torsional:
        middle, ((_, turned),) = plane.plus(here, strip.e, 4.0 * sense), bend.at([x])
        return [Polygon(tuple(plane.box(middle, 8.0, 2 * DISC, angle)), layer=JOINT),
                *_mark(middle, strip.e, 4.0, DISC, turned * bend.unit, bend.seen)]
    if strip.member.kind.name == "bar":
        middle = plane.plus(here, strip.e, SIDE * sense)
        return [Polygon(tuple(plane.box(middle, 2 * SIDE, 24.0, angle)), layer=JOINT)]
    return [Circle(here, BALL, "ink" if key == "mass" else "inner", layer=JOINT)]


def _mark(middle: tuple[float, float], e: tuple[float, float], half: float, radius: float, turned: float,
          seen: bool) -> list[Primitive]:
    """A line along what turns about the direction e and is seen from the side, `turned` points of its rim; none where
    it is not turned, and not `seen` to turn."""
    level = plane.plus(middle, plane.left(e), radius * sin(turned / radius))
    ends = tuple(plane.plus(level, e, side) for side in (-half, half))
    return [Polyline(ends, layer=JOINT)] if seen or abs(turned) > 1e-6 else []


def names(named: list[tuple[Any, Any, list[Any]]], sketch: "Sketch") -> Iterator[tuple[Any, list[Any], bool]]:
    """(runs, places for them, are they within it?) of what is attached: one that has one place is named there."""
    for record, key, places in named:
        if key is not None:
            runs = captions.expression(record[key], sketch)
            if runs:
                yield runs, places, key in ("mass", "inertia") and len(places) == 1
