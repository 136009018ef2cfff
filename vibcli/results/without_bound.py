"""Why what modes left out add to a signal has no bound, and what helps."""

from math import tau
from typing import TYPE_CHECKING

from vibcli.analyses.continuous.disturbances import BOTH, FALL, FIELD, PACE, SERIES, TENSION
from vibcli.analyses.continuous.left_out_causes import IN_FIELD
from vibcli.base.errors import NoBound

if TYPE_CHECKING:
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput

LEFT_OUT = "what the modes left out add to this signal has no bound that is known: "
JUMPED = "after what sets in at once here the sizes of their terms have no finite sum"
FITTING = "let it start in a shape whose moments and forces fit all ends and joints"
SLOWLY = ("loads rise within a time, as (ramp(t) - ramp(t - T))/T does, or where they move supports, or accelerations "
          "are asked, as smoothly as t^4")
DAMPED = "with `damping: {modal: 1 %}` values later on are known"
REASONS = {
    TENSION: ("it is read next to an end without tension, where a unit load moves a member without bound",
              "ask for a place further from that end"),
    PACE: ("a load changes as fast as the modes that are counted", "let it change more slowly"),
    FALL: ("as those counted tell, they fall too slowly or too unevenly",
           "let loads rise within a time; displacements have a bound more often than forces and rates do"),
    FIELD: (JUMPED, f"{FITTING}; {DAMPED}"),
    SERIES: (JUMPED, f"let {SLOWLY}; {DAMPED}"),
    BOTH: (JUMPED, f"{FITTING}, and {SLOWLY}; {DAMPED}"),
}
LATER = "ask for values later on, when these modes have died out"


def without_bound(motion: "ModalMotion", output: "LinearOutput", t: float) -> NoBound:
    """The refusal of an output of a motion of which modes left out have no bound at an instant."""
    obstacle = motion.obstacle(output, t)
    reason, hint = REASONS[obstacle]
    if obstacle == FALL and motion.modes.disturbed:
        why = why_estimated(motion, output)
        reason, hint = f"{reason}, {why}" if why else reason, f"{FITTING}; {hint}" if IN_FIELD in why else hint
    dies_out = obstacle in (FIELD, SERIES, BOTH) and motion.slowest and motion.is_bounded(
        output, t + tau / motion.slowest)
    return NoBound(LEFT_OUT + reason, LATER if dies_out else hint)


def why_estimated(motion: "ModalMotion", output: "LinearOutput") -> str:
    """Why what they add is estimated, in words."""
    modes = motion.modes
    return modes.disturbed(motion.forcing.pieces).reason(output) if modes.disturbed else modes.UNBOUNDED


def whenever(hint: str, other: str) -> str:
    """The hint of such a refusal of what repeats itself, so that nothing helps later on: `other` does."""
    return f"let {SLOWLY}, or {other}" if hint in (LATER, REASONS[SERIES][1]) else hint
