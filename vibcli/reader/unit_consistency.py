"""A scene with units throughout, in letters alone, or in consistent SI numbers without any unit."""

from contextlib import suppress
from typing import TYPE_CHECKING

from vibcli.language.dimension_check import UNIT_DUE
from vibcli.language.reader import Reader, TooManyErrors
from vibcli.reader.names import settle
from vibcli.symbolic.semantics import ALL_NUMBERS

if TYPE_CHECKING:
    from vibcli.language.spec import Spec


def resolve(spec: "Spec", reader: Reader, any_dimension: bool = False) -> "Spec":
    """`spec` with its names and dimensions settled; whatever does not fit goes to reader.diagnostics. A scene that uses
    no unit is taken in consistent SI numbers. Its dimensions are those of its letters, small whole numbers being
    factors, where all fits so; else, if it has data in numbers, everything fits: 2·d³ may be a force, as it does with
    any_dimension."""
    if any_dimension:
        return settle(spec._replace(free_numbers=ALL_NUMBERS), reader)
    before = len(reader.diagnostics)
    spec = spec._replace(free_numbers=_uses_no_units(spec, reader))
    if not (spec.free_numbers and _has_numbers(spec, reader)):
        found = settle(spec, reader)
        if not spec.free_numbers:
            _name_culprits(reader)
        return found
    with suppress(TooManyErrors):
        found = settle(spec, reader)
    if len(reader.diagnostics) > before:
        del reader.diagnostics[before:]
        found = settle(spec._replace(free_numbers=ALL_NUMBERS), reader)
    return found


def _has_numbers(spec: "Spec", reader: Reader) -> bool:
    """Are there numbers in parameters, or in fields that have a dimension?"""
    values = {record["value"].scalar for record in spec.parameters.values() if "value" in record}
    literals = [expression.parts.whole for scalar, expression in reader.expressions.items()
                if expression.dimension or scalar in values]
    return any(literal and literal.value for literal in literals)


def _uses_no_units(spec: "Spec", reader: Reader) -> bool:
    return not any(part.units for e in reader.expressions.values() for part in e.parts.numbers) and not any(
        "unit" in p for p in (*spec.parameters.values(), *(spec.get("records") or {}).values()))


def _name_culprits(reader: Reader) -> None:
    """Say which values have a unit, where plain numbers lack theirs and fewer have one than lack it."""
    bare = sum((d.hint or "").startswith((UNIT_DUE, "give '")) for d in reader.diagnostics)
    measured = [(expression, part) for expression in reader.expressions.values() for part in expression.parts.numbers
                if part.units]
    if measured and bare > len(measured):
        expression, part = measured[0]
        more = f", like {len(measured) - 1} more" if len(measured) > 1 else ""
        reader.report(expression.scalar.place(part.start, part.end - part.start), f"this value has a unit{more}, so "
                      "all numbers of the scene need theirs",
                      "without any unit a scene is taken in consistent SI numbers")
