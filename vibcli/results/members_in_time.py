"""The motion in time of scenes with members: by travelling waves where these are exact and their fronts few,
else by modes, values at early instants by waves nevertheless."""

from typing import TYPE_CHECKING

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.results.coupled_modal_response import CoupledModalResponse
    from vibcli.results.damped_modal_response import DampedModalResponse
    from vibcli.results.dispersed_wave_response import DispersedWaveResponse
    from vibcli.results.problem import Problem
    from vibcli.results.responses import SmallResponse
    from vibcli.results.wave_response import WaveResponse



def members_in_time(problem: "Problem") -> "SmallResponse":
    """The response of a scene whose members vibrate."""
    from vibcli.results.wave_response import WaveResponse

    if problem.spec.in_full:
        raise PhysicsError("members are linear about their drawn line: the full equations of this scene are not found",
                           "write motion: small")
    waves = WaveResponse(problem, by_modes=_by_modes)
    try:
        waves.alone  # noqa: B018 - is its motion one of waves?
    except NotByWaves:
        return _by_modes(problem, _dispersed(problem))
    try:
        if waves.ends or waves.drawn_out:
            waves.reach(waves.until)
    except NotByWaves:      # fronts are too many up to the end
        found = _by_modes(problem, waves)
        return waves if found.KIND == "steady" else found
    return waves


def _dispersed(problem: "Problem") -> "DispersedWaveResponse | None":
    """The response of which instants are read where drag or a foundation disperses waves; None of all else."""
    from vibcli.results.dispersed_wave_response import DispersedWaveResponse

    found = DispersedWaveResponse(problem)
    try:
        found.alone  # noqa: B018 - does it have such a motion?
    except NotByWaves:
        return None
    return found


def _by_modes(problem: "Problem", waves: "WaveResponse | None" = None) -> "SmallResponse":
    """The ModalResponse, beside waves that are followed for a while, or a response of which steady states alone are
    found."""
    from vibcli.results.modal_response import ModalResponse
    from vibcli.results.not_by_modes import CoupledModes, NotByModes, ShakenSupports

    modes: ModalResponse = ModalResponse(problem, waves)
    try:
        try:
            modes.alone  # noqa: B018 - is its motion one of modes by themselves?
        except ShakenSupports:
            from vibcli.results.shaken_modal_response import ShakenModalResponse

            modes = ShakenModalResponse(problem, waves)
            modes.alone  # noqa: B018 - does it have such a motion?
        except CoupledModes:
            modes = _by_coupled_modes(problem, waves)
    except NotByModes as reason:
        from vibcli.results.steady_response import SteadyResponse

        return SteadyResponse(problem, PhysicsError(
            f"the motion in time of this scene is not found: {reason.message}", reason.hint))
    if waves is not None:
        return modes
    from vibcli.results.parted_response import parted

    return parted(modes)


def _by_coupled_modes(problem: "Problem", waves: "WaveResponse | None") -> "CoupledModalResponse | DampedModalResponse":
    """By damped modes where these are all that moves, else by those without damping, which dampers couple."""
    from vibcli.results.coupled_modal_response import CoupledModalResponse
    from vibcli.results.damped_modal_response import DampedModalResponse

    given = problem.spec.get("damping")
    rated = given is not None and "proportional" not in given
    if rated or any(placed.retardation for placed in problem.configuration.linear_system.pieces):
        modes = CoupledModalResponse(problem, waves)
        modes.alone  # noqa: B018 - does it have such a motion?
        return modes
    found = DampedModalResponse(problem, waves)
    found.require()
    return found
