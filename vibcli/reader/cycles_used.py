"""Does a file count cycles (Hz)? Most do not, and have nothing of what `cycle_check` reports."""

from typing import TYPE_CHECKING, Any

from vibcli.base.units import UNITS
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import literal_unit

if TYPE_CHECKING:
    from vibcli.language.reader import Expression, Reader
    from vibcli.language.spec import Spec

OF_CYCLES = frozenset(name for name, unit in UNITS.items() if unit.cycles)


def uses_cycles(spec: "Spec", reader: "Reader") -> bool:
    """Does anything in the file count cycles?"""
    values = [record["value"] for record in spec.parameters.values() if "value" in record]
    if any(_counts(number) for expression in (*reader.expressions.values(), *values)
           for number in expression.parts.numbers):
        return True
    records = (*spec.parameters.values(), *(spec.get("records") or {}).values())
    if any("unit" in record and literal_unit(parse("1 " + record["unit"]).units).cycles for record in records):
        return True
    asked = [answer.asked for answer in spec.answers]
    asked += [side for record in spec.choices.values() for side in record["so"].sides]
    return any(tree.head == "frequency" for expression in asked for tree in expression.parts.quantities)


def is_number_without_cycles(expression: "Expression") -> bool:
    """Is it a number, and not in Hz?"""
    return expression.tree.kind == "number" and not _counts(expression.tree)


def _counts(number: Any) -> bool:
    return any(part.unit in OF_CYCLES for part in number.units)
