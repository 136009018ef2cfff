"""Matrices and generalised forces as functions of the state of a motion: places, velocities and the time.

    Mᵢⱼ = ∂²T/∂q̇ᵢ∂q̇ⱼ        Cᵢⱼ = ∂²Φ/∂q̇ᵢ∂q̇ⱼ        Qᵢ = −∂V/∂qᵢ + Σ F ∂s/∂qᵢ        Kᵢⱼ = −∂Qᵢ/∂qⱼ

Q is that of springs, weights and loads as they act then, without dampers and inertia; K is their tangent stiffness.
"""

from typing import TYPE_CHECKING

from vibcli.mechanics.energies import dissipation, generalised_force, kinetic, potential
from vibcli.symbolic.derivatives import gradient

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def entry(scene: "Scene", which: str, i: int, j: int) -> "Node":
    """Of the matrix M, C or K."""
    if which == "K":
        return -_slope(force(scene, i), scene.q[j])
    energy = {"M": kinetic, "C": dissipation}[which](scene)
    return _slope(_slope(energy, scene.v[i]), scene.v[j])


def force(scene: "Scene", i: int) -> "Node":
    """Q of coordinate i."""
    return generalised_force(scene, i) - _slope(potential(scene), scene.q[i])


def _slope(node, symbol):
    return gradient(node).get(symbol, node.table.zero)
