"""Cycles and radians in a file: what its parameters and quantities count, and where cycles stand for radians."""

from vibcli.base import units
from vibcli.language.parameters import definition_order
from vibcli.language.record_calls import own
from vibcli.quantities.quantity import SIGNAL, declared
from vibcli.symbolic.cycles import (
    CYCLE,
    NEITHER,
    PERIOD,
    RADIAN,
    RATE,
    Cycles,
    agree,
    count_of,
    fits_both,
    is_period,
    left_over,
)
from vibcli.symbolic.parser import ExpressionError, parse
from vibcli.symbolic.semantics import DimensionCheck, constant, literal_unit, literals_in, quantities_in

PERIODS = ("period", "beat_period")


def uses_cycles(spec, reader):
    """Does anything in the file count cycles?"""
    values = [record["value"] for record in spec.parameters.values() if "value" in record]
    if any(part[4] and literal_unit(part[4]).cycles for expression in (*reader.expressions, *values)
           for part in literals_in(expression.tree)):
        return True
    records = (*spec.parameters.values(), *(spec.get("records") or {}).values())
    if any(_of_unit(record).get(CYCLE) for record in records):
        return True
    asked = [answer.asked for answer in spec.answers]
    asked += [side for record in spec.choices.values() for side in record["so"].sides]
    return any(tree[4] == "frequency" for expression in asked for tree in quantities_in(expression.tree))


def cycles(spec, text=""):
    """What counts the cycles in trees of a text."""
    if spec.counts is None:
        spec.counts = {}
        _count_names(spec)
    return Cycles(lambda name: spec.counts.get(name, NEITHER), lambda tree: _quantity(spec, tree),
                  lambda tree: _dimension(spec, tree), text)


def counts_cycles(spec, tree):
    """Does a frequency count cycles (Hz), and not radians?"""
    return left_over(cycles(spec).count(tree)) == 1


def check_radians(spec, reader, expression):
    """Report cycles where radians are due: in an angle, an angular frequency, a stiffness …"""
    message = "expected an angular frequency (rad/s), found Hz" if expression.unit == "rad/s" else (
        "this counts cycles (Hz) where radians are due")
    _reported(reader, expression, lambda counter: counter.require_radians(expression.tree, message, True), spec)


def check_terms(spec, reader, expression):
    """Report terms that cannot be added, one counting cycles and the other radians."""
    return _reported(reader, expression, lambda counter: counter.count(expression.tree), spec)


def check_same(spec, reader, asked, expected):
    """Report an expected value that counts cycles where what is asked does not, or the reverse."""
    counts = [check_terms(spec, reader, part) for part in (asked, expected)]
    dimensions = [_dimension(spec, part.tree) for part in (asked, expected)]
    if None not in counts and not agree(counts, dimensions):
        more = left_over(counts[1]) > left_over(counts[0])
        reader.report(expected.where, "this counts cycles (Hz), and what it is compared with does not" if more else
                      "this counts no cycles (Hz), and what it is compared with does",
                      "an angular frequency is 2*pi*f, a frequency omega/(2*pi)")


def is_frequency(spec, expression):
    """Can it be a frequency in Hz: does it count one cycle, or neither cycles nor radians?"""
    count = cycles(spec, expression.text).count(expression.tree)
    return left_over(count) == 1 or fits_both(count, _dimension(spec, expression.tree))


def _reported(reader, expression, check, spec):
    try:
        return check(cycles(spec, expression.text))
    except ExpressionError as error:
        return reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)


def _count_names(spec):
    """spec.counts of the records and parameters, in an order in which each comes after those it is defined by."""
    for name, record in (spec.get("records") or {}).items():
        spec.counts[own(name)] = _of_unit(record)
    counter = cycles(spec)
    for name in definition_order(spec.parameters):
        record = spec.parameters[name]
        try:
            found = counter.count(record["value"].tree) if "value" in record else _of_unit(record)
        except ExpressionError:     # reported where it stands
            continue
        period = is_period(found) and spec.dimensions.of(name) == units.TIME
        spec.counts[name] = {PERIOD: 1} if period else found
    for name, record in spec.choices.items():
        if name not in spec.counts or not spec.counts[name]:
            spec.counts[name] = _of_condition(counter, name, record["so"].sides)


def _of_unit(record):
    if "unit" not in record:
        return NEITHER
    return count_of(literal_unit(parse("1 " + record["unit"])[4]))


def _of_condition(counter, name, sides):
    """What a chosen parameter counts that is one side of its condition, perhaps times a number."""
    for side, other in (sides, sides[::-1]) if sides else ():
        factors = [part for _, part in side.tree[3]] if side.tree[0] == "product" else [side.tree]
        apart = [part for part in factors if constant(part) is None]
        if len(apart) == 1 and apart[0][0] == "name" and apart[0][3] == name:
            try:
                found = counter.count(other.tree)
            except ExpressionError:
                return NEITHER
            return found if counter.dimension(other.tree) in (units.TIME, RATE) else NEITHER
    return NEITHER


def _quantity(spec, tree):
    """omega[1] counts radians, frequency[1] cycles, and a period is the time of one."""
    asked = declared(tree)
    if tree[4] in spec.choices and (asked is None or len(tree[5]) == 1):
        return spec.counts.get(tree[4], NEITHER)
    if tree[4] in PERIODS:
        return {PERIOD: 1}
    if tree[6] == "Omega":
        return {RADIAN: 1}
    unit = _unit_of(tree)
    return NEITHER if unit is None else count_of(unit)


def _unit_of(tree):
    """The Unit of a quantity; None where its indices or arguments settle it."""
    asked = declared(tree)
    return None if asked is None or asked.unit in (None, SIGNAL) else units.parse_unit(asked.unit)


def _dimension(spec, tree):
    """The dimension of a tree, as far as it is known."""
    def of(name, primes):
        return units.times(spec.dimensions.of(name), units.TIME, -primes)

    def quantity(part):
        unit = _unit_of(part)
        return None if unit is None else unit.dimension

    checker = DimensionCheck(spec.dimensions, of, spec.free_numbers, spec.asked_dimension or quantity)
    found = checker.dimension(tree) if tree[0] != "equation" else None
    return None if found is None else spec.dimensions.resolve(found)
