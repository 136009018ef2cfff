"""Quantities: can they be asked of a scene, with these indices, signals, instants, inputs and frequencies?"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.spelling import near, nearest
from vibcli.language.dimension_check import applied
from vibcli.quantities import FAMILIES
from vibcli.quantities.dimensions import checker
from vibcli.quantities.index_kinds import INDICES
from vibcli.quantities.quantity import COMPLEX, OF_SIGNAL, about_which, declared, is_choice, named, usage, usage_of
from vibcli.symbolic.parser import VALUE
from vibcli.symbolic.semantics import ALL_NUMBERS
from vibcli.symbolic.syntax import ExpressionError, NameRef, QuantityRef, names_within, parts_of

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.reader import Expression, Reader
    from vibcli.language.spec import Spec
    from vibcli.quantities.quantity import Declaration
    from vibcli.symbolic.syntax import SyntaxTree

OF_ELEMENTS = ("law", "mass", "centre", "J")       # quantities of what not every element has


def can_be_asked(spec: "Spec", reader: "Reader", expression: "Expression", tree: QuantityRef,
                 bare: bool = False) -> bool:
    """Is this a quantity that can be asked of this scene? Reports what is wrong with it. `bare`: a frequency response
    stands without a frequency."""
    head, indices, component = tree.head, tree.indices, tree.component
    place = expression.scalar.place(tree.start, tree.end - tree.start)
    if is_choice(spec, tree):
        return True
    quantity = declared(tree)
    if quantity is None:
        from vibcli.reader.quantity_spelling import quantity_meant

        reader.report(place, f"unknown quantity '{head}'", quantity_meant(head))
        return False
    own, number = about_which(tree)
    if not _as_many_indices(spec, reader, place, tree, (quantity, len(own.indices))):
        return False
    kinds = quantity.indices[:len(own.indices)] + ("equilibrium",) * (number is not None)
    if not arguments_fit(spec, reader, expression, tree, bare):
        return False
    if quantity.kind == OF_SIGNAL:
        reader.report(place, f"'{tree.text}' is a function of time",
                      f"ask for its value as in {tree.text}(2 s), or for max({tree.text})")
        return False
    if component not in quantity.components:
        reader.report(place, f"'{head}' has no '.{component}'" if component else f"'{tree.text}' needs a component",
                      "write " + " or ".join(tree.text.removesuffix(f".{component}") + (word and "." + word)
                                             for word in quantity.components))
        return False
    if not all(_index(spec, reader, place, kind, index) for kind, index in zip(kinds, indices, strict=True)):
        return False
    if head in OF_ELEMENTS:
        from vibcli.reader.element_check import has_what_is_asked

        return has_what_is_asked(spec, reader, place, tree)
    return True


def _as_many_indices(spec: "Spec", reader: "Reader", place: "Where", tree: QuantityRef,
                     found: "tuple[Declaration, int]") -> bool:
    """Has it as many as its Declaration takes? found: that, and how many are its own."""
    (quantity, count), most = found, len(found[0].indices)
    if most - quantity.spare <= count <= most:
        return True
    words = "no index", "one index", "two indices", "three indices"
    takes = " or ".join(words[most - quantity.spare:most + 1])
    beyond = quantity.several and len(tree.indices) == most + 1
    reader.report(place, f"'{tree.head}' takes {takes}, found {len(tree.indices) or 'none'}", "write "
                  + usage_of(tree.head, quantity, spec) + "[2] for the second equilibrium" * beyond)
    return False


def _index(spec: "Spec", reader: "Reader", place: "Where", kind: str, index: str) -> bool:
    if kind == "shape":
        from vibcli.reader.place_check import shape_fits

        return shape_fits(spec, reader, place, index)
    kind = INDICES[kind]
    good: bool = kind.fits(spec, index)
    if spec.members and kind.of_signals and not _is_placed(spec, reader, place, index):
        return False
    if not good and kind.wants:
        reader.report(place, f"expected {kind.wants} in square brackets, found {quoted(index)}")
    elif not good:
        hint = nearest(index, kind.names(spec, index))
        defined = kind is INDICES["parameter"] and index in spec.parameters
        reader.report(place, *(f"'{index}' is defined by other parameters", hint) if defined else (
            f"this scene has no {kind.noun} {quoted(index)}", hint or "it has none at all"))
    return good


def _is_placed(spec: "Spec", reader: "Reader", place: "Where", text: str) -> bool:
    """Is a signal of a member one that it has, at a place that can be? Reports what is wrong with it."""
    from vibcli.reader.place_check import place_fits

    return place_fits(spec, reader, place, text)


def arguments_fit(spec: "Spec", reader: "Reader", expression: "Expression", tree: QuantityRef,
                  bare: bool = False) -> bool:
    """Are the arguments of a quantity what it takes? Reports what is wrong with them. `bare`: see can_be_asked."""
    quantity, head, args = declared(tree), tree.head, tree.args
    place = expression.scalar.place(tree.start, tree.end - tree.start)
    if not quantity.args and args:
        if "mode" in quantity.indices:
            reader.report(place, f"'{head}' is no function of time: it takes an index alone", f"write {head}[1]")
        else:
            reader.report(place, f"'{head}' takes no argument in round brackets", "leave it out")
        return False
    if quantity.optional and not args and not bare:
        reader.report(place, f"'{tree.text}' is a function of frequency", f"write {tree.text}(5 Hz)")
        return False
    if len(args) != len(quantity.args) and not bare:
        name = tree.args[0].name if head == VALUE and isinstance(tree.args[0], NameRef) else None
        if name in FAMILIES and named(name).indices:
            reader.report(place, f"'{name}' needs an index", f"write {usage(name, spec)}")
        elif head == VALUE:
            applied(reader, expression, tree)
        else:
            wanted = {1: "one argument in round brackets", 2: "a signal and a number, each in round brackets"}
            reader.report(place, f"'{head}' takes {wanted[len(quantity.args)]}, found {len(args) or 'none'}",
                          f"write {usage_of(head, quantity, spec)}")
        return False
    kinds = zip(quantity.args, args, strict=False)
    return all(_argument(spec, reader, expression, tree, kind, arg) for kind, arg in kinds)


def check_questions(spec: "Spec", reader: "Reader", signals: "Sequence[Expression]", drivers: "Sequence[Expression]",
                    amplitudes: "Sequence[tuple[Expression | None, Expression]]" = ()) -> None:
    """Report what is wrong with the signals and inputs of `find`, and with amplitudes of signals."""
    before = len(reader.diagnostics)
    for expression in signals:
        _signal(spec, reader, expression, QuantityRef(0, 0, "", "", (), "", (expression.tree,)), expression.tree)
    for expression in drivers:
        from vibcli.quantities.signal_dimensions import input_dimension, inputs

        if not isinstance(expression.tree, NameRef) or input_dimension(spec, expression.text) is None:
            reader.report(expression.where, f"this scene has no input {quoted(expression.text)}",
                          nearest(expression.text, inputs(spec)))
    if (signals or amplitudes) and len(reader.diagnostics) == before:
        from vibcli.reader.division_check import check_divisions

        check_divisions(reader, (*signals, *(largest for _, largest in amplitudes)))
    for signal, largest in amplitudes if spec.coordinates and len(reader.diagnostics) == before else ():
        tree = NameRef(0, 0, next(iter(spec.coordinates)), 0) if signal is None else signal.tree
        _number(spec, reader, largest, "amplitude", largest.tree, QuantityRef(0, 0, "", "", (), "", (tree,)))


def _argument(spec: "Spec", reader: "Reader", expression: "Expression", tree: QuantityRef, kind: str,
              arg: "SyntaxTree") -> bool:
    if kind == "signal":
        return _signal(spec, reader, expression, tree, arg)
    if kind in ("response", "complex"):
        return _response(spec, reader, expression, tree, arg, wants_value=kind == "complex")
    return _number(spec, reader, expression, kind, arg, tree)


def _signal(spec: "Spec", reader: "Reader", expression: "Expression", tree: QuantityRef, arg: "SyntaxTree") -> bool:
    """A signal: names of coordinates and signals with at most two primes, and parameters."""
    from vibcli.quantities.signal_dimensions import output_dimension

    before = len(reader.diagnostics)
    for name, primes, start, end in parts_of(arg).names:
        place = expression.scalar.place(start, end - start)
        if name in spec.parameters and not primes:
            spec.used.add(name)
        elif name != "pi" and output_dimension(spec, name + "'" * primes) is None:
            _unknown(spec, reader, tree, name, place)
        elif spec.members:
            _is_placed(spec, reader, place, name)
    for part in parts_of(arg).quantities:
        quantity = declared(part)
        if quantity is None or quantity.kind != OF_SIGNAL:
            reader.report(expression.scalar.place(part.start, part.end - part.start), f"'{part.text}' is no signal",
                          f"write {part.text[:-3]}" if part.text.endswith("(t)") else
                          "signals are made of coordinates, points, springs, forces and parameters")
        elif not arguments_fit(spec, reader, expression, part):
            return False
    if len(reader.diagnostics) == before and {*spec.parameters, "pi"}.issuperset(names_within(arg)):
        reader.report(expression.scalar.place(arg.start, arg.end - arg.start), "this does not depend on the motion",
                      "signals are made of coordinates, points, springs and forces")
    if len(reader.diagnostics) > before or _dimension(spec, reader, expression, arg) is False:
        return False
    return _counted(spec, reader, expression, "signal", arg)


def _unknown(spec: "Spec", reader: "Reader", tree: QuantityRef, name: str, place: "Where") -> None:
    from vibcli.language.signals import signal_meant

    if spec.members and not _is_placed(spec, reader, place, name):
        return
    if name in FAMILIES and named(name).indices:
        reader.report(place, f"'{name}' needs an index", f"write {usage(name, spec)}")
    elif tree.head == VALUE and isinstance(tree.args[0], NameRef):
        from vibcli.reader.quantity_spelling import quantity_meant
        from vibcli.symbolic.function_names import function_meant

        hint = None if near(name, spec.coordinates) else function_meant(name)
        reader.report(place, f"unknown quantity or signal {quoted(name)}",
                      hint or signal_meant(spec, name, quantity_meant(name, None)))
    else:
        reader.report(place, f"this scene has no coordinate or signal {quoted(name)}", signal_meant(spec, name))


def _dimension(spec: "Spec", reader: "Reader", expression: "Expression",
               tree: "SyntaxTree") -> "units.Dimension | Literal[False] | None":
    """The dimension of a tree; False and a report where its parts do not fit."""
    try:
        return checker(spec, expression.text).dimension(tree)
    except ExpressionError as error:
        reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
        return False


def _response(spec: "Spec", reader: "Reader", expression: "Expression", tree: QuantityRef, arg: "SyntaxTree",
              wants_value: bool) -> bool:
    """The argument of peak, arg, phase …: frf[x, F] as a function, or its value frf[x, F](5 Hz)."""
    place = expression.scalar.place(arg.start, arg.end - arg.start)
    problem = "expected a frequency response"
    if isinstance(arg, QuantityRef) and (found := declared(arg)) is not None:
        if wants_value and found.kind == COMPLEX and not (found.args and found.optional):
            return can_be_asked(spec, reader, expression, arg)
        if wants_value and found.kind != COMPLEX:
            reader.report(place, f"{quoted(arg.text)} is a real number", f"ask for {arg.text} itself")
            return False
        if found.optional and bool(arg.args) == wants_value:
            return can_be_asked(spec, reader, expression, arg, bare=not wants_value)
        if found.optional:
            problem = f"expected {'its value at a frequency' if wants_value else 'the response without a frequency'}"
    reader.report(place, problem, f"write {usage_of(tree.head, declared(tree), spec)}")
    return False


def _number(spec: "Spec", reader: "Reader", expression: "Expression", kind: str, arg: "SyntaxTree",
            tree: QuantityRef) -> bool:
    """An instant, a frequency in rad/s or Hz, or an amplitude of the signal before it."""
    before = len(reader.diagnostics)
    for name, primes, start, end in parts_of(arg).names:
        if name in spec.parameters and not primes:
            spec.used.add(name)
        elif name != "pi":
            reader.report(expression.scalar.place(start, end - start), f"'{name}' is no parameter",
                          nearest(name, spec.parameters))
    for part in parts_of(arg).quantities:
        can_be_asked(spec, reader, expression, part)
    if len(reader.diagnostics) > before or (found := _dimension(spec, reader, expression, arg)) is False:
        return False
    wanted, words, example = _wanted(spec, reader, expression, kind, tree)
    bare = spec.free_numbers == ALL_NUMBERS or (
        spec.free_numbers and not any(part.units for part in parts_of(arg).numbers))
    if None in (found, wanted) or bare or spec.dimensions.equate(found, wanted):
        return _counted(spec, reader, expression, kind, arg)
    reader.report(expression.scalar.place(arg.start, arg.end - arg.start),
                  f"expected {words}, found {units.name(spec.dimensions.resolve(found))}",
                  f"write for example {example}")
    return False


def _wanted(spec: "Spec", reader: "Reader", expression: "Expression", kind: str,
            tree: QuantityRef) -> "tuple[units.Dimension | None, str, str]":
    """(dimension, what it is called, an example) of an argument that is a number."""
    if kind == "time":
        return units.TIME, "an instant (s)", "2.5 s"
    if kind == "Omega":
        return units.RATE, "a frequency (rad/s or Hz)", "20 rad/s or 5 Hz"
    if kind == "deflection":
        from vibcli.quantities.signal_dimensions import deflection_dimension
        from vibcli.reader.element_check import law_letter

        rate, found = law_letter(spec, tree.indices[0]) == "v", deflection_dimension(spec, tree.indices[0])
        unit = ("m" if found in (units.LENGTH, units.SPEED) else "rad") + "/s" * rate
        return found, f"a {'rate of ' * rate}deflection ({unit})", f"0.1 {unit}"
    measured = _dimension(spec, reader, expression, tree.args[0])
    found = None if measured is False else measured
    name = "" if found is None else f", {units.name(spec.dimensions.resolve(found))}"
    return found, f"an amplitude of the signal before it{name}", "10 cm of a length"


def _counted(spec: "Spec", reader: "Reader", expression: "Expression", kind: str, arg: "SyntaxTree") -> bool:
    """Can the cycles be counted? An instant is no number of cycles, and a frequency one in rad/s or Hz. Reports where
    they stand for radians."""
    from vibcli.quantities.cycle_count import cycles
    from vibcli.symbolic.cycles import left_over

    try:
        counter = cycles(spec, expression.text)
        count = counter.count(arg)
        if kind in ("time", "deflection") or (kind not in ("signal", "amplitude") and left_over(count) not in (0, 1)):
            counter.require_radians(arg)
    except ExpressionError as error:
        reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
        return False
    return True
