"""Estimates of natural frequencies, from the assembled matrices of the element data,

    Rayleigh   ω² = δᵀKδ/δᵀMδ,  K δ = M d       Dunkerley   1/ω² = tr K⁻¹M       Ritz   det(ΦᵀKΦ − ω² ΦᵀMΦ) = 0

with d = 1 in all coordinates that measure what the first with inertia does, and the assumed shapes in Φ.
"""

from collections.abc import Sequence
from typing import Any

import mpmath

from vibcli.evidence.reference.modal import Elements, matrices
from vibcli.evidence.reference.settled import TrueValues, settled


def rayleigh(elements: Elements, alike: Sequence[int]) -> TrueValues:
    """alike: d."""
    def found() -> "tuple[list[mpmath.mpf], None]":
        M, _, K = matrices(elements)
        bent = mpmath.lu_solve(K, M * mpmath.matrix(alike))
        return [mpmath.sqrt((bent.T * K * bent)[0] / (bent.T * M * bent)[0])], None

    return settled(found)


def dunkerley(elements: Elements) -> TrueValues:
    """By the whole of M at once."""
    def found() -> "tuple[list[mpmath.mpf], None]":
        M, _, K = matrices(elements)
        flexible = mpmath.inverse(K) * M
        return [1 / mpmath.sqrt(mpmath.fsum(flexible[i, i] for i in range(M.rows)))], None

    return settled(found)


def ritz(elements: Elements, shapes: Any, number: int) -> TrueValues:
    """The estimate of this number, counted from 1; shapes(): a list each, at the working precision."""
    def found() -> "tuple[list[mpmath.mpf], None]":
        M, _, K = matrices(elements)
        Phi = mpmath.matrix(shapes()).T
        squares, _ = mpmath.eig(mpmath.inverse(Phi.T * M * Phi) * (Phi.T * K * Phi))
        return [mpmath.sqrt(sorted(map(mpmath.re, squares))[number - 1])], None

    return settled(found)
