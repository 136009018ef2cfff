"""Irreducible factors of polynomials over ℚ in many letters, as SymPy's `factor_list` tells them.

Most polynomials of mechanics hold a letter in first or second degree. What is left of a x + b without gcd(a, b) is
irreducible (Gauss's lemma), and so is what is left of a x² + b x + c where b² − 4ac is no square: where its value at
some numbers is none. The others are SymPy's, whose search takes far longer.
"""

from collections.abc import Sequence
from functools import reduce
from math import isqrt, prod
from typing import Any

POINTS = 6      # at which a square that is none is seen to be none


def irreducible_factors(polynomial: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """(rational, [(irreducible factor, multiplicity)]) of an element of a ring over ℚ."""
    value, rest = _primitive(polynomial)
    if not polynomial:
        return value, []
    powers, rest = _without_letters(rest)
    found = [(gen, power) for gen, power in zip(rest.ring.gens, powers, strict=True) if power]
    while not rest.is_ground:
        parts = _coefficients(rest)
        content = reduce(lambda a, b: a.gcd(b), parts)
        if len(parts) > 3 or (len(parts) == 3 and not _no_square(parts[1] ** 2 - 4 * parts[0] * parts[2])):
            found += rest.factor_list()[1]
            break
        found.append((_primitive(rest.quo(content))[1], 1))
        rest = content
    return value, sorted(found, key=lambda pair: _complexity(*pair)) if len(found) > 1 else found


def _primitive(polynomial: Any) -> tuple[Any, Any]:
    """(rational, polynomial): what is left has whole coefficients without a common factor, the leading one positive."""
    value, rest = polynomial.primitive()
    return (-value, -rest) if rest.LC < 0 else (value, rest)


def _without_letters(polynomial: Any) -> tuple[tuple[int, ...], Any]:
    """(powers, polynomial): the letters that all terms hold, and what is left."""
    common = tuple(map(min, zip(*polynomial.monoms(), strict=True)))
    return common, polynomial.ring.from_dict({tuple(a - b for a, b in zip(powers, common, strict=True)): value
                                              for powers, value in polynomial.terms()})


def _coefficients(polynomial: Any) -> list[Any]:
    """Those of the powers of the letter of least degree, that of the highest power having the fewest terms."""
    degrees, terms = polynomial.degrees(), polynomial.terms()
    least = min(degree for degree in degrees if degree)
    i = min((i for i, degree in enumerate(degrees) if degree == least),
            key=lambda i: sum(powers[i] == least for powers, _ in terms))
    found: list[dict[tuple[int, ...], Any]] = [{} for _ in range(least + 1)]
    for powers, value in terms:
        found[powers[i]][(*powers[:i], 0, *powers[i + 1:])] = value
    return [polynomial.ring.from_dict(part) for part in found[::-1]]


def _no_square(polynomial: Any) -> bool:
    """Is it no square at some whole numbers, so that it is none?"""
    for k in range(POINTS):
        x = _value(polynomial, [2 + (7 * i + 3 * k * (i + 1)) % 31 for i in range(polynomial.ring.ngens)])
        if x < 0 or any(isqrt(part) ** 2 != part for part in (int(x.numerator), int(x.denominator))):
            return True
    return False


def _value(polynomial: Any, numbers: Sequence[int]) -> Any:
    return sum(value * prod(x**power for x, power in zip(numbers, powers, strict=True) if power)
               for powers, value in polynomial.terms())


def _complexity(factor: Any, power: int) -> tuple[int, int, list[list[list[Any]]]]:
    """SymPy's order of factors."""
    dense = factor.to_dense()
    return len(dense), power, dense
