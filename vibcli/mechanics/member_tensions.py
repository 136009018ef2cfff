"""The tension of beams and strings in the plane, on which their stiffness depends, against that in equilibrium."""

from math import pi
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

ROUNDING = 1e-11        # of the largest force in the scene
SLIGHT = 0.05           # of Euler's load: tensions that statics alone does not find, said beside what leaves them out
SAME = 1e-9             # of the largest tension along a beam that stretches: nearer ones are one


class OpenTension(NamedTuple):
    """A member that rests under the tension `found`, `drawn` being that in its stiffness; `part`: their difference over
    Euler's load π²EI/L²."""

    member: Any
    found: float
    drawn: float
    part: float

    @property
    def slight(self) -> bool:
        """Does it change no stiffness by more than a few per cent?"""
        return self.part < SLIGHT


def require_tensions(configuration: "Configuration") -> None:
    """PhysicsError where a member has quite another tension in equilibrium than the one in its stiffness."""
    scene = configuration.scene
    placed = [member for member in scene.members.values() if member.line is not None and member.kind.name != "bar"]
    if not placed:
        return
    for member in placed:
        if not member.settled and not configuration.equilibrium.drawn:
            raise PhysicsError(f"the tension of '{member.name}' depends on where the scene rests: this does not work "
                               "yet", "draw the scene where it rests", member.record.where)
        varies = any(not piece.piece.gradient.is_zero for piece in configuration.system.linearisation.pieces
                     if piece.owner == member.name)
        if varies and member.kind.bends and _bent(member, configuration):
            raise PhysicsError(f"'{member.name}' is bent by its loads, and its tension varies along it: this does not "
                               "work yet", "let it stand or hang upright with nothing that bends it, or leave out "
                               "`gravity`", member.record.where)
    for one in open_tensions(configuration):
        if not one.slight:
            raise PhysicsError(f"'{one.member.name}' rests under the tension {one.found:.6g} N, which statics alone "
                               "does not find: its stiffness under it does not work yet",
                               "leave out the loads that cause it", one.member.record.where)


def open_tensions(configuration: "Configuration") -> "list[OpenTension]":
    """Those of members that rest under another tension than the one in their stiffness, as what both their ends are
    held to, or what bends, takes a share of the loads."""
    scene = configuration.scene
    placed = [member for member in scene.members.values() if member.line is not None and member.kind.name != "bar"]
    found = _of_ties(placed, configuration)
    if not scene.setting.variant.preloaded:     # what lets go starts a small motion
        found += _of_stretches([member for member in placed if member.stretching], configuration)
    return found


def _of_ties(placed, configuration):
    """Of members that keep their length."""
    scene = configuration.scene
    tied = {member.name: member for member in placed
            if any(constraint.name == member.name for constraint in scene.constraints)}
    if not tied:
        return []
    reactions = [one for one in configuration.reactions if one.value is not None]
    largest, found = max((abs(one.value) for one in reactions), default=0.0), []
    for reaction in reactions:
        member = tied.get(reaction.signal.removesuffix(".force"))
        if member is None:
            continue
        drawn = _at_right_end(member, configuration) if member.tie is not None else 0.0
        if abs(reaction.value - drawn) > ROUNDING * (largest + abs(drawn)):
            found.append(_open(member, reaction.value, drawn, configuration))
    return found


def _at_right_end(member, configuration):
    """The tension in its stiffness where its last piece ends, whose weight does not hang on the end."""
    last, end = member.stations[-2:]
    tension, gradient = member.tensions[-1]
    tension, change = evaluate([tension, gradient * (end.place - last.place)], Floats, configuration.numeric.floats)
    return tension + change


def _of_stretches(members, configuration):
    """Of beams that stretch: one each, where it differs most."""
    parts = [(member, *evaluate(pair, Floats, configuration.at_rest)) for member in members
             for pair in member.stretch_forces(configuration.scene)]
    largest = max((abs(tension) for _, *both in parts for tension in both), default=0.0)
    found = {}
    for member, tension, drawn in sorted(parts, key=lambda part: abs(part[1] - part[2])):
        if abs(tension - drawn) > SAME * largest:
            found[member.name] = _open(member, tension, drawn, configuration)
    return list(found.values())


def _open(member, found, drawn, configuration):
    """An OpenTension; of a string no part of its tension is slight."""
    if not member.kind.bends:
        return OpenTension(member, found, drawn, float("inf"))
    length, *bending = evaluate([member.length, *(segment.stiffness for segment in member.segments)], Floats,
                                configuration.numeric.floats)
    return OpenTension(member, found, drawn, abs(found - drawn) * length**2 / (pi**2 * min(bending)))


def _bent(member, configuration):
    """Does a member rest elsewhere than along its line as drawn?"""
    if configuration.equilibrium.drawn:
        return False
    moved = [node for station in member.stations for node in station.motions]
    return any(evaluate(moved, Floats, configuration.at_rest))
