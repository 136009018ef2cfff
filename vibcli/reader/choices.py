"""Chosen parameters of a file: symbols with a condition each, which must name what can be asked, in its dimension."""

from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.language.dimension_check import check
from vibcli.language.reader import Expression, Reader, Record
from vibcli.quantities import FAMILIES
from vibcli.quantities.dimensions import asked_dimension, dimension_of
from vibcli.quantities.quantity import LEAPING, OF_STATE, kind_of
from vibcli.reader.answer_check import as_quantity, check_cycles, in_unit_asked
from vibcli.reader.quantity_check import can_be_asked
from vibcli.reader.sections.choose import Condition
from vibcli.symbolic.semantics import ALL_NUMBERS
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.spec import Spec

MOST_CHOSEN = 4


def with_choices(spec: "Spec", reader: Reader) -> "Spec":
    """The Spec in which every chosen name is a symbol, those as well whose condition could not be read."""
    choices, names = spec.get("choose") or {}, spec.named["choose"]
    moved = {motion.tree.name for motion in reader.motions.values() if isinstance(motion.tree, NameRef)}
    moved |= set(spec.get("coordinates") or ())
    if len(choices) > MOST_CHOSEN:
        reader.report(list(choices.values())[MOST_CHOSEN].where,
                      f"{len(choices)} parameters are chosen; the limit is {MOST_CHOSEN}", "give values to the others")
    for name, record in choices.items():
        if name in moved and name not in spec.parameters:
            reader.report(record.where, f"'{name}' is a coordinate: only parameters can be chosen",
                          f"ask for its place in equilibrium under answers: equilibrium[{name}]")
        elif "value" in spec.parameters.get(name, ()):
            reader.report(record.where, f"'{name}' is chosen, but has a value already",
                          "leave its value out under `parameters`, or do not choose it")
    new = [name for name in names if name not in moved and name.isidentifier() and name not in spec.parameters]
    symbols = {name: Record(None, name, choices[name].where if name in choices else None, {}, {}) for name in new}
    named = {**spec.named, "parameters": [*spec.named.get("parameters", ()), *names]}
    return spec.with_parameters({**spec.parameters, **symbols})._replace(choices=choices, named=named)


def check_choices(spec: "Spec", reader: Reader) -> "Spec":
    """The Spec with its conditions finished; reports whatever is wrong with them."""
    found = {name: record if record["so"].word else record.with_values({**record, "so": _finished(spec, record["so"])})
             for name, record in spec.choices.items()}
    spec = spec.with_sections(choose={**spec.get("choose", {}), **found})._replace(choices=found)
    for name, record in found.items():
        for bound in (record[key] for key in ("from", "to") if key in record):
            for other, _, start, end in bound.parts.names:
                if other in spec.choices:
                    reader.report(bound.scalar.place(start, end - start), f"'{other}' is chosen itself",
                                  "bounds are made of numbers and given parameters")
        if not record["so"].word:
            _equation(spec, reader, name, record["so"])
    return spec


def _finished(spec: "Spec", condition: Condition) -> Condition:
    """An equation in which names alone are the quantities that they stand for, its expected side in their unit."""
    return Condition(condition.text, condition.where, None, *finished_sides(spec, *condition.sides))


def finished_sides(spec: "Spec", left: Expression, right: Expression) -> tuple[Expression, Expression]:
    """Two sides in which names alone are the quantities that they stand for, the expected one in their unit."""
    left, right = as_quantity(spec, left), as_quantity(spec, right)
    if _head(right) and not _head(left):
        left = in_unit_asked(spec, left, right.tree)
    elif _head(left):
        right = in_unit_asked(spec, right, left.tree)
    return left, right


def _equation(spec: "Spec", reader: Reader, name: str, condition: Condition) -> None:
    left, right = condition.sides
    quantities = [(side, tree) for side in condition.sides for tree in side.parts.quantities]
    for side, tree in quantities:
        if tree.head in spec.choices and tree.head not in FAMILIES:
            reader.report(_place(side, tree), f"'{tree.text}' cannot stand in a condition", f"write {tree.head} alone")
            return
        if not can_be_asked(spec, reader, side, tree):
            return
        kind = kind_of(spec, tree)
        if kind in LEAPING:
            reader.report(_place(side, tree), f"'{tree.text}' cannot stand in a condition: it changes by leaps",
                          "for the value at which it changes write stability limit")
            return
        if kind in OF_STATE:
            reader.report(_place(side, tree), f"'{tree.text}' cannot stand in a condition: it is not a number",
                          "conditions are made of numbers, parameters and quantities such as omega[1]")
            return
    if not check_sides(spec, reader, left, right):
        return
    if not quantities and not any(part[0] in spec.choices for side in condition.sides for part in side.parts.names):
        reader.report(condition.where, f"this does not determine '{name}': it holds no quantity and nothing chosen",
                      "write an equation such as omega[1] = 20 rad/s")


def check_sides(spec: "Spec", reader: Reader, left: Expression, right: Expression) -> bool:
    """Do both sides of an equation or comparison measure the same? False where one of them cannot stand; reports what
    is wrong with them."""
    asked, expected = (right, left) if _head(right) and not _head(left) else (left, right)
    if not check(spec, reader, asked, spec.parameters, None):
        return False
    if _head(asked):
        fits = check(spec, reader, expected, spec.parameters, asked_dimension(spec, asked.tree))
    else:
        fits = check(spec, reader, expected, spec.parameters, None) and _same(spec, reader, asked, expected)
    if fits:
        check_cycles(spec, reader, asked, expected)
    return True


def _same(spec: "Spec", reader: Reader, left: Expression, right: Expression) -> bool:
    one, other = (dimension_of(spec, side) for side in (left, right))
    if spec.free_numbers != ALL_NUMBERS and None not in (one, other) and not spec.dimensions.equate(one, other):
        found = [units.name(spec.dimensions.resolve(part)) for part in (one, other)]
        reader.report(right.where, f"the two sides measure different things: {found[0]} and {found[1]}",
                      "both sides of an equation have one dimension")
        return False
    return True


def _head(side: Expression) -> str | None:
    return side.tree.head if isinstance(side.tree, QuantityRef) else None


def _place(side: Expression, tree: QuantityRef) -> "Where":
    return side.scalar.place(tree.start, tree.end - tree.start)
