"""|H| of one degree of freedom by r = Ω/ω and ζ: a gain times what only these make of it.

    |1/(k − mΩ² + icΩ)| = (1/k)·1/√((1 − r²)² + (2ζr)²)        ω² = k/m,  ζ = c/(2√(km))
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.radicals import root

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.frequency_response import Formula
    from vibcli.symbolic.node import Node


class Dimensionless(NamedTuple):
    """gain: what stands before; above: "1", "r²" or "√(1 + (2ζr)²)" over the root; ω and ζ, None without damping."""

    gain: Any
    above: str
    omega: Any
    zeta: Any


CONSTANT, SQUARE, BASE = "1", "r²", "√(1 + (2ζr)²)"


def dimensionless(formula: "Formula") -> Dimensionless | None:
    """That of a Formula of one degree; None of others, and of outputs of which it is no such product."""
    Omega, (real, c), (above, beside) = formula.Omega, formula.denominator, formula.numerator
    if not formula.short or formula.order or formula.vanishes or Omega.op != "symbol" or formula.ahead:
        return None
    zero = formula.table.zero
    k, = substitute([textbook(real)], {Omega: zero})
    m = _simple((k - real) / Omega**2)
    if k.is_zero or m.is_zero or _holds(Omega, m, c, k) or not (_positive(m) and _positive(k)):
        return None
    gain = formula.scale * above
    if not beside.is_zero:
        if c.is_zero or _holds(Omega, gain, beside) or not is_zero(beside * k - above * c):
            return None
        found = gain / k, BASE
    elif not _holds(Omega, gain):
        found = gain / k, CONSTANT
    elif not _holds(Omega, textbook(gain / Omega**2)):
        found = textbook(gain / Omega**2) / m, SQUARE
    else:
        return None
    samples = [formula.table.sample]
    zeta = None if c.is_zero else _simple(c / (2 * root(_simple(k * m), samples)))
    return Dimensionless(_simple(found[0]), found[1], root(_simple(k / m), samples), zeta)


def _simple(node: "Node") -> "Node":
    return shorter(textbook(node))


def _holds(Omega: "Node", *nodes: "Node") -> bool:
    return Omega in reachable(nodes)


def _positive(node: "Node") -> bool:
    return node.table.is_positive(node)
