"""Damping that leaves the modes as they are: C = αM + βK within each block, so 2ζω = α + βω²."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.normal_form import is_zero

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.decoupling import DecoupledBlock
    from vibcli.symbolic.node import Node


def damps_each(parts: "Sequence[DecoupledBlock]", C: "Mapping[tuple[int, int], Node]") -> bool:
    """Does C couple no two of these blocks?"""
    for part in parts:
        for other in parts:
            if part is not other and any(not _vanishes(C, left, right)
                                         for left in part.columns for right in other.columns):
                return False
    return True


def _vanishes(C: "Mapping[tuple[int, int], Node]", left: Mapping[int, int], right: Mapping[int, int]) -> bool:
    terms = [(C[i, j], x * y) for i, x in left.items() for j, y in right.items() if (i, j) in C]
    return not terms or is_zero(terms[0][0].table.sum(*terms))


def proportions(M: Sequence[list[Any]], C: Sequence[list[Any]], K: Sequence[list[Any]]) -> tuple[Any, Any] | None:
    """(α, β) of the rows of a block, elements of a field, with C = αM + βK; None where there are none."""
    if len(M) == 1:
        return (C[0][0] / M[0][0], C[0][0] * 0) if M[0][0] else None
    entries = [entry for rows in zip(M, C, K, strict=True) for entry in zip(*rows, strict=True)]
    for i, (m, c, k) in enumerate(entries):
        for n, d, p in entries[i + 1:]:
            determinant = m * p - n * k
            if determinant:
                alpha, beta = (c * p - d * k) / determinant, (m * d - n * c) / determinant
                return (alpha, beta) if all(alpha * m + beta * k == c for m, c, k in entries) else None
    return None
