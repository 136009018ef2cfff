"""What a motion starts with, in modes: η = Σ φᵀ M q + Σ ∫ μ φ u dx.

Of a shape that springs and pieces at rest take under forces r it is φᵀ r/ω² (Betti). Of fields u = Σ Re c xᵏ e^{λx} it
is by Green's identity, as of loads, or by Gauss's rule.
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.excitation.load_forms import load_form
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.integrals import product_integral
from vibcli.numerics.pieces.loads import bracket, end_loads
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from collections.abc import Iterable

    from vibcli.analyses.continuous.mode_basis import ModeBasis, ModesOnPart
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.loads import LoadForm, LoadStretch

NEAR = 1e-12        # of a length
BLOCK = 64          # modes whose integrals are taken at a time


def of_field(basis: "ModeBasis", piece: int, given: "Forcing", channel: int) -> np.ndarray:
    """μ ∫ φ u dx of each mode over a piece, u being a channel of a Forcing over x."""
    whole = basis.placed[piece].piece
    return cast("np.ndarray", whole.inertia * of_load(basis, piece, load_form(given, channel, whole.length)))


def of_drive(basis: "ModeBasis", drive: "SpreadDrive") -> np.ndarray:
    """∫ φ f dx of each mode over a member."""
    found = np.zeros(basis.shapes.shape[1], basis.shapes.dtype)
    for number, placed in enumerate(basis.placed):
        form = drive.on(placed)
        if form is not None:
            found += of_load(basis, number, form)
    return found


def of_load(basis: "ModeBasis", piece: int, form: "LoadForm") -> np.ndarray:
    """∫ φ f dx of each mode over a piece."""
    found = np.zeros(basis.shapes.shape[1], basis.shapes.dtype)
    for part in basis.parts[piece]:
        for one in form.stretches:
            a, b = max(one.start, part.start), min(one.end, part.start + part.piece.length)
            if b > a and one.terms:
                found[part.modes] += _integrals(part, one._replace(start=a, end=b))
    return found


def of_held_shape(basis: "ModeBasis", piece: int, drive: "SpreadDrive") -> np.ndarray:
    """μ ∫ φ w dx of each mode over a piece, which a load f bends by w at rest while its ends are held:
    (k − κ) ∫ φ w dx is ∫ φ f dx less the work of what f puts on the ends (Betti). Not finite where κ is k."""
    placed = basis.placed[piece]
    whole, half, form = placed.piece, placed.piece.order // 2, drive.on(placed)
    if form is None:
        return np.zeros(basis.shapes.shape[1], basis.shapes.dtype)
    put, found = end_loads(whole, np.float64(whole.foundation), form), of_load(basis, piece, form)
    gaps = np.ones(len(found), found.dtype)
    for part in basis.parts[piece]:
        gaps[part.modes] = whole.foundation - part.kappa
        if part.start <= NEAR * whole.length:
            found[part.modes] -= part.ends[:, :half] @ put[:half]
        if part.start + part.piece.length >= (1 - NEAR) * whole.length:
            found[part.modes] -= part.ends[:, half:] @ put[half:]
    with np.errstate(all="ignore"):
        return cast("np.ndarray", whole.inertia * found / gaps)


def at_rest(basis: "ModeBasis", piece: int, q: np.ndarray, drives: "Iterable[SpreadDrive]") -> np.ndarray:
    """μ ∫ φ u dx of each mode over a piece that coordinates bend by its ends, and loads besides; not finite where
    nothing holds what a load bends."""
    ends = np.array([sum(x * q[i] for i, x in row.items() if i < len(q)) for row in basis.placed[piece].rows])
    found = of_shape(basis, piece, ends)
    for drive in drives:
        found = found + of_held_shape(basis, piece, drive)
    return found


def of_shape(basis: "ModeBasis", piece: int, ends: np.ndarray) -> np.ndarray:
    """μ ∫ φ u dx of each mode over a piece at rest with these end values."""
    whole = basis.placed[piece].piece
    found = np.zeros(basis.shapes.shape[1], basis.shapes.dtype)
    if not np.any(ends):
        return found
    rest, half = whole.foundation, whole.order // 2
    for part in basis.parts[piece]:
        one = part.piece
        left, right = fields(whole, rest, ends, np.array([part.start, min(part.start + one.length, whole.length)]))
        own = np.concatenate([left[:half], right[:half]])
        force = stiffness(one, np.float64(rest)) @ own
        gap, stiff = part.kappa - rest, np.abs(force).max() / np.abs(own).max() / one.length
        far = np.abs(gap) > stiff
        with np.errstate(all="ignore"):
            values = (part.forces() @ own - part.ends @ force) / gap
        found[part.modes] += np.where(far, values, 0.0)
        for k in np.flatnonzero(~far):
            found[part.modes[k]] += product_integral(one, part.kappa[k], part.ends[k], rest, own)
    return cast("np.ndarray", whole.inertia * found)


def _integrals(part: "ModesOnPart", one: "LoadStretch") -> np.ndarray:
    """∫ φ f dx over a LoadStretch, (modes,)."""
    piece, far = part.piece, one.is_far(part.piece, part.kappa)
    found, length = np.zeros(len(part.modes), part.ends.dtype), one.end - one.start
    for x, sign in ((one.end, 1.0), (one.start, -1.0)) if far.any() else ():
        phi = fields(piece, part.kappa[far], part.ends[far], np.clip(x - part.start, 0.0, piece.length))
        found[far] += sign * bracket(piece, part.kappa[far], phi, one, x)
    near = np.flatnonzero(~far)
    for i in range(0, len(near), BLOCK):
        at = near[i:i + BLOCK]
        cut = piece._replace(length=length)
        numbers = arithmetic_of(*cut, part.kappa)
        y, weights = panel_rule(cut, part.kappa[at], one.pace, numbers)
        x = one.start + length * y
        found[at] = _summed(part, at, x - part.start, weights * one.at(x, numbers) * length, numbers)
    return found


def _summed(part: "ModesOnPart", modes: np.ndarray, x: np.ndarray, weights: np.ndarray,
            numbers: "Arithmetic") -> np.ndarray:
    """Σ weights · φ over places x of a piece: of strings of varying tension by the fields that have one end value 1
    each."""
    kappa, ends = part.kappa[modes], part.ends[modes]
    if part.piece.gradient and part.piece.order == 2:
        from vibcli.numerics.pieces.graded import graded_integrals

        return cast("np.ndarray", (ends * graded_integrals(part.piece, kappa, x, weights, numbers)).sum(axis=-1))
    return cast("np.ndarray", weights @ fields(part.piece, kappa, ends, x[:, None])[..., 0])
