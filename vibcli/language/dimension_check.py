"""Does one expression fit where it stands: are its names known there, has it the dimension that is due?"""

import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.base.spelling import near, nearest
from vibcli.language.record_calls import own
from vibcli.symbolic.parser import FUNCTIONS, VALUE
from vibcli.symbolic.semantics import ALL_NUMBERS, ANY, DimensionCheck, literal_unit
from vibcli.symbolic.syntax import Equation, ExpressionError, NameRef, QuantityRef, Sum, parts_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression, Reader, Record
    from vibcli.language.spec import Spec
    from vibcli.symbolic.syntax import Number, UnitPower

TIMED = ("impulse", "square", "sawtooth")
APART = r"(?<![\w.])(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)\s*([*/])\s*$"     # a number and an operator
UNIT_DUE = "write the unit:"
_CONSTANTS = {"Pi": "did you mean 'pi'?", "PI": "did you mean 'pi'?", "e": "e to the power of x is written exp(x)"}
NO_NUMBERS = ("nan", "inf", "infinity", "null", "none", "true", "false", "yes", "no", "on", "off")


def check(spec: "Spec", reader: "Reader", expression: "Expression",
          names: "Mapping[str, Record | None] | Sequence[str]", expected: "units.Dimension | None",
          local: "tuple[str, units.Dimension] | None" = None) -> bool:
    """Names and dimension of one expression; True where both fit. `local`: (name, dimension) of what has a name in it
    alone."""
    before = len(reader.diagnostics)
    named = expression.parts.names
    if not reader.sound and not all(name in names or name in ("pi", "t") for name, *_ in named):
        return True
    for name, primes, start, end in named:
        if local and name == local[0]:
            if primes:
                reader.report(expression.scalar.place(start, end - start), f"'{name}' has no derivative here",
                              f"it is a number on which this depends: write '{name}' alone")
            continue
        if name in names:
            spec.used.add(name)
            _primes(spec, reader, expression, name, primes, start, end)
        elif name != "pi":
            told = _misplaced_unit(expression, name, start, names) or _unknown(
                spec, name, names, expression.scalar in reader.motions, local)
            reader.report(expression.scalar.place(start, end - start), *told)
    _ambiguous(spec, reader, expression, local)
    _of_time_alone(spec, reader, expression)
    if not spec.asked_dimension:
        _no_quantities(reader, expression)
    if len(reader.diagnostics) > before:
        return False
    try:
        def of(name: str, primes: int) -> "units.Dimension":
            known = local[1] if local and name == local[0] else spec.dimensions.of(name)
            return units.times(known, units.TIME, -primes) if primes else known

        def quantity(tree: QuantityRef) -> "units.Dimension | None":
            return spec.asked_dimension(spec, tree)

        checker = DimensionCheck(spec.dimensions, of, spec.free_numbers, quantity, expression.text)
        tree = expression.tree
        if isinstance(tree, Equation):
            checker.dimension(Sum(tree.start, tree.end, ((1, tree.left), (1, tree.right))))
        else:
            _fits(spec, reader, expression, checker.dimension(tree), expected)
    except ExpressionError as error:
        reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
    return len(reader.diagnostics) == before


def _of_time_alone(spec: "Spec", reader: "Reader", expression: "Expression") -> None:
    """Impulses, waves and records are functions of the time, not of where things are."""
    for call in expression.parts.calls:
        recorded = call.name in spec.named.get("records", ())
        if recorded:
            spec.used.add(own(call.name))
        if recorded or call.name in TIMED:
            for name, _, start, end in (place for arg in call.args for place in parts_of(arg).names):
                if name in spec.coordinates:
                    reader.report(expression.scalar.place(start, end - start), f"{call.name} is a function of the "
                                  f"time: the coordinate '{name}' cannot stand in it", f"as in {call.name}(t)")


def _fits(spec: "Spec", reader: "Reader", expression: "Expression",
          found: "units.Dimension | None", expected: "units.Dimension | None") -> None:
    only_numbers = all(name == "pi" for name, *_ in expression.parts.names)
    if spec.free_numbers == ALL_NUMBERS or expected is None or found is ANY or (spec.free_numbers and only_numbers):
        return
    if found != expected and not spec.dimensions.equate(expected, found):
        literal = expression.parts.whole
        if literal and (competing := _competing(spec, expression, literal)):
            _two_readings(reader, expression, literal, competing[0])
            return
        wanted = units.wanted(expression.unit, spec.dimensions.resolve(expected))
        message = f"expected {wanted}, found {_found(expression, spec.dimensions.resolve(found))}"
        _, factor = reader.along.get(expression.scalar, (None, None))
        reader.report(expression.scalar.place(0, len(expression.text)), message, "give each value the unit of its "
                      "coordinate" if factor else _unit_hint(spec, expression, wanted))


def _found(expression: "Expression", dimension: "units.Dimension") -> str:
    literal = expression.parts.whole
    if literal and literal.units:
        if not dimension and literal.units[0].unit != "%":
            return "an angle (rad)"
        if literal_unit(literal.units).cycles:
            return "a frequency (Hz)"
    return units.name(dimension)


def _unit_hint(spec: "Spec", expression: "Expression", wanted: str) -> str | None:
    """A number without unit: where and how to write it."""
    literal = expression.parts.whole
    if not expression.unit:
        unit = re.search(r"\((\S+)\)$", wanted)
        return f"{UNIT_DUE} {expression.text} {unit[1]}" if unit and literal and not literal.units else None
    found = literal_unit(literal.units).dimension if literal else None
    if expression.unit == "N/m" and found == units.parse_unit("N*m").dimension:
        return "a torsional stiffness is given as `torsion:`"
    if expression.unit == "N" and found == units.parse_unit("kg").dimension:
        return f"a weight is a mass times g: {expression.text}*9.81 m/s^2"
    if literal and not literal.units:
        return f"{UNIT_DUE} {expression.text} {unit_of_a_number(expression.unit)}"
    name = expression.tree.name if isinstance(expression.tree, NameRef) else None
    value = spec.parameters[name].get("value") if name in spec.parameters else None
    if name in spec.parameters and value is None:
        return f"'{name}' is {units.name(spec.dimensions.of(name))} in another place"
    literal = value and value.parts.whole
    if literal and not literal.units:
        return f"give '{name}' its unit: {value.text} {unit_of_a_number(expression.unit)}"
    from vibcli.symbolic.foreign_signs import of_form

    return of_form(value.text if value else expression.text)


def unit_of_a_number(unit: str) -> str:
    """A unit as it stands behind a number: 1/s is s^-1."""
    return unit.replace("1/", "", 1) + "^-1" if unit.startswith("1/") else unit


def _no_quantities(reader: "Reader", expression: "Expression") -> None:
    for tree in expression.parts.quantities:
        if tree.head == VALUE:
            applied(reader, expression, tree)
            continue
        reader.report(expression.scalar.place(tree.start, tree.end - tree.start), f"'{tree.text}' cannot stand here",
                      "what is asked of a scene, such as omega[1], stands under answers")


def applied(reader: "Reader", expression: "Expression", tree: QuantityRef) -> None:
    """Something like x(2), where it can be neither a function nor a value in time."""
    inner, start = tree.args[0], tree.start
    if isinstance(inner, NameRef):
        from vibcli.symbolic.function_names import function_meant

        hint = function_meant(inner.name) or "functions: " + " ".join(FUNCTIONS)
        reader.report(expression.scalar.place(start, inner.end - start), f"unknown function '{inner.name}'", hint)
        return
    bracket = expression.text.index("(", inner.end)
    reader.report(expression.scalar.place(bracket, 1), "expected an operator before '('",
                  "there is no implicit multiplication: write a * between factors")


def _primes(spec: "Spec", reader: "Reader", expression: "Expression", name: str, primes: int, start: int,
            end: int) -> None:
    if not primes:
        return
    place = expression.scalar.place(start, end - start)
    if name in spec.parameters or name not in spec.coordinates:
        what = "a parameter" if name in spec.parameters else "the time"
        reader.report(place, f"'{name}' is {what}: it has no derivative", "only coordinates move")
    elif primes > 1 and expression.scalar in reader.loads:
        reader.report(place, "accelerations cannot stand here",
                      "loads depend on coordinates and velocities, constraints on positions")
    elif reader.sound and expression.scalar not in reader.at_speed:
        reader.report(place, "velocities cannot stand here", "they stand in energies, forces and expected equations")


def _misplaced_unit(expression: "Expression", name: str, start: int,
                    names: "Mapping[str, Record | None] | Sequence[str]") -> tuple[str, str] | None:
    """Of a unit in brackets, 2 N*(s/m), or after an operator, 3*N/m, or misspelt, 3 m/sec: what is wrong and what to
    write; None of another name."""
    if name not in units.UNITS:
        from vibcli.base.unit_suggestions import spelt_otherwise

        joined = any(number.units and expression.text[number.end:start].strip() in ("*", "/", "·")
                     for number in expression.parts.numbers)
        meant = spelt_otherwise(name) if joined and not near(name, names) else None
        return (f"unknown name '{name}'", f"did you mean '{meant[0]}'?") if meant else None
    from vibcli.language.unit_brackets import opened

    text = opened(expression.text, start)
    if text is not None:
        return f"unknown name '{name}'", f"units take brackets for exponents alone: write {text}"
    apart = re.compile(APART).search(expression.text, 0, start)
    if apart is None or near(name, names):
        return None
    written = f"{apart[1]} {name}" + "^-1" * (apart[2] == "/")
    return f"unknown name '{name}'", f"a unit stands right after its number: write {written}"


def _unknown(spec: "Spec", name: str, names: "Mapping[str, Record | None] | Sequence[str]", moves: bool,
             local: "tuple[str, units.Dimension] | None") -> tuple[str, str | None]:
    if name == "t":
        return "the time t cannot stand here", "it stands in motions, driven points, forces, energies and constraints"
    if name in spec.named.get("records", ()):
        return f"'{name}' is a record, a function of the time", f"write {name}(t)"
    if name in spec.coordinates:
        return f"'{name}' is a coordinate: only parameters may stand here", "write numbers and parameters"
    if name.lower() in NO_NUMBERS:
        return f"'{name}' is not a number", "write a finite number, or nothing at all: then the parameter is a symbol"
    power = re.fullmatch(r"([A-Za-z]+)([2-4])", name)
    if power and power.group(1) in units.UNITS:
        return f"unknown name '{name}'", f"a power of a unit is written {power.group(1)}^{power.group(2)}"
    factors = [(name[:i], name[i:]) for i in range(1, len(name)) if name[:i] in names and name[i:] in names]
    if factors and len(set(factors[0])) > 1:
        return f"unknown name '{name}'", f"a product is written with *: {'*'.join(factors[0])}"
    if name in _CONSTANTS and (near(name, names) or "").lower() != name.lower():
        return f"unknown name '{name}'", _CONSTANTS[name]
    hint = nearest(name, names)
    if local and not (hint or "").startswith("did"):
        return (f"unknown name '{name}'",
                f"what it depends on is called {local[0]} here; a parameter is declared under `parameters:`")
    if names is not spec.parameters and (not hint or hint.startswith("valid")):
        hint = "a parameter is declared under `parameters:`, a coordinate " + (
            f"within an expression by `coordinates: [{name}]`" if moves else f"by a motion such as `slide: {name}`")
    elif moves:
        hint += f" Or declare a new coordinate: `coordinates: [{name}]`"
    return f"unknown name '{name}'", hint


def _ambiguous(spec: "Spec", reader: "Reader", expression: "Expression",
               local: "tuple[str, units.Dimension] | None") -> None:
    """`2 N*m` within a larger expression of a scene that has a name m may mean two things."""
    if expression.parts.whole:
        return
    for literal in expression.parts.numbers:
        for unit in _competing(spec, expression, literal, local[:1] if local else ()):
            _two_readings(reader, expression, literal, unit)


def check_whole_literal(spec: "Spec", reader: "Reader", expression: "Expression") -> None:
    """A value `36 km/h` is a speed; of a scene with a time h, and wherever the name fits as well, it may mean two
    things, as `2 kg*g` does. (`800 N/m` of a scene with a mass m has one meaning.)"""
    literal = expression.parts.whole
    for unit in _competing(spec, expression, literal) if literal else ():
        others = [units.UNITS[other.unit].dimension for other in literal.units
                  if other is not unit and other.power == unit.power]
        measured = units.UNITS[unit.unit].dimension
        if spec.dimensions.of(unit.unit) == measured or (measured and measured in others):
            _two_readings(reader, expression, literal, unit)


def _competing(spec: "Spec", expression: "Expression", literal: "Number",
               local: tuple[str, ...] = ()) -> "list[UnitPower]":
    """The units of a literal, joined by an operator, that are names of the scene as well; none of one in brackets."""
    before, after = expression.text[:literal.start].rstrip(), expression.text[literal.end:].lstrip()
    if before.endswith("(") and after.startswith(")"):
        return []
    names = (spec.parameters, spec.coordinates, local)
    return [unit for unit in literal.units[1:] if any(unit.unit in some for some in names)]


def _two_readings(reader: "Reader", expression: "Expression", literal: "Number", unit: "UnitPower") -> None:
    name, _, start, end = unit
    text = expression.text
    head, joined = text[literal.start:start].rstrip(" *·/"), text[literal.start:literal.end].rstrip()
    sign = "/" if "/" in text[literal.start + len(head):start] else "*"
    reader.report(expression.scalar.place(start, end - start), f"'{name}' is a unit and a name of this scene",
                  f"write ({joined}) for the unit or ({head}){sign}{name} for the name")
