"""T, V and Φ of a scene as expressions, from the scalar functions of its elements."""

from typing import TYPE_CHECKING

from vibcli.scene.piece_terms import PieceSpring
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import TooLong, textbook

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def potential(scene: "Scene") -> "Node":
    """V = Σ (N s + ½ k s²) + Σ f s + what is written out."""
    stored = [term.potential(scene) for terms in (scene.springs, scene.weights) for term in terms]
    return scene.table.total([*stored, *_written_out(scene, "V")])


def potential_as_drawn(scene: "Scene") -> "Node":
    """V with the driven displacements as symbols that are zero as drawn."""
    if not scene.shaken:
        return potential(scene)
    stored = [term.potential(scene) for kind in ("springs", "weights") for term in scene.shaken[kind]]
    laws = [undriven.potential(scene) - law.potential(scene)
            for law, undriven in zip(scene.laws, scene.shaken["laws"], strict=True) if not law.damper]
    return scene.table.total([*stored, *laws, *_written_out(scene, "V")])


def kinetic(scene: "Scene") -> "Node":
    """T = ½ Σ w ṡ² + what is written out."""
    return scene.table.total([*(term.energy(scene) for term in scene.inertias), *_written_out(scene, "T")])


def dissipation(scene: "Scene") -> "Node":
    """Φ = ½ Σ c ṡ² + what is written out."""
    return scene.table.total([*(term.potential(scene) for term in scene.dampers), *_written_out(scene, "Phi")])


def generalised_force(scene: "Scene", i: int) -> "Node":
    """Q_q = Σ F ∂s/∂q of the forces and moments, from their virtual work δA = Σ F δs = Σ Q_q δq."""
    q, zero = scene.q[i], scene.table.zero
    return scene.table.total(term.weight * gradient(term.s).get(q, zero) for term in scene.forces)


def _written_out(scene: "Scene", key: str) -> "list[Node]":
    """The terms of T, V or Φ that `energies` gives, and ½ xᵀ A x of a matrix given outright."""
    matrix, symbols = {"T": ("M", scene.v), "V": ("K", scene.q), "Phi": ("C", scene.v)}[key]
    rows = scene.matrices.get(matrix, ())
    return [*(rows[i][j] * symbols[i] * symbols[j] / 2 for i in range(len(rows)) for j in range(len(rows))),
            scene.energies[key]]


def effective_potential(scene: "Scene") -> "Node":
    """V − T at rest − Σ F s of constant forces: what is stationary in (relative) equilibrium."""
    from vibcli.symbolic.derivatives import substitute

    rest = scene.rates_at_rest
    loads = scene.table.total(term.weight * term.s for term in scene.forces)
    return potential(scene) - substitute([scene.energies["T"]], rest)[0] - loads


def relative_potential(scene: "Scene") -> "Node | None":
    """V − T at q̇ = 0 − Σ F s where places hang on the time and equations need not, as in a frame that turns steadily;
    None where it depends on the time, or there are loads that do not have such a part."""
    from vibcli.symbolic.derivatives import substitute

    if any(term.weight.mask for term in scene.forces):
        return None
    rest = scene.rates_at_rest
    loads = scene.table.total(term.weight * term.s for term in scene.forces)
    found = textbook(potential(scene) - substitute([kinetic(scene)], rest)[0] - loads)
    return None if found.mask & scene.time.mask else found


def textbook_kinetic(scene: "Scene") -> "Node":
    """T simplified: one fraction where it divides by a sum, as the mass of a body with holes, and that is shorter."""
    from vibcli.symbolic.common_denominator import divides, single
    from vibcli.symbolic.nested_form import letters

    whole = kinetic(scene)
    found = textbook(whole)
    try:
        return min((found, single(found)), key=letters) if divides(whole) else found
    except TooLong:
        return found


def textbook_energies(scene: "Scene") -> "dict[str, Node]":
    """{'T': …, 'V': …, 'Phi': …} simplified; parts of V that do not depend on the coordinates are left out."""
    return {"T": textbook_kinetic(scene), "V": _textbook_potential(scene), "Phi": _textbook_dissipation(scene)}


def _textbook_potential(scene: "Scene") -> "Node":
    """V with the energy ½ k d² of each spring kept as it is read off the figure; weights collected. What pieces of
    members with inertia store is left out: it is no sum of squares but at rest."""
    table, parts = scene.table, []
    rest = [*_written_out(scene, "V"), *(term.potential(scene) for term in scene.weights)]
    for term in scene.springs:
        if isinstance(term, PieceSpring):
            continue
        stretch = textbook(term.s)
        rest.append(term.offset * stretch)
        (parts if stretch.op == "sum" else rest).append(_half_square(term.weight, stretch))
    collected = textbook(table.total(rest))
    if collected.op == "sum":
        collected = table.sum(*((part, c) for part, c in collected.args if part.mask))
    return table.total([*parts, collected])


def _textbook_dissipation(scene: "Scene") -> "Node":
    """Φ with the part ½ c ḋ² of each damper kept as it is read off the figure."""
    parts, rest = [], _written_out(scene, "Phi")
    for term in scene.dampers:
        speed = textbook(scene.rate(term.s))
        (parts if speed.op == "sum" else rest).append(_half_square(term.weight, speed))
    return scene.table.total([*parts, textbook(scene.table.total(rest))])


def _half_square(weight: "Node", node: "Node") -> "Node":
    """½ weight·node², a sum kept as it is."""
    return weight.table.product((weight, 1), (node, 2)) / 2
