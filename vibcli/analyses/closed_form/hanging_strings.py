"""Frequency equations of strings whose tension varies evenly along them, hanging chains among these, in letters:

    (T u′)′ + (μω² − k) u = 0,  T = T₀ + γx       u = A J₀(z) + B Y₀(z),  z = 2√((μω² − k) T)/|γ|
    T u′ = −γ/2·z·(A J₁(z) + B Y₁(z))             where T = 0 at an end, J₀ alone is finite (D. Bernoulli 1732)

so that a chain that hangs from one end has J₀(z) = 0 there, ω = z/2·√(g/L).
"""

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.free_letters import FREQUENCY, IMPEDANCES, free_letter, free_letters
from vibcli.analyses.closed_form.lumped_impedances import stands_apart
from vibcli.analyses.closed_form.member_frequencies import impedances
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece
    from vibcli.symbolic.node import Node

ENDS = ("z", "theta", "eta")
FIRST, SECOND = ("J0", "J1"), ("Y0", "Y1")


class HangingString(NamedTuple):
    """`left` = `right` in z at the ends; z of the end by which ω² is told, ω, ω²; [(letter, what it is)] of z at the
    other end and of impedances; the Bessel function whose zeros are the roots, or None; X = J₀(ζ) − σ Y₀(ζ) with the
    square of ζ/z as a function of the place and σ, None where X is J₀ alone; the coordinates of what hangs on it."""

    members: tuple[str, ...]
    pieces: "list[PlacedPiece]"
    left: "Node"
    right: "Node"
    wave_number: "Node"
    omega: "Node"
    square: "Node"
    named: "list[tuple[Node, Node]]"
    zeros_of: str | None
    sigma: "Node | None"
    hung: list[int]

    def along(self, place: "Node") -> "Node":
        """ζ at a place from the left end."""
        placed, table = self.pieces[0], place.table
        tension, end = tensions(placed.piece)
        share = (tension + placed.piece.gradient * place) / (end if tension.is_zero else tension)
        return self.wave_number * table.sqrt(textbook(share))


def hanging_string(form: Any, placed: "PlacedPiece", taken: Collection[str]) -> HangingString | None:
    """The equation of a member that is such a string, whose slack end holds nothing; None of others."""
    piece, table = placed.piece, form.table
    if piece.gradient.is_zero or not piece.bending.is_zero or names_bessel(table, taken):
        return None
    omega = table.parameter(free_letter(taken, FREQUENCY))
    acting = impedances(form, [placed], omega)
    pulls = tensions(piece)
    slack = [tension.is_zero for tension in pulls]
    if acting is None:
        return None
    own = [table.parameter(name) for name in free_letters(taken, ENDS, 1 if any(slack) else 2)]
    z, reference = (own[0], pulls[1]) if slack[0] else (own[0], pulls[0])
    ends = [own[0]] * 2 if any(slack) else own
    square = (piece.gradient ** 2 * z ** 2 / (4 * reference) + piece.foundation) / piece.inertia
    found = _Ends(piece, pulls, ends, omega, taken)
    parts = [None if none else found.condition(side, Z[0])
             for side, (none, Z) in enumerate(zip(slack, acting[0], strict=True))]
    left, right, zeros = found.equation(parts)
    sigma = None if any(slack) else found.of(parts[0], 0, FIRST) / found.of(parts[0], 0, SECOND)
    other = [] if any(slack) else [(own[1], z * table.sqrt(textbook(pulls[1] / pulls[0])))]
    return HangingString((placed.owner,), [placed], left, right, z, omega, textbook(square),
                         [*other, *found.letters.items()], zeros, sigma, acting[1])


def names_bessel(table: Any, taken: Collection[str]) -> bool:
    """Has a scene a name that is Bessel's?"""
    return not {*FIRST, *SECOND}.isdisjoint((*table.functions, *table.records, *taken))


def tensions(piece: Any) -> "tuple[Node, Node]":
    """At the left end and at the right one."""
    return textbook(piece.tension), textbook(piece.tension + piece.gradient * piece.length)


class _Ends:
    """What holds at the ends of one, (q₁, q₀) of q₁ f₁(z) + q₀ f₀(z) = 0, f of J or Y."""

    def __init__(self, piece: "Piece", pulls: "Sequence[Node]", ends: "Sequence[Node]", omega: "Node",
                 taken: Collection[str]) -> None:
        self.piece, self.tensions, self.ends, self.omega, self.taken = piece, pulls, ends, omega, taken
        self.table, self.letters = omega.table, {}
        self.calls = {(name, side): self.table.call(name, ends[side]) for names, side in (
            (FIRST, 0), (SECOND, 0), (FIRST, 1), (SECOND, 1)) for name in names}

    def condition(self, side: int, Z: "Node | None") -> "tuple[Node, Node]":
        """u = 0 where it is held, else ±T u′ = Z u: f₁ ± 2 Z/(γ z) f₀ = 0."""
        if Z is None:
            return self.table.zero, self.table.one
        piece, z = self.piece, self.ends[side]
        if stands_apart(Z, self.omega, not piece.foundation.is_zero):
            Z = self._lettered(Z)
        elif self.omega in reachable([Z]):
            own = piece.gradient ** 2 * z ** 2 / (4 * self.tensions[side] * piece.inertia)
            Z = substitute([Z], {self.omega: self.table.sqrt(own)})[0]
        return self.table.one, textbook((-2 if side else 2) * Z / (piece.gradient * z))

    def _lettered(self, Z: "Node") -> "Node":
        known = next((letter for letter, one in self.letters.items() if one is Z), None)
        taken = {*self.taken, *(one.name for one in self.letters)}
        letter = known or self.table.parameter(free_letter(taken, IMPEDANCES))
        self.letters[letter] = Z
        return letter

    def of(self, part: Any, side: int, functions: tuple[str, str]) -> "Node":
        """q₁ f₁ + q₀ f₀ of J or of Y."""
        zero, one = (self.calls[name, side] for name in functions)
        found: Node = part[0] * one + part[1] * zero
        return found

    def equation(self, parts: "Sequence[tuple[Node, Node] | None]") -> "tuple[Node, Node, str | None]":
        """(left side, right side, the function whose zeros are the roots or None)."""
        if None in parts:
            side = 1 - parts.index(None)
            first, zero = parts[side]
            f0, f1 = (self.calls[name, side] for name in FIRST)
            alone = "J0" if first.is_zero else "J1" if zero.is_zero else None
            return f0 if first.is_zero else f1, self.table.zero if alone else -(zero * f0), alone
        terms = [(parts[0][1 - i] * parts[1][1 - j], self._crossed(i, j)) for i in (1, 0) for j in (1, 0)]
        (size, lead), *rest = [(size, crossed) for size, crossed in terms if not size.is_zero]
        return lead, self.table.total([-textbook(one / size) * crossed for one, crossed in rest]), None

    def _crossed(self, i: int, j: int) -> "Node":
        """J_i(z₁) Y_j(z₂) − Y_i(z₁) J_j(z₂)."""
        calls = self.calls
        return calls[FIRST[i], 0] * calls[SECOND[j], 1] - calls[SECOND[i], 0] * calls[FIRST[j], 1]

