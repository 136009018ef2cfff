"""How many digits a number is written with, and what its last one is worth."""

import re

SHORT = 3       # digits: fewer are exact


def _number(text: str) -> tuple[str, str, int]:
    """(digits before the point, after it, exponent) of a number as written."""
    whole, fraction, exponent = re.match(r"\s*[-+]?\s*(\d*)\.?(\d*)(?:[eE]([-+]?\d+))?", text).groups()
    return whole, fraction, int(exponent or 0)


def digits_written(text: str) -> int:
    """How many significant digits a number is written with; 0 of what is none."""
    whole, fraction, _ = _number(text)
    return len((whole + fraction).lstrip("0"))


def half_a_unit(text: str) -> float:
    """Half a unit of the last digit of a number as written."""
    _, fraction, exponent = _number(text)
    return 0.5 * 10.0 ** (exponent - len(fraction))
