"""Which motion in time a scene has: of small oscillations, of its full equations, or of what is prescribed."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.factored_system import require_dense

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.results.precise_response import PreciseResponse
    from vibcli.results.problem import Problem
    from vibcli.results.steady_response import SteadyResponse


def motion_in_time(problem: "Problem") -> Any:
    """The motion of a problem, as `motion:` of its file says."""
    scene, spec = problem.scene, problem.spec
    require_dense(len(scene.q), "a motion in time")
    if not scene.q and scene.timed and not scene.pieces:
        from vibcli.results.prescribed_motion import PrescribedResponse

        return PrescribedResponse(problem)
    if spec.motion is None and scene.laws:
        raise _nonlinear(spec, scene.laws[0].owner)
    if scene.pieces:
        _require_no_accuracy(spec)
        from vibcli.results.members_in_time import members_in_time

        return members_in_time(problem)
    if spec.expanded:
        from vibcli.results.expanded_response import ExpandedResponse

        return ExpandedResponse(problem)
    if spec.motion == "full" and problem.digits is not None:
        from vibcli.results.series_response import SeriesResponse

        return SeriesResponse(problem)
    falls = spec.motion is None and not problem.numeric.has_free_symbols and problem.configuration.falls
    if spec.motion == "full" or falls:
        from vibcli.results.full_response import FullResponse

        return FullResponse(problem)
    _require_no_accuracy(spec)
    from vibcli.results.responses import SmallResponse

    return SmallResponse(problem, _precise_response)


def kept_up_by_loads(problem: "Problem") -> "SteadyResponse | None":
    """What loads that oscillate without end keep up in a scene with members, apart from the motion that leads to it;
    None where none does, or the motion is not one of small oscillations."""
    from vibcli.results.steady_response import SteadyResponse

    if problem.spec.in_full or (problem.spec.motion is None and problem.scene.laws):
        return None
    found = SteadyResponse(problem, PhysicsError("this is not found of small oscillations of members",
                                                 "ask for max(x), min(x) or values in time"))
    return found if found.drives else None


def _nonlinear(spec: "Spec", owner: str) -> PhysicsError:
    """The refusal of a motion in time that nobody said to linearise."""
    record = spec.connection(owner)
    return PhysicsError(f"'{owner}' has a nonlinear law: its motion in time is not that of small oscillations",
                        "write motion: small where the motion stays small" if spec.members else
                        "write motion: full, or motion: small where the motion stays small", record and record.where)


def _require_no_accuracy(spec: "Spec") -> None:
    """PhysicsError where an accuracy is asked of a motion that is not integrated."""
    if spec.accuracy is not None:
        raise PhysicsError("this motion is exact in time: it is not integrated, and no accuracy can be asked of it",
                           "leave the accuracy out, or ask for motion: full")


def _precise_response(problem: "Problem") -> "PreciseResponse":
    from vibcli.results.precise_response import PreciseResponse

    return PreciseResponse(problem)
