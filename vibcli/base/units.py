"""Units: text such as `kN/m` to an exact factor and a dimension, and back. SI everywhere inside.

A dimension is a dict of exponents of kg, m, s and of the still unknown dimensions of symbols (`?k`), zeros left out. No
unit is a word of the language: `2 mm/s*t` keeps its time and `800 N/m*d` its deflection, so a tonne is not `t`.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    Dimension = Mapping[str, Fraction | int]

NONE, LENGTH, MASS, TIME = {}, {"m": 1}, {"kg": 1}, {"s": 1}


def si(kg: int = 0, m: int = 0, s: int = 0) -> dict[str, int]:
    """The dimension kg^kg·m^m·s^s."""
    return {base: e for base, e in (("kg", kg), ("m", m), ("s", s)) if e}


class Unit:
    """value·πᵖ·Π bᵉ in SI, the last of `roots` (b, e) with fractional e; a dimension, and the powers in which it counts
    cycles (1 of Hz) and radians (1 of rpm). Of a scene's few units alone the value is made a fraction."""

    __slots__ = ("_prefix", "_value", "cycles", "dimension", "pi", "radians", "roots")

    def __init__(self, value: Any, dimension: Mapping[str, Fraction | int], pi: Fraction | int = 0,
                 cycles: Fraction | int = 0, radians: Fraction | int = 0, roots: Any = (), prefix: str = "") -> None:
        self._value, self.dimension, self.pi = value, dimension, pi
        self.cycles, self.radians, self.roots, self._prefix = cycles, radians, roots, prefix

    @property
    def value(self) -> Fraction:
        if not isinstance(self._value, Fraction):
            self._value = Fraction(_PREFIXES[self._prefix]) * Fraction(self._value)
        return self._value

    def in_si(self, number: Fraction | int) -> float:
        """So many of this unit in SI, as a float."""
        found = float(number * self.value) * 3.141592653589793**self.pi
        for base, exponent in self.roots:
            found *= float(base) ** float(exponent)
        return found


RATE, SPEED, AREA = si(s=-1), si(m=1, s=-1), si(m=2)
FORCE, ENERGY, POWER, PRESSURE = si(1, 1, -2), si(1, 2, -2), si(1, 2, -3), si(1, -1, -2)
_PREFIXES = {"": "1", "n": "1e-9", "u": "1e-6", "µ": "1e-6", "m": "1e-3", "c": "1e-2", "d": "0.1", "da": "10",
             "k": "1e3", "M": "1e6", "G": "1e9"}
_POUND, _INCH, _GRAVITY = Fraction("0.45359237"), Fraction("0.0254"), Fraction("9.80665")     # exact by definition
_POUND_FORCE, _FOOT, _MILE = _POUND * _GRAVITY, 12 * _INCH, 63360 * _INCH
_HOUR = 3600


def _prefixed(name: str, prefixes: str, dimension: Mapping[str, Fraction | int], **counts: int) -> dict[str, Unit]:
    """{name: Unit} of a unit with each of some prefixes, and without."""
    return {prefix + name: Unit(1, dimension, prefix=prefix, **counts) for prefix in ("", *prefixes.split())}


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


def times(a: Mapping[str, Fraction | int], b: Any, power: Fraction | int = 1) -> dict[str, Fraction | int]:
    """The dimension a·b^power."""
    found, plain = dict(a), power == 1
    for base, exponent in b.items():
        known, more = found.get(base), exponent if plain else exponent * power
        total = more if known is None else known + more
        if total:
            found[base] = total
        else:
            found.pop(base, None)
    return found


def raised(a: Any, power: Any) -> dict[str, Fraction]:
    return {base: exponent * power for base, exponent in a.items()} if power else NONE


@lru_cache(maxsize=256)
def combine(chain: Sequence[tuple[str, Fraction | int]]) -> Unit:
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
          ("N/m³", si(1, -2, -2)), ("m/N", si(-1, s=2)), ("m/(N·s)", si(-1, s=1)), ("rad/(N·m)", si(-1, -2, 2)),
          ("rad/N", si(-1, -1, 2)))
_SUPERSCRIPT = str.maketrans("0123456789-/", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᐟ")


def text(dimension: Any) -> str:
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


def _powered(base: str, exponent: Any) -> str:
    return base if exponent == 1 else base + str(exponent).translate(_SUPERSCRIPT)


def wanted(unit: str | None, dimension: Mapping[str, Fraction | int]) -> str:
    """The words for what a field of this unit expects; `unit` None or unknown: by the dimension alone."""
    return _WANTED.get(unit) or name(dimension)


_WANTED = {"rad": "an angle (rad)", "J": "an energy (J)", "N*m": "a moment or torsional stiffness (N·m)",
           "N/m": "a stiffness (N/m)",
           "Hz": "a frequency (Hz)", "1/s": "a rate (1/s)", "W": "a power (W)"}


def name(dimension: Mapping[str, Fraction | int]) -> str:
    """A dimension in words for messages: 'a stiffness (N/m)' reads better than its exponents."""
    if not dimension:
        return "a pure number"
    for known, words in _WORDS:
        if dimension == known:
            return f"{words} ({text(dimension)})"
    return text(dimension) or "an unknown dimension"


_WORDS = ((LENGTH, "a length"), (MASS, "a mass"), (TIME, "a time"), (FORCE, "a force"),
          (si(1, 0, -2), "a stiffness or load per length"), (si(1, 0, -1), "a damping coefficient"),
          (ENERGY, "a moment, torsional stiffness or energy"), (si(1, 2), "a moment of inertia"),
          (si(1, 2, -1), "a torsional damping coefficient"), (si(0, 1, -2), "an acceleration"),
          (SPEED, "a speed"), (RATE, "an angular frequency"), (AREA, "an area"),
          (POWER, "a power"))


class Dimensions:
    """The dimensions of the names of a scene: known, or solved for as fields fix them (linear in the exponents)."""

    def __init__(self) -> None:
        self._solved = {}

    def unknown(self, name: str) -> dict[str, Fraction | int]:
        return {"?" + name: 1}

    def resolve(self, dimension: Mapping[str, Fraction | int]) -> Mapping[str, Fraction | int]:
        """`dimension` with every unknown that has been solved replaced."""
        while not self._solved.keys().isdisjoint(dimension):
            found = {}
            for base, exponent in dimension.items():
                found = times(found, self._solved.get(base, {base: 1}), exponent)
            dimension = found
        return dimension

    def of(self, name: str) -> Mapping[str, Fraction | int]:
        return self.resolve(self.unknown(name))

    def equate(self, a: Mapping[str, Fraction | int], b: Mapping[str, Fraction | int]) -> bool:
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
def parse_unit(text: str) -> Unit:
    """The unit of a text such as 'kg*m^2' (for the declarations of fields); raises ValueError."""
    chain = []
    for part in text.replace("·", "*").replace("/", "*/").split("*"):
        word, _, power = part.strip("/ ").partition("^")
        if word not in UNITS and word not in ("", "1"):
            raise ValueError(f"unknown unit '{word}'")
        if word in UNITS:
            chain.append((word, (-1 if part.startswith("/") else 1) * int(power or 1)))
    return combine(tuple(chain))
