"""A motion as accurate as is asked, with what is known of its error: two solutions, and what its data leave.

The error of each place and velocity, relative to how far it goes, is estimated as for signals (signal_error.py); what
an accuracy is asked of is relative to the largest value where that is less, half of that distance at least.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.analyses.time_integration.agreement import Shared
from vibcli.analyses.time_integration.deviations import deviations
from vibcli.analyses.time_integration.integrate import BALANCED, Unbalanced, solved, solved_again
from vibcli.analyses.time_integration.prepared_motion import PreparedMotion

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.mechanics.configuration import Configuration

ASKED = 1e-9            # unless another accuracy is
FINE, FINEST = 1e-12, 1e-13     # the error of a step that is tried in the end; that of the finest motions
ADDED = 4e3             # errors of a step, that add up to what is said of one of the motion
SPARE, HOPELESS = 0.3, 1e-3     # of the error that may be left where a step is tightened; where the finest is tried


def known_motion(configuration: "Configuration", until: float, initial: Mapping[str, float] | None = None,
                 accuracy: float | None = None) -> "Trajectory":
    """The Trajectory that `simulate` gives, as far as a second solution shares it. accuracy: up to where its error is
    less than that alone; None: to ASKED where floats have that, and as far as three digits are known."""
    motion, asked = PreparedMotion(configuration, until, initial), accuracy or ASKED
    rtol = FINE if accuracy is None else max(accuracy / ADDED, FINEST)
    least = min(FINE, rtol)
    while True:
        try:
            found, shared = _twice(motion, rtol, asked, accuracy)
        except Unbalanced:
            if rtol <= least:
                raise
            rtol = least
            continue
        if shared.largest <= asked or rtol <= least or not found.coarse:      # collocation is as fine anyhow
            break
        part = asked / shared.largest
        rtol = max(SPARE * part * rtol, least) if part > HOPELESS else least
    found.share(shared.beside(deviations(found, initial, motion.units)))
    return found


def _twice(motion: PreparedMotion, rtol: float, asked: float, accuracy: float | None) -> "tuple[Trajectory, Shared]":
    """(its Trajectory, the Shared with a second one), by steps whose error is so large."""
    found = solved(motion, rtol, max(BALANCED, asked))
    if not found.end > 0:
        raise found.unknown(0.0)
    return found, Shared(found, solved_again(motion, found, rtol), motion.units, accuracy)
