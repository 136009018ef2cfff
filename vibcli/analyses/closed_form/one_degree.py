"""One degree of freedom in letters: ω² = K/M, ζ = C/(2√(K M)), and the damper that makes ζ = 1. Without SymPy."""

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.closed_forms import ClosedForms, ClosedMode
from vibcli.analyses.closed_form.numeric_verification import confirmed, damping_confirmed, samples, squares
from vibcli.symbolic.common_denominator import fraction, single
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import ONE, ZERO

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node


def one_degree(symbolic: "SymbolicSystem", modal: "ModalAnalysis", M: "Node", C: "Node",
               K: "Node") -> ClosedForms | None:
    """The ClosedForms of a scene with one coordinate; None where they do not hold."""
    table, (M, C, K) = symbolic.scene.table, map(single, (M, C, K))
    candidates = [] if M.is_zero else samples(symbolic, modal)
    if not candidates:
        return None
    values = [candidate.numeric.floats for candidate in candidates]
    square = single(K / M)
    unstable = squares(candidates[0])[0] < 0
    mode = ClosedMode(square, root(-square if unstable else square, values), [table.one], unstable=unstable)
    if not confirmed([mode], (), candidates):
        return None
    if C.is_zero or K.is_zero or unstable:
        return ClosedForms([mode])
    damped = mode._replace(zeta=C / (2 * root(K, values) * root(M, values)), omega_d=damped_frequency(M, C, K, values))
    if not damping_confirmed([damped], candidates):
        return ClosedForms([damped._replace(zeta=None)])
    return ClosedForms([damped], critical=critical(symbolic.scene, M, C, K, values))


def damped_frequency(M: "Node", C: "Node", K: "Node", values: Sequence[dict[str, float]]) -> "Node":
    """√(K/M − C²/(4M²)), as one fraction or as √(4KM − C²)/(2M) with its parts as they are, whichever is shorter."""
    table, below = M.table, ((base, -e) for base, e in fraction(2 * M))
    flat = root(single(K / M - C * C / (4 * M * M)), values)
    front, rest = _difference(table, _parts(4 * K, M), _parts(C, C))
    return min((flat, table.product((root(front, values), ONE), (table.sqrt(rest), ONE), *below)), key=letters)


def _parts(*nodes: "Node") -> "tuple[Fraction, dict[Node, int]]":
    """(rational, {base: exponent}) of a product of nodes, the sums with whole coefficients."""
    scale, found = Fraction(1), {}
    for node in nodes:
        for base, e in fraction(node):
            if base.op == "number" and e == 1:
                scale *= base.coefficient
            else:
                found[base] = found.get(base, ZERO) + e
    return scale, found


def _difference(table: "Table", a: "tuple[Fraction, dict[Node, int]]",
                b: "tuple[Fraction, dict[Node, int]]") -> "tuple[Node, Node]":
    """(common factors, rest) of a − b, the rest with whole coefficients."""
    (x, left), (y, right) = a, b
    scale = Fraction(gcd(x.numerator, y.numerator), lcm(x.denominator, y.denominator))
    common = {base: min(left.get(base, ZERO), right.get(base, ZERO)) for base in {**left, **right}}
    rest = [table.product(*((base, parts.get(base, ZERO) - e) for base, e in common.items()))
            for parts in (left, right)]
    return (table.product((table.number(scale), ONE), *common.items()),
            table.sum((rest[0], x / scale), (rest[1], -y / scale)))


def critical(scene: "Scene", M: "Node", C: "Node", K: "Node",
             values: Sequence[dict[str, float]]) -> "tuple[Node, Node] | None":
    """(c, 2√(K M)/(C/c)) where all dampers have the coefficient c, else None."""
    weights = {term.weight for term in scene.dampers}
    if len(weights) != 1:
        return None
    letter, = weights
    shape = single(C / letter) if letter.op == "symbol" else letter
    if letter in reachable([shape]):
        return None
    return letter, 2 * root(K, values) * root(M, values) / shape
