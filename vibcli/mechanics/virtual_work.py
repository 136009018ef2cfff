"""Equilibrium by virtual work: δA = Σ Q_q δq with Q_q = 0 for each coordinate (Kovacić & Radomirović 2018, §1.1.3).

Q_q is the generalised force of all weights, springs and loads: Q_q = Σ F ∂s/∂q − ∂V/∂q, at rest.
"""

from typing import TYPE_CHECKING

from vibcli.mechanics.autonomous import steady
from vibcli.mechanics.linearisation import residual_terms
from vibcli.mechanics.linearise import linearise
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def generalised_forces(scene: "Scene") -> "list[Node]":
    """[Q_q] of all coordinates of a scene, simplified."""
    return [textbook(-scene.table.total(terms)) for terms in residual_terms(steady(scene, linearise(scene)))]


def generalised_force_at_rest(system: "MechanicalSystem", i: int) -> "Node":
    """Q of the independent coordinate i, what constraints tie to it included."""
    return -system.scene.table.total(residual_terms(system.linearisation)[i])
