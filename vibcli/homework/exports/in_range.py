"""Units in which keys lie in the range that a format keeps."""

import re
from math import log10
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.units import UNITS
from vibcli.language.given_values import unit_of_text
from vibcli.notation.numbers import figure

if TYPE_CHECKING:
    from collections.abc import Callable
    from fractions import Fraction

LEAST, MOST = 0.1, 1000.0
DECIMALS = 4            # to which answers are rounded
NAME = re.compile(r"[^\W\d]+|%|°")
PER_CENT = "%"
ANGLES = "rad", "mrad", "deg"
OLD = {"dyn", "erg", "tonne", "bar", "mbar"}       # that nobody expects beside SI


def unit_in_range(value: float, figures: int, unit: str, what: str) -> tuple[str, float]:
    """(text of a unit, how many of it one of the asked unit is) in which a key with so many figures has no more than
    DECIMALS, the asked one where it does; PhysicsError of a key that no unit brings there. what: the key in words."""
    least = max(LEAST, 10.0**(figures - 1 - DECIMALS))
    for alike in (_by_tens, _angles):
        found = [(other, factor) for other, factor in [(unit, 1.0), *_others(unit, alike)]
                 if value == 0.0 or least <= abs(value) * factor <= MOST]
        if found:
            return found[0] if found[0][0] == unit else min(
                found, key=lambda one: abs(log10(abs(value) * one[1]) - 1))
    known = f"{what} is {figure(value)} {unit}".rstrip()
    raise PhysicsError(f"{known}, and no unit brings it between {least:g} and {MOST:g}", "Canvas rounds answers to "
                       "four decimals: ask for another quantity, or leave Canvas out")


def _others(unit: str, alike: "Callable[[str], list[str]]") -> list[tuple[str, float]]:
    """(text, factor) of units in which another stands for one of those of a unit, % for a pure number."""
    if not unit:
        return [(PER_CENT, 100.0)]
    if unit == PER_CENT:
        return [("", 0.01)]
    found = []
    for match in NAME.finditer(unit):
        for name in alike(match[0]):
            other = unit[:match.start()] + name + unit[match.end():]
            found.append((other, unit_of_text(unit).in_si(1) / unit_of_text(other).in_si(1)))
    return found


def _angles(name: str) -> list[str]:
    """The units of angles beside one of them."""
    return [other for other in ANGLES if other != name] if name in ANGLES else []


def _by_tens(name: str) -> list[str]:
    """The units that are a power of ten of one, and of its kind: km and mm for m."""
    own = UNITS.get(name)
    return [] if own is None else [
        other for other, unit in UNITS.items() if other != name and other.isascii() and not unit.roots
        and (unit.dimension, unit.pi, unit.cycles, unit.radians) == (own.dimension, own.pi, own.cycles, own.radians)
        and _is_power_of_ten(unit.value / own.value) and other not in OLD]


def _is_power_of_ten(ratio: "Fraction") -> bool:
    top, bottom = str(ratio.numerator), str(ratio.denominator)
    return set(top[1:] + bottom[1:]) <= {"0"} and top[0] == bottom[0] == "1"
