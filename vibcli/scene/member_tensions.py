"""The tension along beams and strings in the plane, as it is found in statics, by virtual work.

A scene whose members are cut open at their stations has for each a coordinate t along the line; as drawn the force
F = −∂V/∂t + Σ Q ∂s/∂t of all that hangs there on the member balances the tensions left and right of it, Nⱼ₊₁ = Nⱼ − F.
Where both ends are held, statics leaves N open but for the `preload`.
"""

from typing import TYPE_CHECKING, NamedTuple

from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene


class Tensions(NamedTuple):
    """N of each piece of a member as drawn, and whether it is the same wherever the scene rests."""

    pieces: list
    settled: bool


def tensions(scene: "Scene") -> dict[str, Tensions]:
    """{name: Tensions} of a scene that is `stretched`."""
    cuts = {t: scene.table.zero for member in scene.members.values() for t in member.stretches if t is not None}
    return {name: _found(scene, member, cuts) for name, member in scene.members.items() if member.stretches}


def _found(scene, member, cuts):
    whole = [None if t is None else substitute([_force(scene, t)], cuts)[0] for t in member.stretches]
    forces = [None if node is None else textbook(scene.at_drawn(node)[0]) for node in whole]
    settled = all(node is None or is_zero(node - force) for node, force in zip(whole, forces, strict=True))
    return Tensions(_along(scene, member, forces), settled)


def _along(scene, member, forces):
    if forces[-1] is not None:
        return _summed(forces[:0:-1], scene.table.zero)[::-1]
    if forces[0] is not None:
        return [-node for node in _summed(forces[:-1], scene.table.zero)]
    start = scene.lower(member.record["preload"]) if "preload" in member.record else scene.table.zero
    inner = [scene.table.zero, *_summed(forces[1:-1], scene.table.zero)]
    return [start - node for node in inner]


def _summed(forces, total):
    found = []
    for force in forces:
        total = total + force
        found.append(total)
    return found


def _force(scene, t):
    """What pulls the station along, but for the member itself: −∂V/∂t and steady loads."""
    zero = scene.table.zero
    parts = [-(term.force(scene) * gradient(term.s).get(t, zero)) for term in scene.springs]
    parts += [-(term.weight * gradient(term.s).get(t, zero)) for term in scene.weights]
    parts += [term.steady * gradient(term.s).get(t, zero) for term in scene.forces]
    return scene.table.total([*parts, -gradient(scene.energies["V"]).get(t, zero)])
