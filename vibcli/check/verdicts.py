"""Answers against results: a verdict per line of `answers`.

Numbers are compared within their tolerance (comparison.py); equations of motion up to a non-zero factor, V up to a
constant, at random states. A scene with symbols is checked at several sets of random values of its symbols.
"""

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import LostDigits, NoBound, NotInLetters, PhysicsError, Unknown
from vibcli.base.named_tuple import NamedTuple
from vibcli.check.comparison import compared
from vibcli.check.instances import Instances
from vibcli.check.tolerance import EXACT, is_exact
from vibcli.quantities.energies import equation_number
from vibcli.quantities.expression import lowered, measure
from vibcli.quantities.quantity import EQUATION, OF_STATE, TRUTH, asked_in, declared, kind_of
from vibcli.quantities.response import ALONG
from vibcli.results.random_states import at_states, states

if TYPE_CHECKING:
    import numpy as np

    from vibcli.language.reader import Expression
    from vibcli.reader.sections.answer import Answer
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef, QuantityRef

    Mistake = Callable[[Problem, Expression, float, float, str | None], str | None]

ROUNDING = 1e-13
NEAR = 1e-4         # relative: what is told as a difference, not as a ratio
UNKNOWN = LostDigits, NoBound, NotInLetters, Unknown    # there is an answer that is not known
FEW = 1e-6          # relative bound above which it stands beside what is found


class Verdict(NamedTuple):
    """One answer compared: expected and found (numbers or None), whether they agree (None where that is uncertain), and
    a remark (then what is known); the refusal of a scene that has no such answer, or does not know it so well; error:
    an absolute bound of what is found, None where nothing is measured, `estimated` where it is an estimate; digits:
    expected and found, where floats do not tell them apart."""

    answer: "Answer"
    agrees: bool | None
    expected: float | bool | None = None
    found: float | bool | None = None
    remark: str | None = None
    case: str | None = None
    refusal: PhysicsError | None = None
    error: float | None = None
    digits: tuple[str, str] | None = None
    estimated: bool = False

    @property
    def known(self) -> str | None:
        """What is found with its bound, where that leaves few digits; None elsewhere."""
        if not self.error or not self.error > FEW * abs(self.found or 0.0):
            return None
        from vibcli.notation.numbers import with_bound

        return with_bound(self.found, self.error)


def check(problem: "Problem", mistake: "Mistake | None" = None) -> list[Verdict]:
    """The Verdicts of a problem and of its cases; SpecError where the geometry of one contradicts itself. mistake:
    (problem, asked, expected, found, case) ↦ the sentence of the known mistake that leads to what is expected, None
    where none does."""
    problem.draw()
    verdicts = []
    for case in (None, *problem.spec.cases):
        part = problem if case is None else problem.case(case)
        verdicts += verdicts_of(part, part.spec.answers, case, mistake)
    return verdicts


def verdicts_of(problem: "Problem", answers: "Iterable[Answer]", case: str | None = None,
                mistake: "Mistake | None" = None, instances: Instances | None = None) -> list[Verdict]:
    """The Verdicts of some answers of a scene, or of a case of it; mistake: as in `check`; instances: those of the
    scene, where they are known."""
    instances = instances or Instances(problem)
    return [_verdict(instances, answer, case, mistake) for answer in answers]


def _verdict(instances: Instances, answer: "Answer", case: str | None, mistake: "Mistake | None") -> Verdict:
    """Compare at every instance, to the first that differs; of a scene with symbols, those of a regime that has no such
    answer are passed over."""
    verdict, count = None, 0
    for instance in instances:
        try:
            found = _compare(instance, answer, case, mistake)
        except PhysicsError as error:
            if verdict is None:
                said = "not known: " if isinstance(error, UNKNOWN) else "no such answer: "
                verdict = Verdict(answer, False, remark=said + error.message, refusal=error.told(answer.asked.where))
            continue
        verdict, count = found if not count or not found.agrees else verdict, count + 1
        if found.agrees is False or count == instances.wanted:
            break
    return verdict._replace(case=case)


def worst_place(wanted: Any, found: Any, groups: Any, rounding: float = 0.0) -> tuple[int, float, float] | None:
    """(index, difference, size of the group) where two functions differ; None where they agree in each group."""
    rounding = max(rounding, ROUNDING * max(abs(wanted).max(), abs(found).max()))
    for group in groups:
        off, size = abs(wanted - found)[group], max(abs(wanted[group]).max(), abs(found[group]).max())
        if not off.max() <= EXACT * size + rounding:
            return group.start + int(off.argmax()), float(off.max()), float(size)
    return None


def proportional(wanted: Any, found: Any, groups: Any) -> tuple[float, tuple[int, float, float] | None]:
    """(the factor between two functions, 0 where one is empty; where they differ by more, None where they do not)."""
    factor = float(wanted @ found / (found @ found)) if found.any() else 0.0
    return factor, worst_place(wanted, factor * found, groups)


def _compare(problem: "Problem", answer: "Answer", case: str | None, mistake: "Mistake | None") -> Verdict:
    tree = answer.asked.tree
    kind = kind_of(problem.spec, tree)
    head = None if kind is None else tree.head
    if kind in OF_STATE:
        return (_compare_equation if kind == EQUATION else _compare_function)(problem, answer, head)
    if kind == TRUTH:
        wanted, found = answer.expected.text == "true", measure(problem, tree)[0]
        return Verdict(answer, found == wanted, wanted, found)
    return _number(problem, answer, case, mistake)


def _number(problem: "Problem", answer: "Answer", case: str | None, mistake: "Mistake | None") -> Verdict:
    found = compared(problem, answer)
    told = None
    if found.agrees is False and found.digits is None and found.found and found.expected:
        told = mistake and mistake(problem, answer.asked, found.expected, found.found, case)
        told = told or _difference(found.expected / found.found)
    verdict = Verdict(answer, found.agrees, found.expected, found.found, told, error=found.error, digits=found.digits,
                      estimated=_estimated(problem, answer.asked.tree))
    return _uncertain(verdict) if found.agrees is None else verdict


def _difference(ratio: float) -> str:
    """By how much what is expected is off what is found."""
    return f"off by {abs(ratio - 1):.2g} of it" if abs(ratio - 1) < NEAR else f"ratio {ratio:.6g}"


def _estimated(problem: "Problem", tree: "QuantityRef") -> bool:
    """Is the error of what is asked, read off a motion in time, an estimate?"""
    along = [(problem.response_of(asked), asked.args[0]) for asked in asked_in(tree) if asked.head in ALONG]
    return any(response.estimated and response.kept_signal(signal).is_estimated for response, signal in along)


def _uncertain(verdict: Verdict) -> Verdict:
    """The Verdict with the refusal of an answer that the bound of what is found leaves open."""
    from vibcli.notation.numbers import with_bound

    known, answer = with_bound(verdict.found, verdict.error), verdict.answer
    cause = "the answer is exact" if is_exact(answer) else "the answer has more digits"
    refusal = PhysicsError(f"{answer.asked.text} is known to be {known}: {cause}, and whether it agrees is uncertain",
                           _advice(verdict), answer.expected.where)
    return verdict._replace(remark=f"found {known}", refusal=refusal)


def _advice(verdict: Verdict) -> str:
    """What to write where an answer is uncertain."""
    if not verdict.expected:
        return "add to both sides what it is small beside, as in x + 1 mm: 1.00 mm"
    tolerance = "a tolerance: {value: …, rtol: 1 %}"
    return "give " + tolerance if is_exact(verdict.answer) else "write fewer digits, or give " + tolerance


def expected_node(problem: "Problem", expression: "Expression") -> "Node":
    """What is expected, in parameters, coordinates and the time; of an equation its left side less its right one."""
    scene = problem.scene

    def symbol(name: str, primes: int, part: "NameRef") -> "Node":
        return scene.parameters.nodes[name] if name in scene.parameters.nodes else scene.symbol(name, primes)

    return lowered(expression, scene.table, symbol)


def _symbolic(problem: "Problem", answer: "Answer") -> "Node":
    """The expression that is asked for."""
    found: Node = declared(answer.asked.tree).symbolic(problem, answer.asked.tree)
    return found


def _compare_function(problem: "Problem", answer: "Answer", head: str) -> Verdict:
    scene, ours = problem.scene, _symbolic(problem, answer)
    verdict = _at_states(problem, answer, head, ours)
    if not verdict.agrees and head in ("T", "V") and ours.mask & scene.time.mask:
        left = scene.terms_with(ours, ~scene.time.mask)     # Lagrange's equations do not need the others
        reduced = _at_states(problem, answer, head, left)
        verdict = reduced if reduced.agrees else verdict
    return verdict


def _at_states(problem: "Problem", answer: "Answer", head: str, ours: "Node") -> Verdict:
    """Is an energy as expected at random states, V up to a constant?"""
    expected = expected_node(problem, answer.expected)
    at, groups = states(problem)
    wanted, found = at_states(problem, [expected, ours], at)
    rounding = 0.0
    if head == "V":
        first = [group.start for group in groups for _ in range(group.start, group.stop)]
        rounding = ROUNDING * max(abs(wanted).max(), abs(found).max())
        wanted, found = wanted - wanted[first], found - found[first]
    worst = worst_place(wanted, found, groups, rounding)
    i = worst[0] if worst else 0
    return Verdict(answer, worst is None, float(wanted[i]), float(found[i]),
                   "values at a random state of motion" if worst else None)


def _compare_equation(problem: "Problem", answer: "Answer", head: str) -> Verdict:
    """Are the two left sides proportional at random states?"""
    scene = problem.scene
    i = equation_number(problem, answer.asked.tree.indices[0])
    expected = expected_node(problem, answer.expected)
    at, groups = states(problem)
    if head == "equation":
        at = {name: value - problem.numeric.drawn_floats.get(name, 0.0) for name, value in at.items()}
        drive = problem.symbolic.excitation.get(i, scene.table.zero) if scene.timed else scene.table.zero
        wanted, load = at_states(problem, [expected, drive], at)
        found = _small_oscillation(problem, i, at) - load
    else:
        wanted, found = at_states(problem, [expected, _symbolic(problem, answer)], at)
    factor, worst = proportional(wanted, found, groups)
    agrees = factor != 0.0 and worst is None
    remark = f"not proportional: off by {worst[1] / worst[2]:.2g} of its size" if worst else "it is empty"
    return Verdict(answer, agrees, remark=None if agrees else remark)


def _small_oscillation(problem: "Problem", i: int, at: "dict[str, np.ndarray]") -> Any:
    """The left side of the linear equation of coordinate i at all states."""
    M, C, G, K = problem.configuration.linear_system.matrices()
    total: Any = 0.0
    for j, name in enumerate(problem.scene.coordinates):
        total = total + (M.get((i, j), 0.0) * at[name + "''"] + K.get((i, j), 0.0) * at[name]
                         + (C.get((i, j), 0.0) + G.get((i, j), 0.0)) * at[name + "'"])
    return total

