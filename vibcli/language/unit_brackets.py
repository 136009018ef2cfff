"""Units in brackets, `2 N*(s/m)^0.5`: how the same unit is written without them, `2 N*s^0.5/m^0.5`."""

import re
from fractions import Fraction

from vibcli.base.units import UNITS
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError, whole_literal

_BRACKET = re.compile(r"([*/·])?\s*\(([^()]*)\)(?:\s*(?:\^|\*\*)\s*(?:(-?\d+(?:\.\d+)?)|"
                      r"\(\s*(-?\d+(?:\.\d+|\s*/\s*\d+)?)\s*\)))?")
_UNIT = re.compile(r"\s*([*/·]?)\s*([A-Za-zµμ°%]+|1(?=\s*/))(?:\s*(?:\^|\*\*)\s*(-?\d+(?:\.\d+)?))?\s*")


def opened(text: str, start: int) -> str | None:
    """The text of a number with its unit without the brackets about the unit at `start`; None of anything else."""
    for bracket in _BRACKET.finditer(text):
        if not bracket.start(2) <= start < bracket.end(2):
            continue
        chain = _chain(bracket[2])
        head = text[:bracket.start()].rstrip()
        if chain is None:
            return None
        plain = bracket[1] != "/"
        power = Fraction((bracket[3] or bracket[4] or "1").replace(" ", "")) * (1 if plain else -1)
        found = "".join(_factor(name, exponent * power) for name, exponent in chain)
        if head[-1:].isdigit() and "^" not in head and not re.search("[A-Za-z]", head):    # a number without a unit
            found = " " + (found[1:] if found.startswith("*") else found)
        return _literal(head + found + text[bracket.end():])
    return None


def _chain(text: str) -> list[tuple[str, Fraction]] | None:
    """[(unit, exponent)] of a product of units; None of what is none."""
    found, at = [], 0
    while at < len(text):
        part = _UNIT.match(text, at)
        if part is None or (at and not part[1]) or (part[2] != "1" and part[2] not in UNITS):
            return None
        if part[2] != "1":
            found.append((part[2], Fraction(part[3] or 1) * (-1 if part[1] == "/" else 1)))
        at = part.end()
    return found


def _factor(name: str, exponent: Fraction) -> str:
    if not exponent:
        return ""
    size = abs(exponent)
    decimal = f"{float(size):.6g}"
    power = "" if size == 1 else f"^{decimal}" if Fraction(decimal) == size else f"^({size})"
    return ("*" if exponent > 0 else "/") + name + power


def _literal(text: str) -> str | None:
    """The text, where it is one number with its unit."""
    try:
        return text if whole_literal(parse(text)) else None
    except ExpressionError:
        return None
