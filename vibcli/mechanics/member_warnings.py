"""What makes the theory of slender members about their drawn line doubtful: thick beams, large turns in equilibrium,
tensions that statics alone does not find."""

from collections.abc import Iterator
from itertools import pairwise
from math import atan2
from typing import TYPE_CHECKING

from vibcli.scene.member_tensions import along_member, is_between_fixed, placed_members
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.mechanics.configuration import Configuration

SLENDER, SMALL = 10.0, 0.1
ROUNDING = 1e-9         # of the length: supports that are nearer are one


def member_warnings(configuration: "Configuration") -> list[str]:
    """Sentences about the members of a scene with numbers."""
    found: list[str] = []
    for member in configuration.scene.members.values():
        if member.kind.bends:
            found += _thick(member, configuration)
    for member in configuration.scene.members.values():
        if not member.kind.torsional:
            found += _turned(member, configuration)
    found += [f"the {side} end of '{member.name}' is held to '{name}' {off:.6g} m from where that is drawn, as by a "
              "rigid arm without mass" for member in configuration.scene.members.values()
              for side, name, off in member.arms(configuration.scene)]
    settled = configuration.system.settled
    names = () if settled is None else settled.names
    found += [_from_equilibrium(configuration, name) for name in names]
    return [*found, *(line for member in placed_members(configuration.scene)
                      for line in _between(configuration, member))]


def _from_equilibrium(configuration: "Configuration", name: str) -> str:
    """How the tension of a member was found."""
    scene = configuration.scene
    found = evaluate(along_member(scene.members[name], scene), Floats, configuration.at_rest)
    told = list(dict.fromkeys(f"{x:.6g}" for x in (min(found), max(found))))
    return f"'{name}': tension {' to '.join(told)} N: statics alone leaves it open; from the equilibrium"


def _between(configuration: "Configuration", member: "Member") -> Iterator[str]:
    """The tension of a member between ends at rest, where its weight varies it."""
    settled = configuration.system.settled
    if not is_between_fixed(member) or (settled is not None and member.name in settled.names):
        return
    left, *_, right = evaluate(along_member(member, configuration.scene), Floats, configuration.at_rest)
    if abs(right - left) <= ROUNDING * max(abs(left), abs(right)):
        return
    if member.stretching:
        yield _from_equilibrium(configuration, member.name)
    else:
        yield (f"'{member.name}': tension {left:.6g} N at its left end, {right:.6g} N at its right one: statics alone "
               "leaves it open, `preload` tells its mean")


def _thick(member: "Member", configuration: "Configuration") -> Iterator[str]:
    """L/h below 10 between supports, where shear and rotary inertia count (Timoshenko 1921)."""
    deep = [segment for segment in member.segments if segment.section is not None]
    floats = configuration.numeric.floats
    held = evaluate([station.place for station in member.stations if station.u.is_zero], Floats, floats)
    length, = evaluate([member.length], Floats, floats)
    stops = sorted({0.0, *held, length})
    spans = [(a, b) for a, b in pairwise(stops) if b - a > ROUNDING * length]
    parts = [evaluate([part.start, part.end, part.section.depth], Floats, floats) for part in deep]
    ratios = [((b - a) / depth, a, b) for a, b in spans for start, end, depth in parts if start < b and end > a]
    ratio, a, b = min(ratios, default=(SLENDER, 0.0, 0.0))
    if ratio < SLENDER:
        where = f" between {a:.6g} m and {b:.6g} m" if len(spans) > 1 else ""
        yield (f"'{member.name}' is thick{where}: L/h is {ratio:.3g}, below 10; shear and rotary inertia, which are "
               "left out, lower its frequencies")


def _turned(member: "Member", configuration: "Configuration") -> Iterator[str]:
    """More than 0.1 rad in equilibrium, at a station or between two."""
    scene, string = configuration.scene, member.kind.stiffness is None
    if not string and not any(node.mask for node in member.nodes):
        return
    slopes = [station.slope for station in member.stations if station.slope is not None]
    if string:
        pieces = member.signals_along(scene.resting, "slope", scene.table.zero)
        slopes += [one._replace(at=at).static(scene.resting) for one in pieces for at in (one.at, one.length)]
    elif member.kind.bends or member.line is not None:
        slopes += [(right.u - left.u) / (right.place - left.place) for left, right in pairwise(member.stations)]
    largest = max(map(abs, evaluate(slopes, Floats, configuration.at_rest)), default=0.0)
    if member.turns:        # as far as it likes, about any point
        first, last = member.stations[0], member.stations[-1]
        largest = abs(atan2(*evaluate([last.u - first.u, member.length + (last.along - first.along)], Floats,
                                      configuration.at_rest)))
    if largest > SMALL:
        yield (f"'{member.name}' turns by {largest:.3g} rad in equilibrium, more than 0.1 rad: members are linear "
               "about their drawn line")
