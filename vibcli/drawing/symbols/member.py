"""Members as drawn: the thickness of their segments, straight or bent, what they rest on, their preload, and ordinates
of what they do along their axis or about it."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas.primitives import BEHIND, BODY, ELEMENT, SURFACE, Circle, Hatch, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.strips import Strip, grid
from vibcli.drawing.symbols import arrow

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch

BED, BED_SPRING, PULL, ASIDE = 17.0, 22.0, 22.0, 20.0
NODE = 2.4
LEAST = 1.0         # points: ordinates that can be seen
CLEAR = 4.0         # points between a bed and what leads through it


class Bend(NamedTuple):
    """How a member is displaced: `at(places)` gives [(along, u)], `unit` points for one of u; `nodes` where it
    rests; `lengthwise`: it has ordinates of what it does along its line; `seen`: ordinates, also in a position of its
    motion in which they vanish."""

    at: Callable[[list[float]], list[tuple[float, float]]]
    unit: float
    nodes: Sequence[float] = ()
    lengthwise: bool = False
    seen: bool = False


def place(strip: Strip, bend: Bend, x: float) -> tuple[float, float]:
    """Where a place of a member is, displaced."""
    (along, u), = bend.at([x])
    return _moved(strip, bend, x, along, u)


def _moved(strip: Strip, bend: Bend, x: float, along: float, u: float) -> tuple[float, float]:
    if strip.sideways:
        return strip.at(x, u * bend.unit, along * bend.unit)
    if strip.placed:
        return strip.at(x, u * strip.scale, along * bend.unit)
    return strip.at(x) if strip.member.kind.torsional else strip.at(x, 0.0, u * bend.unit)


def draw(strip: Strip, bend: Bend) -> list[Any]:
    """The member itself; shafts, bars and beams that move along alone have ordinates."""
    found: list[Any] = []
    xs = grid(strip, bend.nodes)
    rows = dict(zip(xs, bend.at(xs), strict=True))
    axis = {x: _moved(strip, bend, x, *row) for x, row in rows.items()}
    if strip.member.kind.name == "string":
        found.append(Polyline(tuple(axis[x] for x in xs), width=1.5, layer=ELEMENT))
    else:
        found += [_body([axis[x] for x in xs if low - 1e-12 <= x <= high + 1e-12], half)
                  for low, high, half in strip.segments]
    if not strip.sideways or bend.lengthwise:
        found += _ordinates(strip, bend, xs, rows, axis)
    nearest = [min(xs, key=lambda place: abs(place - node)) for node in bend.nodes]     # of equal places one is drawn
    found += [Circle(axis[x], NODE, "paper", "coordinate", 1.0, layer=ELEMENT) for x in nearest]
    return found


def _body(points: Sequence[tuple[float, float]], half: float) -> Polygon:
    """A band about an axis, which may be bent."""
    sides = []
    for i in range(len(points)):
        e = plane.unit(plane.minus(points[min(i + 1, len(points) - 1)], points[max(i - 1, 0)]))
        sides.append(plane.left(e))
    above = [plane.plus(p, n, half) for p, n in zip(points, sides, strict=True)]
    below = [plane.plus(p, n, -half) for p, n in zip(points, sides, strict=True)]
    return Polygon((*above, *below[::-1]), layer=BODY)


def _ordinates(strip: Strip, bend: Bend, xs: Sequence[float], rows: Mapping[float, tuple[float, float]],
               axis: dict[float, tuple[float, float]]) -> list[Primitive]:
    """u of bars, φ of shafts, drawn across the axis."""
    which = 0 if strip.placed else 1
    n = plane.left(strip.e)
    if not bend.seen and max(abs(rows[x][which]) for x in xs) * bend.unit < LEAST:
        return []
    axis = axis if strip.placed else {x: strip.at(x) for x in xs}
    tips = [plane.plus(axis[x], n, rows[x][which] * bend.unit) for x in xs]
    legs = [Polyline((axis[x], tip), "coordinate", 0.5, layer=ELEMENT)
            for x, tip in list(zip(xs, tips, strict=True))[::4]]
    return [*legs, Polyline(tuple(tips), "coordinate", 1.3, layer=ELEMENT)]


def bed(strip: Strip, bend: Bend, attached: Sequence[Any]) -> list[Any]:
    """A row of springs below the segments that rest on a foundation, as long as the member leaves them room, with the
    ground under them: open where what is `attached` leads through it."""
    found: list[Any] = []
    for part, (low, high, half) in zip(strip.member.segments, strip.segments, strict=True):
        if part.foundation.is_zero:
            continue
        count = max(2, round((high - low) * strip.scale / BED_SPRING))
        every = [low + (high - low) * (i + 0.5) / count for i in range(count)]
        through = _through(strip, half, attached)
        clear = [x for x in every if not any(a < x < b for a, b in through)]
        across = [u * bend.unit if strip.sideways else 0.0 for _, u in bend.at(clear or every)]
        found += [_small_spring(strip, x, half, rise) for x, rise in zip(clear or every, across, strict=True)]
        last = low
        for a, b in [*(through if clear else ()), (high, high)]:
            if min(a, high) > last:
                ground = strip.at(last, -half - BED), strip.at(min(a, high), -half - BED)
                found.append(Hatch(ground, -1, layer=SURFACE))
            last = max(last, b)
    return found


def _through(strip: Strip, half: float,
             attached: Sequence[Primitive]) -> list[tuple[float, float]]:
    """[(from, to)] in metres, ascending: where strokes of what is attached lie in the bed below a segment, but those of
    blocks, which come there in motion alone."""
    found = []
    for stroke in (stroke for part in attached if part.layer != BODY for stroke in part.strokes()):
        offsets = [plane.minus(point, strip.start) for point in stroke]
        depths = [-plane.across(strip.e, offset) - half for offset in offsets]
        if max(depths) > CLEAR and min(depths) < BED + CLEAR:
            along = [plane.dot(strip.e, offset) for offset in offsets]
            found.append(((min(along) - CLEAR) / strip.scale, (max(along) + CLEAR) / strip.scale))
    return sorted(found)


def _small_spring(strip: Strip, x: float, half: float, rise: float) -> Polyline:
    """A spring from the ground to a member that has risen there by so many points."""
    points = [strip.at(x, rise - half)]
    for i in range(5):
        points.append(strip.at(x, rise - half - (BED + rise) * (i + 0.75) / 6, 2.6 * (-1) ** i))
    return Polyline((*points, strip.at(x, -half - BED)), "spring", 0.8, layer=BEHIND)


def preload(strip: Strip, sketch: "Sketch") -> list[Any]:
    """Arrows beside both ends, outwards where the member is pulled as drawn."""
    if "preload" not in strip.member.record:
        return []
    pulled = sketch.number(strip.member.record["preload"]) >= 0
    found = []
    for x, sense in ((0.0, -1.0), (strip.metres, 1.0)):
        inner, outer = (strip.at(x, ASIDE, sense * far) for far in (-4.0, PULL - 4.0))
        found += arrow.straight(inner, outer, "load") if pulled else arrow.straight(outer, inner, "load")
    return found
