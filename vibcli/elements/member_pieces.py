"""The pieces of members between their stations: springs at rest, and what has inertia or drag a piece besides."""

from collections.abc import Iterator
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING

from vibcli.elements.member_springs import springs_across, springs_along

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.elements.member import Member, Station
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def add_pieces(member: "Member", scene: "Builder") -> None:
    """Add the pieces of a member that is not drawn."""
    for segment, left, right in pieces_of(member, scene):
        tension = preload_of(member, scene)
        if member.kind.bends:
            add_across(segment, left, right, tension, scene)
        else:
            add_piece(segment, left, right, tension if segment.stiffness is None else segment.stiffness,
                      [left.u, right.u], scene)


def pieces_of(member: "Member", scene: "Builder | Scene") -> "Iterator[tuple[MemberSegment, Station, Station]]":
    """(segment, left Station, right Station) of each piece, from left to right."""
    for segment in member.segments:
        inside = [station for station in member.stations if _within(station, segment, scene)]
        for left, right in pairwise(inside):
            yield segment, left, right


def _within(station: "Station", segment: "MemberSegment", scene: "Builder | Scene") -> bool:
    x, start, end = (scene.number(node) for node in (station.place, segment.start, segment.end))
    slack = 1e-9 * abs(end)
    return start - slack <= x <= end + slack


def preload_of(member: "Member", scene: "Builder") -> "Node":
    """The tension as drawn of a beam, zero where none is given, or of a string, which must be positive."""
    if "preload" not in member.record:
        return scene.table.zero
    preload = member.record["preload"]
    if member.kind.name != "string":
        return scene.lower(preload)
    return scene.positive(preload, f"the tension of '{member.name}'")


def add_piece(segment: "MemberSegment", left: "Station", right: "Station", tension: "Node", ends: "list[Node]",
              scene: "Builder", preload: "Node | None" = None, longer: "Node | None" = None,
              gradient: "Node | None" = None) -> None:
    """A piece of order 2 between two stations, `ends` being its displacements; `longer`: what a bar lengthens besides,
    under its tension as drawn; `gradient`: of the tension along it."""
    gradient = gradient or scene.table.zero
    springs: list[tuple[Node, ...]] = list(springs_along(scene, right.place - left.place, tension, segment.foundation,
                                                         ends, gradient))
    if longer is not None:
        stiffness, stretch = springs[0]
        springs[0] = stiffness, stretch + longer, preload
    _add(segment, left, right, (scene.table.zero, tension, gradient), ends, springs, scene)


def add_across(segment: "MemberSegment", left: "Station", right: "Station", tension: "Node", scene: "Builder") -> None:
    """A piece of a beam between two stations."""
    ends, length, zero = [*left.motions, *right.motions], right.place - left.place, scene.table.zero
    springs = springs_across(scene, length, segment.stiffness, tension, segment.foundation, ends)
    _add(segment, left, right, (segment.stiffness, tension, zero), ends, springs, scene)


def add_graded(owner: str, segment: "MemberSegment", left: "Station", right: "Station", tension: "Node",
               gradient: "Node", scene: "Builder") -> "Node":
    """A piece of a beam whose tension has a gradient; its mean displacement across."""
    from vibcli.elements.graded_beam import graded_beam, plainly

    ends, length = [*left.motions, *right.motions], right.place - left.place

    def found() -> "tuple[list[tuple[Node, Node]], Node]":
        piece = graded_beam(scene, length, segment.stiffness, tension, gradient, segment.foundation)
        return piece.springs(owner, ends), piece.mean(owner, ends)

    springs, mean = plainly(scene, found)
    _add(segment, left, right, (segment.stiffness, tension, gradient), ends, springs, scene)
    return mean


def add_along(member: "Member", segment: "MemberSegment", left: "Station", right: "Station", scene: "Builder") -> None:
    """A piece of a beam that stretches, along it: a bar under its tension as drawn."""
    segment, zero = segment.lengthwise(scene), scene.table.zero
    scene.owned(f"{member.name}.along", partial(
        add_piece, segment, left, right, segment.stiffness, [left.along, right.along], scene,
        preload_of(member, scene), zero))


def _add(segment: "MemberSegment", left: "Station", right: "Station", stiff: "tuple[Node, Node, Node]",
         ends: "list[Node]", springs: "Sequence[tuple[Node, ...]]", scene: "Builder") -> None:
    zero = scene.table.zero
    acting = [(weight, stretch, preload[0] if preload else zero) for weight, stretch, *preload in springs
              if stretch.mask and not weight.is_zero]
    if segment.inertia.is_zero and segment.drag.is_zero:
        for weight, stretch, preload in acting:
            scene.add_spring(weight, preload, stretch)
    else:
        coefficients = (right.place - left.place, *stiff, segment.inertia, segment.drag, segment.foundation)
        scene.add_piece(left.place, coefficients, ends, acting)
