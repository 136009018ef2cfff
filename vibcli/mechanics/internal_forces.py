"""Forces and moments within members along each, and those at rest."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.member_signals import PARTS, STRETCHING
from vibcli.mechanics.rest_curves import curves_at_rest
from vibcli.numerics.stretches import CurveStretch

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.mechanics.configuration import Configuration
    from vibcli.scene.scene import Scene

UNITS = {"force": "N", "shear": "N", "moment": "N·m"}


class InternalForce(NamedTuple):
    """A force or moment along a member, `part` of its signals, in Stretches from its left end to its right one;
    `error(place)` bounds how far a value there may be off."""

    member: str
    part: str
    stretches: list[CurveStretch]
    error: Callable[..., float] = lambda place: 0.0

    @property
    def unit(self) -> str:
        return UNITS[self.part]

    @property
    def largest(self) -> float:
        """The largest of its absolute values that are shown."""
        return max(float(np.abs(stretch.points()[1]).max()) for stretch in self.stretches)


def forces_within(scene: "Scene") -> "list[tuple[str, Member, str]]":
    """(name, Member, part) of all forces and moments within members, as signals name them."""
    return [(name, member, part) for name, member in scene.members.items() if member.turns or not member.lengthwise
            for part in UNITS if part in PARTS[member.kind.name + "s"] or (member.stretching and part in STRETCHING)]


def forces_at_rest(configuration: "Configuration") -> list[InternalForce]:
    """Those of all members in equilibrium."""
    scene = configuration.scene.resting
    return [InternalForce(name, part, curves_at_rest(configuration, member, part))
            for name, member, part in forces_within(scene)]
