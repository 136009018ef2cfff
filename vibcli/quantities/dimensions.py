"""The dimension of a quantity, and of a signal: an expression of coordinates, signals and parameters."""

from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.quantities.quantity import SIGNAL, about_which, declared, is_choice, quantity_of
from vibcli.symbolic.semantics import DimensionCheck
from vibcli.symbolic.syntax import ExpressionError, NameRef, QuantityRef

if TYPE_CHECKING:
    from collections.abc import Container, Mapping
    from fractions import Fraction

    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec


def asked_dimension(spec: "Spec", tree: QuantityRef) -> "Mapping[str, Fraction | int] | None":
    """The dimension of a quantity; None where any fits, or something in it is unknown."""
    if is_choice(spec, tree):
        return spec.dimensions.of(tree.head)
    quantity, (tree, _) = declared(tree), about_which(tree)
    if quantity.unit == SIGNAL:
        return checker(spec).dimension(tree.args[0]) if tree.args else None
    if quantity.unit is not None:
        return units.parse_unit(quantity.unit).dimension
    return None if quantity.dimension is None else quantity.dimension(spec, tree)


def dimension_of(spec: "Spec", expression: "Expression") -> "Mapping[str, Fraction | int] | None":
    """The dimension of an expression of quantities and parameters; None where its parts do not fit."""
    try:
        return DimensionCheck(spec.dimensions, lambda name, primes: spec.dimensions.of(name), spec.free_numbers,
                              lambda tree: asked_dimension(spec, tree)).dimension(expression.tree)
    except ExpressionError:
        return None


def unit_of(spec: "Spec", asked: "Expression") -> str:
    """The SI unit of the value of a quantity: 1 of a pure number, nothing where the scene has no units."""
    tree = asked.tree
    quantity = quantity_of(spec, tree)
    if quantity is not None and quantity.own_unit is not None:
        return quantity.unit
    dimension = asked_dimension(spec, tree) if quantity is not None else dimension_of(spec, asked)
    if dimension is None:
        return ""
    found = spec.dimensions.resolve(dimension)
    angle = quantity is not None and (quantity.unit == SIGNAL or tree.head == "equilibrium")
    return ("rad" if angle else "1") if found == {} else text_of(found, tree, spec.parameters)


def text_of(dimension: "Mapping[str, Fraction | int]", tree: Any, names: "Container[str]" = ()) -> str:
    """The SI unit of a signal or quantity of this dimension, J of an energy and N·m of a moment; `names`: those of
    parameters."""
    while isinstance(tree, QuantityRef) and tree.args:
        tree = tree.args[0]
    name = tree.head if isinstance(tree, QuantityRef) else tree.name if isinstance(tree, NameRef) else ""
    is_energy = name.endswith(".energy") or (name in ("T", "V") and name not in names)
    return "J" if is_energy and dimension == units.ENERGY else units.text(dimension)


def checker(spec: "Spec", text: str = "") -> DimensionCheck:
    """What finds the dimensions of signals; ExpressionError of a misfit."""
    from vibcli.quantities.signal_dimensions import output_dimension

    def of(name: str, primes: int) -> "Mapping[str, Fraction | int]":
        found = spec.dimensions.of(name) if name in spec.parameters else output_dimension(spec, name + "'" * primes)
        return units.times(found, units.TIME, 0)

    return DimensionCheck(spec.dimensions, of, spec.free_numbers, lambda part: asked_dimension(spec, part), text)
