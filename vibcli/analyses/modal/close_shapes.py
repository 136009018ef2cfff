"""Shapes of modes whose frequencies are close: in floats each is a mix of both, by the rounding of the data over the
gap (Davis & Kahan 1970), so they are found in more digits; those of one frequency may be mixed as one likes."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.undamped import Mode
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis

NEAR, ONE, DIGITS = 1e-4, 1e-25, 40     # relative gap of frequencies below which shapes lose digits; of one frequency
CLOSE = 1e-2        # the same of members, whose shapes may lose digits:
MIXED = 1e-11       # this part of its neighbour, the bound of its frequency over the gap, is not seen
MORE = 20           # digits that tell them apart


def told_apart(modal: "ModalAnalysis", mode: Any) -> Any:
    """A mode of lumped bodies with its shape in floats, a Mode of members in more digits, where another frequency is
    that close; those of members that floats do not tell apart have been found in more."""
    motion = getattr(mode, "motion", None)
    if motion is None:
        return _of_bodies(modal, mode)
    if motion.system.digits is not None or not mode.omega:
        return mode
    beside = modal.modes.numbered(max(mode.index - 1, 1), mode.index + 1)
    gaps = [abs(float(other.omega or 0.0) / mode.omega - 1) for other in beside if other.index != mode.index]
    if not any(gap < min(CLOSE, float(mode.error) / MIXED) for gap in gaps):
        return mode
    try:
        return modal.modes_to(MORE).alone(mode.index)
    except PhysicsError:        # the data have no more digits than floats
        return mode


def _of_bodies(modal, mode):
    if not isinstance(mode, Mode) or not isinstance(mode.omega, float) or not mode.omega or modal.many or (
            not _is_close(modal.modes, mode, NEAR)):
        return mode
    try:
        precise = modal.modes_to(DIGITS)
    except PhysicsError:
        return mode
    found = precise.numbered(mode.index, mode.index)
    if not found or _is_close(precise, found[0], ONE):
        return mode
    shape = np.array([complex(x) for x in found[0].shape])
    return mode._replace(shape=shape if shape.imag.any() else shape.real)


def _is_close(modes, mode, gap):
    beside = modes.numbered(max(mode.index - 1, 1), mode.index + 1)
    return any(other.index != mode.index and abs((other.omega or 0) / mode.omega - 1) < gap for other in beside)
