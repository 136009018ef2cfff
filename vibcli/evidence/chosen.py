"""Parameters that a scene chooses: what the conditions determine, the quantities in these being true ones."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, cast

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.conditions import Residual, determined
from vibcli.evidence.reference.modal import matrices
from vibcli.evidence.subject import MethodAnswer, Subject
from vibcli.inverse import settled
from vibcli.mechanics.high_precision import in_its_place
from vibcli.quantities.expression import lowered_in, measure
from vibcli.results.problem import Problem
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.reader.sections.choose import Condition
    from vibcli.symbolic.syntax import QuantityRef

    Make = Callable[[Problem, QuantityRef], Subject]

KIND, TITLE = "chosen parameter", "what conditions determine"
MODES = "modes", "damped modes", "member modes", "damped member modes"
SURE = 50               # digits of what is balanced
OF_RATES: dict[str, Callable[[Any], Any]] = {
    "omega": abs, "frequency": lambda x: abs(x) / (2 * mpmath.pi), "period": lambda x: 2 * mpmath.pi / abs(x),
    "omega_d": mpmath.im, "period_d": lambda x: 2 * mpmath.pi / mpmath.im(x), "decay": lambda x: -mpmath.re(x),
    "growth_rate": mpmath.re, "zeta": lambda x: -mpmath.re(x) / abs(x), "eigenvalue": lambda x: x}


def chosen(problem: Problem, tree: "NameRef | QuantityRef", subject_of: "Make") -> Subject:
    """c, or its second solution c[2]; subject_of: makes the Subject of another quantity."""
    open_one = _unsettled(problem)
    choices = open_one.spec.choices
    name, asked, number = (tree.name, tree.name, 1) if isinstance(tree, NameRef) else (
        tree.head, tree.text, int(tree.indices[0]))

    def ours() -> MethodAnswer:
        choice = settled(open_one.with_values({})).choice
        value = choice.value(name, number)
        return MethodAnswer([value], choice.error(name, number) / abs(value) if value else 0.0)

    known = settled(open_one).choice
    known.value(name, number)       # refused where there is none

    def residual(p: "Sequence[mpmath.mpf]") -> Residual:
        there = open_one.with_values({name: _fraction(x) for name, x in zip(choices, p, strict=True)})
        found = [pair for record in choices.values() for pair in _pairs(there, record["so"], subject_of)]
        return Residual([value for value, _ in found], [error for _, error in found])

    values = known.solutions[number - 1].values
    true = determined(residual, [mpmath.mpf(Fraction(values[one]).numerator) / Fraction(values[one]).denominator
                                 for one in choices])
    p = true.values[list(choices).index(name)]

    def error(found: Any, _: Any) -> float:
        with mpmath.workdps(true.working):
            return float(abs(mpmath.mpf(float(found[0])) / p - 1))

    return Subject(KIND, asked, TITLE, problem, true._replace(values=[p]), ours, None, error)


def _unsettled(problem: Problem) -> Problem:
    """The scene in which they are to be chosen."""
    spec = problem.spec
    parameters = {name: record.with_values({key: x for key, x in record.items() if key != "value"})
                  if name in spec.choices else record for name, record in spec.parameters.items()}
    given = {name: x for name, x in problem.numeric.given.items() if name not in spec.choices}
    return Problem(spec.with_parameters(parameters), given, problem.work)


def _fraction(x: mpmath.mpf) -> Fraction:
    sign, man, exponent, _ = x._mpf_
    return cast("Fraction", Fraction(-man if sign else man) * Fraction(2) ** exponent)


def _pairs(problem: Problem, condition: "Condition",
           subject_of: "Callable[[Problem, QuantityRef], Subject]") -> list[tuple[mpmath.mpf, mpmath.mpf]]:
    """[(L − R, to what it is known)] of a condition."""
    if condition.is_balance:
        numbers = multiprecision()
        known = {**problem.numeric.values(numbers), problem.scene.time.name: mpmath.mpf(0)}
        known |= in_its_place(problem.scene.drawn, known, numbers)
        every = [evaluate(terms, numbers, known) for terms in problem.system.drawn_residual]
        return [(mpmath.fsum(terms), mpmath.fsum(map(abs, terms)) * mpmath.mpf(10) ** -SURE) for terms in every]
    if condition.is_limit:
        return [_stiffness(problem)]
    (left, its), (right, others) = (_side(problem, side, subject_of) for side in condition.sides)
    return [(left - right, its + others)]


def _stiffness(problem: Problem) -> tuple[mpmath.mpf, mpmath.mpf]:
    """(det K of what rests as it is drawn, to what it is known)."""
    elements = problem.configuration.linear_system
    if elements.G or elements.circulatory or elements.pieces or not problem.configuration.equilibrium.drawn:
        raise PhysicsError("of limits of stability a reference is found where a scene rests as it is drawn and nothing "
                           "turns it round")
    K = matrices(problem.configuration.precise_system)[2]
    return mpmath.det(K), mpmath.mpf(10) ** -SURE * mpmath.norm(K) ** K.rows


def _side(problem: Problem, expression: "Expression",
          subject_of: "Callable[[Problem, QuantityRef], Subject]") -> tuple[mpmath.mpf, mpmath.mpf]:
    """(a side of an equation, to what it is known)."""
    numbers, node = multiprecision(), lowered_in(problem.scene, expression)
    found = {tree.text: _true(problem, tree, subject_of) for tree in expression.parts.quantities}
    known = {**problem.numeric.values(numbers), **{text: value for text, (value, _) in found.items()}}
    value, = evaluate([node], numbers, known)
    moved = [evaluate([node], numbers, {**known, text: x + e})[0] - value for text, (x, e) in found.items()]
    return value, mpmath.fsum(map(abs, moved))


def _true(problem: Problem, tree: "QuantityRef",
          subject_of: "Callable[[Problem, QuantityRef], Subject]") -> tuple[mpmath.mpf, mpmath.mpf]:
    """(the true value of a quantity, to what it is known)."""
    subject = subject_of(problem, tree)
    true, value = subject.true, subject.true.values[0]
    if subject.kind in MODES:
        if tree.head not in OF_RATES:
            raise PhysicsError(f"no reference is found of what is chosen by {tree.text}")
        near, read = measure(problem, tree)[0], OF_RATES[tree.head]
        value = min((read(x) for x in true.values if x), key=lambda x: abs(x - near))
    size = max(abs(value), true.about if isinstance(true.about, mpmath.mpf) else 0)
    return value, size * mpmath.mpf(10) ** -true.digits
