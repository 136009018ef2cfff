"""A quantity that several methods answer: its true values, and what each method is given."""

from collections.abc import Callable, Sequence
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.evidence.reference.settled import TrueValues
    from vibcli.results.problem import Problem

ALONE, NO_NUMBER = "no other method is known here", "it is no number"
COUNTED = "it is a count, which has no digits to compare"
NOTHING_ELSE = (ALONE, NO_NUMBER, COUNTED)      # why what vibcli finds by itself is not compared
BY_DIFFERENCES = "derivative"       # the kind whose data is a function of a step, an estimate by central differences
MOMENT = "moment of a body"     # whose data is a function of a quadrature rule, and whether it matters
ESTIMATE = "estimate"               # whose data is a formula in floats
FOLD = "fold"       # whose data is a FoldEquations, where to begin, and what is read off its unknowns
LAW = "force law"       # that whose data is a law in floats and a deflection


class MethodAnswer(NamedTuple):
    """What a method finds: numbers, and the largest bound of their relative errors, None where it states none."""

    values: Sequence[Any]
    bound: float | None = None


class Subject(NamedTuple):
    """`kind`: modes, damped modes …, which decides what methods there are; `asked`: as the scene language writes it;
    `title`: in words; `problem`: with its element data known; `true`: what is to be found; `ours`: finds it from the
    element data on; `data`: what the other methods are given; `error`: of values, beside the true ones, of
    motions relative to `scale`, the largest value."""

    kind: str
    asked: str
    title: str
    problem: "Problem"
    true: "TrueValues"
    ours: Callable[[], MethodAnswer]
    data: Any
    error: Callable[[Sequence[Any], "TrueValues"], float]
    scale: float = 1.0


def of_signal(kind: str, problem: "Problem", tree: Any, title: str, true: "TrueValues", data: Any) -> Subject:
    """A number of a signal, whose errors are relative to its largest value, `about` its true one."""
    return of_number(kind, problem, tree, title, true, data, float(true.about) or 1.0, problem.afresh)


def of_number(kind: str, problem: "Problem", tree: Any, title: str, true: "TrueValues", data: Any, scale: float,
              afresh: "Callable[[], Problem]") -> Subject:
    """A number, whose errors are relative to a scale; afresh: the scene in which ours is found, from the element data
    on."""
    from vibcli.quantities.expression import measure

    def ours() -> MethodAnswer:
        value, bound = measure(afresh(), tree)
        return MethodAnswer([value], bound * abs(value) / scale)

    def error(found: Sequence[Any], known: "TrueValues") -> float:
        import mpmath

        with mpmath.workdps(known.working):
            return float(abs(mpmath.mpf(float(found[0])) - known.values[0]) / scale)

    return Subject(kind, tree.text, title, problem, true, ours, data, error, scale)


class TimeIsOver(Exception):
    """A method took longer than it is given."""


class Deadline:
    """The processor time that a method has; one that takes many steps asks now and then."""

    def __init__(self, seconds: float) -> None:
        self._until = process_time() + seconds

    def check(self) -> None:
        """TimeIsOver where the time is over."""
        if process_time() > self._until:
            raise TimeIsOver


class MethodRun(NamedTuple):
    """One method with one setting (a tolerance, a number of points, '' where it has none), to be run."""

    method: str
    setting: str
    run: Callable[[Deadline], MethodAnswer]
