"""The units by name: exact factors to SI, dimensions, and what counts cycles or radians.

No unit is a word of the language: `2 mm/s*t` keeps its time and `800 N/m*d` its deflection, so a tonne is not `t` and
a day is not `d`.
"""

from fractions import Fraction

NONE, LENGTH, MASS, TIME = {}, {"m": 1}, {"kg": 1}, {"s": 1}


def si(kg=0, m=0, s=0):
    """The dimension kg^kg·m^m·s^s."""
    return {base: e for base, e in (("kg", kg), ("m", m), ("s", s)) if e}


class Unit:
    """value·πᵖ·Π bᵉ in SI, the last of `roots` (b, e) with fractional e; a dimension, and the powers in which it counts
    cycles (1 of Hz) and radians (1 of rpm)."""

    __slots__ = ("cycles", "dimension", "pi", "radians", "roots", "value")

    def __init__(self, value, dimension, pi=0, cycles=0, radians=0, roots=()):
        self.value, self.dimension, self.pi = Fraction(value), dimension, pi
        self.cycles, self.radians, self.roots = cycles, radians, roots

    def in_si(self, number):
        """So many of this unit in SI, as a float."""
        found = float(number * self.value) * 3.141592653589793**self.pi
        for base, exponent in self.roots:
            found *= float(base) ** float(exponent)
        return found


RATE, SPEED, AREA = si(s=-1), si(m=1, s=-1), si(m=2)
FORCE, ENERGY, POWER, PRESSURE = si(1, 1, -2), si(1, 2, -2), si(1, 2, -3), si(1, -1, -2)
_PREFIXES = {"n": "1e-9", "u": "1e-6", "µ": "1e-6", "m": "1e-3", "c": "1e-2", "d": "0.1", "da": "10", "k": "1e3",
             "M": "1e6", "G": "1e9"}
_POUND, _INCH, _GRAVITY = Fraction("0.45359237"), Fraction("0.0254"), Fraction("9.80665")     # exact by definition
_POUND_FORCE, _FOOT, _MILE = _POUND * _GRAVITY, 12 * _INCH, 63360 * _INCH
_HOUR = 3600


def _prefixed(name, prefixes, dimension, value=1, **counts):
    """{name: Unit} of a unit with each of some prefixes, and without."""
    return {prefix + name: Unit(Fraction(_PREFIXES.get(prefix, 1)) * value, dimension, **counts)
            for prefix in ("", *prefixes.split())}


UNITS = {
    "kg": Unit(1, MASS), "g": Unit("1e-3", MASS), "mg": Unit("1e-6", MASS), "Mg": Unit(1000, MASS),
    "tonne": Unit(1000, MASS), "lb": Unit(_POUND, MASS), "lbm": Unit(_POUND, MASS), "oz": Unit(_POUND / 16, MASS),
    "slug": Unit(_POUND_FORCE / _FOOT, MASS),
    **_prefixed("m", "k d c m u µ n", LENGTH),
    "in": Unit(_INCH, LENGTH), "ft": Unit(_FOOT, LENGTH), "yd": Unit(3 * _FOOT, LENGTH), "mi": Unit(_MILE, LENGTH),
    **_prefixed("s", "m u µ n", TIME),
    "min": Unit(60, TIME), "h": Unit(_HOUR, TIME), "day": Unit(24 * _HOUR, TIME),
    "mph": Unit(_MILE / _HOUR, SPEED), "knot": Unit(Fraction(1852, _HOUR), SPEED),
    **_prefixed("N", "u µ m da k M G", FORCE),
    "dyn": Unit("1e-5", FORCE), "kgf": Unit(_GRAVITY, FORCE), "lbf": Unit(_POUND_FORCE, FORCE),
    "kip": Unit(1000 * _POUND_FORCE, FORCE),
    **_prefixed("J", "m k M", ENERGY),
    "erg": Unit("1e-7", ENERGY), "Wh": Unit(_HOUR, ENERGY), "kWh": Unit(1000 * _HOUR, ENERGY),
    **_prefixed("W", "m k M", POWER),
    "hp": Unit(550 * _FOOT * _POUND_FORCE, POWER),
    **_prefixed("Pa", "m k M G", PRESSURE),
    "bar": Unit(10**5, PRESSURE), "mbar": Unit(100, PRESSURE), "atm": Unit(101325, PRESSURE),
    "psi": Unit(_POUND_FORCE / _INCH**2, PRESSURE), "ksi": Unit(1000 * _POUND_FORCE / _INCH**2, PRESSURE),
    "psf": Unit(_POUND_FORCE / _FOOT**2, PRESSURE),
    "rad": Unit(1, NONE, radians=1), "mrad": Unit("1e-3", NONE, radians=1),
    "deg": Unit(Fraction(1, 180), NONE, pi=1, radians=1), "°": Unit(Fraction(1, 180), NONE, pi=1, radians=1),
    "rev": Unit(2, NONE, pi=1, radians=1), "%": Unit("0.01", NONE),
    **_prefixed("Hz", "m k M G", RATE, cycles=1),
    "rpm": Unit(Fraction(1, 30), RATE, pi=1, radians=1),
}
