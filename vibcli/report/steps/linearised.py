"""The steps from the full equations of motion to those of small oscillations: each to the first order in the deviations
from rest."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.held import SmallEquations, drive_of, held, left
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.symbolic.node import Node


def linearised(about: AboutRest, sheet: WorkedSolution, full: "Sequence[Node]", lines: "Sequence[int]"
               ) -> SmallEquations:
    """Write down the equations to the first order; `full`: left sides of the equations of motion. Untold where their
    slopes are not the engine's."""
    scene = about.scene
    M, X, K = (_slopes(about, full, symbols) for symbols in (scene.a, scene.v, scene.q))
    C, G = _parts_by_speeds(about, X)
    M, C, G, K = matrices = held(about, sheet, M, C, K, G)
    drive = drive_of(about.problem)
    rows = [left(scene, matrices, i) for i in range(len(scene.q))]
    kept = [textbook(node - one + drive.get(i, scene.table.zero)) for i, (node, one) in enumerate(zip(
        full, rows, strict=True))]
    if all(map(is_zero, kept)):
        return SmallEquations(M, C, G, K, drive, list(lines))
    told = []
    for i, name in enumerate(scene.coordinates):
        head = [Name(name), Words(":  ")] if len(rows) > 1 else []
        told.append(sheet.write(Words("from rest, to the first order:  "), *head, rows[i], " = ",
                                drive.get(i, scene.table.zero), settles=f"equation[{name}]", node=rows[i], uses=lines))
    return SmallEquations(M, C, G, K, drive, told)


def _slopes(about: AboutRest, full: "Sequence[Node]", symbols: "Sequence[Node]") -> "dict[tuple[int, int], Node]":
    """{(i, j): ∂Eᵢ/∂xⱼ} at rest."""
    zero = about.table.zero
    found = {(i, j): about.rest(gradient(node).get(x, zero)) for i, node in enumerate(full)
             for j, x in enumerate(symbols)}
    return {pair: node for pair, node in found.items() if not node.is_zero}


def _parts_by_speeds(about: AboutRest, X: dict[Any, Any]) -> tuple[dict[Any, Any], dict[Any, Any]]:
    """(C, G) of what is linear in speeds: G of the engine where it is known in letters, else what is skew."""
    symbolic, zero = about.problem.symbolic, about.table.zero
    if not symbolic.linearisable or not proportional(about.problem.spec):
        return _half(about, X, 1), _half(about, X, -1)
    G = symbolic.matrices[2]
    C = {pair: about.tidy(X.get(pair, zero) - G.get(pair, zero)) for pair in {*X, *G}}
    return {pair: node for pair, node in C.items() if not node.is_zero}, G


def _half(about: AboutRest, X: Mapping[Any, Any], sign: int) -> dict[Any, Any]:
    """(X ± Xᵀ)/2."""
    zero = about.table.zero
    found = {(i, j): about.tidy((X.get((i, j), zero) + sign * X.get((j, i), zero)) / 2)
             for i, j in {*X, *((j, i) for i, j in X)}}
    return {pair: node for pair, node in found.items() if not node.is_zero}
