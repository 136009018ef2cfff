"""Many systems of linear equations of one size with narrow bands, all eliminated at once, each with its own pivots."""

import numpy as np


def solved(rows: np.ndarray, right: np.ndarray) -> np.ndarray:
    """D⁻¹·right of each of N matrices: rows (n, 2w + 1, N), row i holding its columns i − w … i + w (zeros beyond the
    edges); right (n, m, N). Not finite where a matrix is singular.

    Gaussian elimination with row pivoting (Golub & Van Loan 2013, §4.3.3); over one matrix a step costs
    (w + 1)(2w + 1 + m) products.
    """
    n, across, many = rows.shape
    w = across // 2
    upper = np.empty((n, across, many), complex)
    x = np.zeros((n + 2 * w, right.shape[1], many), complex)
    window = np.zeros((w + 1, across + right.shape[1], many), complex)      # rows k … k + w, columns k … k + 2w
    for i in range(min(w + 1, n)):
        window[i, :w + 1 + i], window[i, across:] = rows[i, w - i:], right[i]
    with np.errstate(all="ignore"):
        for k in range(n):
            top = _pivoted(window)
            upper[k], x[k] = top[:across], top[across:]
            window = _reduced(window, top, across)
            if k + w + 1 < n:
                window[w, :across], window[w, across:] = rows[k + w + 1], right[k + w + 1]
        for k in reversed(range(n)):
            known = (upper[k, 1:, None] * x[k + 1:k + across]).sum(axis=0)
            x[k] = (x[k] - known) / upper[k, 0]
    return x[:n]


def _pivoted(window: np.ndarray) -> np.ndarray:
    """The row with the largest leading entry, its place being taken by the first one."""
    first = window[:, 0]
    pivot = (np.abs(first.real) + np.abs(first.imag)).argmax(axis=0)
    moved = np.flatnonzero(pivot)
    top: np.ndarray = window[0].copy()
    if len(moved):
        top[:, moved] = window[pivot[moved], :, moved].T
        window[pivot[moved], :, moved] = window[0][:, moved].T
    return top


def _reduced(window: np.ndarray, top: np.ndarray, across: int) -> np.ndarray:
    """The window one row and one column further, its last row empty."""
    found = np.zeros_like(window)
    factor = (window[1:, 0] / top[0])[:, None]
    found[:-1, :across - 1] = window[1:, 1:across] - factor * top[1:across]
    found[:-1, across:] = window[1:, across:] - factor * top[across:]
    return found
