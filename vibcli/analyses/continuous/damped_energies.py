"""The energies of vibrations that dampers damp, of modes and of what loads do at complex frequencies.

Of D(r) w = g and D(s) u = f, M, C + a M and K being symmetric, a: a drag of all that has mass,

    wᵀ K u − r s wᵀ M u = (r wᵀ f − s uᵀ g)/(r − s) = b,      of a mode and itself −r
    wᵀ K u + r s wᵀ M u = (r wᵀ f + s uᵀ g − 2 r s wᵀ C u + a b)/(r + s + a)

so that what is read where loads act and the strokes of dampers tell all: no field is integrated.
"""

import numpy as np

from vibcli.base.named_tuple import NamedTuple

ROUNDED = 2.0**-48  # what rounding leaves of each term of an energy
BLOCK = 512         # rows of terms at a time


class DampedSwings(NamedTuple):
    """w e^{st} of modes and of what loads do: rates s (n,), errors: relative bounds of them; strokes (n, dampers), each
    times the root of its rate, and their sizes; shown, (n, slots): what each shows where loads act, loads: which act on
    it."""

    rates: np.ndarray
    errors: np.ndarray
    strokes: np.ndarray
    sizes: np.ndarray
    shown: np.ndarray
    loads: np.ndarray

    def factors(self) -> "list[np.ndarray]":
        """(U, V, their sizes), r wᵀ f + s uᵀ g − 2 r s wᵀ C u = U Vᵀ."""
        s = self.rates[:, None]
        felt, sizes = s * self.shown, np.abs(s) * self.sizes
        return [np.concatenate(parts, axis=1) for parts in (
            (felt, self.loads, -2 * s * self.strokes), (self.loads, felt, s * self.strokes),
            (np.abs(felt), np.abs(self.loads), 2 * sizes), (np.abs(self.loads), np.abs(felt), sizes))]


def energies(first: DampedSwings, A: np.ndarray, second: DampedSwings, B: np.ndarray, own: np.ndarray,
             own_errors: np.ndarray, drag: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """⟨Re Σ Aᵢ wᵢ, Re Σ Bⱼ uⱼ⟩ of columns of A and B, and how far rounding may put it off; the first of both are
    the same modes, own: ⟨w̄ᵢ, wᵢ⟩ of each, own_errors: relative bounds of them."""
    (U, _, U_size, _), (_, V, _, V_size) = first.factors(), second.factors()
    found, off = np.zeros((A.shape[1], B.shape[1])), np.zeros((A.shape[1], B.shape[1]))
    pace, count = np.abs(second.rates) * second.errors, len(own)
    for start in range(0, len(U), BLOCK):
        rows = slice(start, start + BLOCK)
        r, among = first.rates[rows, None], np.arange(start, min(start + BLOCK, len(U)))
        sizes, roots = U_size[rows] @ V_size.T, np.abs(r) * first.errors[rows, None] + pace
        for left, weight, paces in ((U[rows], A[rows], r), (U[rows].conj(), A[rows].conj(), r.conj())):
            total, modes = paces + second.rates + drag, among[among < count]
            apart = np.abs(total)
            with np.errstate(divide="ignore", invalid="ignore"):
                terms, errors = left @ V.T / total, sizes / apart * (ROUNDED + roots / apart)
                if drag:
                    more, off_more = _dragged(first, left, V, paces - second.rates, roots)
                    if paces is r:
                        more[modes - start, modes] = -first.rates[modes]
                    terms, errors = terms + drag * more / total, errors + drag / apart * (
                        off_more + np.abs(more) * (ROUNDED + roots / apart))
            if paces is not r:
                terms[modes - start, modes], errors[modes - start, modes] = own[modes], (own * own_errors)[modes]
                both = np.sqrt(own[modes, None] * own)
                blurred = ~(errors[:len(modes), :count] <= both)
                terms[:len(modes), :count][blurred] = 0.0
                errors[:len(modes), :count] = np.fmin(errors[:len(modes), :count], both)
            found += 0.5 * (weight.T @ terms @ B).real
            off += 0.5 * np.abs(weight).T @ errors @ np.abs(B)
    return found, off


def _dragged(first, U, V, gap, roots):
    """b and how far rounding may put it off, 0 of modes."""
    m, far = first.loads.shape[1], np.abs(gap)
    sizes = np.abs(U[:, :2 * m]) @ np.abs(V[:, :2 * m]).T
    found = U[:, :m] @ V[:, :m].T - U[:, m:2 * m] @ V[:, m:2 * m].T
    return (np.where(sizes, part, 0.0) for part in (found / gap, sizes / far * (ROUNDED + roots / far)))
