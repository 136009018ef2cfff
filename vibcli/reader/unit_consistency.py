"""A scene with units throughout, in letters alone, or in consistent SI numbers without any unit."""

from contextlib import suppress

from vibcli.language.dimension_check import UNIT_DUE
from vibcli.language.reader import TooManyErrors
from vibcli.reader.names import settle
from vibcli.symbolic.semantics import ALL_NUMBERS, literals_in, whole_literal


def resolve(spec, reader):
    """Settle the names and dimensions of `spec`; whatever does not fit goes to reader.diagnostics.

    A scene that uses no unit is taken in consistent SI numbers. Its dimensions are those of its letters, small whole
    numbers being factors, where all fits so; else, if it has data in numbers, everything fits: 2·d³ may be a force."""
    before = len(reader.diagnostics)
    spec.free_numbers = _uses_no_units(spec, reader)
    if not (spec.free_numbers and _has_numbers(spec, reader)):
        settle(spec, reader)
        if not spec.free_numbers:
            _name_culprits(spec, reader)
        return
    with suppress(TooManyErrors):
        settle(spec, reader)
    if len(reader.diagnostics) > before:
        del reader.diagnostics[before:]
        spec.free_numbers = ALL_NUMBERS
        settle(spec, reader)


def _has_numbers(spec, reader):
    """Are there numbers in parameters, or in fields that have a dimension?"""
    values = {id(record.get("value")) for record in spec.parameters.values()}
    given = [expression for expression in reader.expressions if expression.dimension or id(expression) in values]
    literals = [whole_literal(expression.tree) for expression in given]
    return any(literal and literal.value for literal in literals)


def _uses_no_units(spec, reader):
    return not any(part.units for e in reader.expressions for part in literals_in(e.tree)) and not any(
        "unit" in p for p in (*spec.parameters.values(), *(spec.get("records") or {}).values()))


def _name_culprits(spec, reader):
    """Where plain numbers lack their units, and fewer values have one than lack it: say which these are."""
    bare = sum((d.hint or "").startswith((UNIT_DUE, "give '")) for d in reader.diagnostics)
    measured = [(expression, part) for expression in reader.expressions for part in literals_in(expression.tree)
                if part.units]
    if measured and bare > len(measured):
        expression, part = measured[0]
        more = f", like {len(measured) - 1} more" if len(measured) > 1 else ""
        reader.report(expression.scalar.place(part.start, part.end - part.start), f"this value has a unit{more}, so "
                      "all numbers of the scene need theirs",
                      "without any unit a scene is taken in consistent SI numbers")
