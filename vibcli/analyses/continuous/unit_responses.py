"""How much motion unit loads and unit dislocations bring at a real frequency s = σ, exactly: no modes.

A load f on coordinates and a dislocation e of ends of pieces from their nodes answer with g, of which mode n has

    ⟨φₙ, g⟩ = cₙ/(ωₙ² + σ²),      cₙ = φₙᵀ f − Σ e Q,      Q: the force that an end needs in the mode (Betti)

so that twice the kinetic energy per rate² of g is a sum over all modes (Parseval),

    Σ cₙ²/(ωₙ² + σ²)² = gᵀ ∂D/∂s² g.
"""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.short_pieces import relative_coordinates
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.relative import in_relative_motions
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.short_pieces import RelativeCoordinates
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.loads import LoadForm
    from vibcli.numerics.pieces.piece import Piece

PANEL = 16          # places to a panel of an integral


class UnitLoads(NamedTuple):
    """Columns of loads: forces (n, columns) on coordinates; ends {(piece, end value): (columns,)}: dislocations."""

    forces: np.ndarray
    ends: dict[tuple[int, int], np.ndarray]


def motions_squared(K: np.ndarray, M: np.ndarray, pieces: "Sequence[PlacedPiece]", loads: UnitLoads,
                    sigma: np.ndarray) -> np.ndarray:
    """gᵢᵀ ∂D/∂s² gⱼ of all columns, (number of σ, columns, columns); K, M: (n, n), without the pieces."""
    n, near = len(loads.forces), relative_coordinates(pieces)
    T = near.matrix(n)
    K, M = T.T @ K @ T, T.T @ M @ T
    D = np.repeat((K + sigma[:, None, None] ** 2 * M).astype(float), 1, axis=0)
    right = np.repeat((T.T @ loads.forces)[None].astype(float), len(sigma), axis=0)
    known = []
    for number, one in enumerate(pieces):
        kappa = one.piece.inertia * sigma**2 + one.piece.foundation
        d, slope = stiffness_and_slope(one.piece, kappa)
        if number in near.short:
            d, slope = in_relative_motions(one.piece, kappa, d, slope)
        rows, cut = _of_ends(near, number, n), _cut(loads, number, one.piece, number in near.short)
        D += np.einsum("ai,sab,bj->sij", rows, d, rows, optimize=True)
        right -= np.einsum("ai,sab,bc->sic", rows, d, cut, optimize=True)
        known.append((rows, cut, one.piece.inertia * slope))
    x = _solved(D, right)
    found: np.ndarray = np.einsum("sic,ij,sjd->scd", x, M, x, optimize=True)
    for rows, cut, slope in known:
        ends = rows @ x + cut
        found += np.einsum("sac,sab,sbd->scd", ends, slope, ends, optimize=True)
    return found


def _of_ends(near: "RelativeCoordinates", number: int, n: int) -> np.ndarray:
    """The rows of the motions of a piece, (motions, n)."""
    rows = near.short.get(number, near.ends[number])
    found = np.zeros((len(rows), n))
    for motion, row in enumerate(rows):
        for i, x in row.items():
            found[motion, i] = x
    return found


def _cut(loads: UnitLoads, number: int, piece: "Piece", short: bool) -> np.ndarray:
    """The dislocations of the ends of a piece, (motions, columns), of short ones as u₀, θ₀, w, ψ."""
    none = np.zeros(loads.forces.shape[1])
    found = np.array([none + loads.ends.get((number, end), none) for end in range(piece.order)])
    if short:
        found[2:] -= found[:2]
        found[2] -= piece.length * found[1]
    return found


def _solved(D: np.ndarray, right: np.ndarray) -> np.ndarray:
    """D⁻¹ right, coordinates counted in their own size."""
    if not D.shape[-1]:
        return right
    size = 1 / np.sqrt(np.abs(np.diagonal(D, axis1=1, axis2=2)))
    found = np.linalg.solve(D * size[:, :, None] * size[:, None, :], size[:, :, None] * right)
    return np.asarray(size[:, :, None] * found)


def overlaps(forms: "Sequence[LoadForm]") -> np.ndarray:
    """∫ fᵢ fⱼ dx of loads along a piece, (forms, forms)."""
    found, numbers = np.zeros((len(forms), len(forms))), arithmetic_of(0.0)
    edges = sorted({float(x) for form in forms for one in form.stretches for x in (one.start, one.end)})
    places, weights = np.polynomial.legendre.leggauss(PANEL)
    for low, high in pairwise(edges):
        here = [[one for one in form.stretches if one.start <= low and high <= one.end] for form in forms]
        panels = 1 + int((high - low) * max((one.pace for form in here for one in form), default=0.0))
        x = low + (high - low) / panels * (np.arange(panels)[:, None] + (1 + places) / 2).ravel()
        values = np.array([sum((one.at(x, numbers) for one in form), 0 * x) for form in here])
        found += (high - low) / panels / 2 * (values * np.tile(weights, panels)) @ values.T
    return found
