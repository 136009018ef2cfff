"""What is written about members: their names, what is attached, loads on them, preload, lengths."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import Primitive, Run
from vibcli.drawing.layout import captions, hung, lettering, plane
from vibcli.drawing.layout.rows import motion
from vibcli.drawing.layout.strips import Strip, resting
from vibcli.drawing.symbols import acting, arrow, member_ends, support
from vibcli.drawing.symbols.coordinate import ticked
from vibcli.drawing.symbols.dimension import SHORTEST, Length, named_length
from vibcli.drawing.symbols.member import ASIDE, Bend, preload

if TYPE_CHECKING:
    from vibcli.drawing.layout.hung import Hung
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.space import Space
    from vibcli.language.reader import Expression, Record

NAMED_BY, PUSH, BESIDE, ROW, APART = ("EI", "EA", "GIo"), 30.0, 9.0, 20.0, 18.0
ASIDE_OF_LEGS = 4.0     # points from a name to a line that leads to a length
FAINT = 0.1         # the least part of the largest load of a row that has an arrow
NAMED_AT = 0.3, 0.7, 0.5, 0.4, 0.6      # parts of a length where its name may stand


def of(strip: Strip, sketch: "Sketch", space: "Space") -> Iterator[tuple[list[Any], Any, list[Any], str]]:
    """(primitives, runs, places for them, role) of all that is written on a member."""
    record, bend = strip.member.record, Bend(resting(strip, sketch.values), strip.scale if strip.placed else 0.0)
    for runs, places, within in member_ends.names(member_ends.draw(strip, bend, sketch)[1], sketch):
        if within:
            yield [space.put(runs, places, inside=places)], None, [], "ink"
        else:
            yield [], runs, places, "ink"
    name = _name(record, sketch)
    yield [], name, [strip.at(x, side * 10.0) for x in _free(name, strip, sketch) for side in (1, -1)], "ink"
    if "preload" in record:
        yield preload(strip, sketch), captions.expression(_size(record["preload"]), sketch), [
            strip.at(strip.metres, ASIDE, 14.0)], "load"
    yield from _points(strip, sketch, space)
    for one in hung.on(strip, sketch):
        yield _motion(one, strip, sketch, space)
    for load in (sketch.spec.get("forces") or {}).values():
        if "per_length" in load and load["body"].text == strip.name:
            yield _spread(load, strip, sketch, space)


def _name(record: "Record", sketch: "Sketch") -> tuple[Run, ...]:
    """Its stiffnesses, the letters of each making one name, else the name of the member."""
    told: tuple[Run, ...] = ()
    for key in NAMED_BY:
        if key in record:
            text = record[key].text.strip()
            found = (Run(text, True, lettering.SIZE),) if text in NAMED_BY else captions.expression(record[key], sketch)
            told += (*(lettering.words(", ") if told and found else ()), *(found or ()))
    return told or lettering.words(record.name)


def _free(name: tuple[Run, ...], strip: Strip, sketch: "Sketch") -> list[float]:
    """The places along a member where its name may stand: none where a line to a length would strike it, if there are
    others."""
    places = [part * strip.metres for part in NAMED_AT]
    measured = [x for low, high, runs in _lengths(strip, sketch) if runs for x in (low, high)]
    room = (lettering.size(name)[0] / 2 + ASIDE_OF_LEGS) / strip.scale
    return [x for x in places if all(abs(x - at) > room for at in measured)] or places


def _size(field: "Expression") -> "Expression":
    from vibcli.drawing.symbols.load import unsigned

    found: Expression = unsigned(field)
    return found


def _points(strip: Strip, sketch: "Sketch",
            space: "Space") -> "Iterator[tuple[list[Primitive], tuple[Run, ...] | None, list[plane.Place], str]]":
    """Points on a member, with the loads on one that has no place."""
    for name, record in (sketch.spec.get("member_points") or {}).items():
        if record["body"].text != strip.name:
            continue
        x = sketch.number(record["at"])
        here = strip.at(x)
        yield support.dot(here), None, [], "ink"
        for load in (sketch.spec.get("forces") or {}).values():
            if getattr(load.get("at"), "text", None) == name:
                found = _load(load, strip, here, sketch, space)
                if found is not None:
                    yield found


def _motion(one: "Hung", strip: Strip, sketch: "Sketch",
            space: "Space") -> "tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]], str]":
    """The arrow of a body that hangs on a member."""
    n, field = plane.left(strip.e), motion(sketch.scene.bodies[one.body])
    way, aside = (n, strip.e) if strip.sideways else (strip.e, n)
    middle = strip.at(sketch.number(one.at), -member_ends.REACH - 2 * member_ends.SIDE)
    starts = [plane.plus(middle, aside, side * 26.0) for side in (1, -1)]
    path, make = min((ticked(start, way, aside) for start in starts), key=lambda found: space.arrow(found[0]))
    return make("coordinate"), captions.expression(field, sketch, 18), [path[3]], "coordinate"


def _load(load: "Record", strip: Strip, here: tuple[float, float], sketch: "Sketch",
          space: "Space") -> "tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]], str] | None":
    n = plane.left(strip.e)
    if "moment" in load:
        runs = captions.expression(load["moment"], sketch, 18) or lettering.named(load.name)
        if strip.member.kind.torsional:
            above = plane.plus(here, n, 12.0)
            return arrow.over(above, "load", 1.7), runs, [plane.plus(above, (10.0, 6.0))], "load"
        return arrow.round_(here, 15.0, -0.6, 2.2, "load", 1.7), runs, [plane.plus(here, n, 18.0)], "load"
    if strip.placed or "force" not in load or isinstance(load["force"], list):
        return None
    sense, field = _sensed(load["force"])
    runs = captions.expression(field, sketch, 18) or lettering.named(load.name)
    way = plane.times(n if strip.sideways else strip.e, sense)
    starts = [here, plane.plus(here, way, -PUSH)] if strip.sideways else [
        here, *(plane.plus(plane.plus(here, n, side * BESIDE), way, -back) for back in (PUSH, 0.0) for side in (1, -1))]
    start, tip = min(((place, plane.plus(place, way, PUSH)) for place in starts), key=lambda path: space.arrow(
        [plane.plus(path[0], way, 7), plane.plus(path[1], way, -5)]))
    return arrow.straight(start, tip, "load", 1.7), runs, [tip, start] if strip.sideways else [tip], "load"


def _sensed(field: "Expression") -> "tuple[float, Expression]":
    """(−1, the field without its leading minus) of a load that acts the other way; (1, the field)."""
    shorter = _size(field)
    return (1.0, field) if shorter is field else (-1.0, shorter)


def _spread(load: "Record", strip: Strip, sketch: "Sketch",
            space: "Space") -> tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]], str]:
    """A row of arrows beside a member, where it crosses least, along it on bars; each as long as the load is there."""
    start, end = (sketch.number(load[key]) if key in load else x
                  for key, x in (("from", 0.0), ("to", strip.metres)))
    count = max(2, round((end - start) * strip.scale / APART))
    places = [start + (end - start) * i / count for i in range(count + strip.sideways)]
    field = _sensed(load["per_length"])[1]
    shares = [(x, share) for x, share in zip(places, _shares(load, places, sketch), strict=True) if abs(share) > FAINT]

    def row(aside: float) -> "list[tuple[tuple[float, float], tuple[float, float]]]":
        near, far = (aside, aside + ROW) if aside > 0 else (aside + ROW, aside)
        found = [((strip.at(x, near), strip.at(x, near + (far - near) * abs(share))) if strip.sideways else
                  (strip.at(x, aside), strip.at(x, aside, 0.7 * APART * abs(share))), (share > 0) is (far > near))
                 for x, share in shares]
        return [path if onward else path[::-1] for path, onward in found]

    aside = min((6.0, 12.0, 16.0, -6.0 - ROW, 24.0)[not strip.sideways:],
                key=lambda aside: sum(map(space.arrow, row(aside))))
    parts = [part for path in row(aside) for part in arrow.straight(*path, "load", 0.9)]
    runs = captions.expression(field, sketch, 24) or lettering.named(load.name)
    middle = (start + end) / 2
    return parts, runs, [strip.at(middle, aside + (ROW + 4 if aside > 0 else -4.0))], "load"


def _shares(load: "Record", places: Sequence[float], sketch: "Sketch") -> list[float]:
    """What a load is at each of some places, as a part of the most, when it first acts."""
    node = captions.raw(load["per_length"], sketch.scene)
    found = [value for value, in acting.values([node], sketch, [{"x": x} for x in places])]
    most = max(map(abs, found))
    return [value / most for value in found] if most else [_sensed(load["per_length"])[0]] * len(places)


def lengths(strips: Sequence[Strip], sketch: "Sketch") -> list[Length]:
    """The Lengths of members and of their segments, each as it is written."""
    found, known = [], set()
    for strip in strips:
        for low, high, runs in _lengths(strip, sketch):
            key = strip.placed, lettering.letters(runs or ())
            if runs and key not in known and (high - low) * strip.scale > SHORTEST:
                known.add(key)
                found.append(Length(runs, strip.at(low), strip.at(high)))
    return found


def _lengths(strip: Strip, sketch: "Sketch") -> Iterator[tuple[float, float, tuple[Run, ...] | None]]:
    record = strip.member.record
    if "segments" in record:
        for part, (low, high, _) in zip(record["segments"], strip.segments, strict=True):
            if "length" in part:
                yield low, high, captions.expression(part["length"], sketch)
    elif "length" in record:
        yield 0.0, strip.metres, captions.expression(record["length"], sketch)
    elif "from" in record:
        yield 0.0, strip.metres, named_length(strip.metres, (record["from"], record["to"]), sketch)
    for part in record.get("attached", ()):
        x = sketch.number(part["at"])
        if 0.0 < x < strip.metres * (1 - 1e-9):
            yield 0.0, x, captions.expression(part["at"], sketch)
