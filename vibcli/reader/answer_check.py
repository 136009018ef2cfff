"""Expected answers: does each name a quantity that can be asked of this scene, in the dimension it has?"""

from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.language.dimension_check import check
from vibcli.language.reader import Expression, Reader
from vibcli.quantities import FAMILIES
from vibcli.quantities.dimensions import asked_dimension, dimension_of
from vibcli.quantities.index_kinds import INDICES
from vibcli.quantities.quantity import OF_STATE, TRUTH, is_bare, kind_of, named, quantity_of, usage
from vibcli.reader.cycles_used import is_number_without_cycles
from vibcli.reader.quantity_check import can_be_asked
from vibcli.reader.sections.answer import Answer
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.symbolic.syntax import SyntaxTree


def check_question(spec: "Spec", reader: Reader, asked: Expression) -> Expression:
    """A quantity, or an expression of some, that is asked without an expected value; reports what is wrong with it."""
    from vibcli.reader.cycle_check import check_terms

    asked = as_quantity(spec, asked)
    if is_asked(spec, reader, asked) and check(spec, reader, asked, spec.parameters, None):
        check_terms(spec, reader, asked)
    return asked


def _is_parameter(spec: "Spec", name: str) -> bool:
    """Is a name that can be asked for, such as T, that of a chosen parameter or of one that measures something else?"""
    measured = spec.dimensions.of(name) if name in spec.parameters else None
    return name in spec.choices or (measured is not None and measured != units.parse_unit(named(name).unit).dimension)


def as_quantity(spec: "Spec", expression: Expression) -> Expression:
    """The quantity that is written as a name alone, such as rayleigh or T; other expressions as they are."""
    tree = expression.tree
    if isinstance(tree, NameRef) and not tree.primes and is_bare(tree.name) and not _is_parameter(spec, tree.name):
        return Expression(expression.scalar, QuantityRef(tree.start, tree.end, tree.name, tree.name))
    return expression


def in_unit_asked(spec: "Spec", expected: Expression, tree: "SyntaxTree") -> Expression:
    """An expected value in the unit of the quantity that is asked, if it has one of its own."""
    quantity = quantity_of(spec, tree)
    return Expression(expected.scalar, expected.tree, None if quantity is None else quantity.own_unit)


def is_asked(spec: "Spec", reader: Reader, asked: Expression) -> bool:
    """Is this a quantity, or an expression of some, that can be asked of the scene? Reports what is wrong with it."""
    if not all(can_be_asked(spec, reader, asked, quantity) for quantity in asked.parts.quantities):
        return False
    names = {name for name, *_ in asked.parts.names} - {"pi"}
    of_parameters = names & set(spec.choices) or (names and names <= set(spec.parameters))
    if not asked.parts.quantities and not of_parameters:
        if asked.text in FAMILIES:
            needs = "an index" if named(asked.text).indices else "a signal"
            reader.report(asked.where, f"{quoted(asked.text)} needs {needs}", f"write {usage(asked.text, spec)}")
        elif isinstance(asked.tree, NameRef) and INDICES["output"].fits(spec, asked.tree.name):
            reader.report(asked.where, f"{quoted(asked.text)} is a function of time",
                          f"ask for its value as in {asked.text}(2 s), or for max({asked.text})")
        else:
            from vibcli.reader.quantity_spelling import quantity_meant

            reader.report(asked.where, f"{quoted(asked.text)} is not a quantity", quantity_meant(asked.text))
        return False
    return True


def checked(spec: "Spec", reader: Reader, answer: Answer) -> Answer:
    """The finished Answer, a name alone being the quantity that it means; reports what cannot be asked, and an expected
    value that has not its dimension."""
    asked, expected = as_quantity(spec, answer.asked), answer.expected
    found = Answer(asked, in_unit_asked(spec, expected, asked.tree), answer.rtol)
    if is_asked(spec, reader, asked):
        _expected(spec, reader, found)
    return found


def _expected(spec: "Spec", reader: Reader, answer: Answer) -> None:
    """Report what is wrong with an expected value."""
    asked, expected = answer.asked, answer.expected
    tree = asked.tree
    kind = kind_of(spec, tree)
    if kind == TRUTH:
        if expected.text not in ("true", "false"):
            reader.report(expected.where, f"expected true or false, found {quoted(expected.text)}",
                          f"write {tree.text}: true")
        return
    for part in (expected, answer.rtol) if answer.rtol is not None else (expected,):
        if not all(can_be_asked(spec, reader, part, other) for other in part.parts.quantities):
            return
    if kind in OF_STATE and expected.parts.quantities:
        other = expected.parts.quantities[0]
        reader.report(expected.scalar.place(other.start, other.end - other.start),
                      f"'{other.text}' cannot stand in an expected '{tree.head}'",
                      "write it in parameters and coordinates")
        return
    names = spec.parameters if kind not in OF_STATE else (*spec.parameters, *spec.coordinates, "t")
    fits = check(spec, reader, asked, spec.parameters, None)
    dimension_asked = asked_dimension(spec, tree) if isinstance(tree, QuantityRef) else dimension_of(spec, asked)
    if check(spec, reader, expected, names, dimension_asked) and fits:
        check_cycles(spec, reader, asked, expected)
    if answer.rtol is not None:
        check(spec, reader, answer.rtol, spec.parameters, units.NONE)


def check_cycles(spec: "Spec", reader: Reader, asked: Expression, expected: Expression) -> None:
    """Hz is not rad/s: an angular frequency refuses it, and a frequency the other; all else counts no cycles."""
    tree = asked.tree
    quantity = quantity_of(spec, tree)
    asks_frequency = quantity is not None and quantity.unit == "Hz"
    if quantity is not None and not asks_frequency and is_number_without_cycles(expected):
        return
    from vibcli.reader.cycle_check import check_radians, check_same, check_terms, is_frequency
    from vibcli.symbolic.cycles import left_over

    count = check_terms(spec, reader, expected)
    if count is None or check_terms(spec, reader, asked) is None:
        return
    if asks_frequency and not is_frequency(spec, expected):
        reader.report(expected.where, f"expected a frequency (Hz) for '{tree.head}', found an angular frequency",
                      "divide by 2*pi, or ask for omega[i]")
    elif quantity is not None and quantity.is_rate and left_over(count) == 1:
        reader.report(expected.where, f"expected an angular frequency (rad/s) for '{tree.head}', found Hz",
                      "write 2*pi*f, or ask for frequency[i]")
    elif quantity is None:
        check_same(spec, reader, asked, expected)
    elif not asks_frequency:
        check_radians(spec, reader, expected)
