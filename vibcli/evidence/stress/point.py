"""One scene of a family: what is answered and stated, and what a plain method answers, beside the true value."""

import math
import warnings
from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.asked import subjects
from vibcli.evidence.reference.settled import relative_error, settled
from vibcli.evidence.stress.claims import Claim, claims
from vibcli.evidence.stress.condition import condition
from vibcli.evidence.stress.family import StressFamily
from vibcli.evidence.stress.watched import scene_problem
from vibcli.evidence.subject import Deadline, Subject
from vibcli.evidence.timing import reason
from vibcli.results.problem import Problem

if TYPE_CHECKING:
    from vibcli.evidence.reference.settled import TrueValues

HELD, ESCALATED, REFUSED, BROKEN, UNKNOWN = "held", "escalated", "refused", "broken", "no reference"
IDLE, IDLE_ESTIMATE = 1e4, 1e6      # times the error and the rounding of the value
PATIENCE = 5.0                      # s of the plain method


class StressPoint(NamedTuple):
    """`error`, `bound`: relative, of the number of which the bound is tightest beside its error, None where there is
    none; `plain`: the error of the plain method, infinite where it has no answer, and `plain_why` it has none; `why`:
    of what was refused."""

    knob: str
    condition: float | None
    error: float | None
    bound: float | None
    plain: float | None
    verdict: str
    idle: bool = False
    why: str = ""
    plain_why: str = ""


def measured(family: StressFamily, knob: str) -> StressPoint:
    """The point of a family at one value of its knob."""
    scene = family.scene(knob)
    subject, why = _subject(family, knob, scene)
    if subject is None:
        return StressPoint(knob, None, None, None, None, UNKNOWN, why=why)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        (plain, none), known = _plain(family, knob, subject), condition(subject)
    found = _answered(scene, subject)
    if isinstance(found, PhysicsError):
        return StressPoint(knob, known, None, None, plain, REFUSED, why=found.message, plain_why=none)
    worst, escalated = max(found[0], key=Claim.ratio), found[1]
    verdict = BROKEN if not worst.error <= worst.bound else ESCALATED if escalated else HELD
    limit = IDLE_ESTIMATE if subject.kind == "full motion" else IDLE
    idle = worst.bound > limit * (worst.error + worst.rounding)
    return StressPoint(knob, known, worst.error, worst.bound, plain, verdict, idle, plain_why=none)


def _subject(family: StressFamily, knob: str, scene: Mapping[str, Any]) -> tuple[Subject, str]:
    """(Subject with its true values, "") or (None, why there is none)."""
    problem, _ = scene_problem(scene)
    if family.truth is not None:
        return _of_truth(problem, family.truth, knob), ""
    found = next(iter(subjects(problem, [answer.asked for answer in problem.spec.answers])))
    return (found, "") if isinstance(found, Subject) else (None, found.why)


def _of_truth(problem: Problem, truth: Any, knob: str) -> Subject:
    """A Subject of which a closed form gives the true values."""
    true = settled(lambda: truth(knob))
    if true.about is None:
        M, _, G, K = problem.configuration.linear_system.arrays()
        return Subject("modes", "omega", "natural modes", problem, true, _nobody, (M, G, K), relative_error)
    asked, scale = problem.spec.answers[0].asked, float(true.about)
    return Subject("motion", asked.tree.text, "a motion", problem, true, _nobody, None,
                   lambda found, known: _off(found, known, scale), scale)


def _off(found: Sequence[float], true: "TrueValues", scale: float) -> float:
    """The error of a number beside a size."""
    with mpmath.workdps(true.working):
        return float(abs(mpmath.mpf(float(found[0])) - true.values[0]) / scale)


def _nobody() -> None:
    """Of a Subject that is asked for its true values alone."""
    raise NotImplementedError


def _answered(scene: Mapping[str, Any], subject: Subject) -> PhysicsError | tuple[list[Claim], bool]:
    """(Claims, were more digits taken?), or the PhysicsError that refuses."""
    problem, digits_taken = scene_problem(scene)
    try:
        return claims(problem, subject), digits_taken()
    except PhysicsError as error:
        return error


def _plain(family: StressFamily, knob: str, subject: Subject) -> tuple[float, str]:
    """(the error of the plain method, "") or (infinite, why it has no answer)."""
    try:
        if callable(family.plain):
            return subject.error(family.plain(knob), subject.true), ""
        file, *which = family.plain
        attempts = import_module(f"vibcli.evidence.methods.{file}").attempts(subject)
        attempt = next(one for one in attempts if [one.method, one.setting] == which)
        return subject.error(attempt.run(Deadline(PATIENCE)).values, subject.true), ""
    except Exception as error:      # whatever a library has to say of an input that it does not bear
        return math.inf, reason(error)
