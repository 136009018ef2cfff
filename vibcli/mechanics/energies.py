"""T, V and Φ of a scene as expressions, from the scalar functions of its elements."""

from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF, ONE


def potential(scene):
    """V = Σ (N s + ½ k s²) + Σ f s + what is written out."""
    return scene.table.sum(*_stored(scene, scene.springs, scene.weights), *_quadratic(scene, "K", scene.q),
                           (scene.energies["V"], ONE))


def potential_as_drawn(scene):
    """V with the driven displacements as symbols that are zero as drawn."""
    if not scene.shaken:
        return potential(scene)
    laws = [(undriven.potential(scene) - law.potential(scene), ONE)
            for law, undriven in zip(scene.laws, scene.shaken["laws"], strict=True) if not law.damper]
    return scene.table.sum(*_stored(scene, scene.shaken["springs"], scene.shaken["weights"]), *laws,
                           *_quadratic(scene, "K", scene.q), (scene.energies["V"], ONE))


def _stored(scene, *kinds):
    """N s + ½ k s² and f s of each term, as terms of a sum."""
    return [(term.potential(scene), ONE) for terms in kinds for term in terms]


def kinetic(scene):
    """T = ½ Σ w ṡ² + what is written out."""
    return scene.table.sum(*((term.energy(scene), ONE) for term in scene.inertias), *_quadratic(scene, "M", scene.v),
                           (scene.energies["T"], ONE))


def dissipation(scene):
    """Φ = ½ Σ c ṡ² + what is written out."""
    return scene.table.sum(*((term.potential(scene), ONE) for term in scene.dampers), *_quadratic(scene, "C", scene.v),
                           (scene.energies["Phi"], ONE))


def generalised_force(scene, i):
    """Q_q = Σ F ∂s/∂q of the forces and moments, from their virtual work δA = Σ F δs = Σ Q_q δq."""
    q, zero = scene.q[i], scene.table.zero
    return scene.table.sum(*((term.weight * gradient(term.s).get(q, zero), ONE) for term in scene.forces))


def _quadratic(scene, key, symbols):
    """½ xᵀ A x of a matrix given outright, as terms of a sum."""
    rows = scene.matrices.get(key, ())
    return [(rows[i][j] * symbols[i] * symbols[j], HALF) for i in range(len(rows)) for j in range(len(rows))]


def effective_potential(scene):
    """V − T at rest − Σ F s of constant forces: what is stationary in (relative) equilibrium."""
    from vibcli.symbolic.derivatives import substitute

    rest = dict.fromkeys(scene.v, scene.table.zero)
    loads = scene.table.sum(*((term.weight * term.s, ONE) for term in scene.forces))
    return potential(scene) - substitute([scene.energies["T"]], rest)[0] - loads


def textbook_energies(scene):
    """{'T': …, 'V': …, 'Phi': …} simplified; parts of V that do not depend on the coordinates are left out."""
    return {"T": textbook(kinetic(scene)), "V": _textbook_potential(scene), "Phi": _textbook_dissipation(scene)}


def _textbook_potential(scene):
    """V with the energy ½ k d² of each spring kept as it is read off the figure; weights collected."""
    table, rest, parts = scene.table, [(scene.energies["V"], ONE)], []
    rest += _stored(scene, scene.weights)
    if "K" in scene.matrices:
        rest += _quadratic(scene, "K", scene.q)
    for term in scene.springs:
        stretch = textbook(term.s)
        rest.append((term.offset * stretch, ONE))
        if stretch.op == "sum":
            parts.append((table.product((term.weight, ONE), (stretch, ONE + ONE)), HALF))
        else:
            rest.append((term.weight * stretch * stretch, HALF))
    collected = textbook(table.sum(*rest))
    if collected.op == "sum":
        collected = table.sum(*((part, c) for part, c in collected.args if part.mask))
    return table.sum(*parts, (collected, ONE))


def _textbook_dissipation(scene):
    """Φ with the part ½ c ḋ² of each damper kept as it is read off the figure."""
    table, parts = scene.table, []
    rest = [*_quadratic(scene, "C", scene.v), (scene.energies["Phi"], ONE)]
    for term in scene.dampers:
        speed = textbook(scene.rate(term.s))
        if speed.op == "sum":
            parts.append((table.product((term.weight, ONE), (speed, ONE + ONE)), HALF))
        else:
            rest.append((term.weight * speed * speed, HALF))
    return table.sum(*parts, (textbook(table.sum(*rest)), ONE))
