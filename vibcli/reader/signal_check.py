"""Quantities of responses: are their signals, instants, inputs and frequencies such that they can be asked for?"""

import re

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.language.dimension_check import applied
from vibcli.language.parameters import independent
from vibcli.language.reader import nearest
from vibcli.language.signals import ENERGIES, near_signals, signal_dimension
from vibcli.quantities.quantity import ASKED, IN_FREQUENCY, OF_VALUES, PARTS, SIGNAL, declared, usage
from vibcli.reader.cycle_check import cycles
from vibcli.symbolic.cycles import left_over
from vibcli.symbolic.parser import VALUE, ExpressionError
from vibcli.symbolic.semantics import ALL_NUMBERS, DimensionCheck, literals_in, names_in, quantities_in

COMPLEX = ("eigenvalue", "mode")     # quantities that may be complex, beside frequency responses
RATE = units.parse_unit("rad/s").dimension


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
             "parameter": independent(spec.parameters)}
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
    if tree[4] in ("frf", "transmissibility"):
        out, driver = output_dimension(spec, tree[5][0]), input_dimension(spec, tree[5][1])
        if tree[4] == "transmissibility" and out is not None and driver is not None and out == driver:
            return units.NONE
        return None if out is None or driver is None else units.times(out, driver, -1)
    if asked.unit not in (None, SIGNAL) or not tree[7]:
        return units.parse_unit(asked.unit).dimension if asked.unit not in (None, SIGNAL) else None
    if tree[4] in ("peak", "fixed_point") and tree[6] == "Omega":
        return RATE
    return signal_tree_dimension(spec, tree[7][0])


def signal_tree_dimension(spec, tree):
    """The dimension of a signal: an expression of coordinates, signals and parameters; ExpressionError of a misfit."""
    return _checker(spec).dimension(tree)


def _checker(spec, text=""):
    def of(name, primes):
        found = spec.dimensions.of(name) if name in spec.parameters else output_dimension(spec, name + "'" * primes)
        return units.times(found, units.TIME, 0)

    return DimensionCheck(spec.dimensions, of, spec.free_numbers, lambda part: response_dimension(spec, part), text)


def arguments_fit(spec, reader, expression, tree, bare=False):
    """Are the arguments of a quantity what it takes? Reports what is wrong with them. `bare`: see can_be_asked."""
    asked, head, args = declared(tree), tree[4], tree[7]
    place = expression.scalar.place(tree[1], tree[2] - tree[1])
    if not asked.args and args:
        if ASKED.get(head) is not None and "mode" in asked.indices:
            reader.report(place, f"'{head}' is no function of time: it takes an index alone", f"write {head}[1]")
        else:
            reader.report(place, f"'{head}' takes no argument in round brackets", "leave it out")
        return False
    if asked.optional and not args and not bare:
        reader.report(place, f"'{tree[3]}' is a function of frequency", f"write {tree[3]}(5 Hz)")
        return False
    if len(args) != len(asked.args) and not bare:
        _miscounted(spec, reader, expression, tree, place)
        return False
    kinds = zip(asked.args, args, strict=False)
    return all(_argument(spec, reader, expression, tree, kind, arg) for kind, arg in kinds)


def check_questions(spec, reader, signals, drivers):
    """Report what is wrong with the signals and inputs of `find`."""
    for expression in signals:
        _signal(spec, reader, expression, (None, 0, 0, "", "", (), "", (expression.tree,)), expression.tree)
    for expression in drivers:
        if expression.tree[0] != "name" or input_dimension(spec, expression.text) is None:
            reader.report(expression.where, f"this scene has no input {quoted(expression.text)}",
                          nearest(expression.text, inputs(spec)))


def _miscounted(spec, reader, expression, tree, place):
    if tree[4] == VALUE:
        applied(reader, expression, tree)
        return
    reader.report(place, f"'{tree[4]}' takes one argument in round brackets, found {len(tree[7]) or 'none'}",
                  f"write {usage_here(spec, tree[4])}")


def _argument(spec, reader, expression, tree, kind, arg):
    if kind == "signal" and tree[4] == "phase" and arg[0] == "quantity" and arg[4] == "frf":
        kind = "frf"
    if kind == "signal":
        return _signal(spec, reader, expression, tree, arg)
    if kind == "frf":
        return _response(spec, reader, expression, tree, arg)
    return _number(spec, reader, expression, kind, arg)


def _signal(spec, reader, expression, tree, arg):
    """A signal: names of coordinates and signals with at most two primes, and parameters."""
    before = len(reader.diagnostics)
    for name, primes, start, end in names_in(arg):
        place = expression.scalar.place(start, end - start)
        if name in spec.parameters and not primes:
            spec.used.add(name)
        elif name != "pi" and output_dimension(spec, name + "'" * primes) is None:
            _unknown(spec, reader, expression, tree, name, place)
    for part in quantities_in(arg):
        if part[4] not in PARTS:
            reader.report(expression.scalar.place(part[1], part[2] - part[1]), f"'{part[3]}' is no signal",
                          "signals are made of coordinates, points, springs, forces and parameters")
        elif not arguments_fit(spec, reader, expression, part):
            return False
    if len(reader.diagnostics) == before and not any(_moves(spec, name) for name, *_ in _all_names(arg)):
        reader.report(expression.scalar.place(arg[1], arg[2] - arg[1]), "this does not depend on the motion",
                      "signals are made of coordinates, points, springs and forces")
    if len(reader.diagnostics) > before or _dimension(spec, reader, expression, arg) is False:
        return False
    return _counted(reader, expression, lambda: cycles(spec, expression.text).count(arg))


def _all_names(tree):
    return names_in(tree) + [name for part in quantities_in(tree) for arg in part[7] for name in _all_names(arg)]


def _moves(spec, name):
    return name not in spec.parameters and name != "pi"


def _unknown(spec, reader, expression, tree, name, place):
    if name in ASKED and ASKED[name].indices:
        reader.report(place, f"'{name}' needs an index", f"write {usage_here(spec, name)}")
    elif tree[4] == VALUE and tree[7][0][0] == "name":
        asked = (*ASKED, *spec.coordinates)
        reader.report(place, f"unknown quantity or signal {quoted(name)}", _hint(spec, name, asked))
    else:
        reader.report(place, f"this scene has no coordinate or signal {quoted(name)}",
                      _hint(spec, name, near_signals(spec, name)))


def _hint(spec, name, words):
    return nearest(name, near_signals(spec, name) if "." in name else words)


def _dimension(spec, reader, expression, tree):
    """The dimension of a tree; False and a report where its parts do not fit."""
    try:
        return _checker(spec, expression.text).dimension(tree)
    except ExpressionError as error:
        reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
        return False


def _response(spec, reader, expression, tree, arg):
    """The argument of peak, arg, phase …: frf[x, F] as a function, or its value frf[x, F](5 Hz)."""
    from vibcli.reader.quantity_check import can_be_asked

    wants_value = tree[4] in (*OF_VALUES, "phase")
    example = usage_here(spec, "arg" if tree[4] == "phase" else tree[4])
    example = example.replace("arg", "phase") if tree[4] == "phase" else example
    place = expression.scalar.place(arg[1], arg[2] - arg[1])
    if wants_value and arg[0] == "quantity" and arg[4] in COMPLEX:
        return can_be_asked(spec, reader, expression, arg)
    if wants_value and arg[0] == "quantity" and declared(arg) is not None and arg[4] not in ("frf", *OF_VALUES):
        reader.report(place, f"{quoted(arg[3])} is a real number", f"ask for {arg[3]} itself")
        return False
    if arg[0] != "quantity" or arg[4] not in IN_FREQUENCY or not ASKED[arg[4]].optional:
        reader.report(place, "expected a frequency response", f"write {example}")
        return False
    if bool(arg[7]) != wants_value:
        what = "its value at a frequency" if wants_value else "the response without a frequency"
        reader.report(place, f"expected {what}", f"write {example}")
        return False
    return can_be_asked(spec, reader, expression, arg, bare=not wants_value)


def _number(spec, reader, expression, kind, arg):
    """An instant, or a frequency in rad/s or Hz."""
    before = len(reader.diagnostics)
    for name, primes, start, end in names_in(arg):
        if name in spec.parameters and not primes:
            spec.used.add(name)
        elif name != "pi":
            reader.report(expression.scalar.place(start, end - start), f"'{name}' is no parameter",
                          nearest(name, spec.parameters))
    for part in quantities_in(arg):
        from vibcli.reader.quantity_check import can_be_asked

        can_be_asked(spec, reader, expression, part)
    if len(reader.diagnostics) > before:
        return False
    found = _dimension(spec, reader, expression, arg)
    if found is False:
        return False
    wanted, words = (units.TIME, "an instant (s)") if kind == "time" else (RATE, "a frequency (rad/s or Hz)")
    bare = spec.free_numbers == ALL_NUMBERS or (
        spec.free_numbers and not any(part[4] for part in literals_in(arg)))
    if found is None or bare or spec.dimensions.equate(found, wanted):
        return _counted(reader, expression, lambda: _counts(cycles(spec, expression.text), kind, arg))
    reader.report(expression.scalar.place(arg[1], arg[2] - arg[1]),
                  f"expected {words}, found {units.name(spec.dimensions.resolve(found))}",
                  "write for example 2.5 s" if kind == "time" else "write for example 20 rad/s or 5 Hz")
    return False


def _counts(counter, kind, arg):
    """An instant is no number of cycles, and a frequency one in rad/s or Hz."""
    if kind == "time" or left_over(counter.count(arg)) not in (0, 1):
        counter.require_radians(arg)


def _counted(reader, expression, count):
    """Can the cycles be counted? Reports where they stand for radians."""
    try:
        count()
    except ExpressionError as error:
        reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
        return False
    return True
