"""D⁻¹ of many degrees of freedom by modes, and what they miss of H(s) put right by one residual.

    ẏ = A y,  A W = W B,  W real:   D⁻¹ = R (s − B)⁻¹ L,   B = [σ, ω; −ω, σ] for a pair λ = σ ± iω,

or D⁻¹ = Φ (s² + 2ζω s + ω²)⁻¹ Φᵀ where damping does not couple the modes. With x and y what they give for D⁻¹b and
D⁻ᵀc, and r = b − D x of the matrices themselves,

    H = cᵀx + yᵀr + d,     off by (D⁻ᵀc − y)ᵀ r <= β² |D⁻¹| |x| |y|,     β = |r|/|x| of scaled coordinates,

besides the rounding of the sums. A frequency at which that is more than rounding of Σ |yᵢ| |Dᵢᵢ| |xᵢ| is left to LU, as
is one at which a far end of a chain hardly feels the other, so that this sum is lost in |x| |y|.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from vibcli.analyses.frequency_response.direct import SINGULAR, probe, repaired
from vibcli.analyses.frequency_response.quadratics import polynomial, slope
from vibcli.numerics.fixed_point import count_floats
from vibcli.numerics.state_space import first_order

COUPLED = 1e-14         # coupling by damping, relative to the damping of two modes
DEPENDENT = 1e8         # condition of the modes from which on LU has too much left to do
ROUNDING = 2.0**-51
BLOCK = 2.0**15         # frequencies times modes that are summed at once


def modal_solution(system: Any, otherwise: Any, most: float = np.inf) -> "ModalSolution | None":
    """The solution that leaves to another method what it loses; None where M is not positive definite, where the modes
    are nearly dependent, and where there are more than so many degrees of freedom and damping couples them."""
    reduced = _reduced(system)
    if reduced is None:
        return None
    parts = _real_modes(system, *reduced)
    if parts is None and system.n <= most:
        parts = _complex_modes(*reduced)
    return None if parts is None else ModalSolution(system, otherwise, *parts)


class ModalSolution:
    """right: (n, m), left: (m, n); small(s): how near s is to a pole, and the function that gives (s − B)⁻¹ g, or with
    −1 that of Bᵀ."""

    __slots__ = ("b", "c", "left", "otherwise", "right", "small")

    def __init__(self, system: Any, otherwise: Any, right: np.ndarray, left: np.ndarray, small: Callable):
        self.otherwise, self.right, self.left, self.small = otherwise, right, left, small
        self.b, self.c = system.b @ left.T, system.c @ right

    def __call__(self, system: Any, s: np.ndarray, steep: bool = False) -> tuple:
        """(H, dH/ds or None, whether there is a pole)."""
        values, slopes, lost = zip(*(self._values(system, part, steep) for part in self._parts(s)), strict=True)
        return repaired(system, s, np.concatenate(values), np.concatenate(slopes) if steep else None,
                        np.flatnonzero(np.concatenate(lost)), self.otherwise)

    def fields(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(D⁻¹b, D⁻ᵀc), (N, n) each."""
        found = [self._solved(system, part) for part in self._parts(s)]
        x, y, lost = (np.concatenate([part[k] for part in found]) for k in (0, 1, -1))
        if lost.any():
            x[lost], y[lost] = self.otherwise.fields(system, s[lost])
        return x, y

    def _parts(self, s):
        many = max(1, int(BLOCK / len(self.left)))
        return [s[k:k + many] for k in range(0, max(len(s), 1), many)]

    def _values(self, system, s, steep):
        x, y, missed, (_, Cx, Mx), lost = self._solved(system, s)
        values = (_row(system.c, s) * x + y * missed).sum(axis=1) + polynomial(system.d, s)
        if not steep:
            return values, None, lost
        turned = slope(system.b, s) - Cx - 2 * s[:, None] * Mx
        return values, (slope(system.c, s) * x + y * turned).sum(axis=1) + slope(system.d, s), lost

    def _solved(self, system, s):
        """x, y, r, what K, C and M make of x, and whether something may be lost."""
        near, solved = self.small(s)
        x = _times(solved(_row(self.b, s), 1), self.right.T)
        y = _times(solved(_row(self.c, s), -1), self.left)
        parts = [_times(x, matrix.T) for matrix in (system.K, system.C, system.M)]
        missed = _row(system.b, s) - (parts[0] + s[:, None] * (parts[1] + s[:, None] * parts[2]))
        return x, y, missed, parts, _lost(system, s, x, y, missed, near)


def _row(coefficients, s):
    """The polynomial in s of rows, (N, n), or (1, n) where it does not change."""
    return polynomial(coefficients, s if coefficients[1:].any() else s[:1])


def _lost(system, s, x, y, missed, near):
    """Whether something else than rounding may be left of each H: x and y may be off by β/near of their size."""
    Omega = np.abs(s)[:, None]
    K, C, M = (np.abs(np.diag(matrix)) for matrix in (system.K, system.C, system.M))
    size = K + Omega * (C + Omega * M)
    x, y, missed = _squares(x) * size, _squares(y) * size, _squares(missed) / size
    told = np.sqrt(x * y).sum(axis=1)
    x, y, missed = (part.sum(axis=1) for part in (x, y, missed))
    with np.errstate(all="ignore"):
        together, beta = np.sqrt(x * y), np.sqrt(missed / x)
        told -= 2 * beta / near * together
        return (near <= 64 * SINGULAR) | ((missed != 0) & ~(beta**2 / near * together <= ROUNDING * told))


def _squares(x):
    return x.real**2 + x.imag**2


def _times(x, matrix):
    """Complex rows times a real matrix."""
    diagonal = np.diag(matrix)
    if matrix.shape[0] == matrix.shape[1] and np.count_nonzero(matrix) == np.count_nonzero(diagonal):
        return x * diagonal
    return np.stack([x.real @ matrix, x.imag @ matrix], axis=-1).view(complex)[..., 0]


def _reduced(system):
    """(K̃, C̃, L⁻ᵀ) with M = L Lᵀ: q = L⁻ᵀ y gives ÿ + C̃ ẏ + K̃ y = L⁻¹ b; None where M is not positive definite."""
    M = system.M
    if not _symmetric(M):
        return None
    masses = np.diag(M)
    if (masses > 0).all() and np.count_nonzero(M) == len(M):
        scale = 1 / np.sqrt(masses)
        return system.K * np.outer(scale, scale), system.C * np.outer(scale, scale), np.diag(scale)
    scale = np.exp2(-np.round(np.log2(np.where(masses > 0, masses, 1.0)) / 2))
    try:
        L = np.linalg.cholesky(M * np.outer(scale, scale))
    except np.linalg.LinAlgError:
        return None
    back = np.linalg.inv(L).T * scale[:, None]
    return back.T @ system.K @ back, back.T @ system.C @ back, back


def _symmetric(matrix):
    return bool((np.abs(matrix - matrix.T) <= 1e-15 * np.abs(matrix)).all())


def decoupled(system: Any) -> "tuple[np.ndarray, np.ndarray, np.ndarray] | None":
    """(ω², 2ζω, shapes) of modes that damping does not couple; None where it does, and of an M that is not positive
    definite."""
    reduced = _reduced(system)
    return None if reduced is None else _decoupled(system, *reduced)


def _decoupled(system, K, C, back):
    if not (_symmetric(system.K) and _symmetric(system.C)):
        return None
    if not _commute(K, C):
        return None
    squares, turn = np.linalg.eigh((K + K.T) / 2)
    damping = turn.T @ C @ turn
    size = np.abs(turn).T @ np.abs(C) @ np.abs(turn)
    if (np.abs(damping - np.diag(np.diag(damping))) > COUPLED * size).any():
        return None
    return squares, np.diag(damping), back @ turn


def _real_modes(system, K, C, back):
    """(right, left, small) by real modes where damping does not couple them, else None."""
    found = _decoupled(system, K, C, back)
    if found is None:
        return None
    squares, rates, shapes = found

    def small(s):
        at = s[:, None]
        stiffness = squares + at * (rates + at)
        near = (np.abs(stiffness) / (np.abs(squares) + np.abs(at) ** 2)).min(axis=1)
        stiffness[near == 0] = 1.0
        return near, lambda g, turned: g / stiffness

    return shapes, shapes.T, small


def _commute(K, C):
    """Whether K C = C K but for rounding, as seen along one vector."""
    along = probe(len(K))
    apart = K @ (C @ along) - C @ (K @ along)
    K, C = np.abs(K), np.abs(C)
    return (np.abs(apart) <= COUPLED * len(K) * (K @ (C @ along) + C @ (K @ along))).all()


def _complex_modes(K, C, back):
    """(right, left, small) by complex modes, in real numbers; None where these are nearly dependent."""
    n = len(K)
    pace = np.sqrt(max(np.abs(K).max(), np.finfo(float).tiny))
    count_floats(2 * n)
    values, vectors = np.linalg.eig(first_order(K, C, pace))
    pairs, real = values[values.imag > 0], values[values.imag == 0].real
    above = vectors[:, values.imag > 0]
    W = np.hstack([above.real, above.imag, vectors[:, values.imag == 0].real])
    try:
        inverse = np.linalg.inv(W)
    except np.linalg.LinAlgError:
        return None
    if not np.linalg.norm(inverse) * np.linalg.norm(W) < DEPENDENT:
        return None
    return back @ W[:n] / pace, inverse[:, n:] @ back.T, _pairs(pairs, real)


def _pairs(pairs, real):
    """(s − B)⁻¹ of pairs λ, λ̄ and of real eigenvalues."""
    count, size = len(pairs), np.abs(np.concatenate([pairs, real]))

    def small(s):
        at = s[:, None]
        ahead, behind, alone = at - pairs, at - pairs.conj(), at - real
        above = np.where(s.imag < 0, s.conj(), s)[:, None] - np.concatenate([pairs, real])
        near = (np.abs(above) / (np.abs(at) + size)).min(axis=1)
        lost = near == 0
        ahead[lost], alone[lost] = 1.0, 1.0
        straight, across = 0.5 / ahead, 0.5 / behind
        straight, across = straight + across, -1j * (straight - across)
        alone = 1 / alone

        def solved(g, turned):
            first, second, across_ = g[:, :count], g[:, count:2 * count], turned * across
            return np.hstack([straight * first + across_ * second, straight * second - across_ * first,
                              alone * g[:, 2 * count:]])

        return near, solved

    return small
