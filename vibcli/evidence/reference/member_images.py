"""Laplace images of what members and what is attached to them do from a start on, by the waves that run along pieces:

    B u⁗ − N u″ + κ u = f,   κ = μ s² + c s + k,    u = Σ aⱼ e^{−kⱼ x} + bⱼ e^{−kⱼ (l − x)} + uₚ,   B k⁴ − N k² + κ = 0,

    (K + s C + s² M) q + Σ Sᵀ F = (s M + C) q₀ + M q̇₀,      f = p(x) W(s) + (μ s + c) u₀ + μ u̇₀,

the ends of pieces moving with q. What runs along a piece comes e^{−kⱼ l} later, and stands apart from the rest.
"""

from collections.abc import Mapping
from math import perm
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.exponential_polynomials import NOTHING, ExponentialPolynomial, is_some
from vibcli.evidence.reference.member_starts import StartedMembers
from vibcli.evidence.reference.members import at_ends
from vibcli.numerics.pieces.piece import Piece

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.factored_system import PlacedPiece


class RunningPart(NamedTuple):
    """What a wave that has run along a piece adds to equations, {(i, column): number}, times e^{−kl}; delay: l√(μ/N) of
    what is no beam; rest: e^{−kl} but for that delay."""

    piece: int
    entries: Mapping[tuple[int, int], Any]
    rest: Any


def wave_numbers(piece: Piece, s: Any, numbers: Any = mpmath) -> "list[mpmath.mpc | np.ndarray]":
    """kⱼ with Re k ≥ 0 where s is to the right of all that vibrates; of beams without a jump about imaginary s."""
    kappa, sqrt = piece.reaction(s), numbers.sqrt
    if piece.order == 2:
        return [s * sqrt(kappa / (piece.tension * s * s))]
    N, root = piece.tension, sqrt(piece.tension**2 - 4 * piece.bending * kappa)
    return [sqrt((N + root) / (2 * piece.bending)), 1j * sqrt((root - N) / (2 * piece.bending))]


def delay(piece: Piece, numbers: Any = mpmath) -> Any:
    """Of a wave along it."""
    return piece.length * numbers.sqrt(piece.inertia / piece.tension)


class MemberImages:
    """The equations of StartedMembers at s: those without what has run along pieces, and RunningParts."""

    def __init__(self, members: StartedMembers, s: Any, numbers: Any = mpmath) -> None:
        self.members, self.s, self.numbers, elements = members, s, numbers, members.elements
        self.waves = [wave_numbers(placed.piece, s, numbers) for placed in elements.pieces]
        self.columns, size = [], elements.n
        for placed in elements.pieces:
            self.columns.append(size)
            size += placed.piece.order
        self.lumped = elements.with_parts(pieces=()).matrices()
        self.given = range(members.n, members.end)
        M, C, G, K = self.lumped
        self.size, self.entries = size, {}
        for part, factor in ((K, 1), (M, s * s), (C, s), (G, s)):
            self._put({pair: factor * x for pair, x in part.items()})
        self.running: list[RunningPart] = []
        for number in range(len(elements.pieces)):
            self._add(number)
        self.entries = {pair: x for pair, x in self.entries.items() if pair[0] not in self.given}
        self._put(dict.fromkeys(zip(self.given, self.given, strict=True), 1))

    def _put(self, entries: "Mapping[tuple[int, int], float | mpmath.mpc | mpmath.mpf | np.ndarray]") -> None:
        for pair, x in entries.items():
            self.entries[pair] = self.entries.get(pair, 0) + x

    @property
    def A(self) -> Any:
        """The matrix of the equations without what has run along pieces."""
        found = mpmath.zeros(self.size, self.size)
        for pair, x in self.entries.items():
            found[pair] = x
        return found

    def whole(self) -> dict[tuple[int, int], Any]:
        """{(i, j): number} of the equations with what has run along pieces, from whatever time on."""
        found = dict(self.entries)
        for part in self.running:
            piece = self.members.elements.pieces[part.piece].piece
            late = self.numbers.exp(-self.s * delay(piece, self.numbers)) if piece.order == 2 else 1
            for pair, x in part.entries.items():
                found[pair] = found.get(pair, 0) + x * part.rest * late
        return found

    def _add(self, number: int) -> None:
        placed, waves, column = self.members.elements.pieces[number], self.waves[number], self.columns[number]
        piece, none = placed.piece, [0] * len(waves)
        begin = [[x for k in waves for x in ((-k) ** m, 0)] for m in range(4)]
        end = [[x for k in waves for x in (0, k**m)] for m in range(4)]
        self._put(self._ends(placed, column, at_ends(piece, begin, end)))
        for place, row in enumerate(placed.rows):
            self._put({(column + place, i): -x for i, x in row.items()})
        for j, k in enumerate(waves):
            def only(pair: "tuple[int | mpmath.mpc, int | mpmath.mpc | np.ndarray]",
                     j: int = j) -> "list[int | mpmath.mpc | np.ndarray]":
                return [*none[:j], *none[:j], *pair, *none[j + 1:], *none[j + 1:]]

            begin, end = ([only((0, k**m)) for m in range(4)], [only(((-k) ** m, 0)) for m in range(4)])
            late = k * piece.length - (self.s * delay(piece, self.numbers) if piece.order == 2 else 0)
            self.running.append(RunningPart(number, {pair: x for pair, x in self._ends(
                placed, column, at_ends(piece, begin, end)).items() if is_some(x) and pair[0] not in self.given},
                self.numbers.exp(-late)))

    def _ends(self, placed: "PlacedPiece", column: int, ends: Any) -> dict[tuple[int, int], Any]:
        """{(i, j): what fields do to equations of ends and of coordinates} of (displacements, forces) at ends."""
        found: dict[tuple[int, int], Any] = {}
        for place, (row, move, force) in enumerate(zip(placed.rows, *ends, strict=True)):
            for k, (u, f) in enumerate(zip(move, force, strict=True)):
                found[column + place, column + k] = u
                for i, x in row.items():
                    found[i, column + k] = found.get((i, column + k), 0) + x * f
        return found

    def started(self) -> tuple[list[int], list[ExponentialPolynomial]]:
        """(right sides, uₚ of each piece) of what it starts with."""
        s, elements = self.s, self.members.elements
        right, (q, v), (M, C, G, _) = [0] * self.size, self.members.start, self.lumped
        for part, values in ((M, [s * x + y for x, y in zip(q, v, strict=True)]), (C, q), (G, q)):
            for (i, j), x in part.items():
                right[i] += x * values[j]
        fields = [_particular(placed.piece, s, u * (placed.piece.inertia * s + placed.piece.drag)
                              + rate * placed.piece.inertia)
                  for placed, (u, rate) in zip(elements.pieces, self.members.fields, strict=True)]
        return self._with_fields(right, fields, {})

    def loaded(self, images: Mapping[int, Any]) -> tuple[list[int | mpmath.mpc], list[ExponentialPolynomial]]:
        """The same of inputs that have these images."""
        fields = [sum((part.along * images[part.input] for part in self.members.spread
                       if part.piece == number and part.input in images), NOTHING)
                  for number in range(len(self.waves))]
        return self._with_fields([0] * self.size, [
            _particular(placed.piece, self.s, f) for placed, f in zip(
                self.members.elements.pieces, fields, strict=True)], images)

    def _with_fields(self, right: list[Any], fields: list[ExponentialPolynomial],
                     images: Mapping[int, mpmath.mpc]) -> tuple[list[Any], list[ExponentialPolynomial]]:
        for placed, column, field in zip(self.members.elements.pieces, self.columns, fields, strict=True):
            if field.terms:
                begin, end = ([[x] for x in slopes_at(field, place, self.numbers)]
                              for place in (0, placed.piece.length))
                for (i, _), x in self._ends(placed, column, at_ends(placed.piece, begin, end)).items():
                    right[i] -= x
        for i in self.given:
            right[i] = images.get(i, 0)
        return right, fields

    def along(self, column_values: Any, field: ExponentialPolynomial) -> list[tuple[Any, Any]]:
        """[(delay, image)] of the signal by what one solution has for unknowns."""
        members, s = self.members, self.s
        if members.place is None:
            row = members.row
            return [(0, sum(s**power * x * column_values[i] for power, part in enumerate(
                (row.q, row.v, row.a)) for i, x in part.items()))]
        place = members.place
        piece, column = members.elements.pieces[place.piece].piece, self.columns[place.piece]
        factor, found = s**place.primes * place.factor, []
        for j, k in enumerate(self.waves[place.piece]):
            for which, share, sign in ((0, place.share, -1), (1, 1 - place.share, 1)):
                late = share * delay(piece, self.numbers) if piece.order == 2 else 0
                found.append((late, factor * (sign * k) ** place.order * column_values[column + 2 * j + which]
                              * self.numbers.exp(s * late - k * share * piece.length)))
        if field.terms:
            x = slopes_at(field, place.share * piece.length, self.numbers)[place.order]
            found.append((0, factor * x))
        return found

    def signal(self, column_values: Any, fields: Any = None) -> Any:
        """The image of the signal by what the whole equations have for unknowns, counted from `held`."""
        field = NOTHING if fields is None or self.members.place is None else fields[self.members.place.piece]
        return sum(x * self.numbers.exp(-self.s * late) if late else x for late, x in self.along(column_values, field))


def slopes_at(field: ExponentialPolynomial, x: Any, numbers: Any = mpmath) -> "list[mpmath.mpc | np.ndarray]":
    """[u, u′, u″, u‴] at a place, complex numbers."""
    found = []
    for _ in range(4):
        found.append(sum(c * x**power * numbers.exp(rate * x) for (rate, power), c in field.terms.items()))
        field = field.rate()
    return found


def _particular(piece: Piece, s: mpmath.mpc, load: ExponentialPolynomial) -> ExponentialPolynomial:
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
