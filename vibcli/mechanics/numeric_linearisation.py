"""A Linearisation in numbers of any arithmetic: element data, residual, and the sizes of what they were summed from."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.mechanics.linearisation import Linearisation, nodes_of
from vibcli.symbolic.evaluation import evaluate, evaluate_rational

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.symbolic.dual_numbers import Dual
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.running_errors import Rounded
    from vibcli.symbolic.watched_numbers import Watched

ALIKE, KEPT = 2.0**-46, 8       # forms whose expressions are remembered


class _Expressions:
    """The expressions of Linearisations, each once, and the element data that they make."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[Linearisation, tuple[Node, ...], FactoredSystem]] = {}    # by id, the oldest first

    def of(self, form: Linearisation) -> "tuple[Linearisation, tuple[Node, ...], FactoredSystem]":
        entry = self._known.get(id(form))
        if entry is None:
            elements = FactoredSystem(form.n, form.inertias, form.springs, form.dampers, form.M, form.C, form.G,
                                      drag=form.drag, pieces=form.pieces)
            entry = self._known[id(form)] = form, tuple(dict.fromkeys(nodes_of(form))), elements
            if len(self._known) > KEPT:
                self._known.pop(next(iter(self._known)))
        return entry


_EXPRESSIONS = _Expressions()


class Numbers(NamedTuple):
    """A Linearisation evaluated: the element data, the residual r, and the sizes of the terms r was added from."""

    elements: FactoredSystem
    residual: list[Any]
    residual_size: list[Any]


def in_numbers(form: Linearisation, arithmetic: Any, values: Mapping[str, Any],
               rational: "Mapping[str, Fraction] | None" = None) -> Numbers:
    """The Numbers of a Linearisation. `rational`: exact values of the symbols, for rows that are exactly rational."""
    _, nodes, expressions = _EXPRESSIONS.of(form)
    known = dict(zip(nodes, evaluate(nodes, arithmetic, values), strict=True))
    n, zero = form.n, arithmetic.number(form.table.zero.coefficient)
    K, size = {}, {}
    residual, residual_size = [zero] * n, [zero] * n
    for force, curvature, row in form.curved:
        f = known[force]
        for pair, second in curvature.items():
            _accumulate(K, size, pair, f * known[second])
        for i, slope in row.items():
            _gather(residual, residual_size, i, f * known[slope])
    for part in form.K:
        for pair, node in part.items():
            _accumulate(K, size, pair, known[node])
    for part in form.residual:
        for i, node in part.items():
            _gather(residual, residual_size, i, known[node])
    if arithmetic.ordered:
        _even_out(K, size)
    elements = expressions.each(known.__getitem__, K=K, K_size=size, massless=massless(form, known),
                                rational_rows=_rational_rows(form, rational))
    return Numbers(elements, residual, residual_size)


def _accumulate(K: "dict[tuple[int, int], Dual | float | Fraction | mpmath.mpf | Rounded]",
                size: "dict[tuple[int, int], Dual | float | Fraction | mpmath.mpf | Rounded]", pair: tuple[int, int],
                term: Any) -> None:
    if term:
        K[pair] = K.get(pair, 0) + term
        size[pair] = size.get(pair, 0) + abs(term)


def _even_out(K: "dict[tuple[int, int], float | Fraction | mpmath.mpf | Watched]",
              size: "Mapping[tuple[int, int], float | Fraction | mpmath.mpf | Watched]") -> None:
    """K of forces with a potential is symmetric: what differs by rounding alone is made equal."""
    for (i, j), one in list(K.items()):
        other = K.get((j, i), 0)
        if i < j and one != other and abs(one - other) <= ALIKE * max(size[i, j], size.get((j, i), 0)):
            K[i, j] = K[j, i] = (one + other) / 2


def _gather(residual: "list[Dual | float | Fraction | mpmath.mpf]",
            size: "list[Dual | float | Fraction | mpmath.mpf | Rounded]", i: int,
            term: "Dual | float | Fraction | mpmath.mpf | Rounded") -> None:
    residual[i] = residual[i] + term
    size[i] = size[i] + abs(term)


def massless(form: Linearisation, known: "Mapping[Node, Any]") -> list[int]:
    """Coordinates which no inertia moves: those in no row of T and in no entry of M but such as are exactly zero."""
    moving = {i for weight, row in form.inertias if known[weight] for i in row}
    moving |= {i for (i, _), node in form.M.items() if known[node]}
    moving |= {i for piece in form.pieces if known[piece.piece.inertia] for row in piece.rows for i in row}
    return [i for i in range(form.n) if i not in moving]


def _rational_rows(form: Linearisation,
                   rational: "Mapping[str, Fraction] | None") -> "list[dict[int, Fraction]] | None":
    if rational is None:
        return None
    nodes = [node for _, row in form.springs for node in row.values()]
    values = evaluate_rational(nodes, rational)
    if values is None:
        return None
    known = dict(zip(nodes, values, strict=True))
    return [{i: known[node] for i, node in row.items()} for _, row in form.springs]
