"""Eigenvalues of M q̈ + (C + G) q̇ + K q = 0 to many digits, by mpmath from the element data.

With a positive definite M, a symmetric K and no G: ω² of L⁻¹ K L⁻ᵀ, M = L Lᵀ. Else λ = σ + 1/μ, with μ the eigenvalues
of the companion form of μ² P(σ) + μ P′(σ) + M, P(λ) = λ² M + λ (C + G) + K: what is singular in M gives μ = 0, in K
λ = 0. What falls with the digits is zero.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

Elements = Callable[[int], "FactoredSystem"]        # of the digits that its numbers of mpmath shall have
LARGEST_DAMPED, LARGEST = 24, 100       # coordinates, whose eigenvalues take about a minute
ZERO = 3            # a number below the third part of the digits is none
SHIFT = 7 / 8       # of the largest rate


def eigenvalues(elements: Elements, digits: int = DIGITS) -> TrueValues:
    """All λ with Im λ ≥ 0 by ascending |λ|, of |λ| alike by descending Re λ; a real one as often as it occurs."""
    _require_few(elements(30), LARGEST_DAMPED)
    return settled(lambda: (_quadratic(*matrices(elements)), None), digits)


def squares(elements: Elements, digits: int = DIGITS) -> TrueValues:
    """All ω² of the system without C and G, ascending, of K that is not symmetric by real part; about: the shapes, each
    with its largest component 1, where M is positive definite and K symmetric, else None."""
    first = elements(30)
    _require_few(first, LARGEST)
    return settled(lambda: _squares(first, elements), digits)


def _squares(first: "FactoredSystem",
             elements: "Callable[..., FactoredSystem]") -> tuple[list[mpmath.mpf], list[list[mpmath.mpf]] | None]:
    plain = not first.massless and not first.circulatory
    return (_symmetric if plain else _pencil)(*matrices(elements)[::2])


def rates(elements: Elements, digits: int = DIGITS) -> TrueValues:
    """λ = √−ω² of the same, with Im λ ≥ 0 and ω² ascending: iω of what oscillates."""
    return as_rates(squares(elements, digits + 1))


def as_rates(found: TrueValues) -> TrueValues:
    """√−ω² of each, with Im λ ≥ 0."""
    with mpmath.workdps(found.working):
        return found._replace(values=_upper_roots(found.values), digits=found.digits - 1)


def rates_at_once(elements: Elements) -> list[mpmath.mpc]:
    """λ = iω of a system without C, at the working precision, of which nothing tells how good they are."""
    first = elements(30)
    _require_few(first, LARGEST_DAMPED)
    return _quadratic(*matrices(elements)) if any(first.G.values()) else _upper_roots(_squares(first, elements)[0])


def _upper_roots(squares: Sequence[mpmath.mpf]) -> list[mpmath.mpc]:
    roots = [mpmath.sqrt(-x) for x in squares]
    return [-x if mpmath.im(x) < 0 else x for x in roots]


def matrices(elements: Elements) -> tuple[mpmath.matrix, mpmath.matrix, mpmath.matrix]:
    """M, C + G and K of the element data at the working precision."""
    found = elements(mpmath.mp.dps)
    M, C, G, K = (_matrix(entries, found.n) for entries in found.matrices())
    return M, C + G, K


def _matrix(entries: Mapping[tuple[int, int], mpmath.mpf], n: int) -> mpmath.matrix:
    result = mpmath.zeros(n, n)
    for pair, x in entries.items():
        result[pair] = mpmath.mpf(x)
    return result


def _require_few(elements: "FactoredSystem", most: int) -> None:
    if elements.pieces:
        raise PhysicsError("members have no matrices: their frequencies are roots of a determinant")
    if elements.n > most:
        raise PhysicsError(f"the reference takes too long: eigenvalues to many digits are found of up to {most} "
                           f"coordinates, and these are {elements.n}", "ask for fewer coordinates")


def _symmetric(M: mpmath.matrix, K: mpmath.matrix) -> tuple[list[mpmath.mpf], list[list[mpmath.mpf]]]:
    """(ω², shapes) of a positive definite M."""
    L = mpmath.cholesky(M)
    inverse = L ** -1
    values, vectors = mpmath.eigsy(inverse * K * inverse.T)
    shapes = inverse.T * vectors
    order = sorted(range(M.rows), key=lambda i: values[i])
    return cleaned([values[i] for i in order]), [_normalised(shapes.column(i)) for i in order]


def _normalised(column: mpmath.matrix) -> list[mpmath.mpf]:
    largest = max(column, key=abs)
    return [x / largest for x in column]


def _pencil(M: mpmath.matrix, K: mpmath.matrix) -> tuple[list[mpmath.mpf], None]:
    """ω² = 1/μ − σ, μ of (K + σ M)⁻¹ M."""
    shift = _size(K) / _size(M) * mpmath.mpf(SHIFT)
    found = finite(mpmath.eig(_solved(K + shift * M, M), left=False, right=False))
    return sorted(cleaned([1 / mu - shift for mu in found]), key=lambda x: (mpmath.re(x), mpmath.im(x))), None


def _quadratic(M: mpmath.matrix, C: mpmath.matrix, K: mpmath.matrix) -> list[mpmath.mpc | mpmath.mpf]:
    """λ of P(λ) q = 0."""
    n = M.rows
    shift = mpmath.mpf(SHIFT) * max(mpmath.sqrt(_size(K) / _size(M)), _size(C) / _size(M))
    at_shift = shift * shift * M + shift * C + K
    first, second = _solved(at_shift, 2 * shift * M + C), _solved(at_shift, M)
    companion = mpmath.zeros(2 * n, 2 * n)
    companion[:n, :n], companion[:n, n:] = -first, -second
    for i in range(n):
        companion[n + i, i] = 1
    found = cleaned([shift + 1 / mu for mu in finite(mpmath.eig(companion, left=False, right=False))])
    return by_size([x for x in found if mpmath.im(x) >= 0])


def by_size(values: Sequence[mpmath.mpc | mpmath.mpf]) -> list[mpmath.mpc | mpmath.mpf]:
    """Numbers by ascending magnitude, those of one magnitude by descending real part."""
    result, small = [], threshold()
    for x in sorted(values, key=abs):
        group = result[-1] if result else []
        if group and abs(x) - abs(group[-1]) <= small * abs(x):
            group.append(x)
        else:
            result.append([x])
    return [x for group in result for x in sorted(group, key=lambda y: -mpmath.re(y))]


def _solved(A: mpmath.matrix, B: mpmath.matrix) -> mpmath.matrix:
    """A⁻¹ B."""
    return A ** -1 * B


def _size(A: mpmath.matrix) -> mpmath.mpf:
    """The largest entry of a matrix, one where there is none."""
    return max(map(abs, A)) or mpmath.mpf(1)


def finite(inverses: Sequence[mpmath.mpc | mpmath.mpf]) -> list[mpmath.mpc | mpmath.mpf]:
    """The numbers but for those that fall with the digits."""
    least = threshold() * max(map(abs, inverses))
    return [x for x in inverses if abs(x) > least]


def cleaned(values: Sequence[mpmath.mpc | mpmath.mpf]) -> list[mpmath.mpc | mpmath.mpf]:
    """Each number with zero for itself where it is none beside the largest, and for each part where that is none beside
    the number."""
    small = threshold()
    least = small * max(map(abs, values), default=0)
    return [_cleaned(x, small) if abs(x) > least else mpmath.mpf(0) for x in values]


def _cleaned(x: mpmath.mpc | mpmath.mpf, small: mpmath.mpf) -> mpmath.mpc | mpmath.mpf:
    re, im = mpmath.re(x), mpmath.im(x)
    if abs(im) <= small * abs(x):
        return re
    return mpmath.mpc(0 if abs(re) <= small * abs(x) else re, im)


def threshold() -> mpmath.mpf:
    """What falls below it with the digits is zero."""
    return mpmath.mpf(10) ** (-mpmath.mp.dps // ZERO)
