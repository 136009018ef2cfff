"""Matrices given outright of coordinates that constraints tie: M, K and what is symmetric in C as the energies ½ q̇ᵀM q̇,
½ qᵀK q and ½ q̇ᵀC q̇, in which the dependent coordinates are replaced as in all others; what is skew in C as SᵀC S, where
q = S x of the independent coordinates x."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def with_energies(scene: "Scene") -> "Scene":
    """The Scene with its matrices as energies, but for what is skew in C; so is that at rest."""
    found, C = dict(scene.energies), scene.matrices.get("C", ())
    for key, matrix, symbols in (("T", "M", scene.v), ("V", "K", scene.q), ("Phi", "C", scene.v)):
        rows = scene.matrices.get(matrix, ())
        found[key] = scene.table.total([found[key], *(
            rows[i][j] * symbols[i] * symbols[j] / 2 for i in range(len(rows)) for j in range(len(rows)))])
    skew = [[(C[i][j] - C[j][i]) * HALF for j in range(len(C))] for i in range(len(C))]
    turning = any(not x.is_zero for row in skew for x in row)
    return scene.with_parts(still=scene.still and with_energies(scene.still), contents=scene.contents._replace(
        energies=found, matrices={"C": skew} if turning else {}))


def of_independent(scene: "Scene", values: "Mapping[Node, Node]", left: "Sequence[Node]"
                   ) -> "dict[str, list[list[Node]]]":
    """SᵀC S of the independent coordinates `left`, `values` being {z: expression} of the others. Reported where the
    constraints are not linear."""
    C, zero = scene.matrices["C"], scene.table.zero
    slopes = [gradient(values.get(q, q)) for q in scene.q[:len(C)]]
    if any(slope.mask or x not in left for row in slopes for x, slope in row.items()):
        scene.report(scene.constraints[0].where, "the skew part of a C that is given outright needs constraints that "
                     "are linear in the coordinates, and hold no time",
                     "write C of the coordinates that are left, or leave it out")
        return {}
    S = [[row.get(x, zero) for x in left] for row in slopes]
    return {"C": [[scene.table.total([S[i][a] * C[i][j] * S[j][b] for i in range(len(C)) for j in range(len(C))])
                   for b in range(len(left))] for a in range(len(left))]}
