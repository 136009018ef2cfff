"""Which eigenvalues share a block, and the subspace that belongs to them."""

from collections.abc import Sequence

import numpy as np

from vibcli.analyses.transient.static_condensation import leading
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.components import components
from vibcli.numerics.fixed_point import count_floats

CLOSE, EQUAL = 0.05, 1e-9
TINY = 1e-6
SKEW = 30.0


class EigenvalueCluster(NamedTuple):
    """Eigenvalues of one block and their vectors as columns; half: the conjugates are left out."""

    values: np.ndarray
    vectors: np.ndarray
    half: bool


def groups(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> list[EigenvalueCluster]:
    """The eigenvalues of λ² M + λ C + K in Groups: alone, but where close ones have nearly parallel vectors.

    Coordinates without inertia come last.
    """
    A = first_order(M, C, K)
    count_floats(len(A))
    values, V = np.linalg.eig(A)
    values, V = values.astype(complex), V.astype(complex)
    with np.errstate(over="ignore"):
        skew = condition(values, V, len(M))
    size, top = np.abs(values), np.abs(values).max(initial=0.0)
    gap = np.abs(np.subtract.outer(values, values))
    close = (gap <= CLOSE * np.maximum.outer(size, size)) | (np.maximum.outer(size, size) <= TINY * top)
    joined = close & np.logical_and.outer(skew > SKEW, skew > SKEW) | (gap <= EQUAL * np.maximum.outer(size, size))
    found = []
    for members in components(joined):
        some = values[members]
        if (some.imag < 0).all():
            continue
        found.append(EigenvalueCluster(some, V[:, members], bool((some.imag > 0).all())))
    return found


def joined(found: Sequence[EigenvalueCluster], i: int, j: int) -> list[EigenvalueCluster]:
    """The groups with two made one; one that is joined to its own conjugates holds both."""
    rest = [group for k, group in enumerate(found) if k not in (i, j)]
    pair = [found[k] for k in sorted({i, j})]
    half = i != j and all(group.half for group in pair)
    both = [group for group in pair if group.half and not half]
    pair += [EigenvalueCluster(group.values.conj(), group.vectors.conj(), False) for group in both]
    return [*rest, EigenvalueCluster(np.concatenate([group.values for group in pair]),
                         np.concatenate([group.vectors for group in pair], axis=1), half)]


def first_order(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> np.ndarray:
    """A of ẏ = A y, y = (q, q̇), the velocities being those of the h coordinates that have inertia."""
    n, (h, lead) = len(M), leading(M, C)
    rates = -np.linalg.solve(lead, np.concatenate([K, C[:, :h]], axis=1))
    return np.concatenate([np.eye(h, n + h, n), rates])


def condition(values: np.ndarray, V: np.ndarray, n: int) -> np.ndarray:
    """How nearly each vector lies in the span of the others: ‖column‖ ‖row of the inverse‖, q̇ measured in |λ| q."""
    rates = np.maximum(np.abs(values), TINY * np.abs(values).max(initial=0.0)) + np.finfo(float).tiny
    try:
        N = np.linalg.inv(V)
    except np.linalg.LinAlgError:
        return np.full(len(V), np.inf)
    column = np.hypot(np.linalg.norm(V[:n], axis=0), np.linalg.norm(V[n:], axis=0) / rates)
    found: np.ndarray = column * np.hypot(np.linalg.norm(N[:, :n], axis=1), np.linalg.norm(N[:, n:], axis=1) * rates)
    return found


def starting(M: np.ndarray, C: np.ndarray, K: np.ndarray,
             group: EigenvalueCluster) -> tuple[np.ndarray, np.ndarray, bool]:
    """(X, B, half) with M X B² + C X B + K X ≈ 0 of one group: X, B real where the group holds its own conjugates."""
    n, p, whole = len(M), len(group.values), len(group.vectors)
    if p == 1:
        x, value = group.vectors[:n], group.values
        if not group.half:
            x, value = (x * (np.abs(x).max() / x[np.argmax(np.abs(x))])).real, value.real
        return x / np.linalg.norm(x), value[None], group.half
    if p == whole:
        return np.eye(n, p), first_order(M, C, K), False
    A = first_order(M, C, K)
    Q = group.vectors if group.half else np.concatenate([group.vectors.real, group.vectors.imag], axis=1)
    Q = np.linalg.svd(Q)[0][:, :p]
    middle = group.values.mean() if group.half else group.values.mean().real
    shift = middle + 2.0 ** (-52 / (p + 1)) * 1e-3 * np.abs(A).max()
    for _ in range(2):
        Q = np.linalg.qr(np.linalg.solve(A - shift * np.eye(whole), Q))[0]
    return Q[:n], Q.conj().T @ A @ Q, group.half
