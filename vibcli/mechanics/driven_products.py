"""What small oscillations leave out of driven displacements: products of them and of the coordinates.

A displacement u(t) that comes and goes is small of the first order, as the coordinates are. Of the forces r(q, q̇, u, u̇)
small oscillations keep what is linear; the full equations hold also

    Σ (∂²rᵢ/∂u∂qⱼ u + ∂²rᵢ/∂u̇∂qⱼ u̇) qⱼ + (∂²rᵢ/∂u∂q̇ⱼ u + ∂²rᵢ/∂u̇∂q̇ⱼ u̇) q̇ⱼ,

stiffness and damping that vary in time (parametric excitation), as where a spring turns with its shaken end. Of inertia
the same vanishes: where it does not, there are no small oscillations (`steady`, `through_constraints`).
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.mechanics.autonomous import INSTANTS
from vibcli.mechanics.energies import dissipation, potential
from vibcli.mechanics.linearise import load_at_rest
from vibcli.mechanics.symbolic_linear import place_in_letters
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.smoothed_functions import SmoothFloats
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node

NOTHING = 1e-9      # of what the displacement does to the equations


def driven_products(symbolic: "SymbolicSystem") -> "dict[int, list[Node]]":
    """{i: [products]} on the left side of equation i, the coordinates counted from the equilibrium."""
    if symbolic.numeric.has_free_symbols and not symbolic.linearisable:
        return {}
    opened, found = symbolic.configuration.with_inputs, {}
    scene, forces = opened.scene, _forces(opened)
    for j, opening in enumerate(scene.inputs.values(), opened.n):
        if opening.node is None:
            continue
        bends = _bends(opened, forces, j)
        for (i, symbol, rate), node in _at_equilibrium(symbolic, j, bends).items():
            moved = scene.rate(opening.node) if rate else opening.node
            found.setdefault(i, []).append(node * moved * symbol)
    return {i: copied(products, symbolic.scene.table) for i, products in found.items()}


def _bends(opened: "SystemWithInputs", forces: "Sequence[list[Node]]", j: int) -> "dict[tuple[int, Node, int], Node]":
    """{(i, qₖ or q̇ₖ, is it by u̇?): ∂²rᵢ} by the input number j."""
    scene, found = opened.scene, {}
    moving = {*scene.q[:opened.n], *scene.v[:opened.n]}
    for i, terms in enumerate(forces):
        for rate, u in enumerate((scene.q[j], scene.v[j])):
            for slope in (gradient(term)[u] for term in terms if u in gradient(term)):
                for symbol, second in gradient(slope).items():
                    if symbol in moving:
                        found.setdefault((i, symbol, rate), []).append(second)
    return {key: scene.table.total(terms) for key, terms in found.items()}


def _forces(opened: "SystemWithInputs") -> "list[list[Node]]":
    """[[terms of rᵢ]]: ∂V/∂qᵢ + ∂Φ/∂q̇ᵢ − Σ F ∂s/∂qᵢ, of loads in time the part F that is steady (`left_out` has the
    rest)."""
    scene = opened.scene
    stored, damped = gradient(potential(scene)), gradient(dissipation(scene))
    found = [[part[x] for part, x in ((stored, scene.q[i]), (damped, scene.v[i])) if x in part]
             for i in range(opened.n)]
    for term in scene.forces:
        if term.weight in scene.inputs:
            continue
        _, _, waving, constant = load_at_rest(scene, term)
        slopes = gradient(term.s)
        for i, q in enumerate(scene.q[:opened.n]):
            if q in slopes:
                found[i].append((waving + constant - term.weight) * slopes[q])
    return found


def _at_equilibrium(symbolic: "SymbolicSystem", j: int,
                    bends: "dict[tuple[int, Node, int], Node]") -> "dict[tuple[int, Node, int], Node]":
    """The second derivatives in equilibrium, those that vanish left out."""
    opened = symbolic.configuration.with_inputs
    scene = opened.scene
    if not symbolic.numeric.has_free_symbols:
        bends = _felt(symbolic.configuration, j, bends)
    place = place_in_letters(symbolic) if symbolic.linearisable else opened.place
    place = {symbol: node for symbol, node in place.items() if symbol is not scene.time}
    nodes = substitute(list(bends.values()), place)
    if symbolic.linearisable:
        nodes = list(map(textbook, nodes))
    else:
        numbers = evaluate(list(bends.values()), SmoothFloats, opened.values)
        nodes = [textbook(node) if node.mask & scene.time.mask else scene.table.number(Fraction(x))
                 for node, x in zip(nodes, numbers, strict=True)]
    return {key: node for key, node in zip(bends, nodes, strict=True) if not node.is_zero}


def _felt(configuration: "Configuration", j: int,
          bends: "dict[tuple[int, Node, int], Node]") -> "dict[tuple[int, Node, int], Node]":
    """Those that are more than rounding beside what the displacement does to the equations at once."""
    opened = configuration.with_inputs
    scene, n = opened.scene, opened.n
    length = list(map(configuration.numeric.size_along, scene.coordinates[:n]))
    number = {symbol: (k, order) for order, kind in enumerate((scene.q, scene.v)) for k, symbol in enumerate(kind)}
    sizes = dict.fromkeys(bends, 0.0)
    for instant in INSTANTS:
        found = evaluate(list(bends.values()), SmoothFloats, {**opened.values, scene.time.name: instant})
        for key, x in zip(bends, found, strict=True):
            i, symbol, _ = key
            sizes[key] = max(sizes[key], abs(x) * length[i] * length[number[symbol][0]])
    at_once = [max((abs(x) * length[i] for i, x in part.items()), default=0.0) for part in opened.columns[j]]
    at_once = [*at_once[:2], 0.0]       # nothing that goes with u̇ q̇ is linear
    order = {key: key[2] + number[key[1]][1] for key in bends}
    for key, size in sizes.items():
        at_once[order[key]] = max(at_once[order[key]], size)
    return {key: node for key, node in bends.items() if sizes[key] > NOTHING * at_once[order[key]]}
