"""Laplace images of what members and what is attached to them do from a start on, by the waves that run along pieces:

    B u⁗ − N u″ + κ u = f,   κ = μ s² + c s + k,    u = Σ aⱼ e^{−kⱼ x} + bⱼ e^{−kⱼ (l − x)} + uₚ,   B k⁴ − N k² + κ = 0,

    (K + s C + s² M) q + Σ Sᵀ F = (s M + C) q₀ + M q̇₀,      f = p(x) W(s) + (μ s + c) u₀ + μ u̇₀,

the ends of pieces moving with q. What runs along a piece comes e^{−kⱼ l} later, and stands apart from the rest.
"""

from collections.abc import Mapping
from math import perm
from typing import Any

import mpmath

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.exponential_polynomials import NOTHING, ExponentialPolynomial
from vibcli.evidence.reference.member_starts import StartedMembers
from vibcli.evidence.reference.members import at_ends
from vibcli.numerics.pieces.piece import Piece


class RunningPart(NamedTuple):
    """What a wave that has run along a piece adds to equations, {(i, column): number}, times e^{−kl}; delay: l√(μ/N) of
    what is no beam; rest: e^{−kl} but for that delay."""

    piece: int
    entries: Mapping[tuple[int, int], Any]
    rest: Any


def wave_numbers(piece: Piece, s: Any) -> list:
    """kⱼ with Re k ≥ 0 where s is to the right of all that vibrates."""
    kappa = piece.reaction(s)
    if piece.order == 2:
        return [s * mpmath.sqrt(kappa / (piece.tension * s * s))]
    N, root = piece.tension, mpmath.sqrt(piece.tension**2 - 4 * piece.bending * kappa)
    return [mpmath.sqrt((N + sign * root) / (2 * piece.bending)) for sign in (1, -1)]


def delay(piece: Piece) -> Any:
    """Of a wave along it."""
    return piece.length * mpmath.sqrt(piece.inertia / piece.tension)


class MemberImages:
    """The equations of StartedMembers at s: those without what has run along pieces, and RunningParts."""

    def __init__(self, members: StartedMembers, s: Any):
        self.members, self.s, elements = members, s, members.elements
        self.waves = [wave_numbers(placed.piece, s) for placed in elements.pieces]
        self.columns, size = [], elements.n
        for placed in elements.pieces:
            self.columns.append(size)
            size += placed.piece.order
        self.lumped = elements.with_parts(pieces=()).matrices()
        self.given = range(members.n, members.end)
        M, C, G, K = self.lumped
        self.A = mpmath.zeros(size, size)
        for part, factor in ((K, 1), (M, s * s), (C, s), (G, s)):
            for (i, j), x in part.items():
                self.A[i, j] += factor * x
        self.running: list[RunningPart] = []
        for number in range(len(elements.pieces)):
            self._add(number)
        for i in self.given:
            for j in range(size):
                self.A[i, j] = mpmath.mpf(int(i == j))

    def _add(self, number):
        placed, waves, column = self.members.elements.pieces[number], self.waves[number], self.columns[number]
        piece, none = placed.piece, [0] * len(waves)
        begin = [[x for k in waves for x in ((-k) ** m, 0)] for m in range(4)]
        end = [[x for k in waves for x in (0, k**m)] for m in range(4)]
        for (i, j), x in self._ends(placed, column, at_ends(piece, begin, end)).items():
            self.A[i, j] += x
        for place, row in enumerate(placed.rows):
            for i, x in row.items():
                self.A[column + place, i] -= x
        for j, k in enumerate(waves):
            def only(pair, j=j):
                return [*none[:j], *none[:j], *pair, *none[j + 1:], *none[j + 1:]]

            begin, end = ([only((0, k**m)) for m in range(4)], [only(((-k) ** m, 0)) for m in range(4)])
            late = k * piece.length - (self.s * delay(piece) if piece.order == 2 else 0)
            self.running.append(RunningPart(number, {pair: x for pair, x in self._ends(
                placed, column, at_ends(piece, begin, end)).items() if x and pair[0] not in self.given},
                mpmath.exp(-late)))

    def _ends(self, placed, column, ends):
        """{(i, j): what fields do to equations of ends and of coordinates} of (displacements, forces) at ends."""
        found: dict[tuple[int, int], Any] = {}
        for place, (row, move, force) in enumerate(zip(placed.rows, *ends, strict=True)):
            for k, (u, f) in enumerate(zip(move, force, strict=True)):
                found[column + place, column + k] = u
                for i, x in row.items():
                    found[i, column + k] = found.get((i, column + k), 0) + x * f
        return found

    def started(self) -> tuple[list, list]:
        """(right sides, uₚ of each piece) of what it starts with."""
        s, elements = self.s, self.members.elements
        right, (q, v), (M, C, G, _) = [mpmath.mpc(0)] * self.A.rows, self.members.start, self.lumped
        for part, values in ((M, [s * x + y for x, y in zip(q, v, strict=True)]), (C, q), (G, q)):
            for (i, j), x in part.items():
                right[i] += x * values[j]
        fields = [_particular(placed.piece, s, u * (placed.piece.inertia * s + placed.piece.drag)
                              + rate * placed.piece.inertia)
                  for placed, (u, rate) in zip(elements.pieces, self.members.fields, strict=True)]
        return self._with_fields(right, fields, {})

    def loaded(self, images: Mapping[int, Any]) -> tuple[list, list]:
        """The same of inputs that have these images."""
        fields = [sum((part.along * images[part.input] for part in self.members.spread
                       if part.piece == number and part.input in images), NOTHING)
                  for number in range(len(self.waves))]
        return self._with_fields([mpmath.mpc(0)] * self.A.rows, [
            _particular(placed.piece, self.s, f) for placed, f in zip(
                self.members.elements.pieces, fields, strict=True)], images)

    def _with_fields(self, right, fields, images):
        for placed, column, field in zip(self.members.elements.pieces, self.columns, fields, strict=True):
            if field.terms:
                begin, end = ([[x] for x in slopes_at(field, place)] for place in (0, placed.piece.length))
                for (i, _), x in self._ends(placed, column, at_ends(placed.piece, begin, end)).items():
                    right[i] -= x
        for i in self.given:
            right[i] = images.get(i, mpmath.mpc(0))
        return right, fields

    def along(self, column_values: Any, field: ExponentialPolynomial) -> list[tuple[Any, Any]]:
        """[(delay, image)] of the signal by what one solution has for unknowns."""
        members, s = self.members, self.s
        if members.place is None:
            row = members.row
            return [(mpmath.mpf(0), mpmath.fsum(s**power * x * column_values[i] for power, part in enumerate(
                (row.q, row.v, row.a)) for i, x in part.items()))]
        place = members.place
        piece, column = members.elements.pieces[place.piece].piece, self.columns[place.piece]
        factor, found = s**place.primes * place.factor, []
        for j, k in enumerate(self.waves[place.piece]):
            for which, share, sign in ((0, place.share, -1), (1, 1 - place.share, 1)):
                late = share * delay(piece) if piece.order == 2 else mpmath.mpf(0)
                found.append((late, factor * (sign * k) ** place.order * column_values[column + 2 * j + which]
                              * mpmath.exp(s * late - k * share * piece.length)))
        if field.terms:
            x = slopes_at(field, place.share * piece.length)[place.order]
            found.append((mpmath.mpf(0), factor * x))
        return found


def slopes_at(field: ExponentialPolynomial, x: Any) -> list:
    """[u, u′, u″, u‴] at a place, complex numbers."""
    found = []
    for _ in range(4):
        found.append(mpmath.fsum(c * x**power * mpmath.exp(rate * x) for (rate, power), c in field.terms.items()))
        field = field.rate()
    return found


def _particular(piece, s, load):
    """uₚ of B u⁗ − N u″ + κ u = f: of L(D) with D = λ + ∂ on powers of x, from the highest one down."""
    B, N, kappa, found = piece.bending, piece.tension, piece.reaction(s), {}
    for rate in {rate for rate, _ in load.terms}:
        slopes = [B * rate**4 - N * rate**2 + kappa, 4 * B * rate**3 - 2 * N * rate, 6 * B * rate**2 - N, 4 * B * rate,
                  B]
        top = max(power for other, power in load.terms if other == rate)
        for power in range(top, -1, -1):
            right = load.terms.get((rate, power), 0) - sum(
                slopes[j] * perm(power + j, j) * found.get((rate, power + j), 0) for j in range(1, 5))
            found[rate, power] = right / slopes[0]
    return ExponentialPolynomial(found)
