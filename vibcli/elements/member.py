"""Members: bars, shafts, beams and strings as stations, whose motions are coordinates of their own, and pieces between.

Stations are the ends, the steps of section, and every place with an attachment, a point or a joint. A motion that is
free is a coordinate, named as its signal: `wing.u(L/2)`, `wing.slope(L)`, `line.phi(0 m)`; what is held to a body or
another member is a function of theirs; what is clamped is zero. In the plane a bar stretches and stays straight, hinged
at its ends; beams and strings keep their length, their mass going along. A beam with EA stretches: as it does so it
counts as a member besides, `wing.along`.
"""

from functools import partial
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.member_attachments import attach
from vibcli.elements.member_ends import HOLDS
from vibcli.elements.member_fields import LENGTHWISE, MemberKind, members_of
from vibcli.elements.member_holds import beyond_reach, held_at
from vibcli.elements.member_line import DrawnLine, line_of
from vibcli.elements.member_line import Station as Station
from vibcli.elements.member_pieces import add_pieces, pieces_of
from vibcli.elements.member_places import ROUNDING, places_of
from vibcli.elements.member_segments import segments_of
from vibcli.language.named_elements import load

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from vibcli.elements.member_places import PlaceAlong
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.elements.place_signals import PlaceSignal
    from vibcli.language.reader import Record
    from vibcli.language.signal_names import SignalName
    from vibcli.scene.builder import Builder
    from vibcli.scene.expressions import Expressions
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class Member(NamedTuple):
    """A member as built: its kind, record, MemberSegments, and Stations from left to right; its DrawnLine in the plane;
    `stretches`: the coordinates, one a station, by which it is cut open to find its tension, which is `settled` where
    it is the same wherever the scene rests; `tie`: as drawn that of what both ends are held to, moving along;
    `tensions`: of each piece (N at its left end, N′, length)."""

    name: str
    kind: MemberKind
    record: "Record"
    segments: "list[MemberSegment]"
    stations: list[Station]
    line: DrawnLine | None = None
    stretches: "tuple[Node | None, ...]" = ()
    settled: bool = True
    tie: "Node | None" = None
    tensions: "list[tuple[Node, Node, Node]]" = []

    @property
    def length(self) -> "Node":
        """From its left to its right end."""
        return self.segments[-1].end

    @property
    def nodes(self) -> "list[Node]":
        """The motions of its stations."""
        return [node for station in self.stations for node in station.nodes]

    def over(self, new: "Mapping[Node, Node]") -> "Member":
        """Itself with its motions replaced, {node: node}."""
        return self._replace(stations=[station.over(new) for station in self.stations])

    def position(self, station: Station) -> "tuple[Node, Node]":
        """Where a station is now, in the plane."""
        (x, y), (dx, dy) = self.line.drawn(station.place), self.line.displaced(station.along, station.u)
        return x + dx, y + dy

    @property
    def lengthwise(self) -> bool:
        """Is it a bar in the plane, or a beam as it stretches?"""
        return self.line is not None and self.kind.name == "bar"

    @property
    def turns(self) -> bool:
        """Is it a bar in the plane, which turns besides?"""
        return self.lengthwise and self.kind is not LENGTHWISE

    @property
    def stretching(self) -> bool:
        """Is it a beam that stretches?"""
        return self.segments[0].axial is not None

    @property
    def signal_stem(self) -> str:
        """The signal of its motion, but for the place: `wing.u`, `line.phi`, `wing.along`."""
        return self.name if self.kind is LENGTHWISE else f"{self.name}.{self.kind.motion}"

    def has_coordinate(self, name: str) -> bool:
        """Is a coordinate of that name one of its stations?"""
        return name.startswith(self.name + ("(" if self.kind is LENGTHWISE else "."))

    def motions(self, station: Station) -> "list[Node]":
        """What a station does in the sense of u: u or φ, of beams its slope too."""
        return [station.along] if self.lengthwise else station.motions

    def along(self, scene: "Builder") -> "Member":
        """A beam as it stretches: as a bar, of the name `wing.along`."""
        return Member(f"{self.name}.along", LENGTHWISE, self.record,
                      [segment.lengthwise(scene) for segment in self.segments], self.stations, self.line)

    def tension(self, number: int, segment: "MemberSegment", scene: "Builder | Scene") -> "tuple[Node, Node]":
        """(N at the left end of a piece, N′): EA and GI_o of bars and shafts, of strings and beams the tension."""
        zero = scene.table.zero
        if segment.stiffness is not None and not self.kind.bends:
            return segment.stiffness, zero
        if self.tensions:
            return self.tensions[number][:2]
        return self._preload(scene), zero

    def _preload(self, scene: "Builder | Scene") -> "Node":
        """The tension as drawn, zero where none is given."""
        return scene.lower(self.record["preload"]) if "preload" in self.record else scene.table.zero

    def stretch_forces(self, scene: "Builder | Scene") -> "list[tuple[Node, Node]]":
        """(tension by which a piece of a beam stretches, tension in its stiffness), means of each."""
        found = []
        for number, (segment, left, right) in enumerate(pieces_of(self, scene)):
            length = right.place - left.place
            tension, gradient = self.tension(number, segment, scene)
            stretch = segment.axial * (right.along - left.along) / length
            found.append((stretch + self._preload(scene), tension + gradient * length / 2))
        return found

    def signal(self, scene: "Scene", signal: "SignalName", place: "Node", before: bool = False) -> "PlaceSignal | None":
        """The PlaceSignal of a name: a motion, force or stress at a place, on its right or `before` it; None beyond the
        ends."""
        from vibcli.elements.place_signals import place_signal

        return place_signal(scene, self._moving(scene, signal.part), signal, place, before)

    def signals_along(self, scene: "Scene", part: str, at: "Node") -> "list[PlaceSignal]":
        """The PlaceSignals of a part on each of its pieces from left to right, all as far from its left end."""
        from vibcli.elements.place_signals import signals_along

        return signals_along(scene, self._moving(scene, part), part, at)

    def loaded_along(self, scene: "Scene") -> bool:
        """Does a weight or load act on it at rest between its stations?"""
        part = "along" if self.kind is LENGTHWISE else self.kind.motion
        pieces = self.signals_along(scene, part, scene.table.zero)
        return any(piece.uneven(scene) or not piece.weight(scene).is_zero for piece in pieces)

    def _moving(self, scene: "Scene", part: str) -> "Member":
        """The member whose motions tell a part of its signals: of beams as they stretch another."""
        return scene.members[f"{self.name}.along"] if self.stretching and part in ("along", "force") else self

    def arms(self, scene: "Builder | Scene") -> "Iterator[tuple[str, str, float]]":
        """(side, body, how far off it is drawn) of ends that are held to bodies without size drawn elsewhere."""
        for side, place in (("left", scene.table.zero), ("right", self.length)) if self.line is not None else ():
            end = self.record.get(side, "free")
            name = None if isinstance(end, str) else next((end[word].text for word in HOLDS if word in end), None)
            off = beyond_reach(name, self.line.drawn(place), scene) if name in scene.bodies else 0.0
            if off > ROUNDING * scene.number(self.length):
                yield side, name, off

    def nearest(self, scene: "Builder | Scene | Expressions", place: "Node") -> Station:
        """The Station that is nearest to a place."""
        x = scene.number(place)
        return min(self.stations, key=lambda station: abs(scene.number(station.place) - x))

    def at(self, scene: "Builder | Expressions", place: "Node") -> Station:
        """The Station at a place, which stands for those that differ from it by rounding alone."""
        if not self.stations:
            scene.reports.finish()      # what is wrong with it has been reported
        found = self.nearest(scene, place)
        if abs(scene.number(found.place) - scene.number(place)) > ROUNDING * scene.number(self.length):
            scene.reports.report(self.record.where, f"nothing holds to the slack end of '{self.name}'", "a mass there "
                                 "makes it taut")
        return found


def built(name: str, scene: "Builder") -> Member | None:
    """The Member of that name, its terms added to the scene once; None where members are held to one another in a
    circle, which is reported."""
    kind, record = members_of(scene.spec)[name]
    if name not in scene.members:
        scene.members[name] = None
        scene.members[name] = scene.owned(name, partial(_built, name, kind, record, scene))
    elif scene.members[name] is None:
        scene.report(record.where, f"'{name}' is held to what is held to itself", "let one end carry the other")
    return scene.members[name]


def _built(name: str, kind: MemberKind, record: "Record", scene: "Builder") -> Member:
    before = len(scene.diagnostics)
    if scene.spec.in_full:
        scene.report(record.where, f"'{name}' is linear about its drawn line: its motions are small ones",
                     "leave out `motion:`")
    line = line_of(record, scene)
    segments = segments_of(record, kind, line, scene)
    places = places_of(name, record, segments, scene)
    member = Member(name, kind, record, segments, [], line, tensions=[])
    if len(scene.diagnostics) > before:
        return member
    held = [held_at(place, kind, line, scene, built) for place in places]
    if line is None:
        member = member._replace(stations=[_station(name, kind, place, motions, scene)
                                           for place, motions in zip(places, held, strict=True)])
    else:
        tensions = scene.tensions.get(name)
        member = load("member_plane").placed(member, places, held, scene)._replace(
            settled=tensions is None or tensions.settled, tie=scene.tie(name))
    scene.members[name] = member
    if line is None:
        add_pieces(member, scene)
    else:
        load("member_plane").add_placed_pieces(member, scene)
    member = member._replace(stations=[station for station in member.stations if station.u is not None])
    scene.members[name] = member
    if member.stretching:
        scene.members[f"{name}.along"] = member.along(scene)
    for place in places if member.stations else ():
        for here in (*(end for end in place.ends if not isinstance(end, str)), *place.attached):
            attach(here, member, member.at(scene, place.node), scene)
    return member


def _station(name: str, kind: MemberKind, place: "PlaceAlong", held: "Mapping[str, Node]", scene: "Builder") -> Station:
    """The Station of a place: what is not held is a coordinate."""
    signals = {"u": kind.motion, "slope": "slope"} if kind.bends else {"u": kind.motion}
    found = {motion: held[motion] if motion in held else scene.coordinates.further(f"{name}.{signal}({place.text})")
             for motion, signal in signals.items()}
    return Station(place.node, place.text, **found)
