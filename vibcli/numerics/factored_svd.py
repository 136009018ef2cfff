"""Singular values of a factor in floats, by the cheapest way whose bound allows it.

Plain SVD knows each value to 4 √n ε of the largest. Where that is too little: rows sorted by size, QR with
complete pivoting (Powell & Reid 1969; Cox & Higham 1998), then one-sided Jacobi on Rᵀ (Drmač & Veselić
2008), in NumPy for some hundred columns, by LAPACK's dgejsv beyond: X + δX = X (1 + X⁺δX), and with |δX| ≤ ε|X| each
value is off by ε ‖|X⁺||X|‖ at most, in which the sizes of the rows, and so the ratio of the stiffnesses, drop out.
"""

import numpy as np

from vibcli.numerics.fixed_point import count_floats

UNIT = 2.0 ** -53
ENOUGH = 1e-13
ENOUGH_WHEN_MANY = 1e-10
JACOBI_UP_TO = 150
SWEEPS = 30


def singular_vectors(x, zeros, known=1.0):
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
    if not len(elastic) or bound.max() <= (ENOUGH if n <= JACOBI_UP_TO else ENOUGH_WHEN_MANY):
        return sigma, vt.T, bound
    r, order, turned = (pivoted_qr if n <= JACOBI_UP_TO else _pivoted_by_lapack)(tall)
    r = r[:n - zeros]
    better = np.full(n, row_error(tall[:, order], r, turned[:n - zeros], known))
    better = np.minimum(better, 2 * bound)      # what QR adds is no more, off as the factor is as a whole
    if better.max() >= bound.max():
        return sigma, vt.T, bound
    u, sigma = jacobi(r.T) if n <= JACOBI_UP_TO else _jacobi_by_lapack(r.T)
    v = np.empty((n, n))
    v[order] = np.hstack([u, np.linalg.qr(u, mode="complete")[0][:, n - zeros:]])
    return np.concatenate([sigma, np.zeros(zeros)]), v, better


def row_error(x, r, turned, known):
    """The relative error of each value: that of the data and of QR, 8 ε ‖|X⁺||X|‖ with X⁺ = R⁺Qᵀ, `turned` being
    Qᵀ diag(lengths of the rows of X), and that of Jacobi's rotations, 16 √n ε times the condition of the rows of R."""
    sizes = np.linalg.norm(r, axis=1)[:, None]
    rows = r / sizes
    back = np.linalg.pinv(rows) @ (turned / sizes)
    growth = np.linalg.norm(np.abs(back) @ np.abs(x / _lengths(x)[:, None]), 2)
    return UNIT * (8 * known * growth + 16 * np.sqrt(x.shape[1]) * np.linalg.cond(rows))


def _lengths(x):
    """The lengths of the rows; 1 of a row of zeros."""
    lengths = np.linalg.norm(x, axis=1)
    return np.where(lengths > 0, lengths, 1.0)


def pivoted_qr(a):
    """R, the order with a[:, order] = Q R, and Qᵀ diag(lengths of the rows of a); rows sorted, columns and rows
    exchanged for the pivots."""
    n = a.shape[1]
    a = np.hstack([a, np.diag(_lengths(a))])[np.argsort(-np.abs(a).max(axis=1), kind="stable")]
    order = np.arange(n)
    for k in range(n):
        j = k + int(np.argmax((a[k:, k:n] ** 2).sum(axis=0)))
        a[:, [k, j]], order[[k, j]] = a[:, [j, k]], order[[j, k]]
        i = k + int(np.argmax(np.abs(a[k:, k])))
        a[[k, i]] = a[[i, k]]
        size = np.linalg.norm(a[k:, k])
        if not size:
            break
        v = a[k:, k].copy()
        v[0] += np.copysign(size, v[0])
        a[k:, k:] -= np.multiply.outer(v, (2 / (v @ v)) * (v @ a[k:, k:]))
        a[k + 1:, k] = 0.0
    return a[:n, :n], order, a[:n, n:]


def jacobi(a):
    """Left singular vectors and singular values, descending, by rotations of columns (Hestenes 1958)."""
    a = np.array(a, order="F")
    n = a.shape[1]
    for _ in range(SWEEPS):
        largest = 0.0
        for p, q in _rounds(n):
            x, y = a[:, p], a[:, q]
            alpha, beta, gamma = (x * x).sum(axis=0), (y * y).sum(axis=0), (x * y).sum(axis=0)
            size = np.sqrt(alpha * beta)
            turned = np.abs(gamma) > UNIT * size * 2
            if turned.any():
                largest = max(largest, float((np.abs(gamma[turned]) / size[turned]).max()))
                zeta = (beta[turned] - alpha[turned]) / (2 * gamma[turned])
                t = np.copysign(1.0, zeta) / (np.abs(zeta) + np.hypot(1.0, zeta))
                c = 1 / np.hypot(1.0, t)
                x, y, s = x[:, turned], y[:, turned], c * t
                a[:, p[turned]], a[:, q[turned]] = c * x - s * y, s * x + c * y
        if largest <= n * UNIT:
            break
    sigma = np.linalg.norm(a, axis=0)
    order = np.argsort(-sigma, kind="stable")
    return a[:, order] / sigma[order], sigma[order]


def _rounds(n):
    """Every pair of n columns once, in rounds of disjoint pairs (Brent & Luk 1985)."""
    players = list(range(n + n % 2))
    half = len(players) // 2
    for _ in range(len(players) - 1):
        p, q = np.array(players[:half]), np.array(players[half:][::-1])
        real = (p < n) & (q < n)
        yield p[real], q[real]
        players = [players[0], players[-1], *players[1:-1]]


def _pivoted_by_lapack(a):
    from scipy.linalg import qr_multiply

    sort = np.argsort(-np.abs(a).max(axis=1), kind="stable")
    turned, r, order = qr_multiply(a[sort], np.diag(_lengths(a))[sort].T, pivoting=True)
    return r[:a.shape[1]], order, turned.T[:a.shape[1]]


def _jacobi_by_lapack(a):
    from scipy.linalg.lapack import dgejsv

    sigma, u, _, work, _, _ = dgejsv(a, joba=2, jobu=0, jobv=3, jobr=0, jobt=0, jobp=0)
    return u[:, :a.shape[1]], sigma * (work[0] / work[1])


def mass_factor(rows):
    """Lower triangular L with L Lᵀ = rowsᵀ rows, from a QR of the sorted rows, never from the product."""
    order = np.argsort(-np.abs(rows).max(axis=1), kind="stable")
    r = np.linalg.qr(rows[order], mode="r")
    return (r * np.copysign(1.0, r.diagonal())[:, None]).T
