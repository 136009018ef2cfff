"""What loads that turn at one frequency keep up all along members: D(iΩ) is solved once for all places.

A piece that vibrates with its ends held has no field of end values there: the system is divided elsewhere.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.dynamic_matrix import BLOWN, SHARES, dynamic_matrix
from vibcli.analyses.continuous.spread_drives import spread_inputs
from vibcli.analyses.frequency_response.member_solution import motions, scales
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.loads import loaded_fields
from vibcli.numerics.pieces.retardation import retarded_reaction

if TYPE_CHECKING:
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import PlacedPiece


class DrivenFields(NamedTuple):
    """X e^{st} of the coordinates of PlacedPieces under loads; spread: [(complex amplitude, SpreadDrive)] of those that
    lie along them."""

    s: complex
    pieces: "list[PlacedPiece]"
    X: np.ndarray
    spread: "list[tuple[complex, SpreadDrive]]"

    def along(self, member: str, between: tuple[float, float], places: np.ndarray, order: int) -> np.ndarray:
        """The complex amplitudes of ∂ᵒʳᵈᵉʳu/∂xᵒʳᵈᵉʳ at places between two stations of a member, (n,)."""
        own = [one for one in self.pieces if one.owner == member
               and between[0] < float(one.start + one.piece.length / 2) < between[1]]
        ends = [float(one.start + one.piece.length) for one in own[:-1]]
        found, at = np.zeros(len(places), complex), np.searchsorted(ends, places, side="right")
        for number in np.unique(at).tolist():
            here = at == number
            found[here] = self._within(own[number], places[here] - float(own[number].start), order)
        return found

    def _within(self, placed: "PlacedPiece", x: np.ndarray, order: int) -> np.ndarray:
        piece, s = placed.piece._make(float(value) for value in placed.piece), np.array([self.s])
        x = np.clip(x, 0.0, piece.length)
        kappa = retarded_reaction(piece, s, placed.retardation)[0]
        ends = np.array([sum(float(factor) * self.X[i] for i, factor in row.items()) for row in placed.rows])
        found = fields(piece, kappa, ends, x)[..., order] + 0j
        for A, drive in self.spread:
            form = drive.on(placed)
            if form is not None:
                held = [loaded_fields(piece, kappa, form, one)[..., order] for one in x.tolist()]
                found += A / (1 + float(placed.retardation) * self.s) * np.array(held)
        return found


def driven_fields(configuration: "Configuration", weights: Mapping[int, complex], Omega: float) -> DrivenFields | None:
    """Of inputs with these complex amplitudes {coordinate: A}; None where D is nearly singular, or pieces are short
    beside their member."""
    opened = configuration.with_inputs
    opened.require_steady(weights)
    n, spread = len(opened.scene.q), spread_inputs(configuration, weights)
    inputs, s, best = list(range(opened.n, n)), np.array([1j * Omega]), None
    whole = dynamic_matrix(opened.elements, spread=spread, kept=inputs)
    if any(whole.is_short(number) for number in range(len(whole.pieces))):
        return None
    for share in (None, *SHARES):
        matrix = whole if share is None else whole.divided(share)
        found = matrix.at(s)
        if best is None or found.excess[0] < best.excess[0]:
            best = found
        if best.excess[0] < BLOWN:
            break
    X = np.zeros(best.matrix.n, complex)
    X[inputs] = [weights.get(i, 0.0) for i in inputs]
    free = [i for i in range(best.matrix.n) if i not in inputs]
    loads = -best.D[np.ix_(free, inputs)][..., 0] @ X[inputs]
    (x,), singular = motions(best.D[np.ix_(free, free)] + 0j, scales(best.size[free]), [loads[:, None]], None)
    if singular[0]:
        return None
    X[free] = x[:, 0]
    pieces, X = best.matrix.in_scene(X)
    return DrivenFields(1j * Omega, list(pieces), X, [(weights[j], drive) for j, drive in spread.items()])
