"""A range of values of a parameter, as text: `k=400 N/m .. 1.2 kN/m`. ValueError: what is wrong with it."""

import re
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import exp, log
from typing import TYPE_CHECKING

from vibcli.api.given import parsed, said
from vibcli.base.spelling import nearest
from vibcli.language.given_values import converted, giver, number_and_unit, rounded, unit_of_text
from vibcli.language.parameters import unit_text
from vibcli.language.reader import Expression
from vibcli.quantities.sweep import SweptAxis
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from vibcli.language.spec import Spec

BETWEEN = re.compile(r"\s*\.\.\s*")


def axis(spec: "Spec", text: str, points: int, spaced_by_ratio: bool = False) -> SweptAxis:
    """The SweptAxis of a text, with so many values, evenly spaced or by one ratio."""
    name, equals, ends = text.partition("=")
    name, both = plain_name(name.strip()), BETWEEN.split(ends.strip(), 1)
    if not equals or len(both) < 2:
        raise ValueError("write NAME=LOW .. HIGH, as in k=400 N/m .. 1.2 kN/m")
    _require_free(spec, name)
    numbers, unit = _in_one_unit(spec, name, both)
    low, high = numbers
    if not low < high:
        raise ValueError(f"the range is empty: {both[0].strip()} is not below {both[1].strip()}")
    if spaced_by_ratio and not low > 0:
        raise ValueError("values that grow by one ratio are positive: begin above zero")
    shown = [rounded(_part(low, high, Fraction(k, points - 1), spaced_by_ratio)) for k in range(points)]
    shown[0], shown[-1] = low, high
    given = giver(unit, name)
    return SweptAxis(name, unit, tuple(map(given, shown)), tuple(map(float, shown)), given)


def of_numbers(spec: "Spec", name: str, numbers: "ArrayLike") -> SweptAxis:
    """The SweptAxis of numbers in the unit of the file, ascending."""
    import numpy as np

    name = plain_name(name.strip())
    _require_free(spec, name)
    try:
        values = np.asarray(numbers, float).ravel()
    except (TypeError, ValueError):
        values = np.array([np.nan])
    if not np.isfinite(values).all():
        raise ValueError(f"the values of '{name}' are to be an array of finite numbers, in the unit of the file")
    shown = [Fraction(repr(x)) for x in values.tolist()]
    if len(shown) < 2 or any(not a < b for a, b in pairwise(shown)):
        raise ValueError(f"the values of '{name}' are to ascend, two at least")
    unit = unit_text(spec.parameters[name])
    given = giver(unit, name)
    return SweptAxis(name, unit, tuple(map(given, shown)), tuple(map(float, shown)), given)


def _require_free(spec: "Spec", name: str) -> None:
    known = {*spec.parameters, *spec.choices}
    if name not in known:
        raise ValueError(f"the file has no parameter '{name}'" + said(nearest(name, known)))
    if name in spec.choices:
        raise ValueError(f"'{name}' is chosen by the scene: it has the values that fulfil its condition")
    if name not in spec.independent_parameters:
        others = [other for other, *_ in spec.parameters[name]["value"].parts.names if other in spec.parameters]
        raise ValueError(f"'{name}' is defined by {' and '.join(map(repr, dict.fromkeys(others)))}: vary "
                         + ("that" if len(set(others)) == 1 else "one of these"))


def _in_one_unit(spec: "Spec", name: str, texts: Sequence[str]) -> tuple[list[Fraction], str]:
    """([Fraction, Fraction] of the ends, the text of the unit of the first); a bare number has the unit of the other
    end, or that of the file."""
    found = [_literal(text) for text in texts]
    units = [unit for _, unit in found]
    unit = next((unit for unit in units if unit), unit_text(spec.parameters[name]))
    own, numbers = unit_of_text(unit), []
    for number, text in found:
        other = unit_of_text(text or unit)
        if (own is None) != (other is None) or (own is not None and own.dimension != other.dimension):
            raise ValueError(f"'{text or unit}' and '{unit}' do not go together")
        numbers.append(number if not text or text == unit else converted(number, other, own))
    dimension = spec.dimensions.of(name)
    known = not any(base.startswith("?") for base in dimension)
    if known and (own.dimension if own is not None else {}) != dimension and not (own is None and spec.free_numbers):
        wanted = f", as in {spec.parameters[name]['value'].text}" if "value" in spec.parameters[name] else ""
        raise ValueError(f"the unit of '{name}' does not fit{wanted}")
    return numbers, unit


def _literal(text: str) -> tuple[Fraction, str]:
    """(number, text of its unit)."""
    tree, scalar = parsed(text.strip(), "")
    found = number_and_unit(Expression(scalar, tree))
    if found is None:
        raise ValueError(f"'{text.strip()}' is no number with a unit")
    return found


def _part(low: Fraction, high: Fraction, part: Fraction, spaced_by_ratio: bool) -> Fraction:
    if spaced_by_ratio:
        return Fraction(exp(log(low) + float(part) * (log(high) - log(low))))
    return low + (high - low) * part
