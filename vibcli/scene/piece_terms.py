"""Uniform pieces of bars, shafts, strings and beams as functions of the coordinates, with their static springs.

A piece acts through the displacements of its ends, u₀, u_l, of beams u₀, u₀′, u_l, u_l′: scalar functions s(q, t), as
every element does. At rest it is springs, exactly; in motion its dynamic stiffness takes their place.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.scene.energy_terms import Spring

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


class PieceSpring(Spring):
    """½ k s² of V: a part of what a piece with inertia, drag or a foundation stores at rest."""

    __slots__ = ()
    of_piece = True


class PieceTerm(NamedTuple):
    """A piece of the member `owner` from its place `start` on: the coefficients of its equation, length, B, N, n, μ, c,
    k as in a Piece, and the displacements of its ends, all expressions. `springs`: how many PieceSprings of the scene
    are its own, in the order of both."""

    owner: str
    start: "Node"
    coefficients: "tuple[Node, ...]"
    s: "tuple[Node, ...]"
    springs: int

    @property
    def drag(self) -> "Node":
        """The drag per length c."""
        return self.coefficients[5]

    @property
    def nodes(self) -> "list[Node]":
        """The expressions that it is made of."""
        return [self.start, *self.coefficients, *self.s]

    def over(self, new: "Mapping[Node, Node]") -> "PieceTerm":
        """Itself with its expressions replaced, {node: node}."""
        return self._replace(start=new[self.start], coefficients=tuple(new[node] for node in self.coefficients),
                             s=tuple(new[node] for node in self.s))
