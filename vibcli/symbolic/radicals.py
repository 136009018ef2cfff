"""Square roots taken factor by factor."""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.symbolic.common_denominator import fraction
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def root(node: "Node", samples: Sequence[dict[str, float]] = ()) -> "Node":
    """√node of a quotient whose value is positive. A perfect square gives its root: with the sign that makes it
    positive at all `samples` ({letter: float}), else between bars."""
    table = node.table
    if node.is_zero:
        return node
    scale, *factors = _factors(fraction(node))
    if scale < 0:
        turned = next((i for i, (base, e) in enumerate(factors) if base.op == "sum" and e.numerator % 2), None)
        if turned is None:
            return table.sqrt(node)
        base, e = factors[turned]
        factors[turned], scale = (table.sum((base, -ONE)), e), -scale
    roots = ((positive(base, samples) if e.denominator == 1 and e % 2 == 0 else base, e * HALF) for base, e in factors)
    return table.product((table.sqrt(table.number(scale)), ONE), *roots)


def _factors(factors):
    """The rational, and the other factors, each once."""
    scale, found = Fraction(1), {}
    for base, e in factors:
        if base.op == "number" and e.denominator == 1:
            scale *= Fraction(base.coefficient) ** int(e)
        else:
            found[base] = found.get(base, 0) + e
    return scale, *found.items()


def positive(base: "Node", samples: Sequence[dict[str, float]]) -> "Node":
    """±base, or |base| where its sign is not the same at all samples."""
    table = base.table
    if table.is_positive(base):
        return base
    values = [evaluate([base], Floats, sample)[0] for sample in samples]
    if values and all(value > 0 for value in values):
        return base
    return -base if values and all(value < 0 for value in values) else table.call("abs", base)
