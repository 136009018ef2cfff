"""What holds the ends of members, and what is attached to them, in terms of the energies."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.elements.member_ends import CLAMPED, FREE, GUIDED, HOLDS, PINNED
from vibcli.elements.member_fields import MemberKind

if TYPE_CHECKING:
    from vibcli.elements.member import Member, Station
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node


def held_end(end: "Record | str", kind: MemberKind, scene: Any, built: Callable) -> "list[Node | None]":
    """[u], of beams [u, slope], as an end is held, None what is free; `built(name, scene)`: another Member."""
    zero, free = scene.table.zero, [None] * (2 if kind.bends else 1)
    if isinstance(end, str):
        if end == FREE:
            return free
        if not kind.bends:
            return [zero]
        return [None if end == GUIDED else zero, None if end == PINNED else zero]
    word = next((word for word in HOLDS if word in end), None)
    if word is None:
        return free
    name = end[word]
    if name.text in scene.bodies:
        held = _on_body(name, kind, scene)
    else:
        held = _on_member(name, end, kind, scene, built(name.text, scene))
    if held is None:
        return free
    return held[:1] if not kind.bends else [None if word == GUIDED else held[0], None if word == PINNED else held[1]]


def _on_body(name, kind, scene):
    """[u, slope] of a body without a place; None where it does not fit, which is reported."""
    body, zero = scene.bodies[name.text], scene.table.zero
    if body.lumped is None:
        return scene.report(name.where, f"'{name.text}' has a place, and this member has none",
                            "lump the body, `slide: x` or `turn: phi`, or draw the member `from` a place `to` another")
    moves, motion = body.lumped
    if scene.drifts(motion):
        return scene.report(name.where, f"'{name.text}' moves on and on, and members have small motions about their "
                            "drawn line", "hold the member to what rests or is shaken")
    if kind.bends:
        return [motion, zero] if moves == "slide" else [zero, motion]
    if (moves == "turn") != kind.torsional:
        way = "turns, and bars and strings move along one axis" if moves == "turn" else "slides, and shafts turn"
        return scene.report(name.where, f"'{name.text}' {way}", "let it " + ("turn: `turn: phi`" if kind.torsional else
                                                                             "slide: `slide: x`"))
    return [motion]


def _on_member(name, end, kind, scene, other):
    """[u, slope] of another member at a place; None where it does not fit, which is reported."""
    if "at" not in end:
        return scene.report(name.where, f"where on '{name.text}' is not said", "give the place: `at: L/2`")
    if other is None or not other.stations:
        return None
    if other.kind.torsional != kind.torsional:
        return scene.report(name.where, f"a {kind.name} and a {other.kind.name} have no motion in common",
                            "shafts are held to shafts")
    if CLAMPED in end and kind.bends and other.kind.name == "string":
        return scene.report(name.where, "a string holds no slope", f"write `{{pinned: {name.text}, at: …}}`")
    station = other.at(scene, scene.lower(end["at"]))
    return [station.u, scene.table.zero if station.slope is None else station.slope]


def attach(record: "Record", member: "Member", station: "Station", scene: Any) -> None:
    """Add the masses, springs and dampers that are attached at a station; `record`: of an attachment or an end."""
    torsional = member.kind.torsional
    turning = station.u if torsional else station.slope
    for key, motion in (("mass", station.u), ("inertia", turning), ("k", station.u), ("torsion", turning),
                        ("c", station.u)):
        if key not in record:
            continue
        if not motion.mask:
            scene.report(record.place(key), f"'{member.name}' does not move there: this '{key}' plays no part",
                         "leave it out, or attach it elsewhere")
        elif key in ("mass", "inertia"):
            scene.add_inertia(scene.positive(record[key], f"the {key}", zero=True), motion)
        elif key == "c":
            scene.add_damper(scene.lower(record[key]), motion)
        else:
            scene.add_spring(scene.lower(record[key]), scene.table.zero, motion)
    if "oscillator" in record:
        _oscillator(record["oscillator"], member, station, scene)


def _oscillator(record, member, station, scene):
    """A mass on a spring and a damper, its motion a coordinate."""
    torsional = member.kind.torsional
    motion = scene.coordinates.further(f"{member.name}.oscillator({station.text})")
    mass, k = ("inertia", "torsion") if torsional else ("mass", "k")
    scene.add_inertia(scene.positive(record[mass], f"the {mass} of the oscillator"), motion)
    if k in record:
        scene.add_spring(scene.positive(record[k], "the stiffness of the oscillator"), scene.table.zero,
                         motion - station.u)
    if "c" in record:
        scene.add_damper(scene.lower(record["c"]), motion - station.u)
