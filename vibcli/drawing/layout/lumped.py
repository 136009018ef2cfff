"""Rows of lumped bodies: boxes on a floor, discs on a shaft; springs and dampers between them and walls."""

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from math import sin
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import BODY, Circle, Hatch, Polygon, Polyline, Primitive, Run
from vibcli.drawing.layout import captions, gears, lettering, lumped_loads, plane, storeys, tube
from vibcli.drawing.layout.lumped_place import Layout, LumpedPlace
from vibcli.drawing.layout.rows import LumpedRow, carrier, motion
from vibcli.drawing.symbols import arrow, support
from vibcli.drawing.symbols.connection import between, named, symbol
from vibcli.drawing.symbols.parts import ROW, offsets, rows, sides

if TYPE_CHECKING:
    from vibcli.drawing.layout.gears import Mesh
    from vibcli.drawing.layout.rows import Edge
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.elements.rigid_body import Body
    from vibcli.scene.scene import Scene

BOX, LONG, DISC, GAP, LANE, STACK, NAME = 40.0, 68.0, 13.0, 64.0, 22.0, 18.0, 10.0
HALF, RIM, ROOM, SUPPORT, MARGIN, FOOT = 18.0, 30.0, 46.0, 2.5, 8.0, 8.5
COLUMN, CLOSEST, NARROWEST = 375.0, 0.5, 0.7    # points of a row; the least shares of gaps and boxes while it has few
PHONE, TIGHTEST = 415.0, 0.6    # points of a row that a narrow screen shows whole; the least part of those shares
ARROW, BEFORE, AHEAD = 26.0, 24.0, 2.5      # points of an arrow; those that it ends before the next one, for its name


def layouts(found: Sequence[LumpedRow], sketch: "Sketch", left: float, top: float) -> list[Layout]:
    """The Layouts of rows below one another, from the upper left corner on."""
    made: list[Layout] = []
    scene = sketch.scene
    known = gears.meshes(scene)
    for row in found:
        made.append(_special(row, scene, left, top) or _row(row, sketch, left, top, known))
        mesh, other = _mesh(row, made[:-1], known)
        if mesh is not None:
            mate = mesh.gear if mesh.gear in other.places else mesh.mate
            known_size = other.places[mate].height if other.places[mate].gear == -1 else None
            made[made.index(other)] = other = _sized(
                other, mate, known_size or gears.sizes(mesh)[mate], 4 if known_size else 1)
            made[-1] = _meshed(made[-1], other, mate, mesh)
        heights = [place.height for place in made[-1].places.values()]
        top = made[-1].y - ROOM - (max(heights) if made[-1].kind == "row" else 0.0)
    return made


def _row(row: LumpedRow, sketch: "Sketch", left: float, top: float, known: "Sequence[Mesh]") -> Layout:
    """The Layout of bodies on a floor or a shaft."""
    scene = sketch.scene
    turns = any(scene.bodies[name].lumped[0] == "turn" for name in row.bodies)
    across = max([_across(edges) for edges in row.gaps.values()] or [STACK])
    pushed = lumped_loads.height(row, scene)
    height = max(RIM if turns else HALF, 0.5 * across + 4 + pushed)
    racks = {mesh.mate for mesh in known if mesh.rack}
    above = height + 26 + (LANE * len(row.lanes) + 8) * bool(row.lanes) + gears.PINION * bool(racks & set(row.bodies))
    y = top - above
    walled = 0 in row.gaps or any(low < 0 for low, _, _ in row.lanes)
    narrow, close = _shares(row, scene)
    x = left + (_gap(row, 0, sketch, close) if walled else 0.0)
    places = {}
    for i, name in enumerate(row.bodies):
        half, disc = _half(scene.bodies[name], scene, narrow), scene.bodies[name].lumped[0] == "turn"
        gear = 2 if name in racks else 3 if any(mesh.rack and mesh.gear == name for mesh in known) else 0
        places[name] = LumpedPlace((x + half, y), half, height, disc, gear)
        x += 2 * half + _gap(row, i + 1, sketch, close)
    end = len(row.bodies)
    right = x if end in row.gaps or any(high == end for _, high, _ in row.lanes) else None
    return Layout(row, places, left if walled else None, right, y, y + above - 12, sunk=lumped_loads.SUNK * pushed)


def _shares(row: LumpedRow, scene: "Scene") -> tuple[float, float]:
    """(boxes, gaps): how much narrower than of few ones those of many bodies are, so that their row is no wider than a
    column of text."""
    bodies, gaps = sum(2 * _half(scene.bodies[name], scene) for name in row.bodies), GAP * (len(row.bodies) + 1)
    share = min(1.0, COLUMN / (bodies + gaps))
    box, gap = max(share, NARROWEST), max(share, CLOSEST)
    tight = min(1.0, max(TIGHTEST, PHONE / (bodies * box + gaps * gap)))
    return box * tight, gap * tight


def _gap(row: LumpedRow, column: int, sketch: "Sketch", share: float) -> float:
    """The room between two bodies, in which what is written beside its elements fits."""
    records = [edge.record for edge in row.gaps.get(column, ())]
    named = [captions.quantity(record, symbol(record).NAMED_BY, sketch) for record in records]
    return max([GAP * share, lumped_loads.width(row, column, sketch),
                *(lettering.size(runs)[0] + MARGIN for runs in named)])


def _half(body: "Body", scene: "Scene", share: float = 1.0) -> float:
    """Half the width of a body in a row."""
    if body.lumped[0] == "turn":
        return DISC / 2
    if _is_support(body, scene):
        return SUPPORT
    return LONG / 2 if body.record.get("looks") == "bar" else BOX / 2 * share


def _mesh(row: LumpedRow, made: list[Layout], known: "Sequence[Mesh]") -> "tuple[Mesh | None, Layout | None]":
    """The gears by which a row is driven from one above it: (Mesh, Layout), both None where there are none."""
    for mesh in known:
        for layout in made if not mesh.rack else ():
            for upper, lower in ((mesh.gear, mesh.mate), (mesh.mate, mesh.gear)):
                if upper in layout.places and lower in row.bodies and layout.places[upper].gear not in (1, 4):
                    return mesh, layout
    return None, None


def _sized(layout: Layout, name: str, size: float, side: int) -> Layout:
    """A Layout with a gear of a radius."""
    return layout._replace(places={**layout.places, name: layout.places[name]._replace(height=size, gear=side)})


def _meshed(layout: Layout, upper: Layout, mate: str, mesh: "Mesh") -> Layout:
    """A row moved to below another one so that its gear meets `mate`, the other's, which may mesh with one above."""
    sizes, above = gears.sizes(mesh), upper.places[mate]
    (name,) = {*sizes} - {mate}
    size = above.height * sizes[name] / sizes[mate]
    layout = _sized(layout, name, size, -1)
    dx = above.middle[0] - layout.places[name].middle[0]
    dy = upper.y - above.height - size - layout.y
    places = {key: place._replace(middle=plane.plus(place.middle, (dx, dy))) for key, place in layout.places.items()}
    left, right = (None if x is None else x + dx for x in (layout.left, layout.right))
    return layout._replace(places=places, left=left, right=right, y=layout.y + dy, top=layout.top + dy)


def _is_support(body: "Body", scene: "Scene") -> bool:
    """Is this ground that is shaken: without mass, its motion a function of the time?"""
    mask = captions.raw(motion(body), scene).mask
    return body.mass is None and carrier(body) is None and bool(mask) and mask == scene.time.mask


def _special(row: LumpedRow, scene: "Scene", left: float, top: float) -> Layout | None:
    """The Layout of what is no row on a floor or shaft: storeys, or a column of liquid."""
    if storeys.is_one(row, scene):
        return storeys.layout(row, scene, left, top)
    return tube.layout(row, scene, left, top) if tube.is_one(row, scene) else None


def _across(edges: "Sequence[Edge]") -> float:
    """How much room elements between the same two take."""
    records = [edge.record for edge in edges]
    named = NAME if len(records) > 1 or rows(records[0]) > 1 else 0.0
    return 2 * max(offsets(records, STACK)[0], 0.0) + max(STACK, ROW * rows(records[0])) + named


def draw(layout: Layout, moved: Mapping[str, float],
         gap: Callable[[Any], float | None] = lambda _: None) -> tuple[list[Any], dict[str, tuple[Any, ...]]]:
    """The primitives of a row, and where its elements are; `moved`: {body: displacement in points, or angle},
    gap(record): that of an element in motion."""
    if layout.kind == "frame":
        return storeys.draw(layout, moved)
    if layout.kind == "tube":
        return tube.draw(layout, moved)
    places = {name: place if place.turns else place._replace(middle=plane.plus(place.middle, (moved.get(name, 0.0), 0)))
              for name, place in layout.places.items()}
    found: list[Any] = _walls(layout)
    where: dict[str, tuple[Any, ...]] = {}
    for name, place in places.items():
        found += _disc(place, moved.get(name, 0.0)) if place.turns else _box(place)
        if place.gear == 2:
            found += gears.rack(place, layout.places[name])
    for column, edges in layout.row.gaps.items():
        for edge, t in zip(edges, offsets([edge.record for edge in edges], STACK), strict=True):
            start, end = _ends(layout, places, column, t)
            drawn = plane.distance(*_ends(layout, layout.places, column, t))
            found += between(edge.record, start, end, drawn, gap(edge.record))
            where |= named(edge.record, start, end, (0.0, 1.0), *sides(t, edges))
    for lane, (low, high, edge) in enumerate(layout.row.lanes):
        lines, labels = _lane(layout, places, low, high, edge, lane, gap)
        found += lines
        where |= labels
    return found, where


def _ends(layout: Layout, places: Mapping[str, LumpedPlace], column: int, t: float) -> tuple[plane.Place, plane.Place]:
    """Where the elements of a gap begin and end."""
    bodies = layout.row.bodies
    start = layout.left if column == 0 else places[bodies[column - 1]].middle[0] + places[bodies[column - 1]].half
    end = layout.right if column == len(bodies) else places[bodies[column]].middle[0] - places[bodies[column]].half
    return (start, layout.y + t - layout.sunk), (end, layout.y + t - layout.sunk)


def _lane(layout: Layout, places: dict[str, LumpedPlace], low: int, high: int, edge: "Edge", lane: int,
          gap: Callable[[Any], float | None]) -> tuple[list[Any], dict[str, tuple[plane.Place, plane.Place]]]:
    """An element that runs over the bodies between its ends, and where its names belong."""
    y = layout.y + max(place.height for place in places.values()) + 31 + LANE * lane
    feet, (left, right) = _feet(layout, places, low, high), _feet(layout, layout.places, low, high)
    legs = [Polyline(((x, foot), (x, y))) for x, foot in feet if foot is not None]
    start, end = ((x, y) for x, _ in feet)
    return (legs + between(edge.record, start, end, right[0] - left[0], gap(edge.record)),
            named(edge.record, start, end, (0.0, 1.0)))


def _feet(layout: Layout, places: Mapping[str, LumpedPlace], low: int, high: int) -> list[tuple[float, float | None]]:
    """Where an element that runs over bodies stands on them: the heights are None at a wall."""
    bodies = layout.row.bodies
    ends: list[tuple[float, float | None]] = []
    for column, side in ((low, 1), (high, -1)):
        if column < 0 or column == len(bodies):
            ends.append(((layout.left if column < 0 else layout.right), None))
        else:
            place = places[bodies[column]]
            ends.append((place.middle[0] + side * place.leg, layout.y + place.height))
    return ends


def _box(place: LumpedPlace) -> list[Primitive]:
    x, y = place.middle
    if place.half == SUPPORT:
        return [Polygon(tuple(plane.box(place.middle, 2 * place.half, 2 * place.height)), "driven")]
    wheels = [Circle((x + side * max(place.half - 8, 4.5), y - place.height - support.ROLLER), support.ROLLER, "paper")
              for side in (-1, 1)]
    return [Polygon(tuple(plane.box(place.middle, 2 * place.half, 2 * place.height))), *wheels]


def _disc(place: LumpedPlace, angle: float) -> list[Primitive]:
    """A disc from the side; a mark on its rim shows how far it has turned."""
    x, y = place.middle
    level = y + place.height * sin(angle)
    if place.gear:
        return [Polygon(tuple(plane.box(place.middle, 2 * place.half, 2 * place.height))), *gears.edges(place, angle)]
    return [Polygon(tuple(plane.box(place.middle, 2 * place.half, 2 * place.height))),
            *([Polyline(((x - place.half, level), (x + place.half, level)), layer=BODY)] if angle else [])]


def _walls(layout: Layout) -> list[Primitive]:
    """The ground: a floor under boxes, walls at the ends."""
    places = list(layout.places.values())
    if places[0].turns:
        foot, head = layout.y - 22, max(layout.y + 22, layout.top + 8 if layout.row.lanes else layout.y)
        return [Hatch(((x, head), (x, foot)), side) for x, side in ((layout.left, -1), (layout.right, 1))
                if x is not None]
    height = max(place.height for place in places)
    foot, head = layout.y - height - 2 * support.ROLLER, max(layout.y + height,
                                                             layout.top + 8 if layout.row.lanes else 0.0)
    left = [(places[0].middle[0] - places[0].half - 16, foot)]
    right = [(places[-1].middle[0] + places[-1].half + 16, foot)]
    if layout.left is not None:
        left = [(layout.left, head), (layout.left, foot)]
    if layout.right is not None:
        right = [(layout.right, foot), (layout.right, head)]
    return [Hatch((*left, *right), -1)]


def label_places(place: LumpedPlace) -> list[tuple[float, float]]:
    """Where the name of a body may stand: in a box, below a disc, beside a gear."""
    if place.gear in (-1, 1, 4):
        x, y = place.middle[0], place.middle[1] + 0.6 * place.height * (place.gear if place.gear != 4 else 0)
        return [(x + side * (place.half + 8), y) for side in (1, -1)]
    return [place.middle if not place.turns else plane.plus(place.middle, (0, -place.height - FOOT))]


def arrows(layout: Layout, scene: "Scene",
           sketch: "Sketch") -> list[tuple[list[Primitive], tuple[Run, ...], list[tuple[Any, ...]], str]]:
    """[(primitives, runs, places for them, role)] of the coordinates and loads of a row."""
    found, legged = [], {layout.row.bodies[low] for low, *_ in layout.row.lanes if low >= 0}
    for name, place in layout.places.items():
        body = scene.bodies[name]
        field = motion(body)
        x, y = place.middle[0], place.middle[1] + place.height + 9
        if layout.kind == "frame":      # beside the storey
            x, y = x + place.half + 6, place.middle[1]
        if place.gear == 2:             # beside the pinion
            x += 0.25 * place.half
        elif name in legged and layout.kind == "row" and not place.turns:       # beside what stands on it
            x += place.leg + 4.0
        if place.gear == -1:            # away from the other gear
            y = place.middle[1] - place.height - 15
        if place.gear == 4:             # beside it
            x, y = x + place.half + 16, place.middle[1] - 6
        driven = captions.raw(field, scene).mask == scene.time.mask
        runs = _displacement(body, scene, sketch)
        role = "driven" if driven else "coordinate"
        tip = (x + _reach(layout), y)
        if layout.kind == "tube":
            parts, tip = tube.arrow_of(place, role)
        elif place.turns:
            parts, tip = arrow.over((x, y), role), (x + 8, y + 6)
        else:
            bar = Polyline(((x, y - 5), (x, y + 5)), role, 0.9, layer=arrow.ARROW)
            parts = [bar, *arrow.straight((x, y), tip, role)]
        found.append((parts, runs, [plane.plus(tip, (AHEAD, 0.0))], role))
    for record in (scene.spec.get("forces") or {}).values():
        found += lumped_loads.draw(record, layout, sketch)
    return found


def _reach(layout: Layout) -> float:
    """How long the arrows of a row are."""
    xs = sorted(place.middle[0] for place in layout.places.values()) if layout.kind == "row" else []
    return min([ARROW, *(b - a - BEFORE for a, b in pairwise(xs) if b - a > BEFORE)])


def _displacement(body: "Body", scene: "Scene", sketch: "Sketch") -> tuple[Run, ...]:
    """The runs of how far a body is displaced or turned: of one that is carried, behind those of its carriers."""
    field, under = motion(body), carrier(body)
    own = captions.expression(field, sketch, 18) or lettering.words(field.text)
    return own if under is None else (*_displacement(scene.bodies[under], scene, sketch), *lettering.words(" + "), *own)
