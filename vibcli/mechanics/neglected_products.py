"""What small oscillations leave out: products of the coordinates and of loads in time or driven displacements.

A load F(t) with the virtual work F δs drives by Qᵢ = F ∂s/∂qᵢ. On a curved path this changes with the place, and the
full equations hold also

    −F(t) Σ ∂²s/∂qᵢ∂qⱼ qⱼ,

a stiffness that varies in time (parametric excitation). Loads in time are small of the first order, as the coordinates
are, so that their products are not kept.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.mechanics.autonomous import INSTANTS, with_time
from vibcli.mechanics.linearise import load_at_rest
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.smoothed_functions import SmoothFloats

if TYPE_CHECKING:
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

NOTHING = 1e-9      # of what the load does to the equations


def left_out(symbolic: "SymbolicSystem") -> "dict[int, Node]":
    """{i: node}, what the left side of equation i lacks, linear in the coordinates counted from the equilibrium."""
    scene = symbolic.scene.vibrating
    number, place = {q: i for i, q in enumerate(scene.q)}, symbolic.excitation_place
    place = {symbol: node for symbol, node in place.items() if symbol is not scene.time}
    parts, sizes = {}, {}
    for term in scene.loads_at_still():
        _, turning, waving, constant = load_at_rest(scene, term)
        load = turning + waving, constant       # what holds the time, and the constant that goes with it
        slopes = {q: slope for q, slope in gradient(term.s).items() if q in number}
        for q, slope in slopes.items() if any(not part.is_zero for part in load) else ():
            for other, second in gradient(slope).items():
                if other in number:
                    pair = number[q], number[other]
                    parts.setdefault(pair, []).append([part * second for part in load])
                    sizes.setdefault(pair, []).extend((sum(load[1:], load[0]), row) for row in slopes.values())
    found = _driven(symbolic)
    for (i, j), terms in parts.items():
        node = _at(scene, place, terms)
        if not node.is_zero and not _rounding(symbolic, node, sizes[i, j], place, j):
            found.setdefault(i, []).append(node * symbolic.scene.q[j])
    return {i: scene.table.total(terms) for i, terms in sorted(found.items())}


def _driven(symbolic: "SymbolicSystem") -> "dict[int, list[Node]]":
    if symbolic.scene.resting is symbolic.scene:
        return {}
    from vibcli.mechanics.driven_products import driven_products

    return driven_products(symbolic)


def _at(scene: "Scene", place: "dict[Node, Node]", terms: "Sequence[list[Node]]") -> "Node":
    """−Σ F(t) ∂²s at a position; where the time cancels, as in a load that turns with what it acts on, K has it."""
    waving, constant = (scene.table.total(nodes) for nodes in zip(*terms, strict=True))
    waving, constant = substitute([with_time(scene, waving), constant], place)
    return textbook(-waving - constant)


def _rounding(symbolic: "SymbolicSystem", node: "Node", sizes: "Sequence[tuple[Node, Node]]", place: "dict[Node, Node]",
              j: int) -> bool:
    """Is a coefficient but the rounding of a place that is known in floats?"""
    if symbolic.numeric.has_free_symbols or symbolic.balanced_as_drawn:
        return False
    scene, name = symbolic.scene, symbolic.scene.coordinates[j]
    size = symbolic.numeric.figure_size if symbolic.system.dimension(name) else 1.0
    nodes = substitute([node, *(part for pair in sizes for part in pair)], place)
    largest = [0.0, 0.0]
    for instant in INSTANTS:
        value, *others = evaluate(nodes, SmoothFloats, {**symbolic.configuration.at_rest, scene.time.name: instant})
        largest[0] = max(largest[0], abs(value) * size)
        largest[1] = max(largest[1], *(abs(load * row) for load, row in zip(others[::2], others[1::2], strict=True)))
    return largest[0] <= NOTHING * largest[1]
