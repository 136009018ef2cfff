"""What was chosen: the solutions, and the scene with the first of them."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import isclose
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.inverse.admissible_ranges import known
from vibcli.language.document.document import Scalar
from vibcli.language.reader import Expression, Record
from vibcli.notation.scene_language import language
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.parser import LONGEST, parse
from vibcli.symbolic.running_errors import UNIT
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from vibcli.inverse.solution_errors import Move, SearchedNumbers
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

DIGITS, READABLE = 60, 70
SHORT = 10          # digits of what is taken as a short decimal
FEW, CLOSE = 5, 1e-11
TRACE = 1e-20       # of an imaginary part, by the rounding of a double root


class Solution(NamedTuple):
    """values: {name: number, None in letters}; forms: {name: closed form or None}; residual of the substitution; fold:
    is this a limit point, at which the equilibrium and an unstable one vanish? counts: in letters, the Conditions
    under which it is a solution."""

    values: dict[str, Any]
    forms: dict[str, Any]
    residual: float
    fold: bool = False
    counts: tuple[Any, ...] = ()


class Chosen:
    """The parameters that a scene chooses, their conditions ({name: text}) and the solutions, ascending; draws: the
    same scene with numbers for its letters at which the first solution counts; searched: of each solution in numbers
    what tells the errors of those that were searched for."""

    __slots__ = ("_errors", "_searched", "conditions", "draws", "solutions")

    def __init__(self, choices: Mapping[str, Record], solutions: Sequence[Solution], draws: "Sequence[Problem]" = (),
                 searched: "Sequence[SearchedNumbers]" = ()) -> None:
        self.draws, self._searched = draws, searched
        self._errors: dict[int, dict[str, float]] = {}
        self.conditions = {name: record["so"].text for name, record in choices.items()}
        self.solutions = solutions

    def value(self, name: str, number: int) -> float:
        """The number of the solution with this number, from 1."""
        if not 1 <= number <= len(self.solutions):
            raise PhysicsError(f"there is no solution {number} for {name}: there "
                               + ("is one" if len(self.solutions) == 1 else f"are {len(self.solutions)}"),
                               f"ask for {name}")
        return float(self.solutions[number - 1].values[name])

    def error(self, name: str, number: int = 1) -> float:
        """The bound of the error of that."""
        solution = self.solutions[number - 1]
        if solution.forms[name] is not None or not self._searched:
            return UNIT * abs(float(solution.values[name]))
        if number not in self._errors:
            self._errors[number] = self._searched[number - 1].errors()
        return self._errors[number][name]

    def moved(self) -> "Iterator[tuple[float, list[Move]]]":
        """The error of each number of the first solution that was searched for, and the scenes with it moved; none of
        what is taken as a decimal, nor at a fold, whose place is found with it."""
        if self._searched and not self.exact and not self.solutions[0].fold:
            for name, moves in zip(self.conditions, self._searched[0].moves(), strict=True):
                if not _is_decimal(self.solutions[0].values[name], error := self.error(name)):
                    yield error, moves

    @property
    def exact(self) -> bool:
        """Is the first solution known in closed form?"""
        return all(form is not None for form in self.solutions[0].forms.values())


def shortened(x: float, digits: int = SHORT) -> Fraction:
    """The short decimal next to a number."""
    return Fraction(f"{x:.{digits}g}")


def _is_decimal(value: Fraction, error: float) -> bool:
    """Is a number a decimal of so few digits, known so well, that one in a million would be as near one by chance?"""
    return value == shortened(float(value), FEW) and error <= CLOSE * abs(value)


def defined(problem: "Problem", forms: "Mapping[str, Node]", sample: Mapping[str, Fraction] | None = None) -> "Problem":
    """The problem with parameters defined by closed forms ({name: node}); None where one is too long to write.
    `sample`: values of the letters at which these count, where it is drawn."""
    spec, parameters = problem.spec, dict(problem.spec.parameters)
    for name, node in forms.items():
        text, old = language(node), parameters[name]
        if len(text) > LONGEST or len(reachable([node])) > READABLE:
            return None
        try:
            tree = parse(text)
        except ExpressionError:
            return None
        value = Expression(Scalar(text, spec.choices[name].where), tree)
        parameters[name] = old.with_values({**old, "value": value})
    spec = spec.with_parameters(parameters)._replace(
        sample={name: float(value) for name, value in (sample or {}).items()})
    return problem.with_spec(spec)


def choosing(problem: Any, choices: Any) -> "Problem":
    """The problem with these to choose instead, {name: record}."""
    chosen: Problem = problem.with_spec(problem.spec._replace(choices=choices))
    return chosen


def in_numbers(problem: "Problem", nodes: "Sequence[Node]") -> list[Fraction] | None:
    """The values of closed forms to DIGITS digits, as Fractions; None where one is no finite number."""
    import mpmath

    with mpmath.workdps(DIGITS):
        arithmetic = multiprecision()
        try:
            found = evaluate(nodes, arithmetic, known(problem, arithmetic))
        except (KeyError, ZeroDivisionError, ValueError, OverflowError, TypeError):
            return None
        for value in found:
            if not mpmath.isfinite(value) or abs(mpmath.im(value)) > TRACE * abs(mpmath.re(value)):
                return None
        return [_fraction(mpmath.re(value)) for value in found]


def _fraction(value: Any) -> Fraction:
    """An mpmath number as the rational that it is."""
    sign, mantissa, exponent, _ = value._mpf_
    size: Fraction = Fraction(int(mantissa)) * Fraction(2) ** exponent
    return -size if sign else size


def stable_in_floats(problem: "Problem", nodes: "Sequence[Node]", values: Sequence[Fraction]) -> bool:
    """Do floats give these closed forms the same values but for rounding?"""
    try:
        found = evaluate(nodes, Floats, known(problem, Floats))
    except KeyError:
        return False
    return all(isclose(x, float(value), rel_tol=1e-13) for x, value in zip(found, values, strict=True))
