"""A scene's quantities by every method: points of run time and true error, and what was left out."""

from collections.abc import Iterable
from importlib import import_module
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.asked import NotCompared, subjects
from vibcli.evidence.methods import METHODS
from vibcli.evidence.stages import StageCost, stage_costs
from vibcli.evidence.subject import MethodRun, Subject
from vibcli.evidence.timing import RUNS, Point, measured_in_shares

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

WHOLE = 30.0        # s for the runs of all quantities


class WorkPrecision(NamedTuple):
    """A quantity with its points, ours first."""

    subject: Subject
    points: list[Point]


class Evidence(NamedTuple):
    """problem: the scene in numbers; drawn: {letter: value} that were drawn for letters that have none;
    stages: what the answers took of it, and what they skipped."""

    problem: "Problem"
    drawn: dict[str, str]
    compared: list[WorkPrecision]
    left_out: list[NotCompared]
    stages: list[StageCost]


def evidence(problem: "Problem", asked: "Iterable[Expression]", runs: int = RUNS, whole: float = WHOLE) -> Evidence:
    """The Evidence of the quantities that are asked, of those in the file's own answers where none is; whole: s for the
    runs of all."""
    given = list(asked)
    asked = given or [answer.asked for answer in problem.spec.answers]
    problem, drawn = in_numbers(problem)
    found = list(subjects(problem, asked, not given))
    left = [one for one in found if isinstance(one, NotCompared)]
    known = [one for one in found if isinstance(one, Subject)]
    points = measured_in_shares([(one, _attempts(one)) for one in known], runs, whole)
    compared = [WorkPrecision(*pair) for pair in zip(known, points, strict=True)]
    kinds = {one.subject.kind for one in compared}
    return Evidence(problem, drawn, compared, left, stage_costs(problem, kinds) if compared else [])


def in_numbers(problem: "Problem") -> "tuple[Problem, dict[str, str]]":
    """The problem with values for letters that have none, the same ones at every run, and these."""
    if problem.spec.choices:
        from vibcli.inverse import settled

        problem = settled(problem)
    if not problem.numeric.has_free_symbols:
        return problem, {}
    from vibcli.results.random_states import random_instances

    draws = problem.choice.draws if problem.choice is not None else ()      # at which what is chosen counts
    found = problem.with_values({name: draws[0].numeric.given[name] for name in problem.symbolic.letters}
                                ) if draws else next(random_instances(problem), None)
    if found is None:
        raise PhysicsError("no values were found for its letters with which the drawing fits together",
                           "give them with --set")
    return found, {name: str(found.numeric.given[name]) for name in problem.symbolic.letters}


def _attempts(subject: Subject) -> list[MethodRun]:
    """Those of all methods that answer it, ours first."""
    files = [file for file, (kinds, _) in METHODS.items() if subject.kind in kinds]
    return [attempt for file in files
            for attempt in import_module(f"vibcli.evidence.methods.{file}").attempts(subject)]
