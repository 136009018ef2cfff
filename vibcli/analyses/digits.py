"""What many digits need and cost: bits to work with, and seconds."""

import math

GUARD_DIGITS = 10


def working_bits(digits):
    """The bits of accuracy that give `digits` correct digits."""
    return math.ceil((digits + GUARD_DIGITS) * math.log2(10))


def estimate_seconds(n, digits, damped=False):
    """About how long `digits` digits take for n coordinates, for damped modes where there is damping.

    Steps double the digits without damping, add fourteen with; each is a few products of n × n matrices of
    integers, and each damped shape one linear system. Constants measured in Python 3.11, good to a factor 3.
    """
    bits = working_bits(digits) + 160
    steps = 2 + math.log2(1 + bits / 50)
    seconds = 1e-3 + 5 * steps * _product(n, bits)
    if damped:
        steps = 4 + digits / 14
        shapes = 1e-5 * n * (n + 4) ** 3 * (1 + digits / 150)
        seconds += steps * (1.5e-3 + 2 * _product(n, 2 * bits)) + shapes
    return seconds


def _product(n, bits):
    return (n + 1) ** 3 * (1e-7 + 2.6e-12 * bits ** 1.79)
