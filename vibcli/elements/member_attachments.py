"""What is attached to members, in terms of the energies: masses, springs and dampers to the ground, oscillators."""

from typing import TYPE_CHECKING

from vibcli.language.member_signals import oscillator_names

if TYPE_CHECKING:
    from vibcli.elements.member import Member, Station
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node


def attach(record: "Record", member: "Member", station: "Station", scene: "Builder") -> None:
    """Add the masses, springs and dampers that are attached at a station; `record`: of an attachment or an end.

    In the plane a mass weighs and counts both ways; springs and dampers act across, of a bar along.
    """
    kind, table = member.kind, scene.table
    turning = station.u if kind.torsional else station.slope
    acting = station.along if kind.name == "bar" and member.line is not None else station.u
    ways = [station.u] if station.along is None else [station.u, station.along]
    for key, motions in (("mass", ways), ("inertia", [turning]), ("k", [acting]), ("torsion", [turning]),
                         ("c", [acting])):
        if key not in record:
            continue
        if not any(motion.mask for motion in motions):
            scene.report(record.place(key), f"'{member.name}' does not move there: this '{key}' plays no part",
                         "leave it out, or attach it elsewhere")
        elif key in ("mass", "inertia"):
            weight = scene.positive(record[key], f"the {key}", zero=True)
            for motion in motions:
                scene.add_inertia(weight, motion)
            if key == "mass" and member.line is not None:
                scene.add_weight(weight, *member.position(station))
        elif key == "c":
            scene.add_damper(scene.lower(record[key]), *motions)
        else:
            scene.add_spring(scene.lower(record[key]), table.zero, *motions)
    if "oscillator" in record:
        _oscillator(record["oscillator"], member, station, acting, scene)


def _oscillator(record: "Record", member: "Member", station: "Station", carrier: "Node", scene: "Builder") -> None:
    """A mass on a spring and a damper, its motion a coordinate."""
    motion = scene.coordinates.further(next(name for name in oscillator_names(member.name, station.text)
                                            if name not in scene.coordinates.names))
    mass, k = ("inertia", "torsion") if member.kind.torsional else ("mass", "k")
    weight = scene.positive(record[mass], f"the {mass} of the oscillator")
    scene.add_inertia(weight, motion)
    if member.line is not None:
        bar = carrier is station.along
        scene.add_inertia(weight, station.u if bar else station.along)
        moved = station._replace(along=motion) if bar else station._replace(u=motion)
        scene.add_weight(weight, *member.position(moved))
    if k in record:
        scene.add_spring(scene.positive(record[k], "the stiffness of the oscillator"), scene.table.zero,
                         motion - carrier)
    if "c" in record:
        scene.add_damper(scene.lower(record["c"]), motion - carrier)
