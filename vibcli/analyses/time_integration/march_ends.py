"""Why a motion cannot be followed beyond an instant."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.time_stepping import March
    from vibcli.mechanics.numeric_equations import NumericEquations


def undefined(system: "NumericEquations", t: float) -> PhysicsError:
    """The refusal where forces are not defined at an instant."""
    ending = system.scene.endings(system.floats)
    return PhysicsError(f"the forces of this scene are not defined at t = {t:.6g} s, in the position that the "
                        "motion reaches" + (f": {ending.what}" if ending else ""), ending.hint if ending else
                        "look for roots of what becomes negative, or ends that meet")


def singular(system: "NumericEquations", t: float) -> PhysicsError:
    """The refusal where no window is short enough."""
    ending = system.scene.endings(system.floats)
    if ending:
        return PhysicsError(f"the motion cannot be followed beyond t = {t:.9g} s: there {ending.what}, or a "
                            "force or a linkage is singular", ending.hint)
    return PhysicsError(f"the motion cannot be followed beyond t = {t:.9g} s: it grows without bound there, "
                        "or a force or a linkage is singular", "ask for an earlier end, or mind the signs of "
                        "stiffness and damping")


def endless(march: "March") -> tuple[str, str]:
    """(why it was stopped before its end, what may be done)."""
    task = march.pace.task
    return (f"after {task.steps:.0f} of at most {task.limit:.0f} steps the motion has come to t = {march.t:.6g} s of "
            f"{march.until:.6g} s: its fastest part takes steps of {march.windows[-1].length:.3g} s",
            f"ask for a shorter time, damp what vibrates fast, or let what is very stiff be rigid; {task.hint()}")
