"""Shapes of modes along members: deflection and its derivatives anywhere, nodes and antinodes.

A mode is normalised to shapeᵀ ∂D/∂s² shape = 1: the sum of mass times displacement² over bodies and along members.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from vibcli.numerics.pieces.fields import fields

if TYPE_CHECKING:
    from vibcli.analyses.continuous.uniform_curves import UniformCurves
    from vibcli.numerics.pieces.piece import Piece

CLOSE = 1e-6        # part of a piece by which one stays away from its ends
FINE = 8            # places for each half-wave
STEPS, SETTLED = 60, 4e-16
BESIDE, MOVES, ROUNDING = 1e-3, 1e-9, 1e-12     # of the way to the next turning place; of |u|, of the largest one


class Moved(NamedTuple):
    """A piece of a member from the place `start` on, in motion: κ = k − μ ω², its end values, and whether the member
    cannot be displaced where it begins; curves: the closed form along the whole member, where there is one."""

    start: float
    piece: "Piece"
    kappa: float
    ends: np.ndarray
    supported: bool
    curves: "UniformCurves | None" = None

    def along(self, x: Any) -> np.ndarray:
        """(u, u′) of bars, shafts and strings, (u, u′, u″, u‴) of beams at places x of the member, (…, order)."""
        if self.curves is not None:
            return self.curves.along(x)
        return fields(self.piece, self.kappa, self.ends, np.clip(np.asarray(x) - self.start, 0.0, self.piece.length))


def shape_along(pieces: Sequence[Moved], x: Any) -> np.ndarray:
    """(u, u′) or (u, u′, u″, u‴) at places x of a member, (…, order): at a jump that on the right, at the right end
    that on its left."""
    places = np.asarray(x, float)
    which = _piece_at(pieces, places)
    found = np.zeros((*places.shape, pieces[0].piece.order), pieces[0].ends.dtype)
    for number in np.unique(which):
        chosen = which == number
        found[chosen] = pieces[number].along(places[chosen])
    return found


def nodes(pieces: Sequence[Moved]) -> list[float]:
    """The places at which a member rests, its ends and supports not counted."""
    return crossings(pieces, 0, [moved.start for moved in pieces if moved.supported])


def turning_places(pieces: Sequence[Moved]) -> list[float]:
    """The places within a member at which u is largest or least among those around them."""
    return crossings(pieces, 1, [])


def antinodes(pieces: Sequence[Moved]) -> list[float]:
    """The places at which a member moves more than beside them: |u| is largest there, at ends that are not held too."""
    places = np.array([pieces[0].start, *turning_places(pieces), pieces[-1].start + pieces[-1].piece.length])
    aside = BESIDE * np.diff(places)
    size, left, right = (np.abs(shape_along(pieces, at)[:, 0].real) for at in (
        places, places - np.append(0.0, aside), places + np.append(aside, 0.0)))
    moves = size > MOVES * size.max()
    above = [(size > (1 + ROUNDING) * beside) | (places == end) for beside, end in (
        (left, places[0]), (right, places[-1]))]
    return places[moves & above[0] & above[1]].tolist()


def crossings(pieces: Sequence[Moved], derivative: int, left_out: Sequence[float]) -> list[float]:
    """The places within a member where u or u′ changes its sign, but for those left out."""
    places = np.concatenate([_grid(moved) for moved in pieces])
    values = shape_along(pieces, places)[:, derivative].real
    large = values[np.abs(values).argmax()] if len(values) else 0.0
    if not large:
        return []
    turns = np.flatnonzero(values[:-1] * values[1:] < 0)
    low, high, below = places[turns], places[turns + 1], values[turns]
    kept = [not any(a < place < b for place in left_out) for a, b in zip(low, high, strict=True)]
    low, high, below = low[kept], high[kept], below[kept]
    return _narrowed(pieces, derivative, low, high, below).tolist()


def _narrowed(pieces, derivative, low, high, below):
    """The zeros of u or u′ between places, by Newton steps that stay between them; below: the values at `low`."""
    place = (low + high) / 2
    for _ in range(STEPS if len(place) else 0):
        value, slope = _with_slope(pieces, derivative, place)
        same = value * below > 0
        low, high = np.where(same, place, low), np.where(same, high, place)
        with np.errstate(all="ignore"):
            step = place - value / slope
        place, before = np.where((step >= low) & (step <= high), step, (low + high) / 2), place
        if (abs(place - before) <= SETTLED * abs(place)).all():
            break
    return place


def _with_slope(pieces, derivative, places):
    """u or u′ and its slope; u″ = κ u / N of bars, shafts and strings."""
    found = shape_along(pieces, places).real
    if derivative + 1 < found.shape[1]:
        return found[:, derivative], found[:, derivative + 1]
    ratios = np.array([moved.kappa / moved.piece.tension for moved in pieces])
    return found[:, derivative], found[:, 0] * ratios[_piece_at(pieces, places)]


def _piece_at(pieces, places):
    """The numbers of the pieces that places are on."""
    starts = np.array([moved.start for moved in pieces])
    return np.maximum(np.searchsorted(starts, places, side="right") - 1, 0)


def _grid(moved):
    """Places within a piece, several for each half-wave, close to its ends too."""
    piece = moved.piece
    stiffness = piece.bending or piece.tension
    waves = (max(-moved.kappa, 0.0) / stiffness) ** (1 / piece.order) * piece.length / np.pi
    if piece.order == 4 and piece.tension < 0:
        waves += np.sqrt(-piece.tension / piece.bending) * piece.length / np.pi
    inner = np.linspace(CLOSE, 1 - CLOSE, int(FINE * (waves + 1)) + 2)
    return moved.start + piece.length * inner
