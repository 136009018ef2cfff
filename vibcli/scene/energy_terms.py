"""The terms of the energies: scalar functions s of coordinates and time, each with its weight.

    T = ½ Σ w ṡ²        V = Σ (N s + ½ k s²) + Σ f s        Φ = ½ Σ c ṡ²        δA = Σ F δs

The force of what joins two ends is positive in lengthening.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class Term(NamedTuple):
    """One function s with its weight; `offset` is the tension N at s = 0 of a spring, of a load in time its steady
    part; `owner` is the name of the element that it came from."""

    weight: "Node"
    s: "Node"
    offset: "Node | None" = None
    owner: str | None = None

    @property
    def nodes(self) -> "list[Node]":
        """The expressions that it is made of."""
        return [node for node in self[:3] if node is not None]

    def over(self, new: "Mapping[Node, Node]") -> "Term":
        """Itself with its expressions replaced, {node: node}."""
        weight, s, offset = (node if node is None else new[node] for node in self[:3])
        return self.__class__(weight, s, offset, self.owner)

    def energy(self, _scene: "Scene") -> "Node | None":
        """None: it stores nothing."""
        return None

    def power(self, _scene: "Scene") -> "Node | None":
        """None: it dissipates nothing."""
        return None


class Inertia(Term):
    """½ w ṡ² of T."""

    __slots__ = ()

    def momentum(self, scene: "Scene") -> "Node":
        """w ṡ."""
        return self.weight * scene.rate(self.s)

    def energy(self, scene: "Scene") -> "Node":
        """½ w ṡ²."""
        return self.weight * scene.rate(self.s) ** 2 * HALF


class Inerter(Inertia):
    """½ b ṡ² of T, of what joins two ends."""

    __slots__ = ()

    def force(self, scene: "Scene") -> "Node":
        """b s̈."""
        return self.weight * scene.rate(scene.rate(self.s))


class Spring(Term):
    """N s + ½ k s² of V."""

    __slots__ = ()

    def force(self, _scene: "Scene") -> "Node":
        """N + k s."""
        return self.offset + self.weight * self.s

    def potential(self, _scene: "Scene") -> "Node":
        """N s + ½ k s², which is the energy but for a constant."""
        return self.offset * self.s + self.weight * self.s * self.s * HALF

    def energy(self, scene: "Scene") -> "Node":
        """F²/2k, counted from where the spring is undeformed."""
        return self.force(scene) ** 2 / self.weight * HALF


class Damper(Term):
    """½ c ṡ² of Φ."""

    __slots__ = ()

    def force(self, scene: "Scene") -> "Node":
        """c ṡ."""
        return self.weight * scene.rate(self.s)

    def potential(self, scene: "Scene") -> "Node":
        """½ c ṡ², its share of Φ."""
        return self.weight * scene.rate(self.s) ** 2 * HALF

    def power(self, scene: "Scene") -> "Node":
        """c ṡ², which it dissipates."""
        return self.force(scene) * scene.rate(self.s)


class Weight(Term):
    """f s of V."""

    __slots__ = ()

    def potential(self, _scene: "Scene") -> "Node":
        """f s."""
        return self.weight * self.s


class AppliedLoad(Term):
    """F δs of δA; F may depend on coordinates, velocities and the time."""

    __slots__ = ()

    @property
    def steady(self) -> "Node":
        """What of F depends on the time through driven frames alone."""
        return self.weight if self.offset is None else self.offset

    def force(self, _scene: "Scene") -> "Node":
        """F."""
        return self.weight

    def power(self, scene: "Scene") -> "Node":
        """F ṡ, which it brings in."""
        return self.weight * scene.rate(self.s)


class RestingLoad(AppliedLoad):
    """F δs of a steady load along a member that vibrates: so it acts at rest alone, in motion as a SpreadForce."""

    __slots__ = ()
