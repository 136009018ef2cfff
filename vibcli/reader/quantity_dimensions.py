"""The dimensions of quantities, signals and inputs of a scene, and how they are written in its names."""

import re

from vibcli.base import units
from vibcli.language.signals import ENERGIES, coordinate_name, signal_dimension
from vibcli.quantities.quantity import IN_FREQUENCY, OF_SPEED, SIGNAL, declared, dimension, is_choice, usage
from vibcli.symbolic.semantics import DimensionCheck

RATE = units.parse_unit("rad/s").dimension


def asked_dimension(spec, tree):
    if is_choice(spec, tree):
        return spec.dimensions.of(tree.head)
    if (tree.args or tree.head in IN_FREQUENCY) and tree.head not in OF_SPEED:
        return response_dimension(spec, tree)
    indices = [coordinate_name(spec, index) or index for index in tree.indices]

    def of(name):
        known = name in spec.coordinates or name in spec.parameters
        return spec.dimensions.of(name) if known else signal_dimension(spec, name)

    return dimension(tree.head, indices, of)


def output_dimension(spec, text):
    """The dimension of a coordinate or signal, with its primes; None where there is none of that name."""
    name = text.rstrip("'")
    primes = len(text) - len(name)
    found = spec.dimensions.of(name) if name in spec.coordinates else signal_dimension(spec, name)
    if found is None and name in ENERGIES and name not in spec.parameters:
        found = units.parse_unit(ENERGIES[name]).dimension
    return None if found is None or primes > 2 else units.times(found, units.TIME, -primes)


def usage_here(spec, head):
    """How a quantity is written, in names of this scene."""
    named = {"x": spec.coordinates, "signal": spec.coordinates, "coordinate": spec.coordinates, "F": inputs(spec),
             "d": spec.get("dampers") or (), "body": spec.get("bodies") or (), "place": spec.get("bodies") or (),
             "parameter": spec.independent_parameters}
    return re.sub(r"(?<![\w.])[A-Za-z]+(?=[],)])", lambda word: next(iter(named.get(word[0], ())), word[0]),
                  usage(head))


def inputs(spec):
    """The names of what can drive a scene."""
    driven = [name for name, record in (spec.get("points") or {}).items() if "moves" in record]
    return [*(spec.get("forces") or {}), *driven, *spec.coordinates]


def input_dimension(spec, name):
    """The dimension of a unit of an input: of a force, moment, unbalance, displacement or generalised force."""
    record = (spec.get("forces") or {}).get(name)
    if record is not None:
        if "value" in record:
            return _generalised(spec, record["coordinate"].text)
        unit = next(unit for key, unit in (("force", "N"), ("moment", "N*m"), ("unbalance", "kg*m")) if key in record)
        return units.parse_unit(unit).dimension
    if "moves" in (spec.get("points") or {}).get(name, ()):
        return units.LENGTH
    return _generalised(spec, name) if name in spec.coordinates else None


def _generalised(spec, coordinate):
    return units.times(units.parse_unit("J").dimension, spec.dimensions.of(coordinate), -1)


def response_dimension(spec, tree):
    """The dimension of a quantity with arguments; None where something in it is unknown."""
    asked = declared(tree)
    if tree.head in ("frf", "transmissibility"):
        out, driver = output_dimension(spec, tree.indices[0]), input_dimension(spec, tree.indices[1])
        if tree.head == "transmissibility" and out is not None and driver is not None and out == driver:
            return units.NONE
        return None if out is None or driver is None else units.times(out, driver, -1)
    if asked.unit not in (None, SIGNAL) or not tree.args:
        return units.parse_unit(asked.unit).dimension if asked.unit not in (None, SIGNAL) else None
    if tree.head in ("peak", "fixed_point") and tree.component == "Omega":
        return RATE
    return signal_tree_dimension(spec, tree.args[0])


def signal_tree_dimension(spec, tree):
    """The dimension of a signal: an expression of coordinates, signals and parameters; ExpressionError of a misfit."""
    return checker(spec).dimension(tree)


def checker(spec, text=""):
    def of(name, primes):
        found = spec.dimensions.of(name) if name in spec.parameters else output_dimension(spec, name + "'" * primes)
        return units.times(found, units.TIME, 0)

    return DimensionCheck(spec.dimensions, of, spec.free_numbers, lambda part: response_dimension(spec, part), text)
