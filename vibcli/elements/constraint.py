"""Constraints: what ties motions together. Each gives conditions G(q, t) = 0 that hold as drawn.

    join   x_A = x_B, y_A = y_B                     link   (|AB|² − L²)/(2L) = 0, L as drawn
    point  on a line, circle or curve               gear   r₁(φ₁ − φ_c) ± r₂(φ₂ − φ_c) = 0, φ_c the carrier's turn
    belt   r₁(φ₁ − φ_c) = ± r₂(φ₂ − φ_c)            rope   its length is constant (elements/rope.py)
"""

from typing import TYPE_CHECKING

from vibcli.elements import rope
from vibcli.elements.ends import angle_of
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, PLACE, EquationField, Flag, Many, NameOf, Quantity
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record, Reference
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

_TWO_BODIES = Many(BODY, 2, 2, "two bodies [one, two]")
_TWO_PLACES = Many(PLACE, 2, 2, "two points [A, B]")
KINDS = ("equation", "rope", "gear", "belt", "join", "link", "point")
_GOES_WITH = {"surface": ("point",), "radii": ("gear", "belt"), "carrier": ("gear", "belt"), "inside": ("gear",),
              "crossed": ("belt",)}


def _settle(record: "Record", reader: "Reader") -> None:
    for key, kinds in _GOES_WITH.items():
        if key in record.places and not any(kind in record.places for kind in kinds):
            reader.report(record.place(key), f"'{key}' goes with " + " or ".join(f"'{kind}'" for kind in kinds),
                          f"write `{kinds[0]}:`, or leave it out")
    for kind in ("gear", "belt", "join", "link"):
        ends = [getattr(end, "text", None) for end in record.get(kind, ())]
        if ends and ends[0] is not None and ends[0] == ends[1]:
            reader.report(record.place(kind), f"'{kind}' ties '{ends[0]}' to itself", "name two different ones")
    if "point" in record.places and "surface" not in record.places:
        reader.report(record.where, "a point on a surface needs 'surface'", "surface: the name of a surface")


ELEMENT = Element(
    "constraint",
    "What ties motions together: a rope, a pair of gears, a belt, two points pinned together, a rigid massless link, a "
    "point kept on a surface, or a plain equation between coordinates such as `x2 = 2*x1`.",
    {
        "equation": Field(EquationField(equation="x2 = 2*x1"),
                          "an equation between coordinates and the time, true as drawn"),
        "rope": Field(rope.KIND, rope.ABOUT),
        "gear": Field(_TWO_BODIES, "two bodies whose pitch circles roll on each other"),
        "belt": Field(_TWO_BODIES, "two bodies with a belt around them"),
        "join": Field(_TWO_PLACES, "two points pinned together: they coincide as drawn"),
        "link": Field(_TWO_PLACES, "two points whose distance as drawn is kept by a rigid massless rod"),
        "point": Field(PLACE, "a point that stays on a surface"),
        "surface": Field(NameOf("the name of a surface", "surfaces"), "the surface that a point stays on"),
        "radii": Field(Many(Quantity("m"), 2, 2, "two radii"),
                       "pitch radii of gears or pulleys (default: those of their shapes)"),
        "carrier": Field(BODY, "the body that carries the axes of both gears or pulleys, where they are not fixed"),
        "inside": Field(Flag(), "`true`: one gear runs inside the other"),
        "crossed": Field(Flag(), "`true`: the belt is crossed, so the pulleys turn against each other"),
    },
    short="equation",
    exclusive=(KINDS,),
    needs=(KINDS,),
    settle=_settle,
    example="ropes_and_links",
)


def build(record: "Record", scene: "Builder") -> None:
    """Add the conditions of a constraint to the scene."""
    kind = next(kind for kind in KINDS if kind in record)
    {"equation": _equation, "rope": rope.build, "gear": _gear, "belt": _gear, "join": _join, "link": _link,
     "point": _point}[kind](record, scene)


def _equation(record: "Record", scene: "Builder") -> None:
    node = scene.lower(record["equation"])
    if any(node.mask & x.mask for x in (*scene.v, *scene.a)):
        scene.report(record["equation"].where, "a constraint ties positions, not velocities",
                     "write it between coordinates; what rolls without slip has `roll`")
        return
    if textbook(node).is_zero or not node.mask:
        scene.report(record["equation"].where, f"the constraint '{record.name}' ties no coordinate",
                     "write an equation between coordinates, such as x2 = 2*x1")
        return
    scene.require_equal(node, scene.table.zero, record["equation"].where,
                        f"the constraint '{record.name}' does not hold as drawn: its sides differ by {{}} (SI units)",
                        "mind that coordinates are zero as drawn unless `coordinates` gives `drawn`", size=1e-12)
    scene.add_constraint(record, _driven(record, scene, node), "equation")


def _driven(record: "Record", scene: "Builder", node: "Node") -> "Node":
    """The condition with its terms of the time alone, and their value at t = 0, as one displacement that is driven: of
    y = Y (1 − cos Ωt) all of the right side, so that none of it is there at rest."""
    others = ~scene.time.mask
    tied = scene.terms_with(node, others)
    in_time = textbook(node - tied)
    if not in_time.mask:
        return node
    drawn, = scene.at_drawn(tied)
    return tied - drawn + scene.driven_by(in_time + drawn, record.name)


def _join(record: "Record", scene: "Builder") -> None:
    (ax, ay), (bx, by) = (scene.place_of(end) for end in record["join"])
    x, y = scene.number(bx - ax), scene.number(by - ay)
    _together(record, scene, (x * x + y * y) ** 0.5, "the points that '{}' joins are {:.6g} m apart as drawn",
              "draw them at the same place")
    parts = [(node, part) for node, part in ((bx - ax, ".x"), (by - ay, ".y")) if node.mask and not is_zero(node)]
    if not parts:
        scene.report(record.where, f"the points that '{record.name}' joins never move relative to one another",
                     "take it out")
    for node, part in parts:
        scene.add_constraint(record, node, "join", part)


def _together(record: "Record", scene: "Builder", gap: float, words: str, hint: str) -> None:
    """Report a gap as drawn."""
    if gap and not gap <= 1e-9 * (scene.extent(scene.sample) or 1.0):
        scene.report(record.where, words.format(record.name, gap), hint)


def _link(record: "Record", scene: "Builder") -> None:
    before = len(scene.diagnostics)
    (ax, ay), (bx, by) = (scene.place_of(end) for end in record["link"])
    dx, dy = bx - ax, by - ay
    if len(scene.diagnostics) > before:
        return
    if not (dx.mask or dy.mask):
        scene.report(record.where, f"the points that '{record.name}' links never move relative to one another",
                     "take it out")
        return
    length = scene.distance(*scene.at_drawn(dx, dy))
    if not scene.number(length):
        scene.report(record.where, f"the link '{record.name}' has no length as drawn",
                     "draw its ends apart, or `join` them")
        return
    scene.add_constraint(record, (dx * dx + dy * dy - length * length) / (2 * length), "link")


def _point(record: "Record", scene: "Builder") -> None:
    surface = scene.surfaces[record["surface"].text]
    carrier = scene.carrier(surface, "body")
    x, y = carrier.seen(*scene.place_of(record["point"]))
    if "line" in surface:
        (ax, ay), (bx, by) = (scene.pair(place) for place in surface["line"])
        ex, ey = scene.unit(bx - ax, by - ay, surface.where)
        node = off = (y - ay) * ex - (x - ax) * ey
    elif "circle" in surface:
        (cx, cy), radius = scene.pair(surface["circle"]), scene.positive(surface["radius"], "the radius of the circle")
        node = ((x - cx) * (x - cx) + (y - cy) * (y - cy) - radius * radius) / (2 * radius)
        off = scene.distance(*scene.at_drawn(x - cx, y - cy)) - radius
    else:
        node = off = y - scene.height_of(surface, x)
    if not node.mask:
        scene.report(record.where, f"the distance of the point of '{record.name}' from its surface never changes",
                     "take it out")
        return
    _together(record, scene, abs(scene.number(off)), "the point of '{}' is {:.6g} m off its surface as drawn",
              "draw it on the surface")
    scene.add_constraint(record, node, "point")


def _gear(record: "Record", scene: "Builder") -> None:
    """Equal velocities at the pitch point, or of the belt."""
    belt = "belt" in record
    names = record["belt" if belt else "gear"]
    angles = [angle_of(name, scene) for name in names]
    if None in angles:
        return
    before = len(scene.diagnostics)
    radii = _radii(record, scene, names)
    if len(scene.diagnostics) > before:
        return
    if not belt:
        _touching(record, scene, names, radii)
    turn = scene.carrier(record).angle
    if len(scene.diagnostics) > before:
        return
    _carried(record, scene, names)
    same = belt != record.get("crossed", False) if belt else record.get("inside", False)
    first, second = radii[0] * (angles[0] - turn), radii[1] * (angles[1] - turn)
    node = first - second if same else first + second
    if scene.released and not belt:
        node = node + _parted(record, scene, names, radii)
    scene.add_constraint(record, node, "belt" if belt else "gear")


def _carried(record: "Record", scene: "Builder", names: "list[Reference]") -> None:
    """The axles rest in the carrier of a gear or belt."""
    carrier = scene.carrier(record)
    for name in names:
        body = scene.bodies[name.text]
        if body.frame is not None and not scene.released:
            now = carrier.seen(*body.frame.point(*scene.rim(body, name.where)))
            if not all(scene.vanishes(x - x0) for x, x0 in zip(now, scene.at_drawn(*now), strict=True)):
                scene.report(name.where, f"the axle of '{name.text}' moves" + (f" in '{record['carrier'].text}'"
                             if "carrier" in record else ""), "name the body that carries both axles: `carrier: arm`")


def _parted(record: "Record", scene: "Builder", names: "list[Reference]", radii: "list[Node]") -> "Node":
    """(δc₁ − δc₂)·t of the axles, t along the teeth, where supports give way; zero of gears without a place."""
    bodies = [scene.bodies[name.text] for name in names]
    if any(body.frame is None for body in bodies):
        return scene.table.zero
    (ax, ay), (bx, by) = rims = [scene.rim(body, record.where) for body in bodies]
    ex, ey = scene.unit(bx - ax, by - ay)
    if record.get("inside") and scene.sign(radii[0] - radii[1]) < 0:
        ex, ey = -ex, -ey
    places = [part for body, rim in zip(bodies, rims, strict=True) for part in body.frame.point(*rim)]
    held = substitute(places, dict.fromkeys(scene.supports, scene.table.zero))
    cx, cy, dx, dy = (now - then for now, then in zip(places, held, strict=True))
    tx, ty = scene.carrier(record).turned(-ey, ex)
    return (cx - dx) * tx + (cy - dy) * ty


def _radii(record: "Record", scene: "Builder", names: "list[Reference]") -> "list[Node] | None":
    if "radii" in record:
        return [scene.positive(radius, "a pitch radius") for radius in record["radii"]]
    radii = [scene.bodies[name.text].rolling_radius for name in names]
    for name, radius in zip(names, radii, strict=True):
        if radius is None:
            scene.report(name.where, f"'{name.text}' has no radius", "give the pitch `radii: [r1, r2]`")
            return None
    return radii


def _touching(record: "Record", scene: "Builder", names: "list[Reference]", radii: "list[Node]") -> None:
    """Gears with a place touch as drawn."""
    bodies = [scene.bodies[name.text] for name in names]
    if any(body.frame is None for body in bodies):
        return
    (ax, ay), (bx, by) = (scene.rim(body, name.where) for body, name in zip(bodies, names, strict=True))
    due = radii[0] + radii[1]
    if record.get("inside"):
        due = radii[0] - radii[1] if scene.sign(radii[0] - radii[1]) > 0 else radii[1] - radii[0]
    scene.require_equal(scene.distance(bx - ax, by - ay), due, record.where,
                        f"the gears of '{record.name}' do not mesh as drawn: their axes are {{}} m apart, where {{}} m "
                        "is due", "move one of them, or mind their radii")
