"""What the answer took of the stages of a scene, and what those that it skipped would have cost, found by taking them
afterwards; dear ones of many coordinates are not measured."""

from collections.abc import Callable
from contextlib import suppress

from vibcli.analyses import OF_MODES
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.results.problem import Problem
from vibcli.results.stages import STAGES

WITHOUT_MODES = {"static position", "full motion", "matrix entry"}
DEAR, FEW = ("closed_forms", "equilibria"), 3       # stages, and the coordinates up to which they are measured
UNMEASURED = f"not measured: of members and of more than {FEW} coordinates they may take minutes"


class StageCost(NamedTuple):
    """A stage; seconds: that it took, or would take; taken: was it needed? why: it has no cost."""

    stage: str
    seconds: float | None
    taken: bool
    why: str = ""


def stage_costs(problem: Problem, kinds: set[str]) -> list[StageCost]:
    """Of a problem whose subjects are of these kinds; a scene that is built anew."""
    fresh = Problem(problem.spec, problem.numeric.given)
    if "static position" in kinds:
        fresh.configuration.equilibrium  # noqa: B018
    if "matrix entry" in kinds:
        fresh.configuration.linear_system  # noqa: B018
    if kinds - WITHOUT_MODES:
        fresh.modal.modes  # noqa: B018
        if problem.modal.damps:
            fresh.modal.damped  # noqa: B018
    if kinds & {"motion", "full motion", "vibrations"}:
        with suppress(PhysicsError):        # none is asked where motions are by their amplitudes
            fresh.response  # noqa: B018
    needed = set(fresh.timings)
    return [_cost(fresh, stage, stage in needed) for stage in STAGES]


def _cost(problem: Problem, stage: str, taken: bool) -> StageCost:
    if taken:
        return StageCost(stage, problem.timings[stage], True)
    if stage in DEAR and (len(problem.scene.q) > FEW or problem.scene.pieces):
        return StageCost(stage, None, False, UNMEASURED)
    try:
        _touch(stage)(problem)
    except PhysicsError as error:
        return StageCost(stage, None, False, f"not found: {error.message}")
    return StageCost(stage, problem.timings.get(stage), False)


def _touch(stage: str) -> Callable[[Problem], object]:
    """What takes a stage of a Problem."""
    if stage in OF_MODES:
        return lambda problem: problem.modal.result(stage)
    parts = {"linearisation": "system", **dict.fromkeys(("equilibrium", "linear_system", "reactions"), "configuration"),
             **dict.fromkeys(("modes", "damped"), "modal"), **dict.fromkeys(("energies", "equations"), "symbolic")}
    return lambda problem: getattr(getattr(problem, parts[stage]) if stage in parts else problem, stage)

