"""Shapes of modes whose frequencies are close: in floats each is a mix of both, by the rounding of the data over the
gap (Davis & Kahan 1970), so they are found in more digits; those of one frequency may be mixed as one likes."""

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_modes import DampedMode
from vibcli.analyses.modal.method import CERTIFIABLE, CERTIFIABLE_SQUARES
from vibcli.analyses.modal.undamped import Mode
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.analyses.modal.mode_sequence import Modes

NEAR, ONE, DIGITS = 1e-4, 1e-25, 40     # relative gap of frequencies below which shapes lose digits; of one frequency
COINCIDING, BESIDE = 4e-16, 3       # gap of eigenvalues in floats; modes of members after one that may be close to it
ALIKE = 1e-13       # of frequencies that floats do not tell apart
KNOWN = 1e12        # gap over the error of an eigenvalue, from which on a shape is known
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


def _of_bodies(modal: "ModalAnalysis", mode: DampedMode | Mode) -> DampedMode | Mode:
    if isinstance(mode, DampedMode):
        return _damped(modal, mode)
    if not isinstance(mode, Mode) or not isinstance(mode.omega, float) or not mode.omega or (
            len(modal.scene.q) > CERTIFIABLE_SQUARES or _gap(modal.modes, mode) >= NEAR):
        return mode
    try:
        precise = modal.modes_to(DIGITS)
    except PhysicsError:
        return mode
    found = precise.numbered(mode.index, mode.index)
    if not found or _gap(precise, found[0]) < ONE:
        return mode
    shape = np.array([complex(x) for x in found[0].shape])
    return mode._replace(shape=shape if shape.imag.any() else shape.real)


def _damped(modal: "ModalAnalysis", mode: DampedMode) -> DampedMode:
    if modal.scene.pieces or not isinstance(mode.eigenvalue, complex) or len(modal.scene.q) > CERTIFIABLE or not (
            mode.omega and _eigenvalue_gap(modal.damped, mode) < NEAR):
        return mode
    try:
        precise = modal.damped_to(DIGITS)
    except PhysicsError:
        return mode
    found = min(precise.numbered(mode.index, mode.index), key=lambda other: abs(other.eigenvalue - mode.eigenvalue))
    if _eigenvalue_gap(precise, found) < max(ONE, KNOWN * found.error):
        return mode
    return mode.numbered(mode.index, np.array([complex(x) for x in found.shape]))


def apart(modal: "ModalAnalysis", mode: "DampedMode | Mode") -> float:
    """The gap of the eigenvalue of a mode, 1 of a natural one that is told in more digits or may be mixed;
    PhysicsError where two damped ones coincide, in more digits too."""
    return _natural_gap(modal, mode) if isinstance(mode, Mode) else _damped_gap(modal, mode.index)


def _damped_gap(modal: "ModalAnalysis", number: int) -> float:
    modes, (mode, *_), least = modal.damped, modal.damped.numbered(number, number), 0.0
    if not mode.omega:
        return 1.0
    away = _eigenvalue_gap(modes.shown() if modes.finite else modes.first(number + BESIDE), mode)
    if away > 2 * mode.error + COINCIDING:
        return away
    with suppress(PhysicsError):
        precise = modal.damped_to(DIGITS)
        found, *_ = precise.numbered(number, number)
        away, least = _eigenvalue_gap(precise, found), max(ONE, 2 * found.error)
    if away <= least or not least:
        raise PhysicsError(f"damped mode {number} coincides with another one: any mix of their shapes is one",
                           "see `vibcli frequencies` for the eigenvalues")
    return float(away)


def _eigenvalue_gap(modes: "Sequence[Any]", mode: DampedMode) -> "float | mpmath.mpf":
    """How far an eigenvalue is from that of any other mode, conjugates included, in parts of it."""
    size = abs(mode.eigenvalue)
    return min((abs(mode.eigenvalue - value) / size for other in modes if other.index != mode.index
                for value in (other.eigenvalue, other.eigenvalue.conjugate())), default=1.0)


def _natural_gap(modal: "ModalAnalysis", mode: Mode) -> float:
    """Of so many coordinates that floats alone tell shapes."""
    if len(modal.scene.q) <= CERTIFIABLE_SQUARES or modal.scene.pieces or not (
            isinstance(mode.omega, float) and mode.omega):
        return 1.0
    away = float(_gap(modal.modes, mode))
    return away if away > ALIKE else 1.0


def _gap(modes: "Modes", mode: Mode) -> float:
    """How far the next frequency is, in parts of it."""
    beside = modes.numbered(max(mode.index - 1, 1), mode.index + 1)
    return min((abs((other.omega or 0) / mode.omega - 1) for other in beside if other.index != mode.index), default=1.0)
