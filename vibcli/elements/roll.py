"""Rolling without slip on a line or a circle, fixed or carried.

On a line with unit vector e and the body's centre on the side s = ±1 of its left normal: u = −s r θ.
On a circle of radius R, the line of centres turning by ψ: ρ ψ = σ r θ, with ρ = R + r and σ = 1 outside,
ρ = R − r and σ = −1 inside, and ρ = r − R, σ = 1 where the body encloses the circle (a ring on a peg). A flat side
stays tangent, ψ = θ; with n and t along and across the line from O to the contact, that place of the side which touches
as drawn is at O + R n − R ψ t.
The angles θ and ψ are relative to the surface's carrier; `turn` is θ in the fixed frame.
"""

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, MotionField, NameOf, Quantity
from vibcli.language.named_place import DRAWN

ELEMENT = Element(
    "roll",
    "The body rolls without slip on a surface, on its round side or a `flat` one. One of `travel` (displacement of its "
    "centre along the surface, positive from a line's first place to its second, counter-clockwise about a circle's "
    "centre), `turn` (rotation in the fixed frame), on circles `swing` (turn of the line of centres) says how far.",
    {
        "surface": Field(NameOf("the name of a surface", "surfaces"), "what it rolls on", required=True),
        "travel": Field(MotionField("m"), "displacement of the centre relative to the surface"),
        "turn": Field(MotionField("rad"), "rotation in the fixed frame, counter-clockwise"),
        "swing": Field(MotionField("rad"), "turn of the line of centres, on circles"),
        "radius": Field(Quantity("m"), "the radius it rolls on, where that is not the radius of its shape"),
        "flat": Field(Many(DRAWN, 2, 2, "two places [[x, y], [x, y]]"), "two places on its flat side as drawn, where "
                      "it is that side which rolls, on the outside of a circle"),
    },
    exclusive=(("travel", "turn", "swing"), ("flat", "radius"), ("flat", "travel")),
    needs=(("travel", "turn", "swing"),),
    example="rolling_in_a_track",
)


def build(roll, body, scene):
    """A rolling body with its frame about the centre of the rolling circle, and the normal of the surface."""
    surface = scene.surfaces[roll["surface"].text]
    if "flat" in roll:
        return _flat(roll, body, scene.rim(body, roll.where), scene, surface, scene.carrier(surface, "body"))
    radius = scene.positive(roll["radius"], "the radius it rolls on") if "radius" in roll else body.rolling_radius
    if radius is None:
        scene.report(roll.where, f"'{body.name}' has no radius to roll on", "give `radius`, a shape that is round, "
                     "or two places of the `flat` side that rolls")
        return body._replace(frame=scene.still(body.centre))
    drawn, carrier = scene.rim(body, roll.where), scene.carrier(surface, "body")
    if "curve" in surface:
        scene.report(roll["surface"].where, "bodies roll on lines and circles, not on other curves",
                     "`slide: {surface: …, by: …}` moves a particle along a curve")
        return body._replace(frame=scene.still(body.centre))
    on = _on_line if "line" in surface else _on_circle
    return on(roll, body, drawn, scene, surface, radius, carrier)


def _on_line(roll, body, drawn, scene, surface, radius, carrier):
    (ax, ay), (bx, by) = (scene.pair(place) for place in surface["line"])
    ex, ey = scene.unit(bx - ax, by - ay, surface.where)
    x0, y0 = drawn
    height = (y0 - ay) * ex - (x0 - ax) * ey
    side = scene.sign(height)
    scene.require_equal(scene.absolute(height), radius, roll.where,
                        f"'{body.name}' does not touch its line as drawn: its centre is {{}} m away, its radius {{}} m",
                        "move the body or the line until they touch")
    if "swing" in roll:
        scene.report(roll.place("swing"), "'swing' is for circles", "on a line use `travel` or `turn`")
        return body._replace(frame=scene.still(body.centre))
    if "travel" in roll:
        travel = scene.change(roll["travel"])
        turn = carrier.angle - travel * side / radius
    else:
        turn = scene.change(roll["turn"])
        travel = -(turn - carrier.angle) * side * radius
    place = carrier.point(x0 + travel * ex, y0 + travel * ey)
    return body._replace(normal=carrier.turned(-side * ey, side * ex), frame=scene.new_frame(drawn, place, turn))


def _on_circle(roll, body, drawn, scene, surface, radius, carrier):
    cx, cy = scene.pair(surface["circle"])
    track = scene.positive(surface["radius"], "the radius of the circle")
    x0, y0 = drawn
    inside = surface.get("side") == "inside"
    distance = scene.distance(x0 - cx, y0 - cy)
    encloses = not inside and scene.sign(distance - radius) < 0
    arm = track - radius if inside else radius - track if encloses else track + radius
    scene.require_equal(distance, arm, roll.where, f"'{body.name}' does not touch its circle as drawn: the centres are "
                        f"{{}} m apart, where {{}} m is due {'inside' if inside else 'outside'}",
                        "move the body, or say on which `side` of the circle it is")
    if not scene.number(arm):
        scene.report(roll.where, f"'{body.name}' is as large as the circle it rolls on", "give another radius")
        return body._replace(frame=scene.still(body.centre))
    sense = -1 if inside else 1
    given = scene.change(roll["turn"]) if "turn" in roll else None
    if "swing" in roll:
        swing = scene.change(roll["swing"])
    elif "travel" in roll:
        swing = scene.change(roll["travel"]) / arm
    else:
        swing = (given - carrier.angle) * radius * sense / arm
    turn = given if given is not None else carrier.angle + swing * arm * sense / radius
    centre = carrier.point(cx, cy)
    frame = scene.new_frame((cx, cy), centre, carrier.angle + swing)
    outward = -1 if inside or encloses else 1
    normal = frame.turned(outward * (x0 - cx) / distance, outward * (y0 - cy) / distance)
    return body._replace(normal=normal, frame=scene.new_frame(drawn, frame.point(x0, y0), turn))


def _flat(roll, body, drawn, scene, surface, carrier):
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
