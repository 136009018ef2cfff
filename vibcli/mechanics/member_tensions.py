"""The tension of beams and strings in the plane, on which their stiffness depends, against that in equilibrium."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

ROUNDING = 1e-11        # of the largest force in the scene
SAME = 1e-9             # of the largest tension along a beam that stretches: nearer ones are one


def require_tensions(configuration: "Configuration") -> None:
    """PhysicsError where a member has another tension in equilibrium than as drawn, which is that in its stiffness."""
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
                               "work yet", "let it stand or hang upright, or leave out `gravity`", member.record.where)
    if not scene.setting.variant.preloaded:     # what lets go starts a small motion
        _require_stretch([member for member in placed if member.stretching], configuration)
    tied = {member.name: member for member in placed
            if any(constraint.name == member.name for constraint in scene.constraints)}
    if not tied:
        return
    found = configuration.reactions
    largest = max((abs(reaction.value) for reaction in found if reaction.value is not None), default=0.0)
    for reaction in found:
        member = tied.get(reaction.signal.removesuffix(".force"))
        if member is None or reaction.value is None:
            continue
        drawn = evaluate([member.tie], Floats, configuration.numeric.floats)[0] if member.tie is not None else 0.0
        if abs(reaction.value - drawn) > ROUNDING * (largest + abs(drawn)):
            raise PhysicsError(f"statics finds the tension {reaction.value:.6g} N in '{member.name}', both ends of "
                               "which are held to what moves: its stiffness under it does not work yet",
                               "leave out the loads that cause it",
                               member.record.where)


def _bent(member, configuration):
    """Does a member rest elsewhere than along its line as drawn?"""
    if not member.stretching or configuration.equilibrium.drawn:
        return not configuration.equilibrium.drawn
    moved = [node for station in member.stations for node in station.motions]
    return any(evaluate(moved, Floats, configuration.at_rest))


def _require_stretch(members, configuration):
    """PhysicsError where a beam stretches by another tension in equilibrium than the one in its stiffness: as what
    both its ends are held to, or what bends, takes a share of it."""
    parts = [(member, *evaluate(pair, Floats, configuration.at_rest)) for member in members
             for pair in member.stretch_forces(configuration.scene)]
    largest = max((abs(tension) for _, *both in parts for tension in both), default=0.0)
    for member, found, drawn in parts:
        if abs(found - drawn) > SAME * largest:
            raise PhysicsError(f"'{member.name}' rests under the tension {found:.6g} N, which is not the one found as "
                               "drawn: its stiffness under it does not work yet", "leave out the loads that cause it",
                               member.record.where)
