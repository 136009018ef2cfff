"""Literals in the place of those by which a scene gives values, so that nothing else of it is read otherwise."""

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.language.parameters import Parameters, in_unit, unit_text, unusable
from vibcli.language.reader import Expression, Record
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import exact
from vibcli.symbolic.semantics import is_factor, literal_unit

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import Number, SyntaxTree


class GivenByLiteral:
    """A parameter that a scene gives by a positive literal. free_numbers: as in a DimensionCheck of the scene."""

    def __init__(self, record: Record, free_numbers: bool | str) -> None:
        self._record, self._free_numbers, was = record, free_numbers, record.get("value")
        self._replaceable = was is not None and _is_positive(was.tree)
        if self._replaceable:
            self._unit, self._kind, self._in_si = unit_text(record), _kind(was.tree), _in_si(was.tree)
            self._factor = free_numbers and is_factor(was.tree, free_numbers)

    def other(self, tree: Any, scalar: Any) -> "tuple[Record, Fraction | int | None] | None":
        """Its record with another literal of the same sign and kind of unit, and the exact value of that, None where it
        has none in SI units; None where it is no such literal."""
        if not (self._replaceable and _is_positive(tree)) or (tree.units and self._kind != _kind(tree)) or (
                self._free_numbers and self._factor != is_factor(tree, self._free_numbers)):
            return None
        in_si, record = _in_si(tree) if tree.units else self._in_si, self._record.with_values(self._record)
        record["value"] = _OtherLiteral(record["value"], self._unit, tree, scalar)
        return record, in_si and (tree.value if in_si == 1 else tree.value * in_si)


class _OtherLiteral(Expression):
    """A literal in the place of another, in the unit of that where it has none: it is made when it is first read."""

    __slots__ = ("_in_place_of",)

    def __init__(self, *in_place_of: Any) -> None:
        self._in_place_of = in_place_of

    def __getattr__(self, name: str) -> Any:
        if name not in Expression.__slots__:
            raise AttributeError(name)
        was, unit, tree, scalar = self._in_place_of
        tree, scalar = in_unit(unit, tree, scalar)
        super().__init__(scalar, tree, was.unit, was.dimension)
        return getattr(self, name)


def _is_positive(tree: "SyntaxTree") -> bool:
    return tree.kind == "number" and tree.value.numerator > 0


def _kind(literal: "Number"
          ) -> "tuple[Mapping[str, Fraction | int], Fraction | int, Fraction | int, Fraction | int] | None":
    unit = literal_unit(literal.units) if literal.units else None
    return None if unit is None else (unit.dimension, unit.pi, unit.cycles, unit.radians)


def _in_si(literal: "Number") -> "Fraction | int | None":
    """What its unit is in SI units, None where that is no rational number."""
    unit = literal_unit(literal.units)
    value: Fraction | int | None = None if unit.pi or unit.roots else exact(unit.value)
    return value


class OtherLiterals(Parameters):
    """The parameters of a scene, some with other literals, {name: exact value, None where that is none}, on which hang
    those that are `hanging`, in the order of their definitions."""

    def __init__(self, like: Parameters, records: dict[str, Record], literals: "Mapping[str, Fraction | None]",
                 hanging: Sequence[str]) -> None:
        self._like, self.records, self._literals, self._hanging = like, records, literals, hanging
        self.table, self.order, self.nodes, self.free = like.table, like.order, like.nodes, like.free
        self.untold, self.in_letters = like.untold, like.in_letters

    @cached_property
    def definitions(self) -> dict[str, Any]:
        return {**self._like.definitions, **self._lowered(self._literals)}

    def floats(self, before: Mapping[str, float]) -> dict[str, float] | None:
        """{name: float}, as before of what does not hang on the other literals; None where one is no usual number."""
        found = dict(before)
        for name in self._hanging:
            value = self._literals.get(name)
            found[name] = Floats.number(value) if value else evaluate([self._definition(name)], Floats, found)[0]
            if unusable(found[name], Floats):
                return None
        return found

    def _definition(self, name: str) -> "Node | None":
        return (self if name in self._literals else self._like).definitions.get(name)

    @cached_property
    def exact(self) -> "Mapping[str, Fraction]":
        found = {**self._like.exact, **self._literals}
        rest = [name for name in self._hanging if not self._literals.get(name)]
        return self._rational({name: found[name] for name in found if name not in rest}, rest) if rest else found


def hanging_on(parameters: Parameters, names: Iterable[str]) -> tuple[str, ...]:
    """These parameters and those that are defined by them, in the order of their definitions."""
    found = set(names)
    for name in parameters.order:
        if name in parameters.definitions:
            defined_by = {other for other, *_ in parameters.records[name]["value"].parts.names}
            found |= {name} if defined_by & found else set()
    return tuple(name for name in parameters.order if name in found)
