"""Functions of two variables as sums of products f(x)·g(t): sin(kx − Ωt) is sin kx cos Ωt − cos kx sin Ωt."""

from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import TooLong, collected, expanded

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def products_of(node: "Node", x: "Node", time: "Node") -> "list[tuple[Node, Node]] | None":
    """[(f, g)] of an expression, no two f in proportion, nor g; None where a part of it is no such product, as
    step(x − t)."""
    table, found = node.table, {}
    try:
        for monomial, value in expanded(_opened(node, x, time)).items():
            if any(atom.mask & x.mask and atom.mask & time.mask for atom, _ in monomial):
                return None
            moving = table.product(*(pair for pair in monomial if pair[0].mask & time.mask))
            along = table.product(*(pair for pair in monomial if not pair[0].mask & time.mask))
            found.setdefault(moving, {})[along] = value
    except (TooLong, ZeroDivisionError):
        return None
    forms: dict[frozenset[tuple[Node, Fraction]], list[tuple[Fraction, Node]]] = {}
    for moving, parts in found.items():
        size = next(iter(parts.values()))
        forms.setdefault(frozenset((along, value / size) for along, value in parts.items()), []).append((size, moving))
    return [(table.total([table.scaled(along, value * alike[0][0]) for along, value in form]),
             table.total([table.scaled(moving, size / alike[0][0]) for size, moving in alike]))
            for form, alike in forms.items()]


def _opened(node: "Node", x: "Node", time: "Node") -> "Node":
    """With sines, cosines and exponentials of sums of both as products."""
    known: dict[Node, Node] = {}
    for part in reachable([node]):
        if part.op == "call" and part.name in ("sin", "cos", "exp") and part.mask & x.mask and part.mask & time.mask:
            known[part] = _product(part, x, time)
    return substitute([node], known)[0] if known else node


def _product(part: "Node", x: "Node", time: "Node") -> "Node":
    table, terms = part.table, expanded(part.args[0])
    of_x = {monomial: value for monomial, value in terms.items() if any(atom.mask & x.mask for atom, _ in monomial)}
    along = collected(table, of_x)
    moving = collected(table, {monomial: value for monomial, value in terms.items() if monomial not in of_x})
    if along.mask & time.mask:
        return part
    (s, c), (p, q) = ((table.call("sin", node), table.call("cos", node)) for node in (along, moving))
    if part.name == "exp":
        return table.call("exp", along) * table.call("exp", moving)
    return s * q + c * p if part.name == "sin" else c * q - s * p
