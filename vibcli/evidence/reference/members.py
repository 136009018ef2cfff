"""Natural frequencies of members to many digits: roots of a determinant that has no poles, by power series.

Each piece, B u⁗ − ((N + n x) u′)′ + (k − μ z) u = 0, z = ω², has the solutions Σ aₖ xᵏ that its first four coefficients
start (two where B = 0). The unknowns are these and the coordinates q, the equations that its ends move with q, and
(K − z M) q + Σ Sᵀ F = 0 with the forces F at its ends. No stiffness is formed, so nothing is divided by. Roots are
begun from finite elements, and kept where they are as many and as near.
"""

from collections.abc import Sequence
from math import perm
from typing import TYPE_CHECKING, Any, cast

import mpmath
import numpy as np

from vibcli.analyses.continuous.finite_elements import finite_elements, slack_ends
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.modal import Elements
from vibcli.evidence.reference.settled import DIGITS, DoesNotSettle, TrueValues, settled
from vibcli.numerics.pieces.piece import Piece

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

START = 80              # digits: of what cancels in the series
LARGEST = 60            # unknowns
ELEMENTS = 24           # of a piece and a mode, at first
NEAR, APART = 1e-2, 1e-8        # of a root: to what it was begun from, to its neighbours
TINY = 1e-30            # an ω² beside which all others are large
STEPS, STEP = 60, 1e-7
FOUND = DIGITS + 5      # digits to which the last two secants agree; a determinant of beams under tension loses many


def squares(elements: Elements, count: int) -> TrueValues:
    """The lowest ω² of so many modes; PhysicsError where two of them are too close, and of pieces of other kinds."""
    first = elements(30)
    require_plain(first)
    near = by_elements(first, count, ELEMENTS * count)
    free = _zeros(elements(START))
    if any(b - a <= APART * abs(b) for a, b in zip(near[free:], near[free + 1:], strict=False)):
        raise PhysicsError("two frequencies are so close that no reference is found of them")
    near[:free] = [0.0] * min(free, len(near))
    last: list[Any] = list(near)

    def found() -> "tuple[list[mpmath.mpf], None]":
        last[:] = _roots(elements(mpmath.mp.dps), near, last)
        return list(last), None

    return settled(found, DIGITS + 1, START)


def require_plain(elements: "FactoredSystem") -> None:
    """PhysicsError of pieces whose series this is not, and of too many."""
    unknowns = elements.n + sum(placed.piece.order for placed in elements.pieces)
    if any(type(placed.piece) is not Piece or slack_ends(placed) for placed in elements.pieces) or elements.G:
        raise PhysicsError("no reference is found of members that vary along their length, end without tension or are "
                           "gyroscopic")
    if unknowns > LARGEST:
        raise PhysicsError(f"the reference takes too long: {unknowns} unknowns, of up to {LARGEST}")


def by_elements(elements: "FactoredSystem", count: int, divisions: int) -> list[float]:
    """The lowest eigenvalues in floats, each piece being so many finite elements."""
    import scipy.linalg

    try:
        K, M = with_inertia(*finite_elements(elements.each(float), divisions))
        found = scipy.linalg.eigh(K, M, eigvals_only=True, subset_by_index=[0, min(count, len(K)) - 1])
    except np.linalg.LinAlgError as error:
        raise PhysicsError("no reference is found of these members: in finite elements a matrix of theirs is "
                           "singular to rounding") from error
    return cast("list[float]", np.sort(found).tolist())


def with_inertia(K: np.ndarray, M: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """K and M of the coordinates that have inertia, the others following at rest: K − K₁₂ K₂₂⁻¹ K₂₁ (Guyan 1965)."""
    light = np.diag(M) == 0
    if not light.any() or light.all():
        return K, M
    here = np.ix_(~light, ~light)
    follow = np.linalg.solve(K[np.ix_(light, light)], K[np.ix_(light, ~light)])
    return K[here] - K[np.ix_(~light, light)] @ follow, M[here]


def _zeros(elements: "FactoredSystem") -> int:
    """How many eigenvalues are zero: the power of z by which the determinant begins."""
    with mpmath.workdps(START):
        one, two = (determinant(elements, mpmath.mpf(TINY) * k) for k in (1, 2))
        return int(mpmath.nint(mpmath.log(abs(two / one), 2)))


def _roots(elements: "FactoredSystem", near: Sequence[float], starts: Sequence[Any]) -> list[mpmath.mpf]:
    """Those near by, from where secants start: what fewer digits found."""
    found = []
    for z, start in zip(near, starts, strict=True):
        if not z:
            found.append(mpmath.mpf(0))
            continue
        root = _root(elements, start)
        if abs(root - z) > NEAR * abs(z) or any(abs(root - other) <= APART * abs(root) for other in found):
            raise DoesNotSettle("the reference does not settle: a root lies elsewhere than finite elements have it")
        found.append(root)
    return found


def _root(elements: "FactoredSystem", start: float | mpmath.mpf) -> mpmath.mpf:
    """By secants."""
    x, y = mpmath.mpf(start), mpmath.mpf(start) * (1 - mpmath.mpf(STEP))
    at_x, at_y = determinant(elements, x), determinant(elements, y)
    for _ in range(STEPS):
        if at_x == at_y:
            return y
        x, y, at_x = y, y - at_y * (y - x) / (at_y - at_x), at_y
        if abs(y - x) <= mpmath.mpf(10) ** -FOUND * abs(y):
            return y
        at_y = determinant(elements, y)
    raise ValueError("no root is found near by")


def determinant(elements: "FactoredSystem", z: Any, s: Any = 0) -> Any:
    """Of all equations at z = ω², and s = iω where dampers and drag count, whose roots are the eigenvalues."""
    return _determinant(equations(elements, z, s).tolist())


def equations(elements: "FactoredSystem", z: Any, s: Any = 0) -> Any:
    """All equations at z = ω², as a matrix; s: iω where dampers and drag count."""
    size = elements.n + sum(placed.piece.order for placed in elements.pieces)
    M, C, G, K = elements.with_parts(pieces=()).matrices()
    A = mpmath.zeros(size, size)
    for part, factor in ((K, 1), (M, -z), (C, s), (G, s)):
        for (i, j), x in part.items():
            A[i, j] += factor * x
    column = elements.n
    for placed in elements.pieces:
        moves, forces = ends(placed.piece, z, s)
        for place, (row, move, force) in enumerate(zip(placed.rows, moves, forces, strict=True)):
            for i, x in row.items():
                A[column + place, i] -= x
                for k, f in enumerate(force):
                    A[i, column + k] += x * f
            for k, u in enumerate(move):
                A[column + place, column + k] += u
        column += placed.piece.order
    return A


def _determinant(A: np.ndarray) -> mpmath.mpf:
    """By elimination with pivots."""
    found = mpmath.mpf(1)
    for i in range(len(A)):
        best = max(range(i, len(A)), key=lambda k: abs(A[k][i]))
        if not A[best][i]:
            return mpmath.mpf(0)
        if best != i:
            A[i], A[best], found = A[best], A[i], -found
        found *= A[i][i]
        for row in A[i + 1:]:
            if row[i]:
                factor = row[i] / A[i][i]
                row[i:] = [x - factor * y for x, y in zip(row[i:], A[i][i:], strict=True)]
    return found


def ends(piece: Piece, z: Any, s: Any = 0) -> tuple[list[list[mpmath.mpf]], list[list[mpmath.mpf]]]:
    """(displacements and turns, forces and moments) of both ends, each as a row over the solutions of the piece."""
    far = [derivatives(piece, z, s, k) for k in range(piece.order)]
    begin = [[mpmath.mpf(int(k == i)) * (1, 1, 2, 6)[i] for k in range(piece.order)] for i in range(piece.order)]
    return at_ends(piece, begin, [[one[i] for one in far] for i in range(piece.order)])


def at_ends(piece: Piece, begin: Sequence[list[Any]],
            end: Sequence[list[Any]]) -> tuple[list[list[Any]], list[list[Any]]]:
    """The same by the derivatives [u, u′, …] at both ends, each a row over solutions."""
    order, L, B = piece.order, piece.length, piece.bending
    N, N_end = piece.tension, piece.tension + piece.gradient * L
    if order == 2:
        return [begin[0], end[0]], [[-N * x for x in begin[1]], [N_end * x for x in end[1]]]
    return [begin[0], begin[1], end[0], end[1]], [
        [B * third - N * first for third, first in zip(begin[3], begin[1], strict=True)], [-B * x for x in begin[2]],
        [N_end * first - B * third for third, first in zip(end[3], end[1], strict=True)], [B * x for x in end[2]]]


def derivatives(piece: Piece, z: Any, s: Any, number: int | None, load: Sequence[mpmath.mpc] = ()) -> list[mpmath.mpf]:
    """[u, u′, u″, u‴] at the far end of the solution that begins with xⁿᵘᵐᵇᵉʳ, or with nothing under a load per length
    with coefficients of (x/L)ᵏ: of the coefficients aₖ of (x/L)ᵏ."""
    order, L = piece.order, piece.length
    square, N, n = L**2, piece.tension, piece.gradient * L
    kappa, stiff = (piece.foundation + piece.drag * s - piece.inertia * z) * square, piece.bending / square
    a = [mpmath.mpf(0)] * order
    if number is not None:
        a[number] = L**number
    k, small, largest = 0, 0, max(map(abs, a))
    while small <= 2 * order or k < len(load):
        right = square * load[k] if k < len(load) else mpmath.mpf(0)
        right -= kappa * a[k] if a[k] else 0
        right += n * ((k + 1) ** 2 * a[k + 1]) if n and a[k + 1] else 0
        if order == 4:      # B/L² (k+4)(k+3)(k+2)(k+1) aₖ₊₄ = N (k+2)(k+1) aₖ₊₂ + n (k+1)² aₖ₊₁ − κ aₖ + L² pₖ
            right += N * ((k + 2) * (k + 1) * a[k + 2]) if N and a[k + 2] else 0
            a.append(right / (stiff * ((k + 4) * (k + 3) * (k + 2) * (k + 1))) if right else right)
        else:               # N (k+2)(k+1) aₖ₊₂ = κ aₖ − n (k+1)² aₖ₊₁ − L² pₖ
            a.append(-right / (N * ((k + 2) * (k + 1))) if right else right)
        k += 1
        size = abs(a[-1])
        largest = max(largest, size)
        small = small + 1 if not size or size * k**3 <= mpmath.eps * largest else 0
    own = [(j, x) for j, x in enumerate(a) if x]
    return [sum((perm(j, i) * x for j, x in own if j >= i), mpmath.mpf(0)) / L**i for i in range(4)]
