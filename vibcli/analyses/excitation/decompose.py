"""Expressions of the time as exact sums of functions of time."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.analyses.excitation.assembly import assembled
from vibcli.analyses.excitation.exponential_polynomials import TooManyTerms, added, constant, linear, multiplied, raised
from vibcli.analyses.excitation.functions_of_time import ORDERED, NotSaid, called
from vibcli.analyses.excitation.rounding import Floating, multiprecise
from vibcli.base.errors import PhysicsError
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:

    from vibcli.analyses.excitation.exponential_polynomials import Sum
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.base.work import Work
    from vibcli.notation.plain import Plain
    from vibcli.symbolic.node import Node

FULL = "`motion: full` integrates the equations as they are"
LARGEST = 60        # whole powers that are multiplied out


def forcing_of(nodes: "Mapping[int, Node]", time: "Node", values: Mapping[str, float], channels: int | None = None,
               precise: bool = False, write: "Callable[..., Any] | Plain" = repr,
               work: "Work | None" = None) -> "Forcing":
    """The Forcing of {channel: expression of the time}; `values`: {name: number} of all other symbols.

    `precise`: in mpmath numbers at the working precision, else in floats. `write` says an expression in a message;
    `work` counts.
    PhysicsError where an expression is no piecewise sum of polynomials times exponentials and sines.
    """
    numbers = multiprecise() if precise else Floating
    sums = dict(zip(nodes, sums_of(list(nodes.values()), time, values, numbers, write), strict=True))
    return assembled(sums, max(nodes, default=-1) + 1 if channels is None else channels, numbers, work)


def sums_of(nodes: "Sequence[Node]", time: "Node", values: Mapping[str, Any], numbers: type[Any],
            write: "Callable[..., Any] | Plain" = repr) -> "list[Sum]":
    """Expressions of the time as Sums."""
    below = reachable(nodes)
    known = _constants(below, nodes, time, values, numbers)
    found = {}
    for node in below:
        if node is time:
            found[node] = linear(Fraction(0), Fraction(1))
        elif node in known:
            found[node] = constant(known[node])
        elif node.mask & time.mask:
            try:
                found[node] = _sum_of(node, found, numbers)
            except NotSaid as error:
                raise PhysicsError(f"the response to {write(node)} is not known in closed form: {error}",
                                   FULL) from None
            except TooManyTerms:
                raise PhysicsError(f"{write(node)} has too many terms, or too high powers of t, for a response in "
                                   "closed form", FULL) from None
    return [found[node] for node in nodes]


def _constants(below: "Sequence[Node]", nodes: "Sequence[Node]", time: "Node", values: Mapping[str, Any],
               numbers: type[Any]) -> "dict[Node, Fraction]":
    """{node: its exact value} of what stands beside the time and does not depend on it."""
    fixed = [node for node in below if not node.mask & time.mask]
    beside = {arg for node in below if node.mask & time.mask for arg in _parts(node)} | set(nodes)
    wanted = [node for node in fixed if node in beside]
    found = {}
    for node, value in zip(wanted, evaluate(wanted, numbers.arithmetic, values), strict=True):
        exact = node.coefficient if node.op == "number" else numbers.pi if node.op == "pi" else numbers.exact(value)
        if exact is None:
            raise PhysicsError("what drives this scene is not a finite number",
                               "look for a division by zero, or a root or logarithm of a negative number")
        found[node] = Fraction(exact)
    return found


def _parts(node: "Node") -> "Sequence[Node]":
    return [arg for arg, _ in node.args] if node.op in ("sum", "product") else node.args


def _sum_of(node: "Node", found: "Mapping[Node, Sum]", numbers: type[Any]) -> "Sum":
    if node.op == "sum":
        return added((constant(Fraction(node.coefficient)), 1), *((found[part], c) for part, c in node.args))
    if node.op == "product":
        total = constant(Fraction(node.coefficient))
        for base, exponent in node.args:
            total = multiplied(total, _power(found[base], exponent, numbers))
        return total
    if node.name == "power":
        raise NotSaid("a power is a whole number")
    args, order, record = node.args, 0, node.table.records.get(node.name)
    if (record is not None or node.name in ORDERED) and len(args) > 1:
        args, order = args[:1], args[1].coefficient
    return called(node.name, [found[arg] for arg in args], order, numbers, record)


def _power(base: "Sum", exponent: Fraction, numbers: type[Any]) -> "Sum":
    """A whole power; any power of one exponential, c·e^{r t + r₀}."""
    if exponent.denominator == 1 and 0 < exponent <= LARGEST:
        return raised(base, exponent.numerator)
    if len(base) == 1:
        ((T, gates, (r, w, r0, w0, _)), p), = base.items()
        if T is None and not gates and len(p) == 1 and not (w or w0):
            size = numbers.exact(numbers.arithmetic.power(numbers.number(p[0]), exponent))
            if size is not None:
                return {(None, (), (r * exponent, 0, r0 * exponent, 0, 0)): (size,)}
    raise NotSaid("the time stands in a denominator, under a root or in too high a power")
