"""Dimension lines: given lengths that a body shows, where there is room for them."""

from collections.abc import Iterator, Sequence
from math import pi
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas.primitives import LEADER, Polyline, Primitive, Run
from vibcli.drawing.layout import captions, lettering, plane
from vibcli.drawing.layout.space import TAKEN
from vibcli.drawing.symbols import arrow
from vibcli.drawing.symbols.look import ROD

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.space import Space
    from vibcli.elements.rigid_body import Body
    from vibcli.language.named_place import NamedPlace
    from vibcli.language.reader import Expression, Record

OFFSETS = (15.0, 23.0, 32.0, 42.0, 54.0, 68.0, 84.0)
FAR = 102.0, 122.0      # of what has no room nearer
SHORTEST, ROOM, BEYOND, CROWDED, CUT, LEG, STRUCK = 24.0, 5.0, 3.0, 4.0, 2.0, 0.4, 0.4
OWN = 8.0           # points from a place that are still on the body
STUB, STEP = 2 * BEYOND, 2.0        # of what leads to a dimension line: its least length, by which it is shorter
STARTS = 0.1, 0.2, 0.3, 0.4, 0.5, 0.6       # of a radius: where its line may begin
TIP = 4.5           # points of a dimension line that may lie on the rod of a dashpot at its end, but not on coils


class Length(NamedTuple):
    """A length between two places as drawn, and what it is called; `radial` from a centre to a rim, of which there are
    other places in `rims`."""

    runs: tuple[Run, ...]
    one: tuple[float, float]
    two: tuple[float, float]
    radial: bool = False
    rims: tuple[tuple[float, float], ...] = ()


def lengths(sketch: "Sketch") -> list[Length]:
    """The Lengths of all bodies, each parameter once."""
    found, known = [], set()
    for name in sketch.frames:
        body = sketch.scene.bodies.get(name)
        for length, key in _of_body(body, sketch) if body is not None else ():
            if key not in known:
                known.add(key)
                found.append(length)
    return found


def _of_body(body: "Body", sketch: "Sketch") -> Iterator[tuple[Length, str]]:
    """[(Length, its text)] of one body."""
    for record in body.record.get("parts", (body.record,)):
        yield from _radius(record, sketch)
    origin = sketch.pivot(body.name)
    places = _places(body, sketch)
    if origin is not None:
        places = [(origin.drawn, body.record["pin"].get("at")), *places]
    for i, (one, first) in enumerate(places):
        for two, second in places[i + 1:]:
            length = plane.distance(one, two)
            runs = named_length(length / sketch.scale, (first, second), sketch) if length > SHORTEST else None
            if runs is not None:
                yield Length(runs, one, two), lettering.letters(runs)


def _places(body: "Body", sketch: "Sketch") -> "list[tuple[tuple[float, float], list[Expression] | NamedPlace]]":
    """[(place, the fields that say where it is)] of the ends of a rod and of what a body carries."""
    found = []
    if body.record.get("shape") == "rod":
        found = [(sketch.pair(body.record[key]), body.record[key]) for key in ("from", "to")]
    elif "at" in body.record:
        found = [(sketch.pair(body.record["at"]), body.record["at"])]
    for record in (sketch.spec.get("points") or {}).values():
        if "body" in record and record["body"].text == body.name:
            found.append((sketch.pair(record["at"]), record["at"]))
    return found


def named_length(value: float, fields: Any, sketch: "Sketch") -> Any:
    """The runs of the one parameter that has this value and stands in the fields; None of none or several."""
    names = {name for field in fields if isinstance(field, list) for part in field
             for name, *_ in part.parts.names} & set(sketch.spec.parameters)
    equal = [name for name in names if abs(sketch.values.get(name, 0.0) - value) <= 1e-9 * value]
    return lettering.named(equal[0]) if len(equal) == 1 else None


def _radius(record: "Record", sketch: "Sketch") -> Iterator[tuple[Length, str]]:
    """The radius of a disc or ring, at an angle of its own, or at others."""
    if "radius" not in record or record.get("shape") not in ("disc", "ring", "sector", "arch"):
        return
    runs, radius = captions.expression(record["radius"], sketch, 6), sketch.length(record["radius"])
    if runs is None or radius < SHORTEST:
        return
    centre = sketch.pair(record["at"])
    angles = [sense * pi / 5 for sense in (1, 4, -4, -1)]
    if record["shape"] in ("sector", "arch"):
        axis, half = sketch.number(record["angle"]) if "angle" in record else 0.0, sketch.number(record["half_angle"])
        angles = [axis + share * half for share in (0.6, -0.6, 0.85, -0.85)]
    rim, *rims = (plane.polar(centre, radius, angle) for angle in angles)
    yield Length(runs, centre, rim, True, tuple(rims)), lettering.letters(runs)


Drawn = tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]]]


def ways(length: Length, space: "Space", box: tuple[float, float, float, float]) -> Iterator[Drawn]:
    """(primitives, runs, places for them) of those for which there is room within or beside a box, the better first;
    beside a line that stands upright first away from what it measures, where no other line is."""
    if length.radial:
        tried = [_radial(length, rim, space) for rim in (length.two, *length.rims)]
        yield from (drawn for _, drawn in sorted(filter(None, tried), key=itemgetter(0)))
        return
    upright = abs(length.two[1] - length.one[1]) > abs(length.two[0] - length.one[0])
    for offsets in ((*OFFSETS, *FAR), FAR):
        best = _straight(length, space, offsets)
        if best is not None and best.met:
            best = _straight(length, space, (*offsets, *_beyond(length, box)))
        if best is not None:
            drawn = parts, runs, places = _drawn(length, best)
            if upright:
                yield parts, runs, places[:1]
            yield drawn


def _beyond(length: Length, box: tuple[float, float, float, float]) -> list[float]:
    """The offsets on either side of lines that lie beyond all that is drawn."""
    n = plane.left(plane.unit(plane.minus(length.two, length.one)))
    reach = [plane.dot(plane.minus((x, y), length.one), n) for x in box[::2] for y in box[1::2]]
    return sorted(OFFSETS[0] + far for far in (max(reach), -min(reach)))


def _radial(length: Length, rim: tuple[float, float], space: "Space") -> tuple[float, Drawn] | None:
    """(what it meets, Drawn): from the centre, or from beside a spiral or dashpot that is there."""
    at, radius = plane.along(length.one, rim), plane.distance(length.one, rim)
    starts = [(0.0, min(4.0, radius / 2)), *((share * radius, share * radius) for share in STARTS)]
    met, start, first = min((space.meets([at(first), at(0.9 * radius)]), start, first) for start, first in starts)
    if space.path([at(first), at(0.9 * radius)]) > 2 * CROWDED:
        return None
    parts = [part._replace(width=0.7) for part in arrow.straight(at(start), rim, "measure", 0.7)]
    return met, (parts, length.runs, [plane.plus(plane.middle(at(start), rim), plane.left(
        plane.unit(plane.minus(rim, length.one))), side) for side in (2.0, -2.0)])


class _Line(NamedTuple):
    """A dimension line from `a` to `b` on a side (±1) of what it measures, what leads to it, the cost of it all, and
    that of the springs, dampers and arrows that it crosses."""

    rank: float
    met: float
    a: tuple[float, float]
    b: tuple[float, float]
    side: int
    legs: list[Any]


def _straight(length: Length, space: "Space", offsets: Sequence[float]) -> _Line | None:
    """The best _Line at one of some offsets, None where there is none."""
    e = plane.unit(plane.minus(length.two, length.one))
    n = plane.left(e)
    best = None
    for offset in offsets:
        if best is not None and best.rank <= 0.1 * offset:
            break
        for side in (-1, 1):
            a, b = plane.plus(length.one, n, side * offset), plane.plus(length.two, n, side * offset)
            label = plane.plus(plane.middle(a, b), n, side * 7.0)
            line, clear = ([plane.plus(a, e, off), plane.plus(b, e, -off)] for off in (2.0, TIP))
            cost = space.path(line) + space.path([label, label])
            coiled = space.coiled(line)
            rank = CUT * cost + 0.1 * offset + space.crossings(clear) + coiled
            if cost > CROWDED or (best is not None and rank >= best.rank):
                continue
            legs = [_leg(plane.plus(p, n, side * (ROD + 2)), plane.plus(q, n, side * BEYOND), space)
                    for p, q in ((length.one, a), (length.two, b))]
            if max(map(space.path, legs)) >= TAKEN:     # they strike no word
                continue
            struck = sum(space.path([plane.plus(p, n, side * OWN), q]) for p, q in legs)
            rank += STRUCK * struck + LEG * sum(map(space.meets, legs))
            if best is None or rank < best.rank:
                best = _Line(rank, space.meets(clear) + coiled, a, b, side, legs)
    return best


def _drawn(length: Length, line: _Line) -> Drawn:
    n = plane.left(plane.unit(plane.minus(length.two, length.one)))
    legs = [Polyline(leg, "measure", 0.6, layer=LEADER) for leg in line.legs]
    parts = [part._replace(width=min(part.width, 0.7))
             for part in arrow.straight(line.a, line.b, "measure", 0.7, both=True)]
    return [*legs, *parts], length.runs, [plane.plus(plane.middle(line.a, line.b), n, sign * 1.5)
                                          for sign in (line.side, -line.side)]


def _leg(start: tuple[float, float], end: tuple[float, float],
         space: "Space") -> tuple[tuple[float, float], tuple[float, float]]:
    """What leads from a place to the line of a dimension; only behind a word that is between them, and behind a spring,
    a rope or an arrow along which it would run from there."""
    length, at = plane.distance(start, end), plane.along(start, end)
    whole = length
    while length > STUB and (space.path([start, end]) >= TAKEN or space.meets([start, at(whole - length + STUB)])):
        length -= STEP
        start = at(whole - length)
    return start, end
