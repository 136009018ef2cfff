"""Masses, mass centres and moments of inertia of bodies."""

from typing import TYPE_CHECKING

from vibcli.evidence.reference.bodies import BodyInNumbers, true_moment
from vibcli.evidence.subject import MOMENT, Subject, of_number
from vibcli.quantities.expression import measure
from vibcli.quantities.quantity import declared
from vibcli.symbolic.evaluation import Floats

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef


def moment(problem: "Problem", tree: "QuantityRef") -> Subject:
    """mass[b], centre[b].x, J[b, O]; others add up over cells of its shapes."""
    value = measure(problem, tree)[0]           # refused where there is none
    size = declared(tree).size(problem, tree) if tree.head != "mass" else abs(value)
    true, body = true_moment(problem, tree, size), BodyInNumbers(problem, tree.indices[0], Floats)
    return of_number(MOMENT, problem, tree, "an integral over the shapes of a body", true,
                     (lambda rule: float(body.asked(tree, rule)), any(shape.reaches for shape in body.shapes)),
                     abs(float(true.values[0])) or size or 1.0, problem.afresh)
