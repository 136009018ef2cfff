"""What the parameters and quantities of a file count: cycles, radians, or neither."""

from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.language.parameters import definition_order
from vibcli.language.record_calls import own
from vibcli.quantities import quantity
from vibcli.quantities.quantity import declared
from vibcli.symbolic.cycles import NEITHER, PERIOD, RADIAN, Cycles, count_of, is_period, left_over
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import DimensionCheck, constant, literal_unit
from vibcli.symbolic.syntax import Equation, ExpressionError, NameRef, Product

if TYPE_CHECKING:
    from collections.abc import Mapping
    from fractions import Fraction

    from vibcli.base.units import Unit
    from vibcli.language.reader import Expression, Record
    from vibcli.language.spec import Spec
    from vibcli.symbolic.syntax import QuantityRef


def cycles(spec: "Spec", text: str = "") -> Cycles:
    """What counts the cycles in trees of a text."""
    if not spec.counts:
        _count_names(spec)
    return _counter(spec, text)


def _counter(spec: "Spec", text: str = "") -> Cycles:
    return Cycles(lambda name: spec.counts.get(name, NEITHER), lambda tree: _quantity(spec, tree),
                  lambda tree: known_dimension(spec, tree), text)


def counts_cycles(spec: "Spec", tree: Any) -> bool:
    """Does a frequency count cycles (Hz), and not radians?"""
    found: bool = left_over(cycles(spec).count(tree)) == 1
    return found


def _count_names(spec: "Spec") -> None:
    """spec.counts of the records and parameters, in an order in which each comes after those it is defined by."""
    for name, record in (spec.get("records") or {}).items():
        spec.counts[own(name)] = count_of_unit(record)
    counter = _counter(spec)
    for name in definition_order(spec.parameters):
        record = spec.parameters[name]
        try:
            found = counter.count(record["value"].tree) if "value" in record else count_of_unit(record)
        except ExpressionError:     # reported where it stands
            continue
        period = is_period(found) and spec.dimensions.of(name) == units.TIME
        spec.counts[name] = {PERIOD: 1} if period else found
    for name, record in spec.choices.items():
        if name not in spec.counts or not spec.counts[name]:
            spec.counts[name] = _of_condition(counter, name, record["so"].sides)


def count_of_unit(record: "Record") -> "Mapping[str, Fraction | int]":
    if "unit" not in record:
        return NEITHER
    return count_of(literal_unit(parse("1 " + record["unit"]).units))


def _of_condition(counter: Cycles, name: str, sides: "tuple[Expression, Expression]") -> "Mapping[str, Fraction | int]":
    """What a chosen parameter counts that is one side of its condition, perhaps times a number."""
    for side, other in (sides, sides[::-1]) if sides else ():
        factors = [part for _, part in side.tree.parts] if isinstance(side.tree, Product) else [side.tree]
        apart = [part for part in factors if constant(part) is None]
        if len(apart) == 1 and isinstance(apart[0], NameRef) and apart[0].name == name:
            try:
                found = counter.count(other.tree)
            except ExpressionError:
                return NEITHER
            return found if counter.dimension(other.tree) in (units.TIME, units.RATE) else NEITHER
    return NEITHER


def _quantity(spec: "Spec", tree: "QuantityRef") -> "Mapping[str, Fraction | int]":
    """omega[1] counts radians, frequency[1] cycles, and a period is the time of one."""
    asked = declared(tree)
    if tree.head in spec.choices and (asked is None or len(tree.indices) == 1):
        return spec.counts.get(tree.head, NEITHER)
    if asked is not None and asked.kind == quantity.PERIOD:
        return {PERIOD: 1}
    if tree.component == "Omega":
        return {RADIAN: 1}
    unit = _unit_of(tree)
    return NEITHER if unit is None else count_of(unit)


def _unit_of(tree: "QuantityRef") -> "Unit | None":
    """The Unit of a quantity; None where its indices or arguments settle it."""
    asked = declared(tree)
    return None if asked is None or asked.own_unit is None else units.parse_unit(asked.unit)


def known_dimension(spec: "Spec", tree: Any) -> "Mapping[str, Fraction | int] | None":
    """The dimension of a tree, as far as it is known."""
    def of(name: str, primes: int) -> "Mapping[str, Fraction | int]":
        return units.times(spec.dimensions.of(name), units.TIME, -primes)

    def quantity(part: "QuantityRef") -> "Mapping[str, Fraction | int] | None":
        if spec.asked_dimension:
            return spec.asked_dimension(spec, part)
        unit = _unit_of(part)
        return None if unit is None else unit.dimension

    checker = DimensionCheck(spec.dimensions, of, spec.free_numbers, quantity)
    found = checker.dimension(tree) if not isinstance(tree, Equation) else None
    return None if found is None else spec.dimensions.resolve(found)
