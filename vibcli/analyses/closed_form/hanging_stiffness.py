"""Dynamic stiffness of a string whose tension varies evenly, at the end at which others are tied to it: by Bessel
functions of z = 2ω√(μT)/|γ| at its ends (T u′ = −γ/2·z·(A J₁(z) + B Y₁(z)), see hanging_strings)

    k = ∓γ/2·z·J₁(z)/J₀(z)                                     the other end slack, T = 0 there
    k = ∓γ/2·z·(J₁(z) Y₀(z₀) − Y₁(z) J₀(z₀))/(J₀(z) Y₀(z₀) − Y₀(z) J₀(z₀))        held, where z is z₀

the upper sign where the joint is the right end.
"""

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.hanging_strings import tensions
from vibcli.analyses.closed_form.textbook_equation import quotient
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.symbolic.node import Node


class BesselArguments(NamedTuple):
    """z at the ends of a string, None where no tension is."""

    left: "Node | None"
    right: "Node | None"


def bessel_powers(piece: Any, omega: "Node") -> "list[tuple[int, Node] | None]":
    """[(2, z²)] at its ends, None where the tension is zero."""
    return [None if tension.is_zero else (2, textbook(4 * piece.inertia * tension * omega ** 2 / piece.gradient ** 2))
            for tension in tensions(piece)]


def hanging_stiffness(placed: "PlacedPiece", z: BesselArguments, joints: Collection[int],
                      impedance: "Callable[[int, Node], Node]") -> "dict[tuple[int, int], tuple[Node, Node]] | None":
    """As end_stiffness tells it; None where the joint has no tension, or something holds to an end without."""
    right = bool(placed.rows[1]) and next(iter(placed.rows[1])) in joints
    own, other, row = (z.right, z.left, placed.rows[0]) if right else (z.left, z.right, placed.rows[1])
    if own is None or (other is None and row):
        return None
    piece, call = placed.piece, own.table.call
    slope = textbook(piece.gradient / (-2 if right else 2))         # T u′ out of the member is slope·z·(A J₁ + B Y₁)
    A, B = own.table.one, own.table.zero
    if other is not None:
        values = [(call("J0", other), call("Y0", other)), (call("J1", other), call("Y1", other))]
        if row:
            (i, share), = row.items()
            load = textbook(impedance(i, share) / (-slope * other))       # slope·z·(A J₁ + B Y₁) = Z (A J₀ + B Y₀)
            first, second = (one + load * zero for zero, one in zip(*values, strict=True))
        else:
            first, second = values[0]
        A, B = second, -first
    above, below = (A * call(f"J{n}", own) + B * call(f"Y{n}", own) for n in (1, 0))
    over, under = quotient(textbook(slope * own))
    return {(0, 0): (over * above, under * below)}
