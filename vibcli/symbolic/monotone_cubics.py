"""Monotone cubics between points (Fritsch & Carlson 1980, the slopes by Fritsch & Butland 1984) in exact fractions.

    F = Fₐ + mₐ t + c₂ t² + c₃ t³,  t = u − a,  between two points of which a is the one nearer to u = 0

The slope at a point is the mean (w₁ + w₂)/(w₁/δ₁ + w₂/δ₂), w₁ = h₁ + 2h₂, w₂ = 2h₁ + h₂, of those δ of its two sides,
and zero where they differ in sign. V = ∫₀ᵘ F du follows exactly.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.rationals import bits


class Cubic(NamedTuple):
    """Coefficients of F by powers of u − anchor, on [low, high]; None where it has no end."""

    low: Fraction | None
    high: Fraction | None
    anchor: Fraction
    coefficients: tuple[Fraction, ...]

    def at(self, u: Fraction) -> Fraction:
        """F(u)."""
        return sum((c * (u - self.anchor) ** k for k, c in enumerate(self.coefficients)), Fraction(0))

    def gained(self, u: Fraction) -> Fraction:
        """∫ F du from the anchor."""
        return sum((c * (u - self.anchor) ** (k + 1) / (k + 1) for k, c in enumerate(self.coefficients)), Fraction(0))

    def about(self, a: Fraction) -> "Cubic":
        """The same with another anchor."""
        c, h = [*self.coefficients, Fraction(0), Fraction(0)][:4], a - self.anchor
        moved = (self.at(a), c[1] + h * (2 * c[2] + 3 * h * c[3]), c[2] + 3 * h * c[3], c[3])
        return self._replace(anchor=a, coefficients=moved)


def slopes(u: Sequence[Fraction], F: Sequence[Fraction]) -> list[Fraction]:
    """F′ at the points."""
    h = [b - a for a, b in pairwise(u)]
    rise = [(b - a) / step for (a, b), step in zip(pairwise(F), h, strict=True)]
    if len(h) == 1:
        return rise * 2
    inner = [_mean(*pair) for pair in zip(pairwise(h), pairwise(rise), strict=True)]
    return [_at_end(h[:2], rise[:2]), *inner, _at_end(h[:-3:-1], rise[:-3:-1])]


def _mean(steps: tuple[Fraction, Fraction], rises: tuple[Fraction, Fraction]) -> Fraction:
    (h, following), (before, after) = steps, rises
    if before * after <= 0:
        return Fraction(0)
    first, second = h + 2 * following, 2 * h + following
    return (first + second) / (first / before + second / after)


def _at_end(steps: list[Fraction], rises: list[Fraction]) -> Fraction:
    """By the parabola through three points, as far as that keeps the cubic between the values of its ends."""
    (h, following), (rise, after) = steps, rises
    found = ((2 * h + following) * rise - h * after) / (h + following)
    if found * rise <= 0:
        return Fraction(0)
    return 3 * rise if rise * after < 0 and abs(found) > 3 * abs(rise) else found


def cubics(u: Sequence[Fraction], F: Sequence[Fraction], linear: bool) -> list[Cubic]:
    """The cubics between points, one of them cut at u = 0; beyond the ends straight lines, if it is `linear` there."""
    m, found = slopes(u, F), []
    for (a, b), (Fa, Fb), (ma, mb) in zip(pairwise(u), pairwise(F), pairwise(m), strict=True):
        h = b - a
        rise = (Fb - Fa) / h
        whole = Cubic(a, b, a, (Fa, ma, (3 * rise - 2 * ma - mb) / h, (ma + mb - 2 * rise) / h**2))
        stops = [a, Fraction(0), b] if a < 0 < b else [a, b]
        found += [whole._replace(low=low, high=high).about(low if low >= 0 else high) for low, high in pairwise(stops)]
    if linear:
        found.insert(0, Cubic(None, u[0], u[0], (F[0], m[0], Fraction(0), Fraction(0))))
        found.append(Cubic(u[-1], None, u[-1], (F[-1], m[-1], Fraction(0), Fraction(0))))
    return found


def energies(pieces: Sequence[Cubic], precision: int) -> list[Fraction]:
    """∫₀ᵃ F du of the anchor a of each piece, rounded to so many bits of the smallest part that it is made of."""
    start = max(k for k, piece in enumerate(pieces) if piece.anchor == 0)
    found = [Fraction(0)] * len(pieces)
    for order in (range(start + 1, len(pieces)), range(start - 1, -1, -1)):
        total, last = Fraction(0), pieces[start]
        for k in order:
            total += _rounded(last.gained(pieces[k].anchor), precision)
            found[k], last = total, pieces[k]
    return found


def _rounded(x: Fraction, precision: int) -> Fraction:
    if bits(x) <= precision or not x:
        return x
    scale = precision - (abs(x.numerator).bit_length() - x.denominator.bit_length())
    return Fraction(round(x * Fraction(2) ** scale)) / Fraction(2) ** scale
