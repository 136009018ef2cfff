"""Matrices and generalised forces as functions of the state of a motion: places, velocities and the time.

    M = ∂²T/∂q̇∂q̇        Q = −∂V/∂q + Σ F ∂s/∂q − (d/dt ∂T/∂q̇ − ∂T/∂q)|₀        K = −∂Q/∂q        C = ∂²Φ/∂q̇∂q̇ − ∂Q/∂q̇

Q is that of springs, weights and loads as they act then, and of the inertia of what is driven at relative rest (₀:
where q̇ = q̈ = 0), without dampers; so K and C are those of small motions about a place where the scene stays.
"""

from typing import TYPE_CHECKING

from vibcli.mechanics.energies import dissipation, generalised_force, kinetic, potential
from vibcli.symbolic.derivatives import gradient, substitute

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def entry(scene: "Scene", which: str, i: int, j: int) -> "Node":
    """Of the matrix M, C or K."""
    if which == "K":
        return -_slope(force(scene, i), scene.q[j])
    if which == "C":
        return _slope(_slope(dissipation(scene), scene.v[i]) - generalised_force(scene, i), scene.v[j])
    return _slope(_slope(kinetic(scene), scene.v[i]), scene.v[j])


def force(scene: "Scene", i: int) -> "Node":
    """Q of coordinate i."""
    return generalised_force(scene, i) - _slope(potential(scene), scene.q[i]) - _inertia_at_rest(scene, i)


def _inertia_at_rest(scene: "Scene", i: int) -> "Node":
    """What d/dt ∂T/∂q̇ − ∂T/∂q is where the scene is at rest in its driven frames."""
    still = dict.fromkeys((*scene.v, *scene.a), scene.table.zero)
    if not scene.timed and substitute([scene.energies["T"]], still)[0].is_zero:
        return scene.table.zero
    T = kinetic(scene)
    node = scene.rate(_slope(T, scene.v[i])) - _slope(T, scene.q[i])
    return substitute([node], still)[0]


def _slope(node: "Node", symbol: "Node") -> "Node":
    return gradient(node).get(symbol, node.table.zero)
