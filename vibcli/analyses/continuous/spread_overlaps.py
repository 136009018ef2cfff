"""How far loads go where they act, ∫ p u dx: those on coordinates and those spread along members.

Between nodes that rest, where κ is far above all else in P of a load p on a stretch, u = w + what brings the ends to
rest, P w = p, so that by reciprocity

    ∫ p̂ u dx = ∫ p̂ w dx − (∫ p̂ H dx)ᵀ (w, w′ at the ends)

and elsewhere, where waves are not much shorter than the load, by Gauss's rule.
"""

from itertools import combinations_with_replacement, pairwise
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.polynomial import polynomial

from vibcli.analyses.continuous.unit_responses import overlaps
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.loads import LoadForm, end_loads, loaded_fields, particular
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.loads import LoadStretch
    from vibcli.numerics.pieces.piece import Piece

TINY = 1e-12        # of a length
NEARER = 1e3        # times as near κ is where w is a finite sum


class OnPiece(NamedTuple):
    """Unit loads on a piece at m places s: what each puts on its ends, (slots, order, m), and ∫ p u dx of all pairs
    while these rest, (slots, slots, m)."""

    ends: np.ndarray
    held: np.ndarray


class UnitLoadsOfChannels:
    """Unit loads on channels of an ExactTransfer, and unit displacements of its driven ends."""

    def __init__(self, transfer: "ExactTransfer") -> None:
        self.pieces, self.n, first = transfer.pieces, transfer.n, transfer.n + len(transfer.driven)
        self.driven = dict(enumerate(transfer.driven, transfer.n))
        self.spread = dict(enumerate(transfer.spread, first))

    def takes(self, channel: int) -> bool:
        """Is it one on coordinates, a driven end, or along pieces of one tension each, or a polynomial of the place?"""
        if channel not in self.spread:
            return True
        forms = [self.spread[channel].on(one) for one in self.pieces if one.piece.gradient]
        return all(_is_polynomial(form) for form in forms if form is not None)

    def on_pieces(self, channels: "Sequence[int]", s: np.ndarray) -> dict[int, OnPiece]:
        """Of each piece with a load along it."""
        found = {}
        for number, one in enumerate(self.pieces):
            forms, kappa = self.on(channels, one), one.piece.reaction(s)
            ends = np.zeros((len(channels), one.piece.order, len(s)), complex)
            held = np.zeros((len(channels), len(channels), len(s)), complex)
            for i, form in forms:
                ends[i] = end_loads(one.piece, kappa, form).T
            for (i, a), (j, b) in combinations_with_replacement(forms, 2):
                held[i, j] = held[j, i] = held_overlap(one.piece, kappa, a, b)
            if forms:
                found[number] = OnPiece(ends, held)
        return found

    def on(self, channels: "Sequence[int]", one: "PlacedPiece") -> "list[tuple[int, LoadForm]]":
        """[(slot, load)] of those along a piece."""
        found = [(i, self.spread[c].on(one)) for i, c in enumerate(channels) if c in self.spread]
        return [(i, form) for i, form in found if form is not None]

    def massive(self, channels: "Sequence[int]", inverse: np.ndarray) -> np.ndarray:
        """bᵀ M⁻¹ b of all pairs, (channels, channels), `inverse`: that of coordinates; 0 where nothing has mass."""
        found, light = np.zeros((len(channels), len(channels))), np.zeros(len(channels), bool)
        plain = np.flatnonzero([c < self.n for c in channels])
        own = np.array(channels)[plain]
        found[plain[:, None], plain] = inverse[own[:, None], own]
        for one in self.pieces:
            on = self.on(channels, one)
            at = np.array([i for i, _ in on], int)
            if one.piece.inertia:
                found[at[:, None], at] += overlaps([form for _, form in on]) / one.piece.inertia
            else:
                light[at] = True
        found[light] = found[:, light] = 0.0
        return found


def held_overlap(piece: "Piece", kappa: np.ndarray, first: LoadForm, second: LoadForm) -> np.ndarray:
    """∫ p̂ u dx of the first where the second bends a piece of one tension between ends that rest, (number of κ,)."""
    half, edges, found = piece.order // 2, _edges(piece, (first, second)), 0 * kappa
    inner = half * (len(edges) - 2)
    D, loads = (np.zeros((*sizes, inner), complex) for sizes in ((len(kappa), inner), (2, len(kappa))))
    for number, (low, high) in enumerate(pairwise(edges)):
        part = piece._replace(length=high - low, tension=piece.tension + piece.gradient * low)
        cut = [form.on(low, high) for form in (first, second)]
        found = found + _on_stretch(part, kappa, *cut)
        nodes = half * (number - 1) + np.arange(piece.order)
        ends = np.flatnonzero((nodes >= 0) & (nodes < inner))
        at = nodes[ends]
        D[:, at[:, None], at] += stiffness(part, kappa)[:, ends[:, None], ends]
        for side, form in enumerate(cut):
            loads[side][:, at] += end_loads(part, kappa, form)[:, ends]
    return cast("np.ndarray", found + (loads[0] * np.linalg.solve(D, loads[1][..., None])[..., 0]).sum(axis=1))


def _edges(piece: "Piece", forms: tuple[LoadForm, LoadForm]) -> list[float]:
    """The ends of a piece, and where stretches begin or end between them."""
    found = [0.0]
    for x in sorted({float(x) for form in forms for one in form.stretches for x in (one.start, one.end)}):
        if found[-1] + TINY * piece.length < x < (1 - TINY) * piece.length:
            found.append(x)
    return [*found, float(piece.length)]


def _on_stretch(piece: "Piece", kappa: np.ndarray, first: LoadForm, second: LoadForm) -> np.ndarray:
    """The same where both have one stretch, or none."""
    found = 0 * kappa
    if not first.stretches or not second.stretches:
        return found
    far = _are_far(piece, kappa, second)
    for chosen, integral in ((far, _by_ends), (~far, _by_places)):
        if chosen.any():
            found[chosen] = integral(piece, kappa[chosen], first, second)
    return found


def _is_polynomial(form: LoadForm) -> bool:
    return not any(term.exponent for one in form.stretches for term in one.terms)


def _are_far(piece: "Piece", kappa: np.ndarray, form: LoadForm) -> np.ndarray:
    """Is κ far above all else in P at all of its stretches? Where the tension varies w is known of polynomials, for
    which it need not be as far."""
    if not piece.gradient:
        return np.asarray(np.all([one.is_far(piece, kappa) for one in form.stretches], axis=0))
    most = max(abs(piece.tension), abs(piece.tension + piece.gradient * piece.length))
    even = piece._replace(tension=most, gradient=0.0)
    far = np.all([one.is_far(even, NEARER * kappa) for one in form.stretches], axis=0)
    return np.asarray(far & _is_polynomial(form))


def _of_polynomial(piece: "Piece", kappa: np.ndarray, one: "LoadStretch", x: np.ndarray) -> np.ndarray:
    """w, w′ of a polynomial p, (2, …): w = (1 − L/κ + L²/κ² …) p/κ with L w = B w⁗ − ((N + n x) w′)′, which lowers its
    degree."""
    powers = np.zeros(1)
    for term in one.terms:
        powers = polynomial.polyadd(powers, np.append(np.zeros(term.power), complex(term.coefficient).real))
    tension = np.array([piece.tension + piece.gradient * one.origin, piece.gradient])
    w, share = np.zeros((2, *np.broadcast_shapes(kappa.shape, np.shape(x))), complex), 1 / kappa
    while powers.any():
        slope = polynomial.polyder(powers)
        w = w + share * np.array([polynomial.polyval(x - one.origin, part) for part in (powers, slope)])[:, None]
        bent = piece.bending * polynomial.polyder(powers, 4)
        powers = polynomial.polysub(bent, polynomial.polyder(polynomial.polymul(tension, slope)))
        share = -share / kappa
    return w


def _rule(piece: "Piece", kappa: np.ndarray, forms: tuple[LoadForm, LoadForm]) -> tuple[np.ndarray, np.ndarray]:
    """Places, weights and the first load at these."""
    numbers = arithmetic_of(0.0)
    y, weights = panel_rule(piece, kappa, sum(max(one.pace for one in form.stretches) for form in forms), numbers)
    x = piece.length * y
    return x, piece.length * weights * sum(one.at(x, numbers) for one in forms[0].stretches)


def _by_ends(piece: "Piece", kappa: np.ndarray, first: LoadForm, second: LoadForm) -> np.ndarray:
    x, loads = _rule(piece, np.zeros(1), (first, second))
    half, ends = piece.order // 2, np.array([0.0, piece.length])
    bent = _of_polynomial if piece.gradient else particular
    inside, w = (np.sum([bent(piece, kappa[:, None], one, at) for one in second.stretches], axis=0)
                 for at in (x, ends))
    moved = np.moveaxis(w[:half], 0, -1).reshape(len(kappa), piece.order)
    return cast("np.ndarray", (inside[0] * loads).sum(axis=-1) - (end_loads(piece, kappa, first) * moved).sum(axis=-1))


def _by_places(piece: "Piece", kappa: np.ndarray, first: LoadForm, second: LoadForm) -> Any:
    x, loads = _rule(piece, kappa, (first, second))
    return sum(load * loaded_fields(piece, kappa, second, place)[..., 0] for place, load in zip(x, loads, strict=True))
