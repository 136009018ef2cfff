"""Roots such as those of equal masses in a row: λ = s + t·2cos(2πj/N), s and t rational in the letters.

λ = tμ + s makes a polynomial with numbers for coefficients of such a factor. Its roots are compared with the conjugate
numbers 2cos(2πj/N) to many digits: a rational map that takes the one set into the other exactly is unique.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, prod
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    import mpmath

    from vibcli.symbolic.node import Node
    from vibcli.symbolic.rational_functions import Quotients

LARGEST, DIGITS, HEIGHT = 60, 60, 59        # N; working digits; denominators of the map
PLACES = (2, 1), (5, 3)         # values of the letters, the first and by how much each is larger than the one before


class Cosine:
    """λ = shift + scale·2cos θ, θ = 2πj/N."""

    pair = None

    def __init__(self, quotients: "Quotients", shift: Any, scale: Any, j: int, N: int) -> None:
        self.quotients, self.shift, self.scale, self.j, self.N = quotients, shift, scale, j, N
        self.square = self._short() or self.value([quotients.field(0), quotients.field(1)])

    def _short(self) -> "Node | None":
        """2s·sin²(θ/2) where s = −t·2, 2s·sin²((π − θ)/2) where s = t·2, else None."""
        if self.shift not in (2 * self.scale, -2 * self.scale):
            return None
        turns = Fraction(self.j, self.N)
        angle = self.quotients.table.pi * (turns if self.shift == -2 * self.scale else abs(Fraction(1, 2) - turns))
        return self.quotients.node(self.shift * 2) * self.quotients.table.call("sin", angle) ** 2

    def value(self, element: Sequence[Any]) -> "Node":
        """u₀ + u₁λ + u₂λ² + … as a sum of cosines of multiples of θ."""
        powers = [self.quotients.field(0)]
        for u in reversed(element):             # Horner, in λ = s + t·2cos θ
            shifted, powers = [self.shift * w for w in powers], _doubled([self.scale * w for w in powers])
            for k, w in enumerate(shifted):
                powers[k] += w
            powers[0] += u
        table = self.quotients.table
        angles = [table.pi * Fraction(2 * self.j * k, self.N) for k in range(len(powers))]
        waves = [table.one, *(2 * table.call("cos", angle) for angle in angles[1:])]
        return table.sum(*((self.quotients.node(w) * wave, ONE) for w, wave in zip(powers, waves, strict=True) if w))

    def omega(self, samples: Sequence[dict[str, float]], sign: int = 1) -> "Node":
        """√(±λ)."""
        return root(sign * self.square, samples)


def _doubled(waves: Sequence[Any]) -> list[Any]:
    """Σ wₖ 2cos kθ (w₀ alone without the 2) times 2cos θ, in the same form."""
    found = [waves[0] * 0 for _ in range(len(waves) + 1)]
    for k, w in enumerate(waves):
        found[k + 1] += w
        if k == 1:
            found[0] += 2 * w
        elif k > 1:
            found[k - 1] += w
    return found


def cosines(quotients: "Quotients", modulus: Sequence[Any]) -> list[Cosine] | None:
    """The roots of p₀ + p₁λ + …, ascending, or None."""
    d = len(modulus) - 1
    numbers = _numeric(quotients, modulus)
    if numbers is None:
        return None
    scale, shift, coefficients = numbers
    found = _matched(coefficients, d)
    if found is None:
        return None
    N, a, b = found
    a, b = quotients.number(a), quotients.number(b)
    return [Cosine(quotients, shift + scale * a, scale * b, j, N) for j in range(1, N // 2 + 1) if gcd(j, N) == 1]


def _numeric(quotients: "Quotients", modulus: Sequence[Any]) -> tuple[Any, Any, list[Fraction]] | None:
    """(t, s, rational coefficients of the polynomial in μ) with λ = tμ + s; None where there are no such."""
    d, lead = len(modulus) - 1, modulus[-1]
    zero = quotients.field(0)
    for shift in (zero, -modulus[-2] / (lead * d)):
        moved = _moved([c / lead for c in modulus], shift, zero)
        scale = _scale(quotients, moved) if _in_proportion(quotients, moved) else None
        if scale is None:
            continue
        numbers = [c / scale ** (d - i) for i, c in enumerate(moved)]
        if all(c.numer.is_ground and c.denom.is_ground for c in numbers):
            return scale, shift, [quotients.rational(c.numer.LC / c.denom.LC) if c else Fraction(0) for c in numbers]
    return None


def _in_proportion(quotients: "Quotients", moved: Sequence[Any]) -> bool:
    """May all c_{d−i} be numbers times tⁱ? Then the ratios c_{d−i}ᵏ/c_{d−k}ⁱ, of the first c_{d−k} that is not 0, are
    the same at two places."""
    d, k, found = len(moved) - 1, 1 if moved[-2] else 2, []
    for first, step in PLACES:
        place = [first + step * i for i in range(len(quotients.ring.gens))]
        try:
            values = [_at(quotients, c.numer, place) / _at(quotients, c.denom, place) for c in moved]
            found.append([value ** k / values[d - k] ** (d - i) for i, value in enumerate(values)])
        except ZeroDivisionError:
            return True
    return found[0] == found[1]


def _at(quotients: "Quotients", polynomial: Any, place: Sequence[int]) -> Fraction:
    return sum((quotients.rational(value) * prod(x ** power for x, power in zip(place, powers, strict=True))
                for powers, value in polynomial.terms()), Fraction(0))


def _scale(quotients: "Quotients", moved: Sequence[Any]) -> Any:
    """A quotient t with c_{d−1}/t or c_{d−2}/t² a number."""
    if moved[-2]:
        numer, denom = moved[-2].numer.primitive()[1], moved[-2].denom.primitive()[1]
        return quotients.field(numer) / quotients.field(denom)
    if not moved[-3]:
        return None
    parts = []
    for polynomial in (moved[-3].numer, moved[-3].denom):
        _, factors = quotients.factors(polynomial)
        if any(power % 2 for _, power in factors):
            return None
        part = quotients.ring(1)
        for factor, power in factors:
            part *= factor ** (power // 2)
        parts.append(quotients.field(part))
    return parts[0] / parts[1]


def _moved(coefficients: Sequence[Any], shift: float, zero: Any) -> list[Any]:
    """The coefficients of p(μ + shift)."""
    found = [zero]
    for c in reversed(coefficients):
        found = [zero, *found]
        for i in range(len(found) - 1):
            found[i] += shift * found[i + 1]
        found[0] += c
    return found[:len(coefficients)]


def _matched(coefficients: Sequence[Fraction], d: int) -> tuple[int, Fraction, Fraction] | None:
    """(N, a, b) with the roots of the polynomial the numbers a + b·2cos(2πj/N), j prime to N; None where none are."""
    import mpmath

    with mpmath.workdps(DIGITS):
        try:
            roots = mpmath.polyroots([mpmath.mpf(c.numerator) / c.denominator for c in reversed(coefficients)],
                                     maxsteps=200, extraprec=200)
        except mpmath.libmp.NoConvergence:
            return None
        if any(abs(mpmath.im(r)) > mpmath.mpf(10) ** (10 - DIGITS) for r in roots):
            return None
        roots = sorted(mpmath.re(r) for r in roots)
        for N in range(2 * d + 1, LARGEST + 1):
            angles = [j for j in range(1, N // 2 + 1) if gcd(j, N) == 1]
            if len(angles) != d:
                continue
            waves = sorted(2 * mpmath.cospi(mpmath.mpf(2 * j) / N) for j in angles)
            found = _map(waves, roots, mpmath)
            if found is not None:
                a, b = found
                return N, a, b
    return None


def _map(waves: "Sequence[mpmath.mpf]", roots: "Sequence[mpmath.mpf]", mpmath: Any) -> Sequence[Fraction] | None:
    """Rational (a, b), b > 0, with roots = a + b·waves to almost all digits."""
    b = (roots[-1] - roots[0]) / (waves[-1] - waves[0])
    a = roots[0] - b * waves[0]
    tolerance = mpmath.mpf(10) ** (20 - DIGITS)
    rational = [Fraction(mpmath.nstr(x, DIGITS)).limit_denominator(HEIGHT) for x in (a, b)]
    a, b = (mpmath.mpf(x.numerator) / x.denominator for x in rational)
    if any(abs(a + b * w - r) > tolerance for w, r in zip(waves, roots, strict=True)):
        return None
    return rational


