"""Expressions a + ib of real letters, and determinants of these."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.symbolic.node import Node


class ComplexNode(NamedTuple):
    """An expression a + ib."""

    real: "Node"
    imaginary: "Node"

    def times(self, other: "ComplexNode") -> "ComplexNode":
        """Their product."""
        return ComplexNode(self.real * other.real - self.imaginary * other.imaginary,
                           self.real * other.imaginary + self.imaginary * other.real)

    def plus(self, real: "Node") -> "ComplexNode":
        """The sum with an expression that is real."""
        return ComplexNode(self.real + real, self.imaginary)

    def over(self, other: "ComplexNode") -> "ComplexNode":
        """Their quotient."""
        a, b = other.real, other.imaginary
        size = a ** 2 + b ** 2
        return self.times(ComplexNode(a / size, -b / size))


class LetteredStiffness(NamedTuple):
    """Z = K − Ω²M + iΩC as lines tell it: rows of its letters, of their real and imaginary parts, the letter of its
    determinant, and Ω."""

    letters: "Sequence[Sequence[Node]]"
    parts: "Sequence[Sequence[ComplexNode]]"
    determinant: "Node"
    Omega: "Node"


def determinant_of(rows: "Sequence[Sequence[ComplexNode]]") -> ComplexNode:
    """Along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    zero = rows[0][0].real.table.zero
    total = ComplexNode(zero, zero)
    for j, part in enumerate(rows[0]):
        minor = determinant_of([[*row[:j], *row[j + 1:]] for row in rows[1:]])
        term = part.times(minor)
        total = ComplexNode(*(one + other * (-1) ** j for one, other in zip(total, term, strict=True)))
    return total
