"""Signals: what can be read off a scene beside its coordinates — places, turns, stretches, forces — and their units."""

from vibcli import units

POINT = {"x": "m", "y": "m", "reaction.x": "N", "reaction.y": "N"}
BODY = {"x": "m", "y": "m", "angle": "rad", "reaction.x": "N", "reaction.y": "N", "reaction.moment": "N*m",
        "normal": "N", "friction": "N"}
SPRING = {"stretch": ("m", "rad"), "force": ("N", "N*m"), "energy": ("J", "J")}      # of length, and of torsion
DAMPER = {"stretch": ("m", "rad"), "force": ("N", "N*m"), "power": ("W", "W")}
GROUND = {"force": "N", "force.x": "N", "force.y": "N", "moment": "N*m"}
ENERGIES = {"T": "J", "V": "J", "Phi": "W"}      # of the whole scene, where no parameter has the name
FORCES = {"rope": ("force",), "link": ("force",), "gear": ("force",), "belt": ("force",), "point": ("force",),
          "join": ("force.x", "force.y")}
ABOUT = (
    ("T, V, Phi", "kinetic and potential energy and dissipation function of the scene along a motion: `T(2 s)`, "
                  "`max(V)`; V is counted from the drawn position"),
    ("P.x, P.y", "displacement of a point from where it is drawn; of a body, that of its mass centre"),
    ("B.angle", "turn of a body"),
    ("s.stretch, s.force", "stretch of a spring since the drawn position, and its tension (of torsion its moment)"),
    ("s.energy", "energy stored in a spring, tension²/(2k)"),
    ("d.force, d.power", "force of a damper, positive as it lengthens, and the power that it dissipates"),
    ("ground.force", "force that springs and dampers exert on the ground (fixed or driven) in one-axis scenes; "
                     "ground.moment of torsion; ground.force.x, .y of scenes in the plane"),
    ("hoist.force", "tension of a rope (hoist.force.1, .2 where it is in several pieces) or link; tangential force of "
                    "gears and belts; force on a point from its surface; knee.force.x of a join, on its second point"),
    ("B.reaction.x, .y, .moment", "what the support (pin, guide, contact) exerts on a body, its moment about the pin "
                                  "or mass centre, of what rolls about the centre of its circle; O.reaction.x of the "
                                  "one body pinned at a point O"),
    ("B.normal, B.friction", "contact force on a rolling or sliding body: along the normal from the surface to the "
                             "body, and along the tangent, which is the normal turned clockwise"),
)


def signal_dimension(spec, text):
    """The dimension of a signal; None where the scene has none of that name."""
    unit = _unit(spec, text)
    return None if unit is None else units.parse_unit(unit).dimension


def _unit(spec, text):
    name, _, part = text.partition(".")
    if name in (spec.get("bodies") or {}):
        return BODY.get(part)
    if name in (spec.get("points") or {}):
        return POINT.get(part)
    if name == "ground":
        return GROUND.get(part)
    for section, parts in (("springs", SPRING), ("dampers", DAMPER)):
        record = (spec.get(section) or {}).get(name)
        if record is not None:
            return parts[part]["torsion" in record] if part in parts else None
    record = (spec.get("constraints") or {}).get(name)
    if record is not None:
        kind = next((kind for kind in FORCES if kind in record), None)
        whole, _, number = part.rpartition(".")
        if part in FORCES.get(kind, ()) or (kind == "rope" and whole == "force" and number.isdecimal()):
            return "N"
    return None


def near_signals(spec, text):
    """The signals of what `text` names, or the forms that signals have."""
    name = text.partition(".")[0]
    for section, parts in (("bodies", BODY), ("points", POINT)):
        if name in (spec.get(section) or {}):
            return [f"{name}.{part}" for part in parts]
    for section, parts in (("springs", SPRING), ("dampers", DAMPER)):
        if name in (spec.get(section) or {}):
            return [f"{name}.{part}" for part in parts]
    if name == "ground":
        return [f"ground.{part}" for part in GROUND]
    record = (spec.get("constraints") or {}).get(name)
    if record is not None:
        return [f"{name}.{part}" for kind, parts in FORCES.items() if kind in record for part in parts]
    return list(spec.coordinates)
