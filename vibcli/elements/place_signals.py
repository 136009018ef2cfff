"""Signals of places on members: on which piece each lies, and which part of its deflection it is.

    u, φ: 0, slope: 1;  force N u′, moment of a shaft G I_o φ′: 1;  moment of a beam B u″: 2, shear B u‴: 3 derivatives;
    stress: force/A, moment·D/(2 I_o), moment·h/(2 I).

At a station the piece on its right counts, at the right end and where it is asked for that on its left. What has no
inertia deflects as at rest.
"""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.member_line import Station
from vibcli.language.member_signals import OF_COORDINATES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.elements.member import Member
    from vibcli.elements.member_loads import SpreadLoad
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.elements.rest_shapes import RestPiece
    from vibcli.language.signal_names import SignalName
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAME = 1e-14        # of the length of a member: places nearer than that are one


class PlaceSignal(NamedTuple):
    """factor · ∂ᵒʳᵈᵉʳu/∂xᵒʳᵈᵉʳ at the distance `at` from the station `left`, on piece `number` up to `right`;
    `station`: the one that stands there, if any."""

    member: "Member"
    left: Station
    right: Station
    number: int
    segment: "MemberSegment"
    at: "Node"
    station: Station | None
    order: int
    factor: "Node"

    @property
    def motion(self) -> "Node | None":
        """Itself where it is a motion of a station."""
        motions = () if self.station is None else self.member.motions(self.station)
        return motions[self.order] if self.order < len(motions) else None

    @property
    def ends(self) -> "list[Node]":
        """The motions of the ends of its piece: u, of beams u and slope."""
        return [*self.member.motions(self.left), *self.member.motions(self.right)]

    @property
    def length(self) -> "Node":
        """That of its piece."""
        return self.right.place - self.left.place

    def tension(self, scene: "Scene") -> "tuple[Node, Node]":
        """(N at the left end of its piece, N′)."""
        return self.member.tension(self.number, self.segment, scene)

    def piece(self, scene: "Scene") -> "RestPiece":
        """Its piece at rest."""
        from vibcli.elements.rest_shapes import RestPiece

        tension, gradient = self.tension(scene)
        return RestPiece(self.length, self.member.kind.bends, self.segment.stiffness, tension, gradient,
                         self.segment.foundation)

    def weight(self, scene: "Scene") -> "Node":
        """The even loads and the weight that act on its piece in the sense of u, per length."""
        line, spread = self.member.line, scene.table.total([load.q for load in self._spread(scene) if load.even])
        if line is None or scene.gravity is None or self.segment.inertia.is_zero:
            return spread
        return spread + self.segment.inertia * line.seen(*scene.gravity)[0 if self.member.lengthwise else 1]

    def uneven(self, scene: "Scene") -> "list[SpreadLoad]":
        """The SpreadLoads along its piece that are not the same all along, of which a part is steady."""
        return [load for load in self._spread(scene) if not (load.even or load.q.is_zero)]

    def _spread(self, scene: "Scene") -> "list[SpreadLoad]":
        middle = scene.number(self.left.place + self.right.place) / 2
        return [load for load in scene.spread_loads if load.member == self.member.name
                and scene.number(load.start) < middle < scene.number(load.end)]

    def in_time(self, scene: "Scene") -> "list[SpreadLoad]":
        """The SpreadLoads along its piece that vary in time."""
        return [load for load in self._spread(scene) if not load.in_time.is_zero]

    def static(self, scene: "Scene") -> "Node":
        """Itself as a function of the coordinates, everything being at rest."""
        from vibcli.elements.member_deflection import static_signal

        return static_signal(scene, self)

    @property
    def is_light(self) -> bool:
        """Has the piece neither inertia nor drag, so that it deflects as at rest?"""
        return self.segment.inertia.is_zero and self.segment.drag.is_zero


def place_signal(scene: "Scene", member: "Member", signal: "SignalName", place: "Node",
                 before: bool = False) -> PlaceSignal | None:
    """The PlaceSignal of a name, `before` a place the one on its left; None where the place is not on the member."""
    x, length = scene.number(place), scene.number(member.length)
    if not -SAME * length <= x <= (1 + SAME) * length:
        return None
    stations = _with_slack_ends(scene, member)
    there = next((station for station in stations if abs(scene.number(station.place) - x) <= SAME * length), None)
    if there is not None:
        number = max(min(stations.index(there) - before, len(stations) - 2), 0)
    else:
        number = sum(scene.number(station.place) < x for station in stations) - 1
    at = (place if there is None else there.place) - stations[number].place
    if signal.kind in OF_COORDINATES:
        return _of_coordinates(scene, member, signal, stations[number:number + 2], at, there)
    return _on_piece(scene, member, stations, number, signal.part, at)._replace(station=there)


def _of_coordinates(scene: "Scene", member: "Member", signal: "SignalName", between: "Sequence[Station]", at: "Node",
                    there: Station | None) -> PlaceSignal | None:
    """The motion across of a bar, which stays straight, or that of what hangs there; None where nothing does."""
    left, right = between
    if signal.kind == "across":
        motion = left.u + (right.u - left.u) * (at / (right.place - left.place))
    else:
        name = "" if there is None else signal._replace(place=there.text, primes=0).text
        if name not in scene.hidden:
            return None
        motion = scene.symbol(name)
    alone = Station(left.place + at, signal.place, motion, None, motion)
    return PlaceSignal(member, left, right, 0, member.segments[0], at, alone, 0, scene.table.one)


def signals_along(scene: "Scene", member: "Member", part: str, at: "Node") -> "list[PlaceSignal]":
    """The PlaceSignals of a part on each piece of a member from left to right, all as far from its left end."""
    stations = _with_slack_ends(scene, member)
    return [_on_piece(scene, member, stations, number, part, at) for number in range(len(stations) - 1)]


def _on_piece(scene: "Scene", member: "Member", stations: "Sequence[Station]", number: int, part: str,
              at: "Node") -> PlaceSignal:
    left, right = stations[number:number + 2]
    segment = _segment(scene, member, left, right)
    return PlaceSignal(member, left, right, number, segment, at, None, *_part(scene, member, segment, part))


def _with_slack_ends(scene: "Scene", member: "Member") -> list[Station]:
    """The stations, and the ends of a string that bear no tension, whose motion is none of a station."""
    ends = [Station(place, text, None) for place, text in ((scene.table.zero, "left"), (member.length, "right"))]
    length, known = scene.number(member.length), [scene.number(station.place) for station in member.stations]
    left, right = ([end] if not any(abs(scene.number(end.place) - x) <= SAME * length for x in known) else []
                   for end in ends)
    return [*left, *member.stations, *right]


def _segment(scene: "Scene", member: "Member", left: Station, right: Station) -> "MemberSegment":
    middle = (scene.number(left.place) + scene.number(right.place)) / 2
    return next(segment for segment in member.segments if middle < scene.number(segment.end))


def _part(scene: "Scene", member: "Member", segment: "MemberSegment", part: str) -> "tuple[int, Node]":
    """(order of the derivative, factor)."""
    kind, stiffness = member.kind, segment.stiffness
    if part in ("u", "phi", "along"):
        return 0, scene.table.one
    if part == "slope":
        return 1, scene.table.one
    if part == "shear":
        return 3, stiffness
    if stiffness is None:       # the tension of a string, which small motions do not change
        return 0, scene.table.zero
    order = 2 if kind.bends else 1
    if part != "stress":
        return order, stiffness
    if kind.bends or kind.torsional:
        section = segment.section
        return order, stiffness / (section.I if kind.bends else section.Io) * section.fibre
    return order, segment.modulus if segment.modulus is not None else stiffness / _area(scene, segment, member)


def _area(scene: "Scene", segment: "MemberSegment", member: "Member") -> "Node":
    if segment.section is not None:
        return segment.section.A
    parts = (*member.record.get("segments", ()), member.record)
    area: Node = scene.lower(next(part["A"] for part in parts if "A" in part))
    return area
