"""Rational numbers as they are written: integers, fractions of small denominators, else decimals."""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.notation.radicals import LARGEST

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def shown_as_decimal(value: Fraction | int) -> bool:
    """0.75 m reads better as a decimal, 3/4·m·L² as a fraction: denominators up to 48 are fractions."""
    return value.denominator > LARGEST


def decimal(value: Any) -> str:
    """A rational as text: an integer, p/q, or a decimal where that is short enough, else 12 digits."""
    if value.denominator == 1:
        text = str(value.numerator)
        return text if len(text) < 16 else f"{float(value):.12g}"
    if not shown_as_decimal(value):
        return f"{value.numerator}/{value.denominator}".replace("-", "−")
    return f"{float(value):.12g}".replace("-", "−") if abs(value) >= 1e-4 else f"{float(value):.12g}"


def added_as_decimal(node: "Node", value: Fraction | int) -> bool:
    """Is the number in a sum written as a decimal, 0.3 beside L, as the numbers of the sum were?"""
    written = [node.coefficient, *(c for _, c in node.args)]
    return value.denominator > 1 and bool(node.args) and all(map(_terminates, written)) and any(
        c.denominator % 5 == 0 for c in written)


def _terminates(value):
    """Is a rational a decimal of few digits?"""
    return (value * 1000).denominator == 1


def common_denominator(node: "Node", values: Sequence[Fraction | int]) -> int:
    """The denominator that all terms of a sum of parameters share; 1 where they do not."""
    values = [*values, node.coefficient] if node.coefficient else values
    below = {value.denominator for value in values}
    return 1 if node.mask or len(below) > 1 or shown_as_decimal(values[0]) else below.pop()
