"""Bodies: what each is, where it is drawn, how it may move.

A placed body contributes ½ m (ẋ_C² + ẏ_C²) + ½ J_C θ̇² and its weight; a lumped one, which has no place, ½ m u̇² or
½ J φ̇². Several shapes welded together have m = Σ mᵢ, the common mass centre, and J_C = Σ (Jᵢ + mᵢ d²) by the
parallel axis theorem; a part with `cut: true` counts negative.
"""

from typing import TYPE_CHECKING

from vibcli.elements import ELEMENTS, body_checks
from vibcli.elements.rigid_body import MOTIONS, Body
from vibcli.elements.shapes import LAWS, NEEDS
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Choice, Flag, Many, Quantity
from vibcli.language.named_elements import Lazy, load
from vibcli.language.named_place import DRAWN

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

    Place = tuple[Node, Node]
    Piece = tuple[Node | None, Place, Node | None, Place, Node | None]

_LENGTH, _ANGLE = Quantity("m"), Quantity("rad")
_SHAPE = {
    "shape": Field(Choice(*NEEDS), "what it is (default: particle)"),
    "mass": Field(Quantity("kg"), "its mass; massless without it"),
    "density": Field(Quantity(), "mass per area (or per length of a rod, ring or arch), instead of the mass"),
    "at": Field(DRAWN, "where its mass centre is drawn; of a sector or arch, and beside `parts`, the centre O of its "
                "circle"),
    "from": Field(DRAWN, "one end of a rod"),
    "to": Field(DRAWN, "the other end of a rod"),
    "angle": Field(_ANGLE, "how the shape is turned as drawn: the axis of a sector or arch, the width of a "
                   "rectangle, a of an ellipse; 0 is along +x"),
    "radius": Field(_LENGTH, "radius of a disc, ring, sector or arch"),
    "half_angle": Field(_ANGLE, "half the opening angle of a sector or arch"),
    "width": Field(_LENGTH, "width of a rectangle, along its angle"),
    "height": Field(_LENGTH, "height of a rectangle"),
    "a": Field(_LENGTH, "semi-axis of an ellipse, along its angle"),
    "b": Field(_LENGTH, "the other semi-axis of an ellipse"),
}

PART = Element("part", "One of several shapes welded into a body.",
               {**_SHAPE, "mass": Field(Quantity("kg"), "its mass"),
                "cut": Field(Flag(), "`true`: a hole of this shape; its mass or density is that of what is cut out")},
               exclusive=(("mass", "density"), ("at", "from")), needs=(("mass", "density"), ("at", "from")),
               settle=body_checks.part, example="welded_parts")
ROUND = tuple(shape for shape, sizes in NEEDS.items() if "radius" in sizes)
CLOSE = 1e-9
ELEMENT = Element(
    "body",
    "A rigid body or particle: its shape and mass, where it is drawn, and the one key that says how it may move; "
    "without one it is fixed. A body without a place is lumped, on an axis: `{mass: m, slide: x}` or "
    "`{inertia: J, turn: phi}`.",
    {
        **_SHAPE,
        "inertia": Field(Quantity("kg*m^2"), "moment of inertia about the mass centre, overriding the shape's"),
        "gyration": Field(_LENGTH, "radius of gyration about the mass centre, overriding the shape's"),
        "parts": Field(Many(PART, 1, 50, "a list of parts"), "several shapes welded into this body"),
        "looks": Field(Choice(*body_checks.LOOKS), "what it is drawn as, which changes no result: a bar, slab or frame "
                       "over all that it carries, the cam under what slides or, with a pin, that itself; without a "
                       "place a bar (a rack where gears move it), the storey of a frame, or liquid in a U-tube"),
        **{name: Field(Lazy(name), ELEMENTS[name][1]) for name in MOTIONS},
    },
    exclusive=(("mass", "density", "parts"), ("at", "from"), ("at", "to"), ("inertia", "gyration"), MOTIONS,
               ("shape", "parts"), ("shape", "looks"), ("parts", "looks")),
    settle=body_checks.body,
    example="bodies_of_every_shape",
    instead={"hinge": "did you mean 'pin'?", "pivot": "did you mean 'pin'?", "weight": "did you mean 'mass'?",
             "J": "did you mean 'inertia'?", "length": "a rod has two ends: `from` and `to`"},
)


def build(record: "Record", scene: "Builder") -> Body:
    """The body of a record, its frame included; its energies are added to the scene."""
    body = Body(record.name, record)
    placed = any(key in record for key in ("at", "from", "parts"))
    motion = next((key for key in MOTIONS if key in record), None)
    try:
        body = _with_inertia(body, scene, placed)
        if not placed:
            body = body._replace(lumped=load(motion).lump(record[motion], scene))
        elif motion is None:
            body = body._replace(frame=scene.still(body.centre))
        else:
            body = scene.supported(load(motion).build(record[motion], body, scene))
            if "between" in record.get("roll", ()) and not scene.diagnostics:
                load("roll").tie(record["roll"], body, scene)
        _add_energies(body, motion, scene)
    except ZeroDivisionError:
        scene.report(record.where, f"the geometry of '{record.name}' divides by zero as drawn",
                     "look for a length or a mass that vanishes")
    return body


def _with_inertia(body: Body, scene: "Builder", placed: bool) -> Body:
    """The body with its mass, J_C, mass centre and circles."""
    record = body.record
    if "parts" in record:
        pieces = [_piece(part, scene, part.get("cut", False)) for part in record["parts"]]
        mass, centre, inertia = _welded(pieces)
        if not scene.number(mass) > 0 or not scene.number(inertia) >= 0:
            scene.report(record.place("parts"), f"the parts of '{body.name}' do not leave a positive mass and inertia",
                         "a hole lies within the shape that it is cut from")
        if not {"inertia", "gyration"} & set(record):
            parts = [piece[:3] for piece in pieces]
            holed = any(part.get("cut") for part in record["parts"])
            body = body._replace(cut=parts) if holed else body._replace(pieces=parts)
        rims, radius = _rims_of_parts(record, pieces, scene)
    else:
        mass, centre, inertia, drawn, radius = _piece(record, scene, False, placed)
        rims = [] if radius is None else [drawn]
    if "inertia" in record:
        inertia = scene.positive(record["inertia"], f"the inertia of '{body.name}'", zero=True)
    elif "gyration" in record:
        inertia = mass * scene.positive(record["gyration"], f"the radius of gyration of '{body.name}'", zero=True) ** 2
    return body._replace(mass=mass, inertia=inertia, centre=centre, rims=rims, rolling_radius=radius)


def _rims_of_parts(record: "Record", pieces: "list[Piece]", scene: "Builder") -> "tuple[list[Place], Node | None]":
    """(centres as drawn, radius) of the circles of a body of parts, its holes where nothing else is round; `at` of the
    body names the centre outright. The radius is None where the circles are of several sizes."""
    rims = [(piece[3], piece[4], part.get("cut", False)) for part, piece in zip(record["parts"], pieces, strict=True)
            if part.get("shape") in ROUND]
    rims = [rim for rim in rims if not rim[2]] or rims
    if "at" in record:
        at = scene.pair(record["at"])
        rims, centres = [rim for rim in rims if _same(rim[0], at, scene)], [at]
    else:
        centres = _different([rim[0] for rim in rims], scene)
    radii = _different([(rim[1], scene.table.zero) for rim in rims], scene)
    return centres, radii[0][0] if len(radii) == 1 else None


def _different(places: "list[Place]", scene: "Builder") -> "list[Place]":
    found = []
    for place in places:
        if not any(_same(place, other, scene) for other in found):
            found.append(place)
    return found


def _same(one: "Place", two: "Place", scene: "Builder") -> bool:
    near, far = (sum(abs(scene.number(part)) for part in parts)
                 for parts in ([a - b for a, b in zip(one, two, strict=True)], [*one, *two]))
    return near <= CLOSE * far


def _piece(record: "Record", scene: "Builder", cut: bool, placed: bool = True) -> "Piece":
    """(mass, mass centre, J_C, drawn place, rolling radius) of one shape."""
    table, shape = scene.table, record.get("shape", "particle")
    if shape == "rod":
        (ax, ay), (bx, by) = scene.pair(record["from"]), scene.pair(record["to"])
        drawn = ((ax + bx) / 2, (ay + by) / 2)
        sizes = [scene.distance(bx - ax, by - ay)]
        if not scene.number(sizes[0]):
            scene.report(record.place("to"), "this rod has no length", "draw its two ends apart")
    else:
        drawn = scene.pair(record["at"]) if placed else (table.zero, table.zero)
        sizes = [scene.positive(record[key], f"the {key.replace('_', ' ')}") for key in NEEDS[shape]]
        if shape in ("sector", "arch") and scene.number(sizes[1]) > 3.1415926535897936:
            scene.report(record.place("half_angle"), "the half angle is more than π", "180 deg is the whole circle")
    uniform = LAWS[shape](table, *sizes)
    centre = drawn
    if uniform.offset is not None:
        angle = scene.lower(record["angle"]) if "angle" in record else table.zero
        centre = (drawn[0] + uniform.offset * table.call("cos", angle),
                  drawn[1] + uniform.offset * table.call("sin", angle))
    if "mass" in record:
        mass = scene.positive(record["mass"], "the mass", zero=True)
    elif "density" in record:
        mass = scene.positive(record["density"], "the density", zero=True) * uniform.measure
    else:
        return None, centre, None, drawn, uniform.radius
    mass = -mass if cut else mass
    return mass, centre, mass * uniform.gyration2, drawn, uniform.radius


def _welded(pieces: "list[Piece]") -> "tuple[Node, Place, Node]":
    """Mass, mass centre and J_C of several pieces."""
    zero = pieces[0][0].table.zero
    mass = sum((m for m, *_ in pieces), zero)
    x, y = (sum((m * centre[i] for m, centre, *_ in pieces), zero) / mass for i in (0, 1))
    inertia = sum((own + m * ((px - x) ** 2 + (py - y) ** 2) for m, (px, py), own, _, _ in pieces), zero)
    return mass, (x, y), inertia


def _add_energies(body: Body, motion: str | None, scene: "Builder") -> None:
    """½ m (ẋ_C² + ẏ_C²) + ½ J_C θ̇² and the weight; of a lumped body ½ m u̇² or ½ J φ̇²."""
    if body.frame is None:
        weight = body.mass if motion == "slide" else body.inertia
        if weight is not None:
            scene.add_inertia(weight, body.lumped[1])
        return
    for mass, centre, inertia in body.pieces or ((body.mass, body.centre, body.inertia),):
        if mass is not None:
            x, y = body.frame.point(*centre)
            scene.add_inertia(mass, x)
            scene.add_inertia(mass, y)
            scene.add_weight(mass, x, y)
        if inertia is not None:
            scene.add_inertia(inertia, body.frame.angle)
