"""Forces in letters by few lengths: where ℓ₂² = c·(ℓ₁² + d), as of a rope to a pulley of radius r with c = 1, d = r²,
ℓ₂ is told by ℓ₁, and what is then over one denominator is cancelled."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.notation.abbreviations import abbreviated
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def in_few_lengths(nodes: "Sequence[Node]", known: "dict[Node, Node]"
                   ) -> "tuple[list[Node], list[tuple[Node, Node]]]":
    """(nodes with long roots replaced, [(symbol, root)] of those that are new), as `abbreviated`."""
    shown, lengths = abbreviated(nodes, known)
    squares = {symbol: base for base, symbol in known.items() if nodes and base.table is nodes[0].table}
    odd = {base for part in reachable(shown) if part.op == "product" for base, e in part.args if e.numerator % 2}
    odd |= {base for part in reachable(shown) if part.op != "product" for base in part.parts}
    told = {}
    for symbol in (symbol for symbol in squares if symbol not in odd):
        others = (_by(squares[symbol], squares[one], one) for one in squares if one in odd)
        square = next(filter(None, others), None)
        if square is not None:
            told[symbol] = square.table.sqrt(square)
    shown = [min((node, single(substitute([node], told)[0])), key=letters) for node in shown] if told else shown
    used = set(reachable(shown))
    for base, symbol in list(known.items()):
        if symbol in dict(lengths) and symbol not in used:
            del known[base]
    return shown, [(symbol, root) for symbol, root in lengths if symbol in used]


def _by(square: "Node", other: "Node", length: "Node") -> "Node | None":
    """c·(ℓ² + d) of a square that is c times another one and more, c and d of letters alone; None of others."""
    bend, like = (_bend(node, _variable(other)) for node in (square, other))
    if bend.is_zero or like.is_zero:
        return None
    c = textbook(bend / like)
    d = textbook(square - c * other)
    return None if c.mask or d.mask else c * (length * length + textbook(d / c))


def _variable(node: "Node") -> "Node":
    """A coordinate that a square depends on."""
    return next(part for part in reachable([node]) if part.op == "symbol" and part.mask)


def _bend(node: "Node", q: "Node") -> "Node":
    """∂²/∂q² of a node."""
    zero = node.table.zero
    return gradient(gradient(node).get(q, zero)).get(q, zero)
