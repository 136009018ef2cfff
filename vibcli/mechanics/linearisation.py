"""The Linearisation of a scene: rows ∇s and weights as expressions, anywhere or in one position."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.factored_system import PlacedPiece
from vibcli.symbolic.derivatives import substitute

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

    Row = dict[int, Node]
    Matrix = dict[tuple[int, int], Node]

Key = TypeVar("Key")      # of an entry: i, or (i, j)


class Linearisation(NamedTuple):
    """The expressions of all rows and weights, in the coordinates or with the drawn position substituted.

    inertias, springs, dampers: [(weight, {i: ∂s/∂qᵢ})]; curved: [(force, {(i, j): ∂²s/∂qᵢ∂qⱼ}, {i: ∂s/∂qᵢ})], the force
    being that along s; M, C, G, K: {(i, j): expression}, K as a list of terms; residual: {i: [expressions]}; pieces:
    those of members, PlacedPieces in expressions.
    """

    n: int
    table: Any
    inertias: "list[tuple[Node, Row]]"
    springs: "list[tuple[Node, Row]]"
    dampers: "list[tuple[Node, Row]]"
    curved: "list[tuple[Node, Matrix, Row]]"
    M: "Matrix"
    C: "Matrix"
    G: "Matrix"
    drag: "Matrix"
    K: "list[Matrix]"
    residual: "list[Row]"
    pieces: list[PlacedPiece]


def at_position(form: Linearisation, values: "Mapping[Node, Node]") -> Linearisation:
    """The Linearisation with coordinates replaced, {symbol: node}; what vanishes there is left out.

    In letters, so that what is zero by structure is exactly zero.
    """
    nodes = nodes_of(form)
    moved = dict(zip(nodes, substitute(nodes, values), strict=True))
    return each(form, moved.__getitem__)


def each(form: Linearisation, change: "Callable[..., Node]") -> Linearisation:
    """A Linearisation with `change` applied to every expression in a fixed order."""
    def entries(mapping: "Mapping[Key, Node]") -> "dict[Key, Node]":
        return {key: node for key, old in mapping.items() if not (node := change(old)).is_zero} if mapping else {}

    def rows(terms: "Sequence[tuple[Node, Row]]") -> "list[tuple[Node, Row]]":
        return [(change(weight), entries(row)) for weight, row in terms]

    return Linearisation(
        form.n, form.table, rows(form.inertias), rows(form.springs), rows(form.dampers),
        [(change(force), entries(curvature), entries(row)) for force, curvature, row in form.curved],
        entries(form.M), entries(form.C), entries(form.G), entries(form.drag), list(map(entries, form.K)),
        list(map(entries, form.residual)),
        [PlacedPiece(piece.owner, change(piece.start), piece.piece._make(map(change, piece.piece)),
                     tuple(map(entries, piece.rows)), rows(piece.springs)) for piece in form.pieces])


def joined(form: Linearisation, more: Linearisation) -> Linearisation:
    """The sum of what forces without inertia, damping and stiffness of their own add and of the rest, on as many
    coordinates as these have."""
    return form._replace(n=more.n, curved=form.curved + more.curved, K=form.K + more.K,
                         residual=form.residual + more.residual)


def residual_terms(form: Linearisation) -> "list[list[Node]]":
    """The terms of each condition of equilibrium r = 0: a list of expressions for each coordinate."""
    found = [[] for _ in range(form.n)]
    for force, _, row in form.curved:
        for i, slope in row.items():
            found[i].append(force * slope)
    for part in form.residual:
        for i, node in part.items():
            found[i].append(node)
    return found


def hangs_on(form: Linearisation, variable: "Node") -> bool:
    """Is a variable in what M, C, G and K are made of? Forces without curvature are in the residual alone."""
    curved = [(force, curvature, row) for force, curvature, row in form.curved if curvature]
    return any(node.mask & variable.mask for node in nodes_of(form._replace(curved=curved, residual=[])))


def nodes_of(form: Linearisation) -> "list[Node]":
    """Every expression of a Linearisation."""
    nodes = []
    each(form, lambda node: nodes.append(node) or node)  # type: ignore[func-returns-value]
    return nodes
