"""The energies of vibrations that dampers and drag damp, of modes and of what loads do at complex frequencies.

Of D(r) w = g and D(s) u = f, K, C and M being symmetric,

    wᵀ K u − r s wᵀ M u = (r wᵀ f − s uᵀ g)/(r − s),      of a mode and itself −r
    wᵀ K u + r s wᵀ M u = (r wᵀ f + s uᵀ g − 2 r s wᵀ C u)/(r + s)

so that what is read where loads act, the strokes of dampers and what ends of pieces with drag do tell all: no field is
integrated. With the forces F that its ends e need and the load p along it, on such a piece

    (κ(r) − κ(s)) ∫ w u dx = eᵤᵀ F_w − e_wᵀ Fᵤ + ∫ u p_w − w pᵤ dx,      κ(r) − κ(s) = (r − s) (c + (r + s) μ)
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

ROUNDED = 2.0**-48  # what rounding leaves of each term of an energy
BLOCK = 512         # rows of terms at a time


class DampedSwings(NamedTuple):
    """w e^{st} of modes and of what loads do: rates s (n,), errors: relative bounds of them; strokes (n, dampers), each
    times the root of its rate, and their sizes; shown, (n, slots): what each shows where loads act, loads: which act on
    it; along (n, 2, pieces, ends): of w and of u what makes up the right side on each piece with drag, and sizes of
    these."""

    rates: np.ndarray
    errors: np.ndarray
    strokes: np.ndarray
    sizes: np.ndarray
    shown: np.ndarray
    loads: np.ndarray
    along: np.ndarray
    along_sizes: np.ndarray

    def factors(self) -> "list[np.ndarray]":
        """(U, V, their sizes), r wᵀ f + s uᵀ g − 2 r s wᵀ C u = U Vᵀ, C of dampers alone."""
        s = self.rates[:, None]
        felt, sizes = s * self.shown, np.abs(s) * self.sizes
        return [np.concatenate(parts, axis=1) for parts in (
            (felt, self.loads, -2 * s * self.strokes), (self.loads, felt, s * self.strokes),
            (np.abs(felt), np.abs(self.loads), 2 * sizes), (np.abs(self.loads), np.abs(felt), sizes))]


class OwnEnergies(NamedTuple):
    """Of modes w: energies ⟨w̄, w⟩ and relative bounds of their errors, (n,); squares: ∫ w² dx of each piece with drag,
    (n, pieces)."""

    energies: np.ndarray
    errors: np.ndarray
    squares: np.ndarray


def energies(first: DampedSwings, A: np.ndarray, second: DampedSwings, B: np.ndarray, own: OwnEnergies,
             drags: "Sequence[tuple[float, float]]" = ()) -> tuple[np.ndarray, np.ndarray]:
    """⟨Re Σ Aᵢ wᵢ, Re Σ Bⱼ uⱼ⟩ of columns of A and B, and how far rounding may put it off; the first of both are
    the same modes; drags: (c, μ) of pieces with drag."""
    (U, _, U_size, _), (_, V, _, V_size) = first.factors(), second.factors()
    found, off = np.zeros((A.shape[1], B.shape[1])), np.zeros((A.shape[1], B.shape[1]))
    pace, count = np.abs(second.rates) * second.errors, len(own.energies)
    for start in range(0, len(U), BLOCK):
        rows = slice(start, start + BLOCK)
        r, modes = first.rates[rows, None], np.arange(start, max(start, min(start + BLOCK, count)))
        sizes, roots = U_size[rows] @ V_size.T, np.abs(r) * first.errors[rows, None] + pace
        both, at = np.sqrt(own.energies[modes, None] * own.energies), (modes - start, modes)
        for turned in (False, True):
            left, along, weight, paces = (part.conj() if turned else part
                                          for part in (U[rows], first.along[rows, 0], A[rows], r))
            total = paces + second.rates
            with np.errstate(divide="ignore", invalid="ignore"):
                blur = (ROUNDED + roots / np.abs(total)) / np.abs(total)
                terms, errors = left @ V.T / total, sizes * blur
                if drags:
                    X, off_X = _dragged(drags, along, first.along_sizes[rows, 0], second, (paces, roots))
                    if not turned:
                        X[at] = own.squares[modes] @ [c for c, _ in drags]
                        off_X[at] = ROUNDED * np.abs(X[at])
                    both_paces = -2 * paces * second.rates
                    terms = terms + both_paces * X / total
                    errors = errors + np.abs(both_paces) * (off_X / np.abs(total) + np.abs(X) * blur)
            if turned:
                terms[at], errors[at] = own.energies[modes], (own.energies * own.errors)[modes]
            blurred = ~(errors[:len(modes), :count] <= both)
            terms[:len(modes), :count][blurred] = 0.0
            errors[:len(modes), :count] = np.fmin(errors[:len(modes), :count], both)
            found += 0.5 * (weight.T @ terms @ B).real
            off += 0.5 * np.abs(weight).T @ errors @ np.abs(B)
    return found, off


def _dragged(drags: "Sequence[tuple[float, float]]", along: Any, sizes: np.ndarray, second: DampedSwings,
             rates: tuple[np.ndarray, np.ndarray]) -> tuple[Any, Any]:
    """(Σ c ∫ w u dx, how far rounding may put it off), (rows, n)."""
    (r, roots), found, off = rates, 0.0, 0.0
    gap, total = r - second.rates, r + second.rates
    for p, (c, mu) in enumerate(drags):
        across = c + mu * total
        change = gap * across
        X = along[:, p] @ second.along[:, 1, p].T / change
        blur = sizes[:, p] @ second.along_sizes[:, 1, p].T * ROUNDED / np.abs(change)
        found, off = found + c * X, off + c * (blur + np.abs(X) * roots * (1 / np.abs(gap) + mu / np.abs(across)))
    return found, off
