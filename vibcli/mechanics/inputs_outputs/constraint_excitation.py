"""What is driven to and fro and acts through constraints: its share of the excitation, as columns of the opened scene.

About the equilibrium, in which it is held, a displacement u(t) that constraints tie to the coordinates drives them by

    Qᵢ = −Σ (Mᵢᵤ ü + (C + G)ᵢᵤ u̇ + Kᵢᵤ u)

to first order. Inertia must not carry it into M, C or K: of each s(q, u) with its weight w in T, the terms

    w (sᵢⱼ sᵤ + sᵢ sⱼᵤ) ü qⱼ,      2 w sᵢ sⱼᵤ u̇ q̇ⱼ,      w (sᵢᵤ sⱼ + sᵢ sⱼᵤ) u q̈ⱼ        must vanish in sum.
"""

from collections.abc import Mapping
from itertools import product
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.linearisation import at_position
from vibcli.mechanics.linearise import row_of, slopes_of
from vibcli.mechanics.symbolic_linear import place_in_letters
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import fraction_of
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.displacements import Opening
    from vibcli.scene.energy_terms import Inertia
    from vibcli.symbolic.node import Node

SAME = 1e-9


def excitation_through(symbolic: "SymbolicSystem") -> "dict[int, Node]":
    """{i: Q(t)} of the displacements that are driven to and fro."""
    opened = symbolic.configuration.with_inputs
    table, found = opened.scene.table, {}
    if symbolic.linearisable:
        M, C, G, K = matrices_in_letters(at_position(opened.form, place_in_letters(symbolic)))
    else:
        opened.require_steady({j: 1.0 for j, _ in _driven(opened)})
        M, C, G, K = ({pair: table.number(fraction_of(x)) for pair, x in part.items()}
                      for part in opened.numbers.elements.matrices())
    for j, opening in _driven(opened):
        moved = opening.node
        for matrices in ((K,), (C, G), (M,)):
            for matrix in matrices:
                for i in range(opened.n):
                    if (i, j) in matrix:
                        found[i] = found.get(i, table.zero) - matrix[i, j] * moved
            moved = opened.scene.rate(moved)
    return dict(zip(found, copied(list(found.values()), symbolic.scene.table), strict=True))


def _driven(opened: "SystemWithInputs") -> "list[tuple[int, Opening]]":
    return [(j, opening) for j, opening in enumerate(opened.scene.inputs.values(), opened.n)
            if opening.node is not None]


def carried_into(opened: Any, values: Mapping[str, float]) -> int | None:
    """The number of a coordinate whose inertia, damping or stiffness changes with what is driven; None if none does.
    `values`: {name: float} of all symbols in equilibrium."""
    inputs = [j for j, _ in _driven(opened)]
    number = {q: i for i, q in enumerate(opened.scene.q)}
    sums, sizes = {}, {}
    for term in opened.scene.inertias:
        w, row, bend = _derivatives(term, number, {**opened.at_zero, **values})
        own = [i for i in row if i < opened.n]
        for i, j in product(own, {j for pair in bend for j in pair if j < opened.n} | set(own)):
            for u in inputs:
                parts = (bend.get((i, j), 0.0) * row.get(u, 0.0), row[i] * bend.get((j, u), 0.0),
                         bend.get((i, u), 0.0) * row.get(j, 0.0))
                for kind, shares in enumerate((parts[:2], parts[1:2], parts[1:])):
                    key = i, j, u, kind
                    sums[key] = sums.get(key, 0.0) + w * sum(shares)
                    sizes[key] = sizes.get(key, 0.0) + w * sum(map(abs, shares))
    return next((key[0] for key, total in sums.items() if abs(total) > SAME * sizes[key]), None)


def _derivatives(term: "Inertia", number: "Mapping[Node, int]",
                 values: Mapping[str, float]) -> tuple[float, dict[int, float], dict[tuple[int, int], float]]:
    """(w, {i: ∂s/∂qᵢ}, {(i, j): ∂²s/∂qᵢ∂qⱼ}) of an inertia in numbers."""
    slopes = row_of(term.s, number)
    seconds = slopes_of(slopes, number)
    w, *flat = evaluate([term.weight, *slopes.values(), *seconds.values()], Floats, values)
    return w, dict(zip(slopes, flat, strict=False)), dict(zip(seconds, flat[len(slopes):], strict=True))
