"""The energy of a motion and where it comes from and goes: d(T + V)/dt = loads − dissipated + drive.

What drives a scene has the power of the forces along the prescribed motions. With h = Σ q̇ ∂T/∂q̇ − T + V, whose rate is
∂(V − T)/∂t but for loads, dampers and the constraints G(q, t) = 0 with their multipliers, and T + V = h + b,

    drive = ∂(V − T)/∂t + ḃ + Σ λ ∂G/∂t − Σ F ∂s/∂t + Σ c ṡ ∂s/∂t,        b = 2T − Σ q̇ ∂T/∂q̇ = Σ w ṡ ∂s/∂t + …,

the last two sums because loads and dampers count with the whole of ṡ, that which is prescribed included.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import dissipation, kinetic, potential
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.scene.energy_terms import AppliedLoad, Damper
    from vibcli.scene.laws import Law
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class Powers(NamedTuple):
    """Expressions: T + V, T, the power of the loads, what is dissipated, the power of the drive but for ḃ and
    Σ λ ∂G/∂t, b, and ∂G/∂t of each constraint."""

    energy: Any
    kinetic: Any
    loads: Any
    lost: Any
    drive: Any
    carried: Any
    ties: "list[Node]"

    @property
    def driven(self) -> bool:
        """Does anything move as it is prescribed?"""
        return not (self.drive.is_zero and self.carried.is_zero and all(tie.is_zero for tie in self.ties))


def powers(scene: "Scene", ties: Sequence[Any] = ()) -> Powers:
    """The Powers of a scene; `ties`: the conditions G that multipliers hold."""
    table, T, V = scene.table, kinetic(scene), potential(scene)
    zero, loads = table.zero, _forces(scene, scene.forces)
    drags = _forces(scene, [*scene.dampers, *(law for law in scene.laws if law.damper)])
    timed = gradient(V).get(scene.time, zero) - gradient(T).get(scene.time, zero)
    return Powers(T + V, T, table.total(term.power(scene) for term in scene.forces),
                  _slopes(scene, dissipation(scene)) + _prescribed(scene, drags),
                  timed - _prescribed(scene, loads) + _prescribed(scene, drags), _carried(scene),
                  [gradient(node).get(scene.time, zero) for node in ties])


def _forces(scene: "Scene", terms: "Sequence[AppliedLoad | Damper | Law]") -> "list[tuple[Node, Node]]":
    """[(F, s)]."""
    return [(term.force(scene), term.s) for term in terms]


def _prescribed(scene: "Scene", forces: "Sequence[tuple[Node, Node]]") -> "Node":
    """Σ F ∂s/∂t."""
    return scene.table.total(F * gradient(s)[scene.time] for F, s in forces if scene.time in gradient(s))


def _carried(scene: "Scene") -> "Node":
    """b: 2T − Σ q̇ ∂T/∂q̇."""
    moved = _prescribed(scene, [(term.momentum(scene), term.s) for term in scene.inertias])
    T = scene.energies["T"]
    return moved if T.is_zero else moved + textbook(2 * T - _slopes(scene, T))


def _slopes(scene: "Scene", node: "Node") -> "Node":
    """Σ q̇ ∂/∂q̇ of an expression."""
    return scene.table.total(gradient(node)[v] * v for v in scene.v if v in gradient(node))
