"""How many modes a signal of a motion of members is read by: so many that what is left out is small, or the most that
are worth their time. Modes in closed form cost so little that values at instants take many more of them."""

from math import ceil, log
from typing import TYPE_CHECKING, Any

from vibcli.analyses.continuous.modal_motion import TooSlow
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.results.modal_response import ModalResponse

CLOSE = 1e-10       # of the largest value: a remainder that is small enough
FINEST = 65_536     # modes in closed form
BLOCK = 8_192       # modes that are found together


def first_modes(modes: "Modes", count: int) -> list[Any]:
    """The first modes, found block by block."""
    for last in range(BLOCK, count, BLOCK):
        modes.first(last)
    return modes.first(count)


def enough(response: "ModalResponse", motion: "ModalMotion", output: "LinearOutput") -> "ModalMotion":
    """The motion by so many modes that the remainder of an output is small, or by the most."""
    while 2 * motion.count <= response.most:
        try:
            if motion.left_share(output) <= CLOSE:
                break
        except TooSlow:
            pass
        try:
            motion = response.motion(2 * motion.count).under(motion.reads)
        except PhysicsError:        # frequencies that digits do not tell stand among so many
            break
    return motion


def finest(response: "ModalResponse", motion: "ModalMotion", output: "LinearOutput") -> "ModalMotion":
    """The motion by as many modes in closed form as leave a small remainder, if these are not too many as it falls from
    one doubling to the next; else the same."""
    if not response.closed or 4 * motion.count > FINEST:
        return motion
    share, further = motion.left_share(output), response.motion(2 * motion.count).under(motion.reads)
    less = further.left_share(output) if share > CLOSE else 0.0
    while CLOSE < less < share:
        doublings = ceil(log(less / CLOSE) / log(share / less))
        if further.count << doublings > FINEST:
            break
        motion, share = further, less
        further = response.motion(further.count << doublings).under(motion.reads)
        less = further.left_share(output)
    return further if less <= CLOSE < share else motion
