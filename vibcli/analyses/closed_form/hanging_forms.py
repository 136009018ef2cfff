"""Natural frequencies in letters of one string whose tension ends at zero, a hanging chain: ω = j/2·√(g/L), j the
zeros of J₀, of J₁ where its upper end is free across, to fifteen digits.
"""

from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.closed_forms import ClosedForms, ClosedMode
from vibcli.analyses.closed_form.endless_forms import ROUNDING
from vibcli.analyses.closed_form.hanging_strings import hanging_string
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.hanging_strings import HangingString
    from vibcli.mechanics.symbolic_system import SymbolicSystem

DIGITS = 15


def hanging_forms(symbolic: "SymbolicSystem") -> ClosedForms | None:
    """The forms of a scene that is one such string; None of others."""
    pieces, scene = symbolic.linearisation.pieces, symbolic.scene
    if len(pieces) != 1 or len({i for row in pieces[0].rows for i in row}) < len(scene.q):
        return None
    found = hanging_string(symbolic.linearisation, pieces[0], {*scene.coordinates, *scene.parameters.nodes})
    if found is None or found.zeros_of is None or not pieces[0].piece.foundation.is_zero:
        return None
    pulled, = evaluate([found.square / found.wave_number ** 2], Floats, {**scene.sample, found.wave_number.name: 1.0})
    return ClosedForms([], numbered=lambda number: _mode(found, number)) if pulled > 0 else None


def _mode(found: "HangingString", number: int) -> ClosedMode:
    """The ClosedMode so numbered; all of it moves alike where J₁ has its zero at z = 0."""
    table, z = found.omega.table, found.wave_number
    order = int(found.zeros_of == "J1")
    if number == order:
        return ClosedMode(table.zero, table.zero, index=number)
    from mpmath import besseljzero, nstr

    half = table.number(Fraction(nstr(besseljzero(order, number - order) / 2, DIGITS)))
    square = textbook(substitute([found.square], {z: 2 * half})[0])
    return ClosedMode(square, half * table.sqrt(textbook(4 * found.square / z ** 2)), index=number, error=ROUNDING)
