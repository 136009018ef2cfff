"""Square roots taken factor by factor."""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.symbolic.common_denominator import fraction
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import rooted_square
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.symbolic.node import Monomial, Node

CIRCULAR = ("sin", "cos", "tan")
ANGLES = (0.9, 2.3, 4.1, 5.6)       # one in each quadrant


def root(node: "Node", samples: "Sequence[Mapping[str, float]]" = ()) -> "Node":
    """√node of a quotient whose value is positive. A perfect square gives its root: with the sign that makes it
    positive at all `samples` ({letter: float}), else between bars."""
    table = node.table
    if node.is_zero:
        return node
    scale, factors = _factors(fraction(node))
    if scale < 0:
        turned = next((i for i, (base, e) in enumerate(factors) if base.op == "sum" and e.numerator % 2), None)
        if turned is None:
            return table.sqrt(node)
        base, e = factors[turned]
        factors[turned], scale = (table.sum((base, -ONE)), e), -scale
    roots = ((positive(base, samples) if e.denominator == 1 and e % 4 == 2 else base, e * HALF) for base, e in factors)
    return table.product((table.sqrt(table.number(scale)), ONE), *roots)


def _factors(factors: "Monomial") -> "tuple[Fraction, list[tuple[Node, Fraction | int]]]":
    """The rational, and the other factors, each once."""
    scale = Fraction(1)
    found: dict[Node, Fraction | int] = {}
    for base, e in factors:
        if base.op == "number" and e.denominator == 1:
            scale *= Fraction(base.coefficient) ** int(e)
        else:
            found[base] = found.get(base, 0) + e
    return scale, list(found.items())


def without_bars(node: "Node", samples: "Sequence[Mapping[str, float]]") -> "Node":
    """An expression of parameters with ±a for |a| and √a² where that has one sign at all samples."""
    known, table = {}, node.table
    for part in reachable([node]):
        if part.op == "product":
            factors = [rooted_square(*pair) for pair in part.args]
            if factors != list(part.args):
                known[part] = table.product((table.number(part.coefficient), ONE), *factors)
    node, = substitute([node], known) if known else [node]
    bars = [part for part in reachable([node]) if part.op == "call" and part.name == "abs" and not part.mask]
    return substitute([node], {part: positive(part.args[0], samples) for part in bars})[0] if bars else node


def positive(base: "Node", samples: "Sequence[Mapping[str, float]]") -> "Node":
    """±base, or |base| where its sign is not the same at all samples, at all angles that letters of it may be, and for
    negative letters of any sign."""
    table = base.table
    if table.is_positive(base):
        return base
    more = *_at_other_angles(base, samples), *_with_other_signs(base, samples)
    values = [evaluate([base], Floats, sample)[0] for sample in (*samples, *more)]
    if values and all(value > 0 for value in values):
        return base
    return -base if values and all(value < 0 for value in values) else table.call("abs", base)


def _at_other_angles(base: "Node", samples: "Sequence[Mapping[str, float]]") -> list[dict[str, float]]:
    """The first sample with its free letters within sines and cosines at angles around a turn: at rest they may be
    drawn at any of them."""
    waves = [part for part in reachable([base]) if part.op == "call" and part.name in CIRCULAR]
    names = {part.name for wave in waves for part in reachable([wave]) if part.op == "symbol"}
    free = _free(names, samples)
    return [{**samples[0], **dict.fromkeys(free, angle)} for angle in ANGLES] if free else []


def _with_other_signs(base: "Node", samples: "Sequence[Mapping[str, float]]") -> list[dict[str, float]]:
    """The samples with each of its free letters that may be negative turned."""
    unsigned = {part.name for part in reachable([base]) if part.op == "symbol" and not base.table.is_positive(part)}
    return [{**sample, name: -sample[name]} for name in _free(unsigned, samples) for sample in samples]


def _free(names: set[str], samples: "Sequence[Mapping[str, float]]") -> list[str]:
    """Those that are not the same at all samples: letters without a value."""
    return [name for name in names if len({sample.get(name) for sample in samples}) > 1]
