"""Quantities: can they be asked of a scene, with these indices, signals, instants, inputs and frequencies?"""


from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.spelling import nearest
from vibcli.language.dimension_check import applied
from vibcli.language.signals import coordinate_name, near_signals, signal_dimension
from vibcli.quantities.cycle_count import cycles
from vibcli.quantities.quantity import (
    ALL,
    ASKED,
    IN_FREQUENCY,
    OF_VALUES,
    PARTS,
    SEVERAL,
    declared,
    is_choice,
)
from vibcli.reader.quantity_dimensions import RATE, checker, input_dimension, inputs, output_dimension, usage_here
from vibcli.symbolic.cycles import left_over
from vibcli.symbolic.parser import VALUE, ExpressionError
from vibcli.symbolic.semantics import ALL_NUMBERS, literals_in, names_in, quantities_in
from vibcli.symbolic.syntax import NameRef, QuantityRef

MOST_COUNTED = 1000
COMPLEX = ("eigenvalue", "mode")     # quantities that may be complex, beside frequency responses


def can_be_asked(spec, reader, expression, tree, bare=False):
    """Is this a quantity that can be asked of this scene? Reports what is wrong with it. `bare`: a frequency response
    stands without a frequency."""
    head, indices, attribute = tree.head, tree.indices, tree.component
    place = expression.scalar.place(tree.start, tree.end - tree.start)
    if is_choice(spec, tree):
        return True
    asked = declared(tree)
    if asked is None:
        reader.report(place, f"unknown quantity '{head}'", nearest(head, ASKED) or ALL)
        return False
    kinds = (*asked.indices, "equilibrium") if head in SEVERAL and len(indices) > len(asked.indices) else asked.indices
    if len(indices) != len(kinds) and not (head == "J" and len(indices) == 1):
        takes = {0: "no index", 1: "one index", 2: "two indices"}[len(asked.indices)]
        reader.report(place, f"'{head}' takes {takes}, found {len(indices) or 'none'}",
                      f"write {usage_here(spec, head)}")
        return False
    if not arguments_fit(spec, reader, expression, tree, bare):
        return False
    if attribute not in asked.attributes:
        reader.report(place, f"'{head}' has no '.{attribute}'" if attribute else f"'{tree.text}' needs a component",
                      "write " + " or ".join(tree.text.partition(".")[0] + (a and "." + a) for a in asked.attributes))
        return False
    pairs = zip(kinds, indices, strict=False)
    if not all(_index(spec, reader, place, head, kind, index) for kind, index in pairs):
        return False
    bodies = spec.get("bodies") or {}
    lumped = [name for name in indices if name in bodies and not {"at", "from", "parts"} & set(bodies[name].places)]
    if lumped and (head == "centre" or (head == "J" and len(indices) == 2)):
        reader.report(place, f"'{lumped[0]}' has no place", "say where it is drawn with `at: [x, y]`")
        return False
    return True


def _index(spec, reader, place, head, kind, index):
    n = len(spec.coordinates)
    bodies, points = spec.get("bodies") or {}, spec.get("points") or {}
    if kind == "mode":
        good, valid = index.isdecimal() and index.isascii() and 1 <= int(index) <= 2 * n, [str(i + 1) for i in range(n)]
    elif kind == "equilibrium":
        good, valid = index.isdecimal() and index.isascii() and int(index) > 0, ["1", "2", "3"]
    elif kind == "coordinate":
        good, valid = coordinate_name(spec, index) is not None, list(spec.coordinates)
    elif kind == "signal":
        good = coordinate_name(spec, index) is not None or signal_dimension(spec, index) is not None
        valid = near_signals(spec, index)
    elif kind == "output":
        good, valid = output_dimension(spec, index) is not None, near_signals(spec, index)
    elif kind == "input":
        good, valid = input_dimension(spec, index) is not None, inputs(spec)
    elif kind == "number":
        return _of_kind(reader, place, index.isdecimal() and index.isascii() and 0 < int(index) <= MOST_COUNTED,
                        f"a whole number from 1 to {MOST_COUNTED}", index)
    elif kind == "fraction":
        return _of_kind(reader, place, _is_fraction(index), "a fraction between 0 and 1", index)
    elif kind == "parameter":
        good, valid = index in spec.independent_parameters, spec.independent_parameters
        if not good and index in spec.parameters:
            reader.report(place, f"'{index}' is defined by other parameters", nearest(index, valid))
            return False
    elif kind == "damper":
        good, valid = index in (spec.get("dampers") or {}), list(spec.get("dampers") or {})
    elif kind == "body":
        good, valid = index in bodies, list(bodies)
    else:
        good, valid = index in points or index in bodies, [*points, *bodies]
    if not good:
        kind = "coordinate or signal" if kind == "signal" else kind
        reader.report(place, f"this scene has no {kind} {quoted(index)}", nearest(index, valid) or "it has none at all")
    return good


def _of_kind(reader, place, good, wants, index):
    if not good:
        reader.report(place, f"expected {wants} in square brackets, found {quoted(index)}")
    return good


def _is_fraction(text):
    try:
        return 0 < float(text) < 1
    except ValueError:
        return False


def arguments_fit(spec, reader, expression, tree, bare=False):
    """Are the arguments of a quantity what it takes? Reports what is wrong with them. `bare`: see can_be_asked."""
    asked, head, args = declared(tree), tree.head, tree.args
    place = expression.scalar.place(tree.start, tree.end - tree.start)
    if not asked.args and args:
        if ASKED.get(head) is not None and "mode" in asked.indices:
            reader.report(place, f"'{head}' is no function of time: it takes an index alone", f"write {head}[1]")
        else:
            reader.report(place, f"'{head}' takes no argument in round brackets", "leave it out")
        return False
    if asked.optional and not args and not bare:
        reader.report(place, f"'{tree.text}' is a function of frequency", f"write {tree.text}(5 Hz)")
        return False
    if len(args) != len(asked.args) and not bare:
        _miscounted(spec, reader, expression, tree, place)
        return False
    kinds = zip(asked.args, args, strict=False)
    return all(_argument(spec, reader, expression, tree, kind, arg) for kind, arg in kinds)


def check_questions(spec, reader, signals, drivers):
    """Report what is wrong with the signals and inputs of `find`."""
    for expression in signals:
        _signal(spec, reader, expression, QuantityRef(0, 0, "", "", (), "", (expression.tree,)), expression.tree)
    for expression in drivers:
        if not isinstance(expression.tree, NameRef) or input_dimension(spec, expression.text) is None:
            reader.report(expression.where, f"this scene has no input {quoted(expression.text)}",
                          nearest(expression.text, inputs(spec)))


def _miscounted(spec, reader, expression, tree, place):
    if tree.head == VALUE:
        applied(reader, expression, tree)
        return
    reader.report(place, f"'{tree.head}' takes one argument in round brackets, found {len(tree.args) or 'none'}",
                  f"write {usage_here(spec, tree.head)}")


def _argument(spec, reader, expression, tree, kind, arg):
    if kind == "signal" and tree.head == "phase" and isinstance(arg, QuantityRef) and arg.head == "frf":
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
        if part.head not in PARTS:
            reader.report(expression.scalar.place(part.start, part.end - part.start), f"'{part.text}' is no signal",
                          "signals are made of coordinates, points, springs, forces and parameters")
        elif not arguments_fit(spec, reader, expression, part):
            return False
    if len(reader.diagnostics) == before and not any(_moves(spec, name) for name, *_ in _all_names(arg)):
        reader.report(expression.scalar.place(arg.start, arg.end - arg.start), "this does not depend on the motion",
                      "signals are made of coordinates, points, springs and forces")
    if len(reader.diagnostics) > before or _dimension(spec, reader, expression, arg) is False:
        return False
    return _counted(reader, expression, lambda: cycles(spec, expression.text).count(arg))


def _all_names(tree):
    return names_in(tree) + [name for part in quantities_in(tree) for arg in part.args for name in _all_names(arg)]


def _moves(spec, name):
    return name not in spec.parameters and name != "pi"


def _unknown(spec, reader, expression, tree, name, place):
    if name in ASKED and ASKED[name].indices:
        reader.report(place, f"'{name}' needs an index", f"write {usage_here(spec, name)}")
    elif tree.head == VALUE and isinstance(tree.args[0], NameRef):
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
        return checker(spec, expression.text).dimension(tree)
    except ExpressionError as error:
        reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
        return False


def _response(spec, reader, expression, tree, arg):
    """The argument of peak, arg, phase …: frf[x, F] as a function, or its value frf[x, F](5 Hz)."""
    wants_value = tree.head in (*OF_VALUES, "phase")
    example = usage_here(spec, "arg" if tree.head == "phase" else tree.head)
    example = example.replace("arg", "phase") if tree.head == "phase" else example
    place = expression.scalar.place(arg.start, arg.end - arg.start)
    if wants_value and isinstance(arg, QuantityRef) and arg.head in COMPLEX:
        return can_be_asked(spec, reader, expression, arg)
    quantity = isinstance(arg, QuantityRef)
    if wants_value and quantity and declared(arg) is not None and arg.head not in ("frf", *OF_VALUES):
        reader.report(place, f"{quoted(arg.text)} is a real number", f"ask for {arg.text} itself")
        return False
    if not isinstance(arg, QuantityRef) or arg.head not in IN_FREQUENCY or not ASKED[arg.head].optional:
        reader.report(place, "expected a frequency response", f"write {example}")
        return False
    if bool(arg.args) != wants_value:
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
        can_be_asked(spec, reader, expression, part)
    if len(reader.diagnostics) > before:
        return False
    found = _dimension(spec, reader, expression, arg)
    if found is False:
        return False
    wanted, words = (units.TIME, "an instant (s)") if kind == "time" else (RATE, "a frequency (rad/s or Hz)")
    bare = spec.free_numbers == ALL_NUMBERS or (
        spec.free_numbers and not any(part.units for part in literals_in(arg)))
    if found is None or bare or spec.dimensions.equate(found, wanted):
        return _counted(reader, expression, lambda: _counts(cycles(spec, expression.text), kind, arg))
    reader.report(expression.scalar.place(arg.start, arg.end - arg.start),
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
