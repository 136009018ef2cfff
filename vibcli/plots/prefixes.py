"""Readable units for axes: 0.0032 m is 3.2 mm; where a unit takes no prefix, a power of ten stands before it."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units

if TYPE_CHECKING:
    import numpy as np

_PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
_SMALL = {-9: "n", -6: "µ", -3: "m", 0: ""}
_TAKES = {"m": _SMALL | {3: "k"}, "s": _SMALL, "rad": {-3: "m", 0: ""}, "N": _PREFIXES, "J": _PREFIXES,
          "W": _PREFIXES, "Pa": _PREFIXES, "Hz": _PREFIXES}
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_SMALLEST = 1e-290



def unit_text(unit: str | dict[str, Any]) -> str:
    """The SI unit of a dimension; a text is one already."""
    return unit if isinstance(unit, str) else units.text(unit)


def readable(largest: float, unit: str) -> tuple[float, str]:
    """(factor, unit): values·factor are to be read in that unit, the largest magnitude between 0.1 and 10⁴ of it."""
    if not _SMALLEST < largest < math.inf:
        return 1.0, unit
    exponent = 3 * math.floor((math.log10(largest) + 1) / 3)
    if largest >= 1 and largest < 1e4:
        exponent = 0
    head = unit.partition("·")[0].partition("/")[0]
    prefixes = _TAKES.get(head, {0: ""})
    if exponent in prefixes:
        return 10.0 ** -exponent, prefixes[exponent] + unit
    if -3 < math.log10(largest) < 5:
        return 1.0, unit
    return 10.0 ** -exponent, f"{power(exponent)} {unit}".rstrip()


def power(exponent: int) -> str:
    """10⁻³"""
    return "10" + str(exponent).translate(_SUPERSCRIPT)


def labelled(name: str, unit: str) -> str:
    """`x [mm]`; the name alone where there is no unit."""
    return f"{name} [{unit}]".lstrip() if unit else name


def largest(values: "Sequence[complex] | np.ndarray") -> float:
    """The largest magnitude of the finite ones among real or complex numbers; 0 where there is none."""
    values = values.tolist() if hasattr(values, "tolist") else values
    return max((size for size in map(abs, values) if size < math.inf), default=0.0)
