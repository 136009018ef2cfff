"""Units: text such as `kN/m` to an exact factor and a dimension, and back. SI everywhere inside.

A dimension is a dict of exponents of kg, m, s and of the still unknown dimensions of symbols (`?k`), zeros left out.
"""

from fractions import Fraction
from functools import lru_cache

from vibcli.base.errors import Diagnostic
from vibcli.base.unit_table import (
    AREA,
    ENERGY,
    FORCE,
    LENGTH,
    MASS,
    NONE,
    POWER,
    PRESSURE,
    RATE,
    SPEED,
    TIME,
    UNITS,
    Unit,
    si,
)


def times(a, b, power=1):
    """The dimension a·b^power."""
    found = dict(a)
    for base, exponent in b.items():
        total = found.get(base, 0) + exponent * power
        if total:
            found[base] = total
        else:
            found.pop(base, None)
    return found


def raised(a, power):
    return {base: exponent * power for base, exponent in a.items()} if power else NONE


@lru_cache(maxsize=256)
def combine(chain):
    """The unit of ((name, power), …), e.g. (("N", 1), ("m", -1))."""
    value, dimension, pi, cycles, radians, roots = Fraction(1), {}, 0, 0, 0, ()
    for name, power in chain:
        unit = UNITS[name]
        if Fraction(power).denominator == 1:
            value *= unit.value ** int(power)
        elif unit.value != 1:
            roots += ((unit.value, power),)
        dimension = times(dimension, unit.dimension, power)
        pi += unit.pi * power
        cycles += unit.cycles * power
        radians += unit.radians * power
    return Unit(value, dimension, pi, cycles, radians, roots)


_NAMED = (("N/m", si(1, 0, -2)), ("N·s/m", si(1, 0, -1)), ("N", FORCE), ("N·m", ENERGY),
          ("N·m·s", si(1, 2, -1)), ("Pa", PRESSURE), ("W", POWER), ("kg/m", si(1, -1)),
          ("rad/s", RATE), ("1/s²", si(s=-2)), ("N·m²", si(1, 3, -2)),
          ("N/m³", si(1, -2, -2)))
_SUPERSCRIPT = str.maketrans("0123456789-/", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᐟ")


def text(dimension):
    """The SI unit of a dimension as it is printed: 'N/m', 'kg·m²', '' for a pure number."""
    for name, named in _NAMED:
        if dimension == named:
            return name
    if any(base.startswith("?") for base in dimension):
        return ""
    length = times(dimension, FORCE, -1)
    if set(length) == {"m"} and Fraction(length["m"]).denominator > 1:      # N/m^(3/2), of contact
        return "N" + ("·" if length["m"] > 0 else "/") + _powered("m", abs(length["m"]))
    order = ("kg", "m", "s")
    up = [_powered(base, dimension[base]) for base in order if dimension.get(base, 0) > 0]
    down = [_powered(base, -dimension[base]) for base in order if dimension.get(base, 0) < 0]
    above = "·".join(up) or ("1" if down else "")
    if not down:
        return above
    return above + "/" + (down[0] if len(down) == 1 else "(" + "·".join(down) + ")")


def _powered(base, exponent):
    return base if exponent == 1 else base + str(exponent).translate(_SUPERSCRIPT)


def wanted(unit, dimension):
    """The words for what a field of this unit expects; `unit` None or unknown: by the dimension alone."""
    return _WANTED.get(unit) or name(dimension)


_WANTED = {"rad": "an angle (rad)", "J": "an energy (J)", "N*m": "a moment or torsional stiffness (N·m)",
           "Hz": "a frequency (Hz)", "1/s": "a rate (1/s)", "W": "a power (W)"}


def name(dimension):
    """A dimension in words for messages: 'a stiffness (N/m)' reads better than its exponents."""
    if not dimension:
        return "a pure number"
    for known, words in _WORDS:
        if dimension == known:
            return f"{words} ({text(dimension)})"
    return text(dimension) or "an unknown dimension"


_WORDS = ((LENGTH, "a length"), (MASS, "a mass"), (TIME, "a time"), (FORCE, "a force"),
          (si(1, 0, -2), "a stiffness"), (si(1, 0, -1), "a damping coefficient"),
          (ENERGY, "a moment, torsional stiffness or energy"), (si(1, 2), "a moment of inertia"),
          (si(1, 2, -1), "a torsional damping coefficient"), (si(0, 1, -2), "an acceleration"),
          (SPEED, "a speed"), (RATE, "an angular frequency"), (AREA, "an area"),
          (POWER, "a power"))


class Dimensions:
    """The dimensions of the names of a scene: known, or solved for as fields fix them (linear in the exponents)."""

    def __init__(self):
        self._solved = {}

    def unknown(self, name):
        return {"?" + name: 1}

    def resolve(self, dimension):
        """`dimension` with every unknown that has been solved replaced."""
        while any(base in self._solved for base in dimension):
            found = {}
            for base, exponent in dimension.items():
                found = times(found, self._solved.get(base, {base: 1}), exponent)
            dimension = found
        return dimension

    def of(self, name):
        return self.resolve(self.unknown(name))

    def equate(self, a, b):
        """Make a and b the same dimension by solving for an unknown; False if they cannot be."""
        ratio = self.resolve(times(a, b, -1))
        if not ratio:
            return True
        unknowns = [base for base in ratio if base.startswith("?")]
        if not unknowns:
            return False
        first = unknowns[0]
        exponent = ratio[first]
        factor = -exponent if abs(exponent) == 1 else Fraction(-1) / exponent
        self._solved[first] = {base: e * factor for base, e in ratio.items() if base != first}
        return True


@lru_cache(maxsize=256)
def parse_unit(text, where=None):
    """The unit of a text such as 'kg*m^2' (for the declarations of fields); raises ValueError."""
    import re

    chain, sign = [], 1
    for sep, word, power in re.findall(r"([*/·]?)\s*([A-Za-zµ°%]+|1)(?:\^(-?\d+))?", text):
        sign = -1 if sep == "/" else 1
        if word != "1":
            if word not in UNITS:
                raise ValueError(Diagnostic(where, f"unknown unit '{word}'"))
            chain.append((word, sign * int(power or 1)))
    return combine(tuple(chain))
