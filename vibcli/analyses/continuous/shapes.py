"""Shapes of modes along members: deflection and its derivatives anywhere, nodes and antinodes.

A mode is normalised to shapeᵀ ∂D/∂s² shape = 1: the sum of mass times displacement² over bodies and along members.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.piece import Piece

if TYPE_CHECKING:
    from vibcli.analyses.continuous.uniform_curves import UniformCurves

CLOSE = 1e-6        # part of a piece by which one stays away from its ends
FINE = 8            # places for each half-wave
LAYERS = np.array([0.25, 0.5, 1.0, 2.0, 4.0])       # of the length in which what begins at an end fades
STEPS, SETTLED = 60, 2.0**-27      # of the distance of places: a step as short leaves its square, which is rounding
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
    if len(pieces) == 1 or pieces[0].curves is not None:
        return pieces[0].along(places)
    which = _piece_at(pieces, places)
    start, kappa, ends = (np.array(values)[which] for values in zip(
        *((moved.start, moved.kappa, moved.ends) for moved in pieces), strict=True))
    piece = Piece(*(np.array(values)[which] for values in zip(*(moved.piece for moved in pieces), strict=True)))
    return fields(piece, kappa, ends, np.clip(places - start, 0.0, piece.length))


def resting_and_turning(pieces: Sequence[Moved]) -> tuple[list[float], list[float]]:
    """The nodes, places at which a member rests, its ends and supports not counted, and the places within it at which
    u is largest or least among those around them."""
    places = np.concatenate([_grid(moved) for moved in pieces])
    derivatives = _with_slopes(pieces, places)
    values = derivatives[:, :2].copy()
    alone = (values[1:-1] == 0) & (values[:-2] != 0) & (values[2:] != 0)
    values[1:-1] = np.where(alone, values[:-2], values[1:-1])       # a zero that is looked at lies right of that place
    of, turns = np.nonzero((values[:-1] * values[1:] < 0).T)
    supports = [moved.start for moved in pieces if moved.supported]
    held = [not which and any(places[at] < place < places[at + 1] for place in supports)
            for which, at in zip(of, turns, strict=True)]
    of, turns = of[np.logical_not(held)], turns[np.logical_not(held)]
    ends = [turns, turns + 1]
    found = _narrowed(pieces, of, places[ends], values[ends, of], derivatives[ends, of + 1])
    return found[of == 0].tolist(), found[of == 1].tolist()


def antinodes(pieces: Sequence[Moved], turning: Sequence[float]) -> list[float]:
    """The places at which a member moves more than beside them: |u| is largest there, at ends that are not held too;
    turning: its turning places."""
    return antinodes_and_displacements(pieces, turning, ())[0]


def antinodes_and_displacements(pieces: Sequence[Moved], turning: Sequence[float], at: Sequence[float]
                                ) -> tuple[list[float], np.ndarray]:
    """The antinodes, and u at further places, in one."""
    places = np.array([pieces[0].start, *turning, pieces[-1].start + pieces[-1].piece.length])
    aside = BESIDE * np.diff(places)
    looked_at = np.array([places, places - np.append(0.0, aside), places + np.append(aside, 0.0)])
    u = shape_along(pieces, np.append(looked_at, at))[:, 0]
    size, left, right = np.abs(u[:looked_at.size].real).reshape(looked_at.shape)
    moves = size > MOVES * size.max()
    above = [(size > (1 + ROUNDING) * beside) | (places == end) | (abs(size - beside) <= ROUNDING * size) & told
             for (beside, end), told in zip(((left, places[0]), (right, places[-1])), _by_slopes(pieces, places),
                                            strict=True)]
    return places[moves & above[0] & above[1]].tolist(), u[looked_at.size:]


def _by_slopes(pieces: Sequence[Moved], places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(whether |u| falls towards the left of each turning place, and towards the right), as slopes tell at ends."""
    u, slope, bend = _with_slopes(pieces, places)[:, :3].T
    falls = u * bend < 0
    left, right = falls.copy(), falls
    left[-1], right[0] = u[-1] * slope[-1] > 0, u[0] * slope[0] < 0
    return left, right


def _narrowed(pieces: Sequence[Moved], of: np.ndarray, ends: np.ndarray, values: np.ndarray,
              slopes: np.ndarray) -> np.ndarray:
    """The zeros of u, of = 0, and of u′, 1, between two ends each, (2, zeros), with these values and slopes there, by
    Newton steps that stay between them, from where a cubic of place by value is, that has these slopes."""
    (low, high), below = ends, values[0]
    found, short, moving = _between(ends, values, slopes), SETTLED * (high - low), np.arange(len(of))
    for _ in range(STEPS):
        if not len(moving):
            break
        place, number = found[moving], np.arange(len(moving))
        values = _with_slopes(pieces, place)
        value, slope = values[number, of], values[number, of + 1]
        same = value * below > 0
        low, high = np.where(same, place, low), np.where(same, high, place)
        with np.errstate(all="ignore"):
            step = place - value / slope
        found[moving] = np.where((step >= low) & (step <= high), step, (low + high) / 2)
        on = abs(found[moving] - place) > short
        moving, of, low, high, below, short = (kept[on] for kept in (moving, of, low, high, below, short))
    return found


def _between(ends: np.ndarray, values: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Where x(f) = 0 of Hermite's cubic by the values f at both ends and 1/f′; of the straight line where it leaves
    them."""
    (low, high), (below, above) = ends, values
    rise = above - below
    share = -below / rise
    with np.errstate(all="ignore"):
        one, other = rise / slopes - (high - low)
        found = low + share * (high - low) + share * (1 - share) * ((1 - share) * one - share * other)
    return cast("np.ndarray", np.where((found > low) & (found < high), found, low + share * (high - low)))


def _with_slopes(pieces: Sequence[Moved], places: np.ndarray) -> np.ndarray:
    """(u, u′, u″, …); of bars, shafts and strings u″ from (N u′)′ = κ u."""
    found = shape_along(pieces, places).real
    if found.shape[1] > 2:
        return found
    kappa, tension, gradient, start = np.array([(
        moved.kappa, moved.piece.tension, moved.piece.gradient, moved.start) for moved in pieces]).T[
            :, _piece_at(pieces, places)]
    with np.errstate(all="ignore"):     # an end without tension
        bend = (kappa * found[:, 0] - gradient * found[:, 1]) / (tension + gradient * (places - start))
    return np.column_stack([found, bend])


def _piece_at(pieces: Sequence[Moved], places: np.ndarray) -> np.ndarray:
    """The numbers of the pieces that places are on."""
    starts = np.array([moved.start for moved in pieces])
    return np.maximum(np.searchsorted(starts, places, side="right") - 1, 0)


def mean_tension(piece: Piece) -> Any:
    """N of a tension that varies evenly, so that ∫ dx/√N(x) = l/√N."""
    left, right = piece.tension, piece.tension + piece.gradient * piece.length
    return ((max(left, 0 * left)**0.5 + max(right, 0 * right)**0.5) / 2)**2 if piece.gradient else left


def _lengths(piece: Piece, q: float) -> tuple[float, float]:
    """(half-waves along a piece at most, the part of it in which what begins at an end fades, 0 where nothing does), by
    the roots of B β⁴ + N β² = q and B γ⁴ − N γ² = q, N the least tension, q what drives the motion per length and u."""
    if piece.order == 2:
        return np.sqrt(q / mean_tension(piece)) * piece.length / np.pi, 0.0
    N = min(piece.tension, piece.tension + piece.gradient * piece.length)
    larger = (abs(N) + np.hypot(N, 2 * np.sqrt(piece.bending) * np.sqrt(q))) / (2 * piece.bending)
    smaller = q / (piece.bending * larger) if larger else 0.0
    beta, gamma = np.sqrt([smaller, larger] if N > 0 else [larger, smaller])
    return beta * piece.length / np.pi, 1 / (gamma * piece.length) if N > 0 else 0.0


def _grid(moved: Moved) -> np.ndarray:
    """Places within a piece, several for each half-wave, close to its ends too."""
    piece = moved.piece
    waves, layer = _lengths(piece, max(-moved.kappa, 0.0))
    inner = np.linspace(CLOSE, 1 - CLOSE, int(FINE * (waves + 1)) + 2)
    if 0 < layer < 1 / FINE:
        within = layer * LAYERS[layer * LAYERS > CLOSE]
        inner = np.unique(np.concatenate([inner, within, 1 - within]))
    return cast("np.ndarray", moved.start + piece.length * inner)
