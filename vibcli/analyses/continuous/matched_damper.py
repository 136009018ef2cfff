"""A bar, shaft or string held at one end, at the other a damper c = √(Nμ): no wave comes back from it."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

SAME = 2.0**-50     # relative: c is √(Nμ) as far as floats tell


def dies_after(elements: "FactoredSystem") -> float | None:
    """When every motion has ended: 2L/c₀, c₀ = √(N/μ), after which no wave is left; None where waves do come back.

    F(s) = N cosh(τs)/L·τs + c s … = N/L·τs e^{τs} there, without a zero but that of the piece itself at s = 0.
    """
    if elements.n != 1 or len(elements.pieces) != 1 or elements.springs or any(
            any(part.values()) for part in (elements.M, elements.C, elements.G, elements.K, elements.drag)):
        return None
    if any(m for m, _ in elements.inertias):
        return None
    piece, rows = elements.pieces[0].piece, elements.pieces[0].rows
    ends = [row.get(0, 0) for row in rows]
    if piece.order != 2 or piece.gradient or piece.drag or piece.foundation or all(ends) or not piece.inertia > 0:
        return None
    at_end, damper = sum(x * x for x in ends), sum(c * row.get(0, 0) ** 2 for c, row in elements.dampers)
    own = (piece.tension * piece.inertia) ** 0.5 * at_end
    if not abs(damper - own) <= SAME * own:
        return None
    return float(2 * piece.length * (piece.inertia / piece.tension) ** 0.5)
