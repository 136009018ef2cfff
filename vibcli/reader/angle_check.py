"""Angles as they are given in degrees, but without the unit: numbers beyond a full turn where an angle is due."""

from math import degrees, tau
from typing import TYPE_CHECKING

from vibcli.base.errors import Remark
from vibcli.symbolic.semantics import constant
from vibcli.symbolic.syntax import NameRef, Number, Product, Sum

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Expression, Reader
    from vibcli.language.spec import Spec
    from vibcli.symbolic.syntax import SyntaxTree

CIRCULAR = ("sin", "cos", "tan")
FEW = 4         # angles are doubled and halved; by greater factors degrees are turned into radians


def angle_remarks(spec: "Spec", reader: "Reader") -> list[Remark]:
    """A Remark for each number without a unit, greater than 2π, that is taken in radians: as an argument of sin, cos
    or tan, a term of it or the value of a parameter that is one, as an angle of a body, or where one starts."""
    found = {}
    for expression, tree in _angles(spec, reader):
        for holder, number, name in _terms(spec, expression, tree):
            where = holder.scalar.place(number.start, number.end - number.start)
            text = holder.text[number.start:number.end].strip()
            found[where] = Remark(where, f"{name}{text} has no unit and is taken in radians: "
                                      f"{degrees(float(number.value)):.4g}°", f"write {text} deg, or {text} rad")
    return list(found.values())


def _angles(spec: "Spec", reader: "Reader") -> "Iterator[tuple[Expression, SyntaxTree]]":
    """(expression, its part that is an angle)."""
    turning = set()
    for expression in (*reader.expressions.values(), *_values(spec)):
        angles = [call.args[0] for call in expression.parts.calls if call.name in CIRCULAR]
        if expression.unit == "rad":
            angles.append(expression.tree)
            turning.update(name for name, *_ in expression.parts.names)
        for angle in angles:
            turning.update(term.name for term in _split(angle) if isinstance(term, NameRef))
            yield expression, angle
    for name, expression in _places(spec):
        if name in turning and not spec.dimensions.of(name):
            yield expression, expression.tree


def _values(spec: "Spec") -> "list[Expression]":
    return [record["value"] for record in spec.parameters.values() if "value" in record]


def _places(spec: "Spec") -> "Iterator[tuple[str, Expression]]":
    """(coordinate, expression of where it starts or is drawn)."""
    yield from (spec.get("initial") or {}).items()
    yield from ((name, record["drawn"]) for name, record in spec.coordinates.items() if "drawn" in record)


def _terms(spec: "Spec", expression: "Expression", tree: "SyntaxTree") -> "Iterator[tuple[Expression, Number, str]]":
    """(Expression, Number, 'name = ') of the numbers beyond a turn among the terms of an angle."""
    for term in _split(tree):
        if isinstance(term, NameRef) and "value" in spec.parameters.get(term.name, ()):
            value = spec.parameters[term.name]["value"]
            if not spec.dimensions.of(term.name):
                said = f"{term.name} = " if value.parts.whole else ""
                yield from ((holder, number, name or said)
                            for holder, number, name in _terms(spec, value, value.tree))
        elif isinstance(term, Number) and not term.units and term.value > tau:
            yield expression, term, ""


def _split(tree: "SyntaxTree") -> "Iterator[NameRef | Number]":
    """The names and numbers that are terms of an angle, doubled or halved at most."""
    if isinstance(tree, Sum):
        for _, part in tree.parts:
            yield from _split(part)
    elif isinstance(tree, Product):
        free = [(power, part) for power, part in tree.parts if constant(part) is None]
        factors = [constant(part) for _, part in tree.parts if constant(part) is not None]
        if len(free) == 1 and free[0][0] == 1 and all(abs(factor) <= FEW for factor in factors):
            yield from _split(free[0][1])
    elif isinstance(tree, (NameRef, Number)):
        yield tree
