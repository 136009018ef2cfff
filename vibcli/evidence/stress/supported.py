"""How many digits of an answer the figures of its file support: each moved by half a unit of its last digit.

|y(p + δp) − y(p)| of each parameter that is written with three digits or more (fewer are exact), summed over all.
"""

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import NamedTuple

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.written_digits import SHORT, digits_written, half_a_unit
from vibcli.language.given_values import decimal, number_and_unit
from vibcli.quantities.expression import value_of
from vibcli.quantities.quantity import COMPLEX, LEAPING, OF_STATE, kind_of
from vibcli.results.problem import Problem

MOST = 17       # digits: a float has no more


class SupportedAnswer(NamedTuple):
    """An answer of a file: its value, the digits of it that the data support, None where nothing moves it; the
    parameter that takes most of them; why: it has no number."""

    asked: str
    value: float | None
    digits: float | None
    parameter: str
    why: str = ""


def supported(problem: Problem, remade: Callable[[str, str], Problem]) -> Iterator[SupportedAnswer]:
    """The SupportedAnswer of each answer; remade(parameter, its value as a text): the scene with that value."""
    moved = {}
    for name, text in _half_a_unit_more(problem).items():
        try:
            moved[name] = remade(name, text)
        except (PhysicsError, SpecError):       # the drawing does not fit together there
            continue
    for answer in problem.spec.answers:
        if kind_of(problem.spec, answer.asked.tree) not in (*OF_STATE, *LEAPING, COMPLEX):
            yield _support(problem, answer.asked, moved)


def _support(problem, asked, moved):
    try:
        value = value_of(problem, asked)[0]
        apart = {name: abs(value_of(other, asked)[0] - value) for name, other in moved.items()}
    except PhysicsError as error:
        return SupportedAnswer(asked.text, None, None, "", error.message)
    total = sum(apart.values())
    if not total:
        return SupportedAnswer(asked.text, float(value), None, "")
    digits = min(-math.log10(total / abs(value)), MOST) if value else 0.0
    return SupportedAnswer(asked.text, float(value), max(digits, 0.0), max(apart, key=apart.__getitem__))


def _half_a_unit_more(problem: Problem) -> dict[str, str]:
    """{parameter: its value as a text, half a unit of its last digit more}."""
    found = {}
    for name, record in problem.spec.parameters.items():
        known = number_and_unit(record["value"]) if "value" in record else None
        if known is not None and digits_written(record["value"].text) >= SHORT:
            number, unit = known
            more = number + Fraction(half_a_unit(record["value"].text)).limit_denominator(10**40)
            found[name] = f"{decimal(more)} {unit}".strip()
    return found
