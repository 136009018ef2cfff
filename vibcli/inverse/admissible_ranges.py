"""Where a chosen parameter is looked for: its admissible range, and a grid over it about the natural scale."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.reader import Expression
from vibcli.quantities.expression import lowered
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.semantics import literal_unit

if TYPE_CHECKING:
    from collections.abc import Mapping
    from fractions import Fraction

    import mpmath

    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

DECADES, DENSE, FINE, COARSE, EVEN = 9, 3, 6, 2, 48
TURNING = ("sin", "cos", "tan")


class Range(NamedTuple):
    """The admissible values low < x < high of a parameter; an end that the scene gives is admissible itself."""

    low: float
    high: float
    low_given: bool
    high_given: bool
    scale: float

    def holds(self, x: "float | Fraction") -> bool:
        above = x >= self.low if self.low_given else x > self.low
        return above and (x <= self.high if self.high_given else x < self.high)

    @property
    def closed(self) -> tuple[bool, bool]:
        return self.low_given, self.high_given


def admissible(problem: "Problem", name: str) -> Range:
    """The Range of a chosen parameter: between its bounds, of one sign where it is positive; angles within a turn."""
    return Range(*ends(problem, name, turns(problem, name)), natural_scale(problem.spec, name))


def ends(problem: "Problem", name: str, turning: bool) -> tuple[float, float, bool, bool]:
    """(low, high, whether the scene gives each) of a Range; `turning`: is it an angle?"""
    record, parameter = problem.spec.choices[name], problem.spec.parameters[name]
    low, high = -math.inf if parameter.get("sign") == "any" else 0.0, math.inf
    if turning:
        low, high = (0.0, math.tau) if low == 0.0 else (-math.pi, math.pi)
    bounds = [_bound(problem, record[key]) if key in record else None for key in ("from", "to")]
    if bounds[0] is not None and (bounds[0] > low or low):
        low = bounds[0]
    if bounds[1] is not None:
        high = bounds[1]
    if not low < high:
        unit = units.text(problem.spec.dimensions.of(name))
        raise PhysicsError(f"no value of {name} lies from {low:.6g} to {high:.6g} {unit}".rstrip(),
                           "mind the signs and the order: from the least to the largest value", record.where)
    return low, high, bounds[0] is not None and low == bounds[0], bounds[1] is not None


def _bound(problem: "Problem", expression: Expression) -> float:
    scene = problem.scene
    node = lowered(expression, scene.table, lambda name, primes, part: scene.parameters.nodes[name])
    try:
        return float(evaluate([node], Floats, known(problem, Floats))[0])
    except KeyError:
        raise PhysicsError("this bound has no value", "write a number, or parameters that have one",
                           expression.where) from None


def known(problem: "Problem", arithmetic: Any) -> "dict[str, float | mpmath.mpf]":
    """The parameters of a problem that have a value, in an arithmetic."""
    given = {name: arithmetic.number(value) for name, value in problem.numeric.given.items()}
    values: dict[str, Any] = problem.scene.parameters.values(arithmetic, given)
    return values


def turns(problem: "Problem", name: str) -> bool:
    """Is a parameter without dimension an angle, the argument of a sine, cosine or tangent?"""
    if problem.spec.dimensions.of(name):
        return False
    node = problem.scene.parameters.nodes[name]
    calls = [part for part in reachable(geometry(problem.scene)) if part.op == "call" and part.name in TURNING]
    return any(node in reachable([call]) for call in calls)


def geometry(scene: "Scene") -> "list[Node]":
    """The expressions that say where everything is, moves and pulls."""
    terms = (*scene.inertias, *scene.springs, *scene.dampers, *scene.weights, *scene.forces)
    return [*(node for term in terms for node in term.nodes), *scene.drawn.values(), *scene.energies.values()]


def natural_scale(spec: "Spec", name: str) -> float:
    """A value of the size that the other values of the file suggest: M^a L^b T^c with the mass, length and time that
    fit them best, in logarithms."""
    import numpy as np

    wanted = spec.dimensions.of(name)
    bases = ("kg", "m", "s")
    rows, logs, plain = [], [], []
    for value, dimension in _values(spec):
        plain.append(math.log(value))
        if dimension:
            rows.append([float(dimension.get(base, 0)) for base in bases])
            logs.append(math.log(value))
    if not wanted and not spec.free_numbers:
        return 1.0
    if not rows or any(base not in bases for base in wanted):
        return math.exp(sum(plain) / len(plain)) if plain else 1.0
    sizes = np.linalg.lstsq(np.array(rows), np.array(logs), rcond=1e-9)[0]
    exponent = sum(float(wanted.get(base, 0)) * size for base, size in zip(bases, sizes, strict=True))
    return math.exp(max(-100.0, min(100.0, exponent)))


def _values(spec: "Spec") -> "Iterator[tuple[float, Mapping[str, Fraction | int]]]":
    """(size, dimension) of every number of the scene that is not zero."""
    for expression in _expressions([value for key, value in spec.sections.items() if key != "answers"]):
        for literal in expression.parts.numbers:
            unit = literal_unit(literal.units)
            if literal.value and (literal.units or spec.free_numbers):
                yield unit.in_si(abs(literal.value)), unit.dimension


def _expressions(whole: list[Any]) -> Iterator[Expression]:
    """Every expression below records, lists and mappings; the sides of conditions too."""
    pending = [whole]
    while pending:
        part = pending.pop()
        if isinstance(part, Expression):
            yield part
        elif isinstance(part, dict):
            pending.extend(part.values())
        elif isinstance(part, (list, tuple)):
            pending.extend(part)
        elif hasattr(part, "sides"):
            pending.extend(part.sides)


def grid(span: Range) -> list[float]:
    """Ascending points over a Range: by ratio about the natural scale, and evenly where both ends are known."""
    points = set()
    for sign in (-1, 1):
        points |= {sign * x for x in _ratios(span.scale) if span.holds(sign * x)}
    if math.isfinite(span.low) and math.isfinite(span.high):
        width = span.high - span.low
        points |= {span.low + width * i / EVEN for i in range(1, EVEN)}
        inner = 1e-6 * width
        points.add(span.low + inner * (not span.low_given))
        points.add(span.high - inner * (not span.high_given))
        if span.low > 0:
            ratio = span.high / span.low
            points |= {span.low * ratio ** (i / EVEN) for i in range(1, EVEN)}
    points |= {end for end, given in ((span.low, span.low_given), (span.high, span.high_given)) if given}
    if span.low < 0 < span.high:
        points.add(0.0)
    return sorted(points)


def _ratios(scale: float) -> list[float]:
    """Powers of ten about the scale, closer together within DENSE decades of it."""
    outer = range(DENSE * COARSE + 1, DECADES * COARSE + 1)
    exponents = {i / FINE for i in range(-DENSE * FINE, DENSE * FINE + 1)}
    exponents |= {sign * i / COARSE for i in outer for sign in (-1, 1)}
    return [scale * 10.0**e for e in exponents]
