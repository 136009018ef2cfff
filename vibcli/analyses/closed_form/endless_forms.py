"""Natural frequencies in letters of one uniform member whose frequency equation leaves numbers for βL:

    ω = (2n − 1)π/(2L)·√(E/ρ)           where sin βL or cos βL is zero
    ω = 3.51601526850015·√(EI/μ)/L²     of others, (βL)² to fifteen digits

In order as βL is, so that a column is thought to bear less than its buckling load; none of one that is pressed in a
bed, which may bend in several half waves first.
"""

from fractions import Fraction
from math import pi
from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.closed_forms import ClosedForms, ClosedMode
from vibcli.analyses.closed_form.member_frequencies import frequency_equations
from vibcli.analyses.closed_form.member_shapes import rigid_motions, roots, unstrained
from vibcli.analyses.closed_form.textbook_equation import sides
from vibcli.base.errors import NotInLetters
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

EVEN, SEARCHED = 16, 100        # roots from which on they are π apart; those of other equations that are told
ROUNDING = 1e-14            # of fifteen digits, relative
NUMBERS = "these frequencies are found in numbers"


def endless_forms(symbolic: "SymbolicSystem") -> ClosedForms | None:
    """The forms of a scene that is one such member; None of others."""
    found = frequency_equations(symbolic)
    moved = {i for placed in symbolic.linearisation.pieces for row in placed.rows for i in row}
    one = found[0] if len(found) == 1 else None
    if one is None or len(one.pieces) > 1 or one.second is not None or one.letters:
        return None
    if len(moved) < len(symbolic.scene.q) or roots(one, 1) is None or not _in_order(one, symbolic.scene.sample):
        return None
    return ClosedForms([], numbered=lambda number: _mode(one, number))


def _in_order(found: "FrequencyEquation", sample: dict[str, float]) -> bool:
    """Is the first of them stable at the sample values, and is none pressed in a bed?"""
    piece, first = found.pieces[0].piece, _root(found, 1)
    square = substitute([found.square], {found.wave_number: first})[0]
    lowest, tension = evaluate([square, piece.tension], Floats, sample)
    return bool(lowest > 0 and (tension >= 0 or piece.foundation.is_zero))


def _mode(found: "FrequencyEquation", number: int) -> ClosedMode:
    """The ClosedMode so numbered, rigid ones first."""
    table, x, order = found.wave_number.table, found.wave_number, found.order
    elastic = number - (0 if unstrained(found) else rigid_motions(found))
    if elastic < 1:
        return ClosedMode(table.zero, table.zero, index=number)
    root, alone = _root(found, elastic), textbook(found.square / x ** order)
    square = textbook(substitute([found.square], {x: root})[0])
    error = ROUNDING if root.op == "number" else 0.0
    if x in reachable([alone]):
        return ClosedMode(square, table.sqrt(square), index=number, error=error)
    power = root ** (order // 2)
    return ClosedMode(square, (power if root.op != "number" else _digits(table, float(root.coefficient) ** (
        order // 2), 15)) * table.sqrt(alone), index=number, error=error)


def _root(found: "FrequencyEquation", number: int) -> "Node":
    """βL so numbered."""
    left, right = sides(found)
    table, resting = found.wave_number.table, unstrained(found)
    if right.is_zero and left.op == "call" and left.name in ("sin", "cos"):
        halves = 2 * number - (1 if left.name == "cos" else 2 * resting)
        result: Node = table.pi * table.number(Fraction(halves, 2))
        return result
    bare = all(Z is None or Z.is_zero for end in found.impedances for Z in end)
    wanted = min(number, EVEN) if bare else number
    told = roots(found, wanted) if wanted <= SEARCHED else None
    if told is None or len(told) < wanted:
        raise NotInLetters(NUMBERS, hint="give the parameters values with --set")
    return _digits(table, told[wanted - 1] + pi * (number - wanted), 17)


def _digits(table: "Table", value: float, count: int) -> "Node":
    return table.number(Fraction(f"{value:.{count}g}"))
