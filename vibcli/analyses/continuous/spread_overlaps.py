"""How far loads go where they act, ∫ p u dx: those on coordinates and those spread along members.

Between nodes that rest, where κ is far above all else in P of a load p on a stretch, u = w + what brings the ends to
rest, P w = p, so that by reciprocity

    ∫ p̂ u dx = ∫ p̂ w dx − (∫ p̂ H dx)ᵀ (w, w′ at the ends)

and elsewhere, where waves are not much shorter than the load, by Gauss's rule.
"""

from itertools import combinations_with_replacement, pairwise
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.unit_responses import overlaps
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.loads import LoadForm, end_loads, loaded_fields, particular
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.numerics.pieces.piece import Piece

TINY = 1e-12        # of a length


class UnitLoadsOfChannels:
    """Unit loads on channels of an ExactTransfer, and unit displacements of its driven ends."""

    def __init__(self, transfer: "ExactTransfer"):
        self.pieces, self.n, first = transfer.pieces, transfer.n, transfer.n + len(transfer.driven)
        self.driven = dict(enumerate(transfer.driven, transfer.n))
        self.spread = dict(enumerate(transfer.spread, first))

    def takes(self, channel: int) -> bool:
        """Is it one on coordinates, a driven end, or one along pieces of one tension each?"""
        if channel not in self.spread:
            return True
        return not any(one.piece.gradient for one in self.pieces if self.spread[channel].on(one) is not None)

    def put(self, channels: "Sequence[int]", s: np.ndarray) -> np.ndarray:
        """What each puts on coordinates, (channels, n, number of s); of driven ends nothing."""
        unit = np.repeat(np.eye(self.n + len(self.driven), self.n)[:, :, None], len(s), axis=2)
        return np.array([self.spread[c].put(self.pieces, s, self.n).T if c in self.spread else unit[c]
                         for c in channels])

    def between(self, channels: "Sequence[int]", s: np.ndarray) -> np.ndarray:
        """∫ p u dx of all pairs while the ends of pieces rest, (channels, channels, number of s)."""
        found = np.zeros((len(channels), len(channels), len(s)), complex)
        for one in self.pieces:
            for (i, a), (j, b) in combinations_with_replacement(self._on(channels, one), 2):
                found[i, j] = found[j, i] = found[i, j] + held_overlap(one.piece, one.piece.reaction(s), a, b)
        return found

    def shown(self, channels: "Sequence[int]", s: np.ndarray, H: np.ndarray) -> np.ndarray:
        """How far the answer to each goes where each load acts, and each driven end: (channels, answers, number of s),
        H (n, answers, number of s) what coordinates answer."""
        found = np.einsum("ais,ibs->abs", self.put(channels, s), H) + self.between(channels, s)
        for b, channel in enumerate(channels):
            if channel in self.driven:
                piece, end = self.driven[channel]
                found[b, b] += 1.0
                for a, load in enumerate(channels):
                    loads = self.spread[load].end_loads(self.pieces[piece], s) if load in self.spread else None
                    found[a, b] += 0.0 if loads is None else loads[:, end]
        return found

    def drawn(self, channels: "Sequence[int]", s: np.ndarray, H: np.ndarray, shown: np.ndarray) -> np.ndarray:
        """What each load is where it acts, and the force at each driven end, in the answer to each: (answers, channels,
        number of s). A load of unit size draws at an end minus how far this drives it."""
        found = np.repeat(np.eye(len(channels))[:, :, None], len(s), axis=2) + 0j
        for a, channel in enumerate(channels):
            if channel not in self.driven:
                continue
            drive = self.driven[channel]
            one = self.pieces[drive.piece]
            own = stiffness(one.piece, one.piece.reaction(s))[:, drive.end]
            for b, other in enumerate(channels):
                found[b, a] = -shown[b, a] if other not in self.driven else self._at_end(
                    one, own, drive.piece, self.driven[other], H[:, b])
        return found

    def _at_end(self, one, stiff, piece, moved, q):
        """The force at an end of a piece of a row of D while a driven end moves."""
        found = stiff[:, moved.end] if moved.piece == piece else 0.0
        for k, row in enumerate(one.rows):
            for i, x in row.items():
                found = found + x * stiff[:, k] * q[i] if i < self.n else found
        return found

    def _on(self, channels, one):
        found = [(i, self.spread[c].on(one)) for i, c in enumerate(channels) if c in self.spread]
        return [(i, form) for i, form in found if form is not None]

    def massive(self, channels: "Sequence[int]", inverse: np.ndarray) -> np.ndarray:
        """bᵀ M⁻¹ b of all pairs, (channels, channels), `inverse`: that of coordinates; 0 where nothing has mass."""
        found, light = np.zeros((len(channels), len(channels))), np.zeros(len(channels), bool)
        plain = np.flatnonzero([c < self.n for c in channels])
        own = np.array(channels)[plain]
        found[plain[:, None], plain] = inverse[own[:, None], own]
        for one in self.pieces:
            on = self._on(channels, one)
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
        part, cut = piece._replace(length=high - low), [form.on(low, high) for form in (first, second)]
        found = found + _on_stretch(part, kappa, *cut)
        nodes = half * (number - 1) + np.arange(piece.order)
        ends = np.flatnonzero((nodes >= 0) & (nodes < inner))
        at = nodes[ends]
        D[:, at[:, None], at] += stiffness(part, kappa)[:, ends[:, None], ends]
        for side, form in enumerate(cut):
            loads[side][:, at] += end_loads(part, kappa, form)[:, ends]
    return found + (loads[0] * np.linalg.solve(D, loads[1][..., None])[..., 0]).sum(axis=1)


def _edges(piece, forms):
    """The ends of a piece, and where stretches begin or end between them."""
    found = [0.0]
    for x in sorted({float(x) for form in forms for one in form.stretches for x in (one.start, one.end)}):
        if found[-1] + TINY * piece.length < x < (1 - TINY) * piece.length:
            found.append(x)
    return [*found, float(piece.length)]


def _on_stretch(piece, kappa, first, second):
    """The same where both have one stretch, or none."""
    found = 0 * kappa
    if not first.stretches or not second.stretches:
        return found
    far = np.all([one.is_far(piece, kappa) for one in second.stretches], axis=0)
    for chosen, integral in ((far, _by_ends), (~far, _by_places)):
        if chosen.any():
            found[chosen] = integral(piece, kappa[chosen], first, second)
    return found


def _rule(piece, kappa, forms):
    """Places, weights and the first load at these."""
    numbers = arithmetic_of(0.0)
    y, weights = panel_rule(piece, kappa, sum(max(one.pace for one in form.stretches) for form in forms), numbers)
    x = piece.length * y
    return x, piece.length * weights * sum(one.at(x, numbers) for one in forms[0].stretches)


def _by_ends(piece, kappa, first, second):
    x, loads = _rule(piece, np.zeros(1), (first, second))
    half, ends = piece.order // 2, np.array([0.0, piece.length])
    inside, w = (np.sum([particular(piece, kappa[:, None], one, at) for one in second.stretches], axis=0)
                 for at in (x, ends))
    moved = np.moveaxis(w[:half], 0, -1).reshape(len(kappa), piece.order)
    return (inside[0] * loads).sum(axis=-1) - (end_loads(piece, kappa, first) * moved).sum(axis=-1)


def _by_places(piece, kappa, first, second):
    x, loads = _rule(piece, kappa, (first, second))
    return sum(load * loaded_fields(piece, kappa, second, place)[..., 0] for place, load in zip(x, loads, strict=True))
