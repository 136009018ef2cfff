"""Where a solution in letters counts: the values of the letters at which it is real and within its range, and the
conditions for that.

Values are spread about the natural scale of the other numbers of the file, less and more far; a condition that holds at
all of them is not told.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import isfinite, pi
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.inverse.admissible_ranges import ends, known, natural_scale, turns
from vibcli.language.parameter_samples import sample_values, short_fraction
from vibcli.quantities.expression import lowered
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

MANY, SPREADS, DIGITS = 400, (0.0, 0.5, 1.5, 3.0), 6


class Bound(NamedTuple):
    """A radicand `node`, or the parameter `name`, stands in a relation to a bound; a name alone has to be real, and
    words alone have to be true."""

    node: Any = None
    name: str = None
    relation: str = ""
    bound: Any = None
    words: str = None


class Letters:
    """Values for the letters of a problem, and what solutions {name: node} are there; `rest`: the problem in whose
    letters they are written."""

    def __init__(self, problem: "Problem", rest: "Problem", solutions: "Sequence[dict[str, Node]]") -> None:
        self.problem, self.rest, self.solutions = problem, rest, solutions
        self.turning = {name: turns(problem, name) for name in problem.spec.choices}
        self.scales = {name: natural_scale(problem.spec, name) for name in problem.symbolic.letters}
        self.zero = rest.scene.table.zero
        self.told = [{} for _ in solutions]
        self.radicands = [_radicands(rest.scene.table, forms) for forms in solutions]

    def __iter__(self) -> Iterator[tuple[dict[str, Fraction], list[int]]]:
        """({letter: Fraction}, numbers of the solutions that are real and admissible there)."""
        for attempt in range(MANY):
            given = self.values(attempt)
            yield given, [i for i in range(len(self.solutions)) if self._counts(i, given)]

    def values(self, attempt: int) -> dict[str, Fraction]:
        """Positive values for the letters, others at each attempt: as they are for drawings, or about their scales."""
        spread, plain = SPREADS[attempt % len(SPREADS)], sample_values(self.problem.symbolic.letters, attempt)
        if not spread:
            return {name: short_fraction(value) for name, value in plain.items()}
        powers = {name: spread * (2 * (value - 0.6) / 1.7 - 1) for name, value in plain.items()}
        return {name: Fraction(f"{self.scales[name] * 10**power:.{DIGITS}g}") for name, power in powers.items()}

    def _counts(self, i: int, given: Mapping[str, Fraction]) -> bool:
        """Is a solution real and admissible? Conditions that fail are noted, those of its range where it is real."""
        problem, forms = self.problem.sharing(given), self.solutions[i]
        try:
            values = known(problem, Floats)
            radicands = evaluate(self.radicands[i], Floats, values)
            numbers = dict(zip(forms, evaluate(list(forms.values()), Floats, values), strict=True))
        except (SpecError, KeyError, ArithmeticError, ValueError):
            return False
        under = zip(self.radicands[i], radicands, strict=True)
        failed = {Bound(node, None, "≥", self.zero) for node, value in under if not value >= 0}
        if not failed:
            failed = {Bound(name=name) for name, x in numbers.items() if not isfinite(x)}
        if not failed:
            failed = {part for name, value in numbers.items() for part in self._outside(problem, name, value)}
        self.told[i].update(dict.fromkeys(failed))
        return not failed

    def _outside(self, problem: "Problem", name: str, value: float) -> Iterator[Bound]:
        """The conditions of the range of a parameter that its value does not meet."""
        try:
            low, high, low_given, high_given = ends(problem, name, self.turning[name])
        except PhysicsError:
            yield Bound(name=name)
            return
        if value < low or (value == low and not low_given):
            yield Bound(None, name, "≥" if low_given else ">", self._bound(name, "from", low_given, low))
        if value > high or (value == high and not high_given):
            yield Bound(None, name, "≤" if high_given else "<", self._bound(name, "to", high_given, high))

    def _bound(self, name: str, key: str, given: bool, value: float) -> "Node":
        """An end of the range of a parameter as a node: as the scene gives it, else 0 or a multiple of π."""
        scene = self.rest.scene
        if given:
            bound = self.problem.spec.choices[name][key]
            return lowered(bound, scene.table, lambda part, *_: scene.parameters.nodes[part])
        end: Node = scene.table.pi * round(value / pi) if value else self.zero
        return end

    def conditions(self, i: int) -> list[Any]:
        """The Conditions under which a solution counts, those of its roots first."""
        for attempt in range(MANY):
            self._counts(i, self.values(attempt))
        return sorted(self.told[i], key=lambda condition: condition.node is None)


def _radicands(table: "Table", forms: "dict[str, Node]") -> "list[Node]":
    """What stands under even roots and may be negative."""
    found = {}
    for part in reachable(list(forms.values())):
        for base, e in part.args if part.op == "product" else ():
            if e.denominator % 2 == 0 and not table.is_positive(base):
                found[base] = None
    return list(found)
