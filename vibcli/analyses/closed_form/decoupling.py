"""Blocks of a system: parts that are not coupled, and symmetric and antisymmetric motions.

A signed exchange of coordinates P with PᵀMP = M, PᵀKP = K and P² = 1 leaves x = Px and x = −Px to themselves. Both
are looked for again within each block.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

SEARCHED = 20000    # assignments tried in the search for a symmetry


class DecoupledBlock:
    """columns: for each of its coordinates y the {i: whole number} of x = Σ column·y; matrices: {(a, b): node}."""

    __slots__ = ("columns", "matrices")

    def __init__(self, columns: Sequence[dict[int, int]], matrices: "Sequence[dict[tuple[int, int], Node]]") -> None:
        self.columns, self.matrices = columns, matrices

    def __len__(self) -> int:
        return len(self.columns)


def blocks(table: "Table", n: int, matrices: Any) -> list[DecoupledBlock]:
    """The Blocks into which `matrices` ({(i, j): node} each) fall, as small as they are found."""
    pending, found = [DecoupledBlock([{i: 1} for i in range(n)], list(matrices))], []
    while pending:
        block = pending.pop()
        parts = components(block)
        if len(parts) == 1:
            exchange = symmetry(block)
            parts = [] if exchange is None else eigenspaces(exchange)
        if parts and not (len(parts) == 1 and len(parts[0]) == len(block)):
            pending += [projected(table, block, part) for part in reversed(parts)]
        else:
            found.append(block)
    return found


def components(block: DecoupledBlock) -> list[list[dict[int, int]]]:
    """The parts that no matrix couples, as lists of columns {a: 1}."""
    owner = list(range(len(block)))
    for matrix in block.matrices:
        for i, j in matrix:
            if owner[i] != owner[j]:
                old, new = max(owner[i], owner[j]), min(owner[i], owner[j])
                owner = [new if x == old else x for x in owner]
    return [[{a: 1} for a in range(len(block)) if owner[a] == part] for part in sorted(set(owner))]


def eigenspaces(exchange: Sequence[tuple[int, int]]) -> list[list[dict[int, int]]]:
    """The columns with x = Px and those with x = −Px."""
    same, other = [], []
    for a, (b, sign) in enumerate(exchange):
        if b == a:
            (same if sign > 0 else other).append({a: 1})
        elif a < b:
            same.append({a: 1, b: sign})
            other.append({a: 1, b: -sign})
    return [same, other]


def projected(table: "Table", block: DecoupledBlock, columns: Sequence[dict[int, int]]) -> DecoupledBlock:
    """The block on some columns: TᵀAT of each matrix."""
    matrices = [congruent(table, matrix, columns) for matrix in block.matrices]
    return DecoupledBlock([_combined(block.columns, column) for column in columns], matrices)


def congruent(table: "Table", matrix: "Mapping[tuple[int, int], Node]",
              columns: Sequence[dict[int, int]]) -> "dict[tuple[int, int], Node]":
    found = {}
    for a, left in enumerate(columns):
        for b, right in enumerate(columns):
            terms = [(matrix[i, j], x * y) for i, x in left.items() for j, y in right.items() if (i, j) in matrix]
            node = textbook(table.sum(*terms)) if len(terms) > 1 else table.sum(*terms)
            if not node.is_zero:
                found[a, b] = node
    return found


def _combined(columns: Sequence[dict[int, int]], column: Mapping[int, int]) -> dict[int, int]:
    found = {}
    for a, x in column.items():
        for i, y in columns[a].items():
            found[i] = found.get(i, 0) + x * y
    return {i: value for i, value in found.items() if value}


def symmetry(block: DecoupledBlock) -> list[tuple[int, int]] | None:
    """[(b, ±1)] for each coordinate a: an exchange that changes no matrix, other than ±1 as a whole; None where none
    is found."""
    search = _Search(block)
    return search.exchange if search.extend(0) else None


class _Search:
    """Coordinate after coordinate is sent to itself or another one, with either sign, as long as the entries agree."""

    exchange: list[tuple[int, int] | None]

    def __init__(self, block: DecoupledBlock) -> None:
        self.n, self.matrices, self.tried = len(block), block.matrices, 0
        self.exchange = [None] * self.n

    def extend(self, a: Any) -> bool:
        while a < self.n and self.exchange[a] is not None:
            a += 1
        if a == self.n:
            return any(pair != (i, self.exchange[0][1]) for i, pair in enumerate(self.exchange))
        for b in [*range(a + 1, self.n), a]:
            if self.exchange[b] is not None:
                continue
            for sign in (1, -1):
                self.tried += 1
                if self.tried > SEARCHED:
                    return False
                self.exchange[a], self.exchange[b] = (b, sign), (a, sign)
                if self.agrees(a) and self.agrees(b) and self.extend(a + 1):
                    return True
                self.exchange[a] = self.exchange[b] = None
        return False

    def agrees(self, a: Any) -> bool:
        """Do the entries of row a and those at the images agree, as far as coordinates are placed?"""
        b, sign = self.exchange[a]
        for c, image in enumerate(self.exchange):
            if image is None:
                continue
            d, other = image
            for matrix in self.matrices:
                if not (_alike(matrix, (a, c), (b, d), sign * other) and _alike(matrix, (c, a), (d, b), sign * other)):
                    return False
        return True


def _alike(matrix: "Mapping[tuple[int, int], Node]", pair: tuple[int, int], image: tuple[int, int], sign: int) -> bool:
    here, there = matrix.get(pair), matrix.get(image)
    if here is None or there is None:
        return here is there
    return here is (there if sign > 0 else -there)
