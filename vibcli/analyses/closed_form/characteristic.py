"""The characteristic polynomial det(K − λM + iωG), λ = ω², of a block: factored, its roots and null vectors.

SymPy's steps are bounded in calls: a polynomial that is not factored is taken whole.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.algebraic_extension import Extension
from vibcli.analyses.closed_form.characteristic_roots import solutions
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import TooLong
from vibcli.symbolic.rational_functions import Quotients
from vibcli.symbolic.time_limit import within

if TYPE_CHECKING:
    from sympy.polys.fields import FracElement

    from vibcli.analyses.closed_form.characteristic_roots import Simple, Surd, Turning
    from vibcli.analyses.closed_form.toeplitz_chains import Cosine
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

CALLS, LARGEST = 6_000_000, 6


class Characteristic:
    """A block of M, C, G, K with its elements in a field of quotients, and the factors of its polynomial in λ."""

    def __init__(self, table: "Table", n: int, matrices: Any, sample: Mapping[str, float]) -> None:
        nodes = [node for matrix in matrices for node in matrix.values()]
        self.sample, self.quotients = sample, Quotients(table, nodes)
        self.M, self.C, self.G, self.K = ([[self._element(matrix, i, j) for j in range(n)] for i in range(n)]
                                          for matrix in matrices)
        polynomial = within(CALLS, self._determinant, None)
        self.factors = self._split(polynomial) if polynomial else []

    def _element(self, matrix: "Mapping[tuple[int, int], Node]", i: int, j: int) -> Any:
        return self.quotients(matrix[i, j]) if (i, j) in matrix else self.quotients.field(0)

    def _determinant(self) -> Any:
        """det(s²M + sG + K) with λ = −s², a polynomial of the ring but for its denominators."""
        s = self.quotients.unknown
        rows = [[k + s * g + s * s * m for m, g, k in zip(*row, strict=True)]
                for row in zip(self.M, self.G, self.K, strict=True)]
        rows = [self.quotients.cleared(row)[0] for row in rows]
        whole = determinant(rows, self.quotients.ring)
        return self._in_lambda(self.quotients.settled(self.quotients.field(whole)).numer)

    def _in_lambda(self, polynomial: Any) -> Any:
        halved = {(*powers[:-1], powers[-1] // 2): value * (-1) ** (powers[-1] // 2)
                  for powers, value in polynomial.terms()}
        return self.quotients.ring.from_dict(halved)

    def _split(self, polynomial: Any) -> list[tuple[list[Any], int]]:
        """[(coefficients from the lowest, multiplicity)] of the factors that hold λ."""
        _, factors = self.quotients.factors(polynomial)
        parts = [(self.quotients.coefficients(factor), power) for factor, power in factors]
        return [(modulus, power) for modulus, power in parts if len(modulus) > 1]

    def roots(self, modulus: Sequence[Any]) -> "Sequence[Simple | Surd | Turning | Cosine] | None":
        """The solutions of a factor, None where there are none that are short."""
        turns = any(map(any, self.G))
        found: Sequence[Simple | Surd | Turning | Cosine] | None = within(
            CALLS, lambda: solutions(self.quotients, modulus, self.sample, turns), None)
        return found

    def null_vectors(self, modulus: Sequence[Any]) -> "list[list[list[FracElement]]]":
        """A basis of (K − λM) x = 0 as elements of F[λ]/(modulus); none where that takes too long, or where G turns."""
        if any(map(any, self.G)):
            return []
        field = Extension(self.quotients.field, modulus)

        def work() -> "list[list[list[Any]]]":
            rows = [[field.reduced([k, -m]) for m, k in zip(*row, strict=True)]
                    for row in zip(self.M, self.K, strict=True)]
            try:
                return field.null_vectors(rows)
            except (IndexError, ZeroDivisionError, TooLong):     # or the polynomial was not factored
                return []
        found: list[list[list[FracElement]]] = within(CALLS, work, [])
        return found

    def polynomial(self, modulus: Sequence[Any]) -> "list[Node]":
        """The coefficients of an unsolved factor from the highest, as nodes."""
        sign = -1 if evaluate([self.quotients.node(modulus[-1])], Floats, self.sample)[0] < 0 else 1
        return [self.quotients.node(sign * c) for c in reversed(modulus)]


def determinant(rows: Sequence[list[dict[tuple[Any, ...], Any]]], ring: Any) -> dict[tuple[int, ...], Any]:
    """By expansion along the rows, each minor computed once."""
    minors: dict[tuple[int, ...], Any] = {(): ring(1)}
    n = len(rows)
    for size in range(1, n + 1):
        row, found = rows[n - size], {}
        for rest, minor in minors.items():
            for column in range(n):
                if column not in rest and row[column]:
                    sign = (-1) ** sum(other < column for other in rest)
                    key = tuple(sorted((*rest, column)))
                    found[key] = found.get(key, ring(0)) + row[column] * minor * sign
        minors = found
    result: dict[tuple[int, ...], Any] = minors.get(tuple(range(n)), ring(0))
    return result
