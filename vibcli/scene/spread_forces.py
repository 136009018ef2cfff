"""Loads along members that vary in time, on pieces with inertia or drag: δA = g(t) ∫ f(x) δu dx."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


class SpreadForce(NamedTuple):
    """`along`, f(x), per length of a member from `start` to `end`, times `weight`, g(t) or an input; `x` the place in
    it, along the member; `owner` the load that it is of."""

    owner: str
    member: str
    start: "Node"
    end: "Node"
    along: "Node"
    weight: "Node"
    x: "Node"

    @property
    def nodes(self) -> "list[Node]":
        """The expressions that it is made of."""
        return [self.start, self.end, self.along, self.weight]

    def over(self, new: "Mapping[Node, Node]") -> "SpreadForce":
        """Itself with its expressions replaced, {node: node}."""
        return self._replace(start=new[self.start], end=new[self.end], along=new[self.along], weight=new[self.weight])
