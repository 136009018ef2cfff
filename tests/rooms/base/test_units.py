"""Units against their definitions, their powers in literals, and names that are also units.

Sources: BIPM, The International System of Units (9th ed., 2019), tables 4, 7 and 8, and NIST Special Publication 811
(2008), Appendix B.8 (factors for units listed alphabetically); a factor in bold there is exact, here "exact".
"""

import math
from fractions import Fraction

import pytest
from support.scenes import problem

from vibcli.base.errors import SpecError
from vibcli.base.units import UNITS, text
from vibcli.quantities import FAMILIES
from vibcli.symbolic.parser import FUNCTIONS, parse
from vibcli.symbolic.rationals import HALF
from vibcli.symbolic.semantics import literal_unit
from vibcli.symbolic.syntax import ExpressionError, Number

M, L, T = "kg", "m", "s"
FORCE, ENERGY, POWER, PRESSURE = "kg m s^-2", "kg m^2 s^-2", "kg m^2 s^-3", "kg m^-1 s^-2"
PREFIXES = {"n": -9, "u": -6, "µ": -6, "m": -3, "c": -2, "d": -1, "da": 1, "k": 3, "M": 6, "G": 9}
DEFINED = {     # name: (factor to SI as printed in the source, dimension)
    "kg": ("1", M), "g": ("1e-3", M), "mg": ("1e-6", M), "Mg": ("1e3", M), "tonne": ("1e3", M), "m": ("1", L),
    "s": ("1", T), "min": ("60", T), "h": ("3600", T), "day": ("86400", T), "N": ("1", FORCE), "J": ("1", ENERGY),
    "W": ("1", POWER), "Pa": ("1", PRESSURE), "Hz": ("1", "s^-1"), "%": ("0.01", ""), "rad": ("1", ""),
    "mrad": ("1e-3", ""), "in": ("2.54e-2", L), "ft": ("3.048e-1", L), "yd": ("9.144e-1", L), "mi": ("1609.344", L),
    "mph": ("4.4704e-1", "m s^-1"), "lb": ("4.5359237e-1", M), "lbm": ("4.5359237e-1", M), "dyn": ("1e-5", FORCE),
    "erg": ("1e-7", ENERGY), "kgf": ("9.80665", FORCE), "bar": ("1e5", PRESSURE), "mbar": ("100", PRESSURE),
    "atm": ("101325", PRESSURE), "Wh": ("3600", ENERGY), "kWh": ("3.6e6", ENERGY),
}
ROUNDED = {     # to the seven digits of NIST SP 811
    "oz": ("2.834952e-2", M), "slug": ("1.459390e1", M), "lbf": ("4.448222", FORCE), "kip": ("4.448222e3", FORCE),
    "psi": ("6.894757e3", PRESSURE), "ksi": ("6.894757e6", PRESSURE), "psf": ("4.788026e1", PRESSURE),
    "hp": ("7.456999e2", POWER), "knot": ("5.144444e-1", "m s^-1"), "rpm": ("1.047198e-1", "s^-1"),
    "deg": ("1.745329e-2", ""), "°": ("1.745329e-2", ""), "rev": ("6.283185", ""),
}


def dimension(words):
    parts = (word.partition("^") for word in words.split())
    return {base: int(power or 1) for base, _, power in parts}


def defined(name):
    """(factor as text, whether exact, dimension) by the sources; prefixed units by their prefix."""
    if name in DEFINED or name in ROUNDED:
        factor, words = (DEFINED.get(name) or ROUNDED[name])
        return factor, name in DEFINED, dimension(words)
    prefix = next(prefix for prefix in sorted(PREFIXES, key=len, reverse=True)
                  if name.startswith(prefix) and name[len(prefix):] in ("m", "s", "N", "J", "W", "Pa", "Hz"))
    return f"1e{PREFIXES[prefix]}", True, dimension(DEFINED[name[len(prefix):]][1])


@pytest.mark.parametrize("name", UNITS)
def test_units_are_as_defined(name):
    unit = UNITS[name]
    factor, exact, wanted = defined(name)
    assert unit.dimension == wanted
    if exact:
        assert (unit.value, unit.pi) == (Fraction(factor), 0)
    else:
        found = float(unit.value) * math.pi**unit.pi
        digits = len(factor.partition("e")[0].replace(".", ""))
        assert f"{found:.{digits - 1}e}" == f"{float(factor):.{digits - 1}e}"
    assert unit.in_si(3) == pytest.approx(3 * float(factor), rel=1e-6)
    angle, cycle = name in ("rad", "mrad", "deg", "°", "rev", "rpm"), name.endswith("Hz")
    assert (unit.radians, unit.cycles) == (int(angle), int(cycle))


def test_relations_that_are_exact_by_definition():
    value = {name: unit.value for name, unit in UNITS.items()}
    assert value["lbf"] == value["lb"] * value["kgf"]                       # at standard gravity, 9.80665 m/s²
    assert value["slug"] * value["ft"] == value["lbf"]                      # 1 ft/s² by 1 lbf
    assert value["psi"] * value["in"] ** 2 == value["lbf"] == value["psf"] * value["ft"] ** 2
    assert value["ksi"] * value["in"] ** 2 == value["kip"] == 1000 * value["lbf"]
    assert value["hp"] == 550 * value["ft"] * value["lbf"]
    assert value["mi"] == 5280 * value["ft"] == value["mph"] * value["h"]
    assert value["knot"] * value["h"] == 1852
    assert 16 * value["oz"] == value["lb"]
    assert value["rev"] == value["rpm"] * value["min"] == 360 * value["deg"]


def test_no_unit_is_a_word_of_the_language():
    words = {"t", "d", "v", "pi", "x", "y", "phi", *FUNCTIONS, *FAMILIES, "ground", "power", "value"}
    assert words & set(UNITS) == {"J", "min"}               # J[disc, O] and min(a, b) are told by their brackets
    assert {name for name, unit in UNITS.items() if unit.cycles} == {"Hz", "mHz", "kHz", "MHz", "GHz"}
    assert {name for name, unit in UNITS.items() if unit.radians} == {"rad", "mrad", "deg", "°", "rev", "rpm"}


@pytest.mark.parametrize(("written", "value", "wanted"), [
    ("4 m^0.5", 4, {"m": HALF}), ("4 m**(1/2)", 4, {"m": HALF}), ("4 m^(-1)", 4, {"m": -1}), ("4 m^-2", 4, {"m": -2}),
    ("900 N/m^(3/2)", 900, {"kg": 1, "m": -HALF, "s": -2}), ("900 N/m^1.5", 900, {"kg": 1, "m": -HALF, "s": -2}),
    ("900 N/mm^(3/2)", 900 * 1000**1.5, {"kg": 1, "m": -HALF, "s": -2}), ("3 mm^12", 3e-36, {"m": 12}),
    ("5 kN*s^0.5/cm^0.5", 5e4, {"kg": 1, "m": HALF, "s": -2 + HALF}), ("36 km/h", 10, {"m": 1, "s": -1}),
    ("60 rev/min", 2 * math.pi, {"s": -1}), ("4 deg^0.5", 4 * math.sqrt(math.pi / 180), {}),
    ("2 in^2", 0.00129032, {"m": 2}),
])
def test_powers_belong_to_the_unit(written, value, wanted):
    tree = parse(written)
    assert isinstance(tree, Number)
    unit = literal_unit(tree.units)
    assert unit.dimension == wanted
    assert unit.in_si(tree.value) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize("written", ["4 m^n", "4 m^(n + 1)", "4 m^2^3", "4 m^-n", "2 N*m^(1/n)", "4 m^13", "4 m^(1/0)",
                                     "4 m²^2", "3 m^2.5.1", "1 m^x", "4 m^0.12345678901"])
def test_other_powers_of_units_are_refused(written):
    with pytest.raises(ExpressionError, match=r"power|operator"):
        parse(written)


@pytest.mark.parametrize(("given", "asked", "wanted"), [
    ("a: 900 N/mm^(3/2)", "a*(4 mm)^1.5", "7.2e3 N"), ("a: 4 m^0.5", "a^2", "16 m"), ("a: 36 km/h", "a*(1 h)", "36 km"),
    ("a: 90 N/m^(1/2)", "a*(9 mm)^(1/2)", "8.5381496824546 N"), ("a: 60 mph", "a", "26.8224 m/s"),
])
def test_fields_answers_and_settings_take_them(given, asked, wanted):
    scene = problem(f"""
        parameters: {{{given}}}
        bodies: {{one: {{mass: 2 kg, slide: x}}}}
        springs: {{s: {{k: 8 N/m, between: [ground, one]}}}}
        constraints: {{}}
        answers: {{"omega[1]*({asked})": 2 rad/s*({wanted})}}
    """.replace("        constraints: {}\n", ""))
    from vibcli.check.verdicts import check

    assert [verdict.agrees for verdict in check(scene)] == [True]


def wrong(parameters):
    try:
        problem(f"""
            parameters: {{{parameters}}}
            bodies: {{one: {{mass: 2 kg, slide: x}}}}
            springs: {{s: {{k: (8 N/m), between: [ground, one]}}}}
        """)
    except SpecError as error:
        return [(d.message, d.hint) for d in error.diagnostics]
    return []


@pytest.mark.parametrize("name", [name for name in UNITS if name.isascii() and name.isalpha()])
def test_a_unit_that_is_a_name_of_the_scene(name):
    """Beside a name that measures the same, 3 kN/u is refused with both readings, each of which works; beside a name
    that measures something else it is the unit."""
    other = "unused: allowed"
    dimension = text(UNITS[name].dimension).replace("·", "*").replace("²", "^2").replace("³", "^3")
    same, value = f"{name}: {{value: 2 {dimension or ''}, {other}}}", "b: {{value: {}, unused: allowed}}"
    message, hint = wrong(f"{same}, {value.format(f'3 kN/{name}')}")[0]
    assert message == f"'{name}' is a unit and a name of this scene"
    assert hint == f"write (3 kN/{name}) for the unit or (3 kN)/{name} for the name"
    for reading in (f"(3 kN/{name})", f"(3 kN)/{name}"):
        assert wrong(f"{same}, {value.format(reading)}") == []
    assert wrong(f"{name}: {{value: 2 m^7, {other}}}, {value.format(f'3 kN/{name}')}") == []
    assert wrong(f"{name}: {{value: 2 m^7, {other}}}, {value.format(f'2*3 kN/{name}')}")[0][0] == message
