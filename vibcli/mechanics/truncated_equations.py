"""Lagrange's equations of energies that are polynomials in the deviations ξ from equilibrium and their rates.

    Σⱼ [∂²T/∂ξ̇ᵢ∂ξ̇ⱼ ξ̈ⱼ + ∂²T/∂ξ̇ᵢ∂ξⱼ ξ̇ⱼ] − ∂T/∂ξᵢ + ∂V/∂ξᵢ = 0,    the terms of V that are linear balanced by loads
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

Powers = tuple[int, ...]


def truncated_equation(T: Mapping[Powers, Any], V: Iterable[tuple[Powers, Any]], i: int,
                       n: int) -> dict[Powers, list[Any]]:
    """{powers of ξ, ξ̇ and ξ̈, n each: the numbers or expressions whose sum is their factor} in the equation of ξᵢ.

    T: {powers of ξ and ξ̇: factor}, V: (powers of ξ, factor), any number of them with the same powers.
    """
    found: dict[Powers, list[Any]] = {}
    for powers, factor in _terms(T, V, i, n):
        found.setdefault(powers, []).append(factor)
    return found


def _terms(T: Mapping[Powers, Any], V: Iterable[tuple[Powers, Any]], i: int, n: int) -> Iterator[tuple[Powers, Any]]:
    rest = (0,) * n
    for powers, c in T.items():
        powers = (*powers, *rest)
        if powers[n + i]:
            momentum = _moved(powers, (n + i, -1))
            for j in range(2 * n):
                if momentum[j]:
                    yield _moved(momentum, (j, -1), (j + n, 1)), c * powers[n + i] * momentum[j]
        if powers[i]:
            yield _moved(powers, (i, -1)), c * -powers[i]
    for powers, c in V:
        if powers[i] and sum(powers) > 1:
            yield _moved((*powers, *rest, *rest), (i, -1)), c * powers[i]


def _moved(powers: Sequence[int], *steps: tuple[int, int]) -> tuple[int, ...]:
    found = list(powers)
    for i, step in steps:
        found[i] += step
    return tuple(found)
