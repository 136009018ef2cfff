"""The lowest eigenvalues of K x = λ M x of sparse matrices, none missed, each with a bound.

In slices: a count of the negative pivots of K − σM on either side tells how many there are between, Lanczos' method in
(K − σM)⁻¹ M about the middle finds them (Ericsson & Ruhe 1980; ARPACK). The vectors are then improved by residuals
in twice the digits. With X nearly M-orthonormal, H = XᵀKX, R = KX − MXΘ and all other eigenvalues at least η_j away
from θ_j, the eigenvalues of the slice are off by at most those of H − Θ and ‖R‖²/η_j (Li & Li 2005, theorem 2), the
norm being that of M⁻¹.
"""

from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import counted
from vibcli.numerics import double_double as dd
from vibcli.numerics.double_double import DoubleDouble
from vibcli.numerics.inertia import Pencil, ShiftedFactors
from vibcli.numerics.sparse_form import LEAF, UNIT

SLICE, MOST = 16, 400               # eigenvalues at a time; that may lie too close to be parted
SPARE = 4, 32, 128                  # eigenvalues beyond these among which there may be a gap, in turn
STEPS, ROUNDS = 120, 4              # of the search for a shift; of improvement
NEAR, WIDE = 1e-6, 1e-2             # relative: gap in which a slice may end, and ends
CLOSE = 1e-4                        # relative: gap of vectors that are not told apart by it


class Unsettled(Exception):
    """The eigenvalues are not told apart, or not found, in floats."""


class Slice(NamedTuple):
    """Eigenvalues ascending, the first of which has `before` below it, their vectors as columns with XᵀMX = 1, and
    bounds of the errors of the eigenvalues; end: where the counted interval ends."""

    before: int
    values: np.ndarray
    vectors: np.ndarray
    errors: np.ndarray
    end: ShiftedFactors


def lowest(pencil: Pencil, count: int, zeros: int = 0, start: ShiftedFactors | None = None) -> list[Slice]:
    """Slices that hold at least `count` more eigenvalues beyond `start`, of the lowest on where it is None; `zeros`:
    how many are known to vanish, where none is negative. Unsettled where floats do not tell."""
    found: list[Slice] = []
    begin = start or _below_all(pencil)
    before = begin.below
    while begin.below < before + count:
        rigid = max(zeros - begin.below, 0)
        wanted = max(min(SLICE, before + count - begin.below), rigid)
        found.append(_slice(pencil, begin, wanted, rigid))
        begin = found[-1].end
    return found


def _below_all(pencil: Pencil) -> ShiftedFactors:
    """ShiftedFactors below which nothing lies."""
    shift = -pencil.top * 2.0**-40
    for _ in range(STEPS):
        found = pencil.factors(shift)
        if found is not None and not found.below and found.margin < -shift:
            return found
        shift *= 4
    raise Unsettled


def _slice(pencil: Pencil, begin: ShiftedFactors, wanted: int, zeros: int) -> Slice:
    """The Slice of the next so many eigenvalues, or a few more, beyond `begin`."""
    for spare in SPARE:
        end = _beyond(pencil, begin, wanted + spare)
        values, vectors = _found(pencil, begin, end)
        gaps = np.diff(values[wanted - 1:]) / np.maximum(abs(values[wanted:]), abs(values[wanted - 1:-1]))
        if gaps.max() > NEAR:
            break
    else:
        raise Unsettled
    last = wanted + int(np.argmax(gaps > min(WIDE, gaps.max() / 2)))
    cut = pencil.factors((values[last - 1] + values[last]) / 2)
    if cut is None or cut.below != begin.below + last:
        raise Unsettled
    return _improved(pencil, begin, cut, vectors[:, :last], zeros)


def _beyond(pencil: Pencil, begin: ShiftedFactors, wanted: int) -> ShiftedFactors:
    """ShiftedFactors of a shift that has at least so many eigenvalues between it and `begin`, few more where these
    allow it."""
    low, high, width = 0.0, None, max(pencil.top * (wanted / pencil.K.n) ** 2, abs(begin.shift) * 2.0**-20)
    for _ in range(STEPS):
        found = pencil.factors(begin.shift + width)
        count = wanted if found is None else found.below - begin.below
        if found is not None and wanted <= count <= 2 * wanted:
            return found
        if found is None:
            width *= 1 + 2.0**-20
        elif count < wanted:
            wider = min((1.3 * wanted / max(count, 0.2)) ** 2, 64.0)
            low, width = width, width * wider if high is None else _middle(width, high[0])
        else:
            high, width = (width, found), _middle(low, width) if low else width * max((1.3 * wanted / count)**2, 1 / 64)
        if high is not None and low and high[0] - low <= NEAR * high[0]:
            break
    if high is None or high[1].below - begin.below > MOST:
        raise Unsettled
    return high[1]


def _middle(low: float, high: float) -> float:
    found: float = (low * high) ** 0.5
    return found


def _found(pencil: Pencil, begin: ShiftedFactors, end: ShiftedFactors) -> tuple[np.ndarray, np.ndarray]:
    """Approximate eigenvalues between two shifts, ascending, and their vectors."""
    count = end.below - begin.below
    middle = pencil.factors((begin.shift + end.shift) / 2)
    if middle is None:
        raise Unsettled
    random, found = np.random.default_rng(1), np.zeros((pencil.K.n, 0))
    while True:
        found = _orthonormal(pencil, np.hstack([found, _lanczos(pencil, middle, count - found.shape[1], found,
                                                                random)]))
        values, found = _rotated(pencil, found)
        inside = (begin.shift < values) & (values < end.shift)
        if inside.sum() >= count:
            return values[inside], found[:, inside]
        if not inside.any():
            raise Unsettled
        found = found[:, inside]


def _lanczos(pencil: Pencil, middle: ShiftedFactors, count: int, known: np.ndarray, random: Any) -> np.ndarray:
    """Eigenvectors of (K − σM)⁻¹M for its largest eigenvalues, those that are known left out."""
    from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigsh

    n, weighed = pencil.K.n, pencil.M.product(known)

    def solved(load: np.ndarray) -> np.ndarray:
        counted(middle.cost)
        load = load - weighed @ (known.T @ load)
        x = middle.solve(load)
        x += middle.solve(load - pencil.K.product(x) + middle.shift * pencil.M.product(x))
        return np.asarray(x - known @ (weighed.T @ x))

    operators = [LinearOperator((n, n), apply, dtype=float) for apply in (pencil.K.product, pencil.M.product, solved)]
    K, M, inverse = operators
    try:
        found: np.ndarray = eigsh(K, count, M, middle.shift, OPinv=inverse, v0=random.standard_normal(n))[1]
        return found
    except ArpackNoConvergence as error:
        result: np.ndarray = error.eigenvectors
        return result


def _orthonormal(pencil: Pencil, x: np.ndarray) -> np.ndarray:
    """Columns with the same span and XᵀMX = 1, by Cholesky's factor, twice."""
    for _ in range(2):
        x = np.linalg.solve(np.linalg.cholesky(x.T @ pencil.M.product(x)), x.T).T
    return x


def _rotated(pencil: Pencil, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Ritz values ascending and their vectors."""
    values, turn = np.linalg.eigh(pencil.K.between(DoubleDouble(x, np.zeros_like(x)))[0])
    return values, x @ turn


def _improved(pencil: Pencil, begin: ShiftedFactors, end: ShiftedFactors, x: np.ndarray, zeros: int) -> Slice:
    """The Slice of approximate eigenvectors between two counts."""
    middle, x, best = pencil.factors((begin.shift + end.shift) / 2), DoubleDouble(x, np.zeros_like(x)), None
    if middle is None:
        raise Unsettled
    for _ in range(ROUNDS):
        checked = _Checked(pencil, x, zeros)
        errors = checked.errors(begin, end)
        if best is None or errors.max() < best[1].max():
            best = checked, errors
        if (errors <= 2 * checked.floor).all():
            break
        x = checked.improved(middle)
    checked, errors = best
    if not np.isfinite(errors).all():
        raise Unsettled
    order = np.argsort(checked.values, kind="stable")
    return Slice(begin.below, checked.values[order], checked.x.hi[:, order], errors[order], end)


class _Checked:
    """Nearly eigenvectors X with what bounds their distance: H = XᵀKX, G = XᵀMX, R = KX − MXΘ.

    values: θ, the quotients of the diagonals, of which so many `zeros` are known to be rigid; rounding: of H and G
    relative to the magnitudes they were added from; floor: what it leaves of every bound.
    """

    def __init__(self, pencil: Pencil, x: DoubleDouble, zeros: int) -> None:
        self.pencil, self.x, self.count = pencil, x, x.hi.shape[1]
        self.H, size = pencil.K.between(x)
        self.G, mass = pencil.M.between(x)
        self.values = self.H.diagonal() / self.G.diagonal()
        off = dd.added(pencil.K.times(x), dd.scaled(pencil.M.times(x), -self.values))
        self.residual = off.hi
        rounded = dd.UNIT * 64 * (pencil.K.terms + pencil.M.terms) * (
            pencil.sizes[0].max() + abs(self.values).max() * pencil.sizes[1].max())
        self.off = np.linalg.norm(off.hi) + rounded * np.linalg.norm(x.hi)
        terms = max(len(pencil.K.weights), len(pencil.M.weights), pencil.K.n)
        rounding = self.count * UNIT * (LEAF + np.log2(terms) + 6)
        size = np.maximum(size, abs(self.values))
        elastic = np.sort(size)[zeros:]
        self.size = np.maximum(size, elastic[0] if len(elastic) and elastic[0] else 1.0)
        self.rounding, self.skew = rounding, rounding * mass.max()
        self.floor = rounding * self.size + self.skew * abs(self.values)

    def errors(self, begin: ShiftedFactors, end: ShiftedFactors) -> np.ndarray:
        """Bounds of the errors of the values; inf where they are not parted from the others."""
        loose = np.linalg.norm(self.G - np.eye(self.count)) + self.skew
        if loose > 0.1:
            return np.full(self.count, np.inf)
        off = self.off / np.sqrt(self.pencil.least * (1 - loose)) * (1 + 2.0**-40)
        away = end.shift - end.margin - off - self.values
        if begin.below:
            away = np.minimum(away, self.values - begin.shift - begin.margin - off)
        root = np.sqrt(self.size)
        crossed = np.linalg.norm((self.H - np.diag(self.values)) / root[:, None] / root)
        spread = (crossed + self.rounding) * self.size
        inner = np.maximum(_moved(self.values, spread), _moved(self.values, -spread))
        with np.errstate(divide="ignore"):
            outer = np.where(away > 0, off * off / away, np.inf)
        found: np.ndarray = inner + abs(self.values) * loose / (1 - loose) + outer
        return found

    def improved(self, middle: ShiftedFactors) -> DoubleDouble:
        """X less what its vectors hold of each other, to first order (Ogita & Aishima 2018), and one step of inverse
        iteration for what they hold of others."""
        gap = self.values[None, :] - self.values[:, None]
        near = abs(gap) <= CLOSE * np.maximum(abs(self.values[:, None]), abs(self.values[None, :]))
        turn = np.where(near, -self.G / 2, (self.H - self.G * self.values) / np.where(near, 1.0, gap))
        np.fill_diagonal(turn, (1 - self.G.diagonal()) / 2)
        step = middle.solve(self.residual)
        turn += self.x.hi.T @ self.pencil.M.product(step)
        low = self.x.lo + (self.x.hi @ turn - step)
        return dd.added(DoubleDouble(self.x.hi, np.zeros_like(low)), DoubleDouble(low, np.zeros_like(low)))


def _moved(values: np.ndarray, spread: np.ndarray) -> np.ndarray:
    """By how much the values in ascending order change where each changes by so much."""
    order = np.argsort(values, kind="stable")
    found = np.empty_like(values)
    found[order] = abs(np.sort(values + spread) - values[order])
    return found
