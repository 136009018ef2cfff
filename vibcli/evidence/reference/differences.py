"""Coefficients of Taylor's series by central differences, in numbers of any kind: of f = Σ c ξ₁ⁱ … ξₙʲ, with a step h,

    c = Π δᵢ/hⁱ i! f(0),        δᵢ f = Σ (−1)ᵏ (i over k) f((i/2 − k) h),

to order h². In numbers of mpmath h falls with the digits.
"""

from collections.abc import Callable, Sequence
from math import comb, factorial
from typing import Any

import mpmath

from vibcli.evidence.reference.settled import TrueValues, settled

DIGITS, START, LIMIT = 30, 60, 960
Function = Callable[[Sequence[Any]], Any]


def coefficient(function: Function, powers: Sequence[int], steps: Sequence[Any]) -> Any:
    """Of a product of powers of the variables, by steps of these."""
    return _differences(function, list(powers), list(steps), [])


def _differences(function: Callable[..., Any], powers: list[int], steps: list[float | mpmath.mpf],
                 place: list[float | mpmath.mpf]) -> float | mpmath.mpf:
    if len(place) == len(powers):
        return function(place)
    n, h = powers[len(place)], steps[len(place)]
    total = 0
    for k in range(n + 1):
        total += (-1) ** k * comb(n, k) * _differences(function, powers, steps, [*place, (n / 2 - k) * h])
    return total / (h**n * factorial(n))


def true_coefficient(function: Callable[[], Function], powers: Sequence[int], units: Sequence[float],
                     size: float) -> TrueValues:
    """The same to many digits, of a function that is made at the working precision; units: of the variables; size: from
    which on digits count."""
    def found() -> "tuple[list[mpmath.mpf], float | mpmath.mpf]":
        part = mpmath.mpf(10) ** (-mpmath.mp.dps / (sum(powers) + 2))
        value = coefficient(function(), powers, [part * mpmath.mpf(unit) for unit in units])
        return [value if abs(value) > size * part else mpmath.mpf(0)], max(size, abs(value))

    return settled(found, DIGITS, START, LIMIT, sized=True)
