"""A problem as a drawing in the style of a textbook figure."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import Primitive, extent
from vibcli.drawing.layout import captions, compose, lettering, notes, plane
from vibcli.drawing.layout.space import Space
from vibcli.drawing.symbols import arrow, connection, coordinate, dimension
from vibcli.drawing.symbols.bodies import carried
from vibcli.drawing.symbols.support import HINGE

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import LetterRuns, Run
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.symbols.dimension import Length
    from vibcli.drawing.symbols.look import Look
    from vibcli.results.problem import Problem

GRAVITY, ROOMY = 30.0, 28.0     # points; the least width and height of what has room for a name beside its middle
COLUMN, FEW = 340.0, 8          # points of a column of text less what is written beside a scene; bodies
SHOWN = "bodies bars shafts beams strings springs dampers inerters forces constraints".split()
SLENDER = ("rod", "arm", "bob", "bar", "ring", "hoop", "rim", "arch", "frame")


def draw(problem: Any) -> list[Any]:
    """The primitives of a scene as drawn, with its names; not wider than a column of text, where its scale decides."""
    stage = _pleasing(problem) if problem.scene.parameters.free else compose.Scenery(problem.scene)
    if not stage.scene.bodies and not stage.scene.members:
        from vibcli.drawing.symbols import abstract

        found = abstract.draw(stage.scene)
        return found + notes.lines(stage, found)
    found, where = compose.figure(stage, stage.sketch)
    left, _, right, _ = extent(found)
    if right - left > COLUMN and 0 < len(stage.sketch.frames) <= FEW:
        stage = compose.Scenery(stage.scene, COLUMN / (right - left))
        found, where = compose.figure(stage, stage.sketch)
    if any("move" in body.record for body in stage.scene.bodies.values()):
        from vibcli.drawing.symbols import path

        found += path.draw(stage)
    return found + annotations(stage, found, where)


def _pleasing(problem: "Problem") -> "Scenery":
    """The stage of a scene with parameters that may be letters."""
    from vibcli.drawing.layout.letters import pleasing

    return pleasing(problem, compose.Scenery)


def annotations(stage: Any, found: Any,
                where: Mapping[str, tuple[Any, ...]]) -> list[Any]:
    """Arrows of coordinates, motions and loads, the names of everything, gravity and notes."""
    sketch, space = stage.sketch, Space(found)
    made: list[Any] = []
    for bunch in stage.bunches:
        space.bar(connection.outline(bunch, sketch))

    def put(parts: "Sequence[LetterRuns | Primitive]") -> None:
        made.extend(parts)
        space.add(parts)

    thin, words = [], []
    for parts, runs, places, role in _loads(stage, space):      # where they act is given: names make room for them
        put(parts)
        words.append((runs, places, role))
    for runs, places, outside, own in _bodies(stage):
        if outside:
            thin.append((runs, places, own))
        else:
            made.append(space.put(runs, places, inside=places, of=own))
    for item in coordinate.wanted(sketch):
        parts, places = coordinate.draw(item, sketch, stage.looks, space)
        put(parts)
        words.append((item[0], places, item[1]))
    for parts, runs, places, role in _of_members(stage, space):
        put(parts)
        if runs:
            words.append((runs, places, role))
    for runs, places, role in words:
        made.append(space.put(runs, places, role))
    for runs, places, own in thin:
        made.append(space.put(runs, places, of=own))
    shaken = _shaken(stage)
    for parts, _, _ in shaken:
        put(parts)
    for name, (middle, normal, *sides) in where.items():
        beside = [plane.plus(middle, normal, 7.0 * side) for side in sides or (1.0, -1.0)]
        runs, role = _gap(*name, sketch) if isinstance(name, tuple) else (_element(name, sketch), "ink")
        made += [space.put(runs, beside, role)] if runs else []
    made += [space.put(runs, places, "driven") for _, runs, places in shaken if runs]
    made += _lengths(stage, space, extent(found + made))
    put(_gravity(sketch, found + made))
    return made + notes.lines(stage, found + made)


def _loads(stage: "Scenery",
           space: Space) -> "Iterator[tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]], str]]":
    """(primitives, runs, places, role) of loads on what has a place, and of all that moves and drives rows."""
    if stage.sketch.spec.get("forces"):
        from vibcli.drawing.symbols import load

        for record in stage.sketch.spec.get("forces").values():
            drawn = load.draw(record, stage.sketch, stage.looks, space)
            if drawn is not None:
                yield *drawn, "load"
    if stage.rows:
        from vibcli.drawing.layout import lumped

        for layout in stage.rows:
            yield from lumped.arrows(layout, stage.scene, stage.sketch)


def _of_members(stage: "Scenery",
                space: Space) -> "Iterator[tuple[list[Any], tuple[Run, ...] | None, list[plane.Place], str]]":
    """The same of what is written on members."""
    if stage.strips:
        from vibcli.drawing.symbols import member_words

        for strip in stage.strips:
            yield from member_words.of(strip, stage.sketch, space)


def contents(spec: Any) -> str:
    """What a scene consists of, in words: "bodies: cart, bob; springs: s"."""
    return "; ".join(f"{section}: {', '.join(names)}" for section in SHOWN if (names := spec.named.get(section)))


def _lengths(stage: "Scenery", space: Space, box: tuple[float, float, float, float]) -> "list[LetterRuns | Primitive]":
    """Those that have room for their label, the shorter ones nearer to what they measure."""
    found, wanted = [], [*dimension.lengths(stage.sketch), *_lengths_of_members(stage)]
    for length in sorted(wanted, key=lambda length: round(plane.distance(length.one, length.two))):
        for parts, runs, places in dimension.ways(length, space, box):
            space.add(parts)
            label = space.put(runs, places, "measure", most=dimension.ROOM)
            if label is not None:
                found += [*parts, label]
                break
    return found


def _lengths_of_members(stage: "Scenery") -> "list[Length]":
    if not stage.strips:
        return []
    from vibcli.drawing.symbols.member_words import lengths

    return lengths(stage.strips, stage.sketch)


def _shaken(stage: "Scenery") -> "list[tuple[list[Primitive], tuple[Run, ...] | None, list[tuple[float, float]]]]":
    """[(primitives, runs, places)] of driven supports; those with the same motion are named once."""
    found, named = [], set()
    for name, record in stage.sketch.moving_points.items():
        at = stage.sketch.frames[name].place
        fields = [field for field in record["moves"] if captions.raw(field, stage.scene).mask]
        direction = (1.0, 0.0) if fields and fields[0] is record["moves"][0] else (0.0, 1.0)
        start = plane.plus(at, plane.left(direction), -20.0)
        one, other = (plane.plus(start, direction, side * 13.0) for side in (-1, 1))
        parts = arrow.straight(one, other, "driven", both=True)
        words = captions.expression(fields[0], stage.sketch, 18) if len(fields) == 1 else None
        text = fields[0].text if fields else name
        runs = (words or lettering.named(name)) if text not in named else None
        named.add(text)
        found.append((parts, runs, [other, start]))
    return found


def _element(name: str, sketch: "Sketch") -> "tuple[Run, ...]":
    record = sketch.spec.connection(name)
    if record is None:
        return lettering.named(name)
    return captions.quantity(record, connection.symbol(record).NAMED_BY, sketch)


def _gap(name: str, key: str, sketch: "Sketch") -> "tuple[tuple[Run, ...], str]":
    """The runs and the role of what is written beside a gap: none where it is zero or too long a formula."""
    field = sketch.spec.connection(name)[key]
    none = captions.raw(field, sketch.scene).is_zero
    return () if none else captions.expression(field, sketch) or (), "measure"


def _bodies(stage: "Scenery") -> "list[tuple[tuple[Run, ...], list[plane.Place], bool, list[Primitive] | None]]":
    """[(runs, places, is there no room within, outlines)] of the masses."""
    found = []
    outlines = [carried(part, stage.sketch.frames[name])
                for name, look in stage.looks.items() for part in look.outlines]
    for name, look in stage.looks.items():
        named = _parts(name, stage.sketch)
        runs = captions.mass(stage.scene.bodies[name].record, stage.sketch)
        if runs is not None and not named:
            named = [(runs, _spots(name, look, stage.sketch), look.kind in SLENDER)]
        found += [(*one, [part for part in outlines if any(plane.inside(place, list(part.points)) for place in one[1])])
                  for one in named]
    for layout in stage.rows:
        from vibcli.drawing.layout.lumped import label_places

        for name, place in layout.places.items():
            runs = captions.mass(stage.scene.bodies[name].record, stage.sketch)
            if runs is not None:
                found.append((runs, label_places(place), False, None))
    return found


def _parts(name: str, sketch: "Sketch") -> "list[tuple[tuple[Run, ...], list[tuple[float, float]], bool]]":
    """The same of the parts of a body that have masses of their own."""
    found = []
    for part in sketch.scene.bodies[name].record.get("parts", ()):
        if "mass" in part and not part.get("cut"):
            from vibcli.drawing.symbols.shape import outline

            shape, points = part.get("shape", "particle"), outline(part, sketch).points
            points = [sketch.frames[name].point(p) for p in points]
            ring = [points[len(points) * i // 8] for i in (3, 1, 5, 7)]
            places = ring if shape in SLENDER and shape != "rod" else [plane.middle(*plane.corners(points))]
            found.append((captions.quantity(part, ("mass",), sketch), places, shape in ("particle", *SLENDER)))
    return found


def _spots(name: str, look: "Look", sketch: "Sketch") -> list[tuple[float, float]]:
    """Where the name of a body belongs: the middle of its largest part; along a rod."""
    if look.kind == "rod":
        record = sketch.scene.bodies[name].record
        ends = [sketch.frames[name].point(sketch.pair(record[key])) for key in ("from", "to")]
        spots = [plane.plus(ends[0], plane.minus(ends[1], ends[0]), share) for share in (0.5, 0.65, 0.35)]
        others = [sketch.centre(other) for other in sketch.frames if other in sketch.scene.bodies and other != name]
        return [spot for spot in spots if all(plane.distance(spot, other) > ROOMY for other in others)] or spots
    if look.kind in ("bob", "arm", "hub", "bar"):
        return [sketch.centre(name)]
    if look.kind in ("ring", "hoop", "rim", "arch", "frame"):
        points = [sketch.frames[name].point(p) for p in look.pieces[0].points]
        if look.kind == "frame":        # beside it
            middle = plane.middle(*plane.corners(points))
            points = [plane.plus(p, plane.unit(plane.minus(p, middle)), 7.0) for p in points]
        return [points[len(points) * i // 8] for i in (3, 1, 5, 7)]
    if look.kind == "disc" and look.pieces[-1].fill == "inner":     # between its rim and that of its hub
        points = [sketch.frames[name].point(p) for part in look.pieces[-2:] for p in part.points]
        half = len(points) // 2
        return [plane.middle(points[half * i // 8], points[half + half * i // 8]) for i in (6, 2, 7, 5, 1, 3)]
    part: Any = max((part for part in look.outlines if part.fill != "paper"), default=look.pieces[-1],
                    key=lambda part: plane.distance(*plane.corners(part.points)))
    return _within(part.points)


def _within(points: Sequence[plane.Place]) -> list[tuple[float, float]]:
    """The middle of an outline, or of what is left of it where that is hollow; beside what lies in a large one."""
    low, high = plane.corners(points)
    width, height = plane.minus(high, low)
    spots = [plane.middle(low, high), *(plane.plus(low, (width * x, height * y))
                                        for y in (0.2, 0.8) for x in (0.5, 0.15, 0.85))]
    found = [spot for spot in spots if plane.inside(spot, list(points))][:3] or spots[:1]
    half = width / 4 + HINGE / 2        # the middle between a pin in the middle and the edge
    aside = [plane.plus(low, (width / 2 + side * half, height * y)) for side in (-1, 1) for y in (0.5, 0.7, 0.3)]
    return found + [spot for spot in aside if min(width, height) > ROOMY and plane.inside(spot, list(points))]


def _gravity(sketch: "Sketch",
             drawn: "list[LetterRuns | Primitive]") -> "list[LetterRuns | Primitive]":
    """An arrow beside the upper right corner of what is drawn; in it, or above it, where that is wide."""
    gravity = sketch.scene.gravity
    if gravity is None:
        return []
    direction = plane.unit([sketch.scene.number(part) for part in gravity], (0.0, -1.0))
    field = sketch.spec.get("gravity")
    runs = () if isinstance(field, list) else captions.expression(field, sketch) or ()
    if not runs or runs[0].text[0].isdigit():
        runs = (*lettering.named("g"), *(lettering.words(" = ") if runs else ()), *runs)
    x, y = _corner(drawn, lettering.size(runs)[0])
    start, tip = (plane.plus((x, y), direction, side * GRAVITY / 2) for side in (-1, 1))
    return [*arrow.straight(start, tip, "ink"), lettering.text(runs, x + 5, y - 4)]


def _corner(drawn: "list[LetterRuns | Primitive]", room: float) -> tuple[float, float]:
    """The middle of the arrow of gravity, beside which a name has room."""
    left, _, right, top = extent(drawn)
    if right - left < COLUMN:
        return right + 18.0, top - GRAVITY / 2
    middle = right - room - 5.0
    boxes = [extent([part]) for part in drawn]
    highest = max(box[3] for box in boxes if box[2] > middle - 18.0)
    return middle, max(top, highest + GRAVITY + 6.0) - GRAVITY / 2
