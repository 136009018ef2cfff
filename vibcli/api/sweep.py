"""Quantities of a scene over arrays of values of its parameters, for Python."""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

from vibcli.api.axis import of_numbers
from vibcli.api.source import settled
from vibcli.api.values import checked_quantity, given_expression
from vibcli.base.errors import Diagnostic, PhysicsError, SpecError, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.quantities.dimensions import unit_of
from vibcli.quantities.quantity import OF_STATE, kind_of
from vibcli.quantities.sweep import Sweep, SweptAxis

if TYPE_CHECKING:
    from numpy import ndarray
    from numpy.typing import ArrayLike

    from vibcli.language.reader import Expression
    from vibcli.results.branches import Meeting
    from vibcli.results.problem import Problem

MOST = 1_000_000        # values of all axes together


class SweptValues(NamedTuple):
    """over: {parameter: array in SI units}; values: {quantity: array over them, in SI units, NaN where there is no
    value}; units: {quantity: its unit}; branches: {quantity of a natural mode: which branch, followed by its shape, the
    mode belongs to}; meetings: where branches cross or veer; gaps: [(quantities, places in the arrays, why)]."""

    over: "dict[str, ndarray]"
    values: "dict[str, ndarray]"
    units: dict[str, str]
    branches: "dict[str, ndarray]"
    meetings: "list[Meeting]"
    gaps: list[tuple[Any, ...]]


def swept(problem: "Problem", quantities: Sequence[str], parameters: "Mapping[str, ArrayLike]") -> SweptValues:
    """Quantities over one parameter, or over the grid of several, whose numbers are in the unit of the file."""
    import numpy as np

    try:
        axes = [of_numbers(problem.spec, name, numbers) for name, numbers in parameters.items()]
        found = sweep(problem, axes, [given_expression(text, "the quantity") for text in quantities])
        quantities = [one.text for one in found.asked]
    except ValueError as error:
        raise SpecError([Diagnostic(Where("sweep", 1, 1, 0), str(error))]) from None
    values = dict(zip(quantities, found.columns, strict=True))
    branches = {text: branch for text, one in zip(quantities, found.asked, strict=True)
                if (branch := found.branch(one)) is not None}
    return SweptValues(
        {axis.name: np.array(axis.in_si) for axis in axes}, values,
        dict(zip(quantities, found.units, strict=True)), branches,
        [] if found.branches is None else found.branches.meetings, [*map(tuple, found.gaps), *_not_reached(found)])


def _not_reached(found: Sweep) -> list[tuple[tuple[str, ...], list[tuple[int, ...]], str]]:
    """The gap of what an interrupt left out."""
    left = list(product(*map(range, found.shape)))[found.done:]
    return [(tuple(one.text for one in found.asked), left, "it was interrupted before")] if left else []


def sweep(problem: "Problem", axes: Sequence[SweptAxis], asked: "Sequence[Expression]") -> Sweep:
    """The Sweep of quantities, of the natural frequencies where none is named; ValueError where that cannot be,
    SpecError where a quantity is none of the scene."""
    if not axes:
        raise ValueError("name a parameter to sweep over")
    if len({axis.name for axis in axes}) < len(axes):
        raise ValueError(f"'{axes[0].name}' is swept over twice")
    total = 1
    for axis in axes:
        total *= len(axis.values)
    if total > MOST:
        raise ValueError(f"{total} values are asked for; the limit is {MOST}")
    _require_values(problem, {axis.name for axis in axes})
    checked = [checked_quantity(problem.spec, one) for one in asked or _natural(problem, axes)]
    for one in checked:
        _require_number(problem, one)
    found = Sweep(problem, axes, checked, [unit_of(problem.spec, one) for one in checked], settled)
    if found.invalid_end is not None:
        values, message = found.invalid_end
        _ = problem.scene       # what is wrong as it is written is told with its place
        raise ValueError(f"there is no such scene at {values}: {message}")
    return found


def _require_values(problem: "Problem", swept_over: set[str]) -> None:
    left = [name for name, record in problem.spec.parameters.items()
            if "value" not in record and name not in swept_over and name not in problem.spec.choices]
    if left:
        raise ValueError(f"a sweep needs numbers, and these parameters have none: {', '.join(left)}; give them with "
                         "--set, or values in the file")


def _natural(problem: "Problem", axes: Sequence[SweptAxis]) -> "list[Expression]":
    """The natural frequencies of the scene at the middle of its ranges; at one end, where it has none there."""
    from vibcli.results.variants import Variants

    variants, refused = Variants(problem, [{axis.name: axis.values} for axis in axes], settled), None
    for place in zip(*((len(axis.values) // 2, 0, -1) for axis in axes), strict=True):
        found = variants.alone(place)
        try:
            if isinstance(found, Exception):
                raise found
            return [given_expression(f"omega[{mode.index}]", "the quantity") for mode in found.modal.modes.shown()]
        except (SpecError, PhysicsError) as error:
            refused = refused or error
    raise refused


def _require_number(problem: "Problem", asked: "Expression") -> None:
    if kind_of(problem.spec, asked.tree) in OF_STATE:
        raise ValueError(f"'{asked.text}' is a function of the state, no number")
