"""Forces of springs and dampers by their laws, and the coefficients of these."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from vibcli.evidence.reference.differences import coefficient, true_coefficient
from vibcli.evidence.reference.laws import law_of, true_force, true_law
from vibcli.evidence.subject import BY_DIFFERENCES, LAW, Subject, of_number
from vibcli.evidence.subjects.vibrations import exact
from vibcli.mechanics.configuration import Configuration
from vibcli.quantities.expression import measure, number_of
from vibcli.quantities.index_kinds import power_of_deflection
from vibcli.symbolic.evaluation import Floats

if TYPE_CHECKING:
    import mpmath

    from vibcli.evidence.reference.laws import LawInNumbers
    from vibcli.evidence.reference.settled import TrueValues
    from vibcli.language.reader import Record
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef


def force(problem: "Problem", tree: "QuantityRef") -> Subject:
    """law[s](2 cm)"""
    measure(problem, tree)          # refused where there is none
    record, D = _record(problem, tree), number_of(problem, tree.args[0])
    true = true_force(problem, record, exact(problem, tree.args[0]))
    data = law_of(problem, record, Floats, problem.numeric.floats), D
    return _subject(LAW, problem, tree, "by the laws of its parts", true, data)


def of_power(problem: "Problem", tree: "QuantityRef") -> Subject:
    """law[s, d^3]"""
    measure(problem, tree)
    record, (_, n) = _record(problem, tree), power_of_deflection(tree.indices[1])
    true = true_coefficient(lambda: lambda d: true_law(problem, record).at(d[0])[0], [n], [1.0], 1.0)
    plain = law_of(problem, record, Floats, problem.numeric.floats)
    return _subject(BY_DIFFERENCES, problem, tree, "of a force law", true,
                    lambda step: coefficient(lambda d: plain.at(d[0])[0], [n], [step]))


def _subject(kind: str, problem: "Problem", tree: "QuantityRef", title: str, true: "TrueValues",
             data: "Callable[..., Callable[..., mpmath.mpf]] | tuple[LawInNumbers, float]") -> Subject:
    return of_number(kind, problem, tree, title, true, data, abs(float(true.values[0])) or 1.0,
                     lambda: problem.about(Configuration(problem.numeric)))


def _record(problem: "Problem", tree: "QuantityRef") -> "Record":
    name = tree.indices[0]
    found: Record = next(records[name] for section in ("springs", "dampers")
                           if name in (records := problem.spec.get(section) or {}))
    return found
