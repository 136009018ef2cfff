"""A bar, shaft or string held or free at one end, at the other a damper c = √(Nμ): no wave comes back from it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_modes import DampedMode
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.numerics.pieces.piece import Piece

SAME = 2.0**-49     # relative: c is √(Nμ) as far as floats tell


def dies_after(elements: "FactoredSystem") -> float | None:
    """When every motion has ended: 2L/c₀, c₀ = √(N/μ), after which no wave is left; None where waves do come back.

    Held, F(s) = N cosh(τs)/L·τs + c s … = N/L·τs e^{τs}, without a zero but that of the piece itself at s = 0; free it
    has one more: what is left rests anywhere.
    """
    if elements.n not in (1, 2) or len(elements.pieces) != 1 or elements.springs or any(
            any(part.values()) for part in (elements.M, elements.C, elements.G, elements.K, elements.drag)):
        return None
    if any(m for m, _ in elements.inertias):
        return None
    piece, rows = elements.pieces[0].piece, elements.pieces[0].rows
    if elements.pieces[0].retardation or piece.order != 2 or piece.gradient or piece.drag or piece.foundation or not (
            piece.inertia > 0 and piece.tension > 0):
        return None
    felt: list[dict[int, Any]] = [{i: x for i, x in row.items() if x} for row in rows]
    if [len(row) for row in felt] not in ([[1, 1]] if elements.n == 2 else [[0, 1], [1, 0]]) or (
            elements.n == 2 and felt[0].keys() == felt[1].keys()):
        return None
    return _ended(elements, piece, felt)


def _ended(elements: "FactoredSystem", piece: "Piece", felt: Sequence[dict[int, float]]) -> float | None:
    """The same, of the rows of its ends."""
    dampers = [sum(c * row.get(i, 0) ** 2 for c, row in elements.dampers) for i in range(elements.n)]
    if any(sum(1 for x in row.values() if x) > 1 for _, row in elements.dampers) or sum(map(bool, dampers)) != 1:
        return None
    (i, damper), = ((i, damper) for i, damper in enumerate(dampers) if damper)
    own = (piece.tension * piece.inertia) ** 0.5 * sum(row.get(i, 0) ** 2 for row in felt)
    if not abs(damper - own) <= SAME * own:
        return None
    return float(2 * piece.length * (piece.inertia / piece.tension) ** 0.5)


def require_bounded_answers(elements: "FactoredSystem") -> None:
    """PhysicsError where c = −√(Nμ) stands alone at an end of one uniform bar, shaft or string, however divided:
    N cosh(τs)/L·τs + c s = N/L·τs e^{−τs}, and no mode is there."""
    if elements.springs or any(m for m, _ in elements.inertias) or len(elements.dampers) != 1 or any(
            any(part.values()) for part in (elements.M, elements.C, elements.G, elements.K, elements.drag)):
        return
    c, row = elements.dampers[0]
    felt = [i for i, x in row.items() if x]
    plain = {(one.piece.order, one.piece.tension, one.piece.inertia) for one in elements.pieces
             if not (one.retardation or one.piece.gradient or one.piece.drag or one.piece.foundation)}
    ends = [i for one in elements.pieces for end in one.rows for i, x in end.items() if abs(x) == 1]
    if len(felt) != 1 or len(plain) != 1 or ends.count(felt[0]) != 1 or max(map(ends.count, ends)) > 2 or any(
            len(end) > 1 for one in elements.pieces for end in one.rows):
        return
    (order, tension, inertia), = plain
    own, damper = (max(tension, 0.0) * inertia) ** 0.5, c * row[felt[0]] ** 2
    if order == 2 and damper < 0 and abs(damper + own) <= SAME * own:
        raise PhysicsError("no mode vibrates: a damper of −√(Nμ) at the end of a bar, shaft or string answers a wave "
                           "that arrives without bound", "give it another value")


def left_over(elements: "FactoredSystem") -> list[DampedMode]:
    """The damped modes of what dies_after a time: where nothing holds it λ = 0, at rest."""
    if elements.n == 1:
        return []
    shape = np.array([1 / next(row[i] for row in elements.pieces[0].rows if row.get(i, 0)) for i in range(2)], complex)
    return [DampedMode(1, 0.0, 0.0, None, shape, 0.0, "rests: λ = 0")]
