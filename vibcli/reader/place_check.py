"""Signals of members: are they known, and is their place a length of parameters? Functions of the place x along one."""

from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.spelling import nearest
from vibcli.language.member_signals import mistake
from vibcli.language.sections.initial import PLACE
from vibcli.language.signal_names import signal_name
from vibcli.quantities.dimensions import checker
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import ALL_NUMBERS, DimensionCheck
from vibcli.symbolic.syntax import ExpressionError, parts_of

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.reader import Reader
    from vibcli.language.spec import Spec


def place_fits(spec: "Spec", reader: "Reader", where: "Where", text: str) -> bool:
    """Is a signal of a member one that it has, and its place a length? Then the parameters of this are used; reports
    what is wrong with it. Signals of others fit."""
    signal, before = signal_name(text), len(reader.diagnostics)
    place, found = signal.place, mistake(spec, signal)
    if found is not None:
        reader.report(where, *found)
        return False
    if signal.name not in spec.members:
        return True
    try:
        tree = parse(place)
        for name, primes, *_ in parts_of(tree).names:
            if name in spec.parameters and not primes:
                spec.used.add(name)
            elif name != "pi":
                reader.report(where, f"{quoted(name)} is no parameter: places are lengths of parameters",
                              nearest(name, spec.parameters))
        if parts_of(tree).quantities:
            reader.report(where, f"the place {quoted(place)} is not made of parameters alone",
                          f"write {signal._replace(place='0').text}")
        if len(reader.diagnostics) > before:
            return False
        found = checker(spec, place).dimension(tree)
    except ExpressionError as error:
        reader.report(where, f"the place {quoted(place)} cannot be read: {error.message}", error.hint)
        return False
    bare = spec.free_numbers == ALL_NUMBERS or (spec.free_numbers and not any(part.units for part
                                                                              in parts_of(tree).numbers))
    if found is None or bare or spec.dimensions.equate(found, units.LENGTH):
        return True
    reader.report(where, f"expected a place (m), found {units.name(spec.dimensions.resolve(found))}",
                  "places on a member are lengths from its left end, such as 0.5 m")
    return False


def shape_fits(spec: "Spec", reader: "Reader", where: "Where", text: str) -> bool:
    """Is this a function of the place x and of parameters? Then these are used; reports what is wrong with it."""
    before = len(reader.diagnostics)

    def dimension(name: str, primes: int) -> "units.Dimension":
        return units.LENGTH if name == PLACE else spec.dimensions.of(name)

    try:
        tree = parse(text)
        names = parts_of(tree).names
        for name, primes, *_ in names:
            if name in spec.parameters and not primes:
                spec.used.add(name)
            elif name not in (PLACE, "pi") or primes:
                reader.report(where, f"{quoted(name + primes * chr(39))} is no parameter: deflections are functions of "
                              "the place x and of parameters", nearest(name, spec.parameters) or "write rayleigh[x^2]")
        if parts_of(tree).quantities:
            reader.report(where, f"the deflection {quoted(text)} is not made of x and parameters alone",
                          "write rayleigh[x^2]")
        if len(reader.diagnostics) > before:
            return False
        DimensionCheck(spec.dimensions, dimension, spec.free_numbers, text=text).dimension(tree)
    except ExpressionError as error:
        reader.report(where, f"the deflection {quoted(text)} cannot be read: {error.message}", error.hint)
        return False
    return True
