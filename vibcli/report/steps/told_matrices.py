"""M, C, G and K of several degrees of freedom as matrices, in letters and in numbers; entry by entry where a page does
not hold them."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.names import lowered
from vibcli.notation.numbers import width
from vibcli.report.blocks import Name, ShownMatrix, Words
from vibcli.report.formats.formula import rows_of_matrix
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, told
from vibcli.report.steps.told_before import asked_entries
from vibcli.symbolic.evaluation import evaluate_rational
from vibcli.symbolic.node import is_number

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

WIDEST = 80         # columns of a matrix that a page holds behind its letter
NUMBERED = 6        # degrees, up to which they have numbers
UNITS = {"M": ("kg", "kg·m", "kg·m²"), "K": ("N/m", "N", "N·m"), **dict.fromkeys("CG", ("N·s/m", "N·s", "N·m·s"))}
KINDS = {"M": "mass matrix", "C": "damping matrix", "G": "gyroscopic matrix", "K": "stiffness matrix"}


def tell_matrices(about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> list[int]:
    """Write down those that there are, with what each entry is; the numbers of the lines."""
    of = [_Entries(about, sheet, letter, getattr(found, letter)) for letter in KINDS if getattr(found, letter)]
    return [entries.tell(found.lines, first=not i) for i, entries in enumerate(of)]


class _Entries:
    """Those of a matrix."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, letter: str,
                 entries: "Mapping[tuple[int, int], Node]") -> None:
        self.about, self.sheet, self.letter, self.entries = about, sheet, letter, entries
        self.names, self.name = about.scene.coordinates, sheet.matrix(letter)
        self.values = {pair: self._value(node) for pair, node in entries.items()}

    def _value(self, node: "Node") -> float:
        """The number of an entry, zero where it is so but for rounding; None in letters."""
        value = self.about.value(node)
        exact = None if value is None else evaluate_rational([node], self.about.problem.scene.parameters.exact)
        return 0.0 if exact == [0] else value

    def _unit(self, i: int, j: int) -> str:
        return UNITS[self.letter][sum(not self.about.problem.system.dimension(self.names[k]) for k in (i, j))]

    def tell(self, uses: list[int], first: bool) -> int:
        """Write down the line; the first one says in which order rows and columns stand."""
        order = [part for name in self.names for part in (", ", Name(name))][1:]
        head = [Words(", in the order  "), *order] if first else []
        line = self.sheet.write(Words(KINDS[self.letter]), *head, Words(":  "), *self._shown(), settles=self.letter,
                                uses=uses)
        asked = asked_entries(self.about.problem, self.letter)
        for (i, j), node in self._different():
            value, text = self.values[i, j], f"{self.letter}[{self.names[i]},{self.names[j]}]"
            self.sheet.write(settles=asked.get((i, j), text), node=node, value=value, joined=True, uses=uses,
                             unit="" if value is None else self._unit(i, j))
        return line

    def _different(self) -> "list[tuple[tuple[int, int], Node]]":
        """((i, j), entry) of those that do not stand across the diagonal as well."""
        return [(pair, node) for pair, node in sorted(self.entries.items()) if pair[1] >= pair[0] or not self._twin(
            *pair)]

    def _twin(self, i: int, j: int) -> bool:
        """Is it the one across the diagonal once more, or less, where the matrix is skew?"""
        across = self.entries.get((j, i), self.about.table.zero)
        return self.letter == "G" or self.about.same(self.entries[i, j], across)

    def _shown(self) -> list[Any]:
        """Parts of M = letters = numbers, as far as a page holds them."""
        by_letters = ShownMatrix(self._rows(lambda pair: (self.entries[pair],)))
        known = None not in self.values.values() and len(self.names) <= NUMBERED
        in_numbers = self._in_numbers() if known else []
        numbers = [" = ", *in_numbers] if known and _is_narrow(in_numbers[0]) else []
        if numbers and all(map(is_number, self.entries.values())):
            return [Name(self.name), *numbers]
        if _is_narrow(by_letters):
            return [Name(self.name), " = ", by_letters, *numbers]
        return [*self._one_by_one(), *([Words(",  "), Name(self.name), *numbers] if numbers else [])]

    def _in_numbers(self) -> list[ShownMatrix | Words]:
        """Parts of the matrix in numbers; the unit stands behind it, where all have the same."""
        units = {self._unit(i, j) for (i, j), value in self.values.items() if value}
        alone = units.pop() if len(units) == 1 else ""

        def cell(pair: "tuple[int, int]") -> "tuple[Sequence[str], ...]":
            unit = [Words(f"\u00a0{self._unit(*pair)}")] * bool(units and self.values[pair])
            return (told(self.values[pair]), *unit)

        return [ShownMatrix(self._rows(cell)), *[Words(f"\u00a0{alone}")] * bool(alone)]

    def _rows(self, cell: Callable[..., Any]) -> tuple[tuple[Any, ...], ...]:
        indices = range(len(self.names))
        return tuple(tuple(cell((i, j)) if (i, j) in self.entries else ("0",) for j in indices) for i in indices)

    def _one_by_one(self) -> "list[Node | str | Words]":
        parts: list[Any] = []
        for (i, j), node in self._different():
            twin = f" = {'−' * (self.letter == 'G')}{self._entry(j, i)}" if i != j and self._twin(i, j) else ""
            parts += [*[Words(",  ")] * bool(parts), f"{self._entry(i, j)}{twin}", " = ", node]
        return parts

    def _entry(self, i: int, j: int) -> str:
        return f"{self.name}{lowered(i + 1)}{lowered(j + 1)}"


def _is_narrow(matrix: Any) -> bool:
    return max(map(width, rows_of_matrix(matrix))) <= WIDEST
