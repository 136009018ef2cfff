"""Units: text such as `kN/m` to an exact factor and a dimension, and back. SI everywhere inside.

A dimension is a dict of exponents of kg, m, s and of the still unknown dimensions of symbols (`?k`), zeros left out.
"""

from fractions import Fraction
from functools import lru_cache

from vibcli.errors import Diagnostic

LENGTH, MASS, TIME = {"m": 1}, {"kg": 1}, {"s": 1}
NONE = {}


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
    return {base: exponent * power for base, exponent in a.items()} if power else {}


def _dimension(kg=0, m=0, s=0):
    return {base: e for base, e in (("kg", kg), ("m", m), ("s", s)) if e}


class Unit:
    """value·πᵖ in SI, a dimension, and the powers in which it counts cycles (1 of Hz) and radians (1 of rpm)."""

    __slots__ = ("cycles", "dimension", "pi", "radians", "value")

    def __init__(self, value, dimension, pi=0, cycles=0, radians=0):
        self.value, self.dimension, self.pi = Fraction(value), dimension, pi
        self.cycles, self.radians = cycles, radians


_FORCE, _ENERGY, _PRESSURE = _dimension(1, 1, -2), _dimension(1, 2, -2), _dimension(1, -1, -2)
_POUND, _INCH = Fraction("0.45359237"), Fraction("0.0254")
_POUND_FORCE = _POUND * Fraction("9.80665")

UNITS = {
    "kg": Unit(1, MASS), "g": Unit("1e-3", MASS), "mg": Unit("1e-6", MASS), "Mg": Unit(1000, MASS),
    "m": Unit(1, LENGTH), "km": Unit(1000, LENGTH), "dm": Unit("0.1", LENGTH), "cm": Unit("0.01", LENGTH),
    "mm": Unit("1e-3", LENGTH), "um": Unit("1e-6", LENGTH), "µm": Unit("1e-6", LENGTH), "nm": Unit("1e-9", LENGTH),
    "s": Unit(1, TIME), "ms": Unit("1e-3", TIME), "us": Unit("1e-6", TIME), "µs": Unit("1e-6", TIME),
    "min": Unit(60, TIME),
    "N": Unit(1, _FORCE), "mN": Unit("1e-3", _FORCE), "daN": Unit(10, _FORCE), "kN": Unit(1000, _FORCE),
    "MN": Unit(10**6, _FORCE),
    "J": Unit(1, _ENERGY), "mJ": Unit("1e-3", _ENERGY), "kJ": Unit(1000, _ENERGY),
    "W": Unit(1, _dimension(1, 2, -3)), "kW": Unit(1000, _dimension(1, 2, -3)),
    "Pa": Unit(1, _PRESSURE), "kPa": Unit(1000, _PRESSURE), "MPa": Unit(10**6, _PRESSURE),
    "GPa": Unit(10**9, _PRESSURE),
    "rad": Unit(1, NONE, radians=1), "mrad": Unit("1e-3", NONE, radians=1),
    "deg": Unit(Fraction(1, 180), NONE, pi=1, radians=1), "°": Unit(Fraction(1, 180), NONE, pi=1, radians=1),
    "%": Unit("0.01", NONE),
    "Hz": Unit(1, _dimension(s=-1), cycles=1), "kHz": Unit(1000, _dimension(s=-1), cycles=1),
    "MHz": Unit(10**6, _dimension(s=-1), cycles=1),
    "rpm": Unit(Fraction(1, 30), _dimension(s=-1), pi=1, radians=1),
    "in": Unit(_INCH, LENGTH), "ft": Unit(12 * _INCH, LENGTH), "lb": Unit(_POUND, MASS),
    "lbf": Unit(_POUND_FORCE, _FORCE),
    "slug": Unit(_POUND_FORCE / (12 * _INCH), MASS), "psi": Unit(_POUND_FORCE / _INCH**2, _PRESSURE),
}


@lru_cache(maxsize=256)
def combine(chain):
    """The unit of ((name, power), …), e.g. (("N", 1), ("m", -1))."""
    value, dimension, pi, cycles, radians = Fraction(1), {}, 0, 0, 0
    for name, power in chain:
        unit = UNITS[name]
        value *= unit.value**power
        dimension = times(dimension, unit.dimension, power)
        pi += unit.pi * power
        cycles += unit.cycles * power
        radians += unit.radians * power
    return Unit(value, dimension, pi, cycles, radians)


_NAMED = (("N/m", _dimension(1, 0, -2)), ("N·s/m", _dimension(1, 0, -1)), ("N", _FORCE), ("N·m", _ENERGY),
          ("N·m·s", _dimension(1, 2, -1)), ("Pa", _PRESSURE), ("W", _dimension(1, 2, -3)), ("kg/m", _dimension(1, -1)),
          ("rad/s", _dimension(s=-1)), ("1/s²", _dimension(s=-2)), ("N·m²", _dimension(1, 3, -2)),
          ("N/m³", _dimension(1, -2, -2)))
_SUPERSCRIPT = str.maketrans("0123456789-/", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᐟ")


def text(dimension):
    """The SI unit of a dimension as it is printed: 'N/m', 'kg·m²', '' for a pure number."""
    for name, named in _NAMED:
        if dimension == named:
            return name
    if any(base.startswith("?") for base in dimension):
        return ""
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
    """What a field of this unit expects, in words for messages; `unit` None or unknown: by the dimension alone."""
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


_WORDS = ((LENGTH, "a length"), (MASS, "a mass"), (TIME, "a time"), (_FORCE, "a force"),
          (_dimension(1, 0, -2), "a stiffness"), (_dimension(1, 0, -1), "a damping coefficient"),
          (_ENERGY, "a moment, torsional stiffness or energy"), (_dimension(1, 2), "a moment of inertia"),
          (_dimension(1, 2, -1), "a torsional damping coefficient"), (_dimension(0, 1, -2), "an acceleration"),
          (_dimension(0, 1, -1), "a speed"), (_dimension(s=-1), "an angular frequency"), (_dimension(m=2), "an area"),
          (_dimension(1, 2, -3), "a power"))


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
