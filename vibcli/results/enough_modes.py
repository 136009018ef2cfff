"""How many modes a signal of a motion of members is read by: so many that what is left out is small, or the most that
are worth their time. Modes in closed form cost so little that values at instants take many more of them."""

from math import ceil, inf, log
from typing import TYPE_CHECKING, Any

from vibcli.analyses.continuous.rest_of_transfer import TooSlow
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.results.modal_response import ModalResponse

CLOSE = 8e-11       # of the largest value: a remainder that is small enough beside what else is in a bound of 1e-10
FINEST = {True: 81_920, False: 57_344}      # modes in closed form, and of others
MARGIN = 1.15       # modes more than a remainder needs
ROUGH, FEWER = 1e-6, 8      # of forces and rates, which fall so slowly: a small remainder, and a share of those modes
BLOCK = 512         # modes that are found together: a search takes up to ten counts for each


def first_modes(modes: "Modes", count: int) -> list[Any]:
    """The first modes, found block by block."""
    for last in range(BLOCK, count, BLOCK):
        modes.first(last)
    return modes.first(count)


def enough(response: "ModalResponse", motion: "ModalMotion", output: "LinearOutput") -> "ModalMotion":
    """The motion by so many modes that the remainder of an output is small, or by the most."""
    while 2 * motion.count <= response.most:
        try:
            if not motion.shows_more(output, CLOSE) and motion.left_share(output) <= CLOSE:
                break
        except TooSlow:
            pass
        try:
            motion = response.motion(2 * motion.count).under(motion.reads)
        except PhysicsError:        # frequencies that digits do not tell stand among so many
            break
    return motion


def finest(response: "ModalResponse", motion: "ModalMotion", output: "LinearOutput",
           t: float | None = None) -> "ModalMotion":
    """The motion by as many modes as leave a small remainder, at an instant or ever, as it falls from one doubling to
    the next, or by the most that are worth it; the same where more of them leave no less. Of forces and rates beyond
    closed forms fewer are, of damped modes no more."""
    limit, count, share, small = response.limit, 2 * motion.count, 0.0, CLOSE
    rough = not (response.closed or _is_displacement(output))
    if rough:
        limit, small = 0 if response.estimated else limit // FEWER, ROUGH
    if count <= limit:
        share = motion.left_share(output, t)
    if rough and share == inf:
        return motion
    while share > small and motion.count < count:
        try:
            further = response.motion(count).under(motion.reads)
            less = further.left_share(output, t)
        except PhysicsError:        # frequencies that digits do not tell stand among so many
            break
        if not less < share:
            break
        if not less:        # as exponentials of what is left out underflow
            return further
        power = log(share / less) / log(further.count / motion.count)
        motion, share = further, less
        count = min(ceil(MARGIN * motion.count * (share / small) ** (1 / power)), limit)
    return motion


def _is_displacement(output: "LinearOutput") -> bool:
    return not any((*output.v.values(), *output.a.values())) and all(
        not place.along and not place.rates for place, factor in output.places.items() if factor)
