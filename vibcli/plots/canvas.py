"""A canvas of text: dots of braille (two by four to a cell), one layer a curve, and characters where no dots are."""

from collections.abc import Sequence
from functools import reduce
from itertools import pairwise
from operator import or_

_BITS = ((0x01, 0x02, 0x04, 0x40), (0x08, 0x10, 0x20, 0x80))
_EMPTY = 0x2800     # the character of braille without dots


class Canvas:
    """`columns` by `rows` cells; dots count from the upper left."""

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self.layers, self.letters, self.behind = [], {}, {}

    def dots(self, across: float, up: float) -> tuple[float, float]:
        """(x, y) in dots, not rounded, of a place given as parts of the width and height; one far outside is brought
        to just outside: the line towards it stays."""
        wide, high = 2 * self.columns - 1, 4 * self.rows - 1
        return min(max(across, -1.0), 2.0) * wide, min(max(1 - up, -1.0), 2.0) * high

    def column(self, across: float) -> int:
        return rounded(self.dots(across, 0.0)[0]) // 2

    def row(self, up: float) -> int:
        return rounded(self.dots(0.0, up)[1]) // 4

    def layer(self) -> bytearray:
        """A new layer of dots, one byte a cell."""
        layer = bytearray(self.columns * self.rows)
        self.layers.append(layer)
        return layer

    def dot(self, layer: bytearray, x: int, y: int) -> None:
        if 0 <= x < 2 * self.columns and 0 <= y < 4 * self.rows:
            layer[y // 4 * self.columns + x // 2] |= _BITS[x % 2][y % 4]

    def polyline(self, layer: bytearray, points: Sequence[tuple[float, float]], pattern: str = "x") -> None:
        """Straight lines through the points (dots, not rounded); `pattern`: x for a dot, a space for none."""
        period, count = len(pattern), 0
        if len(points) == 1:
            self.dot(layer, *map(rounded, points[0]))
        for (x, y), (x_end, y_end) in pairwise(points):
            steps = max(abs(rounded(x_end) - rounded(x)), abs(rounded(y_end) - rounded(y)), 1)
            across, down = x_end - x, y_end - y
            for i in range(steps + 1):
                if pattern[(count + i) % period] == "x":
                    column, row = x + across * i / steps, y + down * i / steps
                    self.dot(layer, int(column + 0.5) if column >= 0 else -int(0.5 - column),      # as `rounded`
                             int(row + 0.5) if row >= 0 else -int(0.5 - row))
            count += steps

    def used(self, row: int, column: int) -> list[int]:
        """The numbers of the layers that have dots in a cell."""
        place = row * self.columns + column
        return [i for i, layer in enumerate(self.layers) if layer[place]]

    def rows_used(self) -> list[dict[int, list[int]]]:
        """For each column {number of a layer: the rows at which it has dots}."""
        return [{i: rows for i, layer in enumerate(self.layers)
                 if (rows := [row for row, dots in enumerate(layer[column::self.columns]) if dots])}
                for column in range(self.columns)]

    def free(self, row: int, column: int, length: int) -> bool:
        """Is there room for a text here?"""
        if not (0 <= row < self.rows and column >= 0 and column + length <= self.columns):
            return False
        return not any((row, c) in self.letters or self.used(row, c) for c in range(column, column + length))

    def write(self, row: int, column: int, cells: Sequence[str] | str) -> None:
        """Put cells of text, over dots where they are; what lies outside is left out."""
        for i, cell in enumerate(cells):
            if 0 <= row < self.rows and 0 <= column + i < self.columns:
                self.letters[row, column + i] = cell

    def lines(self) -> list[str]:
        """The rows as text, in braille."""
        dots = reduce(or_, (int.from_bytes(layer, "big") for layer in self.layers), 0)
        found = [chr(_EMPTY + dot) if dot else " " for dot in dots.to_bytes(self.columns * self.rows, "big")]
        for (row, column), cell in self.behind.items():
            if found[row * self.columns + column] == " ":
                found[row * self.columns + column] = cell
        for (row, column), cell in self.letters.items():
            if cell:
                found[row * self.columns + column] = cell
        return ["".join(found[i:i + self.columns]) for i in range(0, len(found), self.columns)]


def rounded(value: float) -> int:
    return int(value + 0.5) if value >= 0 else -int(0.5 - value)
