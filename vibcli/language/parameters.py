"""Values of parameters: from the file, from outside, exact or in any arithmetic."""

from collections.abc import Iterable, Mapping
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.language.document.document import Scalar
from vibcli.language.reader import Expression, Reader, Record
from vibcli.language.record_calls import with_record_calls
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.literals import LARGEST, RANGE, SMALLEST
from vibcli.symbolic.parser import parse
from vibcli.symbolic.rationals import bits
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import Call, ExpressionError, Number, Power, Product, Sum, whole_literal

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.language.spec import Spec
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree, UnitPower

WIDEST = 4096       # bits


def in_unit(unit: str, tree: Any, scalar: Any) -> tuple[Any, Any]:
    """A bare number and its text in a unit, if any; all else as it is."""
    number = whole_literal(tree)
    if unit and number and not number.units:
        return _with_unit(tree, _placed(unit, len(scalar.text) + 1)), Scalar(f"{scalar.text} {unit}", scalar.where)
    return tree, scalar


@lru_cache(maxsize=256)
def _placed(unit: str, start: int) -> "tuple[UnitPower, ...]":
    """The units of a text that starts at a place."""
    moved = start - len("1 ")
    return tuple(one._replace(start=one.start + moved, end=one.end + moved) for one in parse("1 " + unit).units)


def overridden(record: Record, tree: Number | Product | Sum, scalar: Any, reader: Reader) -> Record:
    """The Record of a parameter with another value; a bare number takes the unit in which the file gives it."""
    tree, scalar = in_unit(unit_text(record), tree, scalar)
    value = Expression(scalar, with_record_calls(tree, reader.records))
    if "value" in record:
        del reader.expressions[record["value"].scalar]
        reader.expressions[scalar] = value
    return record.with_values({**record, "value": value})


def unit_text(record: Record) -> str:
    """The text of the unit in which the file gives a parameter, '' where it gives none."""
    if "value" not in record:
        unit: str = record.get("unit", "")
        return unit
    value: Expression = record["value"]
    was = value.parts.whole
    return value.text[was.units[0].start:was.end].strip() if was and was.units else ""


def _with_unit(tree: "SyntaxTree", units: "tuple[UnitPower, ...]") -> Number | Sum:
    if isinstance(tree, Sum):
        sign, number = tree.parts[0]
        return tree._replace(parts=((sign, _with_unit(number, units)),))
    assert isinstance(tree, Number)
    return Number(tree.start, units[-1].end, tree.value, units)


def _may_be_negative(tree: "SyntaxTree") -> bool:
    """Does a value hold a minus, a zero or a function?"""
    if isinstance(tree, (Sum, Product)):
        return any(sign < 0 and isinstance(tree, Sum) for sign, _ in tree.parts) or any(
            _may_be_negative(part) for _, part in tree.parts)
    if isinstance(tree, Power):
        return _may_be_negative(tree.base)
    return isinstance(tree, Call) or (isinstance(tree, Number) and not tree.value)


class Parameters:
    """The parameters of a scene as leaves of its table: `nodes` by name, `definitions` of those that have a value;
    `in_letters`: what those that are defined by letters stand for in the scene; `untold`: those without value that
    neither are `given` one nor are chosen."""

    order: list[str]
    nodes: "dict[str, Node]"
    definitions: "dict[str, Node]"
    free: list[str]
    untold: list[str]
    in_letters: "dict[str, Node]"

    def __init__(self, spec: "Spec", table: "Table", given: Iterable[str] = ()) -> None:
        self.table = table
        self.records = spec.parameters
        self.order = definition_order(spec.parameters)
        unsigned = {name for name, record in spec.parameters.items() if record.get("sign") == "any"}
        unsigned |= self._not_positive()
        self.nodes = {name: table.parameter(name, name not in unsigned) for name in spec.parameters}
        self.definitions = self._lowered(self.order)
        self.free = [name for name in spec.parameters if name not in self.definitions]
        self.untold = [name for name in self.free if name not in given and name not in spec.choices]
        self.in_letters = self._letters() if self.free else {}

    def _not_positive(self) -> set[str]:
        """Names of parameters that are given as zero or a negative number: found where nothing is taken as positive."""
        if not any(_may_be_negative(record["value"].tree) for record in self.records.values() if "value" in record):
            return set()
        from vibcli.symbolic.evaluation import Floats, evaluate

        table, values = self.table.__class__(), {}
        nodes = {name: table.parameter(name, False) for name in self.records}
        for name in self.order:
            if "value" in self.records[name]:
                try:
                    node = lower(self.records[name]["value"].tree, table, lambda name, primes, tree: nodes[name])
                    values[name] = evaluate([node], Floats, values)[0]
                except (ExpressionError, KeyError):     # reported later, or defined by letters
                    continue
        return {name for name, value in values.items() if not value > 0}

    def _letters(self) -> "dict[str, Node]":
        """{name: expression} of parameters defined by parameters without value: m1 = 4·m is written out."""
        letters, found = {self.nodes[name] for name in self.free}, {}
        for name in self.order:
            if name in self.definitions:
                node = substitute([self.definitions[name]], {self.nodes[n]: part for n, part in found.items()})[0]
                if letters.intersection(reachable([node])):
                    found[name] = node
        return found

    def _lowered(self, names: Iterable[str]) -> "dict[str, Node]":
        found, wrong = {}, []
        for name in names:
            value = self.records[name].get("value")
            try:
                if value is not None:
                    found[name] = lower(value.tree, self.table, lambda name, primes, tree: self.nodes[name])
            except ExpressionError as error:
                wrong.append(Diagnostic(value.scalar.place(error.offset, error.width), error.message, error.hint))
        if wrong:
            raise SpecError(wrong)
        return found

    def values(self, arithmetic: Any,
               given: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """{name: number of this arithmetic}; `given` supplies the parameters that have no value."""
        from vibcli.symbolic.evaluation import evaluate

        found, wrong = dict(given or {}), []
        for name in self.order:
            if name in found or name not in self.definitions:
                continue
            try:
                value, = evaluate([self.definitions[name]], arithmetic, found)
            except KeyError:
                continue
            if hasattr(arithmetic, "isfinite") and (problem := unusable(value, arithmetic)):
                where = self.records[name]["value"].where
                wrong.append(Diagnostic(where, f"the value of '{name}' is {problem[0]}", problem[1]))
            else:
                found[name] = value
        if wrong:
            raise SpecError(wrong)
        return found

    def rational(self, given: "Mapping[str, Fraction] | None" = None) -> "Mapping[str, Fraction]":
        """Exact values of the parameters that have one, without those that are irrational or have too many digits.
        (Products of products double their digits at each step.)"""
        return self._rational(dict(given), self.order) if given else self.exact

    @cached_property
    def exact(self) -> "Mapping[str, Fraction]":
        """The same, where no value is given."""
        return self._rational({}, self.order)

    def _rational(self, found: "dict[str, Fraction]", names: list[str]) -> "dict[str, Fraction]":
        from vibcli.symbolic.evaluation import evaluate_rational

        for name in names:
            definition = None if name in found else self._definition(name)
            value = definition and evaluate_rational([definition], found)
            if value and bits(value[0]) <= WIDEST:
                found[name] = value[0]
        return found

    def _definition(self, name: str) -> "Node | None":
        return self.definitions.get(name)


def definition_order(records: Mapping[str, Record]) -> list[str]:
    """Names in an order in which each comes after those it is defined by (there are no circles)."""
    needs = {name: [n for n, *_ in record["value"].parts.names if n in records] if "value" in record else []
             for name, record in records.items()}
    done = {}
    for start in records:
        stack = [start]
        while stack:
            waiting = [n for n in needs[stack[-1]] if n not in done]
            if waiting:
                stack.extend(waiting)
            else:
                done[stack.pop()] = None
    return list(done)


def unusable(value: "float | mpmath.mpf", arithmetic: Any) -> tuple[str, str] | None:
    """(what is wrong, hint) of a value that is no finite number of usual size, else None."""
    if not arithmetic.isfinite(value):
        return "not a finite real number", "look for a division by zero, or a root or logarithm of a negative number"
    if value and not SMALLEST <= abs(value) <= LARGEST:
        return "out of range", RANGE
    return None


def require_values(parameters: Parameters, what: str) -> None:
    """Refuse a numeric question about a scene that has symbols without value."""
    if parameters.free:
        names = ", ".join(parameters.free)
        raise PhysicsError(f"{what} needs numbers, and these parameters have none: {names}",
                           "give them values in the file or with --set")
