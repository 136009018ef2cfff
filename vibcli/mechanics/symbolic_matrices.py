"""M, C, G and K of small oscillations as expressions."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node


def matrices_in_letters(form: Any) -> Any:
    """M, C, G, K of a Linearisation as {(i, j): simplified expression}, zeros left out."""
    M = _assembled(form.table, form.inertias, [form.M])
    C = _assembled(form.table, form.dampers, [form.C, form.drag])
    G = _simplified({pair: [node] for pair, node in form.G.items()}, form.table)
    return M, C, G, _stiffness(form, form.springs)


def stiffness_at_rest(form: Any) -> Any:
    """K as such expressions with the springs that pieces of members are at rest."""
    return _stiffness(form, [*form.springs, *(spring for piece in form.pieces for spring in piece.springs)])


def _stiffness(form: "Linearisation", springs: "list[tuple[Node, dict[int, Node]]]") -> "dict[tuple[int, int], Node]":
    geometric = [{pair: force * second for pair, second in curvature.items()} for force, curvature, _ in form.curved]
    return _assembled(form.table, springs, geometric + form.K)


def _assembled(table: "Table", terms: "Sequence[tuple[Node, dict[int, Node]]]",
               parts: "Sequence[dict[tuple[int, int], Node]]") -> "dict[tuple[int, int], Node]":
    """Σ weight·rowᵢ·rowⱼ + parts."""
    found = {}
    for weight, row in terms:
        for i, x in row.items():
            for j, y in row.items():
                found.setdefault((i, j), []).append(weight * x * y)
    for part in parts:
        for pair, node in part.items():
            found.setdefault(pair, []).append(node)
    return _simplified(found, table)


def _simplified(found: "Mapping[tuple[int, int], list[Node]]", table: "Table") -> "dict[tuple[int, int], Node]":
    entries = {pair: textbook(table.total(nodes)) for pair, nodes in found.items()}
    return {pair: node for pair, node in entries.items() if not node.is_zero}
