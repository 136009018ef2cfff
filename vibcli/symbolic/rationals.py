"""Exact rational coefficients, kept short: ints where they are whole, else Fractions, folded only within BITS."""

from fractions import Fraction
from math import isqrt
from typing import Any

BITS = 256
ZERO, ONE, HALF = 0, 1, Fraction(1, 2)


def exact(value: Fraction | int) -> Any:
    """A rational as an int where it is whole (an order of magnitude faster than a Fraction), else as a Fraction."""
    if value.__class__ is int:
        return value
    if value.__class__ is not Fraction:
        value = Fraction(value)
    return value.numerator if value.denominator == 1 else value


def fraction_of(value: Any) -> Fraction:
    """The exact value of a float, or of a number of mpmath."""
    if not hasattr(value, "_mpf_"):
        return Fraction(value)
    sign, man, exp, _ = value._mpf_
    found: Fraction = (-1)**sign * int(man) * Fraction(2)**exp
    return found


def bits(value: Fraction | int) -> int:
    if value.__class__ is int:
        return value.bit_length() + 1
    return value.numerator.bit_length() + value.denominator.bit_length()


def rational_power(base: Fraction | int, exponent: Fraction | int) -> Fraction | int | None:
    """base^exponent where it is rational and within BITS, else None."""
    if exponent == 1:
        return base
    if base == 1:
        return ONE
    if not base and exponent <= 0:
        raise ZeroDivisionError("division by zero")
    if exponent.denominator == 1:
        power = exponent.numerator
        if bits(base) * abs(power) > BITS:
            return None
        return int(base**power) if base.__class__ is int and power > 0 else exact(Fraction(base)**power)
    if exponent.denominator == 2 and base >= 0:
        root = exact_root(base)
        return None if root is None else rational_power(exact(root), exact(exponent * 2))
    return None


def exact_root(value: Fraction | int) -> Fraction | None:
    """√value of a rational that is not negative as a Fraction; None where it is irrational."""
    up, down = isqrt(value.numerator), isqrt(value.denominator)
    return Fraction(up, down) if up * up == value.numerator and down * down == value.denominator else None


def square_part(value: Fraction | int) -> tuple[Fraction | int, Fraction | int]:
    """(r, n) with value = r²·n and n an integer without small square factors: √8 = 2√2, √(1/2) = √2/2."""
    inside, outside = value.numerator * value.denominator, 1
    if inside <= 0 or inside.bit_length() > BITS // 2:
        return ONE, value
    for prime in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31):
        if prime**2 > inside:
            break
        while inside % prime**2 == 0:
            inside //= prime**2
            outside *= prime
    root = isqrt(inside)
    if root * root == inside:
        outside, inside = outside * root, 1
    return outside if value.__class__ is int else exact(Fraction(outside, value.denominator)), inside
