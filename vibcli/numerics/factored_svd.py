"""Singular values of a factor in floats, by the cheapest way whose bound allows it.

Plain SVD knows each value to 4 √n ε of the largest. Where that is too little: rows sorted by size, QR with
pivoted columns (Powell & Reid 1969; Cox & Higham 1998), then one-sided Jacobi on Rᵀ by LAPACK's dgejsv (Drmač &
Veselić 2008): X + δX = X (1 + X⁺δX), and with |δX| ≤ ε|X| each value is off by ε ‖|X⁺||X|‖ at most, in which the sizes
of the rows, and so the ratio of the stiffnesses, drop out.
"""

import numpy as np

from vibcli.numerics.fixed_point import count_floats

UNIT = 2.0 ** -53
ENOUGH, ENOUGH_WHEN_MANY, MANY = 1e-13, 1e-10, 150


def singular_vectors(x: np.ndarray, zeros: int, known: float = 1.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Singular values of x descending, right singular vectors in columns, a relative bound for each value.

    `zeros`: how many vanish by structure; they and their vectors come last. `known`: how many times its
    rounding x may be off.
    """
    n = x.shape[1]
    tall = x if len(x) >= n else np.vstack([x, np.zeros((n - len(x), n))])
    count_floats(n)
    _, sigma, vt = np.linalg.svd(tall, full_matrices=False)
    elastic = sigma[:n - zeros]
    error = 4 * np.sqrt(n) * known * UNIT
    bound = np.zeros(n)
    with np.errstate(divide="ignore"):
        bound[:n - zeros] = error * sigma[0] / elastic
    if not len(elastic) or bound.max() <= (ENOUGH_WHEN_MANY if n > MANY else ENOUGH):
        return sigma, vt.T, bound
    r, order, turned = pivoted_qr(tall)
    r = r[:n - zeros]
    better = np.full(n, row_error(tall[:, order], r, turned[:n - zeros], known))
    better = np.minimum(better, 2 * bound)      # what QR adds is no more, off as the factor is as a whole
    if better.max() >= bound.max():
        return sigma, vt.T, bound
    u, sigma = jacobi(r.T)
    v = np.empty((n, n))
    v[order] = np.hstack([u, np.linalg.qr(u, mode="complete")[0][:, n - zeros:]])
    return np.concatenate([sigma, np.zeros(zeros)]), v, better


def row_error(x: np.ndarray, r: np.ndarray, turned: np.ndarray, known: float) -> float:
    """The relative error of each value: that of the data and of QR, 8 ε ‖|X⁺||X|‖ with X⁺ = R⁺Qᵀ, `turned` being
    Qᵀ diag(lengths of the rows of X), and that of Jacobi's rotations, 16 √n ε times the condition of the rows of R."""
    sizes = np.linalg.norm(r, axis=1)[:, None]
    rows = r / sizes
    back = np.linalg.pinv(rows) @ (turned / sizes)
    growth = np.linalg.norm(np.abs(back) @ np.abs(x / _lengths(x)[:, None]), 2)
    found: float = UNIT * (8 * known * growth + 16 * np.sqrt(x.shape[1]) * np.linalg.cond(rows))
    return found


def _lengths(x: np.ndarray) -> np.ndarray:
    """The lengths of the rows; 1 of a row of zeros."""
    lengths = np.linalg.norm(x, axis=1)
    return np.where(lengths > 0, lengths, 1.0)


def pivoted_qr(a: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """R, the order with a[:, order] = Q R up to the order of rows, and Qᵀ diag(lengths of the rows of a)."""
    from scipy.linalg import qr_multiply

    sort = np.argsort(-np.abs(a).max(axis=1), kind="stable")
    turned, r, order = qr_multiply(a[sort], np.diag(_lengths(a))[sort].T, pivoting=True)
    return r[:a.shape[1]], order, turned.T[:a.shape[1]]


def jacobi(a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Left singular vectors and singular values, descending, by rotations of columns (Hestenes 1958)."""
    from scipy.linalg.lapack import dgejsv

    sigma, u, _, work, _, _ = dgejsv(a, joba=2, jobu=0, jobv=3, jobr=0, jobt=0, jobp=0)
    return u[:, :a.shape[1]], sigma * (work[0] / work[1])


def mass_factor(rows: np.ndarray) -> np.ndarray:
    """Lower triangular L with L Lᵀ = rowsᵀ rows, from a QR of the sorted rows, never from the product."""
    order = np.argsort(-np.abs(rows).max(axis=1), kind="stable")
    r = np.linalg.qr(rows[order], mode="r")
    found: np.ndarray = (r * np.copysign(1.0, r.diagonal())[:, None]).T  # type: ignore[attr-defined]
    return found
