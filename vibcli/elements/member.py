"""Members: bars, shafts, beams and strings as stations, whose motions are coordinates of their own, and pieces between.

Stations are the ends, the steps of section, and every place with an attachment, a point or a joint. A motion that is
free is a coordinate, named as its signal: `wing.u(L/2)`, `wing.slope(L)`, `line.phi(0 m)`; what is held to a body or
another member is a function of theirs; what is clamped is zero.
"""

from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.elements.member_attachments import attach, held_end
from vibcli.elements.member_ends import GUIDED, PINNED
from vibcli.elements.member_fields import MemberKind, members_of
from vibcli.elements.member_places import places_of
from vibcli.elements.member_segments import segments_of
from vibcli.elements.member_springs import springs_across, springs_along

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.language.signal_names import SignalName
    from vibcli.symbolic.node import Node


class Station(NamedTuple):
    """A place on a member, as it is written, and its motions: u or φ, and the slope of beams (None of the rest)."""

    place: Any
    text: str
    u: Any
    slope: Any

    @property
    def motions(self) -> "list[Node]":
        """(u,), of beams (u, slope)."""
        return [self.u] if self.slope is None else [self.u, self.slope]


class Member(NamedTuple):
    """A member as built: its kind, record, MemberSegments, and Stations from left to right."""

    name: str
    kind: MemberKind
    record: Any
    segments: list
    stations: list

    @property
    def length(self) -> "Node":
        """From its left to its right end."""
        return self.segments[-1].end

    @property
    def nodes(self) -> "list[Node]":
        """The motions of its stations."""
        return [node for station in self.stations for node in station.motions]

    def over(self, new: "Mapping[Node, Node]") -> "Member":
        """Itself with its motions replaced, {node: node}."""
        return self._replace(stations=[
            station._replace(u=new[station.u], slope=None if station.slope is None else new[station.slope])
            for station in self.stations])

    def signal(self, scene: Any, signal: "SignalName", place: "Node"):
        """The PlaceSignal of a name: a motion, force or stress at a place; None beyond the ends."""
        from vibcli.elements.place_signals import place_signal

        return place_signal(scene, self, signal, place)

    def at(self, scene: Any, place: "Node") -> Station:
        """The Station at a place, which stands for those that differ from it by rounding alone."""
        x = scene.number(place)
        return min(self.stations, key=lambda station: abs(scene.number(station.place) - x))


def built(name: str, scene: Any) -> Member | None:
    """The Member of that name, its terms added to the scene once; None where members are held to one another in a
    circle, which is reported."""
    kind, record = members_of(scene.spec)[name]
    if name not in scene.members:
        scene.members[name] = None
        scene.members[name] = scene.owned(name, partial(_built, name, kind, record, scene))
    elif scene.members[name] is None:
        scene.report(record.where, f"'{name}' is held to what is held to itself", "let one end carry the other")
    return scene.members[name]


def _built(name, kind, record, scene):
    before = len(scene.diagnostics)
    if scene.spec.get("motion") == "full":
        scene.report(record.where, f"'{name}' is linear about its drawn line: its motions are small ones",
                     "leave out `motion: full`")
    segments = segments_of(record, kind, scene)
    places = places_of(name, record, segments, scene)
    if len(scene.diagnostics) > before:
        return Member(name, kind, record, segments, [])
    held = [_held(place, kind, scene) for place in places]
    stations = [_station(name, kind, place, motions, scene) for place, motions in zip(places, held, strict=True)]
    member = Member(name, kind, record, segments, stations)
    for segment in segments:
        inside = [station for station in stations if _within(station, segment, scene)]
        for left, right in pairwise(inside):
            _add_piece(member, segment, left, right, scene)
    for place, station in zip(places, stations, strict=True):
        for here in (*(end for end in place.ends if not isinstance(end, str)), *place.attached):
            attach(here, member, station, scene)
    return member


def _within(station, segment, scene):
    x, start, end = (scene.number(node) for node in (station.place, segment.start, segment.end))
    slack = 1e-9 * abs(end)
    return start - slack <= x <= end + slack


def _held(place, kind, scene):
    """[u, slope] of a place as ends and supports hold them, None what is free."""
    motions = [None, None] if kind.bends else [None]
    for holds in (*(held_end(end, kind, scene, built) for end in place.ends), *(
            _support(record["support"], kind, scene) for record in place.attached if "support" in record)):
        for i, motion in enumerate(holds):
            if motion is not None and motions[i] is not None:
                where = next((r.place("support") for r in place.attached if "support" in r), place.where)
                scene.report(where, f"what stands at {place.text} is held there already", "leave one of both out")
            elif motion is not None:
                motions[i] = motion
    return motions


def _support(word, kind, scene):
    zero = scene.table.zero
    if not kind.bends:
        return [zero]
    return [None if word == GUIDED else zero, None if word == PINNED else zero]


def _station(name, kind, place, motions, scene):
    """The Station of a place: what is not held is a coordinate."""
    signals = [kind.motion, "slope"]
    found = [scene.coordinates.further(f"{name}.{signal}({place.text})") if motion is None else motion
             for signal, motion in zip(signals, motions, strict=False)]
    return Station(place.node, place.text, found[0], found[1] if kind.bends else None)


def _tension(member, scene):
    """The tension as drawn of a beam, zero where none is given, or of a string, which must be positive."""
    if "preload" not in member.record:
        return scene.table.zero
    preload = member.record["preload"]
    return scene.lower(preload) if member.kind.bends else scene.positive(preload, f"the tension of '{member.name}'")


def _add_piece(member, segment, left, right, scene):
    """The springs of the piece between two stations, and the piece itself where it has inertia or drag."""
    table, kind = scene.table, member.kind
    length, ends = right.place - left.place, [*left.motions, *right.motions]
    tension = _tension(member, scene)
    if kind.bends:
        bending = segment.stiffness
        springs = springs_across(scene, length, bending, tension, segment.foundation, ends)
    else:
        bending, tension = table.zero, tension if segment.stiffness is None else segment.stiffness
        springs = springs_along(scene, length, tension, segment.foundation, ends)
    springs = [(weight, stretch) for weight, stretch in springs if stretch.mask and not weight.is_zero]
    light = segment.inertia.is_zero and segment.drag.is_zero
    if light:
        for weight, stretch in springs:
            scene.add_spring(weight, table.zero, stretch)
    else:
        coefficients = (length, bending, tension, table.zero, segment.inertia, segment.drag, segment.foundation)
        scene.add_piece(left.place, coefficients, ends, springs)
