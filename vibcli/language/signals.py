"""Signals: what can be read off a scene beside its coordinates — places, turns, stretches, forces — and their units."""

from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.spelling import nearest
from vibcli.language.reader import Record, article
from vibcli.language.signal_names import signal_name

if TYPE_CHECKING:
    from collections.abc import Mapping
    from fractions import Fraction

    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec

POINT = {"x": "m", "y": "m", "reaction.x": "N", "reaction.y": "N", "reaction.moment": "N*m"}
BODY = {"x": "m", "y": "m", "angle": "rad", "reaction.x": "N", "reaction.y": "N", "reaction.moment": "N*m",
        "normal": "N", "friction": "N"}
LOAD = {"force": "N", "moment": "N*m"}          # of a load that is one number
CONTACT = ("normal", "friction")
GROUND = {"force": "N", "force.x": "N", "force.y": "N", "moment": "N*m"}
ENERGIES = {"T": "J", "V": "J", "Phi": "W"}      # of the whole scene, where no parameter has the name
DRIVES = {"slide": {"drive": "N"}, "pin": {"drive": "N*m"}, "turn": {"drive": "N*m"}, "travel": {"drive": "N"},
          "swing": {"drive": "N*m"}, "moves": {"drive.x": "N", "drive.y": "N"},
          "move": {"drive.x": "N", "drive.y": "N", "drive.moment": "N*m"}}      # by what is prescribed
FORCES = {"rope": ("force",), "link": ("force",), "gear": ("force",), "belt": ("force",), "point": ("force",),
          "join": ("force.x", "force.y")}
ABOUT = (
    ("T, V, Phi", "kinetic and potential energy and dissipation function of the scene along a motion: `T(2 s)`, "
                  "`max(V)`; V is counted from the drawn position"),
    ("P.x, P.y", "displacement of a point from where it is drawn; of a body, that of its mass centre"),
    ("B.angle", "turn of a body"),
    ("s.stretch, s.force", "stretch of a spring since the drawn position, and its tension (of torsion its moment)"),
    ("s.deflection", "stretch of a spring from its undeformed state, whatever its preload: the d of its law"),
    ("s.stretch.2", "that of the second part of a spring in series, s.stretch.3.1 of the first one within the third"),
    ("s.energy", "energy stored in a spring, tension²/(2k)"),
    ("d.force, d.power", "force of a damper, positive as it lengthens, and the power that it dissipates"),
    ("i.stretch, i.force", "stretch of an inerter since the drawn position, and its force, positive as its lengthening "
                           "gains speed"),
    ("P.force, P.moment, P.power", "of a load P its force where that is one number, its moment, and the power that it "
                                   "brings in, as in `mean(P.power)`"),
    ("ground.force", "force that springs, dampers and inerters exert on the ground (fixed or driven) in one-axis "
                     "scenes; ground.moment of torsion; ground.force.x, .y of scenes in the plane"),
    ("hoist.force", "tension of a rope (hoist.force.1, .2 where it is in several pieces) or link; tangential force of "
                    "gears and belts; force on a point from its surface; knee.force.x of a join, on its second point"),
    ("B.reaction.x, .y, .moment", "what the support (pin, guide, contact, clamp) exerts on a body, its moment about "
                                  "the pin, clamp or mass centre, of what rolls about the centre of its circle; "
                                  "O.reaction.x of the one body pinned or clamped at a point O"),
    ("B.drive", "force or moment of what prescribes the motion of a body, along that motion: `crank.drive(1 s)` of "
                "`pin: Omega*t`; of `move` B.drive.x, .y, .moment, of a point that `moves` P.drive.x, .y. Times the "
                "prescribed velocity it is the power of the drive"),
    ("B.normal, B.friction", "contact force on a rolling or sliding body: along the normal from the surface to the "
                             "body, and along the tangent, which is the normal turned clockwise; of what slides "
                             "along a direction this is the tangent; of what rolls between two surfaces "
                             "B.normal.deck, B.friction.deck at each"),
)
_PARTS = {**dict.fromkeys(("phi", "theta", "psi", "rotation", "turn"), "angle"), "omega": "angle'", "f": "force",
          "n": "normal", "tension": "force", "elongation": "stretch"}


def signal_dimension(spec: "Spec", text: str) -> "Mapping[str, Fraction | int] | None":
    """The dimension of a signal; None where the scene has none of that name."""
    unit = _unit(spec, text)
    return None if unit is None else units.parse_unit(unit).dimension


def _unit(spec: "Spec", text: str) -> str | None:
    name, part, place, primes = signal = signal_name(text)
    if not primes and name in spec.members:
        from vibcli.language.member_signals import member_unit

        return member_unit(spec, signal)
    if place or primes:
        return None
    roped = "rope" in (spec.get("constraints") or {}).get(name, ())
    of_piece = roped and signal.kind == "force" and signal.axis.isdecimal()
    return _parts(spec, name).get("force" if of_piece else part)


def _parts(spec: "Spec", name: str) -> dict[str, str]:
    """{part: unit} of the signals of what has a name."""
    for section, parts in (("bodies", BODY), ("points", POINT)):
        if name in (spec.get(section) or {}):
            return _signals_of(spec, spec.get(section)[name], parts)
    point = (spec.get("member_points") or {}).get(name)
    if point is not None:
        carrier = point["body"].text
        return {"x": "m", "y": "m"} if "from" in spec.get(spec.members[carrier])[carrier] else {}
    if name == "ground":
        return GROUND
    found = [parts for _, parts in namesakes(spec, name)]
    return found[0] if len(found) == 1 else {}


def namesakes(spec: "Spec", name: str) -> "list[tuple[str, dict[str, str]]]":
    """[(section, {part: unit})] of the elements, forces and constraints of a name that have signals: it stands for one
    of them where there is no other."""
    found = []
    for section, records in spec.sections.items():
        record = records.get(name) if isinstance(records, dict) else None
        if isinstance(record, Record):
            joins = record.element is not None and record.element.signals
            found.append((section, _of_element(record) if joins else _of_force(section, record)))
    return [(section, parts) for section, parts in found if parts]


def _of_element(record: Record) -> dict[str, str]:
    units = {part: pair["torsion" in record] for part, pair in record.element.signals.items()}
    inner = _inner(record) if "energy" in units else []
    return units | {f"stretch.{path}": units["stretch"] for path in inner}


def _of_force(section: str, record: Record) -> dict[str, str]:
    if section == "forces":
        return {"power": "W"} | {key: unit for key, unit in LOAD.items() if key in record
                                 and not isinstance(record[key], list)}
    return {part: "N" for kind, parts in FORCES.items() if section == "constraints" and kind in record
            for part in parts}


def _inner(record: Record) -> list[str]:
    """The numbers of the parts of what consists of several, 2 or 3.1 of nested ones."""
    parts = record.get("series") or record.get("parallel") or ()
    return [f"{i + 1}{rest}" for i, part in enumerate(parts) for rest in ("", *("." + path for path in _inner(part)))]


def _signals_of(spec: "Spec", record: Record, parts: dict[str, str]) -> dict[str, str]:
    """{part: unit} of a body or point: `parts`, the forces of its drives, those of each of several contacts."""
    contacts = record["roll"].get("between", ()) if "roll" in record else ()
    if contacts:
        parts = {part: unit for part, unit in parts.items() if part not in CONTACT}
        parts |= {f"{part}.{surface.text}": "N" for surface in contacts for part in CONTACT}
    return parts | drives(spec, record)


def is_load(spec: "Spec", text: str) -> bool:
    """Is this the force, moment or power of a load?"""
    name, part, *_ = signal_name(text)
    return name in (spec.get("forces") or {}) and part in _parts(spec, name) and (
        spec.connection(name) is None and part in (*LOAD, "power"))


def is_reaction(spec: "Spec", text: str) -> bool:
    """Is this the force of a constraint, a support, a contact or a drive?"""
    signal = signal_name(text)
    if signal.name in (spec.get("constraints") or {}):
        return signal.kind == "force"
    return signal.kind in ("reaction", "drive", *CONTACT) and (
        signal.name in (spec.get("bodies") or {}) or signal.name in (spec.get("points") or {}))


def drives(spec: "Spec", record: Record) -> dict[Any, Any]:
    """{part: unit} of the forces along what is prescribed in time of a body or point."""
    return {part: unit for part, (unit, _) in prescribed(spec, record).items()}


def prescribed(spec: "Spec", record: Record) -> dict[str, tuple[str, Any]]:
    """{part: (unit of the force along it, Expression)} of what is prescribed in time of a body or point."""
    key = next((key for key in ("slide", "pin", "turn", "move", "roll", "moves") if key in record), None)
    if key is None:
        return {}
    value = record[key]
    if key == "roll":
        key = next((kind for kind in ("travel", "swing", "turn") if kind in value), None)
        if key is None:
            return {}
        value = value[key]
    value = value["by"] if isinstance(value, Record) and "by" in value else value
    parts = DRIVES[key]
    given = value if isinstance(value, list) else [value]
    return {part: (unit, one) for (part, unit), one in zip(parts.items(), given, strict=False) if _in_time(spec, one)}


def _in_time(spec: "Spec", expression: "Expression") -> bool:
    """Does an expression hold the time?"""
    if "t" in spec.parameters or "t" in spec.coordinates:
        return False
    return any(name == "t" for name, *_ in expression.parts.names)


def near_signals(spec: "Spec", text: str) -> list[str]:
    """The signals of what `text` names, or the coordinates."""
    signal = signal_name(text)
    if signal.name in spec.members:
        from vibcli.language.member_signals import member_signals

        return member_signals(spec, signal)
    return [f"{signal.name}.{part}" for part in _parts(spec, signal.name)] or list(spec.coordinates)


def signal_meant(spec: "Spec", text: str, quantity: str | None = None) -> str | None:
    """The hint for what is no signal: one of those of what it names or is most like, else that for a quantity."""
    base, _, part = text.rpartition(".")
    both = [article(section[:-1]) for section, _ in namesakes(spec, signal_name(text).name)]
    if len(both) > 1:
        return f"'{signal_name(text).name}' is {' and '.join(both)}: rename one of them"
    signals = near_signals(spec, text)
    meant = f"{base}.{_PARTS.get(part.lower())}"
    if meant.rstrip("'") in signals:
        return f"did you mean '{meant}'?"
    found = nearest(text, signals)
    return found if base or found is None or found.startswith("did") or f"{text}." in found else quantity or found
