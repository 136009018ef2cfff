"""What many digits need and cost: bits to work with, and steps of a million products of short whole numbers each."""

import math

GUARD_DIGITS = 10


def working_bits(digits: int) -> int:
    """The bits of accuracy that give `digits` correct digits."""
    return math.ceil((digits + GUARD_DIGITS) * math.log2(10))


def price(bits: int) -> float:
    """As much as how many products of short whole numbers one of numbers of so many bits costs."""
    found: float = 1 + 2.6e-5 * bits**1.79
    return found


def estimated_steps(n: int, digits: int, damped: bool = False) -> float:
    """About how many steps `digits` digits take for n coordinates, for damped modes where there is damping.

    Steps double the digits without damping, add fourteen with; each is a few products of n × n matrices of
    integers, and each damped shape one linear system. Good to a factor 3.
    """
    bits = working_bits(digits) + 160
    steps = 2 + math.log2(1 + bits / 50)
    total = 0.01 + 5 * steps * _product(n, bits)
    if damped:
        steps = 4 + digits / 14
        shapes = 1e-4 * n * (n + 4) ** 3 * (1 + digits / 150)
        total += steps * (0.015 + 2 * _product(n, 2 * bits)) + shapes
    return total


def _product(n: int, bits: int) -> float:
    return (n + 1) ** 3 * price(bits) / 1e6
