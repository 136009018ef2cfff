"""Undamped modes of many coordinates in floats, with a bound of the rounding.

Where all stiffness is Σ k ∇s ∇sᵀ the frequencies are singular values of X = √k̂ ∇s L⁻ᵀ, M̂ = L Lᵀ: K̂ is not
assembled. Otherwise L⁻¹ K̂ L⁻ᵀ by `eigh`, its error 4 n ε of the assembled magnitudes.
"""

import numpy as np

from vibcli.analyses import fixed as fx
from vibcli.analyses.factored import mass_factor, singular_vectors
from vibcli.analyses.scaled import mechanism, unmoved

UNIT = 2.0 ** -53


def undamped_floats(elements, scale, zeros):
    """λ̂, M̂-normalised shapes in columns, relative error bounds of √|λ̂|, flags of exact zeros."""
    if zeros is None or elements.massless:
        return _assembled(elements, scale, zeros)
    rows = scaled_rows(elements.springs, scale.coordinates, scale.stiffness, elements.n)
    lower = _mass(elements, scale)
    x = rows / lower if lower.ndim == 1 else _solved(lower, rows.T).T
    sigma, v, bound = singular_vectors(x, 1.0 if lower.ndim == 1 else np.linalg.cond(lower))
    zero = np.arange(elements.n) >= elements.n - zeros
    shapes = v / lower[:, None] if lower.ndim == 1 else _solved(lower.T, v)
    with np.errstate(divide="ignore"):
        return sigma ** 2, shapes, np.where(zero, 0.0, bound), zero


def scaled_rows(terms, powers, scale, n):
    """√(2^-scale w) s D as a dense array, a term to a row; the scale enters by halves, exactly."""
    out = np.zeros((len(terms), n))
    for place, (weight, row) in enumerate(terms):
        if weight:
            m, e = np.frexp(weight)
            odd = int(e - scale) % 2
            root, half = np.sqrt(m * 2.0 if odd else m), (int(e) - scale - odd) // 2
            for i, x in row.items():
                out[place, i] = np.ldexp(root * float(x), half + powers[i])
    return out


def _mass(elements, scale):
    """Lower triangular L with M̂ = L Lᵀ, or its diagonal alone."""
    n = elements.n
    if not elements.M and all(sum(1 for x in row.values() if x) <= 1 for _, row in elements.inertias):
        rows = scaled_rows(elements.inertias, scale.coordinates, scale.mass, n)
        return np.sqrt((rows ** 2).sum(axis=0))
    if not elements.M:
        return mass_factor(scaled_rows(elements.inertias, scale.coordinates, scale.mass, n))
    m = dense(elements.inertias, elements.M, scale.coordinates, scale.mass, n)
    try:
        return np.linalg.cholesky(m)
    except np.linalg.LinAlgError:
        raise unmoved(int(np.argmin(m.diagonal()))) from None


def dense(terms, matrix, powers, scale, n):
    """2^-scale D (Σ w s sᵀ + matrix) D in floats."""
    out = np.zeros((n, n))
    for weight, row in terms:
        for i, x in row.items():
            for j, y in row.items():
                out[i, j] += np.ldexp(float(weight) * float(x) * float(y), powers[i] + powers[j] - scale)
    for (i, j), x in matrix.items():
        out[i, j] += np.ldexp(float(x), powers[i] + powers[j] - scale)
    return out


def _solved(triangle, b):
    """triangle⁻¹ b."""
    from scipy.linalg import solve_triangular

    return solve_triangular(triangle, b, lower=not np.any(np.triu(triangle, 1)))


def _assembled(elements, scale, zeros):
    """The same from the assembled stiffness, massless coordinates condensed."""
    n, p = elements.n, scale.coordinates
    k = dense(elements.springs, elements.K, p, scale.stiffness, n)
    size = dense([(abs(w), {i: abs(x) for i, x in row.items()}) for w, row in elements.springs],
                 elements.K_size or {at: abs(x) for at, x in elements.K.items()}, p, scale.stiffness, n)
    massless = sorted(elements.massless)
    massive = [i for i in range(n) if i not in set(massless)]
    follow = None
    if massless:
        try:
            follow = np.linalg.solve(k[np.ix_(massless, massless)], k[np.ix_(massless, massive)])
        except np.linalg.LinAlgError:
            raise mechanism(massless[0]) from None
        size = size[np.ix_(massive, massive)] + size[np.ix_(massive, massless)] @ np.abs(follow)
        k = k[np.ix_(massive, massive)] - k[np.ix_(massive, massless)] @ follow
    lower = _mass(elements, scale)
    if massless:
        lower = lower[massive] if lower.ndim == 1 else lower[np.ix_(massive, massive)]
    if lower.ndim == 1:
        a, grown = k / lower[:, None] / lower, size / lower[:, None] / lower
    else:
        inverse = _solved(lower, np.eye(len(massive)))
        a, grown = inverse @ k @ inverse.T, np.abs(inverse) @ size @ np.abs(inverse.T)
    values, q = np.linalg.eigh((a + a.T) / 2)
    error = 4 * len(a) * UNIT * np.linalg.norm(grown)
    zero = np.abs(values) <= error
    if zeros is not None:
        zero = np.zeros(len(values), bool)
        zero[np.argsort(np.abs(values), kind="stable")[:zeros]] = True
    a_shapes = q / lower[:, None] if lower.ndim == 1 else _solved(lower.T, q)
    shapes = np.zeros((n, len(massive)))
    shapes[massive] = a_shapes
    if massless:
        shapes[massless] = -follow @ a_shapes
    with np.errstate(divide="ignore"):
        return values, shapes, 0.5 * error / np.maximum(np.abs(values) - error, 0.1 * np.abs(values)), zero


_ = fx
