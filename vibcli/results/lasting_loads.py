"""Loads along members that set in at the start and last, f(x)·g for t > 0, where waves travel: what they bend a piece
by while its ends are held stands still, and the waves are counted from it.

    u = g·w + v      N w″ = −f, w = 0 at both ends      N v″ = μ v̈, v(x, 0) = u₀ − g·w      on the ends g ∫ f H dx
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.antiderivatives import antiderivative
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.scene.spread_forces import SpreadForce
    from vibcli.symbolic.node import Node


class LastingLoad(NamedTuple):
    """A load along a member that lasts: the SpreadForce, its f(x) in numbers, and g."""

    force: "SpreadForce"
    drive: "SpreadDrive"
    size: float

    def bends(self, placed: "PlacedPiece", x: float, along: int) -> float:
        """g·w at x of a piece, or a derivative of it."""
        return self.size * float(np.asarray(self.drive.between(placed, np.zeros(1), x, along)).item())

    def on_ends(self, placed: "PlacedPiece") -> list[float]:
        """∫ f H dx on the ends of a piece."""
        found = self.drive.end_loads(placed, 0.0)
        return [0.0, 0.0] if found is None else [float(one) for one in found]

    def field(self, placed: "PlacedPiece", place: "Node") -> "Node | None":
        """g·w of the place along a piece; None where it does not act."""
        if self.drive.on(placed) is None:
            return None
        table, length = place.table, place.table.number(fraction_of(float(placed.piece.length)))
        local = {self.force.x: place + table.number(fraction_of(float(placed.start)))}
        found = substitute([self.force.along], local)[0]
        for _ in range(2):
            found = found and antiderivative(found, place)
        if found is None:
            raise NotByWaves(f"what '{self.force.owner}' bends '{placed.owner}' by is not found as a formula")
        left, right = (substitute([found], {place: end})[0] for end in (table.zero, length))
        weight = table.number(fraction_of(-self.size / float(placed.piece.tension)))
        return weight * (found - left - (right - left) * place / length)


def lasting_load(force: "SpreadForce", drive: "SpreadDrive", weight: "Forcing") -> LastingLoad:
    """The LastingLoad of a SpreadForce; weight: its g(t). NotByWaves where that varies after the start."""
    pieces = weight.pieces if weight.listed else ()
    if len(pieces) != 1 or pieces[0].start or pieces[0].impulses or any(
            wave.power or wave.exponent for wave in pieces[0].waves):
        raise NotByWaves("loads along members that vary in time are followed by modes")
    return LastingLoad(force, drive, sum(wave.coefficient.real for wave in pieces[0].waves))
