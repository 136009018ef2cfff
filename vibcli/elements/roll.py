"""Rolling without slip on a line or a circle, fixed or carried.

On a line with unit vector e and the body's centre on the side s = ±1 of its left normal: u = −s r θ.
On a circle of radius R, the line of centres turning by ψ: ρ ψ = σ r θ, with ρ = R + r and σ = 1 outside,
ρ = R − r and σ = −1 inside, and ρ = r − R, σ = 1 where the body encloses the circle (a ring on a peg). A flat side
stays tangent, ψ = θ; with n and t along and across the line from O to the contact, that place of the side which touches
as drawn is at O + R n − R ψ t. Between two surfaces the body rolls on the first; the second is tied to it, or says how.
The angles θ and ψ are relative to the surface's carrier; `turn` is θ in the fixed frame.
"""

from typing import TYPE_CHECKING

from vibcli.elements.contact import CircleContact, LineContact
from vibcli.elements.rigid_body import Body, touched
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, MotionField, NameOf, Quantity
from vibcli.language.named_place import DRAWN
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record
    from vibcli.scene.builder import Builder
    from vibcli.scene.places import Frame
    from vibcli.symbolic.node import Node

FAR = ("travel", "turn", "swing")
_SURFACE = NameOf("the name of a surface", "surfaces")


def _settle(record: "Record", reader: "Reader") -> None:
    names = [reference.text for reference in record.get("between", ())]
    if names and names[0] == names[1]:
        reader.report(record.place("between"), f"'between' names '{names[0]}' twice", "name two different surfaces, or "
                      "write `surface:`")


ELEMENT = Element(
    "roll",
    "The body rolls without slip on a surface, on its round side or a `flat` one. One of `travel` (displacement of its "
    "centre along the surface, positive from a line's first place to its second, counter-clockwise about a circle's "
    "centre), `turn` (rotation in the fixed frame), on circles `swing` (turn of the line of centres relative to the "
    "surface) says how far. What rolls `between` two surfaces needs none of them.",
    {
        "surface": Field(_SURFACE, "what it rolls on"),
        "between": Field(Many(_SURFACE, 2, 2, "two surfaces [one, two]"), "two surfaces on both of which it rolls. "
                         "With a coordinate it rolls on the first, and the second is tied to it; with none its motion "
                         "follows from those of the bodies that carry both"),
        "travel": Field(MotionField("m"), "displacement of the centre relative to the surface"),
        "turn": Field(MotionField("rad"), "rotation in the fixed frame, counter-clockwise"),
        "swing": Field(MotionField("rad"), "turn of the line of centres relative to the surface, on circles"),
        "radius": Field(Quantity("m"), "the radius it rolls on, where that is not the radius of its shape"),
        "flat": Field(Many(DRAWN, 2, 2, "two places [[x, y], [x, y]]"), "two places on its flat side as drawn, where "
                      "it is that side which rolls, on the outside of a circle"),
    },
    exclusive=(("surface", "between"), FAR, ("flat", "radius"), ("flat", "travel"), ("flat", "between")),
    needs=(("surface", "between"), (*FAR, "between")),
    settle=_settle,
    example="rolling_in_a_track",
)


def build(roll: "Record", body: Body, scene: "Builder") -> Body:
    """A rolling body with its frame about the centre of the rolling circle, and the normal of the surface."""
    if "flat" in roll:
        surface = scene.surfaces[roll["surface"].text]
        return _flat(roll, body, scene.rim(body, roll.where), scene, surface, scene.carrier(surface, "body"))
    contacts = _contacts(roll, body, scene)
    if contacts is None:
        return body._replace(frame=scene.still(body.centre))
    rolled, turn = _motion(roll, body, scene, contacts)
    body = body._replace(frame=contacts[0].frame(rolled, turn))
    if not any(key in roll for key in FAR):
        return body
    return body._replace(normal=contacts[0].normal(rolled), reach=contacts[0].reach if "between" in roll else None)


def tie(roll: "Record", body: Body, scene: "Builder") -> None:
    """Add the conditions of the second contact to the scene: no slip where the body has a coordinate of its own, and no
    gap where both could part."""
    contacts = _contacts(roll, body, scene)
    gap, slip = _parted(contacts[0], contacts[1], body.frame, scene)
    tied = [("normal", gap), ("friction", slip)] if any(key in roll for key in FAR) else [("normal", gap)]
    for part, node in tied:
        if node.mask and not is_zero(node):
            scene.add_constraint(body.record, node, "contact", f".{part}.{roll['between'][1].text}")


def _contacts(roll: "Record", body: Body, scene: "Builder") -> "list[LineContact | CircleContact] | None":
    """The contacts of a round body with its surfaces; None where they were reported as wrong."""
    before = len(scene.diagnostics)
    radius = scene.positive(roll["radius"], "the radius it rolls on") if "radius" in roll else body.rolling_radius
    if radius is None:
        scene.report(roll.where, f"'{body.name}' has no radius to roll on", "give `radius`, a shape that is round, "
                     "or two places of the `flat` side that rolls")
        return None
    drawn, found = scene.rim(body, roll.where), []
    for reference in touched(body.record):
        surface = scene.surfaces[reference.text]
        carrier = scene.carrier(surface, "body")
        if "curve" in surface:
            scene.report(reference.where, "bodies roll on lines and circles, not on other curves",
                         "`slide: {surface: …, by: …}` moves a particle along a curve")
        else:
            found.append(_on_line(roll, body, drawn, scene, surface, radius, carrier) if "line" in surface else
                         _on_circle(roll, body, drawn, scene, surface, radius, carrier))
    return found if len(scene.diagnostics) == before else None


def _on_line(roll: "Record", body: Body, drawn: "tuple[Node, Node]", scene: "Builder", surface: "Record",
             radius: "Node", carrier: "Frame") -> LineContact:
    (ax, ay), (bx, by) = (scene.pair(place) for place in surface["line"])
    ex, ey = scene.unit(bx - ax, by - ay, surface.where)
    height = (drawn[1] - ay) * ex - (drawn[0] - ax) * ey
    scene.require_equal(scene.absolute(height), radius, roll.where,
                        f"'{body.name}' does not touch its line as drawn: its centre is {{}} m away, its radius {{}} m",
                        "move the body or the line until they touch")
    if "swing" in roll and body.touched[0] == surface.name:
        scene.report(roll.place("swing"), "'swing' is for circles", "on a line use `travel` or `turn`")
    return LineContact(carrier, drawn, radius, (ex, ey), scene.sign(height))


def _on_circle(roll: "Record", body: Body, drawn: "tuple[Node, Node]", scene: "Builder", surface: "Record",
               radius: "Node", carrier: "Frame") -> CircleContact:
    centre = cx, cy = scene.pair(surface["circle"])
    track = scene.positive(surface["radius"], "the radius of the circle")
    inside = surface.get("side") == "inside"
    distance = scene.distance(drawn[0] - cx, drawn[1] - cy)
    encloses = not inside and scene.sign(distance - radius) < 0
    arm = track - radius if inside else radius - track if encloses else track + radius
    scene.require_equal(distance, arm, roll.where, f"'{body.name}' does not touch its circle as drawn: the centres are "
                        f"{{}} m apart, where {{}} m is due {'inside' if inside else 'outside'}",
                        "move the body, or say on which `side` of the circle it is")
    if not scene.number(arm):
        scene.report(roll.where, f"'{body.name}' is as large as the circle it rolls on", "give another radius")
    return CircleContact(carrier, drawn, radius, centre, arm, -1 if inside else 1, -1 if inside or encloses else 1,
                         distance)


def _motion(roll: "Record", body: Body, scene: "Builder",
            contacts: list[LineContact | CircleContact]) -> "tuple[Node, Node]":
    """(how far the body has rolled on its first surface, its turn)."""
    first = contacts[0]
    if "turn" in roll:
        turn = scene.change(roll["turn"])
    elif "swing" in roll or "travel" in roll:
        rolled = scene.change(roll["swing" if "swing" in roll else "travel"])
        if "travel" in roll and isinstance(first, CircleContact):
            rolled = rolled / first.arm
        return rolled, first.turn(rolled)
    else:
        turn = _carried_turn(roll, body, scene, *contacts)
    return first.rolled(turn), turn


def _carried_turn(roll: "Record", body: Body, scene: "Builder", first: LineContact | CircleContact,
                  second: LineContact | CircleContact) -> "Node":
    """The turn of a body that slips on neither surface, from the motions of both carriers."""
    unknown = scene.table.variable(f"the turn of {body.name}")
    _, slip = _parted(first, second, first.frame(first.rolled(unknown), unknown), scene, held=True)
    slope = textbook(gradient(textbook(slip)).get(unknown, scene.table.zero))
    if slope.mask or not scene.number(slope):
        scene.report(roll.where, f"how '{body.name}' turns does not follow from its two surfaces as a sum",
                     "give it a coordinate, as in `turn: phi`, which the second contact ties")
        return scene.table.zero
    turn = -substitute([slip], {unknown: scene.table.zero})[0] / slope
    if scene.supports:
        turn = turn - _parted(first, second, first.frame(first.rolled(turn), turn), scene)[1] / slope
    return turn


def _parted(first: LineContact | CircleContact, second: LineContact | CircleContact, frame: "Frame", scene: "Builder",
            held: bool = False) -> "tuple[Node, Node]":
    """(gap, slip) of the second contact of a body with this frame, to first order in supports that give way; those
    `held` do not."""
    now, here, there = (_held(one, scene) for one in (frame, first.carrier, second.carrier))
    one, two = first._replace(carrier=here), second._replace(carrier=there)
    gap, slip = two.parted(now, _swing(one, two, now.angle, scene))
    if held or not scene.supports:
        return gap, slip
    nx, ny = two.normal(two.rolled(now.angle))
    place = now.place[0] - two.reach * nx, now.place[1] - two.reach * ny
    dx, dy = (a - b for a, b in zip(frame.point(*now.seen(*place)), second.carrier.point(*there.seen(*place)),
                                    strict=True))
    return gap + _first_order(dx * nx + dy * ny, scene), slip + _first_order(dx * ny - dy * nx, scene)


def _first_order(node: "Node", scene: "Builder") -> "Node":
    """What a node that vanishes unless supports give way is to first order in how far they do."""
    slopes = gradient(node)
    held = substitute(list(slopes.values()), dict.fromkeys(scene.supports, scene.table.zero))
    return sum((slope * q for q, slope in zip(slopes, held, strict=True) if q in scene.supports), scene.table.zero)


def _held(frame: "Frame", scene: "Builder") -> "Frame":
    """A frame where no support gives way."""
    nodes = frame.nodes
    return frame.over(dict(zip(nodes, substitute(nodes, dict.fromkeys(scene.supports, scene.table.zero)), strict=True)))


def _swing(first: LineContact | CircleContact, second: LineContact | CircleContact, turn: "Node",
           scene: "Builder") -> "Node | None":
    """By how much the line of centres turns in the carrier of the second of two circles about one centre; None of
    others."""
    if not (isinstance(first, CircleContact) and isinstance(second, CircleContact)) or not all(
            scene.vanishes(a - b) for a, b in zip(first.middle, second.middle, strict=True)):
        return None
    return first.carrier.angle + first.rolled(turn) - second.carrier.angle


def _flat(roll: "Record", body: Body, drawn: "tuple[Node, Node]", scene: "Builder", surface: "Record",
          carrier: "Frame") -> Body:
    """On the outside of a circle with a flat side."""
    if "circle" not in surface or surface.get("side") == "inside":
        scene.report(roll["surface"].where, "a flat side rolls on the outside of circles only",
                     "what is round rolls on lines and inside of circles: leave `flat` out")
        return body._replace(frame=scene.still(body.centre))
    (ax, ay), (bx, by) = (scene.pair(place) for place in roll["flat"])
    (cx, cy), radius = scene.pair(surface["circle"]), scene.positive(surface["radius"], "the radius of the circle")
    ex, ey = scene.unit(bx - ax, by - ay, roll.place("flat"))
    height = (cy - ay) * ex - (cx - ax) * ey
    side = scene.sign(height)
    scene.require_equal(scene.absolute(height), radius, roll.where, f"the flat side of '{body.name}' does not touch "
                        "its circle as drawn: it is {} m away from the centre, where {} m is due",
                        "move the body, or mind the two places of `flat`")
    if scene.sign((cx - ax) * ex + (cy - ay) * ey) < 0 or scene.sign((bx - cx) * ex + (by - cy) * ey) < 0:
        scene.report(roll.place("flat"), f"the flat side of '{body.name}' does not reach its contact as drawn",
                     "the contact lies between the two places of `flat`")
    nx, ny = side * ey, -side * ex
    swing = scene.change(roll["swing"]) if "swing" in roll else scene.change(roll["turn"]) - carrier.angle
    centre = scene.new_frame((cx, cy), carrier.point(cx, cy), carrier.angle + swing)
    rolled, (x0, y0) = radius * swing, drawn
    place = centre.point(x0 + rolled * ny, y0 - rolled * nx)
    return body._replace(normal=centre.turned(nx, ny), frame=scene.new_frame(drawn, place, centre.angle))
