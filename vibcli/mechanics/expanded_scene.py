"""The equations of motion expanded to the third order in the deviations ξ = q − qₑ from equilibrium.

V, T and Φ to the fourth order, so that the energy of a conservative scene is kept as it is by the full equations; loads
that have a potential count with V, the generalised forces of others are expanded to the third order (Kovacić &
Radomirović 2018, 9.5). The coordinates still count from the drawn position; the time is left as it is.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.energies import dissipation, generalised_force, kinetic, potential
from vibcli.mechanics.expansion import expanded_about, require_expandable, up_to
from vibcli.scene.energy_terms import AppliedLoad
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

ENERGY, FORCE = 4, 3        # orders
LARGEST = 6                 # coordinates


def expanded_scene(scene: "Scene", place: "Mapping[str, Node]") -> "Scene":
    """The scene whose energies and loads are expanded about the place, {coordinate: node}; PhysicsError where they have
    no such expansion."""
    require_expandable(scene)
    if len(scene.q) > LARGEST:
        raise PhysicsError(f"equations are expanded of up to {LARGEST} coordinates, and this scene has {len(scene.q)}",
                           "ask for its motion in full, motion: full")
    constant = [term for term in scene.forces if not term.weight.mask]
    others = scene.with_parts(contents=scene.contents._replace(
        forces=[term for term in scene.forces if term.weight.mask]))
    V = potential(scene) - scene.table.total(term.weight * term.s for term in constant)
    found = {"T": truncated(scene, kinetic(scene), place, ENERGY, True), "V": truncated(scene, V, place, ENERGY, False),
             "Phi": truncated(scene, dissipation(scene), place, ENERGY, True)}
    loads = []
    for i, q in enumerate(scene.q if others.forces else ()):
        force = truncated(scene, generalised_force(others, i), place, FORCE, True)
        if not force.is_zero:
            loads.append(AppliedLoad(force, q, owner=others.forces[0].owner))
    return scene.with_parts(still=None, contents=scene.contents._replace(
        energies=found, forces=loads, matrices=_skew(scene), inertias=[], springs=[], weights=[], dampers=[], laws=[],
        shaken={}))


def truncated(scene: "Scene", node: "Node", place: "Mapping[str, Node]", order: int, rates: bool) -> "Node":
    """An expression expanded to an order in the deviations, and the velocities where there are `rates`."""
    table, variables = scene.table, [*scene.q, *(scene.v if rates else ())]
    if not any(node.mask & x.mask for x in variables):
        return node
    variables = [x for x in variables if node.mask & x.mask]
    shifts = [x - place.get(x.name, table.zero) for x in variables]
    terms = expanded_about(scene, node, place, variables, up_to(order), order)
    return table.sum(*((table.product((c, ONE), *((u, n) for u, n in zip(shifts, powers, strict=True) if n)), ONE)
                       for powers, c in terms.items() if not c.is_zero))


def _skew(scene):
    """The skew part of a C that is given outright, which no dissipation function has."""
    C = scene.matrices.get("C")
    if C is None:
        return {}
    return {"C": [[(C[i][j] - C[j][i]) * HALF for j in range(len(C))] for i in range(len(C))]}
